"""A choice that is no wider than its panel, however long its entries are."""

from __future__ import annotations

from PySide6.QtWidgets import QComboBox

LEAST = 8
"""Letters of an entry that there is room for at least; the list itself shows all of them."""


def narrow_choice(name: str, hint: str = "") -> QComboBox:
    """A box of choices with a name for those who cannot see it, and a hint."""
    box = QComboBox()
    box.setAccessibleName(name)
    box.setToolTip(hint)
    box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(LEAST)
    return box
