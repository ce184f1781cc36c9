"""Scripts animate, import, speak and export; what is imported finds its place; each run is one step."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.authoring.importing import sound_path, with_capture, with_sound, with_spoken
from app.autosave import Autosave
from app.document import Document
from app.scripting import run_script
from app.speech import espeak_program, sounds_of_text, spoken_sound
from app.speech.espeak import SpeechError
from facemodel.animation.capture import Capture
from facemodel.animation.clip import Animation, Audio
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.mapping import Mapping, MapRow
from facemodel.animation.sound import Sound, voiced_span
from facemodel.animation.speech import Phoneme, Word
from facemodel.animation.track import Track
from facemodel.io.audio import read_sound, write_sound
from facemodel.io.project_file import load_project
from facemodel.project import Project

GOLDEN = Path(__file__).resolve().parents[1] / "animation" / "golden"

PERFORMANCE = Capture("plain", ("12L", "26"), np.linspace(0, 1, 120, dtype=np.float32).reshape(60, 2), 25.0, 1.0)


def run(document: Document, text: str) -> str:
    outcome = run_script(text, document)
    assert outcome.error == ""
    return outcome.output.strip()


def test_a_script_makes_an_animation_in_one_step(document: Document) -> None:
    run(
        document,
        "key_expression(0, {})\n"
        "key_expression(1, 'happiness', strength=0.8)\n"
        "key_expression(2, 'surprise')\n"
        "key('head.yaw', 1, 15, shape='linear')\n"
        "idle(seed=3)\n"
        "marker(1, 'smile')\n"
        "play_range(0, 3, loop=True)\n"
        "frame_rate(24)",
    )
    animation = document.project.animation
    assert [each.name for each in animation.expressions] == ["", "happiness", "surprise"]
    assert (animation.rate, animation.end, animation.loop, animation.markers[0].name) == (24, 3, True, "smile")
    assert document.history.done == ("Script",)
    assert run(document, "round(pose_at(1)['12L'], 3)\nprint(round(pose_at(1)['12L'], 3), keys('head.yaw'))") == (
        "0.72 {'head.yaw': ((1.0, 15.0),)}"
    )
    document.undo()
    assert not document.project.animation.moves


def test_a_script_moves_deletes_and_reshapes_keys(document: Document) -> None:
    run(document, "for t in range(5): key('17', t, t % 2)\nmove_keys(0.5, 1, 2)\ndelete_keys(4, 4)")
    curve = document.project.animation.track("17").curve  # type: ignore[union-attr]
    assert curve.times.tolist() == [0, 1.5, 2.5, 3]
    run(document, "bake('17', 30)\nsmooth_curve(0.1, '17')\nsimplify(0.02)")
    track = document.project.animation.track("17")
    assert track is not None
    assert track.captured is None
    assert 4 < len(track.curve) < 60


def test_a_script_drops_moves_and_deletes_expressions(document: Document) -> None:
    group = run(document, "print(drop('Happiness', 1.0, strength=0.5))")
    assert group == "Happiness"
    starts = {event.start for event in document.project.animation.events}
    run(document, f"move_events('{group}', 2)\nprint(drop('surprise', 0))")
    assert {event.start for event in document.project.animation.events if event.group == group} == {3.0} != starts
    run(document, f"delete_events('{group}')")
    assert {event.group for event in document.project.animation.events} == {"Surprise"}
    assert "There is no group of events “tea”" in run_script("move_events('tea', 1)", document).error


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("key('tail', 0, 1)", "nothing called “tail” to animate"),
        ("key('17', float('nan'), 1)", "nan is not possible here"),
        ("marker(1e9)", "1e+09 is not possible here"),
        ("drop('tea', 0)", "There is no emotion “tea”"),
        ("import_weights('nowhere.csv')", "there is no such file"),
        ("export_weights('out.tea')", "files end in .csv"),
    ],
)
def test_what_cannot_be_done_changes_nothing(document: Document, text: str, says: str) -> None:
    assert says in run_script(text, document).error
    assert document.history.done == ()


def test_a_script_imports_speaks_and_exports(document: Document, tmp_path: Path) -> None:
    out = tmp_path / "out.csv"
    sound = tmp_path / "line.wav"
    write_sound(Sound(np.zeros((16000, 1), np.float32), 16000), sound)
    notes = run(
        document,
        f"print(import_weights({str(GOLDEN / 'weights.csv')!r}))\n"
        f"print(import_speech({str(GOLDEN / 'rhubarb.tsv')!r}, time=1.0))\n"
        f"say('M AA1 M', time=3.0)\n"
        f"sound({str(sound)!r})\n"
        f"export_weights({str(out)!r}, 'live-link')",
    )
    assert "unheard of" in notes
    animation = document.project.animation
    assert {track.channel for track in animation.tracks} == {"12L", "12R", "26", "head.yaw"}
    assert [p.symbol for p in animation.speech.phonemes][-3:] == ["M", "AA1", "M"]
    assert animation.audio == Audio(sound.as_posix())
    assert out.read_text().startswith("Timecode,BlendShapeCount,EyeBlinkLeft")
    assert len(document.history.done) == 1


def test_a_capture_decides_length_and_rate_of_a_fresh_project_alone(project: Project) -> None:
    fresh = with_capture(project, PERFORMANCE).project.animation
    assert (fresh.start, fresh.end, fresh.rate) == (1.0, pytest.approx(1 + 59 / 25), 25.0)
    busy = replace(project, animation=Animation((Track("17", curve_of([Key(0, 1)])),), rate=60.0, end=2.0))
    later = with_capture(busy, PERFORMANCE, start=4.0).project.animation
    assert (later.start, later.end, later.rate) == (0.0, pytest.approx(4 + 59 / 25), 60.0)
    assert later.tracks[0] is busy.animation.tracks[0]


def test_a_capture_takes_the_place_of_the_one_before_and_leaves_keys_and_locked_tracks(project: Project) -> None:
    keyed = Track("12L", curve_of([Key(0, 0.1)]), muted=True)
    locked = Track("26", curve_of([Key(0, 0.2)]), locked=True)
    before = replace(project, animation=Animation((keyed, locked)))
    made = with_capture(before, PERFORMANCE).project.animation
    assert made.tracks[0].curve is keyed.curve
    assert made.tracks[0].captured is not None
    assert made.tracks[0].muted
    assert made.tracks[1] is locked


def test_a_table_of_ones_own_is_used(project: Project) -> None:
    table = Mapping("mine", (MapRow("12L", "17", 0.5),))
    tracks = with_capture(project, PERFORMANCE, table).project.animation.tracks
    assert [track.channel for track in tracks] == ["17"]
    nothing = with_capture(project, PERFORMANCE, Mapping("none", (MapRow("x", "17"),)))
    assert nothing.project.animation.tracks == ()
    assert "has no row" in nothing.notes[-1]


def test_speech_takes_the_place_of_what_was_said_there(project: Project) -> None:
    first = with_spoken(project, [Phoneme("M", 0.0, 0.2), Phoneme("??", 0.2, 0.4)], [Word("mm", 0.0, 0.4)], 1.0)
    assert first.notes == ("No viseme is known for ??; the mouth rests there.",)
    assert first.project.animation.end == pytest.approx(1.4)
    second = with_spoken(first.project, [Phoneme("AA", 0.0, 0.3)], (), 1.1)
    assert [p.symbol for p in second.project.animation.speech.phonemes] == ["AA"]
    assert with_spoken(project, ()).project.animation.speech.phonemes == ()


def test_a_sound_is_told_from_the_folder_of_its_project(project: Project, tmp_path: Path) -> None:
    sound = Sound(np.zeros((32000, 1), np.float32), 16000)
    path = tmp_path / "voice" / "line.wav"
    near = with_sound(project, path, sound, tmp_path).animation
    assert near.audio is not None
    assert (near.audio.path, near.end) == ("voice/line.wav", 2.0)
    assert sound_path(near.audio, tmp_path) == path
    far = with_sound(project, path, sound, tmp_path / "elsewhere").animation
    assert far.audio is not None
    assert sound_path(far.audio, None) == path


def test_an_animation_outlives_a_killed_session(document: Document, tmp_path: Path) -> None:
    autosave = Autosave(document, lambda call: call(), tmp_path, delay=0.0)
    document.edit(with_capture(document.project, PERFORMANCE).project, "Import")
    for _ in range(200):
        if list(tmp_path.glob("*.risorius")):
            break
        autosave._thread.join(0.05)
    (kept,) = tmp_path.glob("*.risorius")
    assert load_project(kept).animation.track("12L") is not None
    autosave.close()


needs_espeak = pytest.mark.skipif(espeak_program() is None, reason="eSpeak NG is not installed here")


@needs_espeak
def test_a_text_becomes_sounds_and_words() -> None:
    sounds, words = sounds_of_text("Hello world. My name is Bob!", start=1.0, length=2.5)
    assert sounds[0].start == 1.0
    assert sounds[-1].end == pytest.approx(3.5)
    assert [word.text for word in words] == ["Hello", "world", "My", "name", "is", "Bob"]
    assert "sil" in {sound.symbol for sound in sounds}
    assert any(sound.symbol == "m" for sound in sounds)


@needs_espeak
def test_a_voice_is_written_and_the_mouth_follows_it(document: Document, tmp_path: Path) -> None:
    path = tmp_path / "voice.wav"
    run(document, f"speak('My name is Bob', time=1.0, sound={str(path)!r})")
    animation = document.project.animation
    begin, end = voiced_span(read_sound(path))
    assert animation.audio == Audio(path.as_posix(), 1.0)
    assert animation.speech.phonemes[0].start == pytest.approx(1.0 + begin)
    assert animation.speech.phonemes[-1].end == pytest.approx(1.0 + end)


@needs_espeak
def test_a_text_that_looks_like_an_option_is_only_said() -> None:
    sounds, _ = sounds_of_text("--version -w /tmp/x")
    assert len(sounds) > 5
    assert spoken_sound("hi").duration > 0.2


@needs_espeak
@pytest.mark.parametrize(
    ("text", "voice", "says"),
    [
        ("   ", "en-us", "nothing to say"),
        ("hi", "../../x", "cannot be a voice"),
        ("hi", "xq-zz", "eSpeak"),
        ("a" * 30_000, "en-us", "at most"),
    ],
)
def test_what_cannot_be_said_is_refused_in_a_sentence(text: str, voice: str, says: str) -> None:
    with pytest.raises(SpeechError, match=says):
        sounds_of_text(text, voice=voice)


def test_without_espeak_a_sentence_says_what_to_do(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(SpeechError, match="install eSpeak NG"):
        sounds_of_text("hello")
