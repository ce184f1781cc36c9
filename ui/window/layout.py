"""The layout of the window as text: where the docks are and which groups are folded."""

from __future__ import annotations

import base64
import binascii
import json
from dataclasses import dataclass, field

VERSION = 4
"""Raised when docks are added or renamed, so that an older layout is not forced on a newer window."""


@dataclass(frozen=True)
class Layout:
    """What is remembered of the window beside its place on the screen.

    Attributes
    ----------
    docks : Qt's own state of docks and toolbars
    folded : keys of the folded groups of action units
    workspace : which one was open
    timeline : whether the timeline was open, and not folded to one line
    """

    docks: bytes = b""
    folded: frozenset[str] = field(default_factory=frozenset)
    workspace: str = "expression"
    timeline: bool = False


def layout_text(layout: Layout) -> str:
    """The layout as text."""
    docks = base64.b64encode(layout.docks).decode()
    members = {"docks": docks, "folded": sorted(layout.folded), "workspace": layout.workspace}
    return json.dumps({"version": VERSION, **members, "timeline": layout.timeline})


def layout_from(text: str) -> Layout:
    """The layout in a text; the default one where the text is of another version or no layout at all."""
    try:
        members = json.loads(text)
        if members["version"] != VERSION:
            return Layout()
        docks = base64.b64decode(members["docks"], validate=True)
        folded = frozenset(map(str, members["folded"]))
        return Layout(docks, folded, str(members["workspace"]), bool(members["timeline"]))
    except (ValueError, KeyError, TypeError, binascii.Error):
        return Layout()
