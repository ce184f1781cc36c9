"""The layout of a contact sheet: sections of captioned pictures under a title."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from ui.viewport.surface import ByteArray

PAPER, INK, MUTED, ACCENT, RULE = "#17191c", "#e6e8eb", "#8b949e", "#f2845c", "#2e343b"
MARGIN, GAP = 72, 24
TITLE, HEADING, NAME, NOTE = 52, 26, 22, 18
CAPTION = 74
"""Pixels under a picture for its two lines."""


@dataclass(frozen=True, eq=False)
class Entry:
    """A captioned picture.

    Attributes
    ----------
    image : (h, w, 3) uint8, all of one size
    mark : what stands first in the caption, in the accent colour; may be empty
    name : what it is
    note : a second line
    """

    image: ByteArray
    mark: str
    name: str
    note: str


@dataclass(frozen=True, eq=False)
class Section:
    """Entries under a heading."""

    heading: str
    entries: Sequence[Entry]


def sheet(title: str, subtitle: str, sections: Sequence[Section], columns: int) -> ByteArray:
    """Lay sections out under a title, (h, w, 3) uint8."""
    height, width = sections[0].entries[0].image.shape[:2]
    full = 2 * MARGIN + columns * width + (columns - 1) * GAP
    rows = [-(-len(section.entries) // columns) for section in sections]
    tall = MARGIN + 130 + sum(64 + row * (height + CAPTION) + GAP for row in rows) + MARGIN // 2
    paper = Image.new("RGB", (full, tall), PAPER)
    pen = ImageDraw.Draw(paper)
    pen.text((MARGIN, MARGIN), title, INK, _font(TITLE), anchor="ls")
    pen.text((MARGIN, MARGIN + 44), subtitle, MUTED, _font(HEADING), anchor="ls")
    top = MARGIN + 110
    for section, count in zip(sections, rows, strict=True):
        pen.line([(MARGIN, top), (full - MARGIN, top)], RULE, 1)
        pen.text((MARGIN, top + 38), section.heading, INK, _font(HEADING), anchor="ls")
        top += 64
        for k, entry in enumerate(section.entries):
            left = MARGIN + (k % columns) * (width + GAP)
            _place(paper, pen, entry, left, top + (k // columns) * (height + CAPTION))
        top += count * (height + CAPTION) + GAP
    return np.asarray(paper)


def _place(paper: Image.Image, pen: ImageDraw.ImageDraw, entry: Entry, left: int, top: int) -> None:
    height, width = entry.image.shape[:2]
    paper.paste(Image.fromarray(entry.image), (left, top))
    at = left
    base = top + height + 30
    if entry.mark:
        pen.text((at, base), entry.mark, ACCENT, _font(NAME), anchor="ls")
        at += round(pen.textlength(entry.mark, _font(NAME))) + 10
    pen.text((at, base), _fitted(pen, entry.name, left + width - at, NAME), INK, _font(NAME), anchor="ls")
    pen.text((left, base + 26), _fitted(pen, entry.note, width, NOTE), MUTED, _font(NOTE), anchor="ls")


def _fitted(pen: ImageDraw.ImageDraw, text: str, width: int, size: int) -> str:
    """The text, shortened with an ellipsis if it is wider than that."""
    if pen.textlength(text, _font(size)) <= width:
        return text
    while text and pen.textlength(text + "…", _font(size)) > width:
        text = text[:-1]
    return text.rstrip() + "…"


def _font(size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    """The typeface that comes with Pillow, so that every sheet looks the same everywhere."""
    return ImageFont.load_default(size)
