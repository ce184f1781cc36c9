"""How values become colours and back: spans of greys, lines and tensors as RGB, and the note in the file."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from facemodel.errors import PaintError, ProjectError
from facemodel.io.png import Picture
from facemodel.painting.layers import PaintLayer
from fem.types import BoolArray, FloatArray

NOTE = "risorius"
"""Name of the text in the file that says which layer it is and what black and white stand for."""

SLACK = 1e-9
"""Part of a range by which a value may be beyond it; rounding does no more."""


@dataclass(frozen=True)
class Span:
    """The values of black and white.

    Raises
    ------
    PaintError
        If the lower one is not the lower one.
    """

    low: float
    high: float

    def __post_init__(self) -> None:
        if not (np.isfinite([self.low, self.high]).all() and self.low < self.high):
            raise PaintError(f"From {self.low:g} to {self.high:g} is no span; choose a lower and a higher value.")


def whole_span(layer: PaintLayer) -> Span:
    """All that a layer can be painted with."""
    return Span(layer.low, layer.high)


def check_within(layer: PaintLayer, values: FloatArray, span: Span, what: str, remedy: str) -> None:
    """Refuse values outside a span.

    Raises
    ------
    PaintError
        ``what`` holds a value outside the span; ``remedy`` is what to do about it.
    """
    slack = SLACK * (span.high - span.low)
    beyond = values[~((values >= span.low - slack) & (values <= span.high + slack))]
    if len(beyond):
        raise PaintError(
            f"{what} holds {beyond[0]:g} {layer.unit}, which is outside {span.low:g} to {span.high:g}; {remedy}."
        )


def note(key: str, unit: str, span: Span) -> str:
    """The text that goes with a picture."""
    return json.dumps({"layer": key, "unit": unit, "low": span.low, "high": span.high}, ensure_ascii=False)


def noted_span(path: Path, picture: Picture, unit: str) -> Span | None:
    """The span in the note of a picture, or None if there is no note.

    Raises
    ------
    ProjectError
        If the note is damaged, or the picture is of a layer with another unit.
    """
    text = picture.notes.get(NOTE)
    if text is None:
        return None
    try:
        found = json.loads(text)
        span = Span(float(found["low"]), float(found["high"]))
        layer, noted = str(found["layer"]), str(found["unit"])
    except (ValueError, KeyError, TypeError, RecursionError, PaintError) as error:
        raise ProjectError(
            f"“{path}” cannot be used: its note “{NOTE}” is damaged; remove the note, or export the layer again."
        ) from error
    if noted != unit:
        raise ProjectError(
            f"“{path}” cannot be used: it was exported from “{layer}”, whose unit is “{noted}” and not “{unit}”; "
            "choose the picture of this layer."
        )
    return span


def encoded_lines(lines: NDArray[np.complex128]) -> FloatArray:
    """Lines (N,) of twice the angle as red and green (N, 3) around a half, and half blue."""
    unit = lines / np.maximum(np.abs(lines), np.finfo(float).tiny)
    return np.column_stack([(1 + unit.real) / 2, (1 + unit.imag) / 2, np.full(len(lines), 0.5)])


def decoded_lines(colours: FloatArray) -> NDArray[np.complex128]:
    """Lines (N,) of colours (N, 3 or 4); the shorter, the less they say."""
    return np.asarray((2 * colours[:, 0] - 1) + 1j * (2 * colours[:, 1] - 1))


def encoded_tensors(principal: FloatArray, lines: NDArray[np.complex128], high: float) -> FloatArray:
    """Symmetric tensors as colours (N, 3): red the level entry, green the upright one, blue the mixed one.

    Parameters
    ----------
    principal : (N, 2) values along and across the lines
    lines : (N,) unit complex numbers at twice the angle
    high : the value of white
    """
    mean, half = principal.mean(axis=1) / high, (principal[:, 0] - principal[:, 1]) / 2 / high
    return np.column_stack([mean + half * lines.real, mean - half * lines.real, 0.5 + half * lines.imag])


def decoded_tensors(
    colours: FloatArray, grain: NDArray[np.complex128], high: float, flat: float
) -> tuple[FloatArray, NDArray[np.complex128], BoolArray]:
    """Principal values (N, 2) along and across lines (N,), and which of the lines are known.

    A tensor is the same with its axes exchanged: the one nearer to the grain as it is goes along.

    Parameters
    ----------
    colours : (N, 3 or 4)
    grain : (N,) unit complex numbers at twice the angle, as the vertices have it
    high : the value of white
    flat : difference of level and upright parts up to which a tensor has no direction
    """
    mean = (colours[:, 0] + colours[:, 1]) / 2
    offset = (colours[:, 0] - colours[:, 1]) / 2 + 1j * (colours[:, 2] - 0.5)
    known = np.abs(offset) > flat
    turned = (offset * grain.conj()).real < 0
    size = np.where(known, np.where(turned, -np.abs(offset), np.abs(offset)), 0.0)
    lines = np.where(turned, -offset, offset).astype(np.complex128)
    lines /= np.maximum(np.abs(offset), np.finfo(float).tiny)
    return high * np.column_stack([mean + size, mean - size]), lines, known
