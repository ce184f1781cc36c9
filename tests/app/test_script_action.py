"""A script from a file is one step; what is none is refused in a sentence."""

from pathlib import Path

import pytest

from app.actions import Context
from tests.app.desk import Desk, do


@pytest.fixture
def script(desk: Desk, tmp_path: Path) -> Path:
    desk.script = tmp_path / "pose.py"
    return desk.script


def test_a_script_runs_as_one_step_and_its_last_line_is_said(context: Context, desk: Desk, script: Path) -> None:
    script.write_text("\ufeffau(12).weight = 0.5\nau(17).weight = 0.25\nprint('posed')\nprint('done')\n", "utf-8")
    do("file.run-script", context)
    assert (desk.errors, desk.messages) == ([], ["Ran pose.py: done"])
    assert context.document.history.done == ("Script pose",)
    assert context.document.shown == {"12L": 0.5, "12R": 0.5, "17": 0.25}


def test_a_script_that_raises_is_told_with_file_and_line(context: Context, desk: Desk, script: Path) -> None:
    script.write_text("au(12).weight = 0.5\nau(99)\n")
    do("file.run-script", context)
    (sentence,) = desk.errors
    assert sentence.startswith("pose.py: The script stopped at line 2: There is no action unit “99”")
    assert context.document.history.done == ()


@pytest.mark.parametrize("content", [b"\xff\xfe\x00", b"#" * (2**20 + 1), None])
def test_what_is_no_script_is_refused(context: Context, desk: Desk, script: Path, content: bytes | None) -> None:
    if content is not None:
        script.write_bytes(content)
    do("file.run-script", context)
    assert "pose.py" in desk.errors[0]
    assert context.document.history.done == ()


def test_thinking_better_of_it_runs_nothing(context: Context, desk: Desk) -> None:
    do("file.run-script", context)
    assert desk.errors == desk.messages == []


def test_a_bare_head_is_begun_with_nothing_on_it(context: Context, desk: Desk) -> None:
    do("file.new-bare.ada", context)
    project = context.document.project
    assert (project.face.key, project.muscles, project.units, project.emotions) == ("ada", (), (), ())
    assert not context.document.dirty
