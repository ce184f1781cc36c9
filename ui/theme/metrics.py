"""Lengths of the 8 px grid, in device-independent pixels."""

from __future__ import annotations

GRID = 8
"""The unit of all spacing; half of it separates what belongs together."""

ROW = 26
"""Height of a row that can be clicked or dragged."""

ICON = 16
"""Side of an icon."""

TYPE = 13
"""Size of the one typeface."""

SMALL_TYPE = 11
"""Size of headings in capitals and of secondary figures."""

RADIUS = 3
"""Rounding of fills and outlines: enough not to look cut out, too little to look like a toy."""
