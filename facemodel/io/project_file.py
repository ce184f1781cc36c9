"""The project file ``.risorius``: what a person might read as JSON, the arrays of the face beside it."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np

from facemodel.actions import field_names, resolve
from facemodel.errors import UnknownNameError
from facemodel.io.animation import animation_arrays, animation_json, animation_of, without_animation
from facemodel.io.archive import LARGEST_ARCHIVE, Archive, pack, unpack
from facemodel.io.corrections import correction_arrays, corrections_json, corrections_of, without_corrections
from facemodel.io.damage import TAKE_BACK, DamageError, naming
from facemodel.io.disk import read_file, replacing
from facemodel.io.face_arrays import face_arrays, face_json, face_of
from facemodel.io.records import (
    emotion_json,
    emotion_of,
    muscle_json,
    muscle_of,
    settings_json,
    settings_of,
    unit_json,
    unit_of,
    weights_json,
)
from facemodel.io.schema import PROJECT_FORMAT, SCHEMA, MuscleRecord, ProjectDocument, parse
from facemodel.muscles.models import MODELS
from facemodel.project import Project

PROJECT_MEMBER = "project.json"
SMALLEST_RING = 1e-3
"""Square millimetres spanned by the half axes; on less the models would divide by nothing."""


def save_project(project: Project, path: Path) -> None:
    """Write a project; its bytes depend on the project alone, and opening them gives it back bit by bit.

    Raises
    ------
    ProjectError
        If the project could not be opened again, or the file cannot be written; a previous file stays.
    """
    with naming(path, "saved", TAKE_BACK):
        data = project_bytes(project)
        project_of(data)
    with replacing(path) as stream:
        stream.write(data)


def load_project(path: Path) -> Project:
    """Read a project of this or an older version.

    Raises
    ------
    ProjectError
        If there is no such file, it is damaged or newer; the place and the remedy are named.
    """
    data = read_file(path, LARGEST_ARCHIVE)
    with naming(path, "opened"):
        return project_of(data)


def project_bytes(project: Project) -> bytes:
    """The bytes of a project file; `project_of` tells whether they can be opened again.

    Raises
    ------
    DamageError
        If something in the project cannot be written at all.
    """
    document = {
        "format": PROJECT_FORMAT,
        "schema": SCHEMA,
        "face": face_json(project.face),
        "muscles": [muscle_json(muscle) for muscle in project.muscles],
        "units": [unit_json(unit) for unit in project.units],
        "emotions": [emotion_json(emotion) for emotion in project.emotions],
        "expression": weights_json(project.expression),
        "settings": settings_json(project.settings),
    }
    if project.corrections:
        document["corrections"] = corrections_json(project.corrections)
    animation = animation_json(project.animation)
    if animation is not None:
        document["animation"] = animation
    arrays = {
        **face_arrays(project.face),
        **correction_arrays(project.corrections),
        **animation_arrays(project.animation),
    }
    return pack(Archive(document, arrays), PROJECT_MEMBER)


def project_of(data: bytes) -> Project:
    """The project in the bytes of a project file.

    Raises
    ------
    DamageError
        If they are not those of a project, or of a newer version.
    """
    archive = unpack(data, PROJECT_MEMBER)
    document = parse(archive.document, ProjectDocument, PROJECT_FORMAT, PROJECT_MEMBER)
    _check_references(document)
    face = face_of(document.face, without_animation(without_corrections(archive.arrays)), PROJECT_MEMBER)
    return Project(
        face=face,
        muscles=tuple(muscle_of(record) for record in document.muscles),
        units=tuple(unit_of(record) for record in document.units),
        emotions=tuple(emotion_of(record) for record in document.emotions),
        expression=dict(document.expression),
        settings=settings_of(document.settings),
        corrections=corrections_of(document.corrections, archive.arrays, len(face.skin.positions)),
        animation=animation_of(document.animation, archive.arrays),
    )


def _check_references(document: ProjectDocument) -> None:
    """Every name that one part of the document uses is there in another, once."""
    _check_unique([f"{m.name} {m.side}" for m in document.muscles], "muscles")
    _check_unique([str(unit.number) for unit in document.units], "units")
    _check_unique([emotion.name.lower() for emotion in document.emotions], "emotions")
    for k, muscle in enumerate(document.muscles):
        _check_muscle(muscle, f"{PROJECT_MEMBER}, muscles[{k}]")
    known = {muscle.name for muscle in document.muscles}
    for k, unit in enumerate(document.units):
        for name in sorted(unit.muscles.keys() - known):
            raise DamageError(
                f"{PROJECT_MEMBER}, units[{k}].muscles", f"names “{name}”, which is no muscle of the project"
            )
    units = [unit_of(record) for record in document.units]
    for k, emotion in enumerate(document.emotions):
        for name in emotion.weights:
            try:
                resolve(name, units)
            except UnknownNameError as error:
                raise DamageError(
                    f"{PROJECT_MEMBER}, emotions[{k}].weights",
                    f"names “{name}”, which is no action unit of the project",
                ) from error
    for name in sorted(document.expression.keys() - set(field_names(units))):
        raise DamageError(f"{PROJECT_MEMBER}, expression", f"names “{name}”, which is no field of the project")
    for name in sorted({each.field for each in document.corrections} - set(field_names(units))):
        raise DamageError(f"{PROJECT_MEMBER}, corrections", f"names “{name}”, which is no field of the project")


def _check_muscle(muscle: MuscleRecord, place: str) -> None:
    """A muscle has what its model works on."""
    works_on = MODELS[muscle.model].geometry
    if works_on == "fibres" and not muscle.fibres:
        raise DamageError(f"{place}.fibres", "is empty")
    if works_on == "ring" and muscle.ring is None:
        raise DamageError(f"{place}.ring", "is missing")
    if muscle.ring is not None:
        spanned = np.cross(muscle.ring.long_axis, muscle.ring.short_axis)
        if np.linalg.norm(spanned) < SMALLEST_RING:
            raise DamageError(f"{place}.ring", "has half axes that span no ellipse")


def _check_unique(names: list[str], place: str) -> None:
    for name, times in Counter(names).items():
        if times > 1:
            raise DamageError(f"{PROJECT_MEMBER}, {place}", f"has “{name}” {times} times")
