"""The arrays of a face as members of an archive, and back with every shape, index and range checked."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from facemodel.face import Eye, Face, Jaw, Layers, Part, Placement, Pose, Skull
from facemodel.io.damage import DamageError
from facemodel.io.members import Members
from facemodel.io.records import point_json
from facemodel.io.schema import FaceRecord, PartRecord
from facemodel.mesh import Mesh
from facemodel.tissue import SLIDING
from fem.supports import Support
from fem.types import FloatArray

LARGEST_COORDINATE = 1e5
"""Millimetres; a hundred metres is no head."""

LARGEST_STIFFNESS = 1e9

SMALLEST_SLIDING = 1e-3
"""Tissue that is so much stiffer along the surface is no tissue."""

LATER: Mapping[str, tuple[float, float, float]] = {
    "thickness": (0.0, 0.0, LARGEST_COORDINATE),
    "sliding": (SLIDING, SMALLEST_SLIDING, LARGEST_STIFFNESS),
    "volume": (0.0, 0.0, LARGEST_STIFFNESS),
}
"""Layers with what they are where nobody painted them, and their range.  They are only in files of a face on which
somebody did; files from before they could be painted have none."""

FEET = "face/skull/feet"
"""Only in files of a face whose skull was moved; files from before it could be moved have none."""

SHARES_SUM_TO_ONE = 1e-3
"""Rows of shares are normalised; stored in single precision they may miss one by this much."""


def face_arrays(face: Face) -> dict[str, NDArray[Any]]:
    """All arrays of a face by member name; indices as 32-bit integers."""
    skin, skull, layers = face.skin, face.skull, face.layers
    arrays: dict[str, NDArray[Any]] = {
        **_mesh_arrays("face/skin", skin),
        "face/skin/solved": face.solved.astype(np.bool_),
        "face/skin/uv": face.uv,
        "face/skin/mirror": face.mirror.astype(np.int32),
        "face/skin/chart": face.chart,
        **_mesh_arrays("face/skull/cranium", skull.cranium),
        **_mesh_arrays("face/skull/mandible", skull.mandible),
        "face/skull/anchors": skull.anchors,
        "face/skull/jawbone": skull.jawbone,
        "face/layers/direction": layers.direction,
        "face/layers/stretching": layers.stretching,
        "face/layers/bending": layers.bending,
        "face/layers/stiffness": layers.stiffness,
        "face/layers/supports": layers.supports.astype(np.int8),
    }
    for name, (unpainted, *_) in LATER.items():
        if (getattr(layers, name) != unpainted).any():
            arrays[f"face/layers/{name}"] = getattr(layers, name)
    if len(skull.placement.feet):
        arrays[FEET] = skull.placement.feet
    for number, part in enumerate(face.parts):
        place = f"face/parts/{number}"
        arrays |= _mesh_arrays(place, part.mesh)
        arrays[f"{place}/anchors"] = part.anchors.astype(np.int32)
        arrays[f"{place}/shares"] = part.shares
    return arrays


def _mesh_arrays(place: str, mesh: Mesh) -> dict[str, NDArray[Any]]:
    return {f"{place}/positions": mesh.positions, f"{place}/triangles": mesh.triangles.astype(np.int32)}


def face_json(face: Face) -> dict[str, Any]:
    """The readable part of a face: what `FaceRecord` reads."""
    jaw, placement = face.skull.jaw, face.skull.placement
    moved = {"placement": _placement_json(placement)} if len(placement.feet) else {}
    return {
        "key": face.key,
        "title": face.title,
        "provenance": face.provenance,
        "landmarks": {name: int(vertex) for name, vertex in face.landmarks.items()},
        "eyes": [
            {"side": eye.side, "centre": point_json(eye.centre), "radius": float(eye.radius)} for eye in face.eyes
        ],
        "jaw": {"axis": [point_json(condyle) for condyle in jaw.axis], "teeth": point_json(jaw.teeth)},
        "parts": [{"name": part.name, "kind": part.kind, "carrier": part.carrier} for part in face.parts],
        **moved,
    }


def _placement_json(placement: Placement) -> dict[str, Any]:
    pose = placement.pose
    members = {"shift": pose.shift, "turn": pose.turn, "scale": pose.scale, "centre": placement.centre}
    return {name: point_json(np.array(values)) for name, values in members.items()}


def face_of(record: FaceRecord, arrays: Mapping[str, NDArray[Any]], member: str) -> Face:
    """A face from its readable part and its arrays.

    Parameters
    ----------
    record : the readable part
    arrays : the arrays by member name
    member : the name of the document, for errors

    Raises
    ------
    DamageError
        If an array is missing, left over, of another shape than the others, or out of range.
    """
    members = Members(arrays)
    skin = _mesh(members, "face/skin")
    count = len(skin.positions)
    face = Face(
        key=record.key,
        title=record.title,
        skin=skin,
        solved=members.flags("face/skin/solved", len(skin.triangles)),
        uv=members.floats("face/skin/uv", (count, 2), -LARGEST_COORDINATE, LARGEST_COORDINATE),
        mirror=members.indices("face/skin/mirror", (count,), count),
        chart=members.floats("face/skin/chart", (count, 2), -LARGEST_COORDINATE, LARGEST_COORDINATE),
        landmarks=_landmarks(record, count, member),
        eyes=_eyes(record, member),
        parts=_parts(record, members, count, member),
        skull=_skull(record, members, count, member),
        layers=_layers(members, count),
        provenance=record.provenance,
    )
    members.finish()
    return face


def _mesh(members: Members, place: str) -> Mesh:
    positions = members.floats(f"{place}/positions", (None, 3), -LARGEST_COORDINATE, LARGEST_COORDINATE)
    triangles = members.indices(f"{place}/triangles", (None, 3), len(positions))
    a, b, c = triangles.T
    twice = np.flatnonzero((a == b) | (b == c) | (c == a))
    if len(twice):
        raise DamageError(f"{place}/triangles.npy", f"names a corner twice in triangle {twice[0]}")
    return Mesh(positions, triangles)


def _landmarks(record: FaceRecord, count: int, member: str) -> dict[str, int]:
    for name, vertex in record.landmarks.items():
        if vertex >= count:
            raise DamageError(f"{member}, face.landmarks.{name}", f"is {vertex} but the skin has {count} vertices")
    return dict(record.landmarks)


def _eyes(record: FaceRecord, member: str) -> tuple[Eye, Eye]:
    left, right = (Eye(eye.side, np.array(eye.centre), eye.radius) for eye in record.eyes)
    if (left.side, right.side) != ("L", "R"):
        raise DamageError(f"{member}, face.eyes", "are not one left and one right eye in this order")
    return left, right


def _parts(record: FaceRecord, members: Members, count: int, member: str) -> tuple[Part, ...]:
    names = [part.name for part in record.parts]
    if len(set(names)) < len(names):
        raise DamageError(f"{member}, face.parts", "has two parts of the same name")
    return tuple(_part(part, members, f"face/parts/{k}", count) for k, part in enumerate(record.parts))


def _part(record: PartRecord, members: Members, place: str, count: int) -> Part:
    mesh = _mesh(members, place)
    anchors = members.indices(f"{place}/anchors", (None, None), count)
    shares = members.floats(f"{place}/shares", anchors.shape, -LARGEST_COORDINATE, LARGEST_COORDINATE)
    if record.carrier == "skin":
        if len(anchors) != len(mesh.positions):
            raise DamageError(f"{place}/anchors.npy", "does not have one row for each vertex of the part")
        if np.any(np.abs(shares.sum(axis=1) - 1) > SHARES_SUM_TO_ONE):
            raise DamageError(f"{place}/shares.npy", "has a row that does not sum to one")
    elif anchors.size:
        raise DamageError(f"{place}/anchors.npy", f"is not empty though the {record.carrier} carries it")
    return Part(record.name, record.kind, record.carrier, mesh, anchors, shares)


def _skull(record: FaceRecord, members: Members, count: int, member: str) -> Skull:
    axis = np.array(record.jaw.axis)
    if np.array_equal(axis[0], axis[1]):
        raise DamageError(f"{member}, face.jaw.axis", "has both condyles at the same point")
    return Skull(
        cranium=_mesh(members, "face/skull/cranium"),
        mandible=_mesh(members, "face/skull/mandible"),
        anchors=members.floats("face/skull/anchors", (count, 3), -LARGEST_COORDINATE, LARGEST_COORDINATE),
        jawbone=members.floats("face/skull/jawbone", (count,), 0, 1),
        jaw=Jaw(axis, np.array(record.jaw.teeth)),
        placement=_placement(record, members, count),
    )


def _placement(record: FaceRecord, members: Members, count: int) -> Placement:
    if record.placement is None:
        return Placement()
    pose = Pose(record.placement.shift, record.placement.turn, record.placement.scale)
    feet = members.floats(FEET, (count, 3), -LARGEST_COORDINATE, LARGEST_COORDINATE)
    return Placement(pose, np.array(record.placement.centre), feet)


def _layers(members: Members, count: int) -> Layers:
    most = LARGEST_STIFFNESS
    return Layers(
        direction=members.floats("face/layers/direction", (count, 3), -LARGEST_COORDINATE, LARGEST_COORDINATE),
        stretching=members.floats("face/layers/stretching", (count, 2), 0, most),
        bending=members.floats("face/layers/bending", (count, 3), 0, most),
        stiffness=members.floats("face/layers/stiffness", (count,), 0, most),
        supports=members.indices("face/layers/supports", (count,), len(Support)),
        **{name: _later(members, name, count) for name in LATER},
    )


def _later(members: Members, name: str, count: int) -> FloatArray:
    unpainted, low, high = LATER[name]
    member = f"face/layers/{name}"
    return members.floats(member, (count,), low, high) if member in members else np.full(count, unpainted)
