"""A ten-minute capture of sixty channels in the window: scrubbed and edited, against the bare viewport."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from benchmarks.figure import Figure, alone, compared, interleaved
from benchmarks.timeline_window import timeline_window
from facemodel.animation.channels import channels
from facemodel.animation.clip import Animation
from facemodel.animation.samples import Samples
from facemodel.animation.track import Track
from facemodel.project import Project
from facemodel.projects import new_project

MINUTES, RATE, CHANNELS = 10, 60, 60
REPEATS = 25
EDITED = "12L"
"""The channel whose layer is edited."""

LIMIT = 1.25
"""Beyond this the frames of the timeline would be seen to be fewer than those of the face alone."""


def figures() -> Iterator[Figure]:
    """Measure frames of the bare viewport and of the same viewport with a long capture under the hand."""
    project = _captured(new_project())
    with timeline_window(project, EDITED) as window:
        window.begin_scrubbing()
        scrubbed = interleaved({"scrub": window.scrub, "bare": window.pose}, REPEATS)
        window.end_scrubbing()
        window.begin_editing()
        edited = interleaved({"edit": window.edit, "bare": window.pose}, REPEATS)
        window.end_editing()
    what = f"{MINUTES} minutes of {CHANNELS} channels at {RATE} Hz"
    yield alone("a frame of the bare viewport beside the timeline", scrubbed["bare"])
    yield compared(f"scrub to drawn frame, {what}", scrubbed["scrub"], "the bare viewport", scrubbed["bare"], LIMIT)
    yield compared(
        f"key of a layer dragged to drawn frame, {what}", edited["edit"], "the bare viewport", edited["bare"], LIMIT
    )


def _captured(project: Project) -> Project:
    """Slow waves on sixty channels, weaker than full so that the face stays one."""
    random = np.random.default_rng(9)
    times = np.arange(MINUTES * 60 * RATE) / RATE
    names = [channel.name for channel in channels(project.units)][:CHANNELS]
    waves = (0.1 + 0.1 * np.sin(times * random.uniform(0.2, 2.0) + random.uniform(0, 6)) for _ in names)
    tracks = tuple(
        Track(name, captured=Samples(wave.astype(np.float32), float(RATE)))
        for name, wave in zip(names, waves, strict=True)
    )
    return replace(project, animation=Animation(tracks, rate=float(RATE), end=60.0 * MINUTES))
