"""Muscles as JSON: every model's numbers come back to the last bit, and a wrong profile is named."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from facemodel.io.readable import readable
from facemodel.io.records import muscle_json, muscle_of
from facemodel.io.schema import MuscleRecord
from facemodel.muscles import Cosine, Fibre, Muscle, Profile, Profiles, Sphincter
from facemodel.muscles.models import MODELS
from tests.io.small_project import identical

number = st.floats(-200, 200)
point = st.tuples(number, number, number).map(lambda xyz: np.array(xyz, dtype=np.float64))
share = st.floats(-1, 1)
positive = st.floats(0.01, 100)
factors = st.tuples(share, share, share).map(np.array)


@st.composite
def profiles(draw: st.DrawFn) -> Profile:
    steps = draw(st.lists(st.floats(0.01, 1), min_size=1, max_size=5))
    at = (0.0, *(float(x) for x in np.cumsum(steps)))
    return Profile(at, tuple(draw(st.lists(share, min_size=len(at), max_size=len(at)))))


muscles = st.builds(
    Muscle,
    name=st.just("anything"),
    side=st.sampled_from(["L", "R", "M"]),
    title=st.just("Musculus"),
    group=st.just("lip"),
    model=st.sampled_from(sorted(MODELS)),
    fibres=st.lists(st.builds(Fibre, point, point, st.lists(point, max_size=3).map(tuple)), max_size=3).map(tuple),
    ring=st.none() | st.builds(Sphincter, point, point, point, point, st.floats(0, 1), share, share),
    width=positive,
    kappa=positive,
    strength=positive,
    count=st.integers(1, 100),
    profiles=st.none() | st.builds(Profiles, profiles(), profiles()),
    cosine=st.none() | st.builds(Cosine, st.tuples(positive, positive, positive).map(np.array), share, factors),
    linked=st.booleans(),
)


def read(text: bytes) -> Muscle:
    return muscle_of(MuscleRecord.model_validate_json(text))


@given(muscles)
def test_a_muscle_comes_back_bit_by_bit(muscle: Muscle) -> None:
    assert identical(read(readable(muscle_json(muscle))), muscle)


def test_what_a_fibre_muscle_does_not_need_is_not_written() -> None:
    straight = Muscle("a", "L", "A", "lip", "fibre", (Fibre(np.zeros(3), np.ones(3)),), None, 9.0, 3.0, 0.01, 50)
    assert {"profiles", "cosine", "linked"}.isdisjoint(muscle_json(straight))
    assert "via" not in muscle_json(straight)["fibres"][0]
    assert muscle_json(replace(straight, linked=False))["linked"] is False


@pytest.mark.parametrize(
    ("sigma", "says"),
    [
        ({"at": [0.0, 1.0], "values": [1.0]}, "one value for every knot|at least 2 items"),
        ({"at": [0.5, 1.0], "values": [1.0, 0.0]}, "start at 0"),
        ({"at": [0.0, 1.0, 1.0], "values": [1.0, 0.5, 0.0]}, "increase"),
    ],
)
def test_a_profile_out_of_order_is_refused(sigma: dict[str, list[float]], says: str) -> None:
    ring = Sphincter(np.zeros(3), np.array([20.0, 0, 0]), np.array([0, 10.0, 0]))
    document = muscle_json(Muscle("m", "M", "M", "lip", "mouth", (), ring, 9.0, 1.0, 0.01, 1))
    document["profiles"] = {"sigma": sigma, "tau": {"at": [0.0, 1.0], "values": [0.5, 0.0]}}
    with pytest.raises(ValidationError, match=says):
        read(readable(document))
