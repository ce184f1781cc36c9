"""A weight over a distance that a person draws: knots joined without overshoot."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator

from fem.types import FloatArray


@dataclass(frozen=True)
class Profile:
    """A curve through knots, monotone between them and zero past the last one.

    Attributes
    ----------
    at : distances of the knots, increasing from zero
    values : the weights there
    """

    at: tuple[float, ...]
    values: tuple[float, ...]

    def __call__(self, distance: FloatArray) -> FloatArray:
        """Weights at any distances, of the same shape."""
        curve = PchipInterpolator(self.at, self.values)
        within = np.clip(distance, self.at[0], self.at[-1])
        return np.where(distance < self.at[-1], curve(within), 0.0)


@dataclass(frozen=True)
class Profiles:
    """Both profiles of the mouth sphincter over the elliptic distance: ``sigma`` inward and ``tau`` outward."""

    sigma: Profile
    tau: Profile
