"""A contact sheet of a face: neutral, every action unit and every emotion, from the front and three-quarter."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from facemodel.actions import GROUP_TITLES, ActionUnit, Emotion, Expression, expand
from facemodel.io.disk import checked_target
from facemodel.project import Project
from facemodel.solve import Solution
from ui.headless.picture import write_png
from ui.headless.sheet import Entry, Section, sheet
from ui.headless.stage import Stage, stage
from ui.panels.unit_text import motion_words
from ui.viewport.camera import face_frame, head_frame, look_along
from ui.viewport.surface import ByteArray

PORTRAIT = (264, 324)
"""Width and height of each of the two pictures of an entry, pixels."""
COLUMNS = 5
FRONT, TURNED = (0.0, 0.0), (38.0, 3.0)
"""Azimuth and elevation of the two pictures, degrees."""


def gallery_to_file(project: Project, solution: Solution, path: Path) -> None:
    """Draw the sheet of all action units and emotions into a PNG file.

    Raises
    ------
    ProjectError
        If the file cannot be written.
    """
    checked_target(path)
    write_png(gallery(project, solution), path)


def gallery(project: Project, solution: Solution) -> ByteArray:
    """The sheet, (h, w, 3) uint8."""
    with stage(PORTRAIT, samples=0) as made:
        made.scene.show(project, solution)
        neutral = Entry(_pair(made, project, {}), "", "Neutral", "at rest")
        emotions = [_emotion(made, project, emotion) for emotion in project.emotions]
        units = [
            _unit(made, project, solution, unit)
            for group in GROUP_TITLES
            for unit in project.units
            if unit.group == group
        ]
    count = f"{len(units)} action units and {len(emotions)} emotions at full strength"
    sections = [Section("Neutral and emotions", [neutral, *emotions]), Section("Action units", units)]
    return sheet(project.face.title, count, sections, COLUMNS)


def _unit(made: Stage, project: Project, solution: Solution, unit: ActionUnit) -> Entry:
    peak = max((solution.basis.peak(name) for name in unit.fields if name in solution.basis.index), default=0.0)
    name = unit.name[:1].upper() + unit.name[1:]
    note = f"{GROUP_TITLES[unit.group]}, {peak:.1f} mm" if unit.moves_skin else motion_words(unit).capitalize()
    return Entry(_pair(made, project, unit.portrait), str(unit.number), name, note)


def _emotion(made: Stage, project: Project, emotion: Emotion) -> Entry:
    expression = expand(emotion.weights, project.units)
    recipe = " + ".join(
        name if weight == 1 else f"{name} ({weight:g})" for name, weight in emotion.weights.items() if weight
    )
    return Entry(_pair(made, project, expression), "", emotion.title, recipe)


def _pair(made: Stage, project: Project, expression: Expression) -> ByteArray:
    """The expression from the front and from three-quarter, side by side."""
    made.scene.pose(expression)
    camera = made.scene.renderer.GetActiveCamera()
    upright = np.array_equal(made.scene.mount.motion, np.eye(4))
    frame = face_frame(project.face) if upright else head_frame(project.face)
    pictures = []
    for azimuth, elevation in (FRONT, TURNED):
        look_along(camera, frame, azimuth, elevation, PORTRAIT[0] / PORTRAIT[1])
        pictures.append(made.picture())
    return np.concatenate(pictures, axis=1)
