"""The table that a person reads and the JSON that a program does."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path

from benchmarks.figure import Figure

COLUMNS = ("what", "measured", "against", "ratio", "limit", "")


def table(figures: Iterable[Figure]) -> str:
    """Figures as lines of aligned columns."""
    rows = [COLUMNS, *(_cells(figure) for figure in figures)]
    widths = [max(len(row[k]) for row in rows) for k in range(len(COLUMNS))]
    right = {1, 3, 4}
    lines = (
        "  ".join(f"{cell:>{width}}" if k in right else f"{cell:<{width}}" for k, (cell, width) in enumerate(pairs))
        for pairs in (zip(row, widths, strict=True) for row in rows)
    )
    return "\n".join(line.rstrip() for line in lines)


def _cells(figure: Figure) -> tuple[str, ...]:
    return (
        figure.what,
        "" if figure.value is None else f"{_digits(figure.value)} {figure.unit}".strip(),
        figure.against,
        "" if figure.ratio is None else _digits(figure.ratio),
        "" if figure.limit is None else f"{figure.limit:g}",
        figure.verdict,
    )


def _digits(value: float) -> str:
    """Three significant digits."""
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"


def write(
    path: Path,
    machine: Mapping[str, object],
    measured: Mapping[str, Sequence[Figure]],
    unmeasured: Mapping[str, str],
) -> None:
    """Write all figures as JSON."""
    path.parent.mkdir(parents=True, exist_ok=True)
    groups = {name: [asdict(f) | {"verdict": f.verdict} for f in figures] for name, figures in measured.items()}
    text = json.dumps({"machine": machine, "figures": groups, "unmeasured": unmeasured}, indent=1)
    path.write_text(text + "\n", encoding="utf-8")
