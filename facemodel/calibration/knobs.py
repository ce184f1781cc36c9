"""The numbers of a recipe that may be turned, each within anatomical bounds."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np

from facemodel.anatomy.recipe import Anatomy, Band, Course, Crease, Region, Ring, Spot
from fem.types import FloatArray

Owner = TypeVar("Owner")

MOST_TURNS = 2.0
"""Steps that a knob goes to either side of where it stood: what one head's anatomy may differ from another's."""


@dataclass(frozen=True)
class Knob:
    """One number that may be turned.

    Attributes
    ----------
    name : for people, for example ``zygomaticus_major width``
    step : how far one turn goes: millimetres, or the logarithm of a factor
    turned : the recipe with this number turned so many steps from where it is
    muscle : whose it is; empty for one of the tissue
    least, most : steps from where it is within which its number keeps its own bounds
    """

    name: str
    step: float
    turned: Callable[[Anatomy, float], Anatomy]
    muscle: str = ""
    least: float = -MOST_TURNS
    most: float = MOST_TURNS


ATTACHED, ORIGINATED = 4.0, 5.0
"""Millimetres by which attachments in the skin and origins on the bone differ between people."""

WIDER, SHARPER = 0.35, 0.5
"""Logarithms of the factors on width and kappa of one step."""

WIDTHS, KAPPAS = (6.5, 26.0), (0.5, 8.0)
"""Bounds of width, millimetres, and kappa: a narrower pull would fall between the vertices of a coarse skin."""

CREASES = (3.0, 8.0)
"""Bounds of the width of a fold, millimetres: a narrower one would fall between the vertices of a coarse skin."""

FIRMER, SHARE = 0.5, 0.25
"""Logarithm of the factor on the tissue, and part of a share, of one step."""

FREE = (-MOST_TURNS, MOST_TURNS)
"""Steps of a knob whose number has no bounds of its own."""


def knobs(anatomy: Anatomy) -> tuple[Knob, ...]:
    """All knobs of a recipe."""
    found: list[Knob] = []
    for number, band in enumerate(anatomy.bands):
        found += _band_knobs(number, band)
    for number, ring in enumerate(anatomy.rings):
        found += _ring_knobs(number, ring)
    for number, crease in enumerate(anatomy.creases):
        found += _crease_knobs(number, crease)
    for layer in ("stretching", "bending", "stiffness", "sliding"):
        found.append(_tissue_knob(layer))
    for number, region in enumerate(anatomy.tissue.regions):
        found += [_region_knob(number, region, layer) for layer, factor in region.factors.items() if factor]
    return tuple(found)


def turned(anatomy: Anatomy, all_knobs: Sequence[Knob], steps: FloatArray) -> Anatomy:
    """The recipe with every knob turned so many steps."""
    for knob, step in zip(all_knobs, steps, strict=True):
        if step:
            anatomy = knob.turned(anatomy, float(step))
    return anatomy


def _band_knobs(number: int, band: Band) -> list[Knob]:
    def knob(what: str, step: float, change: Callable[[Band, float], Band], bounds: tuple[float, float] = FREE) -> Knob:
        return Knob(f"{band.name} {what}", step, _on("bands", number, change, step), band.name, *bounds)

    def shifted(end: str, axis: int, first: float, last: float) -> Callable[[Band, float], Band]:
        return lambda b, x: replace(b, courses=_shifted(b.courses, end, axis, first * x, last * x))

    made = [
        knob(
            "width",
            WIDER,
            lambda b, x: replace(b, width=_times(b.width, x, WIDTHS)),
            _within(band.width, WIDTHS, WIDER),
        ),
        knob(
            "kappa",
            SHARPER,
            lambda b, x: replace(b, kappa=_times(b.kappa, x, KAPPAS)),
            _within(band.kappa, KAPPAS, SHARPER),
        ),
    ]
    for axis, way in ((0, "lateral"), (1, "up")):
        if band.midline and axis == 0:
            continue
        made.append(knob(f"origin {way}", ORIGINATED, shifted("origin", axis, 1, 1)))
        if len(band.courses) == 1 or band.midline:
            made.append(knob(f"attachment {way}", ATTACHED, shifted("attachment", axis, 1, 1)))
        else:
            made.append(knob(f"first attachment {way}", ATTACHED, shifted("attachment", axis, 1, 0)))
            made.append(knob(f"last attachment {way}", ATTACHED, shifted("attachment", axis, 0, 1)))
    return made


def _within(value: float, bounds: tuple[float, float], step: float) -> tuple[float, float]:
    """Steps by which a factor may be turned so that the value keeps its bounds."""
    low, high = (float(np.log(bound / value)) / step for bound in bounds)
    return min(max(low, -MOST_TURNS), 0.0), max(min(high, MOST_TURNS), 0.0)


def _times(value: float, log: float, bounds: tuple[float, float]) -> float:
    return float(np.clip(value * np.exp(log), *bounds))


def _shifted(courses: tuple[Course, ...], end: str, axis: int, first: float, last: float) -> tuple[Course, ...]:
    """Courses whose one end is shifted along an axis, from the first to the last more and more otherwise."""
    shares = np.linspace(0, 1, len(courses)) if len(courses) > 1 else np.array([0.5])
    made = []
    for course, share in zip(courses, shares, strict=True):
        shift = float(first * (1 - share) + last * share)
        made.append(_with(course, end, _moved(getattr(course, end), axis, shift)))
    return tuple(made)


def _moved(spot: Spot, axis: int, shift: float) -> Spot:
    """A spot shifted along an axis, millimetres."""
    offset = [value + shift * (k == axis) for k, value in enumerate(spot.offset)]
    return replace(spot, offset=(offset[0], offset[1], offset[2]))


def _ring_knobs(number: int, ring: Ring) -> list[Knob]:
    def knob(what: str, step: float, change: Callable[[Ring, float], Ring], bounds: tuple[float, float] = FREE) -> Knob:
        return Knob(f"{ring.name} {what}", step, _on("rings", number, change, step), ring.name, *bounds)

    def share(name: str, low: float, high: float) -> Callable[[Ring, float], Ring]:
        return lambda r, x: _with(r, name, float(np.clip(getattr(r, name) + x, low, high)))

    def raised(r: Ring, x: float) -> Ring:
        return replace(r, shift=(r.shift[0], r.shift[1] + x, r.shift[2]))

    made = [
        knob("width", WIDER, lambda r, x: replace(r, width=r.width * float(np.exp(x)))),
        knob("reach", WIDER / 2, lambda r, x: replace(r, reach=r.reach * float(np.exp(x)))),
        knob(
            "height",
            WIDER / 2,
            lambda r, x: replace(r, height=r.height * float(np.exp(x)), relative=r.relative * float(np.exp(x))),
        ),
        knob("up", ATTACHED / 2, raised),
    ]
    if ring.model == "sphincter":
        made.append(knob("focus", SHARE, share("focus", 0, 1), _inside(ring.focus, 0, 1)))
    if ring.model in ("sphincter", "mouth"):
        made.append(knob("forward", SHARE, share("forward", -1, 1), _inside(ring.forward, -1, 1)))
        made.append(knob("inward", SHARE, share("inward", -1, 1), _inside(ring.inward, -1, 1)))
    return made


def _crease_knobs(number: int, crease: Crease) -> list[Knob]:
    def knob(what: str, step: float, change: Callable[[Crease, float], Crease], bounds: tuple[float, float]) -> Knob:
        return Knob(f"{crease.name} {what}", step, _on("creases", number, change, step), crease.name, *bounds)

    def shifted(axis: int) -> Callable[[Crease, float], Crease]:
        return lambda c, x: replace(c, spots=tuple(_moved(spot, axis, x) for spot in c.spots))

    width = _within(crease.width, CREASES, WIDER)
    return [
        knob("width", WIDER, lambda c, x: replace(c, width=_times(c.width, x, CREASES)), width),
        knob("lateral", ATTACHED / 2, shifted(0), FREE),
        knob("up", ATTACHED / 2, shifted(1), FREE),
    ]


def _inside(value: float, low: float, high: float) -> tuple[float, float]:
    """Steps by which a share may be turned so that it keeps its bounds."""
    return min(max((low - value) / SHARE, -MOST_TURNS), 0.0), max(min((high - value) / SHARE, MOST_TURNS), 0.0)


def _tissue_knob(layer: str) -> Knob:
    def change(anatomy: Anatomy, steps: float) -> Anatomy:
        value = getattr(anatomy.tissue, layer) * float(np.exp(FIRMER * steps))
        return replace(anatomy, tissue=_with(anatomy.tissue, layer, value))

    return Knob(f"tissue {layer}", FIRMER, change)


def _region_knob(number: int, region: Region, layer: Any) -> Knob:
    def change(anatomy: Anatomy, steps: float) -> Anatomy:
        regions = list(anatomy.tissue.regions)
        factors = dict(regions[number].factors)
        factors[layer] *= float(np.exp(FIRMER * steps))
        regions[number] = replace(regions[number], factors=factors)
        return replace(anatomy, tissue=replace(anatomy.tissue, regions=tuple(regions)))

    return Knob(f"{region.name} {layer}", FIRMER, change)


def _on(
    list_name: str, number: int, change: Callable[[Any, float], Any], step: float
) -> Callable[[Anatomy, float], Anatomy]:
    def turn(anatomy: Anatomy, steps: float) -> Anatomy:
        items = list(getattr(anatomy, list_name))
        items[number] = change(items[number], step * steps)
        return _with(anatomy, list_name, tuple(items))

    return turn


def _with(owner: Owner, name: str, value: Any) -> Owner:
    """A frozen value with another member."""
    return replace(owner, **{name: value})  # type: ignore[type-var]
