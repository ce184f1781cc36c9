"""The sum of fields is what the summed loads do, but for the arc of the jaw; and the user sees where."""

import numpy as np
import pytest

from app.document import Document
from app.jobs import Failure, Job
from app.superposition_check import SuperpositionJob, check_superposition, posed
from facemodel.comparison import Comparison
from facemodel.errors import FaceError
from facemodel.project import Project
from facemodel.solve import solve_project


def checked(document: Document) -> Comparison:
    found: list[Comparison] = []
    failures: list[Failure] = []
    job: SuperpositionJob = Job(check_superposition)
    job.finished.connect(lambda comparison, _: found.append(comparison))
    job.failed.connect(failures.append)
    job.request(posed(document))
    job.close()
    assert not failures
    return found[0]


@pytest.fixture
def solved(document: Document, project: Project) -> Document:
    document.accept(solve_project(project), project)
    return document


def test_without_the_jaw_both_ways_give_the_same_face(solved: Document) -> None:
    solved.set_weights({"12L": 0.7, "12R": 0.2, "20R": 0.5, "17": 0.4})
    comparison = checked(solved)
    assert comparison.moved > 0.01
    assert comparison.largest < 1e-4 * comparison.moved + 1e-5


def test_the_arc_of_the_jaw_is_found_where_the_jaw_pulls(solved: Document) -> None:
    solved.set_weights({"26": 0.5})
    comparison = checked(solved)
    assert comparison.largest > 0.01
    assert comparison.rms < comparison.largest
    assert solved.solution is not None
    worst = solved.solution.basis.display.points[int(np.argmax(comparison.apart))]
    assert worst[1] < 0


def test_a_face_at_rest_is_the_same_both_ways(solved: Document) -> None:
    comparison = checked(solved)
    assert (comparison.moved, comparison.largest) == (0.0, 0.0)


def test_what_is_not_solved_cannot_be_checked(document: Document) -> None:
    with pytest.raises(FaceError, match="Solve now"):
        posed(document)
