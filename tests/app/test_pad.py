"""On the pad the nearer expression is the more of what is seen, and where it lies is part of the project."""

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.authoring import pad
from app.authoring.emotions import with_expression
from app.errors import UnitError
from facemodel.actions import Emotion, expand
from facemodel.io.project_file import project_bytes, project_of
from facemodel.project import Project
from tests.app.conftest import small_project

PLACE = st.tuples(st.floats(0, 1), st.floats(0, 1))


@pytest.fixture
def laid(project: Project) -> Project:
    return pad.with_place(pad.with_place(project, "happiness", (0.1, 0.9)), "surprise", (0.9, 0.9))


def test_on_an_expression_it_is_seen_alone_and_in_the_middle_the_face_is_at_rest(laid: Project) -> None:
    assert pad.blend_at(laid, (0.1, 0.9)) == expand({"12": 0.9}, laid.units)
    assert pad.blend_at(laid, pad.MIDDLE) == {}
    half = pad.blend_at(laid, (0.5, 0.9), rest=False)
    assert half == pytest.approx({"12L": 0.45, "12R": 0.45, "26": 0.4, "20L": 0.05})


def test_places_are_kept_in_the_file_and_through_a_change_of_the_weights(laid: Project) -> None:
    again = project_of(project_bytes(laid))
    assert [each.place for each in again.emotions] == [(0.1, 0.9), (0.9, 0.9)]
    changed = with_expression(laid, "happiness", {"17": 0.5})
    assert changed.emotions[0].place == (0.1, 0.9)
    bare = pad.emptied(laid)
    assert not pad.on_pad(bare)
    with pytest.raises(UnitError, match="No expression"):
        pad.blend_at(bare, (0.5, 0.5))
    for wrong in ((1.1, 0.5), (0.5, float("nan"))):
        with pytest.raises(UnitError, match="pad"):
            pad.with_place(laid, "happiness", wrong)


def test_variants_are_left_off_the_circle(project: Project) -> None:
    varied = replace(project, emotions=(*project.emotions, Emotion("happiness, shy", {"12": 0.4})))
    first, *others, variant = pad.arranged(varied).emotions
    assert first.place is not None
    assert all(each.place is not None for each in others)
    assert variant.place is None


def test_arranged_on_a_circle_all_are_as_far_from_the_middle_and_from_each_other(project: Project) -> None:
    seven = replace(project, emotions=tuple(replace(project.emotions[0], name=f"e{k}") for k in range(7)))
    places = [each.place for each in pad.arranged(seven).emotions]
    assert places[0] == (0.5, 0.5 + pad.ROUND)
    assert all(math.dist(place, pad.MIDDLE) == pytest.approx(pad.ROUND, abs=1e-3) for place in places if place)


def test_a_free_place_is_far_from_what_is_there(laid: Project) -> None:
    x, y = pad.free_place(laid)
    assert min(math.dist((x, y), each.place) for each in laid.emotions if each.place) > 0.45


@given(PLACE, PLACE, PLACE, st.booleans())
def test_a_blend_is_never_more_than_its_parts(one: tuple, other: tuple, pointer: tuple, rest: bool) -> None:
    project = pad.with_place(pad.with_place(small_project(), "happiness", one), "surprise", other)
    parts = [expand(each.weights, project.units) for each in project.emotions]
    for field, weight in pad.blend_at(project, pointer, rest).items():
        assert 0 < weight <= max(part.get(field, 0.0) for part in parts) + 1e-9
