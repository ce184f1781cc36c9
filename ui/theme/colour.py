"""Arithmetic on colours."""

from __future__ import annotations

from PySide6.QtGui import QColor


def blend(below: str | QColor, above: str | QColor, share: float) -> QColor:
    """The colour ``share`` (0..1) of the way from ``below`` to ``above``."""
    a, b = QColor(below), QColor(above)
    mixed = (x + (y - x) * share for x, y in zip(a.getRgbF()[:3], b.getRgbF()[:3], strict=True))
    return QColor.fromRgbF(*mixed)


def luminance(colour: str | QColor) -> float:
    """Relative luminance in 0..1 (WCAG 2.2)."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in QColor(colour).getRgbF()[:3]]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str | QColor, other: str | QColor) -> float:
    """Contrast ratio of two colours, 1..21 (WCAG 2.2)."""
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)
