"""Curves over time: a hundred at one moment, and a ten-minute capture of sixty channels loaded, edited and saved."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from app.authoring.importing import with_capture
from app.document import Document
from app.playback import Playhead
from benchmarks.figure import Figure, alone, compared, interleaved
from facemodel.animation.capture import Capture
from facemodel.animation.clip import Animation
from facemodel.animation.curve import curve_through
from facemodel.animation.evaluation import Evaluator, sampled
from facemodel.animation.track import Track
from facemodel.io.project_file import project_bytes, project_of
from facemodel.io.weights import read_capture
from facemodel.io.weights.names import ARKIT
from facemodel.project import Project
from facemodel.projects import new_project

CURVES, KEYS = 100, 200
MINUTES, RATE, CHANNELS = 10, 60, 52
REPEATS = 41

MOMENT = 1e-3
"""Seconds that a hundred curves may take; a sixteenth of a frame."""

FRAME = 1 / 60
"""Seconds within which an edit has to be seen."""


def figures() -> Iterator[Figure]:
    """Measure curves of keys, then a long capture."""
    yield from _moments()
    yield from _capture()


def _moments() -> Iterator[Figure]:
    random = np.random.default_rng(4)
    tracks = tuple(
        Track(f"{number}", curve_through(np.cumsum(random.uniform(0.05, 0.5, KEYS)), random.random(KEYS)))
        for number in range(CURVES)
    )
    evaluator = Evaluator(Animation(tracks))
    times = random.uniform(0, 50, (REPEATS + 1, 1))
    moments = iter(times)
    taken = interleaved({"one": lambda: evaluator.at(next(moments))}, REPEATS)
    yield _against(f"{CURVES} curves of {KEYS} keys at one time", taken["one"], "1 ms", MOMENT)


def _capture() -> Iterator[Figure]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "take.csv"
        path.write_text(_recording(), encoding="utf-8")
        size = path.stat().st_size / 1e6
        loaded = interleaved({"load": partial(read_capture, path)}, 3)
        capture = read_capture(path)
    yield alone(f"{MINUTES} minutes of {CHANNELS} channels at {RATE} Hz read, {size:.0f} MB of text", loaded["load"])
    yield from _edited(new_project(), capture)


def _edited(project: Project, capture: Capture) -> Iterator[Figure]:
    made = with_capture(project, capture).project
    document = Document(made)
    playhead = Playhead(document)
    at = iter(np.linspace(10, 500, 4 * REPEATS))

    def scrub() -> None:
        playhead.go(float(next(at)))

    def key() -> None:
        playhead.key({"12L": 0.9}, gesture="drag")

    taken = interleaved({"scrub": scrub, "key": key}, REPEATS)
    channels = len(made.animation.tracks)
    yield _against(f"scrubbing through {channels} captured curves, without drawing", taken["scrub"], "1 ms", MOMENT)
    yield _against("a key dragged over it, as a step of the document", taken["key"], "a frame", FRAME)
    clip = interleaved({"clip": lambda: sampled(document.project.animation, project.units)}, 3)
    yield alone("all of it sampled frame by frame", clip["clip"])
    saved = interleaved({"save": lambda: project_bytes(document.project)}, 3)
    data = project_bytes(document.project)
    opened = interleaved({"open": lambda: project_of(data)}, 3)
    yield alone(f"project with it packed, {len(data) / 1e6:.0f} MB", saved["save"])
    yield alone("project with it opened", opened["open"])


def _against(what: str, taken: np.ndarray, against: str, seconds: float) -> Figure:
    figure = compared(what, taken, against, np.full(len(taken), seconds))
    return replace(figure, limit=1.0)


def _recording() -> str:
    """A table of ARKit's channels in slow motion, of numbers as trackers write them."""
    random = np.random.default_rng(9)
    count = MINUTES * 60 * RATE
    times = np.arange(count) / RATE
    speeds, phases = random.uniform(0.2, 2.0, CHANNELS), random.uniform(0, 6, CHANNELS)
    values = 0.4 + 0.4 * np.sin(times[:, None] * speeds + phases)
    heading = ",".join(("time", *ARKIT))
    rows = (f"{time:.4f}," + ",".join(f"{value:.8f}" for value in row) for time, row in zip(times, values, strict=True))
    return "\n".join([heading, *rows, ""])
