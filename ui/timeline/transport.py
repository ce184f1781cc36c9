"""The transport: play and go about in time, set keys, and how the timeline is looked at, all in one line."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMenu, QSizePolicy, QToolButton, QWidget

from app.timeline.state import SnapTarget, TimelineState
from app.timeline.timeline import Timeline
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ROW
from ui.timeline.rate_button import RateButton
from ui.timeline.time_field import TimeField
from ui.window.action_binding import ActionBinding

SNAPS: tuple[tuple[SnapTarget, str], ...] = (("frames", "Frames"), ("keys", "Keys"), ("markers", "Markers and ranges"))

GOING = ("timeline.start", "timeline.key-back", "timeline.play", "timeline.key-on", "timeline.end", "timeline.loop")
ADDING = (
    "timeline.import-sound",
    "timeline.type-speech",
    "timeline.idle",
    "timeline.marker",
    "timeline.range",
)
SETTING = ("timeline.key", "timeline.auto-key")


class Transport(QWidget):
    """One line of buttons.

    Signals
    -------
    folded(bool) : a person folded the timeline to this line, or opened it

    Parameters
    ----------
    timeline : what is played
    binding : the actions of the window
    inspector : the column of fields that a button shows and hides
    """

    folded = Signal(bool)

    def __init__(self, timeline: Timeline, binding: ActionBinding, inspector: QWidget) -> None:
        super().__init__()
        self._timeline, self._binding = timeline, binding
        self.fold = _button("chevron-right", "Open the timeline")
        self.fold.clicked.connect(lambda: self.folded.emit(not self._is_folded))
        self._is_folded = True
        self.time = TimeField(timeline)
        self.rate = RateButton(timeline)
        self.add = _menu_button("plus", "Add an expression that moves, a sound, speech, idle life, marks")
        self.snap = _menu_button("magnet", "What moved things snap to")
        self.fields = _button("tune-variant", "Fields about what is chosen")
        self.fields.setCheckable(True)
        self.fields.clicked.connect(lambda on: timeline.change(fields=on))
        inspector.installEventFilter(self)
        self.modes = {mode: _button(glyph, text) for mode, glyph, text in MODES}
        self._lay_out()
        self._fill_menus()
        for mode, button in self.modes.items():
            button.setCheckable(True)
            button.clicked.connect(lambda _on, mode=mode: timeline.change(mode=mode))
        timeline.changed.connect(self._follow)
        timeline.playhead.playing_changed.connect(self._show_playing)
        binding.table_changed.connect(self._fill_menus)
        self._follow(timeline.state, timeline.state)

    def show_folded(self, folded: bool) -> None:
        """Show whether the timeline is folded to this line."""
        self._is_folded = folded
        self.fold.setIcon(icon("chevron-right" if folded else "chevron-down"))
        text = "Open the timeline" if folded else "Fold the timeline to this line"
        self.fold.setToolTip(text)
        self.fold.setAccessibleName(text)
        for widget in self._inner:
            widget.setVisible(not folded)

    def eventFilter(self, _inspector: QObject, event: QEvent) -> bool:
        """The button says whether the fields are shown."""
        if event.type() in (QEvent.Type.ShowToParent, QEvent.Type.HideToParent):
            self.fields.setChecked(event.type() == QEvent.Type.ShowToParent)
        return False

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Where there is little room, what can be spared makes way."""
        super().resizeEvent(event)
        for widget, least in self._spared:
            widget.setVisible(event.size().width() >= least)

    def minimumSizeHint(self) -> QSize:
        """Room for what is reached for all the time."""
        return QSize(46 * GRID, ROW + 4)

    def sizeHint(self) -> QSize:
        """One row."""
        return QSize(super().sizeHint().width(), ROW + 4)

    def _lay_out(self) -> None:
        layout = QHBoxLayout(self)
        layout.setSizeConstraint(QHBoxLayout.SizeConstraint.SetNoConstraint)
        layout.setContentsMargins(0, 2, 0, 2)
        layout.setSpacing(2)
        title = QLabel("TIMELINE")
        title.setProperty("role", "heading")
        title.setContentsMargins(0, 0, 2 * GRID, 0)
        layout.addWidget(self.fold)
        layout.addWidget(title)
        going = {key: self._act(layout, key) for key in GOING}
        layout.addSpacing(GRID)
        layout.addWidget(self.time)
        layout.addWidget(self.rate)
        layout.addSpacing(GRID)
        for key in SETTING:
            self._act(layout, key)
        layout.addWidget(self.add)
        layout.addStretch(1)
        self._inner: list[QWidget] = [self.snap, *self.modes.values(), self.fields]
        layout.addWidget(self.snap)
        layout.addSpacing(GRID)
        for button in self.modes.values():
            layout.addWidget(button)
        layout.addSpacing(GRID)
        layout.addWidget(self.fields)
        layout.addSpacing(GRID)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._spared: tuple[tuple[QWidget, int], ...] = (
            (title, 90 * GRID),
            (going["timeline.start"], 80 * GRID),
            (going["timeline.end"], 80 * GRID),
            (self.rate, 68 * GRID),
            (going["timeline.loop"], 58 * GRID),
        )

    def _act(self, layout: QHBoxLayout, key: str) -> QToolButton:
        button = QToolButton()
        button.setDefaultAction(self._binding.qt[key])
        button.setProperty("role", "small")
        button.setIconSize(QSize(18, 18))
        button.setFixedSize(ROW, ROW)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        layout.addWidget(button)
        return button

    def _fill_menus(self) -> None:
        menu = self.add.menu()
        menu.clear()
        inner = menu.addMenu("Dynamic expression")
        self._put(inner, "timeline.drop.")
        menu.addSeparator()
        for key in ADDING:
            if key in self._binding.qt:
                menu.addAction(self._binding.qt[key])
        snap = self.snap.menu()
        snap.clear()
        for target, title in SNAPS:
            action = snap.addAction(title)
            action.setCheckable(True)
            action.setChecked(target in self._timeline.state.snaps)
            action.toggled.connect(lambda on, target=target: self._snap_to(target, on))

    def _put(self, menu: QMenu, prefix: str) -> None:
        for key, action in self._binding.qt.items():
            if key.startswith(prefix):
                menu.addAction(action)

    def _snap_to(self, target: SnapTarget, on: bool) -> None:
        snaps = self._timeline.state.snaps
        self._timeline.change(snaps=snaps | {target} if on else snaps - {target})

    def _follow(self, now: TimelineState, _before: TimelineState) -> None:
        for mode, button in self.modes.items():
            button.setChecked(mode == now.mode)
        self.snap.setIcon(icon("magnet-on" if now.snaps else "magnet"))

    def _show_playing(self, playing: bool) -> None:
        self._binding.qt["timeline.play"].setIcon(icon("pause" if playing else "play"))


MODES = (
    ("keys", "rhombus-split-outline", "Keys on lines"),
    ("curves", "chart-bell-curve-cumulative", "Curves in a graph"),
)


def _button(glyph: str, text: str) -> QToolButton:
    button = QToolButton()
    button.setIcon(icon(glyph))
    button.setProperty("role", "small")
    button.setToolTip(text)
    button.setAccessibleName(text)
    button.setFixedSize(ROW, ROW)
    button.setIconSize(QSize(18, 18))
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    return button


def _menu_button(glyph: str, text: str) -> QToolButton:
    button = _button(glyph, text)
    button.setMenu(QMenu(button))
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    button.setProperty("role", "menu")
    return button
