"""Make the page of plates, ``docs/action-units.md``: ``make plates``, or this file under ``.ci/with-display``.

Every action unit and emotion of the default face at full strength, front and three-quarter, with the neutral face
beside it; its muscles, how far it moves the skin, and how near its field comes to what an artist sculpted on this head
and, where a file of measured expressions is named on the command line, to those.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np
from PIL import Image

from facemodel.actions import GROUP_TITLES, ActionUnit, Emotion, Expression, expand
from facemodel.cache import solve_cached
from facemodel.calibration.compare import carried_over, measured_report, sculpted_report
from facemodel.calibration.measured import read_measured
from facemodel.calibration.report import Report
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solve import Solution
from ui.headless.stage import Stage, stage
from ui.viewport.camera import face_frame, look_along

PAGE = Path(__file__).parent / "action-units.md"
PLATES = Path(__file__).parent / "plates"
PORTRAIT = (300, 360)
"""Width and height of each of the three pictures of a plate, pixels."""
FRONT, TURNED = (0.0, 0.0), (38.0, 3.0)
"""Azimuth and elevation, degrees."""
QUALITY = 82
"""Of JPEG: fifty plates stay within two megabytes."""

INTRODUCTION = """\
# Action units and emotions

Every unit and emotion of the default face at full strength, beside the neutral face; built by `make plates`. Under
each action unit: its muscles with their share, the largest displacement of the skin on one side, and the area-weighted
cosine of its field with what an artist sculpted on this head and with measured expressions of a scanned face
(`risorius calibrate`), where there is one that this unit alone answers.
"""


def picture(made: Stage, project: Project, expression: Expression, view: tuple[float, float]) -> np.ndarray:
    """One picture of an expression."""
    made.scene.pose(expression)
    camera = made.scene.renderer.GetActiveCamera()
    look_along(camera, face_frame(project.face), *view, PORTRAIT[0] / PORTRAIT[1])
    return np.asarray(made.picture())


def draw(made: Stage, project: Project, expression: Expression, name: str) -> str:
    """Draw a plate, and return the line of the page that shows it."""
    shown = [({}, FRONT), (expression, FRONT), (expression, TURNED)]
    plate = np.concatenate([picture(made, project, each, view) for each, view in shown], axis=1)
    Image.fromarray(plate).save(PLATES / f"{name}.jpg", quality=QUALITY, optimize=True)
    print(f"docs/plates/{name}.jpg")
    return f"![{name}](plates/{name}.jpg)"


def figures(unit: ActionUnit, reports: Mapping[str, Report]) -> Iterable[str]:
    """How near the field of a unit comes to what others made of it, one phrase per report."""
    for whose, report in reports.items():
        own = [row.figures.cosine for row in report.rows if set(row.fields) <= set(unit.fields)]
        if own:
            yield f"cosine {np.mean(own):.2f} {whose}"


def unit_entry(
    made: Stage, project: Project, solution: Solution, unit: ActionUnit, reports: Mapping[str, Report]
) -> str:
    """The entry of an action unit."""
    plate = draw(made, project, unit.portrait, f"au-{unit.number:02d}")
    most = max((abs(weight) for weight in unit.muscles.values()), default=1.0)
    pulls = [f"{name.replace('_', ' ')} {weight / most:.2g}" for name, weight in unit.muscles.items()]
    if unit.jaw is not None:
        pulls.append("the jaw")
    peak = max((solution.basis.peak(name) for name in unit.fields if name in solution.basis.index), default=0.0)
    said = "; ".join([", ".join(pulls), f"{peak:.1f} mm", *figures(unit, reports)])
    return f"### {unit.number} {unit.name}\n\n{plate}\n\n{said}.\n"


def emotion_entry(made: Stage, project: Project, emotion: Emotion) -> str:
    """The entry of an emotion."""
    name = emotion.name.replace(", ", "-").replace(" ", "-")
    plate = draw(made, project, expand(emotion.weights, project.units), name)
    recipe = " + ".join(n if w == 1 else f"{n} ({w:g})" for n, w in emotion.weights.items())
    return f"### {emotion.title}\n\n{plate}\n\n{recipe}\n"


def main(measured: Path | None) -> None:
    """Draw all plates and write the page."""
    PLATES.mkdir(exist_ok=True)
    project = new_project()
    solution = solve_cached(project)
    reports = {"with what was sculpted": sculpted_report("", project)}
    if measured is not None:
        fitted = carried_over(read_measured(measured), project)
        reports["with a scanned face"] = measured_report("", fitted)
    with stage(PORTRAIT) as made:
        made.scene.show(project, solution)
        parts = [INTRODUCTION, "## Emotions\n", *(emotion_entry(made, project, each) for each in project.emotions)]
        for group, title in GROUP_TITLES.items():
            own = [unit for unit in project.units if unit.group == group]
            parts += [f"## {title}\n", *(unit_entry(made, project, solution, unit, reports) for unit in own)]
    PAGE.write_text("\n".join(parts), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
