"""One table holds everything that can be done; it is whole, free of clashes, and does what it says."""

from pathlib import Path

from app.actions import (
    MENUS,
    Action,
    Context,
    all_actions,
    perform,
    shortcuts_of,
    state_signals,
    table_signals,
)
from app.actions.table import in_order
from app.palette import typed_expression
from app.playback import Playhead
from app.timeline.actions import timeline_actions
from app.timeline.timeline import Timeline
from facemodel.faces import face_keys
from facemodel.io.project_file import save_project
from tests.app.desk import Desk, do, find_action


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
    of_timeline = timeline_actions(Timeline(context.document, Playhead(context.document)))
    for menu in MENUS:
        groups = [action.group for action in (*all_actions(context), *of_timeline) if action.menu == (menu,)]
        assert groups == sorted(groups), menu
        assert groups or menu == "File", menu


def test_the_file_menu_goes_from_what_begins_to_what_ends(context: Context) -> None:
    importing = Action("timeline.import", "Weights over time…", lambda _: None, menu=("File", "Import"), group=2)
    actions = in_order((*all_actions(context), importing))
    entries = [action.menu[1] if len(action.menu) > 1 else action.title for action in actions if "File" in action.menu]
    assert list(dict.fromkeys(entries)) == [
        *("New", "New bare head", "Open…", "Examples"),
        *("Save", "Save as…"),
        *("Import", "Export", "Save picture…"),
        *("Run script…", "Quit"),
    ]


def test_every_action_can_be_done(context: Context, desk: Desk, file: Path) -> None:
    save_project(context.document.project, file)
    desk.path, desk.answer, desk.text = file, "discard", "12=0.5"
    context.settings.remember(file)
    desk.script = file.with_suffix(".py")
    desk.script.write_text("print(len(units()))")
    for action in all_actions(context):
        if any(action.id == now.id for now in all_actions(context)):
            perform(action, context)
    assert desk.errors == []


def test_what_is_not_possible_is_not_done(context: Context, desk: Desk) -> None:
    assert not find_action("edit.undo", context).enabled(context)
    assert not find_action("solve.cancel", context).enabled(context)
    assert not find_action("edit.reset", context).enabled(context)
    for action in ("edit.undo", "edit.redo", "edit.reset", "solve.cancel"):
        do(action, context)
    assert context.document.history.done == ()


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
