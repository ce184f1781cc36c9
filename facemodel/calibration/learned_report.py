"""What was learned, and the cross-checks of it, as data and for people."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from facemodel.calibration.adjust import Change, Learned
from facemodel.calibration.hold_out import HeldOut


def learned_json(found: Learned) -> dict[str, Any]:
    """What was learned as JSON."""
    return {
        "mean_cosine_before": found.before,
        "mean_cosine_after": found.after,
        "stopped": found.stopped,
        "goals": [asdict(goal) for goal in found.goals],
        "turned": dict(found.turns),
        "turned_to_bounds": found.at_bounds,
        "mixtures": {str(number): dict(pulls) for number, pulls in found.mixtures.items()},
    }


def learned_text(found: Learned) -> str:
    """What was learned for people."""
    lines = [
        f"learned{' until it was stopped' if found.stopped else ''}: {len(found.turns)} knobs turned, "
        f"{found.at_bounds} of them to their bounds",
        "cosine with the best mixture of muscles, on what was learned from (a training figure):",
        *_table(found.goals, found.before, found.after),
        "mixtures:",
    ]
    for number, pulls in found.mixtures.items():
        parts = " + ".join(f"{weight:.2g} {name.replace('_', ' ')}" for name, weight in pulls.items() if weight)
        lines.append(f"  AU {number}: {parts or 'the jaw alone'}")
    return "\n".join(lines)


def held_out_json(checks: Sequence[HeldOut]) -> list[dict[str, Any]]:
    """Cross-checks as JSON."""
    return [
        {
            "learned_from": check.learned_from,
            "told_on": check.told_on,
            "mean_cosine_before": check.before,
            "mean_cosine_after": check.after,
            "expressions": [asdict(change) for change in check.changes],
        }
        for check in checks
    ]


def held_out_text(checks: Sequence[HeldOut]) -> str:
    """Cross-checks for people."""
    lines = ["held out: cosine on expressions that nothing was learned from, with mixtures known without them"]
    for check in checks:
        lines.append(f"learned from {check.learned_from}, told on {check.told_on}:")
        lines += _table(check.changes, check.before, check.after)
    return "\n".join(lines)


def _table(changes: Sequence[Change], before: float, after: float) -> list[str]:
    rows = [*((change.name, change.before, change.after) for change in changes), ("mean", before, after)]
    wide = max(len(name) for name, _, _ in rows)
    head = f"  {'':<{wide}}{'before':>9}{'after':>9}{'gain':>9}"
    return [head, *(f"  {name:<{wide}}{old:>9.3f}{new:>9.3f}{new - old:>+9.3f}" for name, old, new in rows)]
