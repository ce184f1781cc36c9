"""Files of measured faces: what is read, and what is said of those that are wrong."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from facemodel.calibration.measured import read_measured
from facemodel.errors import ProjectError
from facemodel.faces import load_face
from tests.facemodel.calibration.heads import arrays, write

FACE = load_face("ada")
GOOD = arrays(FACE, ["mouthSmile_L", "jawOpen"], np.ones((2, len(FACE.skin.positions), 3)))


def test_a_file_is_read_as_it_was_written_and_other_arrays_are_ignored(tmp_path: Path) -> None:
    measured = read_measured(write(tmp_path / "face.npz", GOOD))
    assert measured.names == ("mouthSmile_L", "jawOpen")
    assert measured.mesh.positions == pytest.approx(GOOD["neutral"])
    assert np.array_equal(measured.mesh.triangles, FACE.skin.triangles)
    assert np.array_equal(measured.landmarks, GOOD["landmarks68"])
    assert measured.deltas == pytest.approx(GOOD["deltas"])
    assert measured.left_out == 0


def test_eyeballs_and_stray_vertices_are_left_out(tmp_path: Path) -> None:
    count = len(FACE.skin.positions)
    more = GOOD | {
        "neutral": np.concatenate([GOOD["neutral"], np.eye(3, dtype=np.float32), np.zeros((1, 3), dtype=np.float32)]),
        "triangles": np.concatenate([GOOD["triangles"], [[count, count + 1, count + 2]]]),
        "deltas": np.pad(GOOD["deltas"], ((0, 0), (0, 4), (0, 0))),
    }
    measured = read_measured(write(tmp_path / "face.npz", more))
    assert measured.left_out == 4
    assert measured.mesh.positions == pytest.approx(GOOD["neutral"])
    assert measured.deltas.shape == GOOD["deltas"].shape


def changed(name: str, value: Any) -> dict[str, Any]:
    return GOOD | {name: value}


def with_nan() -> np.ndarray:
    deltas = GOOD["deltas"].copy()
    deltas[1, 7, 2] = np.nan
    return deltas


BAD = {
    "no array “deltas”": {name: array for name, array in GOOD.items() if name != "deltas"},
    "(3420, 2) as “neutral”": changed("neutral", GOOD["neutral"][:, :2]),
    "<U1": changed("triangles", np.full((4, 3), "a")),
    "names vertex 3420": changed("triangles", GOOD["triangles"] + 1),
    "names vertex -1": changed("landmarks68", np.where(np.arange(68) == 3, -1, GOOD["landmarks68"])),
    "shape (68)": changed("landmarks68", GOOD["landmarks68"][:60]),
    "nan at [1, 7, 2] of “deltas”": changed("deltas", with_nan()),
    "“jawOpen” twice": changed("names", np.array(["jawOpen", "jawOpen"])),
    "no list of words": changed("names", np.arange(2)),
    "plain arrays": changed("names", np.array(["a", 3], dtype=object)),
    "must be numbers of shape (3, 3420, 3)": changed("names", np.array(["a", "b", "c"])),
    "1e+06 at [0, 0]": changed("neutral", GOOD["neutral"] * 0 + 1e6),
}


@pytest.mark.parametrize("says", BAD)
def test_a_wrong_file_is_refused_in_a_sentence_that_says_where(says: str, tmp_path: Path) -> None:
    path = write(tmp_path / "face.npz", BAD[says])
    with pytest.raises(ProjectError) as caught:
        read_measured(path)
    assert says in str(caught.value)
    assert str(path) in str(caught.value)
    assert str(caught.value).endswith(".")


def test_landmarks_lie_on_one_piece_of_skin(tmp_path: Path) -> None:
    count = len(FACE.skin.positions)
    landmarks = GOOD["landmarks68"].copy()
    landmarks[5] = count
    more = GOOD | {
        "neutral": np.concatenate([GOOD["neutral"], np.eye(3, dtype=np.float32)]),
        "triangles": np.concatenate([GOOD["triangles"], [[count, count + 1, count + 2]]]),
        "deltas": np.pad(GOOD["deltas"], ((0, 0), (0, 3), (0, 0))),
        "landmarks68": landmarks,
    }
    with pytest.raises(ProjectError, match="landmark 5"):
        read_measured(write(tmp_path / "face.npz", more))


@pytest.mark.parametrize("contents", [b"", b"PK\x03\x04 half a zip", b"no zip at all"])
def test_what_is_no_archive_is_refused(contents: bytes, tmp_path: Path) -> None:
    path = tmp_path / "face.npz"
    path.write_bytes(contents)
    with pytest.raises(ProjectError, match=r"no \.npz archive"):
        read_measured(path)
    with pytest.raises(ProjectError, match="cannot be read"):
        read_measured(tmp_path / "missing.npz")
