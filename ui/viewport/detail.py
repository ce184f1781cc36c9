"""The fine detail of the skin as one picture over the chart: brows, pores and blotches, lines, gloss, furrows.

Red is how much a brow hair covers, green multiplies the colour (one half is neutral), blue multiplies the gloss, and
alpha is how deep the skin furrows there when it is pushed together.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw, ImageFilter
from scipy.ndimage import gaussian_filter

from facemodel.face import Face
from fem.types import FloatArray
from ui.viewport.brows import strokes
from ui.viewport.complexion import lip_share, openings, rings
from ui.viewport.furrows import Furrow
from ui.viewport.surface import ByteArray

PIXELS_PER_MM = 11.0
"""A brow hair is a pixel wide."""
FINER = 3
"""Strokes are drawn this much larger and scaled down, which smooths their edges."""
LARGEST = 4096
"""Pixels per side that every driver takes."""
FURROW = 0.9
"""Millimetres across the deepest part of a furrow."""
TILE = 512
"""Side of the repeating pattern of pores."""
NEUTRAL = 128
BORDER = 120
"""Pixels over which the detail fades towards the border of the picture."""


@dataclass(frozen=True, eq=False)
class Detail:
    """The picture and where the skin lies on it.

    Attributes
    ----------
    image : (h, w, 4) uint8, the first row at v = 0
    coordinates : (N, 2) texture coordinates of the skin vertices; outside 0..1 the border goes on
    """

    image: ByteArray
    coordinates: FloatArray


@dataclass(frozen=True)
class _Window:
    low: FloatArray
    size: tuple[int, int]
    scale: float

    def pixels(self, chart: FloatArray) -> FloatArray:
        return np.asarray((chart - self.low) * self.scale)


def _window(face: Face) -> _Window:
    """The rectangle of the chart that holds the front of the face."""
    position = face.skin.positions
    front = position[:, 2] > position[face.landmarks["lateral_orbit_L"], 2] - 45.0
    front &= position[:, 1] > position[face.landmarks["menton"], 1] - 5.0
    low, high = face.chart[front].min(axis=0) - 4.0, face.chart[front].max(axis=0) + 4.0
    scale = min(PIXELS_PER_MM, LARGEST / float((high - low).max()))
    width, height = np.ceil((high - low) * scale).astype(int)
    return _Window(low, (int(width), int(height)), scale)


def _grain(random: np.random.Generator, pixels: float) -> FloatArray:
    """Repeating noise (TILE, TILE) of about the given grain, mean 0 and deviation 1."""
    noise = gaussian_filter(random.standard_normal((TILE, TILE)), pixels, mode="wrap")
    return np.asarray((noise - noise.mean()) / noise.std())


def _tiled(tile: FloatArray, size: tuple[int, int]) -> FloatArray:
    width, height = size
    return np.tile(tile, (-(-height // TILE), -(-width // TILE)))[:height, :width]


def _blotches(random: np.random.Generator, size: tuple[int, int]) -> FloatArray:
    """Broad, uneven patches that do not repeat, deviation about 1."""
    coarse = gaussian_filter(random.standard_normal((48, 48)), 1.0) * 3.5
    return np.asarray(Image.fromarray(coarse.astype(np.float32)).resize(size, Image.Resampling.BICUBIC))


def _brows(face: Face, window: _Window) -> Image.Image:
    """Coverage of brow hair: strokes over a soft shadow."""
    picture = Image.new("L", window.size, 0)
    for side in "LR":
        hairs = strokes(face, side)
        pixels = window.pixels(hairs.points)
        corner = np.floor(pixels.min(axis=(0, 1))).astype(int) - 24
        size = np.ceil(pixels.max(axis=(0, 1))).astype(int) + 24 - corner
        local = (pixels - corner) * FINER
        large = Image.new("L", (int(size[0]) * FINER, int(size[1]) * FINER), 0)
        pen = ImageDraw.Draw(large)
        for k in np.argsort(hairs.weight):
            ink = int(255 * hairs.weight[k])
            points = [tuple(p) for p in local[k]]
            pen.line(points, fill=int(0.8 * ink), width=2)
            pen.line(points[: len(points) * 2 // 3], fill=ink, width=3)
        sharp = large.resize((int(size[0]), int(size[1])), Image.Resampling.BOX)
        soft = np.asarray(sharp.filter(ImageFilter.GaussianBlur(1.1 * window.scale)), dtype=float)
        cover = np.maximum(np.asarray(sharp, dtype=float), np.clip(soft * 1.35, 0, 168))
        picture.paste(Image.fromarray(cover.astype(np.uint8)), tuple(int(c) for c in corner))
    return picture


def _lip_lines(face: Face, window: _Window, shade: Image.Image) -> None:
    """Fine furrows across the red of the lips, from the wet line to the vermilion border."""
    mouth = openings(face)[0]
    ring = rings(face.skin, mouth, 12)
    border = np.flatnonzero((lip_share(face) > 0.25) & (lip_share(face) < 0.95))
    if len(border) == 0:
        return
    random = np.random.default_rng(3)
    position = face.skin.positions
    pen = ImageDraw.Draw(shade)
    inner = np.flatnonzero((ring <= 2) & (ring >= 1))
    for _ in range(150):
        a, b = random.choice(len(inner), 2)
        mix = random.uniform()
        near = np.linalg.norm(position[inner[a]] - position[inner[b]]) < 6.0
        start = face.chart[inner[a]] * (1 - mix * near) + face.chart[inner[b]] * mix * near
        end = face.chart[border[np.linalg.norm(face.chart[border] - start, axis=1).argmin()]]
        reach = random.uniform(0.5, 0.95)
        path = window.pixels(np.stack([start, start + (end - start) * reach]))
        pen.line([tuple(p) for p in path], fill=int(NEUTRAL - random.uniform(8, 26)), width=2)


def _furrows(lines: Sequence[Furrow], window: _Window) -> ByteArray:
    """How deep each place (h, w) can furrow: sharp in the middle of a line, soft beside it."""
    picture = Image.new("L", window.size, 0)
    pen = ImageDraw.Draw(picture)
    wide = round(FURROW * window.scale)
    pieces = [
        (int(255 * (line.depth[k] + line.depth[k + 1]) / 2), tuple(start), tuple(stop))
        for line in lines
        for k, (start, stop) in enumerate(itertools.pairwise(window.pixels(line.points)))
    ]
    for ink, start, stop in sorted(pieces):
        pen.line([start, stop], fill=ink, width=max(round(wide * ink / 255), 2))
    drawn = np.asarray(picture, dtype=np.float64)
    sharp, soft = (gaussian_filter(drawn, size * window.scale) for size in (FURROW / 2, 2.5 * FURROW))
    return np.clip(1.1 * sharp + 0.8 * soft, 0, 255).astype(np.uint8)


def skin_detail(face: Face, lines: Sequence[Furrow]) -> Detail:
    """Paint the picture for a face with its furrows; the same face always gives the same picture."""
    window = _window(face)
    random = np.random.default_rng(1)
    pores = _tiled(_grain(random, 1.3), window.size)
    blotches = _blotches(random, window.size)
    shade = Image.fromarray(np.clip(NEUTRAL + 3.0 * np.minimum(pores, 0.6) + 4.0 * blotches, 0, 255).astype(np.uint8))
    _lip_lines(face, window, shade)
    gloss = np.clip(NEUTRAL + 17 * pores + 16 * blotches, 0, 255).astype(np.uint8)
    brows = np.asarray(_brows(face, window))
    image = np.stack([brows, np.asarray(shade), gloss, _furrows(lines, window)], axis=2)
    return Detail(_calm_border(image), window.pixels(face.chart) / np.array(window.size))


def _calm_border(image: ByteArray) -> ByteArray:
    """Fade to neutral at the border, since the border goes on over the rest of the head."""
    height, width = image.shape[:2]
    x, y = (np.minimum(np.arange(n), np.arange(n)[::-1]) / BORDER for n in (width, height))
    inside = np.clip(np.minimum(x[None, :], y[:, None]), 0, 1)[..., None]
    calm = np.array([0, NEUTRAL, NEUTRAL, 0])
    return np.asarray(calm + (image - calm) * inside + 0.5).astype(np.uint8)
