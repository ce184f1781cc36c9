"""Cubic Bernstein polynomials on a triangle, as functions of three barycentric coordinates."""

from math import factorial

import numpy as np

from fem.types import FloatArray, IntArray

# Exponents of the ten cubics; hct12 fills its coefficients in this order.
EXPONENTS: IntArray = np.array(
    [
        (3, 0, 0), (0, 3, 0), (0, 0, 3), (2, 1, 0), (1, 2, 0),
        (2, 0, 1), (0, 2, 1), (1, 0, 2), (0, 1, 2), (1, 1, 1),
    ],
    dtype=np.int64,
)  # fmt: skip
_FACTORS: FloatArray = np.array([6.0 / (factorial(i) * factorial(j) * factorial(k)) for i, j, k in EXPONENTS.tolist()])
# The six second derivatives, as pairs of barycentric coordinates.
SECOND_PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))


def _derivative(mu: FloatArray, orders: IntArray) -> FloatArray:
    """Differentiate all ten cubics `orders` times by each coordinate, the three taken as independent."""
    result = np.broadcast_to(_FACTORS, (len(mu), 10)).copy()
    for axis in range(3):
        powers = EXPONENTS[:, axis]
        remaining = powers - orders[axis]
        scale = np.array([_falling(int(power), int(orders[axis])) for power in powers])
        result *= scale * mu[:, axis, None] ** np.maximum(remaining, 0)
    return result


def _falling(power: int, order: int) -> float:
    return float(np.prod(np.arange(power - order + 1, power + 1))) if order <= power else 0.0


def values(mu: FloatArray) -> FloatArray:
    """Evaluate the ten cubics.

    Parameters
    ----------
    mu
        (P, 3) barycentric coordinates.

    Returns
    -------
    (P, 10) values.
    """
    return _derivative(mu, np.zeros(3, dtype=np.int64))


def gradients(mu: FloatArray) -> FloatArray:
    """Return (P, 3, 10) first derivatives by each barycentric coordinate, the three taken as independent."""
    return np.stack([_derivative(mu, np.eye(3, dtype=np.int64)[axis]) for axis in range(3)], axis=1)


def hessians(mu: FloatArray) -> FloatArray:
    """Return (P, 6, 10) second derivatives in the order of `SECOND_PAIRS`."""
    unit = np.eye(3, dtype=np.int64)
    return np.stack([_derivative(mu, unit[i] + unit[j]) for i, j in SECOND_PAIRS], axis=1)
