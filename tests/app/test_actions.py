"""One table holds everything that can be done; it is whole, free of clashes, and does what it says."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from app.actions import (
    MENUS,
    Action,
    Answer,
    Context,
    FileQuestion,
    all_actions,
    find_action,
    may_leave,
    open_path,
    perform,
    shortcuts_of,
    state_signals,
    table_signals,
)
from app.actions.exporting import export_to
from app.document import Document
from app.jobs import SolveJob
from app.palette import typed_expression
from app.settings import UserSettings
from app.solving import Solving
from app.view import View
from facemodel.errors import RisoriusError, UnknownNameError
from facemodel.faces import face_keys
from facemodel.io.export import export_project
from facemodel.io.project_file import load_project, save_project
from facemodel.project import Project
from facemodel.solve import Cancelled, Progress, Solution, solve_project


@dataclass
class Desk:
    """A person at a window: answers as it was told, and writes down what the window was asked to do."""

    path: Path | None = None
    answer: Answer = "cancel"
    text: str = ""
    questions: list[FileQuestion | str] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)
    messages: list[str] = field(default_factory=list)
    calls: list[object] = field(default_factory=list)

    def ask_path(self, question: FileQuestion) -> Path | None:
        self.questions.append(question)
        return self.path

    def ask_unsaved(self, name: str) -> Answer:
        self.questions.append(name)
        return self.answer

    def show_error(self, sentence: str) -> None:
        self.errors.append(sentence)

    def show_message(self, sentence: str) -> None:
        self.messages.append(sentence)

    def clipboard(self) -> str:
        return self.text

    def set_clipboard(self, text: str) -> None:
        self.text = text

    def save_picture(self, path: Path) -> None:
        self.calls.append(("save_picture", path))

    def focus_unit(self, number: int) -> None:
        self.calls.append(("focus_unit", number))

    def frame_head(self) -> None:
        self.calls.append("frame_head")

    def frame_selection(self) -> None:
        self.calls.append("frame_selection")

    def focus_search(self) -> None:
        self.calls.append("focus_search")

    def show_palette(self) -> None:
        self.calls.append("show_palette")

    def show_face_information(self) -> None:
        self.calls.append("show_face_information")

    def show_shortcuts(self) -> None:
        self.calls.append("show_shortcuts")

    def show_about(self) -> None:
        self.calls.append("show_about")

    def reset_layout(self) -> None:
        self.calls.append("reset_layout")

    def toggle_full_screen(self) -> None:
        self.calls.append("toggle_full_screen")

    def quit(self) -> None:
        self.calls.append("quit")


@pytest.fixture
def desk() -> Desk:
    return Desk()


def solve_small(project: Project, progress: Progress) -> Solution:
    """Solve the small face, and give up on the large ones: what is tested here does not depend on them."""
    if project.face.key != "patch":
        raise Cancelled
    return solve_project(project, progress)


@pytest.fixture
def context(document: Document, desk: Desk, tmp_path: Path) -> Iterator[Context]:
    job = SolveJob(solve_small)
    yield Context(document, View(), UserSettings(tmp_path / "preferences.json"), Solving(document, job), desk)
    job.close()


def do(action_id: str, context: Context) -> None:
    perform(find_action(action_id, context), context)


def test_ids_and_keys_are_there_once(context: Context) -> None:
    actions = all_actions(context)
    ids = [action.id for action in actions]
    keys = [key for action in actions for key in shortcuts_of(action, context.settings.preferences)]
    assert len(set(ids)) == len(ids)
    assert len(set(keys)) == len(keys)


def test_every_action_says_what_it_is(context: Context) -> None:
    for action in all_actions(context):
        assert action.title, action.id
        assert action.hint, action.id
        assert not action.hint.endswith("."), action.id
        assert action.title_now(context).startswith(action.title.split("…")[0][:4]), action.id
        assert not action.menu or action.menu[0] in MENUS, action.id
        assert action.menu or action.id.split(".")[0] in ("unit", "muscle"), action.id


def test_every_menu_has_something_and_its_groups_stand_together(context: Context) -> None:
    for menu in MENUS:
        groups = [action.group for action in all_actions(context) if action.menu == (menu,)]
        assert groups == sorted(groups), menu
        assert groups or menu == "File", menu


def test_every_action_can_be_done(context: Context, desk: Desk, file: Path) -> None:
    save_project(context.document.project, file)
    desk.path, desk.answer, desk.text = file, "discard", "12=0.5"
    context.settings.remember(file)
    for action in all_actions(context):
        perform(action, context)
    assert desk.errors == []


def test_what_is_not_possible_is_not_done(context: Context, desk: Desk) -> None:
    assert not find_action("edit.undo", context).enabled(context)
    assert not find_action("solve.cancel", context).enabled(context)
    assert not find_action("edit.reset", context).enabled(context)
    for action in ("edit.undo", "edit.redo", "edit.reset", "solve.cancel"):
        do(action, context)
    assert context.document.history.done == ()
    with pytest.raises(UnknownNameError, match=r"edit\.smile"):
        do("edit.smile", context)


def test_undo_and_redo_name_the_step(context: Context) -> None:
    do("emotion.happiness", context)
    assert context.document.shown == {"12L": 0.9, "12R": 0.9}
    undo, redo = (find_action(name, context) for name in ("edit.undo", "edit.redo"))
    assert undo.title_now(context) == "Undo Happiness 100%"
    do("edit.undo", context)
    assert context.document.shown == {}
    assert redo.title_now(context) == "Redo Happiness 100%"
    do("edit.redo", context)
    do("edit.reset", context)
    assert context.document.shown == {}
    assert undo.title_now(context) == "Undo Neutral face"


def test_an_expression_goes_through_the_clipboard_and_replaces_the_other(context: Context, desk: Desk) -> None:
    context.document.set_weights({"12": 0.5, "17": 0.25})
    do("edit.copy", context)
    assert desk.text == "12L=0.5 12R=0.5 17=0.25"
    context.document.set_expression({"26": 1.0}, "Jaw")
    do("edit.paste", context)
    assert context.document.project.expression == {"12L": 0.5, "12R": 0.5, "17": 0.25}
    desk.text = "https://example.org"
    do("edit.paste", context)
    assert len(desk.errors) == 1
    assert context.document.project.expression == {"12L": 0.5, "12R": 0.5, "17": 0.25}


def test_an_expression_can_be_typed_into_the_palette(context: Context) -> None:
    assert typed_expression("turn", context) is None
    assert typed_expression("99=1", context) is None
    typed = typed_expression(" 12=50%  17=0.25", context)
    assert typed is not None
    assert typed.title == "Show 12=50% 17=0.25"
    perform(typed, context)
    assert context.document.project.expression == {"12L": 0.5, "12R": 0.5, "17": 0.25}


def test_toggles_and_choices_show_what_is_on(context: Context) -> None:
    for action in all_actions(context):
        if action.kind == "toggle":
            before = action.checked(context)
            perform(action, context)
            assert action.checked(context) is not before, action.id
            perform(action, context)
            assert action.checked(context) is before, action.id
    for chosen in ("view.left", "emotion.happiness", "muscle.zygomaticus_major_L"):
        do(chosen, context)
        kind = chosen.split(".")[0]
        on = [a.id for a in all_actions(context) if a.id.startswith(kind) and a.kind == "choice" and a.checked(context)]
        assert on == [chosen]
    assert context.view.state.muscles


def test_solving_now_makes_the_solution_fresh_and_is_then_not_offered(context: Context) -> None:
    now = find_action("solve.now", context)
    assert now.enabled(context)
    perform(now, context)
    assert context.document.solution is not None
    assert not now.enabled(context)


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
    assert desk.questions[0] == "Untitled (Patch)"
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


def test_a_user_can_give_an_action_other_keys(context: Context) -> None:
    undo, redo = (find_action(name, context) for name in ("edit.undo", "edit.redo"))
    assert shortcuts_of(redo, context.settings.preferences) == ("Ctrl+Shift+Z", "Ctrl+Y")
    context.settings.change(shortcuts={"edit.redo": "Ctrl+R", "edit.undo": ""})
    assert shortcuts_of(redo, context.settings.preferences) == ("Ctrl+R",)
    assert shortcuts_of(undo, context.settings.preferences) == ()


def test_whatever_changes_an_action_is_among_the_signals(context: Context, desk: Desk, file: Path) -> None:
    desk.path, desk.answer = file, "discard"

    def states(actions: tuple[Action, ...]) -> list[tuple[object, ...]]:
        return [(a.id, a.enabled(context), a.checked(context), a.title_now(context)) for a in actions]

    fired: list[str] = []
    for signal in state_signals(context):
        signal.connect(lambda *_: fired.append("state"), check_nargs=False)
    for signal in table_signals(context):
        signal.connect(lambda *_: fired.append("table"), check_nargs=False)
    for action_id in [action.id for action in all_actions(context)]:
        actions = all_actions(context)
        before, ids = states(actions), {action.id for action in actions}
        fired.clear()
        do(action_id, context)
        if states(actions) != before:
            assert "state" in fired, action_id
        if {action.id for action in all_actions(context)} != ids:
            assert "table" in fired, action_id


def test_every_shipped_face_can_be_begun_with_and_changed_to(context: Context, desk: Desk) -> None:
    assert face_keys()
    context.document.set_weights({"12": 0.5, "17": 0.25})
    desk.answer = "discard"
    for key in face_keys():
        do(f"face.switch.{key}", context)
        assert context.document.project.face.key == key
        assert context.document.shown == {"12L": 0.5, "12R": 0.5, "17": 0.25}
    for _ in face_keys():
        do("edit.undo", context)
    assert context.document.project.face.key == "patch"
    for key in face_keys():
        do(f"file.new.{key}", context)
        assert context.document.project.face.key == key
        assert context.document.shown == {}
        assert context.document.history.done == ()
