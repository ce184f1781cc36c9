"""The sum of fields is what the summed loads do, along the arc of the jaw as well."""

from dataclasses import replace

import numpy as np
import pytest

from app.document import Document
from app.superposition_check import SuperpositionCheck, posed
from app.view import View
from app.view_state import ViewState
from facemodel.comparison import Comparison
from facemodel.errors import FaceError
from facemodel.project import Project
from facemodel.sculpting.correction import correction_of
from facemodel.solve import solve_project


def checked(document: Document) -> Comparison:
    check = SuperpositionCheck(document, View())
    check.begin()
    check.job.close()
    assert not check.failure
    assert check.found is not None
    return check.found


@pytest.fixture
def solved(document: Document, project: Project) -> Document:
    document.accept(solve_project(project), project)
    return document


def test_without_the_jaw_both_ways_give_the_same_face(solved: Document) -> None:
    solved.set_weights({"12L": 0.7, "12R": 0.2, "20R": 0.5, "17": 0.4})
    comparison = checked(solved)
    assert comparison.moved > 0.01
    assert comparison.largest < 1e-4 * comparison.moved + 1e-5


def test_the_skin_follows_the_arc_of_the_jaw(solved: Document) -> None:
    solved.set_weights({"26": 0.5, "12L": 0.3})
    comparison = checked(solved)
    assert comparison.moved > 1.0
    assert comparison.rms <= comparison.largest < 1e-4


def test_the_pure_linear_sum_leaves_the_arc_of_the_jaw(solved: Document) -> None:
    solved.set_weights({"26": 0.5})
    view = View()
    check = SuperpositionCheck(solved, view)
    view.change(linear=True)
    check.begin()
    assert check.found is not None
    assert check.found.largest > 0.01
    assert solved.solution is not None
    worst = solved.solution.basis.display.points[int(np.argmax(check.found.apart))]
    assert worst[1] < 0
    view.change(linear=False)
    assert check.found is None
    check.job.close()


def test_a_face_at_rest_has_nothing_to_check(solved: Document) -> None:
    with pytest.raises(FaceError, match="rest"):
        posed(solved, ViewState())


def test_what_is_sculpted_is_no_error_of_the_superposition(solved: Document) -> None:
    layer = correction_of(np.full((len(solved.project.face.skin.positions), 3), 2.0))
    solved.edit(replace(solved.project, corrections={"17": layer}), "Sculpt")
    solved.set_weights({"17": 1.0})
    assert checked(solved).largest < 1e-4


def test_what_is_seen_alone_is_what_is_checked_and_forgotten_when_something_else_is(solved: Document) -> None:
    solved.set_weights({"26": 0.5})
    view = View()
    view.change(workspace="actions", unit=17, solo=True)
    check = SuperpositionCheck(solved, view)
    check.begin()
    assert check.found is not None
    assert check.found.largest < 1e-4
    view.change(forces=True)
    assert check.found is not None
    view.change(solo=False)
    assert check.found is None
    check.job.close()


def test_what_is_not_solved_cannot_be_checked(document: Document) -> None:
    with pytest.raises(FaceError, match="Solve now"):
        posed(document, ViewState())
