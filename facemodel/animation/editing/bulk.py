"""Many keys at once, across tracks and layers."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from facemodel.actions import ActionUnit
from facemodel.animation.clip import Animation
from facemodel.animation.curve import Curve, Shape
from facemodel.animation.editing import keys
from facemodel.animation.editing.eases import Ease, eased
from facemodel.animation.editing.selection import Row, Selection, with_keys_changed
from fem.types import IntArray

SMALLEST_FACTOR = 1e-3
"""By which keys are drawn together in time at most; at 0 all but one of a row would be lost."""

Edited = tuple[Animation, Selection]


def moved_keys(
    animation: Animation, selection: Selection, seconds: float, rise: float = 0.0, units: Sequence[ActionUnit] = ()
) -> Edited:
    """Keys moved in time and value; keys that they land on give way."""

    def change(curve: Curve, places: IntArray, _: Row) -> tuple[Curve, IntArray]:
        return keys.moved(curve, places, seconds, rise)

    return with_keys_changed(animation, selection, change, units)


def scaled_keys(
    animation: Animation,
    selection: Selection,
    about: tuple[float, float],
    factors: tuple[float, float],
    units: Sequence[ActionUnit] = (),
) -> Edited:
    """Keys moved towards a time and a value or away from them; the factor of time is kept above `SMALLEST_FACTOR`."""
    kept = max(factors[0], SMALLEST_FACTOR), factors[1]

    def change(curve: Curve, places: IntArray, _: Row) -> tuple[Curve, IntArray]:
        return keys.scaled(curve, places, about, kept)

    return with_keys_changed(animation, selection, change, units)


def snapped_keys(animation: Animation, selection: Selection, rate: float | None = None) -> Edited:
    """Keys moved to the nearest frame; of several of a row on one frame the last stays."""
    own = rate or animation.rate

    def change(curve: Curve, places: IntArray, _: Row) -> tuple[Curve, IntArray]:
        return keys.transformed(curve, places, lambda times: (times * own).round() / own, lambda values: values)

    return with_keys_changed(animation, selection, change)


def valued_keys(animation: Animation, selection: Selection, value: float, units: Sequence[ActionUnit] = ()) -> Edited:
    """Keys all at one value."""
    return with_keys_changed(
        animation, selection, lambda curve, places, _: (keys.with_values(curve, places, value), places), units
    )


def deleted_keys(animation: Animation, selection: Selection) -> Animation:
    """An animation without some keys; tracks stay, even without a key."""

    def change(curve: Curve, places: IntArray, _: Row) -> tuple[Curve, IntArray]:
        return keys.without_keys(curve, places), places[:0]

    return with_keys_changed(animation, selection, change)[0]


def shaped_keys(animation: Animation, selection: Selection, shape: Shape) -> Animation:
    """An animation in which curves go on from some keys in another way."""
    return with_keys_changed(
        animation, selection, lambda curve, places, _: (keys.with_shape(curve, places, shape), places)
    )[0]


def eased_keys(animation: Animation, selection: Selection, ease: Ease) -> Animation:
    """An animation in which curves go on from some keys with an ease; see `eases.EASES`."""
    return with_keys_changed(animation, selection, lambda curve, places, _: (eased(curve, places, ease), places))[0]


def flagged_keys(
    animation: Animation, selection: Selection, weighted: bool | None = None, broken: bool | None = None
) -> Animation:
    """An animation in which handles count their length, or turn on their own, or no longer do."""
    flag = partial(keys.with_flags, weighted=weighted, broken=broken)
    return with_keys_changed(animation, selection, lambda curve, places, _: (flag(curve, places), places))[0]
