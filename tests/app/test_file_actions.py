"""Files are begun, opened, saved, exported and left with the questions a person expects, and no others."""

from pathlib import Path

import pytest

from app.actions import Answer, Context, all_actions, may_leave, open_path
from app.actions.exporting import export_to
from facemodel.errors import RisoriusError
from facemodel.io.export import export_project
from facemodel.io.project_file import load_project, save_project
from facemodel.project import Project
from tests.app.desk import Desk, do, find_action


def test_saving_asks_once_for_a_file_and_remembers_it(context: Context, desk: Desk, tmp_path: Path) -> None:
    context.document.set_weights({"17": 0.5})
    desk.path = tmp_path / "smile"
    do("file.save", context)
    saved = tmp_path / "smile.risorius"
    assert load_project(saved).expression == {"17": 0.5}
    assert context.document.path == saved
    assert context.settings.preferences.recent == (saved,)
    context.document.set_weights({"17": 0.75})
    do("file.save", context)
    assert load_project(saved).expression == {"17": 0.75}
    assert len(desk.questions) == 1
    assert not find_action("file.save", context).enabled(context)


@pytest.mark.parametrize("suffix", [".glb", ".npz", ".obj", ".ply"])
def test_a_solved_face_is_exported_as_it_is_shown(context: Context, desk: Desk, tmp_path: Path, suffix: str) -> None:
    desk.path = tmp_path / "face"
    do(f"file.export{suffix}", context)
    assert desk.questions == []
    context.solving.solve()
    context.document.preview({"12": 0.5})
    do(f"file.export{suffix}", context)
    written = tmp_path / f"face{suffix}"
    assert desk.errors == []
    assert desk.messages == [f"Exported {written.name}"]
    shown = tmp_path / f"shown{suffix}"
    assert context.document.solution is not None
    export_project(context.document.project, context.document.solution, shown)
    assert context.document.project.expression == {"12L": 0.5, "12R": 0.5}
    assert written.read_bytes() == shown.read_bytes()


def test_an_export_that_fails_says_so(context: Context, desk: Desk, tmp_path: Path) -> None:
    desk.path = tmp_path / "missing" / "face.glb"
    with pytest.raises(RisoriusError, match="solved"):
        export_to(context, desk.path)
    context.solving.solve()
    do("file.export.glb", context)
    assert len(desk.errors) == 1
    assert desk.messages == []


def test_a_picture_gets_its_ending(context: Context, desk: Desk, tmp_path: Path) -> None:
    desk.path = tmp_path / "smile"
    do("file.screenshot", context)
    assert desk.calls == [("save_picture", tmp_path / "smile.png")]


def test_thinking_better_of_it_changes_nothing(context: Context, desk: Desk) -> None:
    for action in ("file.open", "file.save", "file.save-as", "file.screenshot"):
        do(action, context)
    assert len(desk.questions) == 4
    assert context.document.path is None
    assert desk.errors == desk.messages == []


@pytest.mark.parametrize(("answer", "leaves", "saved"), [("cancel", False, 0), ("discard", True, 0), ("save", True, 1)])
def test_unsaved_changes_are_asked_about(
    context: Context, desk: Desk, file: Path, answer: Answer, leaves: bool, saved: int
) -> None:
    assert may_leave(context)
    assert desk.questions == []
    desk.answer, desk.path = answer, file
    context.document.preview({"17": 0.5})
    assert may_leave(context) is leaves
    assert desk.questions[0] == "Untitled, Patch"
    assert file.exists() == bool(saved)
    assert context.document.shown == {"17": 0.5}


def test_a_save_that_fails_or_is_abandoned_keeps_the_window_open(context: Context, desk: Desk, tmp_path: Path) -> None:
    context.document.set_weights({"17": 0.5})
    desk.answer = "save"
    assert not may_leave(context)
    desk.path = tmp_path / "missing" / "file.risorius"
    assert not may_leave(context)
    assert len(desk.errors) == 1


def test_opening_asks_about_changes_and_keeps_them_if_told_so(
    context: Context, desk: Desk, project: Project, file: Path
) -> None:
    save_project(project.posed({"26": 1.0}), file)
    context.document.set_weights({"17": 0.5})
    open_path(context, file)
    assert context.document.shown == {"17": 0.5}
    desk.answer = "discard"
    open_path(context, file)
    assert context.document.shown == {"26": 1.0}
    assert not context.document.stale
    assert [action.hint for action in all_actions(context) if action.menu == ("File", "Open recent")] == [
        f"Open {file}"
    ]


def test_a_recent_file_that_is_gone_is_told_and_forgotten(context: Context, desk: Desk, file: Path) -> None:
    context.settings.remember(file)
    do("file.recent.0", context)
    assert len(desk.errors) == 1
    assert str(file) in desk.errors[0]
    assert context.settings.preferences.recent == ()
