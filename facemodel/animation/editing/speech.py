"""What is said: sounds placed, moved, renamed and removed, and sounds without times laid out in time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from facemodel.animation.clip import Animation
from facemodel.animation.speech import Phoneme, Speech, Viseme, VisemeTable, Word
from facemodel.animation.visemes import mouth_table, parts_of

SHORTEST = 0.01
"""Seconds of a sound at least; nobody hears a shorter one."""

PAUSE = "sil"
PAUSES = ("|", "/", ",", ".", ";", "?", "!")
"""What stands for a pause among typed sounds."""

GLIDE = 0.75
"""How long a glide is beside both vowels that it moves between."""

STRESSED = 1.25
"""How much longer a stressed vowel is: one with the digit 1 of ARPAbet, or with the mark of IPA."""


def with_speech(animation: Animation, speech: Speech) -> Animation:
    """An animation in which something else is said, its sounds and words in the order of time."""
    return replace(
        animation,
        speech=replace(
            speech,
            phonemes=tuple(sorted(speech.phonemes, key=lambda sound: sound.start)),
            words=tuple(sorted(speech.words, key=lambda word: word.start)),
        ),
    )


def with_phonemes(animation: Animation, phonemes: Sequence[Phoneme], words: Sequence[Word] = ()) -> Animation:
    """An animation with sounds in place of those between their first and last time; words likewise."""
    if not phonemes:
        return animation
    begin, end = min(sound.start for sound in phonemes), max(sound.end for sound in phonemes)
    speech = animation.speech
    kept = [each for each in speech.phonemes if each.end <= begin or each.start >= end]
    spoken = [each for each in speech.words if each.end <= begin or each.start >= end]
    return with_speech(animation, replace(speech, phonemes=(*kept, *phonemes), words=(*spoken, *words)))


def without_phonemes(animation: Animation, places: Sequence[int]) -> Animation:
    """An animation without some sounds, by their place in the order of time."""
    gone = set(places)
    kept = tuple(sound for place, sound in enumerate(animation.speech.phonemes) if place not in gone)
    return replace(animation, speech=replace(animation.speech, phonemes=kept))


def renamed_phoneme(animation: Animation, place: int, symbol: str) -> Animation:
    """An animation in which a sound is another one."""
    sounds = list(animation.speech.phonemes)
    sounds[place] = replace(sounds[place], symbol=symbol.strip())
    return replace(animation, speech=replace(animation.speech, phonemes=tuple(sounds)))


def with_bounds(animation: Animation, place: int, start: float | None = None, end: float | None = None) -> Animation:
    """An animation in which a sound begins or ends at another time; a neighbour that touches it goes along."""
    sounds = list(animation.speech.phonemes)
    sound = sounds[place]
    if start is not None:
        begin = min(start, sound.end - SHORTEST)
        if place and sounds[place - 1].end >= sound.start - SHORTEST:
            before = sounds[place - 1]
            begin = max(begin, before.start + SHORTEST)
            sounds[place - 1] = replace(before, end=begin)
        sounds[place] = sound = replace(sound, start=begin)
    if end is not None:
        stop = max(end, sound.start + SHORTEST)
        if place + 1 < len(sounds) and sounds[place + 1].start <= sound.end + SHORTEST:
            after = sounds[place + 1]
            stop = min(stop, after.end - SHORTEST)
            sounds[place + 1] = replace(after, start=stop)
        sounds[place] = replace(sound, end=stop)
    return with_speech(animation, replace(animation.speech, phonemes=tuple(sounds)))


def moved_speech(animation: Animation, seconds: float, factor: float = 1.0) -> Animation:
    """An animation in which all is said later by seconds, and slower by a factor about its beginning."""
    speech = animation.speech
    if not speech.phonemes and not speech.words:
        return animation
    begin = min([each.start for each in speech.phonemes] + [each.start for each in speech.words])
    kept = max(factor, 0.05)

    def at(time: float) -> float:
        return begin + kept * (time - begin) + seconds

    return with_speech(
        animation,
        replace(
            speech,
            phonemes=tuple(replace(each, start=at(each.start), end=at(each.end)) for each in speech.phonemes),
            words=tuple(replace(each, start=at(each.start), end=at(each.end)) for each in speech.words),
        ),
    )


def with_visemes(animation: Animation, visemes: Sequence[Viseme]) -> Animation:
    """An animation that speaks with other visemes; with the shipped ones if there are none."""
    own = () if tuple(visemes) == mouth_table().visemes else tuple(visemes)
    return replace(animation, speech=replace(animation.speech, visemes=own))


def with_viseme(animation: Animation, viseme: Viseme) -> Animation:
    """An animation in which a viseme looks otherwise, or is new."""
    known = {each.name: each for each in animation.speech.visemes or mouth_table().visemes}
    return with_visemes(animation, tuple((known | {viseme.name: viseme}).values()))


def unknown_symbols(speech: Speech) -> tuple[str, ...]:
    """Symbols that no viseme has; the mouth rests while they are said."""
    table = VisemeTable(speech.visemes or mouth_table().visemes)
    found = (sound.symbol for sound in speech.phonemes)
    return tuple(dict.fromkeys(each for each in found if any(table.find(part) is None for part in parts_of(each))))


def laid_out(words: Sequence[Sequence[str]], start: float, length: float | None = None) -> tuple[Phoneme, ...]:
    """Sounds without times in time: each as long as its kind usually takes.

    Parameters
    ----------
    words : sounds of one word after the other
    start : of the first, seconds
    length : of all together, if it is known, from a recording say
    """
    table = mouth_table()
    find = VisemeTable(table.visemes).find
    usual = [(symbol, _usual_length(symbol, find)) for word in words for symbol in word]
    whole = sum(seconds for _, seconds in usual)
    factor = 1.0 if length is None or whole <= 0 else length / whole
    found: list[Phoneme] = []
    time = start
    for symbol, seconds in usual:
        found.append(Phoneme(symbol, time, time + factor * seconds))
        time = found[-1].end
    return tuple(found)


def _usual_length(symbol: str, find: Callable[[str], Viseme | None]) -> float:
    table = mouth_table()
    seen = [find(part) for part in parts_of(symbol)]
    lengths = [table.lengths.get(viseme.name if viseme else "", table.lengths[""]) for viseme in seen]
    # A glide is one long sound and not two: it takes about 0.17 s.
    together = sum(lengths) if len(lengths) == 1 else GLIDE * sum(lengths)
    return STRESSED * together if symbol.endswith("1") or "ˈ" in symbol else together


def typed(text: str) -> tuple[tuple[str, ...], ...]:
    """Words of sounds as a person types them: sounds apart by spaces, a pause as ``|`` or by punctuation."""
    sounds: list[str] = []
    for part in text.split():
        sounds.append(PAUSE if part in PAUSES else part)
    return (tuple(sounds),) if sounds else ()
