"""The timeline's share of the table of actions."""

from __future__ import annotations

from dataclasses import replace

from app.actions.action import Action
from app.timeline import deeds, keying, layers
from app.timeline.entry import (
    Entry,
    with_anything,
    with_capture,
    with_keys,
    with_keys_or_events,
    with_things,
    with_tracks,
)
from app.timeline.timeline import Timeline
from app.timeline.whole import OPERATIONS
from facemodel.animation.curve import SHAPES, Shape
from facemodel.animation.editing.eases import EASES
from facemodel.animation.idle import Idle
from facemodel.animation.library import library

SHAPE_TITLES: dict[Shape, str] = {"step": "Step", "linear": "Linear", "smooth": "Smooth", "bezier": "Bezier"}


def timeline_actions(timeline: Timeline) -> tuple[Action, ...]:
    """Everything that can be done with a timeline, in the order of its menu."""
    return tuple(entry.action(timeline, menu, group) for menu, group, entries in SECTIONS for entry in entries)


def _toggle_play(timeline: Timeline) -> None:
    head = timeline.playhead
    head.pause() if head.playing else head.play()


def _toggle_loop(timeline: Timeline) -> None:
    animation = timeline.animation
    timeline.edit(replace(animation, loop=not animation.loop), "Stop looping" if animation.loop else "Loop")


def _toggle_auto_key(timeline: Timeline) -> None:
    timeline.playhead.auto_key = not timeline.playhead.auto_key


def _toggle_life(timeline: Timeline) -> None:
    animation = timeline.animation
    on = animation.idle is None
    timeline.edit(replace(animation, idle=Idle() if on else None), "Add idle life" if on else "Remove idle life")


PLAYING = (
    Entry(
        "play",
        "Play",
        _toggle_play,
        "Play the animation in real time, or pause it",
        shortcut="Space",
        caption=lambda timeline: "Pause" if timeline.playhead.playing else "Play",
    ),
    Entry(
        "loop",
        "Loop",
        _toggle_loop,
        "Begin anew at the end of what is played",
        on=lambda timeline: timeline.animation.loop,
    ),
)

GOING = (
    Entry(
        "start",
        "Start",
        lambda timeline: timeline.playhead.go(timeline.animation.start),
        "Go to the start of what is played",
        shortcut="Shift+Home",
    ),
    Entry(
        "end",
        "End",
        lambda timeline: timeline.playhead.go(timeline.animation.end),
        "Go to the end of what is played",
        shortcut="Shift+End",
    ),
    Entry(
        "start-here",
        "Start here",
        deeds.play_from_here,
        "Let what is played start at the playhead",
    ),
    Entry("end-here", "End here", deeds.play_to_here, "Let what is played end at the playhead"),
    Entry("frame-back", "Previous frame", lambda t: t.playhead.go_frames(-1), "Go one frame back", shortcut=","),
    Entry("frame-on", "Next frame", lambda t: t.playhead.go_frames(1), "Go one frame on", shortcut="."),
    Entry(
        "key-back",
        "Previous key",
        lambda timeline: keying.go_to_key(timeline, -1),
        "Go to the key before, of the chosen tracks or of all",
        shortcut="Shift+,",
        also=("Shift+<", "Shift+;"),
    ),
    Entry(
        "key-on",
        "Next key",
        lambda timeline: keying.go_to_key(timeline, 1),
        "Go to the next key, of the chosen tracks or of all",
        shortcut="Shift+.",
        also=("Shift+>", "Shift+:"),
    ),
)

KEYING = (
    Entry(
        "key",
        "Key expression",
        keying.key_expression,
        "Make what the face shows now a key expression under the playhead",
        shortcut="E",
    ),
    Entry(
        "key-chosen",
        "Key chosen tracks",
        lambda timeline: keying.key_channels(timeline, keying.chosen_channels(timeline)),
        "Key what the chosen tracks show now, and nothing else",
        with_tracks,
        "Shift+E",
    ),
    Entry(
        "auto-key",
        "Auto-key",
        _toggle_auto_key,
        "Whatever is changed on the face becomes a key at once",
        on=lambda timeline: timeline.playhead.auto_key,
    ),
)

EDITING = (
    Entry("cut", "Cut", deeds.cut, "Copy what is chosen on the timeline and delete it (Ctrl+X)", with_keys_or_events),
    Entry("copy", "Copy", deeds.copy, "Copy what is chosen on the timeline (Ctrl+C)", with_keys_or_events),
    Entry(
        "paste",
        "Paste",
        deeds.paste,
        "Put what was copied under the playhead, or onto the chosen tracks (Ctrl+V)",
        lambda timeline: bool(timeline.clip),
    ),
    Entry("duplicate", "Duplicate", deeds.duplicate, "Copies behind what is chosen (Ctrl+D)", with_keys_or_events),
    Entry("delete", "Delete", deeds.delete, "Delete what is chosen, or the chosen tracks (Delete)", with_anything),
)

TURNING = (
    Entry(
        "mirror",
        "Mirror left and right",
        deeds.mirror,
        "Move keys and events to the other side of the face (M)",
        with_keys_or_events,
    ),
    Entry("nudge-back", "Move a frame back", lambda t: deeds.nudge(t, -1), "Move it (Alt+Left)", with_things),
    Entry("nudge-on", "Move a frame on", lambda t: deeds.nudge(t, 1), "Move it (Alt+Right)", with_things),
    Entry("snap", "Snap to frames", deeds.put_on_frames, "Move the chosen keys to the nearest frames", with_keys),
)

CHOOSING = (
    Entry("all", "Choose all", deeds.choose_all, "Choose all keys of the chosen tracks, or everything (A)"),
    Entry("others", "Choose the others", deeds.choose_others, "Choose the keys that are not chosen (Ctrl+I)"),
    Entry(
        "column",
        "Choose at these times",
        deeds.choose_column,
        "Choose the keys of all tracks at the times of those that are chosen (C)",
        with_keys,
    ),
)

SHAPING = tuple(
    Entry(
        f"shape.{name}",
        SHAPE_TITLES[name],
        lambda timeline, name=name: deeds.shape(timeline, name),  # type: ignore[misc]
        f"Let curves go on from the chosen keys: {name}",
        with_keys,
    )
    for name in SHAPES
)

EASING = tuple(
    Entry(
        f"ease.{name}",
        ease.title,
        lambda timeline, name=name: deeds.ease(timeline, name),  # type: ignore[misc]
        "Let curves go on from the chosen keys with this ease",
        with_keys,
    )
    for name, ease in EASES.items()
)

DROPPING = tuple(
    Entry(
        f"drop.{each.name.replace(' ', '-')}",
        each.title,
        lambda timeline, each=each: deeds.drop(timeline, each),  # type: ignore[misc]
        f"Let the face do this from the playhead on: {each.title}, {each.duration:.1f} s",
    )
    for each in library()
)

WHOLE = tuple(
    Entry(
        f"curves.{each.key}",
        f"{each.title}…",
        lambda timeline, key=each.key: timeline.change(page=key),  # type: ignore[misc]
        f"{each.hint}: the chosen tracks, or all",
        lambda timeline: bool(timeline.animation.tracks),
    )
    for each in OPERATIONS.values()
)

LAYERING = (
    Entry(
        "layer.add",
        "Add layer",
        lambda timeline: layers.add_layer(timeline, keying.chosen_channels(timeline)[0]),
        "A layer over the captured curve of the chosen track, which keys can bend",
        with_capture,
    ),
    Entry(
        "layer.bake",
        "Bake layers",
        lambda timeline: layers.bake_layers(
            timeline, keying.chosen_channels(timeline) or layers.layered_channels(timeline)
        ),
        "Make layers part of the captured curves: of the chosen tracks, or all",
        lambda timeline: bool(layers.layered_channels(timeline)),
    ),
)

ADDING = (
    Entry(
        "idle",
        "Idle life",
        _toggle_life,
        "Blinks, small jumps of the eyes and breathing, from a seed",
        on=lambda timeline: timeline.animation.idle is not None,
    ),
    Entry("marker", "Marker", deeds.mark, "Mark this moment, or take its marker away", shortcut="Ctrl+M"),
    Entry("range", "Named range", deeds.name_range, "Name the stretch of what is chosen, or of what is played"),
)

SECTIONS: tuple[tuple[tuple[str, ...], int, tuple[Entry, ...]], ...] = (
    ((), 0, PLAYING),
    (("Go to",), 0, GOING),
    ((), 1, KEYING),
    (("Edit",), 2, EDITING),
    (("Edit",), 3, TURNING),
    (("Edit",), 4, CHOOSING),
    (("Interpolation",), 2, SHAPING),
    (("Interpolation",), 3, EASING),
    (("Curves",), 2, WHOLE),
    (("Curves",), 3, LAYERING),
    (("Add", "Dynamic expression"), 3, DROPPING),
    (("Add",), 4, ADDING),
)
"""Submenu, group and entries, in the order of the menu."""
