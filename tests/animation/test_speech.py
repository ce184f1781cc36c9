"""Lips close on m, b and p, round for oo, open for ah, and consonants behind them take the shape of their vowels."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.animation.clip import Animation
from facemodel.animation.coarticulation import Mouth
from facemodel.animation.editing import speech as editing
from facemodel.animation.evaluation import Evaluator
from facemodel.animation.library import find_expression, placed
from facemodel.animation.speech import Phoneme, Speech, Viseme, VisemeTable, Word, plain
from facemodel.animation.visemes import mouth_table
from facemodel.basis import Basis
from facemodel.cache import solve_cached
from facemodel.facs import action_units
from facemodel.project import Project
from facemodel.projects import new_project

UNITS = action_units()
OPENING = ("25", "26", "27", "22", "10L", "10R", "16L", "16R")


def apart(text: str) -> list[str]:
    return text.split()


ARPABET = apart("AA AE AH AO AW AY B CH D DH EH ER EY F G HH IH IY JH K L M N NG OW OY P R S SH T TH UH UW V W Y Z ZH")
IPA = apart("p b m f v θ ð t d s z ʃ ʒ tʃ dʒ n ŋ l ɹ k g h j w iː ɪ ɛ æ ɑː ʌ ə ɔ ʊ uː ɜː aɪ aʊ oʊ eɪ")


def said(*symbols: str, length: float = 0.1) -> Speech:
    return Speech(tuple(Phoneme(symbol, k * length, (k + 1) * length) for k, symbol in enumerate(symbols)))


def at(speech: Speech, time: float) -> dict[str, float]:
    mouth = Mouth(speech, UNITS)
    return dict(zip(mouth.channels, mouth.at(np.array([time]))[0][0].tolist(), strict=True))


@given(st.lists(st.sampled_from(ARPABET), max_size=6), st.sampled_from("MBP"), st.lists(st.sampled_from(ARPABET)))
def test_lips_meet_on_m_b_and_p_between_any_sounds(before: list[str], closing: str, after: list[str]) -> None:
    speech = said(*before, closing, *after)
    sound = speech.phonemes[len(before)]
    values, closed = Mouth(speech, UNITS).at(np.array([(sound.start + sound.end) / 2]))
    found = dict(zip(Mouth(speech, UNITS).channels, values[0].tolist(), strict=True))
    assert closed[0] == 1.0
    assert max(found.get(name, 0.0) for name in OPENING) == pytest.approx(0.0, abs=1e-9)
    assert found["24"] == pytest.approx(0.3)


def test_an_open_vowel_opens_and_a_rounded_one_rounds() -> None:
    assert at(said("M", "AA", "M", length=0.2), 0.3)["26"] > 0.55
    assert at(said("UW", length=0.2), 0.1)["18L"] > 0.5
    assert at(said("UW", length=0.2), 0.1)["26"] < 0.25


def test_a_consonant_behind_the_lips_takes_the_shape_of_its_vowel() -> None:
    rounded = at(said("UW", "K", "UW"), 0.15)
    spread = at(said("IY", "K", "IY"), 0.15)
    assert rounded["18L"] > 0.4
    assert spread.get("18L", 0.0) < 0.05
    assert spread["20L"] > 0.15


def test_lips_round_before_the_sound_begins() -> None:
    at_start = at(said("T", "T", "UW"), 0.15)["18L"]
    assert at_start > 0.05


def test_the_mouth_is_at_rest_long_before_and_after_and_moves_without_jumps() -> None:
    speech = said(*apart("HH AH L OW M AY N EY M IH Z B AA B"))
    mouth = Mouth(speech, UNITS)
    times = np.arange(-1, 3, 1 / 240)
    values, closed = mouth.at(times)
    assert np.abs(values[[0, -1]]).max() < 1e-3
    assert np.abs(np.diff(values, axis=0)).max() < 0.06
    assert set(np.unique(closed[[0, -1]])) == {0.0}


def test_silence_between_sounds_closes_the_mouth() -> None:
    speech = said("AA", "SIL", "AA", length=0.6)
    assert at(speech, 0.9)["26"] < 0.05 < 0.5 < at(speech, 0.3)["26"]


def test_a_glide_moves_from_one_viseme_to_the_next() -> None:
    speech = said("AY", length=0.4)
    assert at(speech, 0.05)["26"] > 2 * at(speech, 0.35)["26"]


def test_strength_and_mute_scale_what_is_seen() -> None:
    speech = said("AA", length=0.3)
    half = at(replace(speech, strength=0.5), 0.15)["26"]
    assert half == pytest.approx(at(speech, 0.15)["26"] / 2)
    assert Mouth(replace(speech, muted=True), UNITS).channels == ()
    assert Evaluator(Animation(speech=speech)).channels == ()


@given(st.lists(st.sampled_from([*ARPABET, "sil"]), min_size=1, max_size=40))
def test_many_times_and_one_give_the_same(symbols: list[str]) -> None:
    mouth = Mouth(said(*symbols), UNITS)
    times = np.linspace(-0.5, 0.1 * len(symbols) + 0.5, 700)
    together, alone = mouth.at(times), [mouth.at(times[k : k + 1]) for k in range(0, 700, 37)]
    assert together[0][::37] == pytest.approx(np.concatenate([each[0] for each in alone]), abs=1e-9)


@pytest.mark.parametrize(
    "symbol",
    [*ARPABET, *IPA],
)
def test_every_english_sound_is_seen(symbol: str) -> None:
    for stressed in (symbol, symbol + "1" if symbol.isupper() else "ˈ" + symbol):
        assert editing.unknown_symbols(Speech((Phoneme(stressed, 0, 1),))) == ()


@pytest.mark.parametrize("symbol", ["əl", "ˈɪɹ", "ˈoːɹ", "aɪɚ", "ˈʊə"])
def test_sounds_that_are_written_as_one_are_seen_as_what_they_are_made_of(symbol: str) -> None:
    assert editing.unknown_symbols(Speech((Phoneme(symbol, 0, 1),))) == ()


def test_symbols_are_found_without_their_marks() -> None:
    assert plain("ˈiː") == "i"
    assert plain("AH0") == "AH"
    table = VisemeTable(mouth_table().visemes)
    assert table.find("aa1").name == "aa"  # type: ignore[union-attr]
    assert table.find("t̪").name == "TH"  # type: ignore[union-attr]
    assert table.find("Ω") is None
    assert editing.unknown_symbols(said("M", "Ω", "Ω")) == ("Ω",)


def test_own_visemes_take_the_place_of_the_shipped_ones() -> None:
    wide = Viseme("aa", ("AA",), {"27": 0.9}, 1.0)
    animation = editing.with_viseme(Animation(speech=said("AA", length=0.4)), wide)
    assert len(animation.speech.visemes) == len(mouth_table().visemes)
    assert at(animation.speech, 0.2)["27"] > 0.8
    assert editing.with_visemes(animation, mouth_table().visemes).speech.visemes == ()


def test_sounds_are_put_moved_renamed_and_removed() -> None:
    animation = editing.with_phonemes(Animation(), said("M", "AA", "M").phonemes, [Word("mom", 0.0, 0.3)])
    longer = editing.with_bounds(animation, 1, end=0.25)
    assert [(s.symbol, s.start, s.end) for s in longer.speech.phonemes][1:] == [
        ("AA", 0.1, 0.25),
        ("M", 0.25, pytest.approx(0.3)),
    ]
    earlier = editing.with_bounds(longer, 1, start=0.05)
    assert (earlier.speech.phonemes[0].end, earlier.speech.phonemes[1].start) == (0.05, 0.05)
    squeezed = editing.with_bounds(earlier, 1, end=9.0)
    assert squeezed.speech.phonemes[2].end - squeezed.speech.phonemes[2].start == pytest.approx(editing.SHORTEST)
    assert editing.renamed_phoneme(animation, 0, "B").speech.phonemes[0].symbol == "B"
    assert len(editing.without_phonemes(animation, [0, 2]).speech.phonemes) == 1
    later = editing.moved_speech(animation, 1.0, 2.0)
    assert (later.speech.phonemes[-1].end, later.speech.words[0].end) == (pytest.approx(1.6), pytest.approx(1.6))
    replaced = editing.with_phonemes(animation, [Phoneme("S", 0.0, 0.3)])
    assert [s.symbol for s in replaced.speech.phonemes] == ["S"]
    assert replaced.speech.words == ()


def test_typed_sounds_are_laid_out_as_long_as_they_usually_take() -> None:
    words = editing.typed("HH AH0 L OW1 | M AY1")
    sounds = editing.laid_out(words, 1.0)
    assert [s.symbol for s in sounds] == ["HH", "AH0", "L", "OW1", "sil", "M", "AY1"]
    assert sounds[0].start == 1.0
    assert all(a.end == b.start for a, b in pairwise(sounds))
    assert sounds[3].end - sounds[3].start > sounds[1].end - sounds[1].start
    fitted = editing.laid_out(words, 0.0, length=2.0)
    assert fitted[-1].end == pytest.approx(2.0)
    assert editing.typed("   ") == ()


@pytest.fixture(scope="module")
def project() -> Project:
    return new_project()


@pytest.fixture(scope="module")
def basis(project: Project) -> Basis:
    return solve_cached(project).basis


def gap(project: Project, basis: Basis, weights: dict[str, float]) -> float:
    """Return how far the middle of the lips is apart, millimetres."""
    skin, marks = project.face.skin.positions, project.face.landmarks
    ends = []
    for name in ("upper_lip_mid", "lower_lip_mid"):
        point = int(np.argmin(((basis.display.points - skin[marks[name]]) ** 2).sum(axis=1)))
        moved = sum(
            weight * basis.moving_field(field)[point] for field, weight in weights.items() if field in basis.index
        )
        ends.append(basis.display.points[point] + moved)
    return float((ends[0] - ends[1])[1])


def test_on_a_real_face_lips_meet_for_m_between_open_vowels_even_in_surprise(project: Project, basis: Basis) -> None:
    speech = said("AA", "M", "AA", length=0.16)
    calm = Evaluator(Animation(speech=speech), project.units)
    surprise, _ = placed(Animation(speech=speech), find_expression("surprise"), -0.4, project.units)
    rest = gap(project, basis, {})
    assert gap(project, basis, calm.pose(0.08).weights) > rest + 4.0
    for evaluator in (calm, Evaluator(surprise, project.units)):
        assert gap(project, basis, evaluator.pose(0.24).weights) < rest + 0.1
