"""Number fields compute as Python does, and say in a sentence what they cannot read."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.arithmetic import LONGEST, evaluate
from app.errors import NumberError

Tree = tuple[str, float]
"""A text, and its value by plain arithmetic."""


def numbers() -> st.SearchStrategy[Tree]:
    plain = st.floats(0, 1e6).map(lambda x: (repr(x), x))
    percent = st.integers(0, 500).map(lambda n: (f"{n}%", n / 100))
    comma = st.integers(0, 99).map(lambda n: (f"0,{n:02}", float(f"0.{n:02}")))
    return plain | percent | comma


def joined(parts: st.SearchStrategy[Tree]) -> st.SearchStrategy[Tree]:
    def join(a: Tree, sign: str, b: Tree, space: str) -> Tree:
        value = {"+": a[1] + b[1], "-": a[1] - b[1], "*": a[1] * b[1], "/": a[1] / b[1] if b[1] else math.nan}[sign]
        return f"({a[0]}{space}{sign}{space}{b[0]})", value

    pair = st.builds(join, parts, st.sampled_from("+-*/"), parts, st.sampled_from(["", " "]))
    return pair | parts.map(lambda a: (f"-{a[0]}", -a[1])) | parts.map(lambda a: (f"({a[0]})%", a[1] / 100))


@given(st.recursive(numbers(), joined, max_leaves=8))
def test_it_computes_as_python_does(tree: Tree) -> None:
    text, value = tree
    if len(text) > LONGEST or not math.isfinite(value):
        with pytest.raises(NumberError):
            evaluate(text)
    else:
        assert evaluate(text) == value


@given(
    st.lists(st.tuples(st.integers(1, 99), st.sampled_from(["+", "-", "*", "/"])), min_size=1, max_size=12),
    st.integers(1, 99),
)
def test_products_bind_before_sums_and_all_from_the_left(terms: list[tuple[int, str]], last: int) -> None:
    text = "".join(f"{number}{sign}" for number, sign in terms) + str(last)
    assert evaluate(text) == pytest.approx(value_by_sums_of_products(text), rel=1e-12, abs=1e-9)


def value_by_sums_of_products(text: str) -> float:
    """Split at plus and minus first, then at times and by: another way to the same value."""
    total = 0.0
    for term in text.replace("-", "+-").split("+"):
        product = 1.0
        for factor in term.replace("/", "*/").split("*"):
            product = product / float(factor[1:]) if factor[0] == "/" else product * float(factor)
        total += product
    return total


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0.5+0.1", 0.5 + 0.1),
        ("80%", 0.8),
        ("1/3", 1 / 3),
        ("  .5 ", 0.5),
        ("5.", 5.0),
        ("0,5", 0.5),
        ("1e-3", 1e-3),
        ("--1", 1.0),
        ("2 − 1", 1.0),
        ("3 × 2 ÷ 4", 1.5),
        ("1/50%", 2.0),
        ("50%%", 0.005),
        ("-(1+2)*3", -9.0),
        ("2-1-1", 0.0),
    ],
)
def test_it_reads_what_people_write(text: str, value: float) -> None:
    assert evaluate(text) == value


@pytest.mark.parametrize(
    "text",
    ["", " ", "abc", "1+", "(1", "1)", "1 2", "1..2", "2**3", "1//2", "%", ".", "²", "1/0", "1e999", "nan", "0x10",
     "__import__('os')", "1_000", "(" * 150, "1+" * 150],
)  # fmt: skip
def test_it_refuses_everything_else_in_one_sentence(text: str) -> None:
    with pytest.raises(NumberError) as refused:
        evaluate(text)
    sentence = str(refused.value)
    assert sentence.endswith(".")
    assert "\n" not in sentence


@given(st.text(max_size=60))
def test_any_text_is_a_finite_number_or_is_refused(text: str) -> None:
    try:
        value = evaluate(text)
    except NumberError:
        return
    assert math.isfinite(value)
