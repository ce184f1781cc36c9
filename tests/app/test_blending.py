"""On a pad every expression is seen alone at its own place, and nothing is seen that nobody put there."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.authoring.blending import blended, shares

INSIDE = st.floats(0, 1, allow_subnormal=False)
PLACES = st.tuples(INSIDE, INSIDE)
PAD = {
    "happy": ((0.0, 0.0), {"12L": 1.0, "12R": 1.0}),
    "sad": ((1.0, 0.0), {"15": 0.8}),
    "wide": ((0.5, 1.0), {"12L": 0.5, "26": 1.0}),
}


@given(st.lists(PLACES, min_size=1, max_size=6), PLACES)
def test_shares_are_parts_of_a_whole(places: list[tuple[float, float]], pointer: tuple[float, float]) -> None:
    found = shares(places, pointer)
    assert sum(found) == pytest.approx(1.0)
    assert all(0 <= share <= 1 for share in found)


@pytest.mark.parametrize("name", PAD)
def test_an_expression_is_seen_alone_at_its_place(name: str) -> None:
    place, expression = PAD[name]
    assert blended(PAD, place) == expression


def test_half_way_between_two_both_are_seen_alike() -> None:
    pair = {name: PAD[name] for name in ("happy", "sad")}
    assert blended(pair, (0.5, 0.3)) == pytest.approx({"12L": 0.5, "12R": 0.5, "15": 0.4})


@given(PLACES)
def test_no_field_is_seen_more_than_where_it_is_seen_most(pointer: tuple[float, float]) -> None:
    found = blended(PAD, pointer)
    assert all(0 < weight <= 1 for weight in found.values())
    assert found.keys() <= {"12L", "12R", "15", "26"}


def test_an_empty_pad_shows_nothing() -> None:
    assert blended({}, (0.5, 0.5)) == {}
