"""Learning on a measured face from end to end: its figures are those of what was learned."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from facemodel.anatomy.files import shipped_anatomy
from facemodel.calibration.compare import Adjusted, adjusted, carried_over, measured_report, vertex_fields
from facemodel.calibration.measured import read_measured
from facemodel.errors import FaceError
from facemodel.project import Settings
from facemodel.projects import new_project
from facemodel.solution import Cancelled
from facemodel.solve import solve_project
from tests.facemodel.calibration.heads import arrays, write

SMILE, NOBODY = "mouthSmile_L", "grumpyFace"


@pytest.fixture(scope="module")
def smiling(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a file of an old man whose smile goes up more steeply than his own muscle would draw it."""
    project = replace(new_project("dayo"), settings=Settings("hct9", 1))
    fields = vertex_fields(project.face, solve_project(project).basis)
    steep = fields["12L"] * [0.6, 1.2, 1.0]
    contents = arrays(project.face, [SMILE, NOBODY], np.array([steep, steep]))
    return write(tmp_path_factory.mktemp("measured") / "dayo.npz", contents)


@pytest.fixture(scope="module")
def stopped(smiling: Path) -> Adjusted:
    """Return what was learned of it in the first round."""

    def one_round(text: str, _share: float) -> None:
        if "round 2" in text:
            raise Cancelled

    return adjusted(str(smiling), carried_over(read_measured(smiling), new_project()), shipped_anatomy(), one_round)


def test_what_was_learned_until_it_was_stopped_is_solved_and_reported(smiling: Path, stopped: Adjusted) -> None:
    before = measured_report("", carried_over(read_measured(smiling), new_project()))
    assert stopped.learned.stopped
    assert stopped.learned.turns
    assert stopped.report.mean > before.mean
    assert stopped.report.mean == pytest.approx(stopped.learned.after, abs=ELEMENTS_APART)
    assert stopped.report.left_out[NOBODY]


ELEMENTS_APART = 0.01
"""Cosine by which the element that learns and the one that is shown differ on faces."""


def test_a_smile_contracts_as_strongly_as_before(smiling: Path, stopped: Adjusted) -> None:
    fitted = carried_over(read_measured(smiling), new_project())
    (row,), (before,) = stopped.report.rows, measured_report("", fitted).rows
    assert row.figures.solved == pytest.approx(before.figures.solved, rel=0.5)


def test_a_face_of_which_nothing_can_be_learned_is_refused_in_a_sentence(tmp_path: Path) -> None:
    face = new_project("dayo").face
    nothing = write(tmp_path / "face.npz", arrays(face, [NOBODY], np.ones((1, len(face.skin.positions), 3))))
    with pytest.raises(FaceError, match="nothing to learn"):
        adjusted("", carried_over(read_measured(nothing), new_project()), shipped_anatomy())
