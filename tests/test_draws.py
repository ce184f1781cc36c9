"""Examples of properties are the same whatever else a process has done."""

import importlib
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests import draws


def drawn() -> list[tuple[int, float, str]]:
    examples = []

    @given(st.integers(), st.floats(), st.text())
    @settings(max_examples=200)
    def look(number: int, share: float, text: str) -> None:
        examples.append((number, repr(share), text))

    look()
    return examples


def test_examples_do_not_depend_on_the_modules_that_are_loaded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if not draws.repeatable():
        pytest.skip("Examples are drawn at random, as asked for.")
    before = drawn()
    (tmp_path / "loaded_meanwhile.py").write_text("NUMBERS = 8675309, 24601.5, 'Jean Valjean'\n")
    monkeypatch.syspath_prepend(tmp_path)
    importlib.import_module("loaded_meanwhile")
    assert drawn() == before
