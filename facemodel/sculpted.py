"""The hand-made basis: 52 face units that an artist sculpted on the default head."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from zipfile import BadZipFile

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.basis import Basis
from facemodel.displaced import MEMBRANE
from facemodel.display import DisplaySurface
from facemodel.errors import FaceError, ProjectError
from facemodel.face import Face, Jaw
from facemodel.project import Project
from facemodel.sampling import ELEMENTS, HeadSurface, carried_points, head_surface
from facemodel.solve import Solution
from fem import interpolate_smoothly, sample_operators
from fem.types import Float32Array, FloatArray
from resources import resource


@dataclass(frozen=True, eq=False)
class SculptedUnits:
    """Sculpted displacements of the skin's vertices.

    Attributes
    ----------
    names : M names of the ARKit set, for example ``mouthSmileLeft``
    fields : (M, N, 3) float32, millimetres
    provenance : whose work it is
    """

    names: tuple[str, ...]
    fields: Float32Array
    provenance: str


AU_FROM_SCULPTED: Mapping[str, Mapping[str, float]] = {
    "2": {"browOuterUp": 1.0},
    "4": {"browDown": 1.0},
    "5": {"eyeWide": 1.0},
    "6": {"cheekSquint": 1.0},
    "7": {"eyeSquint": 1.0},
    "9": {"noseSneer": 1.0},
    "10": {"mouthUpperUp": 1.0},
    "11": {"mouthUpperUp": 0.5, "noseSneer": 0.2},
    "12": {"mouthSmile": 1.0},
    "14": {"mouthDimple": 1.0},
    "15": {"mouthFrown": 1.0},
    "16": {"mouthLowerDown": 1.0},
    "17": {"mouthShrugLower": 1.0},
    "20": {"mouthStretch": 1.0},
    "22": {"mouthFunnel": 1.0},
    "23": {"mouthRollLower": 0.5, "mouthRollUpper": 0.5},
    "24": {"mouthPressLeft": 1.0, "mouthPressRight": 1.0},
    "25": {"mouthLowerDownLeft": 0.6, "mouthLowerDownRight": 0.6},
    "26": {"jawOpen": 0.5},
    "27": {"jawOpen": 1.0},
    "28": {"mouthRollLower": 1.0, "mouthRollUpper": 1.0},
    "29": {"jawForward": 1.0},
    "30": {"jaw": 1.0},
    "41": {"eyeBlink": 0.35},
    "42": {"eyeBlink": 0.7, "eyeSquint": 0.3},
    "43": {"eyeBlink": 1.0},
    "44": {"eyeSquint": 1.0},
    "45": {"eyeBlink": 1.0},
    "46": {"eyeBlink": 1.0, "cheekSquint": 0.5},
}
"""Which sculpted units answer an action unit; paired ones without ``Left`` and ``Right``."""

SPLIT: Mapping[str, str] = {"1": "browInnerUp", "18": "mouthPucker", "34": "cheekPuff"}
"""Action units with sides whose sculpted unit has none; it is split smoothly at the midline."""

LEAST_OPENING = 3.0
"""Degrees; a chin that sinks less than this means a moved lip, not a turned jaw."""

SPLIT_WIDTH = 12.0
"""Millimetres to both sides of the midline over which such a unit fades."""


def write_sculpted(units: SculptedUnits, path: Path) -> None:
    """Write sculpted units as a compressed archive of arrays."""
    np.savez_compressed(path, names=np.array(units.names), fields=units.fields, provenance=np.array(units.provenance))


def read_sculpted(face: Face) -> SculptedUnits:
    """The sculpted units that ship for a face.

    Raises
    ------
    FaceError
        If none ship for it.
    ProjectError
        If the file is damaged.
    """
    path = resource("sculpted", f"{face.key}.npz")
    if not path.exists():
        raise FaceError(f"No sculpted units ship for {face.title}; take the default face for them.")
    try:
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as arrays:
            fields = arrays["fields"]
            names = tuple(str(name) for name in arrays["names"])
            provenance = str(arrays["provenance"])
    except (OSError, ValueError, KeyError, BadZipFile) as error:
        raise ProjectError(f"The sculpted units {path} are damaged; reinstall Risorius.") from error
    if fields.shape != (len(names), len(face.skin.positions), 3):
        raise FaceError(f"The sculpted units of {face.title} belong to another mesh; take the shipped face for them.")
    return SculptedUnits(names, fields, provenance)


def sculpted_basis(
    face: Face, head: HeadSurface, display: DisplaySurface, names: Sequence[str], fields: FloatArray
) -> Basis:
    """A basis of vertex displacements (M, N, 3), made smooth by the element and sampled where the skin is drawn.

    The opening of the jaw that each field means is read off the displacement of the chin.
    """
    flat = np.asarray(fields, dtype=np.float64).transpose(1, 2, 0).reshape(len(face.skin.positions), -1)
    held = np.setdiff1d(np.arange(len(flat)), face.skin.triangles[face.solved])
    flat[held] = 0.0
    coefficients = interpolate_smoothly(head.assembler, flat, MEMBRANE)
    moving = slice(0, display.moving)
    sample = sample_operators(head.assembler, display.elements[moving], display.barycentric[moving])
    count = len(names)
    moved = np.concatenate([carried_points(face, flat), sample.value @ coefficients])
    slopes = np.concatenate([sample.d_u @ coefficients, sample.d_v @ coefficients]).reshape(2, display.moving, 3, count)
    return Basis(
        tuple(names),
        display,
        np.ascontiguousarray(moved.reshape(-1, 3, count).transpose(2, 0, 1), dtype=np.float32).reshape(count, -1),
        np.ascontiguousarray(slopes.transpose(3, 0, 2, 1), dtype=np.float32).reshape(count, -1),
        _jaw_of(face, fields),
        origin="sculpted",
    )


def _jaw_of(face: Face, fields: FloatArray) -> FloatArray:
    """Jaw motions (M, 3) that would lower the chin as far as each field does: the opening alone."""
    jaw: Jaw = face.skull.jaw
    chin = face.landmarks["pogonion"]
    arm = face.skin.positions[chin] - jaw.axis.mean(axis=0)
    lowered = -np.asarray(fields, dtype=np.float64)[:, chin, 1]
    degrees = np.degrees(lowered / np.hypot(arm[1], arm[2]))
    degrees[degrees < LEAST_OPENING] = 0.0
    return np.pad(degrees[:, None], ((0, 0), (0, 2)))


def sculpted_solution(project: Project, solution: Solution) -> Solution:
    """A solved project with the hand-made basis in place of the solved one, driven by the same sliders.

    Raises
    ------
    FaceError, ProjectError
        If no sculpted units ship for this face, or they are damaged.
    """
    face = project.face
    names, fields = sculpted_for_units(face, read_sculpted(face), project.units)
    head = head_surface(face, ELEMENTS[project.settings.element])
    return replace(solution, basis=sculpted_basis(face, head, solution.basis.display, names, fields))


def sculpted_for_units(
    face: Face, sculpted: SculptedUnits, units: Sequence[ActionUnit]
) -> tuple[list[str], FloatArray]:
    """Sculpted displacements by field name of the action units, so that the same sliders drive them.

    Returns
    -------
    names : of the fields that the artist's units can answer
    fields : (M, N, 3) millimetres
    """
    row = {name: k for k, name in enumerate(sculpted.names)}
    left = np.clip(face.skin.positions[:, 0] / SPLIT_WIDTH, -1, 1)
    share = {"L": (1 + np.sin(np.pi / 2 * left)) / 2, "R": (1 - np.sin(np.pi / 2 * left)) / 2}
    names: list[str] = []
    fields: list[FloatArray] = []
    for unit in units:
        key = str(unit.number)
        for name in unit.fields:
            if key in SPLIT and unit.paired:
                field = sculpted.fields[row[SPLIT[key]]] * share[name[-1]][:, None]
            elif key in AU_FROM_SCULPTED:
                field = _mix(sculpted, row, AU_FROM_SCULPTED[key], name)
            else:
                continue
            names.append(name)
            fields.append(np.asarray(field, dtype=np.float64))
    return names, np.array(fields)


def _mix(sculpted: SculptedUnits, row: Mapping[str, int], parts: Mapping[str, float], name: str) -> FloatArray:
    side = {"L": "Left", "R": "Right"}.get(name[-1], "")
    total = np.zeros(sculpted.fields.shape[1:])
    for part, weight in parts.items():
        total += weight * sculpted.fields[row[part if part in row else part + side]]
    return total
