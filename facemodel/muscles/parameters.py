"""The numbers of a muscle that a person may turn, with name, unit, range and default: a panel can be made of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from facemodel.muscles.cosine import cosine_of
from facemodel.muscles.mouth import PROFILES
from facemodel.muscles.muscle import Muscle
from facemodel.muscles.profile import Profile


@dataclass(frozen=True)
class Parameter:
    """One number of a muscle.

    Attributes
    ----------
    name : where it is kept: an attribute of `Muscle`, or one of its ``ring`` or ``cosine`` after a point, the
        components of a vector as x, y, z; for example ``width``, ``ring.focus``, ``cosine.box.x``
    title : what people read
    unit : ``mm``, ``N/mm²`` or nothing for a pure number
    least, most : the range of its slider, in which a face stays a face
    default : what a new muscle gets
    whole : whether it counts something
    """

    name: str
    title: str
    unit: str
    least: float
    most: float
    default: float
    whole: bool = False


@dataclass(frozen=True)
class ProfileParameter:
    """A profile of a muscle that is drawn as a curve through knots.

    Attributes
    ----------
    name : ``profiles.sigma`` or ``profiles.tau``
    title : what people read
    reach : largest distance of a knot, in half axes of the ring
    least, most : the range of its values
    default : what a new muscle gets
    """

    name: str
    title: str
    reach: float
    least: float
    most: float
    default: Profile


WIDTH = Parameter("width", "Width", "mm", 1.0, 60.0, 10.0)
RADIUS = Parameter("width", "Radius", "mm", 1.0, 60.0, 12.0)
STRENGTH = Parameter("strength", "Strength", "N/mm²", 0.0, 0.1, 0.01)
KAPPA = Parameter("kappa", "Kappa: pull near the attachment", "", 0.25, 10.0, 3.0)
COUNT = Parameter("count", "Generated fibres", "", 1, 200, 50, whole=True)
FOCUS = Parameter("ring.focus", "Line of closure", "", 0.0, 1.0, 0.0)
INWARD = Parameter("ring.inward", "Inward", "", -1.0, 1.0, 1.0)
FORWARD = Parameter("ring.forward", "Forward", "", -1.0, 1.0, 0.0)
SHARE = Parameter("cosine.share", "Share of the way at full contraction", "", 0.0, 1.0, 0.3)
BOX = tuple(
    Parameter(f"cosine.box.{axis}", f"Half of the box, {title}", "mm", 1.0, 120.0, 20.0)
    for axis, title in (("x", "across"), ("y", "up"), ("z", "forward"))
)
FACTORS = tuple(
    Parameter(f"cosine.factors.{axis}", f"K {title}", "", -1.0, 1.0, default)
    for axis, title, default in (
        ("x", "along the ring", 0.4),
        ("y", "across the ring", 0.4),
        ("z", "out of the ring", 0.0),
    )
)
SIGMA = ProfileParameter("profiles.sigma", "Inward profile σ", 3.0, -1.0, 1.0, PROFILES.sigma)
TAU = ProfileParameter("profiles.tau", "Pursing profile τ", 3.0, -1.0, 1.0, PROFILES.tau)

AXES: Mapping[str, int] = {"x": 0, "y": 1, "z": 2}


def completed(muscle: Muscle) -> Muscle:
    """The same muscle with its defaults written out, so that every parameter has a place."""
    profiles = muscle.profiles or PROFILES
    return replace(muscle, profiles=profiles, cosine=cosine_of(muscle))


def value_of(muscle: Muscle, name: str) -> Any:
    """The value of a parameter: a number, or a `Profile`.

    Raises
    ------
    AttributeError
        If the muscle has no such part, for example no ring.
    """
    value: Any = completed(muscle)
    for step in name.split("."):
        value = float(value[AXES[step]]) if isinstance(value, np.ndarray) else getattr(value, step)
    return value


def with_value(muscle: Muscle, name: str, value: float | Profile) -> Muscle:
    """A muscle with another value of a parameter, whatever its range; see `facemodel.laying.values` for checks."""
    owner = muscle if "." not in name or name.startswith("ring.") else completed(muscle)
    changed: Muscle = _with(owner, name.split("."), value)
    return changed


def _with(owner: Any, steps: list[str], value: Any) -> Any:
    if not steps:
        return value
    if isinstance(owner, np.ndarray):
        vector = owner.copy()
        vector[AXES[steps[0]]] = value
        return vector
    return replace(owner, **{steps[0]: _with(getattr(owner, steps[0]), steps[1:], value)})
