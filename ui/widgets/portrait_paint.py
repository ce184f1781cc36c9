"""How a portrait is laid into a place of any shape."""

from __future__ import annotations

from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QImage, QPainter, QPainterPath

from ui.theme.apply import current_theme


def paint_portrait(painter: QPainter, shape: QPainterPath, picture: QImage | None, higher: float = 0.5) -> None:
    """Fill a shape with a picture, cut to fit it; without a picture it is an even ground.

    Parameters
    ----------
    shape : what is filled
    higher : which part of what is too high is kept, 0 the top and 1 the bottom
    """
    area = shape.boundingRect()
    painter.save()
    painter.setClipPath(shape)
    painter.fillRect(area, QColor(current_theme().raised))
    if picture is not None:
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawImage(area, picture, cut_to(picture, area, higher))
    painter.restore()


def cut_to(picture: QImage, area: QRectF, higher: float = 0.5) -> QRectF:
    """The largest part of a picture that has the shape of an area, in pixels."""
    wide, high = float(picture.width()), float(picture.height())
    aspect = area.width() / max(area.height(), 1.0)
    if wide / high > aspect:
        return QRectF((wide - high * aspect) / 2, 0.0, high * aspect, high)
    cut = wide / aspect
    return QRectF(0.0, (high - cut) * higher, wide, cut)
