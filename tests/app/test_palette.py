"""A few letters find what was meant."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.actions import Action, Context
from app.palette import Match, rank


def nothing(_context: Context) -> None:
    """Stand for what an action does, which finding it does not depend on."""


def actions(*titles: str) -> list[Action]:
    return [Action(title, title, nothing) for title in titles]


def titles(matches: list[Match]) -> list[str]:
    return [match.action.title for match in matches]


TITLES = (
    "Open…",
    "Save",
    "Save as…",
    "Undo",
    "Redo",
    "Front",
    "Frame selection",
    "Forces",
    "Three-quarter",
    "AU 12 lip corner puller",
    "AU 2 outer brow raiser",
    "AU 22 lip funneler",
    "Happiness",
    "Zygomaticus major (left)",
    "Zygomaticus major (right)",
)


@pytest.mark.parametrize(
    ("query", "first"),
    [
        ("save", "Save"),
        ("sa", "Save"),
        ("lcp", "AU 12 lip corner puller"),
        ("au 2", "AU 2 outer brow raiser"),
        ("22", "AU 22 lip funneler"),
        ("lip fun", "AU 22 lip funneler"),
        ("fun lip", "AU 22 lip funneler"),
        ("fr", "Front"),
        ("fs", "Frame selection"),
        ("tq", "Three-quarter"),
        ("zyg right", "Zygomaticus major (right)"),
        ("HAPPY"[:4], "Happiness"),
        ("hapiness", "Happiness"),
        ("undö", "Undo"),
    ],
)
def test_what_was_meant_comes_first(query: str, first: str) -> None:
    assert titles(rank(query, actions(*TITLES)))[0] == first


def test_letters_that_begin_words_beat_letters_in_a_row() -> None:
    assert titles(rank("ue", actions("Queue", "Undo edit"))) == ["Undo edit", "Queue"]


def test_an_empty_query_lists_all_in_their_order() -> None:
    assert titles(rank("  ", actions(*TITLES))) == list(TITLES)


def test_every_word_has_to_be_found() -> None:
    assert rank("save xyz", actions(*TITLES)) == []


def test_the_menu_and_the_hint_count_but_less_than_the_title() -> None:
    table = [
        Action("a", "Dark", nothing, hint="Colour the window"),
        Action("b", "Reset layout", nothing, menu=("Window",)),
        Action("c", "Window size", nothing),
    ]
    assert titles(rank("window", table)) == ["Window size", "Dark", "Reset layout"]


@given(st.text(min_size=1, max_size=8), st.lists(st.sampled_from(TITLES), unique=True))
def test_found_letters_are_those_that_were_typed_in_their_order(query: str, some: list[str]) -> None:
    for match in rank(query, actions(*some)):
        assert match.letters == tuple(sorted(set(match.letters)))
        assert all(0 <= place < len(match.action.title) for place in match.letters)


@given(st.sampled_from(TITLES), st.data())
def test_any_letters_of_a_title_in_their_order_find_it(title: str, data: st.DataObject) -> None:
    places = sorted(data.draw(st.sets(st.integers(0, len(title) - 1), min_size=1)))
    word = "".join(title[place] for place in places).replace(" ", "")
    if word:
        assert title in titles(rank(word, actions(*TITLES)))
