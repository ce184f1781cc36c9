"""A sequence of numbered files comes whole or not at all, and never mixes with an earlier one."""

import os
from pathlib import Path

import pytest

from facemodel.errors import ProjectError
from facemodel.io.sequence import numbered, replacing_sequence


def written(path: Path, count: int, text: str = "new") -> None:
    with replacing_sequence(path, count) as place:
        for number in range(1, count + 1):
            place(number).write_text(f"{text} {number}")


def interrupted(path: Path) -> None:
    with replacing_sequence(path, 3) as place:
        place(1).write_text("half")
        raise KeyboardInterrupt


def contents(folder: Path) -> dict[str, str]:
    return {each.name: each.read_text() for each in folder.iterdir()}


def test_numbers_have_four_digits_or_as_many_as_they_need() -> None:
    assert numbered(Path("a/smile.obj"), 7, 20) == Path("a/smile.0007.obj")
    assert numbered(Path("smile.obj"), 7, 123_456) == Path("smile.000007.obj")


def test_a_shorter_sequence_takes_the_place_of_a_longer_one(tmp_path: Path) -> None:
    (tmp_path / "smile.0003.txt").write_text("another kind")
    (tmp_path / "smile.final.obj").write_text("no number")
    (tmp_path / "other.0003.obj").write_text("another name")
    kept = contents(tmp_path)
    written(tmp_path / "smile.obj", 5, "old")
    written(tmp_path / "smile.obj", 2)
    assert contents(tmp_path) == kept | {"smile.0001.obj": "new 1", "smile.0002.obj": "new 2"}


def test_a_failure_leaves_the_sequence_that_was_there(tmp_path: Path) -> None:
    written(tmp_path / "smile.obj", 3, "old")
    before = contents(tmp_path)
    with pytest.raises(KeyboardInterrupt):
        interrupted(tmp_path / "smile.obj")
    assert contents(tmp_path) == before


def test_a_file_that_was_not_written_is_a_failure(tmp_path: Path) -> None:
    written(tmp_path / "smile.obj", 3, "old")
    before = contents(tmp_path)
    with (
        pytest.raises(ProjectError, match=r"smile\.obj” cannot be saved"),
        replacing_sequence(tmp_path / "smile.obj", 3) as place,
    ):
        place(1).write_text("the only one")
    assert contents(tmp_path) == before


def test_a_place_that_is_taken_is_found_before_the_work(tmp_path: Path) -> None:
    (tmp_path / "smile.0002.obj").mkdir()
    with (
        pytest.raises(ProjectError, match=r"smile\.0002\.obj” cannot be saved: it is a folder"),
        replacing_sequence(tmp_path / "smile.obj", 3),
    ):
        raise AssertionError("nothing may be written")
    assert os.listdir(tmp_path) == ["smile.0002.obj"]
    with pytest.raises(ProjectError, match="there is no folder"), replacing_sequence(tmp_path / "no" / "a.obj", 3):
        raise AssertionError("nothing may be written")
