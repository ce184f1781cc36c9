"""How alike two fields are, against cases one can work out by hand."""

import numpy as np
import pytest

from facemodel.calibration.figures import compare_fields

AREAS = np.array([1.0, 1.0, 2.0])
FIELD = np.array([[3.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 1.0]])


def test_a_field_is_like_itself_at_any_size() -> None:
    figures = compare_fields(FIELD, 0.5 * FIELD, AREAS)
    assert figures.cosine == pytest.approx(1.0)
    assert figures.factor == pytest.approx(2.0)
    assert figures.explained == pytest.approx(1.0)
    assert figures.rms == pytest.approx(0.0, abs=1e-9)
    assert figures.direction == pytest.approx(0.0, abs=1e-5)
    assert (figures.measured, figures.solved) == (4.0, 2.0)


def test_the_opposite_is_scaled_to_nothing() -> None:
    figures = compare_fields(FIELD, -FIELD, AREAS)
    assert figures.cosine == pytest.approx(-1.0)
    assert figures.factor == 0.0
    assert figures.explained == pytest.approx(0.0)
    assert figures.largest == pytest.approx(4.0)
    assert figures.direction == pytest.approx(180.0)


def test_larger_triangles_count_more() -> None:
    only_last = np.zeros_like(FIELD)
    only_last[2] = FIELD[2]
    figures = compare_fields(FIELD, only_last, AREAS)
    assert figures.cosine == pytest.approx(2.0 / np.sqrt((9 + 16 + 2) * 2.0))
    assert figures.explained == pytest.approx(2.0 / 27.0)
    assert figures.rms == pytest.approx(np.sqrt(25.0 / 4.0))


def test_the_direction_is_that_of_the_skin_that_moves_most() -> None:
    turned = FIELD.copy()
    turned[0] = [3.0, 3.0, 0.0]
    turned[2] = [1.0, 0.0, 0.0]
    assert compare_fields(FIELD, turned, AREAS).direction == pytest.approx(22.5), "the third moves too little to count"


def test_nothing_is_like_nothing() -> None:
    nothing = np.zeros_like(FIELD)
    for one, other in ((FIELD, nothing), (nothing, FIELD), (nothing, nothing)):
        figures = compare_fields(one, other, AREAS)
        assert (figures.cosine, figures.factor, figures.explained) == (0.0, 0.0, 0.0)
