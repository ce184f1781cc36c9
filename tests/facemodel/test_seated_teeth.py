"""Teeth are where people have them: upper incisors show under parted lips, and lie over and before the lower ones."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from facemodel.face import Face, Part
from facemodel.faces import face_keys
from facemodel.jaw.opening import incisal_edge
from facemodel.making.bite import with_seated_teeth

EVERY_FACE = pytest.mark.parametrize("key", face_keys())
Shipped = Callable[[str], Face]

ROUNDED = 1e-4
"""Millimetres by which single precision and seating once more may differ."""


def part(face: Face, name: str) -> Part:
    return next(each for each in face.parts if each.name == name)


def edge(face: Face, row: str) -> np.ndarray:
    """Where the incisors of a row of teeth end."""
    teeth = part(face, f"teeth-{row}")
    return teeth.mesh.positions[incisal_edge(teeth)]


@EVERY_FACE
def test_one_to_three_millimetres_of_the_upper_incisors_end_below_the_line_between_the_lips(
    shipped: Shipped, key: str
) -> None:
    face = shipped(key)
    lips = [face.landmarks["upper_lip_mid"], face.landmarks["lower_lip_mid"]]
    assert 1.0 < face.skin.positions[lips, 1].mean() - edge(face, "upper")[1] < 3.0


@EVERY_FACE
def test_upper_incisors_hang_over_the_lower_ones_and_lie_before_them(shipped: Shipped, key: str) -> None:
    _, over, before = edge(shipped(key), "lower") - edge(shipped(key), "upper")
    assert 0.5 < over < 3.0
    assert 1.0 < -before < 3.0


@EVERY_FACE
def test_the_tongue_lies_behind_both_rows_of_teeth(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    tip = part(face, "tongue").mesh.positions[:, 2].max()
    assert tip < min(edge(face, "upper")[2], edge(face, "lower")[2]) - 5.0


@EVERY_FACE
def test_teeth_that_are_seated_stay_where_they_are(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    for seated, own in zip(with_seated_teeth(face).parts, face.parts, strict=True):
        assert seated.mesh.positions == pytest.approx(own.mesh.positions, abs=ROUNDED)


def test_teeth_that_are_too_high_or_too_low_come_to_their_place(face: Face) -> None:
    aside = {"teeth-upper": 3.0, "teeth-lower": -2.0}
    up = np.array([0.0, 1.0, 0.0])
    parts = [replace(p, mesh=p.mesh.moved(p.mesh.positions + aside.get(p.name, 0) * up)) for p in face.parts]
    seated = with_seated_teeth(replace(face, parts=tuple(parts)))
    for row in ("upper", "lower"):
        assert edge(seated, row) == pytest.approx(edge(face, row), abs=ROUNDED)
