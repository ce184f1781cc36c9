"""Scores of FACS are read as they are written, and weights are told in its letters."""

import pytest

from app.errors import NumberError
from app.expression_text import parse_expression
from app.intensity import INTENSITIES, letter_of, parse_code
from facemodel.errors import UnknownNameError
from tests.app.conftest import UNITS


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


def test_letters_and_weights_belong_together() -> None:
    assert all(letter_of(weight) == letter for letter, weight in INTENSITIES.items())
    assert [letter_of(weight) for weight in (0.0, 0.09, 0.1, 0.71, 2.0)] == ["", "", "A", "D", "E"]
