"""Phonemes from other programs, and sounds: read as they are meant, damage named in one sentence."""

import codecs
from collections.abc import Callable
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.io import wavfile

from facemodel.animation.editing.speech import unknown_symbols
from facemodel.animation.sound import FINEST, Sound, resampled, voiced_span, waveform
from facemodel.animation.speech import Speech
from facemodel.errors import ProjectError
from facemodel.io.audio import read_sound, sound_of, write_sound
from facemodel.io.damage import DamageError
from facemodel.io.speech import Spoken, read_speech

GOLDEN = Path(__file__).parent / "golden"

SHAPES = [("sil", 0.0, 0.25), ("SS", 0.25, 0.41), ("PP", 0.41, 0.5), ("aa", 0.5, 0.75), ("sil", 0.75, 0.85)]


def sounds(spoken: Spoken) -> list[tuple[str, float, float]]:
    return [(s.symbol, pytest.approx(s.start), pytest.approx(s.end)) for s in spoken.phonemes]


@pytest.mark.parametrize("name", ["rhubarb.tsv", "rhubarb.json", "rhubarb.xml"])
def test_rhubarb_says_the_same_in_all_its_formats(name: str) -> None:
    assert sounds(read_speech(GOLDEN / name)) == SHAPES


def test_papagayo_counts_frames_from_one() -> None:
    spoken = read_speech(GOLDEN / "papagayo.dat")
    expected = [("sil", 0, 6), ("DD", 6, 10), ("PP", 10, 12), ("aa", 12, 18), ("sil", 18, 21)]
    assert sounds(spoken) == [(name, start / 24, end / 24) for name, start, end in expected]
    assert "24" in spoken.notes[0]
    assert read_speech(GOLDEN / "papagayo.dat", rate=30.0).phonemes[-1].end == pytest.approx(21 / 30)


def test_a_long_textgrid_has_sounds_and_words() -> None:
    spoken = read_speech(GOLDEN / "long.TextGrid")
    assert sounds(spoken) == [("sil", 0, 0.25), ("M", 0.25, 0.5), ("AA1", 0.5, 0.75), ("sil", 0.75, 0.85)]
    assert [(word.text, word.start, word.end) for word in spoken.words] == [('say "ma"', 0.25, 0.75)]


def test_a_short_textgrid_is_read_in_any_encoding(tmp_path: Path) -> None:
    text = (GOLDEN / "short.TextGrid").read_text("utf-8")
    expected = [("sil", 0, 0.25), ("m", 0.25, 0.5), ("ɑː", 0.5, 0.85)]
    for data in (
        text.encode(),
        codecs.BOM_UTF8 + text.encode(),
        codecs.BOM_UTF16_BE + text.encode("utf-16-be"),
        text.replace("\n", "\r\n").encode(),
    ):
        path = tmp_path / "a.TextGrid"
        path.write_bytes(data)
        assert sounds(read_speech(path)) == expected


def test_every_symbol_of_the_golden_files_is_seen() -> None:
    for path in GOLDEN.iterdir():
        if path.suffix in (".TextGrid", ".tsv", ".xml", ".dat"):
            assert unknown_symbols(Speech(read_speech(path).phonemes)) == ()


@pytest.mark.parametrize(
    ("name", "change", "says"),
    [
        ("rhubarb.tsv", lambda t: t.replace("0.50", "0.30"), "goes back in time"),
        ("rhubarb.tsv", lambda t: t.replace("D", "Q"), "the mouth shape “Q”"),
        ("rhubarb.tsv", lambda t: t.replace("0.25", "soon"), "“soon” where a time has to be"),
        ("rhubarb.tsv", lambda t: "", "has no mouth shape"),
        ("rhubarb.json", lambda t: t[:-20], "is no JSON"),
        ("rhubarb.json", lambda t: '{"cues": []}', "no list “mouthCues”"),
        ("rhubarb.json", lambda t: t.replace('"end": 0.50', '"stop": 0.5'), "mouthCues[2] has no start, end and value"),
        ("rhubarb.xml", lambda t: t[:-20], "is no XML"),
        ("rhubarb.xml", lambda t: t.replace("?>", '?><!DOCTYPE a [<!ENTITY b "c">]>', 1), "declares entities"),
        ("rhubarb.xml", lambda t: t.replace('end="0.50"', 'end="0.1"'), "ends before it begins"),
        ("papagayo.dat", lambda t: t.replace("13 AI", "9 AI"), "line 5 goes back in time"),
        ("papagayo.dat", lambda t: t.replace("AI", "AAA"), "“AAA”, which Preston Blair has not"),
        ("papagayo.dat", lambda t: t.replace("MohoSwitch1", "Moho"), "line 1 is not “MohoSwitch1”"),
        ("papagayo.dat", lambda t: t[:12], "has no mouth shape"),
        ("long.TextGrid", lambda t: t[:700], "is cut short"),
        ("long.TextGrid", lambda t: t.replace("xmax = 0.5\n", "xmax = 0.1\n"), "tier 3, interval 2 goes back in time"),
        ("long.TextGrid", lambda t: t.replace('text = "M"', "text = 5"), "“5” where text in quotes has to be"),
        ("short.TextGrid", lambda t: t.replace("<exists>", "<absent>"), "has no tier of intervals"),
        ("short.TextGrid", lambda t: t.replace("TextGrid", "Spectrum"), "is not a time and a mouth shape"),
    ],
)
def test_damage_is_said_in_one_sentence(tmp_path: Path, name: str, change: Callable[[str], str], says: str) -> None:
    path = tmp_path / name
    path.write_text(change((GOLDEN / name).read_text("utf-8")), "utf-8")
    with pytest.raises(ProjectError) as caught:
        read_speech(path)
    sentence = str(caught.value)
    assert says in sentence
    assert f"“{path}” cannot be read" in sentence
    assert sentence.endswith(".")
    assert "\n" not in sentence


@given(st.binary(max_size=400))
def test_no_bytes_at_all_are_more_than_damage(data: bytes) -> None:
    from facemodel.io.speech.moho import read_moho
    from facemodel.io.speech.rhubarb import read_rhubarb_json, read_rhubarb_tsv, read_rhubarb_xml
    from facemodel.io.speech.textgrid import read_textgrid

    for read in (read_moho, read_rhubarb_json, read_rhubarb_tsv, read_rhubarb_xml, read_textgrid):
        try:
            read(data)
        except DamageError:
            continue


def wav(samples: np.ndarray, rate: int = 16000) -> bytes:
    stream = BytesIO()
    wavfile.write(stream, rate, samples)
    return stream.getvalue()


@pytest.mark.parametrize("kind", [np.uint8, np.int16, np.int32, np.float32, np.float64])
def test_a_wav_is_read_whatever_its_samples(kind: type) -> None:
    wave = np.sin(np.linspace(0, 50, 4000)) * 0.5
    if kind is np.uint8:
        samples = np.rint(wave * 127 + 128).astype(kind)
    else:
        samples = (
            np.rint(wave * np.iinfo(kind).max).astype(kind) if np.issubdtype(kind, np.integer) else wave.astype(kind)
        )
    sound = sound_of(wav(samples))
    assert (sound.rate, sound.samples.shape) == (16000, (4000, 1))
    assert sound.samples[:, 0] == pytest.approx(wave, abs=0.01)


def test_stereo_is_kept_and_drawn_as_one(tmp_path: Path) -> None:
    both = np.stack([np.full(1000, 0.5), np.full(1000, -0.25)], axis=1).astype(np.float32)
    path = tmp_path / "a.wav"
    write_sound(Sound(both, 22050), path)
    sound = read_sound(path)
    assert sound.samples == pytest.approx(both, abs=1e-4)
    assert waveform(sound).samples == pytest.approx(np.full(1000, 0.125), abs=1e-4)


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"hello", "is no WAV file"),
        (wav(np.zeros(100, np.int16))[:30], "is cut short or no WAV file"),
        (wav(np.zeros(100, np.int16), 100), "says 100 samples a second, which no recording has"),
        (wav(np.zeros(0, np.int16)), "holds no sound"),
        (wav(np.zeros((10, 40), np.int16)), "has 40 channels"),
    ],
    ids=["text", "cut", "slow", "empty", "wide"],
)
def test_broken_sounds_are_named(tmp_path: Path, data: bytes, says: str) -> None:
    path = tmp_path / "a.wav"
    path.write_bytes(data)
    with pytest.raises(ProjectError, match=says):
        read_sound(path)
    with pytest.raises(ProjectError, match="16-bit PCM"):
        read_sound(tmp_path / "a.mp3")


@given(st.data())
def test_a_wav_cut_anywhere_is_damage_or_a_sound(data: st.DataObject) -> None:
    whole = wav(np.arange(500, dtype=np.int16))
    try:
        sound = sound_of(whole[: data.draw(st.integers(0, len(whole)))])
    except DamageError:
        return
    assert len(sound.samples) <= 500


@given(st.integers(1, 5000), st.floats(-0.1, 0.3), st.floats(0.01, 0.4), st.integers(1, 80))
def test_peaks_enclose_every_sample_of_their_stretch(count: int, start: float, length: float, columns: int) -> None:
    samples = np.random.default_rng(count).uniform(-1, 1, count).astype(np.float32)
    outline = waveform(Sound(samples[:, None], 16000))
    peaks = outline.peaks(start, start + length, columns)
    bounds = (np.linspace(start, start + length, columns + 1) * 16000).astype(np.int64)
    for (low, high), first, last in zip(peaks, bounds[:-1], bounds[1:], strict=True):
        part = samples[max(first, 0) : max(last, 0)]
        if len(part):
            assert low <= part.min() + 1e-6
            assert high >= part.max() - 1e-6
    assert np.all(peaks[:, 0] <= peaks[:, 1])


def test_the_outline_of_a_long_sound_is_small() -> None:
    outline = waveform(Sound(np.zeros((480_000, 1), np.float32), 48000))
    assert sum(level.size for level in outline.levels) < 480_000 / 12
    assert len(outline.levels[0]) == 480_000 // FINEST
    assert outline.duration == 10.0


def test_the_silence_around_a_voice_is_told_from_it() -> None:
    samples = np.zeros((16000, 1), np.float32)
    samples[4000:12000] = np.sin(np.linspace(0, 800, 8000))[:, None]
    samples[:4000] = 0.005
    assert voiced_span(Sound(samples, 16000)) == (pytest.approx(0.25, abs=1e-3), pytest.approx(0.75, abs=1e-3))
    assert voiced_span(Sound(np.zeros((160, 1), np.float32), 16000)) == (0.0, 0.01)


def test_a_sound_of_another_rate_is_still_the_same_sound() -> None:
    times = np.arange(22050) / 22050
    sound = Sound(np.sin(2 * np.pi * 440 * times)[:, None].astype(np.float32), 22050)
    made = resampled(sound, 48000)
    assert made.duration == pytest.approx(1.0)
    then = np.arange(2000, 46000) / 48000
    assert made.samples[2000:46000, 0] == pytest.approx(np.sin(2 * np.pi * 440 * then), abs=0.01)
