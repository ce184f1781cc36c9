"""Compare the anatomy with measured expressions, and say how near it comes."""

from __future__ import annotations

import sys
from argparse import Namespace
from pathlib import Path

from app.cli.progress import ProgressLine
from facemodel.calibration.compare import carried_over, measured_report, sculpted_report
from facemodel.calibration.measured import read_measured
from facemodel.calibration.report import Report, report_json, report_text
from facemodel.io.disk import checked_target, replacing
from facemodel.io.project_file import load_project
from facemodel.io.readable import readable
from facemodel.projects import new_project

PROJECT_SUFFIX = ".risorius"


def calibrate(asked: Namespace) -> int:
    """Print the figures, and write them where that was asked."""
    out: Path | None = asked.out
    if out is not None:
        checked_target(out)
    report = _reported(asked.measured)
    print(report_text(report))
    if out is not None:
        with replacing(out) as stream:
            stream.write(readable(report_json(report)))
        print(f"Wrote {out}")
    return 0


def _reported(path: Path) -> Report:
    line = ProgressLine(sys.stderr)
    try:
        if path.suffix.lower() == PROJECT_SUFFIX:
            return sculpted_report(str(path), load_project(path), line)
        line("Laying our head on the measured one", 0.0)
        return measured_report(str(path), carried_over(read_measured(path), new_project()), line)
    finally:
        line.clear()
