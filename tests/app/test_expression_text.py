"""An expression goes through the clipboard unchanged."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.errors import NumberError
from app.expression_text import format_expression, parse_expression
from facemodel.errors import RisoriusError, UnknownNameError
from facemodel.project import Project

FIELDS = st.sampled_from(["12L", "12R", "20L", "20R", "17", "26"])


@given(expression=st.dictionaries(FIELDS, st.floats(0, 2, exclude_min=True)))
def test_it_comes_back_exactly(project: Project, expression: dict[str, float]) -> None:
    assert parse_expression(format_expression(expression, project.units), project.units) == expression


def test_it_is_written_in_the_order_of_the_units(project: Project) -> None:
    assert format_expression({"26": 1.0, "12R": 0.8, "17": 0.0, "12L": 0.8}, project.units) == "12L=0.8 12R=0.8 26=1.0"
    assert format_expression({}, project.units) == "neutral"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("12=0.8", {"12L": 0.8, "12R": 0.8}),
        ("AU12L = 50%, 17: 1/4", {"12L": 0.5, "17": 0.25}),
        ("lip corner puller R = 0,5\nJaw drop=1;", {"12R": 0.5, "26": 1.0}),
        ("12=0.8 12L=0.1", {"12L": 0.1, "12R": 0.8}),
        (" neutral\n", {}),
    ],
)
def test_it_reads_what_people_write(project: Project, text: str, expected: dict[str, float]) -> None:
    assert parse_expression(text, project.units) == expected


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("", NumberError),
        ("hello", NumberError),
        ("12", NumberError),
        ("12=", NumberError),
        ("12=0.8 17", NumberError),
        ("12=lots", NumberError),
        ("99=1", UnknownNameError),
        ("17L=1", UnknownNameError),
        ("=1", NumberError),
    ],
)
def test_it_refuses_the_rest_in_one_sentence(project: Project, text: str, error: type[RisoriusError]) -> None:
    with pytest.raises(error) as refused:
        parse_expression(text, project.units)
    assert str(refused.value).endswith((".", ")."))


@given(text=st.text(alphabet="12L=.,; \nabc%/", max_size=40))
def test_any_text_is_an_expression_or_is_refused(project: Project, text: str) -> None:
    try:
        expression = parse_expression(text, project.units)
    except RisoriusError:
        return
    assert all(math.isfinite(weight) for weight in expression.values())
