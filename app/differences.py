"""When two projects are the same, for what, and what is different between them.

Faces, muscles, units and arrays are frozen and shared between projects: the same object is the same, and only
what is another object is compared.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import TypeVar

from app.commands.animation import PARTS, event_name, track_name
from app.commands.content import emotion_name, muscle_name, unit_name
from app.commands.painting import ARRAY_NAMES, ON_SKULL, ArrayName, changed_rows, layer_array
from facemodel.animation.clip import Animation
from facemodel.face import Face
from facemodel.project import Project
from facemodel.sameness import same
from facemodel.sculpting.correction import Corrections
from fem.types import IntArray

Item = TypeVar("Item")

PAINTED_ON = {"layers", "skull"}
"""Members of a face that change by painting and shaping; the others make it another head."""


@dataclass(frozen=True, eq=False)
class Changes:
    """What is different between two projects.

    Attributes
    ----------
    whole : another head, or other settings; all the rest is then to be made anew and is not told apart
    layers : by painted array, the skin vertices that have other values
    skull : whether the bones or the hinge of the jaw are others
    muscles, units, emotions : keys, numbers and names of those that changed, came, went or stand elsewhere
    corrections : fields whose correction changed, came or went
    animation : channels whose track changed, came, went or stands elsewhere, and names of the other members of the
        animation that are others
    """

    whole: bool = False
    layers: Mapping[ArrayName, IntArray] = field(default_factory=dict)
    skull: bool = False
    muscles: frozenset[str] = frozenset()
    units: frozenset[int] = frozenset()
    emotions: frozenset[str] = frozenset()
    corrections: frozenset[str] = frozenset()
    animation: frozenset[str] = frozenset()

    def __bool__(self) -> bool:
        content = self.muscles or self.units or self.emotions or self.corrections or self.animation
        return bool(self.whole or self.layers or self.skull or content)


def changes(before: Project, after: Project) -> Changes:
    """What is different between two projects beside the expression."""
    if not same_head(before.face, after.face) or before.settings != after.settings:
        return Changes(whole=True)
    return Changes(
        layers=_painted(before.face, after.face),
        skull=_other_bones(before.face, after.face),
        muscles=_moved(before.muscles, after.muscles, muscle_name),
        units=frozenset(map(int, _moved(before.units, after.units, unit_name))),
        emotions=_moved(before.emotions, after.emotions, emotion_name),
        corrections=_sculpted(before.corrections, after.corrections),
        animation=_animated(before.animation, after.animation),
    )


def same_head(one: Face, other: Face) -> bool:
    """Whether two faces differ at most in what is painted on them and in the bone below."""
    if one is other:
        return True
    kept = (each.name for each in fields(one) if each.name not in PAINTED_ON)
    return all(same(getattr(one, name), getattr(other, name)) for name in kept)


def same_content(one: Project, other: Project) -> bool:
    """Whether both would be saved alike."""
    return all(same(getattr(one, each.name), getattr(other, each.name)) for each in fields(one))


def _painted(before: Face, after: Face) -> dict[ArrayName, IntArray]:
    if before is after:
        return {}
    rows = {name: changed_rows(layer_array(before, name), layer_array(after, name)) for name in ARRAY_NAMES}
    return {name: indices for name, indices in rows.items() if len(indices)}


def _other_bones(before: Face, after: Face) -> bool:
    if before.skull is after.skull:
        return False
    bones = (each.name for each in fields(before.skull) if each.name not in ON_SKULL)
    return not all(same(getattr(before.skull, name), getattr(after.skull, name)) for name in bones)


def _sculpted(before: Corrections, after: Corrections) -> frozenset[str]:
    if before is after:
        return frozenset()
    return frozenset(name for name in {**before, **after} if not same(before.get(name), after.get(name)))


def _animated(before: Animation, after: Animation) -> frozenset[str]:
    if before is after:
        return frozenset()
    parts = {name for name in PARTS if not same(getattr(before, name), getattr(after, name))}
    if _moved(before.events, after.events, event_name):
        parts.add("events")
    return _moved(before.tracks, after.tracks, track_name) | parts


def _moved(before: Sequence[Item], after: Sequence[Item], name_of: Callable[[Item], str]) -> frozenset[str]:
    if before is after:
        return frozenset()
    old, new = ({name_of(item): (place, item) for place, item in enumerate(each)} for each in (before, after))
    return frozenset(
        name
        for name in {**old, **new}
        if name not in old or name not in new or old[name][0] != new[name][0] or not same(old[name][1], new[name][1])
    )
