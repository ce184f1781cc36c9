"""Reading fields out of a basis."""

import numpy as np
import pytest

from facemodel.basis import Basis
from facemodel.face import Face


def test_fields_lie_row_by_row_in_single_precision(basis: Basis) -> None:
    count = len(basis.names)
    carried = sum(points for _, points in basis.display.carried)
    assert basis.fields.shape == (count, 3 * (carried + basis.display.moving))
    assert basis.slopes.shape == (count, 6 * basis.display.moving)
    assert basis.jaw.shape == (count, 3)
    for array in (basis.fields, basis.slopes):
        assert array.dtype == np.float32
        assert array.flags.c_contiguous


def test_a_field_on_the_whole_skin_is_still_where_it_is_held(basis: Basis) -> None:
    for name in basis.names:
        whole = basis.field(name)
        assert whole.shape == basis.display.points.shape
        assert np.array_equal(whole[: basis.display.moving], basis.moving_field(name))
        assert not whole[basis.display.moving :].any()
        assert basis.peak(name) == pytest.approx(np.linalg.norm(whole, axis=1).max())


def test_parts_take_their_own_share_of_a_field(face: Face, basis: Basis) -> None:
    row = basis.index["12L"]
    pieces = [basis.carried_field("12L", part) for part, _ in basis.display.carried]
    joined = np.concatenate([*pieces, basis.moving_field("12L")])
    assert np.array_equal(joined.ravel(), basis.fields[row])
    for part, count in basis.display.carried:
        assert count == len(next(p for p in face.parts if p.name == part).mesh.positions)


def test_a_part_that_the_skin_does_not_carry_has_no_field(basis: Basis) -> None:
    with pytest.raises(KeyError):
        basis.carried_field("12L", "teeth-lower")


def test_only_the_jaw_turns_the_jaw(basis: Basis) -> None:
    turning = {name for name, motion in zip(basis.names, basis.jaw, strict=True) if motion.any()}
    assert turning == {"19", "26", "27", "29", "30L", "30R"}
    opening = basis.jaw[[basis.index["26"], basis.index["27"]]]
    assert np.all(opening[:, :2] > 0)
    assert not opening[:, 2].any()
