"""Which curves the graph shows, and how each is drawn."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtGui import QColor

from app.timeline.keying import chosen_channels
from app.timeline.lines import Line, Side, channel_line
from app.timeline.timeline import Timeline
from facemodel.animation.channels import channel_of
from facemodel.animation.curve import BEZIER, SAME_TIME, Curve
from facemodel.animation.editing.selection import Row
from facemodel.animation.track import Track
from fem.types import FloatArray
from ui.theme.roles import Theme

HUES = {
    "dark": ("#e8a13c", "#58b6e6", "#5cc49a", "#ece057", "#5f9bff", "#ff8a5c", "#d990c0", "#b7bec8"),
    "light": ("#a86200", "#0b7bb0", "#00795a", "#8a7c00", "#2255b8", "#b8471b", "#a0457f", "#59636e"),
}
"""Colours that the colour-blind tell apart too (after Okabe and Ito), for more curves than there are sides."""

MOST = 24
"""Curves that are drawn at once when none is chosen; more would be a thicket."""

THIRD = 1.0 / 3.0


@dataclass(frozen=True, eq=False)
class GraphCurve:
    """One curve of the graph.

    Attributes
    ----------
    track : whose it is
    row : where its keys are: the track's own, or those of a layer
    title, side : for people
    factor : by which its values are multiplied to be drawn beside the others
    colour : of its line
    """

    track: Track
    row: Row
    title: str
    side: Side
    factor: float
    colour: QColor

    @property
    def keys(self) -> Curve:
        """Its keys."""
        return self.track.curve if self.row[1] == 0 else self.track.layers[self.row[1] - 1].keys


def graph_curves(timeline: Timeline, lines: Sequence[Line], theme: Theme) -> tuple[GraphCurve, ...]:
    """The curves of the chosen lines, or else the first of those that are listed."""
    animation, units = timeline.animation, timeline.document.project.units
    wanted = chosen_channels(timeline)
    listed = [line.channel for line in lines if line.kind == "track"]
    names = [name for name in listed if name in wanted] if wanted else listed[:MOST]
    tracks = [track for name in names if (track := animation.track(name)) is not None]
    known = {track.channel: channel_of(track.channel, units) for track in tracks}
    mixed = {each.rigid for each in known.values()} == {True, False}
    heads = [channel_line(track.channel, units) for track in tracks]
    by_side = len({head.side for head in heads}) == len(heads)
    found: list[GraphCurve] = []
    for number, (track, head) in enumerate(zip(tracks, heads, strict=True)):
        channel = known[track.channel]
        factor = 1.0 / channel.high if mixed and channel.rigid else 1.0
        hues = HUES[theme.name]
        colour = QColor(getattr(theme, head.side)) if by_side else QColor(hues[number % len(hues)])
        row = (track.channel, _row_of(track, timeline))
        found.append(GraphCurve(track, row, f"{head.number} {head.title}".strip(), head.side, factor, colour))
    return tuple(found)


def _row_of(track: Track, timeline: Timeline) -> int:
    """The row whose keys are worked on: a chosen layer, else the uppermost layer of a capture, else the track's own."""
    for number in range(len(track.layers), 0, -1):
        if f"layer {track.channel} {number}" in timeline.state.lines:
            return number
    return len(track.layers) if track.captured is not None and not len(track.curve) else 0


def bezier_ends(keys: Curve, place: int) -> tuple[tuple[float, float] | None, tuple[float, float] | None]:
    """Where the handles of a key are drawn, as time and value; none where the segment there follows no handle."""
    time, value = float(keys.times[place]), float(keys.values[place])
    behind = place > 0 and keys.shapes[place - 1] == BEZIER
    ahead = place + 1 < len(keys) and keys.shapes[place] == BEZIER
    four = keys.handles[place]
    weighted = bool(keys.weighted[place])
    before = _end(four[:2], float(time - keys.times[place - 1]), weighted, -1.0) if behind else None
    after = _end(four[2:], float(keys.times[place + 1] - time), weighted, 1.0) if ahead else None
    return (
        None if before is None else (time + before[0], value + before[1]),
        None if after is None else (time + after[0], value + after[1]),
    )


def _end(handle: FloatArray, length: float, weighted: bool, way: float) -> tuple[float, float]:
    """A handle as it acts: no longer than its segment, and a third of it where only its slope counts."""
    size, rise = abs(float(handle[0])), float(handle[1])
    if size < SAME_TIME:
        return (0.0, rise) if weighted else (way * length * THIRD, 0.0)
    reach = min(size, length) if weighted else length * THIRD
    return way * reach, rise * reach / size
