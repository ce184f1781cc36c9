"""What is sculpted is a layer: as much of it as one wants, mirrored, copied, cleared, and none of it is lost."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.authoring import parting, sculpting, units
from app.authoring.merging import merged
from app.errors import UnitError
from facemodel.errors import UnknownNameError
from facemodel.io.project_file import project_bytes, project_of
from facemodel.project import Project
from facemodel.sculpting.correction import correction_of, summed
from fem.types import FloatArray
from tests.app.conftest import small_project

COUNT = 81


def rough(seed: int) -> FloatArray:
    return np.random.default_rng(seed).uniform(-1, 1, (COUNT, 3))


@pytest.fixture
def sculpted(project: Project) -> Project:
    layers = {"12L": correction_of(rough(1)), "12R": correction_of(rough(2)), "17": correction_of(rough(3))}
    return replace(project, corrections=layers)


def total(project: Project, number: int) -> FloatArray:
    return summed(project.corrections, units.unit_of(project, number).fields, COUNT)


def test_half_of_it_is_half_and_off_is_nothing_and_the_layer_stays(sculpted: Project) -> None:
    half = sculpting.with_amount(sculpted, 12, 0.5)
    np.testing.assert_allclose(total(half, 12), total(sculpted, 12) / 2, atol=1e-6)
    assert np.array_equal(total(half, 17), total(sculpted, 17))
    off = sculpting.with_switch(half, 12, False)
    assert not total(off, 12).any()
    again = sculpting.with_amount(sculpting.with_switch(off, 12, True), 12, 1.0)
    assert np.array_equal(total(again, 12), total(sculpted, 12))
    assert project_of(project_bytes(off)).corrections["12L"].share == 0
    for amount in (-0.1, 1.1, float("nan")):
        with pytest.raises(UnitError, match="amount"):
            sculpting.with_amount(sculpted, 12, amount)


def test_one_side_is_made_the_image_of_the_other(sculpted: Project) -> None:
    partners = sculpted.face.mirror
    for number in (12, 17):
        made = total(sculpting.symmetric(sculpted, number, "L", partners), number)
        np.testing.assert_allclose(made, made[partners] * [-1, 1, 1], atol=1e-6)
    left = sculpted.face.skin.positions[:, 0] > 0
    whole = total(sculpting.symmetric(sculpted, 17, "L", partners), 17)
    assert np.array_equal(whole[left], total(sculpted, 17)[left])
    only = replace(sculpted, corrections={"12L": sculpted.corrections["12L"]})
    with pytest.raises(UnitError, match="right"):
        sculpting.symmetric(only, 12, "R", partners)


def test_a_layer_is_copied_to_a_unit_of_as_many_sides_or_of_others(sculpted: Project) -> None:
    pairs = sculpting.copied_to(sculpted, 12, 20)
    assert pairs.corrections["20L"] is sculpted.corrections["12L"]
    one = sculpting.copied_to(sculpted, 12, 26)
    np.testing.assert_allclose(total(one, 26), total(sculpted, 12), atol=1e-6)
    two = sculpting.copied_to(sculpted, 17, 20)
    np.testing.assert_allclose(total(two, 20), total(sculpted, 17), atol=1e-6)
    assert np.abs(two.corrections["20L"].moved).max() > 0
    with pytest.raises(UnitError, match="itself"):
        sculpting.copied_to(sculpted, 12, 12)
    with pytest.raises(UnitError, match="Nothing"):
        sculpting.copied_to(sculpted, 26, 12)


def test_cleared_is_as_if_nobody_had_sculpted(sculpted: Project, project: Project) -> None:
    bare = sculpting.cleared(sculpting.cleared(sculpted, 12), 17)
    assert bare.corrections == project.corrections == {}
    assert sculpting.sculpted_units(sculpted) == {12, 17}
    with pytest.raises(UnitError, match="Nothing"):
        sculpting.cleared(bare, 12)


@given(
    st.lists(
        st.sampled_from(["amount", "switch", "left", "right", "copy", "clear", "duplicate", "split", "merge"]),
        max_size=8,
    ),
    st.floats(0, 1),
)
def test_whatever_is_done_the_project_can_be_saved_and_names_only_fields_there_are(
    deeds: list[str], amount: float
) -> None:
    project = small_project()
    layers = {"12L": correction_of(rough(1)), "17": correction_of(rough(3))}
    made = replace(project, corrections=layers)
    partners = project.face.mirror
    acts = {
        "amount": lambda p: sculpting.with_amount(p, 12, amount),
        "switch": lambda p: sculpting.with_switch(p, 17, False),
        "left": lambda p: sculpting.symmetric(p, 12, "L", partners),
        "right": lambda p: sculpting.symmetric(p, 17, "R", partners),
        "copy": lambda p: sculpting.copied_to(p, 17, 12),
        "clear": lambda p: sculpting.cleared(p, 17),
        "duplicate": lambda p: units.with_duplicate(p, 12)[0],
        "split": lambda p: parting.split(p, 17),
        "merge": lambda p: merged(p, 12, 20),
    }
    for deed in deeds:
        try:
            made = acts[deed](made)
        except (UnitError, UnknownNameError):
            continue
    read = project_of(project_bytes(made))
    assert list(read.corrections) == list(made.corrections)
    for name, each in made.corrections.items():
        assert np.array_equal(read.corrections[name].moved, each.moved)


def test_a_merged_unit_has_what_is_sculpted_on_both_in_their_shares(sculpted: Project) -> None:
    other = sculpting.copied_to(sculpted, 17, 20)
    made = merged(other, 12, 20, 1.0, 0.5)
    np.testing.assert_allclose(total(made, 12), total(other, 12) + total(other, 20) / 2, atol=1e-6)
    assert set(made.corrections) == {"12L", "12R", "17"}
