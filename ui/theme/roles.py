"""The two sets of colour roles.  Everything that is painted takes its colour from one of these names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

ThemeName = Literal["dark", "light"]


@dataclass(frozen=True)
class Theme:
    """Colour roles as ``#rrggbb``.

    Attributes
    ----------
    name : ``dark`` or ``light``
    window, panel, raised : backgrounds, from the furthest to the nearest
    hover : a raised background under the pointer
    line : separators and outlines
    text, muted : writing, and writing that recedes
    accent, on_accent : what is chosen or changed, and writing upon it
    left, right, both : fills that belong to the subject's left, right, or both sides
    ok, warn, error : states
    """

    name: ThemeName
    window: str
    panel: str
    raised: str
    hover: str
    line: str
    text: str
    muted: str
    accent: str
    on_accent: str
    left: str
    right: str
    both: str
    ok: str
    warn: str
    error: str


DARK = Theme(
    name="dark",
    window="#1f2226",
    panel="#262a30",
    raised="#30353c",
    hover="#343940",
    line="#3b424a",
    text="#e6e8eb",
    muted="#9aa3ad",
    accent="#f2845c",
    on_accent="#1f2226",
    left="#5ab1f0",
    right="#f07a96",
    both="#98a4b2",
    ok="#6cc08b",
    warn="#e8b949",
    error="#ee847f",
)

LIGHT = Theme(
    name="light",
    window="#e9ebee",
    panel="#f5f6f7",
    raised="#ffffff",
    hover="#eceef1",
    line="#cfd4da",
    text="#1d2126",
    muted="#57606a",
    accent="#b3441a",
    on_accent="#ffffff",
    left="#196cb0",
    right="#b92f5c",
    both="#606b78",
    ok="#25754a",
    warn="#835b00",
    error="#b8322b",
)

THEMES: Mapping[str, Theme] = {"dark": DARK, "light": LIGHT}
"""Both themes by name."""
