"""A measured face is given bone, tissue, landmarks and supports by one of our heads, whichever way it was turned."""

from pathlib import Path

import numpy as np
import pytest

from facemodel.calibration.measured import read_measured
from facemodel.calibration.measured_face import PosedFace, posed_face
from facemodel.chart import chart_figures
from facemodel.errors import FaceError
from facemodel.faces import load_face
from facemodel.mesh import Mesh
from fem import Support
from tests.facemodel.calibration.heads import arrays, write

HEAD, OTHER = load_face("ada"), load_face("dayo")
UP = np.tile([0.0, 2.0, 0.0], (1, len(OTHER.skin.positions), 1))


@pytest.fixture(scope="module")
def posed(tmp_path_factory: pytest.TempPathFactory) -> PosedFace:
    """Return an old man, measured lying on his side, to whom a young woman lends what he lacks."""
    path = write(tmp_path_factory.mktemp("measured") / "face.npz", arrays(OTHER, ["browInnerUp"], UP))
    return posed_face(read_measured(path), HEAD)


def test_it_is_turned_into_the_axes_of_our_heads_and_its_fields_with_it(posed: PosedFace) -> None:
    skin = posed.face.skin.positions
    left, right = (skin[posed.face.landmarks[f"eye_outer_{side}"]] for side in "LR")
    assert left[0] > 30.0
    assert right[0] < -30.0
    assert posed.fields[0] == pytest.approx(UP[0], abs=0.3), "up is up again"
    apart = np.linalg.norm(skin[:, None][::97] - skin[None, ::89], axis=2)
    assert apart == pytest.approx(
        np.linalg.norm(OTHER.skin.positions[:, None][::97] - OTHER.skin.positions[None, ::89], axis=2), abs=1e-2
    ), "a face is turned and shifted, and keeps its size"


def test_its_loops_are_named(posed: PosedFace) -> None:
    assert set(posed.loops) == {"eye_L", "eye_R", "mouth", "rim"}
    assert posed.face.skin.positions[posed.loops["eye_L"]][:, 0].min() > 0.0


def test_landmarks_come_to_lie_where_they_are_on_that_face(posed: PosedFace) -> None:
    """The individuals share one mesh, so that every landmark of the old man is known."""
    off = {
        name: np.linalg.norm(posed.face.skin.positions[vertex] - posed.face.skin.positions[OTHER.landmarks[name]])
        for name, vertex in posed.face.landmarks.items()
    }
    assert np.median(list(off.values())) < 4.0
    assert max(off.values()) < 16.0, "on cheeks and temples nothing tells places apart"
    assert all(off[name] < 1e-6 for name in ("mouth_corner_L", "eye_inner_R", "nose_tip", "brow_mid_L"))


def test_bone_and_tissue_come_along(posed: PosedFace) -> None:
    face, solved = posed.face, np.unique(posed.face.skin.triangles[posed.face.solved])
    assert np.abs(face.skull.jawbone - OTHER.skull.jawbone)[solved].mean() < 0.05
    depth, own = (np.linalg.norm(f.skull.anchors - f.skin.positions, axis=1)[solved] for f in (face, OTHER))
    assert np.median(np.abs(depth - own)) < 2.5
    firm, firm_own = (np.log(f.layers.stiffness)[solved] for f in (face, OTHER))
    assert np.corrcoef(firm, firm_own)[0, 1] > 0.9
    assert face.solved.mean() == pytest.approx(OTHER.solved.mean(), abs=0.08)


def test_it_is_held_where_it_is_not_solved_and_charted_without_a_flip(posed: PosedFace) -> None:
    face = posed.face
    rest = np.unique(face.skin.triangles[~face.solved])
    assert (face.layers.supports[rest] == Support.CLAMPED).all()
    assert not np.isin(posed.loops["rim"], np.setdiff1d(face.skin.triangles[face.solved], rest)).any()
    figures = chart_figures(Mesh(face.skin.positions, face.skin.triangles[face.solved]), face.chart)
    assert figures.flips == 0


def test_lids_rest_on_the_eyeballs(posed: PosedFace) -> None:
    for eye in posed.face.eyes:
        margin = posed.face.skin.positions[posed.loops[f"eye_{eye.side}"]]
        gap = np.linalg.norm(margin - eye.centre, axis=1) - eye.radius
        assert np.abs(np.median(gap)) < 1.0


@pytest.mark.parametrize(("scale", "says"), [(0.001, "millimetres"), (10.0, "millimetres")])
def test_a_face_in_another_unit_is_refused(scale: float, says: str, tmp_path: Path) -> None:
    contents = arrays(OTHER, ["browInnerUp"], UP)
    contents["neutral"] = contents["neutral"] * scale
    with pytest.raises(FaceError, match=says):
        posed_face(read_measured(write(tmp_path / "face.npz", contents)), HEAD)
