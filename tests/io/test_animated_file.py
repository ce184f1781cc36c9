"""What happens over time is saved and opened to the last bit; without it, files are what they always were."""

import io
import json
import zipfile
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.animation.clip import STILL, Animation
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.displacement import Displacement
from facemodel.animation.samples import Samples
from facemodel.animation.track import Track
from facemodel.io.damage import DamageError
from facemodel.io.npy import npy_bytes
from facemodel.io.project_file import project_bytes, project_of
from facemodel.project import Project
from tests.animation.strategies import animations
from tests.io.small_project import identical, small_project
from tests.io.test_damaged_files import json_values, packed, places


def small_animation() -> Animation:
    layer = Displacement(curve_of([Key(0.2, 0.9), Key(0.8, 0.1)]), 0.1, 0.5, name="brighter")
    captured = Samples(np.linspace(0, 1, 30, dtype=np.float32), 30.0, 0.5)
    return Animation(
        (
            Track("12L", curve_of([Key(0, 0.5, "bezier", (-0.1, 0), (0.1, 0.2), True), Key(1, 1)]), group="mouth"),
            Track("26", captured=captured, layers=(layer,)),
        )
    )


def animated(animation: Animation) -> Project:
    return replace(small_project(), animation=animation)


WHOLE = project_bytes(animated(small_animation()))


def members() -> dict[str, bytes]:
    zipped = zipfile.ZipFile(io.BytesIO(WHOLE))
    return {name: zipped.read(name) for name in zipped.namelist()}


@given(animations())
def test_any_animation_comes_back_to_the_last_bit(animation: Animation) -> None:
    project = animated(animation)
    data = project_bytes(project)
    opened = project_of(data)
    assert identical(opened, project)
    assert project_bytes(opened) == data


def test_a_file_without_animation_is_the_file_it_always_was() -> None:
    data = project_bytes(small_project())
    assert project_bytes(animated(Animation())) == data
    assert b"animation" not in zipfile.ZipFile(io.BytesIO(data)).read("project.json")
    assert project_of(data).animation is STILL


PLACES = [place for place in places(json.loads(members()["project.json"])) if place[:1] == ("animation",)]


@given(st.sampled_from(PLACES), json_values)
def test_any_value_anywhere_in_an_animation_is_refused_or_makes_one(place: tuple[object, ...], value: object) -> None:
    document = json.loads(members()["project.json"])
    inner = document
    for step in place[:-1]:
        inner = inner[step]
    inner[place[-1]] = value
    try:
        project = project_of(packed(members() | {"project.json": json.dumps(document).encode()}))
    except DamageError:
        return
    assert identical(project_of(project_bytes(project)), project)


@pytest.mark.parametrize(
    ("name", "array", "says"),
    [
        ("animation/keys/times", np.array([0, 1, 0.8, 0.2]), "at 3 does not go on in time"),
        ("animation/keys/times", np.array([0, 1, 0.2]), "has the shape"),
        ("animation/keys/values", np.array([0, np.nan, 0, 0]), "is not finite"),
        ("animation/keys/codes", np.array([0, 1, 2, 99], dtype=np.int8), "holds 99"),
        ("animation/captured/1", np.zeros((2, 2), dtype=np.float32), "has the shape"),
        ("animation/captured/0", np.zeros(3, dtype=np.float32), "is not part"),
    ],
)
def test_a_damaged_array_is_named(name: str, array: np.ndarray, says: str) -> None:
    with pytest.raises(DamageError) as caught:
        project_of(packed(members() | {f"{name}.npy": npy_bytes(array)}))
    assert caught.value.where.startswith(f"{name}.npy")
    assert says in caught.value.what


def test_arrays_of_an_animation_that_is_not_there_are_left_over() -> None:
    document = json.loads(members()["project.json"])
    del document["animation"]
    with pytest.raises(DamageError, match="is not part"):
        project_of(packed(members() | {"project.json": json.dumps(document).encode()}))
