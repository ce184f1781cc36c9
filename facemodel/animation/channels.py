"""Channels: what a curve may move.  Displacement fields by weight, head and eyes by degrees and millimetres."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from facemodel.actions import EXAGGERATED, ActionUnit


@dataclass(frozen=True)
class Channel:
    """Something that one curve moves.

    Attributes
    ----------
    name : as tracks, events and files call it
    title : for people
    low, high : the range to which its value is clamped
    unit : empty for a weight, ``°`` or ``mm``
    flips : whether its mirror image moves the other way
    """

    name: str
    title: str
    low: float
    high: float
    unit: str = ""
    flips: bool = False

    @property
    def rigid(self) -> bool:
        """Whether it moves head or eyes, and no displacement field."""
        return bool(self.unit)


_RIGID = (
    Channel("head.yaw", "Head turn", -80.0, 80.0, "°", flips=True),
    Channel("head.pitch", "Head up and down", -60.0, 60.0, "°"),
    Channel("head.roll", "Head tilt", -50.0, 50.0, "°", flips=True),
    Channel("head.x", "Head sideways", -200.0, 200.0, "mm", flips=True),
    Channel("head.y", "Head up", -200.0, 200.0, "mm"),
    Channel("head.z", "Head forward", -200.0, 200.0, "mm"),
    Channel("eyeL.yaw", "Left eye turn", -50.0, 50.0, "°", flips=True),
    Channel("eyeL.pitch", "Left eye up and down", -40.0, 40.0, "°"),
    Channel("eyeR.yaw", "Right eye turn", -50.0, 50.0, "°", flips=True),
    Channel("eyeR.pitch", "Right eye up and down", -40.0, 40.0, "°"),
)

RIGID: Mapping[str, Channel] = {channel.name: channel for channel in _RIGID}
"""Rigid motions by name.  Yaw is to the subject's left, pitch up, roll towards the subject's left shoulder."""


def channel_of(name: str, units: Iterable[ActionUnit] = ()) -> Channel:
    """A channel by name; a field of no unit known here keeps the range of any weight."""
    if name in RIGID:
        return RIGID[name]
    for unit in units:
        if name in unit.fields:
            side = {"L": " L", "R": " R"}.get(name[-1], "") if unit.paired else ""
            return Channel(name, unit.name + side, 0.0, unit.limit)
    return Channel(name, name, 0.0, EXAGGERATED)


def channels_of(names: Iterable[str], units: Iterable[ActionUnit]) -> list[Channel]:
    """Channels by name, for many at once."""
    known = {channel.name: channel for channel in channels(units)}
    return [known.get(name) or channel_of(name) for name in names]


def channels(units: Iterable[ActionUnit]) -> tuple[Channel, ...]:
    """All channels of a face: its fields in the order of the units, left before right, then the rigid motions."""
    known = tuple(units)
    return (*(channel_of(name, (unit,)) for unit in known for name in unit.fields), *_RIGID)


def mirrored(name: str) -> str:
    """The channel on the other side: ``12R`` for ``12L``, the very same for one on the midline."""
    if name.startswith(("eyeL.", "eyeR.")):
        return f"eye{_OTHER[name[3]]}{name[4:]}"
    if name not in RIGID and name[-1:] in _OTHER and name[:-1].isdigit():
        return name[:-1] + _OTHER[name[-1]]
    return name


_OTHER = {"L": "R", "R": "L"}
