"""An animation as exchange formats hold it: shapes whose weights change, and rigid parts that move.

What the editor draws is no linear sum: lids glide on the eyeballs, the jaw goes along an arc.  Formats add shapes by
weights and no more, so what is missing between both is told by a few corrective shapes, made for the clip.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.animation.take import Take
from facemodel.basis import Basis
from facemodel.errors import ProjectError
from facemodel.io.export.asked import Asked
from facemodel.io.export.fewest import farthest, fewest_shapes, fitted, from_nothing_to_one
from facemodel.io.export.frames import SKIN, PosedFrames, sample_frames
from facemodel.io.export.joints import Joint, joints_of
from facemodel.kinematics import Stance
from facemodel.solution import Progress, silent
from fem.types import Float32Array, FloatArray

WITHIN = 0.05
"""Millimetres between a frame in the editor and in the file within which no more shapes are made; nobody sees them."""

MOST_SHAPES = 64
"""Shapes made for a clip at most, where nobody asks for fewer."""

LEARNED_FROM = 240
"""Frames from which shapes are made at most; all frames are then fitted with them."""


@dataclass(frozen=True, eq=False)
class Shape:
    """One shape.

    Attributes
    ----------
    name : ``AU12L``, ``correction 1`` or ``shape 1``
    moved : (n, 3) float32 by mesh, how far its points go at weight 1, millimetres
    turns : (n, 3) float32 by mesh, how normals change, of the skin and what else bends or turns
    """

    name: str
    moved: Mapping[str, Float32Array]
    turns: Mapping[str, Float32Array]


@dataclass(frozen=True, eq=False)
class Performance:
    """A clip.

    Attributes
    ----------
    rate : frames per second
    times : (T,) seconds from its first frame on
    shapes : (K,) of them
    weights : (T, K)
    joints : head, jaw and eyes
    apart : millimetres, the largest distance of a point that bends from where the editor draws it
    still : whether all but the head moves by shapes, as in a face that other programs animate
    """

    rate: float
    times: FloatArray
    shapes: tuple[Shape, ...]
    weights: FloatArray
    joints: tuple[Joint, ...]
    apart: float
    still: bool = False

    @property
    def remark(self) -> str:
        """What it is, for people."""
        apart = max(self.apart, 0.01)
        return f"{len(self.shapes)} shapes, {len(self.times)} frames, within {apart:.2f} mm of the editor"


def performance(take: Take, basis: Basis, asked: Asked, progress: Progress = silent) -> Performance:
    """Make a take ready for exchange.

    Parameters
    ----------
    take : what is played
    basis : displacement fields of its project
    asked : which shapes are wanted
    progress : told about every frame; may raise `facemodel.solution.Cancelled`

    Raises
    ------
    ProjectError
        If the clip moves more action units than shapes are allowed.
    """
    linear = LinearFrames(take, basis, _named(take, basis, asked))
    chosen = sample_frames(take, LEARNED_FROM)
    learned = np.empty((len(chosen), len(linear.poser.rest)), dtype=np.float32)
    for row, frame in enumerate(chosen):
        progress(f"Looking for shapes, frame {row + 1} of {len(chosen)}", 0.4 * row / len(chosen))
        learned[row] = linear.missing(frame)
    room = (asked.most or MOST_SHAPES) - len(linear.shapes) - 1
    mean, made = fewest_shapes(learned, WITHIN, room)
    del learned
    fit = _Fit(mean, made)
    for frame in range(len(take)):
        progress(f"Fitting shapes, frame {frame + 1} of {len(take)}", 0.4 + 0.6 * frame / len(take))
        fit.add(linear.missing(frame), linear.missing_normals(frame), linear.poser.stance)
    extra, weights = _made_shapes(fit, linear, "correction" if asked.shaping == "units" else "shape")
    return Performance(
        take.rate,
        np.arange(len(take)) / take.rate,
        (*linear.shapes, *extra),
        np.concatenate([linear.weights, weights], axis=1),
        joints_of(take.project.face, fit.stances),
        fit.apart,
    )


def _made_shapes(fit: _Fit, linear: LinearFrames, word: str) -> tuple[list[Shape], FloatArray]:
    """The shapes made for a clip, the first one with full weight in all frames, and their weights (T, 1 + K)."""
    base, shapes, weights = from_nothing_to_one(fit.mean, fit.shapes, np.stack(fit.weights))
    if not base.any() and not len(shapes):
        return [], weights
    whole = np.column_stack([np.ones(len(weights)), weights])
    normals = fit.normals(whole)
    names = [f"{word} base", *(f"{word} {k + 1}" for k in range(len(shapes)))]
    moved = [base, *shapes]
    return [linear.shape(name, *each) for name, *each in zip(names, moved, normals, strict=True)], whole


def _named(take: Take, basis: Basis, asked: Asked) -> tuple[str, ...]:
    """The fields that are given shapes of their own: those that weigh anything in the clip."""
    if asked.shaping == "clip":
        return ()
    moving = set(take.sampled.channels) | {name for name, weight in take.project.expression.items() if weight}
    named = tuple(name for name in basis.names if name in moving)
    if asked.most is not None and len(named) > asked.most:
        raise ProjectError(
            f"This clip moves {len(named)} sides of action units, more than the {asked.most} shapes that are allowed; "
            "allow more, or ask for shapes made for the clip."
        )
    return named


class LinearFrames:
    """A take as the sum of its fields alone, and what that leaves out of each frame.

    Attributes
    ----------
    poser : poses the frames
    shapes : (K,) one for each of some fields, at activation 1
    weights : (T, K)
    """

    def __init__(self, take: Take, basis: Basis, named: Sequence[str]) -> None:
        self._take = take
        self.poser = PosedFrames(take.project, basis)
        self.shapes: list[Shape] = []
        fields = np.empty((len(named), len(self.poser.rest)), dtype=np.float32)
        for row, name in enumerate(named):
            fields[row] = self.poser.moved({name: 1.0})
            self.shapes.append(self.shape(f"AU{name}", fields[row], self.poser.normals))
        self._fields = fields
        self._normals = np.array([shape.turns[SKIN].ravel() for shape in self.shapes], dtype=np.float32)
        weights = [[take.expression(frame).get(name, 0.0) for name in named] for frame in range(len(take))]
        # What goes beyond 1 is left to the corrections: Blender's reader cuts it off.
        self.weights: FloatArray = np.minimum(np.array(weights).reshape(len(take), len(named)), 1.0)

    def shape(self, name: str, moved: Float32Array, normals: Float32Array) -> Shape:
        """A shape that moves everything by (3 Q,) and the normals of the skin by (P, 3)."""
        return Shape(name, {mesh: self.poser.of(mesh, moved) for mesh in self.poser.names}, {SKIN: normals})

    def missing(self, frame: int) -> Float32Array:
        """By how much (3 Q,) a frame differs from the sum, millimetres."""
        moved = self.poser.moved(self._take.expression(frame), self._take.rigid(frame))
        if self.shapes:
            moved -= self.weights[frame].astype(np.float32) @ self._fields
        return moved

    def missing_normals(self, frame: int) -> Float32Array:
        """By how much (P, 3) the normals of the frame whose points were asked for last differ from the sum."""
        normals = self.poser.normals
        if self.shapes:
            normals -= (self.weights[frame].astype(np.float32) @ self._normals).reshape(normals.shape)
        return normals


class _Fit:
    """Weights of some shapes for one frame after the other.

    Attributes
    ----------
    mean, shapes : (3 Q,) and (K, 3 Q)
    weights : (K,) of each frame
    stances : how jaw, eyes and head stand in each frame
    apart : millimetres, the largest distance that is left
    """

    def __init__(self, mean: Float32Array, shapes: Float32Array) -> None:
        self.mean, self.shapes = mean, shapes
        self.weights: list[FloatArray] = []
        self.stances: list[Stance] = []
        self.apart = 0.0
        self._turned: FloatArray | None = None

    def add(self, moved: Float32Array, normals: Float32Array, stance: Stance) -> None:
        """Take the next frame: what is to be fitted (3 Q,), the change of the normals (P, 3), the stance."""
        rest = moved - self.mean
        weights = fitted(self.shapes, rest)
        self.weights.append(weights)
        self.stances.append(stance)
        self.apart = max(self.apart, farthest(rest - weights.astype(np.float32) @ self.shapes))
        turned = np.multiply.outer(np.append(weights, 1.0), normals.astype(np.float64))
        self._turned = turned if self._turned is None else self._turned + turned

    def normals(self, weights: FloatArray) -> Float32Array:
        """Changes of the normals (1 + K, P, 3) that come nearest to those of all frames with weights (T, 1 + K).

        The weights are those of `from_nothing_to_one` behind a column of ones, which span what `weights` and ones do.
        """
        assert self._turned is not None
        own = np.column_stack([np.stack(self.weights), np.ones(len(weights))])
        to_own = np.linalg.lstsq(own, weights, rcond=None)[0]
        flat = to_own.T @ self._turned.reshape(len(self._turned), -1)
        found = np.linalg.lstsq(weights.T @ weights, flat, rcond=None)[0]
        return np.asarray(found.reshape(self._turned.shape), dtype=np.float32)
