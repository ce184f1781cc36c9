"""The report of a calibration: figures of every expression, as data and for people."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from facemodel.arkit import answering_fields, find_arkit
from facemodel.calibration.figures import Figures, compare_fields
from fem.types import FloatArray


@dataclass(frozen=True)
class Row:
    """One measured expression.

    Attributes
    ----------
    name : as it was given
    fields : weights of the displacement fields that answer it
    figures : solved against measured
    """

    name: str
    fields: Mapping[str, float]
    figures: Figures


@dataclass(frozen=True)
class Report:
    """All measured expressions.

    Attributes
    ----------
    source : what was measured
    rows : those that an action unit answers, in their order
    left_out : reasons by the name of each expression that none answers
    """

    source: str
    rows: tuple[Row, ...]
    left_out: Mapping[str, str] = field(default_factory=dict)

    @property
    def mean(self) -> float:
        """Mean cosine; none counts as zero."""
        return float(np.mean([row.figures.cosine for row in self.rows])) if self.rows else 0.0

    @property
    def worst(self) -> float:
        """Smallest cosine."""
        return min((row.figures.cosine for row in self.rows), default=0.0)


def wanted_fields(names: Sequence[str], fields: Sequence[str]) -> tuple[dict[str, dict[str, float]], dict[str, str]]:
    """Which displacement fields answer some expressions, and why others are left out.

    Parameters
    ----------
    names : of expressions, in the ARKit manner
    fields : names of displacement fields that there are
    """
    wanted: dict[str, dict[str, float]] = {}
    left_out: dict[str, str] = {}
    for name in names:
        found = find_arkit(name)
        if found is None:
            left_out[name] = "is no name of an ARKit face unit"
            continue
        weights = answering_fields(*found, fields)
        if weights:
            wanted[name] = weights
        else:
            left_out[name] = found[0].note or "is answered by no action unit of this face"
    return wanted, left_out


def make_report(
    source: str, measured: Mapping[str, FloatArray], solved: Mapping[str, FloatArray], areas: FloatArray
) -> Report:
    """Compare measured fields (N, 3) by name with solved ones (N, 3) by the names of displacement fields."""
    wanted, left_out = wanted_fields(list(measured), list(solved))
    rows = []
    for name, weights in wanted.items():
        mixed = np.sum([weight * solved[each] for each, weight in weights.items()], axis=0)
        figures = compare_fields(measured[name], mixed, areas)
        if figures.measured > 0:
            rows.append(Row(name, weights, figures))
        else:
            left_out[name] = "does not move the measured skin"
    return Report(source, tuple(rows), left_out)


def report_json(report: Report) -> dict[str, Any]:
    """The report as JSON."""
    return {
        "source": report.source,
        "mean_cosine": report.mean,
        "worst_cosine": report.worst,
        "expressions": [{"name": row.name, "fields": dict(row.fields), **asdict(row.figures)} for row in report.rows],
        "left_out": dict(report.left_out),
    }


HEAD = ("cosine", "explained", "RMS mm", "max mm", "direction", "factor")


def report_text(report: Report) -> str:
    """The report for people: a line per expression and the mean."""
    names = [f"{row.name} ({mixture(row.fields)})" for row in report.rows]
    wide = max((len(name) for name in (*names, "mean")), default=0)
    lines = [" " * wide + "".join(f"{title:>11}" for title in HEAD)]
    for name, row in zip(names, report.rows, strict=True):
        f = row.figures
        lines.append(
            f"{name:<{wide}}{f.cosine:>11.3f}{f.explained:>11.1%}{f.rms:>11.2f}{f.largest:>11.1f}"
            f"{f.direction:>10.1f}°{f.factor:>11.2f}"
        )
    if report.rows:
        explained, rms = (np.mean([getattr(row.figures, each) for row in report.rows]) for each in ("explained", "rms"))
        direction = np.mean([row.figures.direction for row in report.rows])
        lines.append(f"{'mean':<{wide}}{report.mean:>11.3f}{explained:>11.1%}{rms:>11.2f}{'':>11}{direction:>10.1f}°")
    lines += [f"left out: {name} {why}" for name, why in report.left_out.items()]
    return "\n".join(lines)


def mixture(fields: Mapping[str, float]) -> str:
    """Weights of fields as people write them: ``AU 12L``, ``AU 12L + 0.3 AU 6L``."""
    return " + ".join(f"AU {name}" if weight == 1 else f"{weight:g} AU {name}" for name, weight in fields.items())
