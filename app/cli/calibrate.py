"""Compare the anatomy with measured expressions, and say how near it comes."""

from __future__ import annotations

import sys
from argparse import Namespace
from pathlib import Path

from app.cli.progress import ProgressLine
from facemodel.anatomy.files import shipped_anatomy, write_anatomy
from facemodel.calibration.adjust import Learned
from facemodel.calibration.compare import adjusted, carried_over, measured_report, sculpted_report
from facemodel.calibration.measured import read_measured
from facemodel.calibration.report import Report, learned_json, learned_text, report_json, report_text
from facemodel.io.disk import checked_target, replacing
from facemodel.io.project_file import load_project
from facemodel.io.readable import readable
from facemodel.projects import new_project

PROJECT_SUFFIX = ".risorius"


def calibrate(asked: Namespace) -> int:
    """Print the figures, and write them and what was learned where that was asked."""
    for out in (asked.out, asked.learn):
        if out is not None:
            checked_target(out)
    report, found = _reported(asked)
    print(report_text(report))
    document = report_json(report)
    if found is not None:
        print(learned_text(found))
        document["learned"] = learned_json(found)
    if asked.out is not None:
        with replacing(asked.out) as stream:
            stream.write(readable(document))
        print(f"Wrote {asked.out}")
    if asked.learn is not None and found is not None:
        write_anatomy(found.anatomy, asked.learn)
        print(f"Wrote {asked.learn}: the recipe that was learned")
    return 0


def _reported(asked: Namespace) -> tuple[Report, Learned | None]:
    path: Path = asked.measured
    line = ProgressLine(sys.stderr)
    try:
        if path.suffix.lower() == PROJECT_SUFFIX:
            return sculpted_report(str(path), load_project(path), line), None
        measured = read_measured(path)
        line("Laying our head on the measured one", 0.0)
        fitted = carried_over(measured, new_project())
        if asked.report_only:
            return measured_report(str(path), fitted, line), None
        made = adjusted(str(path), fitted, shipped_anatomy(), line)
        return made.report, made.learned
    finally:
        line.clear()
