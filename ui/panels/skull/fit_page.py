"""A skull from elsewhere is fitted to the head: landmark by landmark, with what is missed at each in millimetres."""

from __future__ import annotations

from html import escape

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QScrollArea, QVBoxLayout, QWidget

from app.actions.context import Context
from app.skull_fitting import PLACES, title_of
from app.tools.tool import Bench
from facemodel.skull.fitting import FEWEST, KINDS, Kind
from ui.panels.skull.deeds import change
from ui.panels.skull.landmark_row import LandmarkRow
from ui.panels.skull.triple_row import NAME
from ui.panels.tissue.choices import Buttons, Choices
from ui.theme.metrics import GRID

KIND_TIPS: dict[Kind, str] = {
    "alike": "Turn, move and scale it alike in all directions",
    "axes": "Scale it along each of its own axes by itself",
    "bent": "Scale it along its axes, and bend it so that all landmarks are met",
}


class FitPage(QWidget):
    """Leads through the landmarks, and takes the skull over when enough are picked."""

    def __init__(self, context: Context, bench: Bench) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self._context, self._bench, self._fitting = context, bench, bench.fitting
        self.title, self.account, self.lead, self.result = (QLabel() for _ in range(4))
        self.account.setProperty("role", "muted")
        for label in (self.account, self.lead, self.result):
            label.setWordWrap(True)
        self.lead.setTextFormat(Qt.TextFormat.RichText)
        self.kinds = Choices("How the skull is scaled")
        self.kinds.offer(KINDS)
        for kind, tip in KIND_TIPS.items():
            self.kinds.button(kind).setToolTip(tip)
        self.kinds.chosen.connect(self._fitting.scale)
        self.turns = Buttons(
            tuple(
                (f"About {axis}", f"Turn the skull by a quarter about {axis} of the head", lambda k=k: self._turn(k))
                for k, axis in enumerate("xyz")
            ),
            3,
        )
        self.deeds = Buttons(
            (
                ("Propose", "Pick what is not picked yet where it may be by the shape of the skull", self._propose),
                ("Clear", "Take all picks back", lambda: self._fitting.restore({})),
            ),
            2,
        )
        self.rows = {name: LandmarkRow(name, title_of(name), hint) for name, hint in PLACES.items()}
        self.cancel, self.use = QPushButton("Cancel"), QPushButton("Use this skull")
        self.use.setDefault(True)
        self._lay_out()
        self._connect()

    def _connect(self) -> None:
        for name, row in self.rows.items():
            row.chosen.connect(self._fitting.choose)
            row.forgotten.connect(self._fitting.forget)
            row.setObjectName(name)
        self.cancel.clicked.connect(self._fitting.end)
        self.use.clicked.connect(self._use)
        self._fitting.changed.connect(self._show)

    def _turn(self, axis: int) -> None:
        self._fitting.turn(axis)

    def _propose(self) -> None:
        self._fitting.propose()

    def _use(self) -> None:
        """Make it the skull of the project, as one step."""
        guest = self._fitting.guest
        if guest is None:
            return
        before, origins = self._context.document.project, self._context.view.state.origins_follow
        change(self._context, lambda project: self._fitting.used(project, origins), f"Import skull {guest.title}")
        if self._context.document.project is not before:
            self._fitting.end()

    def _show(self) -> None:
        fitting = self._fitting
        if fitting.guest is None:
            return
        self.title.setText(f"<b>{escape(fitting.guest.title)}</b>")
        self.account.setText(f"{fitting.guest.bone.account}.")
        missing = [name for name in fitting.guest.targets if name not in fitting.picked]
        if fitting.active in fitting.picked and not missing:
            self.lead.setText("All landmarks are picked. Drag those that are not where they should be.")
        else:
            self.lead.setText(f"Click the <b>{title_of(fitting.active)}</b>: {PLACES[fitting.active]}.")
        residuals = {} if fitting.fit is None else fitting.fit.residuals
        for name, row in self.rows.items():
            row.setVisible(name in fitting.guest.targets)
            row.show_state(name in fitting.picked, name == fitting.active, residuals.get(name))
        self.kinds.press(fitting.kind)
        self.turns.setEnabled(fitting.fit is None)
        self.deeds.by_name["Propose"].setEnabled(bool(missing))
        self.deeds.by_name["Clear"].setEnabled(bool(fitting.picked))
        self.use.setEnabled(fitting.ready)
        self.result.setText(self._told())

    def _told(self) -> str:
        fitting = self._fitting
        if not fitting.ready or fitting.fit is None:
            left = max(1, FEWEST - len(fitting.picked))
            return f"Pick at least {left} more, beside each other and not in a line, to use the skull."
        x, y, z = fitting.fit.scale / fitting.fit.scale.mean()
        even = f"; its axes by {100 * x:.0f}, {100 * y:.0f} and {100 * z:.0f} %" if fitting.kind != "alike" else ""
        return f"{len(fitting.picked)} landmarks are missed by {fitting.fit.rms:.1f} mm rms{even}."

    def _lay_out(self) -> None:
        inside = QWidget()
        inside.setProperty("role", "panel")
        rows = QVBoxLayout(inside)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(0)
        for row in self.rows.values():
            rows.addWidget(row)
        rows.addStretch(1)
        scroll = QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(inside)
        ends = QHBoxLayout()
        ends.setSpacing(GRID)
        ends.addWidget(self.cancel)
        ends.addWidget(self.use, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, GRID, GRID, 0)
        layout.setSpacing(GRID)
        for widget in (self.title, self.account, self.lead):
            layout.addWidget(widget)
        layout.addWidget(scroll, 1)
        for widget in (self.deeds, _named("Scale", self.kinds), _named("Turn", self.turns), self.result):
            layout.addWidget(widget)
        layout.addLayout(ends)


def _named(title: str, widget: QWidget) -> QWidget:
    """A widget behind its name."""
    row = QWidget()
    layout = QHBoxLayout(row)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(GRID // 2)
    name = QLabel(title)
    name.setProperty("role", "muted")
    name.setFixedWidth(NAME)
    layout.addWidget(name)
    layout.addWidget(widget, 1)
    return row
