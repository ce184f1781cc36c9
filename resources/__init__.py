"""Data that ships with Risorius (faces, muscle atlas, FACS table, icons, themes) and a way to find it."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).resolve().parent
"""The folder that holds the data; `PROVENANCE.md` in it says where every file comes from."""


def resource(*parts: str) -> Path:
    """Path of a shipped file or folder, for example ``resource("faces", "ada.face")``."""
    return ROOT.joinpath(*parts)
