"""``python -m benchmarks [NAME ...]``: measure, print the table, write ``benchmarks/results/latest.json``."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

# As the program runs, see `ui`; it must be set before NumPy is loaded, and its children inherit it.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from benchmarks import (
    animation,
    authoring,
    contact,
    exports,
    frames,
    growth,
    solving,
    start,
    superposition,
    timeline,
    tissue,
)
from benchmarks.figure import Figure, Unmeasured
from benchmarks.machine import machine
from benchmarks.report import table, write

LATEST = Path(__file__).resolve().parent / "results" / "latest.json"

BENCHMARKS: Mapping[str, Callable[[], Iterator[Figure]]] = {
    "superposition": superposition.figures,
    "frames": frames.figures,
    "solving": solving.figures,
    "growth": growth.figures,
    "start": start.figures,
    "authoring": authoring.figures,
    "animation": animation.figures,
    "timeline": timeline.figures,
    "contact": contact.figures,
    "tissue": tissue.figures,
    "exports": exports.figures,
}


def main() -> int:
    """Measure what is named, or everything."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"any of {', '.join(BENCHMARKS)}; default: all")
    names = parser.parse_args().names or list(BENCHMARKS)
    unknown = sorted(set(names) - set(BENCHMARKS))
    if unknown:
        parser.error(f"there is no benchmark {unknown[0]}; choose from {', '.join(BENCHMARKS)}")
    about = machine()
    measured: dict[str, list[Figure]] = {}
    unmeasured: dict[str, str] = {}
    for name in names:
        print(f"measuring {name} ...", file=sys.stderr, flush=True)
        measured[name] = []
        try:
            for figure in BENCHMARKS[name]():
                measured[name].append(figure)
        except Unmeasured as reason:
            unmeasured[name] = str(reason)
    print(table(figure for figures in measured.values() for figure in figures))
    for name, reason in unmeasured.items():
        print(f"not measured, {name}: {reason}")
    print(f"on {about['processor']}, {about['cores']} cores, {about['blas']}, load {about['load']} at the start")
    write(LATEST, about, measured, unmeasured)
    print(f"written to {LATEST}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
