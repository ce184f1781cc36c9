"""A measured surface as a face that can be solved: everything it lacks is carried over from one of our heads."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from facemodel.calibration.forward import borrowed, borrowed_supports
from facemodel.calibration.lending import Lent, largest_piece
from facemodel.calibration.measured import MeasuredFace
from facemodel.calibration.points68 import check_unit, places68
from facemodel.calibration.registration import registered, rigid_pose
from facemodel.chart import make_chart
from facemodel.errors import FaceError
from facemodel.face import Eye, Face, Jaw, Skull
from facemodel.laying.warp import Warp
from facemodel.mesh import Mesh
from fem.types import BoolArray, FloatArray, IntArray

MARGINS: Mapping[str, tuple[tuple[str, ...], float]] = {
    "eye_L": (("eye_inner_L", "eye_outer_L", "upper_lid_mid_L", "lower_lid_mid_L"), 6.0),
    "eye_R": (("eye_inner_R", "eye_outer_R", "upper_lid_mid_R", "lower_lid_mid_R"), 6.0),
    "mouth": (("upper_lip_mid", "lower_lip_mid"), 15.0),
}
"""Landmarks about a boundary loop, and how far it may lie from them in millimetres: lips may go on into the mouth."""

HALF = 0.5
"""Share of solved skin from which on a place counts as solved."""

BEYOND = 15.0
"""Millimetres from the skin of the head beyond which measured skin is not solved: nothing is known of its bone."""

LID_GAP, CARUNCLE = 0.3, 4.0
"""Millimetres between eyeball and lids, and about the inner corner where they do not touch it."""


@dataclass(frozen=True, eq=False)
class PosedFace:
    """A face with the fields that were measured on it, in the axes of our heads.

    Attributes
    ----------
    face : solvable, its skin the measured one
    names : K names of expressions
    fields : (K, N, 3) displacement of the skin, millimetres
    loops : vertices of the boundary loops by name; holes that are no eye, mouth or rim are numbered
    lent : how its skin borrows from the head that was laid on it
    """

    face: Face
    names: tuple[str, ...]
    fields: FloatArray
    loops: dict[str, IntArray]
    lent: Lent


def posed_face(measured: MeasuredFace, head: Face) -> PosedFace:
    """Make a solvable face of a measured one.

    Parameters
    ----------
    measured : of any topology, in millimetres, turned in any way
    head : one of ours, which lends landmarks, bone, tissue and supports

    Raises
    ------
    FaceError
        If the surface is closed or has no chart, or is not in millimetres.
    """
    places = places68(measured.mesh, measured.landmarks)
    check_unit(places)
    own = np.array([head.skin.positions[head.landmarks[name]] for name in places])
    turn, shift = rigid_pose(np.array(list(places.values())), own)
    skin = Mesh(measured.mesh.positions @ turn + shift, measured.mesh.triangles)
    if not skin.boundary_loops:
        raise FaceError("The measured skin is closed; cut it open at the neck, and at mouth and eyes if they move.")
    warp = registered(head, skin, places68(skin, measured.landmarks))
    loops = named_loops(skin, places68(skin, measured.landmarks))
    laid = head.skin.moved(warp(head.skin.positions))
    lent = Lent.between(laid, skin)
    return PosedFace(_face(skin, head, warp, laid, lent, loops), measured.names, measured.deltas @ turn, loops, lent)


def named_loops(skin: Mesh, places: dict[str, FloatArray]) -> dict[str, IntArray]:
    """The boundary loops of a skin, the longest as ``rim``, those at eyes and mouth by name, the rest numbered."""
    *inner, rim = skin.boundary_loops
    named: dict[str, IntArray] = {}
    for name, (marks, reach) in MARGINS.items():
        away = [max(_gap(skin.positions[loop], places[mark]) for mark in marks) for loop in inner]
        if away and min(away) < reach:
            named[name] = inner[int(np.argmin(away))]
    taken = {id(loop) for loop in named.values()}
    holes = [loop for loop in inner if id(loop) not in taken]
    return {**named, "rim": rim, **{f"hole_{k + 1}": loop for k, loop in enumerate(holes)}}


def _gap(points: FloatArray, place: FloatArray) -> float:
    return float(np.linalg.norm(points - place, axis=1).min())


def _face(skin: Mesh, head: Face, warp: Warp, laid: Mesh, lent: Lent, loops: dict[str, IntArray]) -> Face:
    solved = _solved(skin, lent, head, loops["rim"])
    _, marks = skin.tree.query(laid.positions[list(head.landmarks.values())])
    left, right = (_eye(eye, warp, skin, loops) for eye in head.eyes)
    return Face(
        key="measured",
        title="Measured face",
        skin=skin,
        solved=solved,
        uv=np.zeros((len(skin.positions), 2)),
        mirror=skin.tree.query(skin.positions * [-1.0, 1.0, 1.0])[1].astype(np.int64),
        chart=make_chart(skin),
        landmarks=dict(zip(head.landmarks, marks.tolist(), strict=True)),
        eyes=(left, right),
        parts=(),
        skull=_skull(head.skull, warp, laid, lent, skin),
        layers=borrowed(head.layers, lent, borrowed_supports(head.layers, lent, np.unique(skin.triangles[~solved]))),
        provenance=f"Measured; bone and tissue carried over from {head.title}.",
    )


def _solved(skin: Mesh, lent: Lent, head: Face, rim: IntArray) -> BoolArray:
    """Triangles (T,) that move: those under the solved skin of the head, in one piece, off the rim."""
    moving = np.isin(np.arange(len(head.skin.positions)), head.skin.triangles[head.solved])
    inside = lent.values(moving.astype(np.float64)) > HALF
    inside &= lent.away < BEYOND
    inside[rim] = False
    return largest_piece(skin.triangles, np.asarray(inside[skin.triangles].all(axis=1)))


def _eye(eye: Eye, warp: Warp, skin: Mesh, loops: dict[str, IntArray]) -> Eye:
    """The eyeball carried over, pushed back until the lids rest on it."""
    centre, radius = warp(eye.centre)[0], eye.radius * warp.scale(eye.centre)
    loop = loops.get(f"eye_{eye.side}")
    if loop is None:
        return Eye(eye.side, centre, radius)
    margin = skin.positions[loop]
    inner = margin[np.abs(margin[:, 0]).argmin()]
    resting = margin[np.linalg.norm(margin - inner, axis=1) > CARUNCLE]
    fitted = least_squares(lambda c: np.linalg.norm(resting - c, axis=1) - radius - LID_GAP, centre)
    return Eye(eye.side, np.asarray(fitted.x), radius)


def _skull(skull: Skull, warp: Warp, laid: Mesh, lent: Lent, skin: Mesh) -> Skull:
    """Bone carried over by the map of space, the depth of the tissue under every vertex by the skin laid on it."""
    anchors = skin.positions + lent.values(warp(skull.anchors) - laid.positions)
    jaw = Jaw(warp(skull.jaw.axis), warp(skull.jaw.teeth)[0])
    cranium, mandible = (bone.moved(warp(bone.positions)) for bone in (skull.cranium, skull.mandible))
    jawbone = lent.values(skull.jawbone)
    return Skull(cranium, mandible, anchors, jawbone, jaw)
