"""A bar cut into the intensities A to E of FACS, whose cuts are dragged, stepped and typed."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPainterPath, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.intensity import NAMES
from facemodel.actions import EXAGGERATED, LETTERS
from ui.theme.apply import current_theme, interface_font
from ui.theme.colour import blend
from ui.theme.metrics import GRID, RADIUS, ROW, SMALL_TYPE
from ui.widgets.number_edit import NumberEdit

REACH = 6.0
"""Pixels from a cut within which a press takes hold of it."""

STEP, FINE_STEP = 0.01, 0.001

PALEST, STRONGEST = 0.10, 0.52
"""How much of the accent A and E have."""


class LetterBar(QWidget):
    """Shows where five intensities begin, and lets the hand move the cuts between them.

    Drag a cut; Esc takes it back.  A to E choose a cut, arrows step it (Shift finer), Enter or a double click types it.

    Signals
    -------
    previewed(str, float) : a letter, and the weight at which it is to begin
    committed() : the change is over and stays
    cancelled() : the change is over and is taken back
    """

    previewed = Signal(str, float)
    committed = Signal()
    cancelled = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._begins: tuple[float, ...] = LETTERS
        self._chosen = 0
        self._held = self._stepping = False
        self._editor: NumberEdit | None = None
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName("Beginnings of the intensities A to E")
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    @property
    def letters(self) -> tuple[float, ...]:
        """The weights at which A to E begin, as they are shown."""
        return self._begins

    @property
    def held(self) -> bool:
        """Whether a hand is changing it."""
        return self._held or self._stepping

    @property
    def end(self) -> float:
        """The weight at the right end of the bar."""
        return 1.0 if self._begins[-1] < 1.0 else EXAGGERATED

    def show_letters(self, letters: tuple[float, ...]) -> None:
        """Show other beginnings; emits nothing."""
        if letters != self._begins:
            self._begins = letters
            self.update()

    def place(self, letter: str) -> float:
        """Where a letter begins, in pixels from the left."""
        return self.width() * self._begins[NAMES.index(letter)] / self.end

    def take_back(self) -> bool:
        """End the drag under way as if it had never been; whether there was one."""
        held, self._held = self._held, False
        if held:
            self.cancelled.emit()
        self.update()
        return held

    def edit(self) -> None:
        """Open the beginning of the chosen letter for typing."""
        if self._editor is None:
            self._editor = NumberEdit(self, f"{self._begins[self._chosen]:g}")
            self._editor.entered.connect(self._enter)
            self._editor.dismissed.connect(self._close_editor)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of the nearest cut."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._chosen = self._nearest(event.position())
            self._held = abs(self.place(NAMES[self._chosen]) - event.position().x()) <= REACH
            self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The cut follows the pointer."""
        x = event.position().x()
        if self._held:
            self._tell(round(x / max(1, self.width()) * self.end, 3 if _fine(event) else 2))
            return
        near = abs(self.place(NAMES[self._nearest(event.position())]) - x) <= REACH
        self.setCursor(Qt.CursorShape.SizeHorCursor if near else Qt.CursorShape.ArrowCursor)
        self.setToolTip(self._told(self._segment(x)))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go: the cut stays."""
        if event.button() == Qt.MouseButton.LeftButton and self._held:
            self._held = False
            self.committed.emit()
            self.update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Type where the letter under the pointer begins."""
        self._held = False
        self._chosen = max(self._segment(event.position().x()), 0)
        self.edit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Choose, step or type."""
        text = event.text().upper()
        if text and text in NAMES:
            self._chosen = NAMES.index(text)
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_F2):
            self.edit()
        elif event.key() in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            way = 1 if event.key() == Qt.Key.Key_Right else -1
            self._stepping = True
            self._tell(round(self._begins[self._chosen] + way * (FINE_STEP if _fine(event) else STEP), 3))
        else:
            event.ignore()
        self.update()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """A key held down is one gesture."""
        if not event.isAutoRepeat():
            self._finish_steps()
        event.ignore()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Finish what the keys began."""
        super().focusOutEvent(event)
        self._finish_steps()
        self.update()

    def event(self, event: QEvent) -> bool:
        """Keep letters and arrows from the window's shortcuts."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride and self._wants(event):
            event.accept()
            return True
        return super().event(event)

    def sizeHint(self) -> QSize:
        """One row."""
        return QSize(20 * GRID, ROW - 2)

    def minimumSizeHint(self) -> QSize:
        """One row in which five letters can be told apart."""
        return QSize(12 * GRID, ROW - 2)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the parts from A to E, each stronger than the one before, with their letters."""
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area, shape = QRectF(self.rect()), QPainterPath()
        shape.addRoundedRect(area, RADIUS, RADIUS)
        painter.setClipPath(shape)
        painter.fillRect(area, QColor(theme.raised))
        places = [self.place(letter) for letter in NAMES]
        painter.setFont(interface_font(SMALL_TYPE))
        for k, (left, right) in enumerate(zip(places, (*places[1:], area.width()), strict=True)):
            part = QRectF(left, 0, right - left, area.height())
            strength = PALEST + (STRONGEST - PALEST) * k / (len(NAMES) - 1)
            painter.fillRect(part, blend(theme.raised, theme.accent, strength))
            chosen = k == self._chosen and (self.hasFocus() or self._held)
            cut = QRectF(left, 0, 2 if chosen else 1, area.height())
            painter.fillRect(cut, QColor(theme.text if chosen else theme.panel))
            painter.setPen(QColor(theme.text))
            word = f"{NAMES[k]} {self._begins[k]:.2f}"
            fits = painter.fontMetrics().horizontalAdvance(word) + GRID // 2 <= part.width()
            painter.drawText(part, Qt.AlignmentFlag.AlignCenter, word if fits and chosen else NAMES[k])
        if self.hasFocus() or self._held:
            painter.setPen(QColor(theme.accent))
            painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)

    def _wants(self, event: QKeyEvent) -> bool:
        plain = not event.modifiers() & ~Qt.KeyboardModifier.ShiftModifier
        arrows = event.key() in (Qt.Key.Key_Left, Qt.Key.Key_Right)
        return plain and (self._stepping or arrows or event.text().upper() in NAMES)

    def _tell(self, weight: float) -> None:
        self.previewed.emit(NAMES[self._chosen], weight)

    def _enter(self, weight: float) -> None:
        self._close_editor()
        self._tell(weight)
        self.committed.emit()

    def _close_editor(self) -> None:
        editor, self._editor = self._editor, None
        if editor is not None:
            editor.go_away()

    def _finish_steps(self) -> None:
        if self._stepping:
            self._stepping = False
            self.committed.emit()

    def _nearest(self, point: QPointF) -> int:
        return min(range(len(NAMES)), key=lambda k: abs(self.place(NAMES[k]) - point.x()))

    def _segment(self, x: float) -> int:
        """The letter at a place, -1 in front of A."""
        return sum(self.place(letter) <= x for letter in NAMES) - 1

    def _told(self, segment: int) -> str:
        what = f"{NAMES[segment]} begins at {self._begins[segment]:g}" if segment >= 0 else "Below A nothing is scored"
        return f"{what}<br>Drag the cuts · double-click types · A to E and arrows step"


def _fine(event: QMouseEvent | QKeyEvent) -> bool:
    return bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
