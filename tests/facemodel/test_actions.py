"""Names and weights of action units, emotions and expressions."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.actions import ActionUnit, Emotion, expand, field_names, find_emotion, mixed, resolve
from facemodel.errors import UnknownNameError
from facemodel.facs import action_units, emotions

UNITS = action_units()
WEIGHTS = st.dictionaries(st.sampled_from(field_names(UNITS)), st.floats(-0.5, 2.0), max_size=6)


@pytest.mark.parametrize(
    ("name", "fields"),
    [
        ("12", ("12L", "12R")),
        ("AU12", ("12L", "12R")),
        ("au 12", ("12L", "12R")),
        ("lip corner puller", ("12L", "12R")),
        ("Lip_Corner-Puller", ("12L", "12R")),
        ("12L", ("12L",)),
        ("12 r", ("12R",)),
        ("AU12r", ("12R",)),
        ("lip corner puller R", ("12R",)),
        ("17", ("17",)),
        ("chin raiser", ("17",)),
        ("jaw drop", ("26",)),
        ("nose wrinkler", ("9L", "9R")),
        ("upper lip raiser l", ("10L",)),
    ],
)
def test_a_unit_is_found_by_any_of_its_names(name: str, fields: tuple[str, ...]) -> None:
    assert resolve(name, UNITS) == fields


@given(st.sampled_from(UNITS), st.sampled_from(["", "L", "R"]), st.booleans(), st.sampled_from(["", " ", "  "]))
def test_every_unit_answers_to_number_and_name_on_either_side(
    unit: ActionUnit, side: str, by_name: bool, gap: str
) -> None:
    spoken = unit.name.upper() if by_name else str(unit.number)
    asked = f" {spoken}{gap or ' '}{side}"
    if side and not unit.paired:
        with pytest.raises(UnknownNameError, match="has no left and right"):
            resolve(asked, UNITS)
    else:
        assert resolve(asked, UNITS) == ((f"{unit.number}{side}",) if side else unit.fields)


@pytest.mark.parametrize("name", ["99", "smile", "", "L", "12X", "AU", "1 2", "12LR", "-12"])
def test_an_unknown_unit_is_answered_with_those_there_are(name: str) -> None:
    with pytest.raises(UnknownNameError, match=r"There is no action unit .* this face has 1, 2, 4"):
        resolve(name, UNITS)


def test_a_middle_unit_has_no_sides() -> None:
    with pytest.raises(UnknownNameError, match=r"Action unit 26 \(jaw drop\) has no left and right; name it 26"):
        resolve("26L", UNITS)


def test_no_two_units_answer_to_one_name() -> None:
    spoken = [name for unit in UNITS for name in (str(unit.number), unit.name)]
    assert len(set(spoken)) == len(spoken)
    assert len(set(field_names(UNITS))) == len(field_names(UNITS))


def test_a_later_name_overrides_an_earlier_one() -> None:
    assert expand({"12": 0.5, "12L": 1.0}, UNITS) == {"12L": 1.0, "12R": 0.5}
    assert expand({"12L": 1.0, "12": 0.5}, UNITS) == {"12L": 0.5, "12R": 0.5}


@given(WEIGHTS)
def test_fields_stand_for_themselves(weights: dict[str, float]) -> None:
    assert expand(weights, UNITS) == weights


@given(WEIGHTS, WEIGHTS)
def test_mixing_takes_the_larger_weight_and_the_order_does_not_matter(
    one: dict[str, float], other: dict[str, float]
) -> None:
    both = mixed([one, other])
    assert both == mixed([other, one])
    for name in field_names(UNITS):
        assert both.get(name, 0.0) == max(one.get(name, 0.0), other.get(name, 0.0), 0.0)


@given(WEIGHTS)
def test_mixing_an_expression_with_itself_changes_nothing(weights: dict[str, float]) -> None:
    assert mixed([weights, weights]) == mixed([weights])


def test_emotions_are_found_whatever_their_case_and_are_made_of_known_units() -> None:
    known = emotions()
    for emotion in known:
        assert find_emotion(f" {emotion.name.upper()} ", known) is emotion
        assert expand(emotion.weights, UNITS)
        assert emotion.title[0].isupper()


def test_an_emotion_is_found_by_a_name_with_blanks_around_it_as_files_may_have_them() -> None:
    joy = Emotion("joy ", {"12": 1.0})
    assert find_emotion(joy.name, (joy,)) is joy


def test_an_unknown_emotion_is_answered_with_those_there_are() -> None:
    with pytest.raises(UnknownNameError, match=r"no emotion “glee”; choose one of joy, awe"):
        find_emotion("glee", (Emotion("joy"), Emotion("awe")))
