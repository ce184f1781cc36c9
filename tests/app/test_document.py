"""The document keeps what it is given, tells who listens, and never stands half changed."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.commands import ReplaceProject
from app.document import Document
from app.errors import NumberError
from facemodel.errors import ProjectError, RisoriusError, UnknownNameError
from facemodel.io.project_file import load_project, save_project
from facemodel.project import Project
from facemodel.solve import solve_project

SIGNALS = (
    "project_changed",
    "layers_changed",
    "skull_changed",
    "muscles_changed",
    "units_changed",
    "emotions_changed",
    "expression_changed",
    "solution_changed",
    "history_changed",
    "saved_changed",
)


@contextmanager
def heard(document: Document) -> Iterator[list[str]]:
    """Collect the names of the signals in the order in which they come."""
    names: list[str] = []

    def listener(name: str):  # type: ignore[no-untyped-def]
        return lambda *_: names.append(name)

    listeners = {name: listener(name) for name in SIGNALS}
    for name, listen in listeners.items():
        getattr(document, name).connect(listen, check_nargs=False)
    yield names
    for name, listen in listeners.items():
        getattr(document, name).disconnect(listen)


@given(previews=st.lists(st.dictionaries(st.sampled_from(["12L", "12R", "17"]), st.floats(0, 2)), max_size=5))
def test_a_cancelled_preview_leaves_no_trace(project: Project, previews: list[dict[str, float]]) -> None:
    posed = project.posed({"12L": 0.25})
    document = Document(posed)
    for weights in previews:
        document.preview(weights)
    document.cancel_preview()
    assert document.project is posed
    assert document.shown == posed.expression
    assert document.history.done == ()
    assert not document.dirty
    document.commit()
    assert document.project is posed


def test_a_drag_is_shown_at_once_and_becomes_one_step_when_it_ends(document: Document, project: Project) -> None:
    with heard(document) as names:
        for weight in (0.1, 0.2, 0.3):
            document.preview({"12": weight})
    assert names == ["expression_changed"] * 3
    assert document.shown == {"12L": 0.3, "12R": 0.3}
    assert document.project is project
    with heard(document) as names:
        document.commit()
    assert names == ["history_changed", "saved_changed"]
    assert document.project.expression == {"12L": 0.3, "12R": 0.3}
    assert document.history.done == ("Lip corner puller",)


def test_a_drag_back_to_where_it_began_is_no_step(document: Document) -> None:
    document.set_weights({"17": 0.5})
    document.preview({"17": 0.9})
    document.preview({"17": 0.5})
    document.commit()
    assert len(document.history.done) == 1


def test_undo_during_a_drag_takes_back_the_drag_and_can_bring_it_again(document: Document) -> None:
    document.preview({"17": 0.9})
    document.undo()
    assert document.shown == {}
    document.redo()
    assert document.shown == {"17": 0.9}


def test_weights_at_zero_leave_the_expression(document: Document) -> None:
    document.set_weights({"12": 0.5, "17": 0.5})
    document.set_weights({"12L": 0.0})
    assert document.project.expression == {"12R": 0.5, "17": 0.5}


def test_an_emotion_is_shown_alone_and_scaled(document: Document) -> None:
    document.set_weights({"17": 0.5})
    document.apply_emotion("Surprise", 0.5)
    assert document.project.expression == {"26": 0.4, "20L": 0.05}
    assert document.history.done[-1] == "Surprise 50%"
    document.reset_expression()
    assert document.project.expression == {}
    document.undo()
    document.undo()
    assert document.project.expression == {"17": 0.5}


@pytest.mark.parametrize("weight", [float("nan"), float("inf"), -0.1, 2.1])
def test_an_impossible_weight_is_refused_and_nothing_changes(document: Document, weight: float) -> None:
    document.preview({"17": 0.5})
    for intent in (document.preview, document.set_weights):
        with pytest.raises(NumberError, match="17"):
            intent({"26": 0.5, "17": weight})
    with pytest.raises(NumberError, match="strength"):
        document.apply_emotion("happiness", weight)
    assert document.shown == {"17": 0.5}
    assert document.held


def test_an_unknown_name_is_refused_and_nothing_changes(document: Document, project: Project) -> None:
    for name in ("99", "17L", "smile"):
        with pytest.raises(UnknownNameError):
            document.set_weights({"26": 0.5, name: 0.5})
    with pytest.raises(UnknownNameError, match="boredom"):
        document.apply_emotion("boredom")
    assert document.project is project


@given(
    st.lists(
        st.one_of(st.sampled_from(["save", "undo", "redo", "reset"]), st.sampled_from([0.0, 0.5, 1.0])), max_size=15
    )
)
def test_it_is_dirty_exactly_when_it_differs_from_what_was_saved(
    tmp_path_factory: pytest.TempPathFactory, project: Project, acts: list[str | float]
) -> None:
    document = Document(project)
    path = tmp_path_factory.getbasetemp() / "dirty.risorius"
    saved = project.expression
    for act in acts:
        if act == "save":
            document.save(path)
            saved = document.project.expression
        elif act == "undo":
            document.undo()
        elif act == "redo":
            document.redo()
        elif act == "reset":
            document.reset_expression()
        else:
            document.set_weights({"17": float(act)})
        assert document.dirty == (document.project.expression != saved)


def test_what_is_saved_is_opened_again(document: Document, file: Path) -> None:
    document.preview({"12L": 0.1 + 0.2})
    document.save(file)
    assert not document.dirty
    assert document.path == file
    assert document.name == "patch"
    other = Document(document.project.posed({}))
    other.open(file)
    assert other.project.expression == {"12L": 0.1 + 0.2}
    assert other.project.units == document.project.units
    assert not other.dirty


def test_opening_replaces_everything_and_tells_everyone(document: Document, project: Project, file: Path) -> None:
    save_project(project.posed({"26": 1.0}), file)
    document.accept(solve_project(project), project)
    document.set_weights({"17": 0.5})
    document.preview({"12": 0.5})
    with heard(document) as names:
        document.open(file)
    assert names == ["project_changed", "expression_changed", "history_changed", "saved_changed"]
    assert document.shown == {"26": 1.0}
    assert document.history.done == ()
    assert not document.held
    assert not document.dirty


def test_opening_another_head_lets_its_solution_go_and_the_same_head_keeps_it(
    document: Document, project: Project, other_project: Project, file: Path
) -> None:
    solution = solve_project(project)
    document.accept(solution, project)
    save_project(project, file)
    document.open(file)
    assert document.solution is solution
    assert not document.stale
    save_project(other_project, file)
    with heard(document) as names:
        document.open(file)
    assert names[:2] == ["project_changed", "solution_changed"]
    assert document.solution is None
    assert document.stale


def test_everyone_who_is_told_sees_the_whole_new_state(document: Document, project: Project, file: Path) -> None:
    save_project(project.posed({"26": 1.0}), file)
    document.set_weights({"17": 0.5})
    seen: list[tuple[object, ...]] = []
    document.project_changed.connect(
        lambda now: seen.append((document.project is now, document.shown, document.dirty, document.path))
    )
    document.open(file)
    assert seen == [(True, {"26": 1.0}, False, file)]


def test_a_damaged_file_leaves_the_open_document_as_it_was(document: Document, file: Path) -> None:
    save_project(document.project, file)
    file.write_bytes(file.read_bytes()[:-100])
    document.set_weights({"17": 0.5})
    document.preview({"12L": 0.5})
    before = (document.project, document.path, document.shown, document.history.done, document.dirty)
    with heard(document) as names, pytest.raises(ProjectError, match=file.name):
        document.open(file)
    assert (document.project, document.path, document.shown, document.history.done, document.dirty) == before
    assert names == []


def test_a_failed_save_keeps_the_old_file_and_the_changes(document: Document, file: Path) -> None:
    document.save(file)
    document.set_weights({"17": 0.5})
    with pytest.raises(ProjectError):
        document.save(file.parent / "missing" / "file.risorius")
    assert document.dirty
    assert document.path == file
    assert load_project(file).expression == {}


def test_a_document_without_a_file_asks_for_one(document: Document) -> None:
    with pytest.raises(ProjectError, match="Save as"):
        document.save()


def test_a_solution_stays_fresh_while_only_the_expression_changes(document: Document, project: Project) -> None:
    assert document.stale
    solution = solve_project(project)
    with heard(document) as names:
        document.accept(solution, project)
    assert names == ["solution_changed"]
    document.apply_emotion("happiness")
    assert document.solution is solution
    assert not document.stale


def test_a_changed_muscle_makes_the_solution_stale_but_keeps_the_last_good_face(
    document: Document, project: Project
) -> None:
    solution = solve_project(project)
    document.accept(solution, project)
    halved = Project(project.face, project.muscles[:1], project.units[2:], ())
    with heard(document) as names:
        document.run(ReplaceProject("Remove a muscle", project, halved))
    assert names[:4] == ["muscles_changed", "units_changed", "emotions_changed", "solution_changed"]
    assert document.stale
    assert document.solution is solution
    with heard(document) as names:
        document.undo()
    assert "solution_changed" in names
    assert not document.stale


def test_a_solution_of_another_face_is_dropped(document: Document, project: Project, other_project: Project) -> None:
    document.accept(solve_project(other_project), other_project)
    assert document.solution is None
    document.accept(solve_project(project), project)
    document.run(ReplaceProject("Other face", project, other_project))
    assert document.solution is None
    assert document.stale


def test_all_errors_of_a_document_are_meant_for_people(document: Document, tmp_path: Path) -> None:
    shutil.rmtree(tmp_path)
    for act in (lambda: document.open(tmp_path / "gone"), lambda: document.save(tmp_path / "gone" / "x")):
        with pytest.raises(RisoriusError, match="gone"):
            act()
