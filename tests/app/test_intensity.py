"""Scores of FACS are read as they are written, and weights are told in its letters."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.authoring.intensities import with_letter, with_letters
from app.authoring.units import unit_of
from app.errors import NumberError, UnitError
from app.expression_text import parse_expression
from app.intensity import NAMES, letter_of, parse_code, typed_weight, weight_of
from facemodel.actions import LETTERS
from facemodel.errors import UnknownNameError
from facemodel.io.project_file import project_bytes, project_of
from facemodel.project import Project
from tests.app.conftest import UNITS

SMILE = UNITS[0]
EARLY = replace(SMILE, letters=(0.05, 0.1, 0.2, 0.5, 0.95))


@pytest.mark.parametrize(
    ("score", "weights"),
    [
        ("12C", {"12L": 0.6, "12R": 0.6}),
        ("L12D+17a", {"12L": 0.8, "17": 0.2}),
        (" 12RB + 26 ", {"12R": 0.4, "26": 1.0}),
        ("12A+R12E", {"12L": 0.2, "12R": 1.0}),
    ],
)
def test_a_score_is_read(score: str, weights: dict[str, float]) -> None:
    assert parse_code(score, UNITS) == weights
    assert parse_expression(score, UNITS) == weights


@pytest.mark.parametrize("score", ["", "12F", "12C+", "L12RC", "C12", "12C 17A", "12CC"])
def test_what_is_no_score_is_refused(score: str) -> None:
    with pytest.raises(NumberError):
        parse_code(score, UNITS)


def test_a_unit_that_is_not_there_is_named() -> None:
    with pytest.raises(UnknownNameError, match="99"):
        parse_code("12C+99A", UNITS)
    with pytest.raises(UnknownNameError, match="no left and right"):
        parse_code("L17A", UNITS)


def test_letters_begin_where_the_unit_says() -> None:
    assert [letter_of(weight, SMILE) for weight in (0.0, 0.09, 0.1, 0.71, 2.0)] == ["", "", "A", "D", "E"]
    assert [letter_of(weight, EARLY) for weight in (0.04, 0.09, 0.1, 0.71, 2.0)] == ["", "A", "B", "D", "E"]


@pytest.mark.parametrize("unit", [SMILE, EARLY])
@pytest.mark.parametrize("letter", NAMES)
def test_what_a_letter_sets_is_scored_as_that_letter(unit, letter: str) -> None:
    assert letter_of(weight_of(letter, unit), unit) == letter


def test_a_letter_sets_no_more_than_the_limit() -> None:
    assert weight_of("E", replace(SMILE, limit=0.6)) == 0.6
    assert weight_of("E", replace(SMILE, letters=(0.1, 0.3, 0.5, 0.7, 1.4))) == 1.4


def test_a_field_takes_a_letter_a_score_or_a_sum() -> None:
    assert [typed_weight(text, SMILE) for text in ("C", " 12c ", "1/4", "50%")] == [0.6, 0.6, 0.25, 0.5]
    with pytest.raises(NumberError, match="action unit 12, not 6"):
        typed_weight("6C", SMILE)
    with pytest.raises(NumberError):
        typed_weight("F", SMILE)


@pytest.mark.parametrize("letters", [(0.1, 0.2, 0.3, 0.4), (0.1, 0.3, 0.2, 0.4, 0.5), (0, 0.1, 0.2, 0.3, 0.4)])
def test_letters_out_of_order_are_refused(project: Project, letters: tuple[float, ...]) -> None:
    with pytest.raises(UnitError):
        with_letters(project, 12, letters)


@given(st.sampled_from(NAMES), st.floats(-1, 3))
def test_a_letter_that_is_dragged_stays_between_its_neighbours(project: Project, letter: str, weight: float) -> None:
    moved = with_letter(project, 12, letter, weight)
    letters = unit_of(moved, 12).letters
    assert list(letters) == sorted(set(letters))
    assert sum(one != other for one, other in zip(letters, LETTERS, strict=True)) <= 1


def test_letters_are_saved_with_the_unit(project: Project) -> None:
    made = with_letters(project, 12, (0.05, 0.1, 0.2, 0.5, 0.95))
    again = project_of(project_bytes(made))
    assert unit_of(again, 12).letters == (0.05, 0.1, 0.2, 0.5, 0.95)
    assert b"letters" not in project_bytes(project)
