"""Tables of numbers with a heading, as trackers write them."""

from __future__ import annotations

import csv
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.io.damage import DamageError
from fem.types import FloatArray

CORRECT = "correct that line, or record again"
GAPS = {"", "nan", "na", "n/a", "-", "null", "none", "inf", "-inf", "+inf"}
"""Cells that stand for a number that is missing."""

SEPARATORS = ",;\t"

Wanted = Callable[[str], bool]
"""Whether a column is read, by its heading."""


@dataclass(frozen=True, eq=False)
class Table:
    """Columns of a table.

    Attributes
    ----------
    names : (C,) headings of the columns of numbers, without blanks around them
    values : (N, C), not a number where one is missing
    texts : columns that were asked for as text, by heading
    lines : (N,) numbers of the lines
    notes : what was left out
    """

    names: tuple[str, ...]
    values: FloatArray
    texts: Mapping[str, tuple[str, ...]]
    lines: tuple[int, ...]
    notes: tuple[str, ...] = ()

    def column(self, *names: str) -> FloatArray | None:
        """The first column that has one of some names, whatever its case; none if there is none."""
        known = {name.casefold(): k for k, name in enumerate(self.names)}
        found = next((known[name.casefold()] for name in names if name.casefold() in known), None)
        return None if found is None else self.values[:, found]


def decoded(data: bytes) -> str:
    """The text of a file.

    Raises
    ------
    DamageError
        If it is none in UTF-8 or UTF-16.
    """
    try:
        return data.decode("utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig")
    except UnicodeDecodeError as error:
        raise DamageError("the file", "is no text in UTF-8", "save it as such") from error


def heading(data: bytes) -> tuple[str, ...]:
    """The headings of a table; a single one if it is no table."""
    first = next((line for line in decoded(data).splitlines() if line.strip()), "")
    return tuple(name.strip() for name in next(csv.reader([first], delimiter=_separator(first)), []))


def read_table(data: bytes, wanted: Wanted, texts: Sequence[str] = ()) -> Table:
    """A table from the bytes of a file.

    Parameters
    ----------
    data : the whole file
    wanted : which columns of numbers are read
    texts : headings, in lower case, of columns that are text

    Raises
    ------
    DamageError
        If it is no table, has no wanted column or one twice, a line has too few or too many cells, or a cell is no
        number; the line is named.
    """
    lines = [(k, line) for k, line in enumerate(decoded(data).splitlines(), start=1) if line.strip()]
    if not lines:
        raise DamageError("the file", "is empty", "record again")
    separator = _separator(lines[0][1])
    names = [name.strip() for name in next(csv.reader([lines[0][1]], delimiter=separator))]
    chosen = [k for k, name in enumerate(names) if name.casefold() not in texts and wanted(name)]
    spoken = [k for k, name in enumerate(names) if name.casefold() in texts]
    _check_once([names[k].casefold() for k in (*chosen, *spoken)])
    rows, notes = _whole_rows(lines[1:], separator, len(names))
    values = _fast(rows, separator, chosen) if chosen else np.zeros((len(rows), 0))
    cells = _cells(rows, separator) if values is None or spoken else []
    if values is None:
        values = _slow(rows, cells, chosen, names)
    return Table(
        tuple(names[k] for k in chosen),
        np.where(np.isfinite(values), values, np.nan),
        {names[k].casefold(): tuple(cell[k].strip() for cell in cells) for k in spoken},
        tuple(line for line, _ in rows),
        notes,
    )


def _separator(line: str) -> str:
    return max(SEPARATORS, key=line.count)


def _check_once(names: Sequence[str]) -> None:
    for name in names:
        if names.count(name) > 1:
            raise DamageError("line 1", f"has the column “{name}” twice", "give every column a name of its own")


def _whole_rows(
    lines: Sequence[tuple[int, str]], separator: str, width: int
) -> tuple[list[tuple[int, str]], tuple[str, ...]]:
    """The lines that have a cell for every heading; a last one that was cut short is left out."""
    rows = list(lines)
    if rows and _count(rows[-1][1], separator) < width:
        line, _ = rows.pop()
        if rows:
            return rows, (f"Line {line}, the last one, is cut short and was left out.",)
        raise DamageError(f"line {line}", "is cut short, and there is no other", "record again")
    if not rows:
        raise DamageError("the file", "has a heading and no line of numbers", "record again")
    return rows, ()


def _count(line: str, separator: str) -> int:
    return line.count(separator) + 1 if '"' not in line else len(next(csv.reader([line], delimiter=separator)))


def _fast(rows: Sequence[tuple[int, str]], separator: str, chosen: Sequence[int]) -> FloatArray | None:
    """All numbers at once; none if a line or a cell is not as all others."""
    try:
        return np.loadtxt([line for _, line in rows], delimiter=separator, usecols=chosen, comments=None, ndmin=2)
    except ValueError:
        return None


def _cells(rows: Sequence[tuple[int, str]], separator: str) -> list[list[str]]:
    return list(csv.reader((line for _, line in rows), delimiter=separator))


def _slow(
    rows: Sequence[tuple[int, str]], cells: Sequence[Sequence[str]], chosen: Sequence[int], names: Sequence[str]
) -> FloatArray:
    """The numbers one by one, so that the first that is wrong can be named."""
    values = np.full((len(rows), len(chosen)), np.nan)
    for row, ((line, _), cell) in enumerate(zip(rows, cells, strict=True)):
        # A line of two cells is how some trackers say that they saw no face.
        if len(cell) != len(names) and len(cell) > 2:
            raise DamageError(f"line {line}", f"has {len(cell)} cells and the heading {len(names)}", CORRECT)
        for column, k in enumerate(chosen):
            text = cell[k].strip() if k < len(cell) else ""
            if text.casefold() not in GAPS:
                values[row, column] = _number(text, line, names[k])
    return values


def _number(text: str, line: int, name: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise DamageError(f"line {line}", f"says “{text[:30]}” under {name}, which is no number", CORRECT) from None
