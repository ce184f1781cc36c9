"""Compare the anatomy with measured expressions, and say how near it comes."""

from __future__ import annotations

import sys
from argparse import Namespace
from pathlib import Path

from app.cli.progress import ProgressLine
from app.cli.stopping import Stopping
from facemodel.anatomy.files import shipped_anatomy, write_anatomy
from facemodel.calibration.compare import Adjusted, adjusted, carried_over, measured_report, sculpted_report
from facemodel.calibration.learned_report import held_out_json, held_out_text, learned_json, learned_text
from facemodel.calibration.measured import read_measured
from facemodel.calibration.report import Report, report_json, report_text
from facemodel.errors import ProjectError
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
    if asked.hold_out and (asked.report_only or _is_project(asked.measured)):
        raise ProjectError("Nothing is learned that could be held out: --hold-out needs a measured face to adjust to.")
    report, made = _reported(asked)
    print(report_text(report))
    document = report_json(report)
    if made is not None:
        print(learned_text(made.learned))
        document["learned"] = learned_json(made.learned)
        if made.checks:
            print(held_out_text(made.checks))
            document["hold_out"] = held_out_json(made.checks)
    if asked.out is not None:
        with replacing(asked.out) as stream:
            stream.write(readable(document))
        print(f"Wrote {asked.out}")
    if asked.learn is not None and made is not None:
        write_anatomy(made.learned.anatomy, asked.learn)
        print(f"Wrote {asked.learn}: the recipe that was learned")
    return 0


def _is_project(path: Path) -> bool:
    return path.suffix.lower() == PROJECT_SUFFIX


def _reported(asked: Namespace) -> tuple[Report, Adjusted | None]:
    path: Path = asked.measured
    line = ProgressLine(sys.stderr)
    try:
        if _is_project(path):
            return sculpted_report(str(path), load_project(path), line), None
        measured, project = read_measured(path), new_project()
        line("Laying our head on the measured one", 0.0)
        fitted = carried_over(measured, project)
        if asked.report_only:
            return measured_report(str(path), fitted, line), None
        with Stopping(line) as told:
            made = adjusted(str(path), fitted, shipped_anatomy(), told, project if asked.hold_out else None)
        return made.report, made
    finally:
        line.clear()
