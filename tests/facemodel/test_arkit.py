"""Names of ARKit's face units, however they are written, and the action units that answer them."""

import pytest

from facemodel.actions import field_names
from facemodel.arkit import answering_fields, arkit_units, find_arkit
from facemodel.faces import load_face
from facemodel.facs import action_units
from facemodel.sculpted import read_sculpted

FIELDS = field_names(action_units())


def test_all_52_sculpted_names_are_known() -> None:
    names = read_sculpted(load_face("ada")).names
    assert len(names) == 52
    assert all(find_arkit(name) for name in names)


@pytest.mark.parametrize(
    ("name", "plain", "side"),
    [
        ("mouthSmile_L", "mouthSmile", "L"),
        ("mouthSmileRight", "mouthSmile", "R"),
        ("MOUTHSMILE_r", "mouthSmile", "R"),
        ("browInnerUp", "browInnerUp", ""),
        ("browInnerUp_L", "browInnerUp", "L"),
        ("mouthLeft", "mouthLeft", ""),
        ("jawRight", "jawRight", ""),
        ("eyeLookDownLeft", "eyeLookDown", "L"),
    ],
)
def test_sides_and_case_are_read_as_people_write_them(name: str, plain: str, side: str) -> None:
    found = find_arkit(name)
    assert (found[0].name, found[1]) == (plain, side) if plain else found is None


@pytest.mark.parametrize(
    ("name", "fields"),
    [
        ("mouthSmile_L", {"12L"}),
        ("mouthSmile", {"12L", "12R"}),
        ("browInnerUp", {"1L", "1R"}),
        ("browInnerUp_R", {"1R"}),
        ("jawOpen", {"27"}),
        ("mouthShrugLower_L", {"17"}),
        ("jawLeft", {"30L"}),
        ("eyeBlinkLeft", {"45L"}),
    ],
)
def test_a_name_is_answered_by_its_fields(name: str, fields: set[str]) -> None:
    found = find_arkit(name)
    assert found is not None
    assert answering_fields(*found, FIELDS).keys() == fields


def test_every_unit_that_a_name_asks_for_is_in_the_table() -> None:
    for unit in arkit_units().values():
        assert bool(unit.units) != bool(unit.note), "either action units answer, or a note says what it is instead"
        for number in unit.units:
            assert answering_fields(unit, "", FIELDS), number
