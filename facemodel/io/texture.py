"""Painted layers as pictures in the face's texture coordinates, so that other programs can paint them.

==========  =========================================================================================================
layer       picture
==========  =========================================================================================================
amounts     grey, 8 or 16 bits: black is the lower end of the span, white the upper one, linear between
supports    grey, 8 or 16 bits: 0 free, 1/3 value held, 2/3 value and slope held, 1 sliding; no greys between
grain       RGB, 8 bits: R = (1 + cos 2a) / 2, G = (1 + sin 2a) / 2, a the angle to the horizontal; B = 1/2
stretching  RGBA, 8 bits: R level, G upright and B - 1/2 mixed entry of the tensor as parts of the span's upper end;
            A = 1 where the skin is, and what is transparent is not read
==========  =========================================================================================================

The span, the layer and its unit are noted in the file; a file without notes is read with the layer's whole range.
Vertices that have no place of their own in the picture keep their values.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from facemodel.errors import PaintError
from facemodel.face import Face
from facemodel.io.png import LARGEST, SMALLEST, read_png, write_png
from facemodel.io.texture_codes import (
    NOTE,
    Span,
    check_within,
    decoded_lines,
    decoded_tensors,
    encoded_lines,
    encoded_tensors,
    note,
    noted_span,
    whole_span,
)
from facemodel.io.uv_map import TexturedSkin, reading, spread, texels_on, textured_skin, true_at_vertices
from facemodel.painting.delta import LayerDelta, layer_delta
from facemodel.painting.frames import angle_of, direction_at, doubled, line_at, tangent_frames
from facemodel.painting.layers import LAYER, Kind, PaintLayer
from fem.types import Float32Array, FloatArray, IntArray

Bits = Literal[8, 16]

SIZE = 2048
"""Texels along a side: about two to a millimetre of skin."""

FAINTEST = 0.25
"""Length of the vector in red and green below which a picture says nothing about the grain."""

FLATTEST = 2 / 255
"""Anisotropy of a tensor, as a part of white, that is lost in eight bits."""

OPAQUE = 0.5
"""Least alpha at which a vertex is read."""

TENSOR = "stretching"
"""What the picture of the stretching tensor is called in its note."""

WIDER = "choose a span that holds all values"
TAME = "paint it within this range, or choose the right span"


@dataclass(frozen=True, eq=False)
class Loss:
    """Where a picture is too coarse: several vertices of different values share its texels.

    Attributes
    ----------
    vertices : (k,) whose colours are read back more than a quantisation step off
    worst : by how much of the way from black to white
    """

    vertices: IntArray
    worst: float


def export_layer(
    face: Face, layer: PaintLayer, path: Path, size: int = SIZE, bits: Bits = 16, span: Span | None = None
) -> Loss:
    """Write a layer as a square picture.

    Parameters
    ----------
    face : whose layer
    layer : which one; the grain is written as RGB with 8 bits
    path : the PNG file
    size : texels along each side
    bits : of a grey
    span : of an amount; the layer's range by default

    Returns
    -------
    What the picture is too coarse for.

    Raises
    ------
    PaintError
        If the size is not possible, or the span does not hold all values.
    ProjectError
        If the file cannot be written.
    """
    skin = _skin(face, size)
    values = layer.values(face)
    span = span if span is not None and layer.kind == "amount" else whole_span(layer)
    if layer.kind == "angle":
        colours, bits = encoded_lines(line_at(values)), 8
    else:
        check_within(layer, values[skin.vertices], span, f"The layer “{layer.title}”", WIDER)
        colours = (values[:, None] - span.low) / (span.high - span.low)
    picture = _chosen(skin, colours, size) if layer.kind == "choice" else _drawn(skin, colours, size)
    texels = _quantised(picture, bits)
    write_png(path, texels, {NOTE: note(layer.key, layer.unit, span)})
    return _loss(skin, texels, colours, layer.kind)


def export_tensor(face: Face, path: Path, size: int = SIZE, high: float | None = None) -> Loss:
    """Write stretching along and across the grain and the grain in one picture, as a tensor.

    Parameters
    ----------
    face : whose stretching
    path : the PNG file
    size : texels along each side
    high : the value of white, N/mm; the upper end of the layer's range by default

    Returns
    -------
    What the picture is too coarse for.

    Raises
    ------
    PaintError
        If the size is not possible, or a value is above ``high``.
    ProjectError
        If the file cannot be written.
    """
    skin, layer, layers = _skin(face, size), LAYER["stretching-along"], face.layers
    span = whole_span(layer) if high is None else Span(0.0, high)
    check_within(layer, layers.stretching[skin.vertices].ravel(), span, "The stretching", WIDER)
    colours = encoded_tensors(layers.stretching, _grain(face), span.high)
    colours = np.column_stack([colours, np.ones(len(colours))])
    texels = _quantised(_drawn(skin, colours, size), 8)
    write_png(path, texels, {NOTE: note(TENSOR, layer.unit, span)})
    return _loss(skin, texels, colours, "amount")


def import_layer(face: Face, layer: PaintLayer, path: Path, span: Span | None = None) -> LayerDelta:
    """Read a layer from a picture.

    Parameters
    ----------
    face : whose layers are to be changed
    layer : which one
    path : the PNG file
    span : of an amount; that of the file's note by default, and the layer's range where there is none

    Returns
    -------
    The change; vertices that have no place of their own in the picture are not in it.

    Raises
    ------
    ProjectError
        If there is no such file, it is damaged, or of another size, colour type or unit.
    PaintError
        If the picture holds values outside the layer's range.
    """
    wanted = f"the layer “{layer.title}”"
    lines = layer.kind == "angle"
    picture = read_png(path, ("RGB", "RGBA") if lines else ("grey",), (8,) if lines else (8, 16), wanted)
    noted = noted_span(path, picture, layer.unit)
    skin = textured_skin(face)
    height, width = picture.texels.shape[:2]
    read = reading(skin.uv[skin.vertices], width, height)
    if lines:
        found = decoded_lines(read.of(picture.texels) / picture.white)
        clear = np.abs(found) >= FAINTEST
        return layer.delta(face, skin.vertices[clear], angle_of(found[clear]))
    if layer.kind == "choice":
        shares = picture.texels.reshape(-1)[read.nearest] / picture.white
        span = whole_span(layer)
    else:
        shares = read.of(picture.texels)[:, 0] / picture.white
        span = span or noted or whole_span(layer)
    values = span.low + shares * (span.high - span.low)
    check_within(layer, values, whole_span(layer), f"“{path}”", TAME)
    return layer.delta(face, skin.vertices, values)


def import_tensor(face: Face, path: Path, high: float | None = None) -> tuple[LayerDelta, LayerDelta]:
    """Read stretching along and across the grain, and the grain, from a picture of the tensor.

    Parameters
    ----------
    face : whose layers are to be changed
    path : the PNG file, RGB or RGBA; what is transparent is not read
    high : the value of white, N/mm; that of the file's note by default, else the upper end of the layer's range

    Returns
    -------
    The changes of the stretching and of the direction; where the tensor has none, the grain stays as it is.

    Raises
    ------
    ProjectError, PaintError
        As `import_layer` does.
    """
    picture = read_png(path, ("RGB", "RGBA"), (8,), "the stretching tensor")
    layer = LAYER["stretching-along"]
    noted = noted_span(path, picture, layer.unit)
    white = high if high is not None else (noted or whole_span(layer)).high
    skin = textured_skin(face)
    height, width = picture.texels.shape[:2]
    colours = reading(skin.uv[skin.vertices], width, height).of(picture.texels) / picture.white
    seen = colours[:, 3] >= OPAQUE if picture.colour == "RGBA" else np.ones(len(colours), dtype=np.bool_)
    vertices, colours = skin.vertices[seen], colours[seen]
    principal, lines, known = decoded_tensors(colours, _grain(face)[vertices], white, FLATTEST)
    check_within(layer, principal.ravel().clip(min=0), whole_span(layer), f"“{path}”", TAME)
    turned = vertices[known]
    rows = direction_at(angle_of(lines[known]), tangent_frames(face.skin.normals[turned]))
    return (
        layer_delta(face.layers, "stretching", vertices, layer.fitting(principal)),
        layer_delta(face.layers, "direction", turned, rows),
    )


def _grain(face: Face) -> NDArray[np.complex128]:
    return line_at(angle_of(doubled(face.layers.direction, tangent_frames(face.skin.normals))))


def _skin(face: Face, size: int) -> TexturedSkin:
    if not SMALLEST <= size <= LARGEST:
        raise PaintError(f"A picture of {size} texels is not possible; choose between {SMALLEST} and {LARGEST}.")
    return textured_skin(face)


def _drawn(skin: TexturedSkin, colours: FloatArray, size: int) -> Float32Array:
    """The picture (size, size, C) of colours (N, C) at the vertices, linear in every triangle."""
    texels = texels_on(skin, size, size)
    inside = np.einsum("kc,kcx->kx", texels.shares, colours[texels.corners])
    picture = spread(inside.astype(np.float32), texels.index, size)
    read = reading(skin.uv[skin.vertices], size, size)
    return true_at_vertices(picture, read, colours[skin.vertices])


def _chosen(skin: TexturedSkin, colours: FloatArray, size: int) -> Float32Array:
    """The picture (size, size, C) of colours (N, C) at the vertices: every texel has that of the nearest corner."""
    texels = texels_on(skin, size, size)
    nearest = np.take_along_axis(texels.corners, texels.shares.argmax(axis=1)[:, None], axis=1)[:, 0]
    picture = spread(colours[nearest].astype(np.float32), texels.index, size)
    flat = picture.reshape(size * size, -1)
    flat[reading(skin.uv[skin.vertices], size, size).nearest] = colours[skin.vertices]
    return picture


def _quantised(picture: Float32Array, bits: Bits) -> NDArray[np.uint8] | NDArray[np.uint16]:
    white = (1 << bits) - 1
    levels = np.rint(np.clip(picture, 0.0, 1.0) * white)
    return levels.astype(np.uint8) if bits == 8 else levels.astype(np.uint16)


def _loss(skin: TexturedSkin, texels: NDArray[Any], colours: FloatArray, kind: Kind) -> Loss:
    read, white = reading(skin.uv[skin.vertices], texels.shape[1], texels.shape[0]), np.iinfo(texels.dtype).max
    there = texels.reshape(-1, texels.shape[2])[read.nearest] if kind == "choice" else read.of(texels)
    off = np.abs(there / white - colours[skin.vertices]).max(axis=1)
    return Loss(skin.vertices[off > 1 / white], float(off.max()))
