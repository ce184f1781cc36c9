"""One model of a muscle as a card: what it does to this face, how far, and how like the model in use."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QSizePolicy

from facemodel.model_fields import ModelField
from facemodel.muscles.models import MODELS
from facemodel.muscles.muscle import Model
from ui.theme.apply import current_theme, interface_font
from ui.theme.colour import blend
from ui.theme.metrics import GRID, RADIUS, SMALL_TYPE, TYPE
from ui.viewport.surface import ByteArray

PICTURE = QSize(24 * GRID, 25 * GRID)
LINES = 3
LINE = TYPE + 6
STILL = 0.005
"""Millimetres below which nothing is said to move."""


class ModelCard(QAbstractButton):
    """Shows one model; a click chooses it.

    Parameters
    ----------
    model : which one
    """

    def __init__(self, model: Model) -> None:
        super().__init__()
        self.model = model
        self._image: QImage | None = None
        self._figures = ("", "")
        self.setText(MODELS[model].title)
        self.setToolTip(f"{MODELS[model].title}: {MODELS[model].source}<br>Click to use it for the selected muscles")
        self.setAccessibleName(MODELS[model].title)
        self.setCheckable(True)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    @property
    def figures(self) -> tuple[str, str]:
        """What it says in numbers."""
        return self._figures

    @property
    def has_picture(self) -> bool:
        """Whether its picture is there."""
        return self._image is not None

    def show_field(self, field: ModelField | None, own: bool) -> None:
        """Say what the model does; nothing while it is not known."""
        self._image = None
        if field is None:
            self._figures = ("", "")
        elif field.largest < STILL:
            self._figures = ("moves nothing here", "")
        else:
            alike = (
                "in use" if own else "" if field.cosine is None else f"cosine {field.cosine:.2f} to the model in use"
            )
            self._figures = (f"{field.largest:.2f} mm at most", alike)
        self.setAccessibleDescription(", ".join(filter(None, self._figures)))
        self.update()

    def show_picture(self, picture: ByteArray) -> None:
        """Show what the face looks like under it."""
        height, width, _ = picture.shape
        self._image = QImage(picture.tobytes(), width, height, 4 * width, QImage.Format.Format_RGBA8888)
        self._image.setDevicePixelRatio(self.devicePixelRatioF())
        self.update()

    def picture_size(self) -> tuple[int, int]:
        """Width and height of the picture in pixels of the screen."""
        scale = self.devicePixelRatioF()
        return round(PICTURE.width() * scale), round(PICTURE.height() * scale)

    def sizeHint(self) -> QSize:
        """The picture, and three lines under it."""
        return QSize(PICTURE.width(), PICTURE.height() + LINES * LINE + 2 * GRID)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw picture, title and figures; the model in use has a frame."""
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = QRectF(self.rect()).adjusted(1, 1, -1, -1)
        chosen, near = self.isChecked(), self.underMouse() or self.hasFocus()
        painter.setPen(QPen(QColor(theme.accent if chosen or self.hasFocus() else theme.line), 2.0 if chosen else 1.0))
        painter.setBrush(QColor(theme.hover) if near else blend(theme.panel, theme.window, 0.5))
        painter.drawRoundedRect(area, RADIUS, RADIUS)
        if self._image is not None:
            painter.drawImage(1, 1, self._image)
        line = QRectF(GRID, PICTURE.height() + GRID, self.width() - 2 * GRID, LINE)
        written = (
            (self.text(), theme.text, TYPE),
            (self._figures[0], theme.text, TYPE),
            (self._figures[1], theme.muted, SMALL_TYPE),
        )
        for text, colour, size in written:
            painter.setFont(interface_font(size))
            painter.setPen(QColor(theme.accent if text == "in use" else colour))
            fitting = painter.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, int(line.width()))
            painter.drawText(line, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, fitting)
            line.translate(0, LINE)
