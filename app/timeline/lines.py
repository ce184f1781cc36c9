"""The lines of the timeline, from top to bottom: what there is, grouped, folded and searched."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from app.timeline.state import TimelineState
from facemodel.actions import GROUP_TITLES, ActionUnit
from facemodel.animation.channels import RIGID, channel_of, channels
from facemodel.animation.clip import Animation
from facemodel.animation.editing.selection import Row
from facemodel.animation.event import Event
from facemodel.animation.track import Track

Kind = Literal["expressions", "audio", "speech", "life", "events", "event", "group", "track", "layer"]

Side = Literal["left", "right", "both"]

HEAD_AND_EYES = "Head and eyes"
OTHERS = "Other channels"


@dataclass(frozen=True)
class Line:
    """One line.

    Attributes
    ----------
    key : unique, for example ``track 12L`` or ``layer 12L 1``
    kind : what it shows
    title : for people
    number : of the action unit; empty for anything else
    side : of the face
    depth : how far it is indented
    channel, layer : of a track and its layers, 1 the lowest
    members : channels of a group of tracks, keys of the events of a lane or of one line of it
    foldable, folded : whether it has inner lines, and whether they are hidden
    """

    key: str
    kind: Kind
    title: str
    number: str = ""
    side: Side = "both"
    depth: int = 0
    channel: str = ""
    layer: int = 0
    members: tuple[str, ...] = ()
    foldable: bool = False
    folded: bool = False

    @property
    def row(self) -> Row | None:
        """Where its own keys are; none for a line without keys of its own."""
        return (self.channel, self.layer) if self.kind in ("track", "layer") else None


def lines_of(animation: Animation, units: Sequence[ActionUnit], state: TimelineState) -> tuple[Line, ...]:
    """All lines that are to be seen.

    What is searched for is found in numbers, names and groups; folds then open.  Tracks are in the order of the face,
    those of a group of one's own in that of the animation.
    """
    found = [Line("expressions", "expressions", "Key expressions")]
    if animation.audio is not None:
        found.append(Line("audio", "audio", animation.audio.path.rpartition("/")[2]))
    if animation.speech.phonemes or animation.speech.words:
        found.append(Line("speech", "speech", "Speech"))
    if animation.idle is not None:
        found.append(Line("life", "life", "Idle life"))
    sought = state.sought.strip().lower()
    found += _event_lines(animation, units, state, sought)
    found += _track_lines(animation, units, state, sought)
    return tuple(found)


def rows_of(line: Line, animation: Animation) -> tuple[Row, ...]:
    """Where the keys of a line are: its own, or those of all that it sums up."""
    if line.row is not None:
        return (line.row,)
    channels = line.members if line.kind == "group" else ()
    among = animation.tracks if line.kind == "expressions" else [t for t in animation.tracks if t.channel in channels]
    return tuple((track.channel, row) for track in among for row in range(len(track.layers) + 1))


def channel_line(channel: str, units: Sequence[ActionUnit]) -> Line:
    """The line of a channel's track, at the margin."""
    for unit in units:
        if channel in unit.fields:
            side: Side = {"L": "left", "R": "right"}.get(channel[-1], "both") if unit.paired else "both"  # type: ignore[assignment]
            return Line(f"track {channel}", "track", unit.name.capitalize(), str(unit.number), side, channel=channel)
    return Line(f"track {channel}", "track", channel_of(channel).title, side=_side_of(channel), channel=channel)


def group_of(track: Track, units: Sequence[ActionUnit]) -> str:
    """The title of the group that a track is listed in."""
    if track.group:
        return track.group
    if track.channel in RIGID:
        return HEAD_AND_EYES
    unit = next((unit for unit in units if track.channel in unit.fields), None)
    return GROUP_TITLES[unit.group] if unit is not None else OTHERS


def channels_title(channels: Sequence[str], units: Sequence[ActionUnit]) -> str:
    """What an event moves, for people."""
    for unit in units:
        if unit.paired and set(unit.fields) == set(channels):
            return f"{unit.number} {unit.name.capitalize()}"
    lines = [channel_line(channel, units) for channel in channels]
    sides = {"left": " left", "right": " right", "both": ""}
    return ", ".join(f"{line.number} {line.title}{sides[line.side]}".strip() for line in lines)


def _side_of(channel: str) -> Side:
    return "left" if channel.startswith("eyeL") else "right" if channel.startswith("eyeR") else "both"


def _event_lines(
    animation: Animation, units: Sequence[ActionUnit], state: TimelineState, sought: str
) -> Iterator[Line]:
    """Lanes of clips that do not overlap, and below each the lines of the clips in it that are open."""
    clips = {
        name: events
        for name, events in clips_of(animation.events).items()
        if not sought or _matches(sought, name, *(channels_title(event.channels, units) for event in events))
    }
    for number, lane in enumerate(_lanes(clips)):
        opened = [name for name in lane if f"clip {name}" in state.flipped]
        members = tuple(event.key for name in lane for event in clips[name])
        title = "Events" if number == 0 else ""
        yield Line(f"lane {number}", "events", title, members=members, foldable=True, folded=not opened)
        for name in opened:
            yield from _lines_of_clip(name, clips[name], units)


def clips_of(events: Iterable[Event]) -> dict[str, list[Event]]:
    """Events by the name of their group; those of none are clips of their own, by their key."""
    found: dict[str, list[Event]] = {}
    for event in events:
        found.setdefault(event.group or event.key, []).append(event)
    return found


def _lanes(clips: Mapping[str, Sequence[Event]]) -> list[list[str]]:
    """Clips from the first on, each in the uppermost lane where it has room."""
    lanes: list[list[tuple[float, float, str]]] = []
    for name, events in clips.items():
        begin, end = min(event.begins for event in events), max(event.ends for event in events)
        free = (lane for lane in lanes if all(end <= first or begin >= last for first, last, _ in lane))
        lane = next(free, None)
        if lane is None:
            lane = []
            lanes.append(lane)
        lane.append((begin, end, name))
    return [[name for _, _, name in lane] for lane in lanes]


def _lines_of_clip(name: str, events: Iterable[Event], units: Sequence[ActionUnit]) -> Iterator[Line]:
    """A line for each thing that a clip moves."""
    moved: dict[tuple[str, ...], list[Event]] = {}
    for event in events:
        moved.setdefault(event.channels, []).append(event)
    for names, each in moved.items():
        title = channels_title(names, units)
        sides = {channel_line(channel, units).side for channel in names}
        side = next(iter(sides)) if len(sides) == 1 else "both"
        number, _, words = title.partition(" ") if title[:1].isdigit() and "," not in title else ("", "", title)
        keys = tuple(event.key for event in each)
        yield Line(f"event {name} {' '.join(names)}", "event", words, number, side, 1, members=keys)


def _track_lines(
    animation: Animation, units: Sequence[ActionUnit], state: TimelineState, sought: str
) -> Iterator[Line]:
    groups: dict[str, list[Track]] = {}
    for track in animation.tracks:
        groups.setdefault(group_of(track, units), []).append(track)
    order = {channel.name: place for place, channel in enumerate(channels(units))}
    for title in sorted(groups, key=_group_order):
        if not any(track.group for track in groups[title]):
            groups[title].sort(key=lambda track: order.get(track.channel, len(order)))
        listed = [track for track in groups[title] if not sought or _found(track, title, units, sought)]
        if not listed:
            continue
        inner = [line for track in listed for line in _lines_of_track(track, units, state, bool(sought))]
        if len(groups) == 1:
            yield from inner
            continue
        key = f"group {title}"
        folded = key in state.flipped and not sought
        members = tuple(track.channel for track in listed)
        yield Line(key, "group", title, members=members, foldable=True, folded=folded)
        if not folded:
            yield from (_deeper(line) for line in inner)


def _lines_of_track(track: Track, units: Sequence[ActionUnit], state: TimelineState, searching: bool) -> Iterator[Line]:
    line = channel_line(track.channel, units)
    folded = line.key in state.flipped and not searching
    yield replace(line, foldable=bool(track.layers), folded=folded)
    if not folded:
        for number, layer in enumerate(track.layers, start=1):
            title = layer.name or f"Layer {number}"
            key = f"layer {track.channel} {number}"
            yield Line(key, "layer", title, "", line.side, 1, track.channel, number)


def _group_order(title: str) -> tuple[int, str]:
    """Groups of people's own first, then those of the face from top to bottom."""
    known = [*GROUP_TITLES.values(), HEAD_AND_EYES, OTHERS]
    return (1 + known.index(title), "") if title in known else (0, title.lower())


def _found(track: Track, group: str, units: Sequence[ActionUnit], sought: str) -> bool:
    line = channel_line(track.channel, units)
    return _matches(sought, group, f"{line.number} {line.title} {line.side}", track.channel)


def _matches(sought: str, *texts: str) -> bool:
    """Whether all words that are sought begin a word, or a number, of what is written."""
    words = [word for text in texts for word in text.lower().split()]
    return all(any(word.startswith(each) for word in words) for each in sought.split())


def _deeper(line: Line) -> Line:
    return replace(line, depth=line.depth + 1)


def keyed_rows(lines: Iterable[Line], animation: Animation) -> tuple[Row, ...]:
    """Rows of all lines, each once."""
    return tuple(dict.fromkeys(row for line in lines for row in rows_of(line, animation)))
