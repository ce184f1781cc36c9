"""What is written about an action unit, and by which words it is found."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from html import escape

from facemodel.actions import ActionUnit, JawMotion
from facemodel.motions import EyeMotion, HeadMotion, TongueMotion
from facemodel.muscles import Muscle

MuscleTitles = Mapping[str, str]
"""Titles for people of muscles by name without side."""


def muscle_titles(muscles: Iterable[Muscle]) -> MuscleTitles:
    """Titles by name without side."""
    return {muscle.name: muscle.title for muscle in muscles}


def unit_title(unit: ActionUnit) -> str:
    """The name as a heading is written."""
    return unit.name[:1].upper() + unit.name[1:]


def unit_muscles(unit: ActionUnit, titles: MuscleTitles) -> tuple[str, ...]:
    """Titles of the muscles that it contracts, the strongest first."""
    strongest_first = sorted(unit.muscles, key=lambda name: -abs(unit.muscles[name]))
    return tuple(titles.get(name, name.replace("_", " ")) for name in strongest_first)


def jaw_words(jaw: JawMotion) -> str:
    """What happens to the jaw, as far as anything does: ``12° open, 2 mm forward, 3 mm to the left``."""
    return _ways(
        (jaw.degrees, "° open", "° further closed"),
        (jaw.slide, " mm forward", " mm back"),
        (jaw.side, " mm to the left", " mm to the right"),
    )


def eye_words(eyes: EyeMotion) -> str:
    """How the eyes turn, as far as they do: ``35° to the left, 10° up``."""
    return _ways(
        (eyes.turn, "° to the left", "° to the right"),
        (eyes.lift, "° up", "° down"),
        (eyes.spread, "° outwards each", "° inwards each"),
    )


def head_words(head: HeadMotion) -> str:
    """How the head moves, as far as it does: ``45° to the left, 35 mm forward``."""
    return _ways(
        (head.turn, "° to the left", "° to the right"),
        (head.lift, "° up", "° down"),
        (head.tilt, "° tilted to the left", "° tilted to the right"),
        (head.forward, " mm forward", " mm back"),
    )


def tongue_words(tongue: TongueMotion) -> str:
    """How the tongue moves, as far as it does: ``24 mm out, 30° down``."""
    return _ways((tongue.out, " mm out", " mm back"), (tongue.lift, "° up", "° down"))


def motion_words(unit: ActionUnit) -> str:
    """What a unit does to jaw, eyes, head and tongue: ``jaw, 12° open``."""
    parts = (
        ("jaw", unit.jaw and jaw_words(unit.jaw)),
        ("eyes", unit.eyes and eye_words(unit.eyes)),
        ("head", unit.head and head_words(unit.head)),
        ("tongue", unit.tongue and tongue_words(unit.tongue)),
    )
    return "; ".join(f"{what}, {words}" for what, words in parts if words)


def _ways(*ways: tuple[float, str, str]) -> str:
    return ", ".join(f"{abs(way):g}{one if way > 0 else other}" for way, one, other in ways if way)


def unit_tooltip(unit: ActionUnit, titles: MuscleTitles, sculpted: bool = False) -> str:
    """Number, muscles and amplitude, as rich text of a few short lines."""
    moved = list(unit_muscles(unit, titles))
    if motion_words(unit):
        moved.append(motion_words(unit))
    lines = [
        f"<b>AU {unit.number} · {escape(unit_title(unit))}</b>",
        escape(", ".join(moved)),
        f"{unit.amplitude:g} mm at 1" if unit.moves_skin else "",
        "sculpted by hand" if sculpted else "",
        escape(unit.note),
        "Double-click types 0.6 or C · right-click resets · Ctrl past 1 · Shift finer",
    ]
    return "<br>".join(line for line in lines if line)


def unit_matches(query: str, unit: ActionUnit, titles: MuscleTitles) -> bool:
    """Whether every word of a search is in the unit's number, name or muscles.  ``12``, ``AU12``, ``zygom lip``."""
    numbers = {str(unit.number), f"au{unit.number}", *(name.lower() for name in unit.fields)}
    text = " ".join((unit.name, *unit.muscles, *unit_muscles(unit, titles))).lower()
    return all(word in numbers or _in_text(word, text) for word in query.lower().split())


def _in_text(word: str, text: str) -> bool:
    return not word.isdigit() and (word == "au" or word in text)
