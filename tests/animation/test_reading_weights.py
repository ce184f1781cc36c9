"""Weights from other programs: read as they are meant, gaps bridged and told, damage named in one sentence."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.animation.capture import Capture
from facemodel.animation.clip import Animation
from facemodel.animation.evaluation import Evaluator
from facemodel.animation.mapping import Mapping, MapRow, default_mapping, mapped, with_row, without_row
from facemodel.errors import ProjectError
from facemodel.facs import action_units
from facemodel.io.weights import read_capture
from facemodel.io.weights.arkit_json import read_arkit_json
from facemodel.io.weights.live_link import read_live_link
from facemodel.io.weights.mapping_file import load_mapping, save_mapping
from facemodel.io.weights.names import ARKIT, TURNS, arkit_name, live_link_name
from facemodel.io.weights.openface import read_openface
from facemodel.io.weights.plain import read_plain

UNITS = action_units()
GOLDEN = Path(__file__).parent / "golden"
TRACKS = Path(__file__).resolve().parents[3] / "shared" / "data" / "tracks"


def column(capture: Capture, name: str) -> list[float]:
    return [round(float(value), 5) for value in capture.values[:, capture.channels.index(name)]]


def golden(name: str, rate: float | None = None) -> Capture:
    return read_capture(GOLDEN / name, UNITS, rate)


def test_openface_is_read_with_unsure_frames_bridged_and_eyes_seen_from_the_head() -> None:
    capture = golden("openface.csv")
    assert (capture.kind, capture.rate, len(capture.values)) == ("openface", 25.0, 4)
    assert column(capture, "AU12_r") == [0.0, 2.5, 3.75, 5.0]
    assert column(capture, "head.yaw") == [0.0, pytest.approx(11.459, abs=1e-3), pytest.approx(5.73, abs=1e-2), 0.0]
    assert column(capture, "head.pitch")[1] == pytest.approx(-5.73, abs=1e-2)
    assert column(capture, "eyeR.yaw")[1] == pytest.approx(-11.459, abs=1e-3)
    assert column(capture, "eyeL.yaw")[3] == pytest.approx(5.71, abs=1e-2)
    assert capture.notes == (
        "In 1 of 4 frames no face was found for sure; they were bridged.",
        "In 1 of 4 frames numbers are missing and were bridged.",
    )


def test_live_link_is_read_whatever_the_case_across_midnight_and_with_frames_missing() -> None:
    capture = golden("live_link.csv")
    assert (capture.kind, capture.rate, len(capture.values)) == ("live-link", 30.0, 5)
    assert capture.channels == (
        "JawOpen",
        "MouthSmileLeft",
        "MouthSmileRight",
        "EyeBlinkLeft",
        "HeadYaw",
        "LeftEyePitch",
    )
    assert column(capture, "JawOpen") == [0.1, 0.2, 0.3, 0.4, 0.5]
    assert capture.notes[-1] == "1 of 5 frames are missing and were bridged."
    assert "48 of ARKit’s 52 channels are not in it" in capture.notes[0]


def test_mediapipe_and_matrices_of_weights_are_read() -> None:
    mediapipe, matrix = golden("mediapipe.json"), golden("audio2face.json")
    assert (mediapipe.kind, mediapipe.rate) == ("arkit", 25.0)
    assert column(mediapipe, "JawOpen") == [0.25, 0.5]
    assert column(mediapipe, "BrowInnerUp") == [0.0, 0.75]
    assert (matrix.rate, column(matrix, "MouthPucker")) == (60.0, [0.125, 0.25, 0.5])


@pytest.mark.parametrize(
    "text",
    [
        '{"fps": 50, "jawOpen": [0, 0.5], "mouthFunnel": [1, 0]}',
        '{"fps": 50, "frames": [{"blendshapes": {"jawOpen": 0, "mouthFunnel": 1}}, {"blendshapes": {"jawOpen": 0.5}}]}',
        '[{"time": 0, "jawOpen": 0, "mouthFunnel": 1}, {"time": 0.02, "jawOpen": 0.5, "mouthFunnel": 0}]',
        '{"fps": 50, "names": ["jawOpen", "mouthFunnel"], "frames": [[0, 1], [0.5, 0]]}',
        '{"rate": 50, "data": [[{"name": "jawOpen", "value": 0}], [{"name": "jawOpen", "value": 0.5}]]}',
    ],
)
def test_json_is_read_in_all_its_shapes(text: str) -> None:
    capture = read_arkit_json(text.encode())
    assert (capture.rate, column(capture, "JawOpen")) == (50.0, [0.0, 0.5])


def test_a_plain_table_names_action_units_in_any_way() -> None:
    capture = golden("weights.csv")
    assert (capture.rate, capture.channels) == (25.0, ("12L", "26", "12R", "head.yaw"))
    assert column(capture, "12R") == [0.25, 0.25, 0.25]
    assert capture.notes == (
        "Columns that this face has nothing for were left out: unheard of.",
        "In 1 of 3 frames numbers are missing and were bridged.",
    )


def test_mpeg4_parameters_are_read_in_their_units() -> None:
    capture = golden("small.fap")
    assert (capture.kind, capture.rate, capture.channels) == (
        "fap",
        25.0,
        ("open_jaw", "stretch_l_cornerlip", "head_yaw"),
    )
    assert column(capture, "open_jaw") == [0, 200, 400]
    assert column(capture, "stretch_l_cornerlip") == [0, -50, -50]
    found = {t.channel: t for t in mapped(capture, default_mapping("fap"), UNITS).tracks}
    assert found["head.yaw"].captured.values[1] == pytest.approx(10.0, abs=0.01)  # type: ignore[union-attr]
    assert found["26"].captured.values[2] == pytest.approx(0.472, abs=1e-3)  # type: ignore[union-attr]


def test_a_rate_that_is_given_counts_frames_and_looks_at_no_times() -> None:
    capture = golden("openface.csv", rate=50.0)
    assert (capture.rate, len(capture.values)) == (50.0, 4)
    assert golden("small.fap", rate=50.0).notes == ("It says 25 frames a second and was taken as 50.",)


def lines(name: str) -> list[str]:
    return (GOLDEN / name).read_text().splitlines()


def damaged(name: str, change: Callable[[list[str]], list[str]]) -> bytes:
    return "\n".join(change(lines(name))).encode()


def swapped(at: int, old: str, new: str) -> Callable[[list[str]], list[str]]:
    return lambda rows: [row.replace(old, new) if k == at else row for k, row in enumerate(rows)]


@pytest.mark.parametrize(
    ("name", "change", "says"),
    [
        ("openface.csv", swapped(4, "0.120", "0.010"), "line 5 goes back in time, from 0.080 s to 0.010 s"),
        ("openface.csv", swapped(0, "_r", "_x"), "names nothing that this face can do"),
        ("openface.csv", swapped(2, "2.5", "lots"), "line 3 says “lots” under AU12_r, which is no number"),
        ("live_link.csv", swapped(2, "23:59:59:29.000", "noon"), "line 3 says “noon”, which is no timecode"),
        ("live_link.csv", swapped(0, "MouthSmileRight", "jawOpen"), "line 1 has the column “jawopen” twice"),
        ("live_link.csv", swapped(2, "0.60000000,0.25000000,", ""), "line 3 has 6 cells and the heading 8"),
        ("live_link.csv", lambda rows: rows[:1], "has a heading and no line of numbers"),
        ("live_link.csv", lambda rows: [], "the file is empty"),
        ("weights.csv", swapped(0, "12L,AU26,lip corner puller R,head.yaw", "a,b,c,d"), "names nothing that this face"),
        ("small.fap", lambda rows: rows[:-1], "frame 2 is where it ends, and it should have 3 frames"),
        ("small.fap", lambda rows: rows[:4], "frame 1 is where it ends"),
        ("small.fap", swapped(1, "2.1 small 25 3", "hello"), "line 1 is not a version"),
        ("small.fap", swapped(5, "1 200 -50 17453", "1 200"), "frame 1 gives 1 values for 3 marks"),
        ("small.fap", swapped(4, "0 0 1", "0 0 7"), "frame 1 has no line of 68 marks"),
        ("mediapipe.json", lambda rows: rows[:2], "is no JSON"),
        ("mediapipe.json", swapped(2, "0.75", '"high"'), "frame 2 says “high” where a number has to be"),
        ("mediapipe.json", lambda rows: ["{}"], "holds no list of frames"),
        ("mediapipe.json", lambda rows: ['[{"smile": 1}]'], "names no blend shape of ARKit"),
        ("audio2face.json", swapped(0, "[0.25, 0.25]", "[0.25]"), "frame 2 has 1 weights and there are 2 names"),
    ],
)
def test_damage_is_said_in_one_sentence(
    tmp_path: Path, name: str, change: Callable[[list[str]], list[str]], says: str
) -> None:
    path = tmp_path / name
    path.write_bytes(damaged(name, change))
    with pytest.raises(ProjectError) as caught:
        read_capture(path, UNITS)
    sentence = str(caught.value)
    assert says in sentence
    assert f"“{path}” cannot be read" in sentence
    assert sentence.endswith(".")
    assert "\n" not in sentence


def test_the_wrong_kind_of_file_a_missing_one_and_an_impossible_rate_are_named(tmp_path: Path) -> None:
    for path, rate, says in (
        (tmp_path / "a.txt", None, "are in .csv, .json, .fap files"),
        (tmp_path / "a.csv", None, "there is no such file"),
        (GOLDEN / "weights.csv", 0.0, "cannot have 0 frames a second"),
    ):
        with pytest.raises(ProjectError, match=says):
            read_capture(path, UNITS, rate)


def test_a_recording_that_was_cut_off_keeps_all_whole_frames() -> None:
    data = "\n".join(lines("live_link.csv")).encode()
    capture = read_live_link(data[:-30])
    assert column(capture, "JawOpen") == [0.1, 0.2, 0.3]
    assert "Line 5, the last one, is cut short and was left out." in capture.notes


def test_frames_without_a_face_are_bridged() -> None:
    rows = lines("live_link.csv")
    rows[2] = rows[2].split(",")[0] + ",0"
    capture = read_live_link("\n".join(rows).encode())
    assert column(capture, "JawOpen")[:3] == [0.1, 0.2, 0.3]
    assert any("frames numbers are missing" in note for note in capture.notes)


@given(st.integers(20, 60), st.sampled_from([24.0, 25.0, 29.97, 30.0, 59.94, 60.0, 120.0]), st.data())
def test_numbers_that_are_there_are_kept_whatever_frames_are_missing(
    count: int, rate: float, data: st.DataObject
) -> None:
    gone = data.draw(st.sets(st.integers(1, count - 2), max_size=count // 6))
    values = np.arange(count) / count
    rows = [f"{k / rate:.4f},{values[k]:.6f}" for k in range(count) if k not in gone]
    capture = read_plain("\n".join(["time,12L", *rows]).encode(), UNITS)
    # A few frames cannot tell 30 from 29.97.
    assert capture.rate == pytest.approx(rate, rel=0.0015)
    assert capture.values[:, 0] == pytest.approx(values, abs=1e-5)


def test_a_gap_does_not_make_another_rate_of_what_is_left() -> None:
    rows = [f"{k / 29.97:.4f},{k}" for k in range(55) if not 1 <= k <= 9]
    capture = read_plain("\n".join(["time,12L", *rows]).encode(), UNITS)
    assert capture.rate == pytest.approx(29.97, rel=0.0015)
    assert capture.values[:, 0] == pytest.approx(np.arange(55), abs=1e-5)


def test_stamps_of_milliseconds_mean_a_common_rate() -> None:
    rows = [f"{int(k * 1000 / 30)},{k}" for k in range(90)]
    capture = read_live_link("\n".join(["timestamp_ms,jawOpen", *rows]).encode())
    assert (capture.rate, len(capture.values), capture.notes[1:]) == (30.0, 90, ())


def test_uneven_times_are_sampled_anew() -> None:
    stamps = np.sort(np.random.default_rng(0).uniform(0, 4, 100))
    capture = read_plain("\n".join(["time,12L", *(f"{t:.5f},{t / 4:.5f}" for t in stamps)]).encode(), UNITS)
    at = capture.start + np.arange(len(capture.values)) / capture.rate
    assert np.abs(capture.values[:, 0] - at / 4).max() < 0.01
    assert any("sampled anew" in note for note in capture.notes)


def test_impossible_times_are_counted_instead() -> None:
    rows = [f"{k * 0.001:.3f},{k}" for k in range(50)]
    capture = read_plain("\n".join(["time,12L", *rows]).encode(), UNITS)
    assert capture.rate == 30.0
    assert "1000 frames a second, which no camera takes" in capture.notes[0]


def test_of_several_faces_the_first_is_taken() -> None:
    rows = lines("openface.csv")
    other = [row.replace(", 0, 0.0", ", 1, 0.0", 1) for row in rows[1:]]
    capture = read_openface(
        "\n".join([rows[0], *(line for pair in zip(rows[1:], other, strict=True) for line in pair)]).encode()
    )
    assert len(capture.values) == 4
    assert "It has 2 faces; the first one was taken." in capture.notes


@pytest.mark.parametrize("name", [*ARKIT, *TURNS])
def test_names_are_known_in_any_spelling(name: str) -> None:
    snake = "".join(f"_{letter.lower()}" if letter.isupper() else letter for letter in name).lstrip("_")
    for spelled in (name, name.upper(), arkit_name(name), snake, f"blendShape1.{name}"):
        assert live_link_name(spelled) == name


@pytest.mark.parametrize("name", ["openface.csv", "live_link_face.csv"])
def test_real_recordings_play_on_a_face(name: str) -> None:
    if not (TRACKS / name).exists():
        pytest.skip(f"{TRACKS / name} is not there")
    capture = read_capture(TRACKS / name, UNITS)
    found = mapped(capture, default_mapping(capture.kind), UNITS)
    values = Evaluator(Animation(found.tracks), UNITS).at(np.linspace(0, capture.duration, 50))
    assert len(found.tracks) >= 20
    assert np.isfinite(values).all()
    assert len(capture.notes) >= 1


@pytest.mark.filterwarnings("error")
def test_a_number_beyond_all_measure_is_held_at_the_end_of_its_range() -> None:
    capture = read_plain(b"time,1L\n0,0.5\n1,1e300\n", UNITS)
    assert np.isfinite(capture.values).all()
    (track,) = mapped(capture, default_mapping("plain"), UNITS).tracks
    assert track.captured.values == pytest.approx([0.5, 2.0])  # type: ignore[union-attr]


def test_rows_of_a_table_have_gains_offsets_caps_and_are_summed() -> None:
    values = np.array([[0.0, 1.0], [0.5, 1.0], [1.0, 1.0]], dtype=np.float32)
    capture = Capture("arkit", ("JawOpen", "MouthSmileLeft"), values, 30.0, 2.0)
    table = Mapping(
        "mine",
        (
            MapRow("JawOpen", "26", 0.5),
            MapRow("JawOpen", "26", 2.0, offset=0.25, cap=0.6),
            MapRow("MouthSmileLeft", "12", 0.7),
            MapRow("JawOpen", "head.yaw", 10.0, centred=True),
            MapRow("JawOpen", "tail"),
        ),
    )
    found = mapped(capture, table, UNITS)
    tracks = {track.channel: track.captured for track in found.tracks}
    assert tracks["26"].values == pytest.approx([0.0, 0.75, 1.1])  # type: ignore[union-attr]
    assert tracks["12L"].values == pytest.approx([0.7] * 3)  # type: ignore[union-attr]
    assert tracks["head.yaw"].values == pytest.approx([-5, 0, 5])  # type: ignore[union-attr]
    assert tracks["26"].start == 2.0  # type: ignore[union-attr]
    assert found.notes == ("This face has no action unit for JawOpen; what was captured of it is left out.",)
    fitting = without_row(with_row(table, 0, MapRow("JawOpen", "27")), 4)
    assert [row.target for row in fitting.rows] == ["27", "26", "12", "head.yaw"]
    nothing = mapped(capture, Mapping("other", (MapRow("AU12_r", "12"),)), UNITS)
    assert "has no row for any of its channels" in nothing.notes[0]


def test_smoothing_calms_every_channel() -> None:
    noise = np.random.default_rng(1).uniform(0, 1, (200, 1)).astype(np.float32)
    capture = Capture("plain", ("12L",), noise, 30.0)
    rough, smooth = (mapped(capture, Mapping("m", (), smoothing), UNITS).tracks[0].captured for smoothing in (0.0, 0.2))
    assert smooth.values.std() < rough.values.std() / 3  # type: ignore[union-attr]


def test_a_table_is_kept_in_a_file_that_people_can_edit(tmp_path: Path) -> None:
    path = tmp_path / "table.json"
    for kind in ("arkit", "live-link", "openface", "fap"):
        save_mapping(default_mapping(kind), path)
        assert load_mapping(path) == default_mapping(kind)
    path.write_text(path.read_text().replace('"gain": ', '"gain": "', 1))
    with pytest.raises(ProjectError, match="cannot be read"):
        load_mapping(path)
    path.write_text('{"format": "risorius-mapping", "name": "a", "rows": [{"source": "x"}]}')
    with pytest.raises(ProjectError, match=r"rows\[0\]\.target"):
        load_mapping(path)
