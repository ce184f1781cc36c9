"""Reads phonemes over time from a file, whatever program wrote it."""

from __future__ import annotations

from pathlib import Path

from facemodel.errors import ProjectError
from facemodel.io.damage import naming
from facemodel.io.disk import read_file
from facemodel.io.speech.moho import is_moho, read_moho
from facemodel.io.speech.rhubarb import read_rhubarb_json, read_rhubarb_tsv, read_rhubarb_xml
from facemodel.io.speech.spoken import Spoken
from facemodel.io.speech.textgrid import is_textgrid, read_textgrid

LARGEST_FILE = 1 << 26
"""Bytes; a day of speech takes less."""

READABLE = (".textgrid", ".tsv", ".json", ".xml", ".dat", ".txt")
"""Suffixes of files with phonemes."""


def read_speech(path: Path, rate: float | None = None) -> Spoken:
    """What is said, from a file of Rhubarb, Papagayo, Moho, Praat or the Montreal Forced Aligner.

    Parameters
    ----------
    path : the format is known by its content, else by its suffix
    rate : frames per second, for files that count frames

    Raises
    ------
    ProjectError
        If there is no such file, it is of another kind, or damaged; the place and the remedy are named.
    """
    suffix = path.suffix.lower()
    if suffix not in READABLE:
        raise ProjectError(f"“{path}” cannot be read: phonemes are in {', '.join(READABLE)} files.")
    data = read_file(path, LARGEST_FILE)
    with naming(path, "read"):
        if is_textgrid(data):
            return read_textgrid(data)
        if is_moho(data) or suffix == ".dat":
            return read_moho(data, rate)
        if suffix == ".json":
            return read_rhubarb_json(data)
        if suffix == ".xml":
            return read_rhubarb_xml(data)
        return read_rhubarb_tsv(data)
