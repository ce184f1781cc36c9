"""Named expressions as text that another project can read: one a line, ``happiness: 6=1 12=0.9``.

Units that FACS does not know are told by their names, since their numbers mean something else in every project.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from app.authoring.emotions import free_name, told_weights
from app.authoring.unit_names import FIRST_OWN, LONGEST_NAME
from app.errors import NumberError, UnitError
from app.expression_text import PAIR, SCORE, parse_expression
from facemodel.actions import ActionUnit, Emotion, expand, resolve
from facemodel.errors import UnknownNameError
from facemodel.project import Project

LONGEST_TEXT = 100_000
"""Characters; a thousand expressions are shorter."""

UNTITLED = "pasted expression"

UNWRITABLE = re.compile(r"[=:;,]")
"""What cannot stand in the name of a unit in such a text."""


@dataclass(frozen=True)
class Read:
    """An expression as it was read.

    Attributes
    ----------
    name : what it is called
    weights : by field of the project
    missing : names in the text that are no units of the project
    """

    name: str
    weights: dict[str, float]
    missing: tuple[str, ...] = ()


def expressions_text(emotions: Iterable[Emotion], units: Sequence[ActionUnit]) -> str:
    """Some expressions as text, one a line, so that `expressions_of` reads the same in a project with such units."""
    return "\n".join(f"{emotion.name}: {weights_text(emotion, units)}" for emotion in emotions)


def weights_text(emotion: Emotion, units: Sequence[ActionUnit]) -> str:
    """The weights of an expression as text: ``6=1 12L=0.9 half wink R=0.5``."""
    fields = expand(emotion.weights, units)
    return " ".join(f"{_spoken(name, units)}={weight:.6g}" for name, weight in told_weights(fields, units).items())


def expressions_of(text: str, units: Sequence[ActionUnit]) -> tuple[Read, ...]:
    """The expressions in a text; what names no unit of a project is left out and told.

    Raises
    ------
    UnitError
        If there is no expression in the text, or nothing of one that the project has units for.
    NumberError
        If a line is not made of weights.
    """
    if len(text) > LONGEST_TEXT:
        raise UnitError(f"The clipboard holds {len(text):,} characters; copy no more than some expressions.")
    lines = [line for line in text.splitlines() if line.strip()]
    found = tuple(_read(line, units) for line in lines)
    if not found:
        raise UnitError("There is no expression in the clipboard; copy one as text, such as “smile: 6=0.5 12=0.9”.")
    return found


def with_pasted(project: Project, read: Iterable[Read]) -> tuple[Project, tuple[str, ...]]:
    """A project with more expressions at the end of its list; also what they are called there.

    A name that is taken gets a number.
    """
    names = []
    for each in read:
        name = free_name(project, each.name)
        weights = told_weights(each.weights, project.units)
        project = replace(project, emotions=(*project.emotions, Emotion(name, weights)))
        names.append(name)
    return project, tuple(names)


def told(read: Sequence[Read], names: Sequence[str]) -> str:
    """What was pasted, and what of it this project has no units for, in a sentence or two."""
    said = "Pasted " + ", ".join(f"“{name}”" for name in names) + "."
    missing = tuple(dict.fromkeys(name for each in read for name in each.missing))
    if missing:
        said += f" Left out {', '.join(f'“{name}”' for name in missing)}: this project has no such action unit."
    return said


def _spoken(name: str, units: Sequence[ActionUnit]) -> str:
    """A weight's name for another project: that of a unit of one's own is said in words."""
    number, side = re.fullmatch(r"(\d+)([LR]?)", name).groups()  # type: ignore[union-attr]
    unit = next(each for each in units if each.number == int(number))
    if unit.number < FIRST_OWN or UNWRITABLE.search(unit.name):
        return name
    return f"{unit.name} {side}".strip()


def _read(line: str, units: Sequence[ActionUnit]) -> Read:
    name, rest = _named(line, units)
    weights, missing = _weights(rest, units)
    if not weights and missing:
        raise UnitError(
            f"“{name}” is made of {', '.join(f'“{each}”' for each in missing)} alone, and this project has no such "
            "action unit; make one of that name, then paste it again."
        )
    if not weights:
        raise UnitError(f"Nothing moves in “{name}”; paste an expression with some weights.")
    return Read(" ".join(name.split())[:LONGEST_NAME], weights, missing)


def _named(line: str, units: Sequence[ActionUnit]) -> tuple[str, str]:
    """What an expression is called, and the rest of its line; ``12: 0.5`` is a weight and no name."""
    name, colon, rest = line.partition(": ")
    if not colon or not name.strip() or "=" in name or ";" in name or _means_a_unit(name, units):
        return UNTITLED, line
    return name.strip(), rest


def _weights(text: str, units: Sequence[ActionUnit]) -> tuple[dict[str, float], tuple[str, ...]]:
    """Weights by field, and the names of those that are no units."""
    if "=" not in text and ":" not in text and SCORE.match(text):
        return parse_expression(text, units), ()
    weights: dict[str, float] = {}
    missing: list[str] = []
    place = 0
    while text[place:].strip():
        pair = PAIR.match(text, place)
        if pair is None:
            raise NumberError(
                f"“{' '.join(text[place:].split())[:30]}” is no weight; write pairs such as 12=0.8 1L=50%."
            )
        if _means_a_unit(pair[1], units):
            weights |= parse_expression(pair[0], units)
        else:
            missing.append(pair[1])
        place = pair.end()
    return {name: weight for name, weight in weights.items() if weight}, tuple(missing)


def _means_a_unit(name: str, units: Sequence[ActionUnit]) -> bool:
    try:
        return bool(resolve(name, units))
    except UnknownNameError:
        return False
