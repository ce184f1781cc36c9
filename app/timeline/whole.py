"""What is done to curves as a whole, each with a few parameters: baking, simplifying, smoothing, warping, looping."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from app.timeline.chosen import times_of
from app.timeline.keying import chosen_channels
from app.timeline.timeline import Timeline
from facemodel.animation.clip import Animation
from facemodel.animation.editing import dense
from facemodel.animation.track import Track

Values = Mapping[str, float]
"""Parameters by name."""

LEAN = 0.45
"""Share of a stretch by which its middle is moved at the farthest."""


@dataclass(frozen=True)
class Parameter:
    """One number.

    Attributes
    ----------
    name : unique
    label : for people
    least, most, usual : its range and what it begins with
    unit : written behind it
    bend : more than 1 gives small values more room
    whole : whether it counts something
    """

    name: str
    label: str
    least: float
    most: float
    usual: float
    unit: str = ""
    bend: float = 1.0
    whole: bool = False


@dataclass(frozen=True, eq=False)
class Target:
    """What an operation is about.

    Attributes
    ----------
    channels : whose tracks are changed
    span : the stretch of time that is meant, seconds
    rate : frames per second
    """

    channels: tuple[str, ...]
    span: tuple[float, float]
    rate: float


@dataclass(frozen=True)
class Operation:
    """Something that is done to whole tracks.

    Attributes
    ----------
    key, title, hint : unique name, and the words for people
    parameters : what can be chosen
    change : makes another track of one
    asks_span : whether a stretch of time matters
    ends : where the stretch ends then, if it does not end where it did
    """

    key: str
    title: str
    hint: str
    parameters: tuple[Parameter, ...]
    change: Callable[[Track, Values, Target], Track]
    asks_span: bool = False
    ends: Callable[[Values, Target], float] | None = None

    @property
    def usual(self) -> dict[str, float]:
        """The parameters to begin with."""
        return {each.name: each.usual for each in self.parameters}

    def apply(self, animation: Animation, values: Values, target: Target) -> Animation:
        """An animation with the tracks changed; locked ones and empty ones stay.

        What is played goes on to the end of a stretch that ended with it.
        """

        def change(track: Track) -> Track:
            empty = not len(track.curve) and track.captured is None
            return track if empty else self.change(track, values, target)

        made = dense.each_track(animation, target.channels, change)
        if self.ends is None or made is animation or target.span[1] < animation.end:
            return made
        return replace(made, end=max(self.ends(values, target), animation.end))


def target_of(timeline: Timeline) -> Target:
    """The chosen tracks, else those of chosen keys, else all; the stretch of what is chosen, else what is played."""
    animation = timeline.animation
    channels = chosen_channels(timeline) or tuple(dict.fromkeys(channel for channel, _ in timeline.chosen.keys))
    reach = times_of(animation, timeline.chosen)
    long_enough = reach is not None and reach[1] - reach[0] > 1.0 / animation.rate
    span = reach if reach is not None and long_enough else (animation.start, animation.end)
    return Target(channels or tuple(track.channel for track in animation.tracks), span, animation.rate)


def _warp(track: Track, values: Values, target: Target) -> Track:
    begin, end = target.span
    middle, length = (begin + end) / 2, (end - begin) * values["stretch"]
    leaning = begin + length * (0.5 + LEAN * values["lean"])
    return dense.warped(track, (begin, middle, end), (begin, leaning, begin + length))


def _after(target: Target, times: float) -> float:
    """The end of a stretch that takes so many times as long."""
    begin, end = target.span
    return begin + times * (end - begin)


def _loop(track: Track, values: Values, target: Target) -> Track:
    closed = dense.closed(track, target.span, values["blend"]) if values["blend"] > 0 else track
    return dense.looped(closed, target.span, round(values["times"]))


RATE = Parameter("rate", "Rate", 12.0, 120.0, 30.0, "fps")

OPERATIONS: Mapping[str, Operation] = {
    each.key: each
    for each in (
        Operation(
            "bake-keys",
            "Bake to keys",
            "A key on every frame, and nothing else",
            (RATE,),
            lambda track, values, _: dense.baked_to_keys(track, values["rate"]),
        ),
        Operation(
            "bake-samples",
            "Bake to a captured curve",
            "Keys and layers become samples, which layers can bend",
            (RATE,),
            lambda track, values, _: dense.baked_to_samples(track, values["rate"]),
        ),
        Operation(
            "simplify",
            "Simplify",
            "As few smooth keys as stay within a tolerance",
            (Parameter("tolerance", "Tolerance", 0.001, 0.25, 0.02, bend=2.0),),
            lambda track, values, _: dense.simplified(track, values["tolerance"]),
        ),
        Operation(
            "smooth",
            "Smooth",
            "Take fast motion out",
            (Parameter("seconds", "Over", 0.0, 1.0, 0.1, "s", bend=2.0),),
            lambda track, values, _: dense.smoothed(track, values["seconds"]),
        ),
        Operation(
            "warp",
            "Time-warp",
            "Let a stretch take longer or shorter, its middle earlier or later; what is behind goes along",
            (
                Parameter("stretch", "Length", 0.1, 4.0, 1.0, "×", bend=2.0),
                Parameter("lean", "Middle", -1.0, 1.0, 0.0),
            ),
            _warp,
            asks_span=True,
            ends=lambda values, target: _after(target, values["stretch"]),
        ),
        Operation(
            "offset",
            "Offset",
            "Later or earlier, higher or lower",
            (
                Parameter("seconds", "Later by", -2.0, 2.0, 0.0, "s"),
                Parameter("rise", "Higher by", -1.0, 1.0, 0.0),
            ),
            lambda track, values, _: dense.offset(track, values["seconds"], values["rise"]),
        ),
        Operation(
            "loop",
            "Repeat",
            "Repeat a stretch; over the seam it is drawn back to its beginning",
            (
                Parameter("times", "Times", 2.0, 20.0, 2.0, whole=True),
                Parameter("blend", "Close the seam over", 0.0, 2.0, 0.2, "s", bend=2.0),
            ),
            _loop,
            asks_span=True,
            ends=lambda values, target: _after(target, round(values["times"])),
        ),
    )
}
"""By key."""
