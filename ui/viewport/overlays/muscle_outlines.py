"""The lines that show what a muscle is under its model: fibres, sheet, ring, box, lever of the jaw."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from facemodel.face import Face
from facemodel.laying.drape import draped, of_sector, ring_line, ring_turns
from facemodel.laying.handles import MEASURES, Handle
from facemodel.laying.measures import foot, places, profiles_end
from facemodel.muscles import Muscle
from facemodel.muscles.cosine import cosine_of, radius
from facemodel.muscles.curve import path
from facemodel.muscles.models import MODELS
from facemodel.muscles.quadrilateral import nearest_on_line
from fem.types import FloatArray
from ui.viewport.overlays.marks import chain
from ui.viewport.overlays.on_skin import OnSkin

STEPS = 16

UNIT_BOX = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=np.float64)
BOX_EDGES = [(a, b) for a in range(8) for b in range(a) if np.abs(UNIT_BOX[a] - UNIT_BOX[b]).sum() == 2]


@dataclass
class Outlines:
    """Segments by their ends (2 n, 3).

    Attributes
    ----------
    body : central fibres, ring, or the lever of the jaw
    edges : of a sheet, a box, or the axis of the jaw
    """

    body: list[FloatArray] = field(default_factory=list)
    edges: list[FloatArray] = field(default_factory=list)


def outlines(muscle: Muscle, face: Face, at: OnSkin) -> Outlines:
    """The lines of a muscle on a posed face."""
    lines = Outlines()
    geometry = MODELS[muscle.model].geometry
    if geometry == "fibres":
        _fibres(muscle, at, lines)
    elif geometry == "skull":
        _lever(muscle, face, lines)
    elif muscle.ring is not None:
        _ring(muscle, face, at, lines)
    if MODELS[muscle.model].action == "displacement" and (muscle.fibres or muscle.ring is not None):
        _boxes(muscle, at, lines)
    return lines


def spoke(muscle: Muscle, handle: Handle, face: Face, at: OnSkin) -> FloatArray:
    """From where a handle measures to the handle, (2, 3); nothing for a handle that is a point of the muscle."""
    if handle.part not in MEASURES and handle.part not in ("long", "short"):
        return np.zeros((0, 3))
    start = foot(muscle, handle.part, handle.fibre, face)  # type: ignore[arg-type]
    return np.array([start if handle.part == "force" else at.carried(start), place_of(muscle, handle, at)])


ON_SKIN = ("attachment", "centre", "long", "short", "radius", "reach")
"""Parts of which a handle goes with the skin, whatever the muscle."""


def on_skin(muscle: Muscle, handle: Handle) -> bool:
    """Whether a handle goes with the skin."""
    return handle.part in ON_SKIN or MODELS[muscle.model].along_skin


def place_of(muscle: Muscle, handle: Handle, at: OnSkin) -> FloatArray:
    """Where (3,) a handle is seen."""
    return at.carried(handle.point) if on_skin(muscle, handle) else handle.point


def reach(muscle: Muscle, points: FloatArray) -> tuple[FloatArray, float] | None:
    """A distance (n,) of points from a muscle, and the one at which its influence ends; none where it only fades."""
    if muscle.model == "quadrilateral":
        insertion = np.array([fibre.attachment for fibre in muscle.fibres])
        return np.linalg.norm(points - nearest_on_line(points, insertion), axis=1), muscle.width
    if muscle.model == "cosine":
        away = [np.linalg.norm(points - fibre.attachment, axis=1) for fibre in muscle.fibres]
        return np.min(away, axis=0), muscle.width
    if muscle.model == "cosine_ring" and muscle.ring is not None:
        return np.linalg.norm(points - muscle.ring.centre, axis=1), radius(muscle)
    return None


def _fibres(muscle: Muscle, at: OnSkin, lines: Outlines) -> None:
    """Central fibres, which end where the skin has gone; of a sheet its edges on bone and skin; a fold goes with it."""
    if MODELS[muscle.model].along_skin:
        lines.body += [chain(at.carried(path(fibre, STEPS))) for fibre in muscle.fibres]
        return
    share = np.linspace(0.0, 1.0, STEPS + 1)[:, None] ** 2
    runs = [path(fibre, STEPS) + share * at.shift(fibre.attachment) for fibre in muscle.fibres]
    lines.body += [chain(run) for run in runs]
    if muscle.model == "quadrilateral" and len(runs) > 1:
        ends = np.array([[run[0], run[-1]] for run in runs])
        lines.body += [chain(ends[:, 1])]
        lines.edges += [chain(ends[:, 0])]


def _ring(muscle: Muscle, face: Face, at: OnSkin, lines: Outlines) -> None:
    """The ring on the skin, dashed where there is none, and where the profiles of a mouth have come to zero."""
    ring = muscle.ring
    assert ring is not None
    line = ring_line(ring, face.skin)
    own = of_sector(ring, ring_turns() + np.pi / len(line))
    segments = chain(at.carried(line), closed=True).reshape(-1, 2, 3)
    lines.body.append(segments[own].reshape(-1, 3))
    lines.edges.append(_dashed(segments[~own].reshape(-1, 3)))
    if muscle.model == "mouth":
        end = np.full((len(line), 2), profiles_end(muscle))
        around = draped(ring, ring_turns(), end, face.skin)
        lines.edges.append(_dashed(chain(at.carried(around), closed=True)))


def _dashed(segments: FloatArray) -> FloatArray:
    return np.asarray(segments.reshape(-1, 2, 3)[::2].reshape(-1, 3))


def _boxes(muscle: Muscle, at: OnSkin, lines: Outlines) -> None:
    """The bounding boxes about the points of application."""
    middles = [fibre.attachment for fibre in muscle.fibres]
    if MODELS[muscle.model].geometry == "ring" and muscle.ring is not None:
        middles = [muscle.ring.centre]
    half = cosine_of(muscle).box
    for middle in middles:
        corners = at.carried(middle) + UNIT_BOX * half
        lines.edges += [corners[[a, b]] for a, b in BOX_EDGES]


def _lever(muscle: Muscle, face: Face, lines: Outlines) -> None:
    """The axis of the jaw, the lever from it to the lower incisors, and the force there."""
    right, left = face.skull.jaw.axis
    teeth = face.skull.jaw.teeth
    lines.edges += [np.array([right, left]), np.array([right, teeth]), np.array([left, teeth])]
    lines.body += [np.array([teeth, point]) for point, *_ in places(muscle, "force", face)]
