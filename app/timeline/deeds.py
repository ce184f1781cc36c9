"""What is done to the things that are chosen on the timeline, each deed one step."""

from __future__ import annotations

from dataclasses import replace

from app.timeline.chosen import NOTHING, Chosen, all_of, merged, reduced, times_of
from app.timeline.clipping import clipping, pasted
from app.timeline.keying import chosen_channels
from app.timeline.moving import deleted, moved, on_other_side
from app.timeline.timeline import Timeline
from facemodel.animation.clip import Animation
from facemodel.animation.curve import SAME_TIME, Shape
from facemodel.animation.editing.bulk import eased_keys, flagged_keys, shaped_keys, snapped_keys, valued_keys
from facemodel.animation.editing.eases import EASES
from facemodel.animation.editing.marks import played, with_marker, with_range
from facemodel.animation.editing.selection import Row, curve_of_row, rows, selected
from facemodel.animation.editing.tracks import without_tracks
from facemodel.animation.library import DynamicExpression, placed


def delete(timeline: Timeline) -> None:
    """Delete what is chosen; without anything chosen, the chosen tracks."""
    chosen = timeline.chosen
    if chosen:
        timeline.edit(deleted(timeline.animation, chosen), f"Delete {_what(chosen)}", chosen=NOTHING)
    elif channels := chosen_channels(timeline):
        made = without_tracks(timeline.animation, channels)
        timeline.edit(_without_empty(made), "Delete tracks" if len(channels) > 1 else "Delete track")
        timeline.change(lines=frozenset())


def copy(timeline: Timeline) -> None:
    """Put what is chosen into the clipboard of the timeline."""
    clip = clipping(timeline.animation, timeline.chosen)
    if clip:
        timeline.clip = clip


def cut(timeline: Timeline) -> None:
    """Copy what is chosen, then delete it."""
    copy(timeline)
    delete(timeline)


def paste(timeline: Timeline) -> None:
    """Put what was copied under the playhead; keys of a single row onto the chosen tracks, if any are."""
    units = timeline.document.project.units
    onto: tuple[Row, ...] = tuple((channel, 0) for channel in chosen_channels(timeline))
    made, chosen = pasted(timeline.animation, timeline.clip, timeline.playhead.time, onto, units)
    timeline.edit(made, f"Paste {_what(chosen)}", chosen=chosen)


def duplicate(timeline: Timeline) -> None:
    """Copies of what is chosen, right behind it."""
    reach = times_of(timeline.animation, timeline.chosen)
    clip = clipping(timeline.animation, timeline.chosen)
    if reach is not None and clip:
        behind = reach[0] + max(reach[1] - reach[0], 0.0) + 1.0 / timeline.rate
        made, chosen = pasted(timeline.animation, clip, behind, (), timeline.document.project.units)
        timeline.edit(made, f"Duplicate {_what(chosen)}", chosen=chosen)


def mirror(timeline: Timeline) -> None:
    """Move keys and events to the other side of the face; where both sides are chosen they change places."""
    made, chosen = on_other_side(timeline.animation, timeline.chosen, timeline.document.project.units)
    timeline.edit(made, f"Mirror {_what(chosen)}", chosen=chosen)


def nudge(timeline: Timeline, frames: int) -> None:
    """Move what is chosen by frames."""
    made, chosen = moved(
        timeline.animation, timeline.chosen, frames / timeline.rate, 0.0, timeline.document.project.units
    )
    timeline.edit(made, f"Move {_what(chosen)}", "timeline nudge", chosen)


def choose_all(timeline: Timeline) -> None:
    """Choose all keys, those of the chosen lines if any are, and all events."""
    channels = chosen_channels(timeline)
    among = [row for row in rows(timeline.animation) if not channels or row[0] in channels]
    events = frozenset() if channels else frozenset(event.key for event in timeline.animation.events)
    expressions = frozenset() if channels else frozenset(each.time for each in timeline.animation.expressions)
    timeline.choose(Chosen(all_of(timeline.animation, among), events, expressions=expressions))


def choose_others(timeline: Timeline) -> None:
    """Choose the keys that are not chosen instead of those that are."""
    timeline.choose(Chosen(reduced(all_of(timeline.animation), timeline.chosen.keys)))


def choose_column(timeline: Timeline) -> None:
    """Choose all keys at the times of those that are chosen."""
    animation = timeline.animation
    found = timeline.chosen.keys
    for time in _times(animation, timeline.chosen):
        found = merged(found, selected(animation, time, time))
    timeline.choose(replace(timeline.chosen, keys=found))


def shape(timeline: Timeline, wanted: Shape) -> None:
    """Let curves go on from the chosen keys in another way."""
    timeline.edit(shaped_keys(timeline.animation, timeline.chosen.keys, wanted), f"Make {wanted}")


def ease(timeline: Timeline, name: str) -> None:
    """Let curves go on from the chosen keys with a ready ease."""
    timeline.edit(eased_keys(timeline.animation, timeline.chosen.keys, EASES[name]), EASES[name].title)


def flag(timeline: Timeline, weighted: bool | None = None, broken: bool | None = None) -> None:
    """Let handles of the chosen keys count their length, or turn on their own, or no longer."""
    timeline.edit(flagged_keys(timeline.animation, timeline.chosen.keys, weighted, broken), "Change handles")


def put_on_frames(timeline: Timeline) -> None:
    """Move the chosen keys to the nearest frames."""
    made, keys = snapped_keys(timeline.animation, timeline.chosen.keys)
    timeline.edit(made, "Snap to frames", chosen=replace(timeline.chosen, keys=keys))


def level(timeline: Timeline, value: float) -> None:
    """Give all chosen keys one value."""
    units = timeline.document.project.units
    made, keys = valued_keys(timeline.animation, timeline.chosen.keys, value, units)
    timeline.edit(made, "Set value", chosen=replace(timeline.chosen, keys=keys))


def mark(timeline: Timeline, name: str = "") -> None:
    """Set a marker under the playhead, or take the one there away."""
    animation, time = timeline.animation, timeline.playhead.time
    there = [each for each in animation.markers if abs(each.time - time) <= SAME_TIME]
    if there and not name:
        kept = tuple(each for each in animation.markers if each not in there)
        timeline.edit(replace(animation, markers=kept), "Delete marker")
    else:
        label = name or f"Marker {len(animation.markers) + 1}"
        timeline.edit(with_marker(animation, time, label), "Set marker", chosen=Chosen(markers=frozenset((time,))))


def name_range(timeline: Timeline) -> None:
    """Name the stretch of what is chosen, or else of what is played."""
    animation = timeline.animation
    start, end = times_of(animation, timeline.chosen) or (animation.start, animation.end)
    if end - start <= SAME_TIME:
        start, end = animation.start, animation.end
    taken = {each.name for each in animation.ranges}
    name = next(name for k in range(1, len(taken) + 2) if (name := f"Range {k}") not in taken)
    timeline.edit(with_range(animation, name, start, end), "Name range", chosen=Chosen(ranges=frozenset((name,))))


def play_from_here(timeline: Timeline) -> None:
    """Let what is played start at the playhead."""
    animation, time = timeline.animation, timeline.playhead.time
    timeline.edit(played(animation, time, max(animation.end, time)), "Play range")


def play_to_here(timeline: Timeline) -> None:
    """Let what is played end at the playhead."""
    animation, time = timeline.animation, timeline.playhead.time
    timeline.edit(played(animation, min(animation.start, time), time), "Play range")


def drop(timeline: Timeline, expression: DynamicExpression, strength: float = 1.0) -> None:
    """Place a dynamic expression under the playhead."""
    animation, units = timeline.animation, timeline.document.project.units
    made, group = placed(animation, expression, timeline.playhead.time, units, strength)
    keys = frozenset(event.key for event in made.events if event.group == group)
    longer = max([made.end, *(event.ends for event in made.events if event.key in keys)])
    timeline.edit(replace(made, end=longer), f"Add {expression.title}", chosen=Chosen(events=keys))


def _without_empty(animation: Animation) -> Animation:
    """An animation without marks of key expressions that have no key any more."""
    among = list(rows(animation))
    kept = tuple(
        each
        for each in animation.expressions
        if any(curve_of_row(animation, row).near(each.time) is not None for row in among)
    )
    return animation if kept == animation.expressions else replace(animation, expressions=kept)


def _times(animation: Animation, chosen: Chosen) -> tuple[float, ...]:
    found = {
        float(curve_of_row(animation, row).times[place]) for row, places in chosen.keys.items() for place in places
    }
    return tuple(sorted(found))


def _what(chosen: Chosen) -> str:
    """What is chosen, for the label of a step."""
    if chosen.expressions and not chosen.events:
        return "key expressions" if len(chosen.expressions) > 1 else "key expression"
    for name, count in (
        ("key", chosen.key_count),
        ("event", len(chosen.events)),
        ("sound", len(chosen.sounds)),
        ("marker", len(chosen.markers)),
        ("range", len(chosen.ranges)),
    ):
        if count:
            return f"{count} {name}s" if count > 1 else name
    return "nothing"
