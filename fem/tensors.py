"""Stretching and bending tensors: given per vertex, turned into each triangle's own plane.

The energy of one coordinate w of the displacement is, with (1, 2) along and across the material direction,

    integral of a1 w_1^2 + a2 w_2^2 + b11 w_11^2 + b22 w_22^2 + 2 b12 w_12^2 - 2 f w  over the true surface.

In the plane (s, t) of a triangle the stretching is a full symmetric 2 x 2 form in (w_s, w_t), and the bending
a full symmetric 3 x 3 form in (w_ss, w_tt, w_st).
"""

from dataclasses import dataclass

import numpy as np

from fem.errors import FemError
from fem.surface import ChartedSurface
from fem.types import FloatArray

# Below this sine of the angle between direction and normal the projection is noise and the frame's s is used.
PARALLEL_SINE = 1e-6
# Rounding allowed in the eigenvalues of a positive semidefinite form, as a share of its largest one.
SEMIDEFINITE_SHARE = 1e-12
# Below this a share of a form underflows, and its rounding cannot be told from zero.
SMALLEST_FORM = 1e-300


@dataclass(frozen=True, eq=False)
class Material:
    """Principal stretching and bending of the skin at every vertex.

    Parameters
    ----------
    direction
        (N, 3) world vectors of any length; projected onto each triangle's plane. Where one is parallel to the
        normal, or zero, the first edge of the triangle stands in.
    stretching
        (N, 2) stiffness along and across the direction, not negative.
    bending
        (N, 3) b11, b22, b12 in the same frame, not negative; b11 = b22 = b12 is isotropic.

    Raises
    ------
    FemError
        If a shape is wrong, a value is negative or not finite.
    """

    direction: FloatArray
    stretching: FloatArray
    bending: FloatArray

    def __post_init__(self) -> None:
        count = len(self.direction)
        for name, width in (("direction", 3), ("stretching", 2), ("bending", 3)):
            array = np.array(getattr(self, name), dtype=np.float64)
            if array.shape != (count, width):
                raise FemError(f"The {name} must be ({count}, {width}), not {array.shape}.")
            allowed = np.isfinite(array) if name == "direction" else np.isfinite(array) & (array >= 0.0)
            bad = np.flatnonzero(~allowed.all(axis=1))
            if len(bad):
                rule = "finite" if name == "direction" else "finite and not negative"
                raise FemError(f"The {name} of vertex {bad[0]} is {array[bad[0]].tolist()}; it must be {rule}.")
            array.setflags(write=False)
            object.__setattr__(self, name, array)


@dataclass(frozen=True, eq=False)
class ElementTensors:
    """Tensors at the corners of every triangle in its own frame (s, t), linear in between.

    Parameters
    ----------
    stretching
        (T, 3, 2, 2) forms in (w_s, w_t).
    bending
        (T, 3, 3, 3) forms in (w_ss, w_tt, w_st).

    Raises
    ------
    FemError
        If a form is not finite, not symmetric or not positive semidefinite.
    """

    stretching: FloatArray
    bending: FloatArray

    def __post_init__(self) -> None:
        count = len(self.stretching)
        for name, width in (("stretching", 2), ("bending", 3)):
            array = np.array(getattr(self, name), dtype=np.float64)
            if array.shape != (count, 3, width, width):
                raise FemError(f"The {name} must be ({count}, 3, {width}, {width}), not {array.shape}.")
            bad = np.flatnonzero(~_semidefinite(array).all(axis=1))
            if len(bad):
                raise FemError(f"The {name} of triangle {bad[0]} is not symmetric positive semidefinite.")
            array.setflags(write=False)
            object.__setattr__(self, name, array)


def _semidefinite(forms: FloatArray) -> FloatArray:
    finite = np.asarray(np.isfinite(forms).all(axis=(-2, -1)))
    safe = np.where(finite[..., None, None], forms, 0.0)
    size = np.abs(safe).max(axis=(-2, -1))
    skew = np.abs(safe - np.swapaxes(safe, -2, -1)).max(axis=(-2, -1))
    least = np.linalg.eigvalsh(safe)[..., 0]
    allowed = SEMIDEFINITE_SHARE * size + SMALLEST_FORM
    return np.asarray(finite & (skew <= allowed) & (least >= -allowed))


def uniform_material(n_vertices: int, stretching: float, bending: float) -> Material:
    """Return an isotropic material of one stretching and one bending stiffness."""
    return Material(
        direction=np.tile([1.0, 0.0, 0.0], (n_vertices, 1)),
        stretching=np.full((n_vertices, 2), float(stretching)),
        bending=np.full((n_vertices, 3), float(bending)),
    )


def element_tensors(surface: ChartedSurface, material: Material) -> ElementTensors:
    """Turn the material of the vertices into the frame of every triangle.

    Raises
    ------
    FemError
        If the material has another number of vertices than the surface.
    """
    if len(material.direction) != surface.n_vertices:
        raise FemError(f"The material has {len(material.direction)} vertices, the surface {surface.n_vertices}.")
    cosine, sine = _angles(surface, material.direction[surface.triangles])
    stretching = material.stretching[surface.triangles]
    bending = material.bending[surface.triangles]
    return ElementTensors(_turned_stretching(cosine, sine, stretching), _turned_bending(cosine, sine, bending))


def _angles(surface: ChartedSurface, direction: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return cosine and sine, (T, 3) each, of the angle from s to the projected direction at each corner."""
    in_plane = np.einsum("tck,tfk->tcf", direction, surface.frames)
    length = np.linalg.norm(in_plane, axis=-1)
    usable = length > PARALLEL_SINE * np.linalg.norm(direction, axis=-1)
    unit = in_plane / np.where(usable, length, 1.0)[..., None]
    return np.where(usable, unit[..., 0], 1.0), np.where(usable, unit[..., 1], 0.0)


def _turned_stretching(cosine: FloatArray, sine: FloatArray, principal: FloatArray) -> FloatArray:
    along, across = principal[..., 0], principal[..., 1]
    result = np.empty((*cosine.shape, 2, 2))
    result[..., 0, 0] = along * cosine**2 + across * sine**2
    result[..., 1, 1] = along * sine**2 + across * cosine**2
    result[..., 0, 1] = result[..., 1, 0] = (along - across) * cosine * sine
    return result


def _turned_bending(cosine: FloatArray, sine: FloatArray, principal: FloatArray) -> FloatArray:
    """Turn diag(b11, b22, 2 b12) on (w_11, w_22, w_12) into a form on (w_ss, w_tt, w_st).

    With c and s of the angle: w_11 = c2 w_ss + s2 w_tt + 2 c s w_st, w_22 = s2 w_ss + c2 w_tt - 2 c s w_st,
    w_12 = -c s w_ss + c s w_tt + (c2 - s2) w_st.
    """
    c2, s2, cs = cosine**2, sine**2, cosine * sine
    turn = np.stack(
        [
            np.stack([c2, s2, 2.0 * cs], axis=-1),
            np.stack([s2, c2, -2.0 * cs], axis=-1),
            np.stack([-cs, cs, c2 - s2], axis=-1),
        ],
        axis=-2,
    )
    weights = principal * np.array([1.0, 1.0, 2.0])
    form = np.swapaxes(turn, -2, -1) @ (weights[..., None] * turn)
    return np.asarray(0.5 * (form + np.swapaxes(form, -2, -1)))
