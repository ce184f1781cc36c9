"""Captures, phonemes and sounds come in and weights go out; what is wrong is said in one sentence, nothing is lost."""

import struct
from pathlib import Path

import numpy as np
import pytest

from app.actions import Context
from app.actions.action import perform
from app.document import Document
from app.palette import rank
from app.timeline.exchange import Again, Exchange, exchange_actions
from app.timeline.sounds import SoundShelf
from app.timeline.timeline import Timeline
from facemodel.animation.capture import Capture
from facemodel.animation.sound import Sound
from facemodel.io.audio import read_sound, write_sound
from facemodel.io.weights.writing import WEIGHT_EXPORTS
from facemodel.solve import solve_project
from tests.app.desk import Desk


class Asked:
    """Dialogs that were opened."""

    def __init__(self) -> None:
        self.captures: list[tuple[Capture, Path]] = []
        self.opened: list[str] = []

    def map_capture(self, capture: Capture, path: Path, again: Again) -> None:
        self.captures.append((capture, path))
        self.again = again

    def type_speech(self) -> None:
        self.opened.append("speech")

    def edit_visemes(self) -> None:
        self.opened.append("visemes")


@pytest.fixture
def asked() -> Asked:
    return Asked()


@pytest.fixture
def exchange(timeline: Timeline, context: Context, asked: Asked):
    made = Exchange(timeline, context, asked)
    yield made
    made.close()


@pytest.fixture
def act(exchange: Exchange, timeline: Timeline, context: Context):
    actions = {action.id: action for action in exchange_actions(lambda: exchange, timeline)}

    def perform_one(key: str, path: Path | None = None) -> None:
        context.host.path = path
        perform(actions[key], context)

    return perform_one


def test_a_capture_is_read_and_its_table_shown(act, asked: Asked, tmp_path: Path) -> None:
    file = tmp_path / "take.csv"
    file.write_text("time,12L,17\n0,0,0.1\n0.1,0.5,0.1\n0.2,1,0.1\n")
    act("timeline.import", file)
    ((capture, path),) = asked.captures
    assert (capture.kind, capture.channels, path) == ("plain", ("12L", "17"), file)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("take.csv", ""),
        ("take.csv", "time,12L\n0,a lot\n"),
        ("take.csv", "time,12L\n1,0\n0,0\n"),
        ("take.json", "{"),
        ("take.fap", "2.1 clip 25 10\n1 1"),
        ("take.txt", "12L"),
    ],
)
def test_a_broken_capture_is_told_in_one_sentence_and_changes_nothing(
    act, asked: Asked, desk: Desk, document: Document, tmp_path: Path, name: str, text: str
) -> None:
    before = document.project
    file = tmp_path / name
    file.write_text(text)
    act("timeline.import", file)
    (sentence,) = desk.errors
    assert name in sentence
    assert sentence.count("\n") == 0
    assert asked.captures == []
    assert document.project is before


def test_thinking_better_of_it_does_nothing(act, asked: Asked, desk: Desk, document: Document) -> None:
    for key in ("timeline.import", "timeline.import-speech", "timeline.import-sound", "timeline.export.weights"):
        act(key)
    assert document.history.done == ()
    assert asked.captures == []
    assert len(desk.questions) == 4


def test_phonemes_are_said_from_the_playhead_on(act, timeline: Timeline, tmp_path: Path) -> None:
    file = tmp_path / "line.tsv"
    file.write_text("0.00\tA\n0.20\tD\n0.40\tX\n")
    timeline.playhead.go(2.0)
    act("timeline.import-speech", file)
    assert timeline.document.history.done == ("Import phonemes",)
    assert timeline.animation.speech.phonemes[-1].start >= 2.0


def test_a_sound_plays_along_from_the_playhead_on(act, timeline: Timeline, desk: Desk, tmp_path: Path) -> None:
    file = tmp_path / "line.wav"
    write_sound(Sound(np.zeros((4000, 1), np.float32), 8000), file)
    timeline.playhead.go(1.0)
    act("timeline.import-sound", file)
    audio = timeline.animation.audio
    assert audio is not None
    assert (audio.path, audio.start) == (file.as_posix(), 1.0)
    file.write_bytes(b"RIFF")
    act("timeline.import-sound", file)
    assert len(desk.errors) == 1


@pytest.mark.parametrize("kind", ["weights", "arkit", "live-link"])
def test_weights_are_written_as_they_are_seen(act, desk: Desk, tmp_path: Path, kind: str) -> None:
    file = tmp_path / "clip.csv"
    act(f"timeline.export.{kind}", file)
    assert desk.errors == []
    assert len(file.read_text().splitlines()) > 100


def test_weights_leave_by_the_page_of_the_menu_and_are_found_by_name(exchange: Exchange, timeline: Timeline) -> None:
    actions = exchange_actions(lambda: exchange, timeline)
    exports = [action for action in actions if action.id.startswith("timeline.export.")]
    assert len(exports) == len(WEIGHT_EXPORTS)
    assert not any(action.menu for action in exports)
    for query in ("export live link", "export arkit", "mpeg"):
        assert rank(query, actions)[0].action in exports


def test_what_cannot_be_measured_on_this_face_is_said(act, document: Document, desk: Desk, tmp_path: Path) -> None:
    act("timeline.export.fap", tmp_path / "clip.fap")
    document.accept(solve_project(document.project), document.project)
    act("timeline.export.fap", tmp_path / "clip.fap")
    unsolved, unmeasured = desk.errors
    assert "solve the face first" in unsolved
    assert "landmarks" in unmeasured
    assert not (tmp_path / "clip.fap").exists()


def test_a_still_face_has_nothing_to_export(act, document: Document, desk: Desk, project, tmp_path: Path) -> None:
    document.restore(project, None)
    act("timeline.export.weights", tmp_path / "clip.csv")
    assert desk.questions == []


def test_typing_and_visemes_open_their_dialogs(act, asked: Asked) -> None:
    act("timeline.type-speech")
    act("timeline.visemes")
    assert asked.opened == ["speech", "visemes"]


@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize("there", [20, 21, 4000])
def test_of_a_sound_that_is_cut_short_what_is_there_plays_and_it_is_said(
    act, timeline: Timeline, desk: Desk, tmp_path: Path, channels: int, there: int
) -> None:
    file = tmp_path / "voice.wav"
    write_sound(Sound(np.full((4000, channels), 0.5, np.float32), 8000), file)
    written = file.read_bytes()
    head = written.index(b"data") + 4
    promised = struct.pack("<I", 2_000_000_000)
    file.write_bytes(written[:head] + promised + written[head + 4 : head + 4 + there])
    act("timeline.import-sound", file)
    sound = read_sound(file)
    assert len(sound.samples) == there // (2 * channels)
    assert sound.missing == pytest.approx((2_000_000_000 - there) / (16_000 * channels))
    assert timeline.animation.audio is not None
    assert len(desk.messages[-1].split(". ")) == 1
    assert desk.messages[-1].startswith("“voice.wav” is cut short: 0.")
    assert desk.messages[-1].endswith("s are there and play; save it again for the rest.")


@pytest.mark.parametrize("size", [0xFFFF_FFFF, 8000])
def test_a_sound_of_which_nothing_is_missing_or_said_comes_in_without_a_word(tmp_path: Path, size: int) -> None:
    file = tmp_path / "voice.wav"
    write_sound(Sound(np.full((4000, 1), 0.5, np.float32), 8000), file)
    written = file.read_bytes()
    head = written.index(b"data") + 4
    file.write_bytes(written[:head] + struct.pack("<I", size) + written[head + 4 :])
    sound = read_sound(file)
    assert (len(sound.samples), sound.missing) == (4000, 0.0)


def test_the_shelf_reads_the_sound_of_the_animation(timeline: Timeline, act, tmp_path: Path) -> None:
    shelf = SoundShelf(timeline.document)
    assert "voice.wav" in shelf.complaint
    file = tmp_path / "line.wav"
    write_sound(Sound(np.full((4000, 1), 0.5, np.float32), 8000), file)
    act("timeline.import-sound", file)
    assert shelf.sound is not None
    assert shelf.sound.duration == 0.5
    assert shelf.complaint == ""
    timeline.document.undo()
    assert shelf.sound is None
    shelf.close()
