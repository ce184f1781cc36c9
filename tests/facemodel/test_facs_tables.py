"""The shipped tables say what the Facial Action Coding System says."""

import pytest

from facemodel.actions import GROUP_TITLES, JawMotion, expand, skin_units
from facemodel.atlas import read_atlas
from facemodel.faces import face_keys
from facemodel.facs import action_units, emotions
from resources import resource

UPPER = {1, 2, 4, 5, 6, 7, 41, 42, 43, 44, 45, 46}
LOWER = {*range(8, 21), *range(22, 31), 34, 38, 39}
NUMBERS = UPPER | LOWER
MIDLINE = {8, 17, 19, 22, 23, 24, 25, 26, 27, 28, 29, 39}
EYES, HEAD = set(range(61, 67)), set(range(51, 59))

# Largest displacement of the skin at full contraction, measured on scanned adults, one side where paired; mm.
MEASURED = {
    "inner brow raiser": 6.0,
    "outer brow raiser": 8.6,
    "brow lowerer": 6.5,
    "eyes closed": 9.6,
    "cheek raiser": 6.3,
    "lip corner puller": 15.8,
    "lip corner depressor": 6.1,
    "dimpler": 8.9,
    "lip stretcher": 10.3,
    "upper lip raiser": 8.8,
    "lower lip depressor": 4.6,
    "nose wrinkler": 10.3,
    "lip pucker": 12.4,
    "lip funneler": 11.7,
    "lip pressor": 4.3,
    "chin raiser": 11.3,
    "blink": 9.6,
    "mouth stretch": 42.0,
}

MUSCLES = {
    1: {"frontalis_medialis"},
    2: {"frontalis_lateralis"},
    4: {"corrugator", "depressor_supercilii", "procerus"},
    5: {"levator_palpebrae"},
    6: {"orbicularis_oculi_malaris", "orbicularis_oculi_orbitalis"},
    7: {"orbicularis_oculi_palpebralis"},
    9: {"levator_labii_superioris_alaeque_nasi"},
    10: {"levator_labii_superioris"},
    11: {"zygomaticus_minor"},
    12: {"zygomaticus_major"},
    13: {"levator_anguli_oris"},
    14: {"buccinator"},
    15: {"depressor_anguli_oris"},
    16: {"depressor_labii_inferioris"},
    17: {"mentalis"},
    18: {"incisivus_labii_superioris", "incisivus_labii_inferioris"},
    20: {"risorius", "platysma"},
    34: {"breath"},
    38: {"nasalis_alaris"},
    39: {"nasalis_transversa", "depressor_septi"},
    41: {"levator_palpebrae"},
    43: {"levator_palpebrae"},
    44: {"orbicularis_oculi_palpebralis"},
    45: {"levator_palpebrae"},
}

PROTOTYPES = {
    "happiness": {6, 12},
    "sadness": {1, 4, 15},
    "surprise": {1, 2, 5, 26},
    "fear": {1, 2, 4, 5, 7, 20, 26},
    "anger": {4, 5, 7, 23},
    "disgust": {9, 15, 16},
    "contempt": {12, 14},
    "sadness, furrowed": {1, 4, 11, 15},
    "sadness, chin raised": {1, 4, 15, 17},
    "surprise, mouth stretched": {1, 2, 5, 27},
    "anger, lip raised": {4, 5, 7, 10, 23},
    "anger, lips funnelled": {4, 5, 7, 22, 23},
    "anger, lips pressed": {4, 5, 7, 24},
    "anger, lips parted": {4, 5, 7, 23, 25, 26},
    "disgust, chin raised": {9, 15, 17},
    "disgust, lip raised": {10, 16, 25},
}


def test_the_units_are_there_with_their_sides() -> None:
    units = action_units()
    assert {unit.number for unit in units} == NUMBERS | EYES | HEAD
    assert {unit.number for unit in units if not unit.paired} == MIDLINE | EYES | HEAD
    assert {unit.number for unit in skin_units(units)} == NUMBERS
    assert {unit.group for unit in units} == set(GROUP_TITLES)


@pytest.mark.parametrize("name", MEASURED)
def test_amplitudes_are_the_measured_ones(name: str) -> None:
    unit = next(unit for unit in action_units() if unit.name == name)
    # Lids part seven to ten millimetres, so that what closes them depends on the individual.
    assert unit.amplitude == pytest.approx(MEASURED[name], rel=0.1 if unit.number == 43 else 0.0)


@pytest.mark.parametrize("number", MUSCLES)
def test_units_are_made_by_the_muscles_of_the_system(number: int) -> None:
    unit = next(unit for unit in action_units() if unit.number == number)
    assert set(unit.muscles) >= MUSCLES[number]


def test_the_jaw_moves_in_jaw_units_only_and_opens_further_in_the_larger() -> None:
    moving = {unit.number: unit.jaw for unit in action_units() if unit.jaw is not None}
    assert set(moving) == {19, 26, 27, 29, 30}
    assert 0 < moving[19].degrees < moving[26].degrees < moving[27].degrees < 35
    assert 0 <= moving[26].slide <= moving[27].slide < 15
    assert moving[29] == JawMotion(0.0, moving[29].slide)
    assert moving[30] == JawMotion(0.0, 0.0, moving[30].side)
    assert min(moving[29].slide, moving[30].side) > 0


def test_eyes_and_head_turn_to_either_side_alike() -> None:
    units = {unit.number: unit for unit in action_units()}
    for left, right in ((61, 62), (51, 52), (55, 56)):
        one, other = units[left], units[right]
        assert one.eyes == (other.eyes and other.eyes.mirrored)
        assert one.head == (other.head and other.head.mirrored)
    assert all(units[number].eyes and not units[number].head for number in EYES)
    assert all(units[number].head and not units[number].eyes for number in HEAD)
    assert all(units[number].limit == 1 for number in EYES | HEAD)


def test_the_tongue_comes_out_in_one_unit_that_opens_the_mouth_for_it() -> None:
    assert {unit.number for unit in action_units() if unit.tongue} == {19}
    assert all(unit.jaw for unit in action_units() if unit.tongue)


def test_levator_contracts_to_open_and_relaxes_to_close() -> None:
    units = {unit.number: unit for unit in action_units()}
    for closing in (41, 42, 43, 45, 46):
        assert units[5].muscles["levator_palpebrae"] * units[closing].muscles["levator_palpebrae"] < 0


@pytest.mark.parametrize("emotion", PROTOTYPES)
def test_emotions_follow_their_prototypes(emotion: str) -> None:
    assert {each.name for each in emotions()} == set(PROTOTYPES)
    weights = next(e.weights for e in emotions() if e.name == emotion)
    fields = expand(weights, action_units())
    assert {int(name.rstrip("LR")) for name in fields} == PROTOTYPES[emotion]
    assert all(0 < weight <= 1 for weight in weights.values())


def test_contempt_is_one_sided_and_the_others_are_not() -> None:
    for emotion in emotions():
        fields = expand(emotion.weights, action_units())
        mirrored = {name.translate(str.maketrans("LR", "RL")): weight for name, weight in fields.items()}
        assert (mirrored == fields) == (emotion.name != "contempt")


@pytest.mark.parametrize("key", face_keys())
def test_the_atlas_of_a_face_has_every_muscle_that_is_used(key: str) -> None:
    atlas = read_atlas(resource("atlas", f"{key}.json"))
    muscles = {muscle.key for muscle in atlas.muscles}
    assert len(muscles) == len(atlas.muscles)
    for unit in action_units():
        for name in unit.muscles:
            assert name in muscles or {f"{name}_L", f"{name}_R"} <= muscles, name
    assert set(atlas.gains) == NUMBERS
    assert all(gain > 0 for gain in atlas.gains.values())


@pytest.mark.parametrize("key", face_keys())
def test_muscles_come_in_mirrored_pairs(key: str) -> None:
    muscles = {muscle.key: muscle for muscle in read_atlas(resource("atlas", f"{key}.json")).muscles}
    for left in (muscle for muscle in muscles.values() if muscle.side == "L"):
        right = muscles[f"{left.name}_R"]
        assert (left.width, left.kappa, left.strength, left.count) == (
            right.width,
            right.kappa,
            right.strength,
            right.count,
        )
        for own, other in zip(left.fibres, right.fibres, strict=True):
            assert own.origin * [-1, 1, 1] == pytest.approx(other.origin, abs=0.5)
            assert own.attachment * [-1, 1, 1] == pytest.approx(other.attachment, abs=0.5)
            assert own.origin[0] > -6.0, "on the subject's left"
