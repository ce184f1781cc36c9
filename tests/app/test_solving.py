"""Edits are solved by what they touch, what is shown stays, and one can look back at what was before."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.authoring import units
from app.document import Document
from app.jobs import SolveJob
from app.solving import EditingSolve, Solving
from facemodel.laying.values import changed
from facemodel.project import Project
from facemodel.solve import solve_project
from facemodel.solver import Work


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("RISORIUS_CACHE", str(tmp_path))
    return tmp_path


@pytest.fixture
def solve(cache: Path) -> EditingSolve:
    return EditingSolve()


@pytest.fixture
def solving(document: Document, solve: EditingSolve) -> Iterator[Solving]:
    job = SolveJob(solve)
    solving = Solving(document, job)
    solving.solve()
    yield solving
    job.close()


def wider(project: Project) -> Project:
    first = changed(project.muscles[0], "width", project.muscles[0].width + 3)
    return replace(project, muscles=(first, *project.muscles[1:]))


def test_the_first_solve_of_a_head_comes_from_the_disk_and_edits_do_not_go_there(
    solving: Solving, solve: EditingSolve, cache: Path, document: Document, project: Project
) -> None:
    assert len(list(cache.iterdir())) == 1
    assert solve.work.factorised
    document.edit(wider(document.project), "Widen")
    assert not document.stale
    assert solve.work == Work(columns=1, fields=3)
    assert len(list(cache.iterdir())) == 1
    again = EditingSolve()
    again(project)
    assert again.work == Work()


def test_after_preparing_the_first_edit_is_as_quick_as_all_others(
    solving: Solving, document: Document, cache: Path, project: Project
) -> None:
    cold = EditingSolve()
    job = SolveJob(cold)
    other = Document(project)
    second = Solving(other, job)
    second.solve()
    assert not cold.work.factorised
    second.prepare()
    assert cold.work.factorised
    second.prepare()
    other.edit(wider(project), "Widen")
    assert not cold.work.factorised
    job.close()


def test_what_is_shown_stays_through_a_new_solution(solving: Solving, document: Document) -> None:
    document.set_weights({"12L": 0.5})
    document.edit(wider(document.project), "Widen")
    assert document.shown == {"12L": 0.5}
    assert not document.stale


def test_a_new_solution_is_what_a_fresh_solve_gives(solving: Solving, document: Document) -> None:
    document.edit(wider(document.project), "Widen")
    assert document.solution is not None
    fresh = solve_project(document.project).basis
    assert document.solution.basis.fields == pytest.approx(fresh.fields, abs=1e-6)


def test_a_map_shows_where_the_last_change_moved_what_is_shown(solving: Solving, document: Document) -> None:
    assert document.last_change_map() is None
    document.set_weights({"12L": 0.5, "17": 1.0})
    before = document.solution
    document.edit(wider(document.project), "Widen")
    after = document.solution
    assert before is not None
    assert after is not None
    assert document.previous_solution is before
    moved = sum(w * (after.basis.field(n) - before.basis.field(n)) for n, w in document.shown.items())
    assert document.last_change_map() == pytest.approx(np.linalg.norm(moved, axis=1), rel=1e-5, abs=1e-6)
    assert document.last_change_map().max() > 1e-3  # type: ignore[union-attr]
    document.reset_expression()
    assert document.last_change_map().max() == 0  # type: ignore[union-attr]


def test_only_the_fields_that_an_edit_touches_are_stale(document: Document, project: Project) -> None:
    document.accept(solve_project(project), project)
    document.edit(units.with_activation(project, 20, "zygomaticus_major", 0.7), "Stronger")
    assert document.stale_fields == {"20L", "20R"}
    document.edit(units.with_note(document.project, 12, "a smile"), "Note")
    assert document.stale_fields == {"20L", "20R"}
    document.undo()
    document.undo()
    assert not document.stale


def test_names_and_notes_are_not_solved_again_but_another_order_is(solving: Solving, document: Document) -> None:
    started: list[object] = []
    solving.job.started.connect(started.append)
    document.edit(units.with_note(document.project, 12, "a smile"), "Note")
    document.edit(units.renamed(document.project, 12, "smile"), "Rename")
    assert started == []
    document.edit(units.moved_unit(document.project, 26, 0), "Order")
    assert len(started) == 1
    assert document.solution is not None
    assert document.solution.basis.names[0] == "26"


@pytest.fixture
def waiting(document: Document, project: Project) -> Iterator[Solving]:
    """A document that is solved, whose next solve begins and is never heard of again."""
    document.accept(solve_project(project), project)
    job = SolveJob(EditingSolve(), lambda _: None)
    yield Solving(document, job)
    job.close()


@pytest.fixture
def started(waiting: Solving) -> list[object]:
    """What the solver was started for."""
    heard: list[object] = []
    waiting.job.started.connect(heard.append)
    return heard


def test_after_cancelling_a_pose_does_not_start_the_solver_again(
    waiting: Solving, started: list[object], document: Document, project: Project
) -> None:
    document.edit(wider(project), "Widen")
    waiting.job.cancel()
    document.set_weights({"17": 0.5})
    assert len(started) == 1
    assert waiting.wanted


def test_an_edit_that_is_undone_before_it_is_solved_and_done_again_is_solved(
    waiting: Solving, started: list[object], document: Document, project: Project
) -> None:
    document.edit(wider(project), "Widen")
    document.undo()
    assert not document.stale
    document.redo()
    assert document.stale
    assert not waiting.wanted
    assert len(started) == 2


def test_a_face_without_units_is_solved_and_has_nothing_to_move(document: Document, project: Project) -> None:
    document.edit(replace(project, units=(), emotions=()), "Delete all units")
    solution = solve_project(document.project)
    document.accept(solution, document.project)
    assert document.solution is solution
    assert solution.basis.names == ()
    assert not document.stale
