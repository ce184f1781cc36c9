"""Landmarks in files: read whatever they are wrapped in, gaps bridged and told, damage named in one sentence."""

import json
import pickle
import zipfile
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest

from facemodel.animation.capture import Capture
from facemodel.animation.landmarks import LandmarkTrack
from facemodel.errors import ProjectError
from facemodel.io.weights import read_capture, read_recording

FRAMES, POINTS = 6, 478


@pytest.fixture
def points() -> np.ndarray:
    return np.random.default_rng(4).uniform(100, 400, (FRAMES, POINTS, 3)).astype(np.float32)


def npz(path: Path, **arrays: np.ndarray) -> Path:
    np.savez_compressed(path, **arrays)
    return path


def read(path: Path, rate: float | None = None) -> LandmarkTrack:
    found = read_recording(path, rate=rate)
    assert isinstance(found, LandmarkTrack)
    return found


def test_an_archive_of_arrays_is_read(tmp_path: Path, points: np.ndarray) -> None:
    track = read(npz(tmp_path / "a.npz", landmarks=points))
    assert track.points == pytest.approx(points)
    assert (track.rate, track.irises) == (30.0, True)
    assert track.notes == ("No times are noted in it; its frames are taken as 30 a second.",)
    assert read(tmp_path / "a.npz", 25.0).rate == 25.0
    without = read(npz(tmp_path / "b.npz", landmarks=points[:, :468], times=np.arange(FRAMES) / 24))
    assert (without.rate, without.irises, without.notes) == (24.0, False, ())


def test_frames_without_a_face_are_bridged_and_told(tmp_path: Path, points: np.ndarray) -> None:
    lost = points.copy()
    lost[2], lost[4], lost[1, 7, 0] = np.nan, 0.0, np.inf
    track = read(npz(tmp_path / "a.npz", landmarks=lost), 30.0)
    assert track.points[2] == pytest.approx((track.points[1] + points[3]) / 2)
    assert track.points[4] == pytest.approx((points[3] + points[5]) / 2)
    assert track.points[1, 7, 0] == pytest.approx((2 * points[0, 7, 0] + points[3, 7, 0]) / 3)
    assert track.notes[0] == "In 2 of 6 frames no face was found; they were bridged."
    assert len(track.notes) == 2
    lost = points.copy()
    lost[2] = np.nan
    whole = read(npz(tmp_path / "b.npz", landmarks=lost), 30.0)
    assert whole.notes == ("In 1 of 6 frames no face was found; they were bridged.",)


def named(frame: np.ndarray) -> list[dict[str, float]]:
    return [dict(zip("xyz", point, strict=True)) for point in frame.tolist()]


def test_json_is_read_in_whatever_shape_it_is(tmp_path: Path, points: np.ndarray) -> None:
    path = tmp_path / "a.json"
    shapes = [
        {"fps": 25, "landmarks": points.tolist()},
        [{"landmarks": frame} for frame in points.tolist()],
        {"frames": [{"faceLandmarks": [named(frame)], "timestamp_ms": 40 * k} for k, frame in enumerate(points)]},
        [{"multi_face_landmarks": [{"landmarks": named(frame)}, {"landmarks": named(-frame)}]} for frame in points],
    ]
    for shape, rate in zip(shapes, (25.0, 30.0, 25.0, 30.0), strict=True):
        path.write_text(json.dumps(shape))
        track = read(path)
        assert track.points == pytest.approx(points)
        assert track.rate == rate
    path.write_text(json.dumps([{"faceLandmarks": []}, {"faceLandmarks": None}, {"faceLandmarks": [named(points[0])]}]))
    assert read(path).notes[0] == "In 2 of 3 frames no face was found; they were bridged."


def test_weights_beside_landmarks_say_more(tmp_path: Path, points: np.ndarray) -> None:
    path = tmp_path / "a.json"
    frames = [{"faceBlendshapes": {"jawOpen": 0.5}, "faceLandmarks": [named(frame)]} for frame in points]
    path.write_text(json.dumps(frames))
    found = read_recording(path)
    assert isinstance(found, Capture)
    assert found.kind == "arkit"


def archive(name: str, data: bytes) -> bytes:
    stream = BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as out:
        out.writestr(name, data)
    return stream.getvalue()


def pickled() -> bytes:
    stream = BytesIO()
    np.save(stream, np.array([{"a": 1}], dtype=object), allow_pickle=True)
    return stream.getvalue()


def huge() -> bytes:
    """An array file that says it has a terabyte of numbers."""
    stream = BytesIO()
    np.save(stream, np.zeros((10, 478, 3)))
    return stream.getvalue().replace(b"(10, 478, 3)", b"(99999999, 478, 3)")


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"", "the file is cut short or no .npz archive"),
        (pickle.dumps([1]), "the file is cut short or no .npz archive"),
        (archive("weights.npy", b""), "the file has no array landmarks"),
        (archive("landmarks.npy", b"numbers"), "the array landmarks is not an array file"),
        (archive("landmarks.npy", pickled()), "the array landmarks has a header that is not that of a plain array"),
        (archive("landmarks.npy", huge()), "the array landmarks"),
        (archive("landmarks.npy", bytes((1 << 28) + 1)), "would unpack to 256 MiB, which no recording needs"),
    ],
)
def test_a_broken_archive_is_told_in_one_sentence(tmp_path: Path, data: bytes, says: str) -> None:
    path = tmp_path / "a.npz"
    path.write_bytes(data)
    with pytest.raises(ProjectError) as raised:
        read_recording(path)
    assert says in str(raised.value)
    assert "write it again as frames of 468 or 478 points x, y, z" in str(raised.value)
    assert str(raised.value).count("\n") == 0


def test_a_damaged_byte_is_noticed(tmp_path: Path, points: np.ndarray) -> None:
    whole = bytearray(npz(tmp_path / "a.npz", landmarks=points).read_bytes())
    whole[len(whole) // 2] ^= 0xFF
    (tmp_path / "a.npz").write_bytes(whole)
    with pytest.raises(ProjectError, match="the array landmarks is damaged"):
        read_recording(tmp_path / "a.npz")


@pytest.mark.parametrize(
    ("shape", "says"),
    [
        ((6, 68, 3), "holds 6 × 68 × 3 numbers of landmarks"),
        ((6, 478, 2), "holds 6 × 478 × 2 numbers of landmarks"),
        ((478, 3), "holds 478 × 3 numbers of landmarks"),
        ((0, 478, 3), "shows no face in any of its frames"),
        ((6, 478, 3), "shows no face in any of its frames"),
    ],
)
def test_landmarks_of_another_kind_are_told(tmp_path: Path, shape: tuple[int, ...], says: str) -> None:
    with pytest.raises(ProjectError, match=says):
        read_recording(npz(tmp_path / "a.npz", landmarks=np.zeros(shape)))


def test_what_contradicts_itself_is_told(tmp_path: Path, points: np.ndarray) -> None:
    with pytest.raises(ProjectError, match="has not one time for each of its 6 frames"):
        read_recording(npz(tmp_path / "a.npz", landmarks=points, times=np.arange(5.0)))
    with pytest.raises(ProjectError, match="goes back in time"):
        read_recording(npz(tmp_path / "a.npz", landmarks=points, times=np.array([0, 1, 2, 1, 3, 4.0])))
    lacking = points.copy()
    lacking[:, 3] = np.nan
    with pytest.raises(ProjectError, match="has a point without a number in every frame"):
        read_recording(npz(tmp_path / "a.npz", landmarks=lacking))
    with pytest.raises(ProjectError, match=r"weights over time are in \.csv, \.json, \.fap files"):
        read_capture(tmp_path / "a.npz")


@pytest.mark.parametrize(
    ("raw", "says"),
    [
        ('{"landmarks": 3}', "holds no list of frames"),
        ('{"landmarks": []}', "holds no list of frames"),
        ('{"landmarks": [', "is no JSON"),
        ('[{"landmarks": "no"}]', "frame 1 is no list of points"),
        ('[{"landmarks": [[1, 2]]}]', "frame 1 says “.1, 2.” where a point x, y, z has to be"),
        ('[{"landmarks": [[1, 2, "far"]]}]', "frame 1 says “far” where a number has to be"),
        (
            '[{"landmarks": [[1, 2, 3]]}, {"landmarks": [[1, 2, 3], [1, 2, 3]]}]',
            "frame 2 has 2 points and those before",
        ),
        ('[{"landmarks": [[1, 2, 3]]}]', "holds 1 × 1 × 3 numbers of landmarks"),
    ],
)
def test_broken_json_is_told_in_one_sentence(tmp_path: Path, raw: str, says: str) -> None:
    path = tmp_path / "a.json"
    path.write_text(raw)
    with pytest.raises(ProjectError, match=says):
        read_recording(path)
