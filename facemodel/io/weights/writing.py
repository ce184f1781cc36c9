"""Writes weights over time in the formats of other programs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.animation.channels import RIGID
from facemodel.animation.evaluation import Sampled
from facemodel.animation.mapping import export_mapping, fields_of
from facemodel.basis import Basis
from facemodel.errors import ProjectError
from facemodel.face import Face
from facemodel.io.disk import replacing
from facemodel.io.weights.fap_writing import fap_text
from facemodel.io.weights.names import ARKIT, TURNS, arkit_name
from fem.types import FloatArray

LARGEST_TURN = 4.0
"""Radians; a head does not turn farther, and the columns of Live Link Face hold no more."""


@dataclass(frozen=True, eq=False)
class Animated:
    """What is exported.

    Attributes
    ----------
    clip : frame by frame
    units : of the face
    face : that is animated
    basis : its displacement fields; only MPEG-4 needs them
    name : of the clip
    """

    clip: Sampled
    units: Sequence[ActionUnit]
    face: Face
    basis: Basis | None = None
    name: str = "clip"


@dataclass(frozen=True)
class WeightExport:
    """A format.

    Attributes
    ----------
    title : of the format
    suffix : of its files
    holds : what is in them
    text : makes the file
    needs_basis : whether the face has to be solved
    """

    title: str
    suffix: str
    holds: str
    text: Callable[[Animated], str]
    needs_basis: bool = False


def export_weights(animated: Animated, path: Path, kind: str) -> None:
    """Write weights over time.

    Parameters
    ----------
    kind : one of `WEIGHT_EXPORTS`

    Raises
    ------
    ProjectError
        If there is no such format, the face has to be solved for it and is not, or the file cannot be written.
    """
    if kind not in WEIGHT_EXPORTS:
        raise ProjectError(f"There is no format “{kind}” for weights; choose one of {', '.join(WEIGHT_EXPORTS)}.")
    export = WEIGHT_EXPORTS[kind]
    if path.suffix.lower() != export.suffix:
        raise ProjectError(f"“{path}” cannot be saved: {export.title} files end in {export.suffix}.")
    if export.needs_basis and animated.basis is None:
        raise ProjectError(f"{export.title} tells how far points of the face move; solve the face first.")
    text = export.text(animated)
    with replacing(path) as stream:
        stream.write(text.encode())


def plain_text(animated: Animated) -> str:
    """Time, then every channel that moves by its name; numbers come back as they were."""
    clip = animated.clip
    heading = ",".join(("time", *clip.channels))
    rows = zip(clip.times.tolist(), clip.values.tolist(), strict=True)
    lines = [",".join([_short(time), *map(_short, values)]) for time, values in rows]
    return "\n".join([heading, *lines, ""])


def _short(value: float) -> str:
    return f"{value:.9g}"


def arkit_text(animated: Animated) -> str:
    """Time, then the 52 blend shapes of ARKit in its own spelling."""
    values = arkit_values(animated)
    heading = ",".join(("time", *map(arkit_name, ARKIT)))
    shapes = np.stack([values[name] for name in ARKIT], axis=1).tolist()
    rows = zip(animated.clip.times.tolist(), shapes, strict=True)
    return "\n".join([heading, *(",".join([_short(t), *(f"{v:.6f}" for v in row)]) for t, row in rows), ""])


def live_link_text(animated: Animated) -> str:
    """The table of Live Link Face: timecode, how many channels, the blend shapes, and turns of head and eyes."""
    values = arkit_values(animated)
    names = (*ARKIT, *TURNS)
    columns = np.stack([values[name] for name in names], axis=1).tolist()
    heading = ",".join(("Timecode", "BlendShapeCount", *names))
    lines = [
        ",".join([_timecode(time, animated.clip.rate), str(len(names)), *(f"{value:.8f}" for value in row)])
        for time, row in zip(animated.clip.times.tolist(), columns, strict=True)
    ]
    return "\n".join([heading, *lines, ""])


def _timecode(time: float, rate: float) -> str:
    """Hours, minutes, seconds, frames and thousandths of a frame of the real time; a clip begins at no less than 0."""
    base = round(rate)
    thousandths = max(round(time * base * 1000), 0)
    frames, part = divmod(thousandths, 1000)
    seconds, frame = divmod(frames, base)
    return f"{seconds // 3600:02}:{seconds // 60 % 60:02}:{seconds % 60:02}:{frame:02}.{part:03}"


def arkit_values(animated: Animated) -> dict[str, FloatArray]:
    """Every blend shape of ARKit (T,), 0 to 1, and the turns of Live Link Face, radians."""
    clip = animated.clip
    column = {name: k for k, name in enumerate(clip.channels)}
    sums = {name: np.zeros(len(clip.times)) for name in (*ARKIT, *TURNS)}
    for row in export_mapping().rows:
        own = [row.source] if row.source in RIGID else list(fields_of(row.source, animated.units))
        moved = [clip.values[:, column[name]] for name in own if name in column]
        if moved:
            # A unit without sides is one shape for both: half of each.
            sums[row.target] = sums[row.target] + row.gain * np.sum(moved, axis=0) / len(own)
    low = {name: 0.0 if name in ARKIT else -LARGEST_TURN for name in sums}
    high = {name: 1.0 if name in ARKIT else LARGEST_TURN for name in sums}
    return {name: np.clip(values, low[name], high[name]) + 0.0 for name, values in sums.items()}


def _fap(animated: Animated) -> str:
    assert animated.basis is not None
    return fap_text(animated.clip, animated.face, animated.basis, animated.name)


WEIGHT_EXPORTS: Mapping[str, WeightExport] = {
    "weights": WeightExport("Weights", ".csv", "every animated channel by its own name, frame by frame", plain_text),
    "arkit": WeightExport("ARKit weights", ".csv", "the 52 blend shapes of ARKit, frame by frame", arkit_text),
    "live-link": WeightExport("Live Link Face", ".csv", "61 channels with timecode, for Unreal Engine", live_link_text),
    "fap": WeightExport("MPEG-4 face animation", ".fap", "face animation parameters in units of this face", _fap, True),
}
"""By name."""
