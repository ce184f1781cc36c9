"""What is seen of an eyeball as one picture: pupil, iris and white, finer than the vertices of a mesh could carry it.

The picture looks at the eye from the front; the farther from its middle, the more it gathers.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from facemodel.eyeball import IRIS_RADIUS, PUPIL, PUPIL_RADIUS, around_the_eye, iris_colours, white_colours
from facemodel.smooth import smooth
from fem.types import FloatArray
from ui.viewport.complexion import Colour
from ui.viewport.surface import ByteArray

SIDE = 768
"""Pixels of the picture: some twenty for a millimetre of the iris."""
REACH = np.radians(118.0)
"""Angle from the axis of the eye at the border of the picture."""
GATHERED = 0.7
"""Power of that angle with which places go out from the middle: the iris gets more than its share of the pixels."""
TINT = 0.9
"""How fully an iris takes the colour of its owner; the rest keeps the play between hazel and grey."""
PLAY = 0.55
"""How much of that play between the colours is left; where it goes, light and dark stay."""
FIBRES, FINE_FIBRES = 0.16, 0.10
"""How much single fibres of the iris are brighter or darker than their bundle."""
PUPIL_EDGE = 0.12
"""Millimetres over which the iris ends at the pupil."""

VEINS, TWIGS = 40, 3
"""Veins of the white, and how often each parts on its way to the iris."""
BLOOD: Colour = (0.62, 0.20, 0.18)
FAINTER = 0.4
"""Power of what is left of a vein with which it gets thinner and fainter."""
VEIN = 0.42
"""How much of the white the thickest vein covers."""
FROM_WHERE, TO_WHERE = np.radians(80.0), np.radians(33.0)
"""Angles from the axis between which a vein runs: from behind the lids towards the iris, which it does not reach."""


def eye_coordinates(places: FloatArray, ball: float) -> FloatArray:
    """Texture coordinates (n, 2) of places (n, 3) on an eyeball of that radius about the origin, looking along +z."""
    away = np.hypot(places[:, 0], places[:, 1])
    slant = np.arcsin(np.minimum(away / ball, 1.0))
    angle = np.where(places[:, 2] > 0, slant, np.pi - slant)
    out = 0.5 * (angle / REACH) ** GATHERED / np.maximum(away, 1e-9)
    return np.asarray(0.5 + out[:, None] * places[:, :2])


@lru_cache(maxsize=4)
def eye_picture(ball: float, iris: Colour) -> ByteArray:
    """The picture (h, w, 3) of an eyeball of that radius whose iris has a colour; the first row at v = 0."""
    places = _places(ball)
    away = np.hypot(places[:, 0], places[:, 1])
    inside = (away < IRIS_RADIUS) & (places[:, 2] > 0)
    colours = np.empty((len(places), 3))
    colours[~inside] = white_colours(places[~inside], ball)
    colours[inside] = _iris(places[inside], iris)
    picture = np.clip(colours, 0.0, 1.0).reshape(SIDE, SIDE, 3)
    cover = (VEIN * _veins() * ~inside.reshape(SIDE, SIDE))[:, :, None]
    return np.asarray(255 * (picture + (BLOOD - picture) * cover)).astype(np.uint8)


def _places(ball: float) -> FloatArray:
    """The places (h w, 3) on the eyeball that the pixels show."""
    step = (np.arange(SIDE) + 0.5) / SIDE - 0.5
    across, up = np.meshgrid(step, step)
    out = np.hypot(across, up)
    angle = np.minimum(REACH * (2 * out) ** (1 / GATHERED), np.pi)
    away = ball * np.sin(angle) / out
    return np.stack([away * across, away * up, ball * np.cos(angle)], axis=-1).reshape(-1, 3)


def _iris(places: FloatArray, tint: Colour) -> FloatArray:
    """Colours (n, 3) of an iris round its pupil, with its fibres and rings as bright as those of the eyes' own."""
    away, turn = np.hypot(places[:, 0], places[:, 1]), np.arctan2(places[:, 1], places[:, 0])
    share = (away - PUPIL_RADIUS) / (IRIS_RADIUS - PUPIL_RADIUS)
    single = FIBRES * around_the_eye(turn + 0.02 * np.sin(5 * share + 3 * turn), 151, 5)
    single += FINE_FIBRES * around_the_eye(turn - 0.008 * np.sin(13 * share + 7 * turn), 331, 6)
    own = iris_colours(places) * (1 + single * smooth(share, 0.02, 0.2) * smooth(share, 1.0, 0.8))[:, None]
    middle = _middle_of_irises()
    played = own * (np.array(tint) / middle) ** TINT
    plain = np.array(tint) * (own.mean(axis=1, keepdims=True) / middle.mean())
    tinted = np.clip(PLAY * played + (1 - PLAY) * plain, 0.0, 1.0)
    open_ = smooth(away, PUPIL_RADIUS + PUPIL_EDGE, PUPIL_RADIUS)[:, None]
    return np.asarray(tinted + (PUPIL - tinted) * open_)


def _middle_of_irises() -> FloatArray:
    """The colour (3,) in the middle of all that an iris has from the pupil to its rim."""
    away, turn = np.meshgrid(np.linspace(PUPIL_RADIUS, IRIS_RADIUS, 33), np.linspace(0, 2 * np.pi, 120))
    places = np.stack([away * np.cos(turn), away * np.sin(turn), np.zeros_like(away)], axis=-1)
    return np.asarray(np.median(iris_colours(places.reshape(-1, 3)), axis=0))


def _veins() -> FloatArray:
    """How much blood is seen (h, w), 0 to 1: veins that come from both corners and part towards the iris."""
    random = np.random.default_rng(3)
    finer = 2
    drawn = Image.new("L", (SIDE * finer, SIDE * finer))
    pen = ImageDraw.Draw(drawn)
    for number in range(VEINS):
        side = np.pi if number % 2 else 0.0
        start, heading = side + random.normal(0.0, 0.55), random.normal(0.0, 0.10)
        end = FROM_WHERE + (TO_WHERE - FROM_WHERE) * random.uniform(0.45, 1.0)
        for twig in range(1 + random.integers(TWIGS)):
            begin = FROM_WHERE if twig == 0 else random.uniform(end + 0.1, FROM_WHERE)
            bright = random.uniform(0.35, 1.0) * (1.0 if twig == 0 else 0.6)
            _vein(pen, random, (begin, end + 0.1 * twig), start + heading * (1 + 2 * twig), bright, finer)
    smoothed = drawn.filter(ImageFilter.GaussianBlur(finer / 2)).resize((SIDE, SIDE), Image.Resampling.LANCZOS)
    return np.asarray(smoothed, dtype=np.float64) / 255


def _vein(
    pen: ImageDraw.ImageDraw,
    random: np.random.Generator,
    between: tuple[float, float],
    turn: float,
    bright: float,
    finer: int,
) -> None:
    """Draw one vein from one angle off the axis to another, winding, thinner and fainter towards its end."""
    steps = 32
    angle = np.linspace(*between, steps)
    waves = np.outer(np.linspace(0, 1, steps), random.uniform(4, 26, 5)) + random.uniform(0, 2 * np.pi, 5)
    sway = (between[0] - between[1]) * (np.sin(waves) * [0.04, 0.03, 0.02, 0.015, 0.015]).sum(axis=1)
    out = SIDE * finer / 2 * (angle / REACH) ** GATHERED
    x, y = SIDE * finer / 2 + out * np.cos(turn + sway), SIDE * finer / 2 + out * np.sin(turn + sway)
    for k in range(steps - 1):
        left = (1 - k / steps) ** FAINTER
        pen.line([x[k], y[k], x[k + 1], y[k + 1]], fill=int(255 * bright * left), width=round(finer * (1 + left)))
