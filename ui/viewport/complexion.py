"""The colours of a face, vertex by vertex: redder lips, warm cheeks, nose and ears, shaded lids."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.smooth import smooth
from fem.types import FloatArray, IntArray
from ui.viewport.lids import lid_line

Colour = tuple[float, float, float]


@dataclass(frozen=True)
class Palette:
    """Colours 0..1 (sRGB) of one person; ``iris`` is what the middle of an iris is tinted to."""

    skin: Colour
    pale: Colour
    flush: Colour
    lips: Colour
    lids: Colour
    lash_line: Colour
    hair: Colour
    iris: Colour


FAIR = Palette(
    skin=(0.835, 0.655, 0.560),
    pale=(0.860, 0.700, 0.610),
    flush=(0.800, 0.500, 0.430),
    lips=(0.690, 0.370, 0.355),
    lids=(0.700, 0.490, 0.430),
    lash_line=(0.300, 0.180, 0.150),
    hair=(0.205, 0.140, 0.105),
    iris=(0.395, 0.380, 0.255),
)
LIGHT_OLIVE = Palette(
    skin=(0.840, 0.675, 0.545),
    pale=(0.870, 0.720, 0.600),
    flush=(0.815, 0.540, 0.440),
    lips=(0.700, 0.395, 0.370),
    lids=(0.700, 0.510, 0.420),
    lash_line=(0.260, 0.160, 0.130),
    hair=(0.095, 0.075, 0.070),
    iris=(0.270, 0.170, 0.085),
)
TANNED = Palette(
    skin=(0.790, 0.595, 0.490),
    pale=(0.815, 0.635, 0.535),
    flush=(0.755, 0.455, 0.375),
    lips=(0.640, 0.370, 0.340),
    lids=(0.640, 0.435, 0.370),
    lash_line=(0.270, 0.160, 0.130),
    hair=(0.170, 0.120, 0.095),
    iris=(0.350, 0.385, 0.365),
)
DEEP = Palette(
    skin=(0.430, 0.285, 0.215),
    pale=(0.480, 0.325, 0.245),
    flush=(0.430, 0.230, 0.175),
    lips=(0.400, 0.215, 0.200),
    lids=(0.320, 0.200, 0.155),
    lash_line=(0.110, 0.070, 0.055),
    hair=(0.350, 0.310, 0.280),
    iris=(0.235, 0.145, 0.075),
)
LASH_REACH = 1.3
"""Millimetres around the edge of a lid that the roots of its lashes darken."""

PALETTES: Mapping[str, Palette] = {"ada": FAIR, "ben": TANNED, "chen": LIGHT_OLIVE, "dayo": DEEP}
"""By the key of a face; any other face is fair."""


def palette_of(face: Face) -> Palette:
    """The colours of a face's owner."""
    return PALETTES.get(face.key, FAIR)


RED_CORNER = (1.10, 0.90)
"""Width of the mouth, as a share of that between its corners, at which the red of the lips has ended, and is whole."""

FEATURES = (
    *("upper_lip_mid", "lower_vermilion", "nose_tip", "subnasale", "chin", "menton", "supraglabella", "glabella"),
    *(
        f"{name}_{side}"
        for side in "LR"
        for name in (
            *("upper_lid_mid", "cupid_bow", "mouth_corner", "ala", "cheek", "suborbital", "frontal_eminence"),
            *("tragus", "brow_inner", "brow_mid", "brow_outer", "lateral_orbit", "zygion", "eye_outer"),
        )
    ),
)
"""Landmarks without which no features can be painted."""


def has_features(face: Face) -> bool:
    """Whether lips, brows and lids of a face are known; a bare scan is drawn in one colour."""
    return all(name in face.landmarks for name in FEATURES) and len(face.skin.boundary_loops) >= OPENINGS


OPENINGS = 4
"""Mouth, two eyes and the neck."""


@dataclass(frozen=True, eq=False)
class Complexion:
    """What the skin looks like before light falls on it.

    Attributes
    ----------
    colours : (N, 3) sRGB 0..1 per skin vertex
    gloss : (N,) how much the skin shines, about 1
    """

    colours: FloatArray
    gloss: FloatArray


def rings(mesh: Mesh, loop: IntArray, count: int) -> IntArray:
    """Number of edges (N,) from each vertex to a loop, at most ``count``."""
    ring = np.full(len(mesh.positions), count, dtype=np.int64)
    reached = np.zeros(len(mesh.positions))
    reached[loop] = 1.0
    for k in range(count):
        ring[(reached > 0) & (ring > k)] = np.where(ring[(reached > 0) & (ring > k)] == count, k, 0)
        reached = reached + mesh.adjacency @ reached
    return ring


def openings(face: Face) -> tuple[IntArray, IntArray, IntArray]:
    """Boundary loops of the mouth, the left and the right eye."""
    at = {
        "mouth": face.landmarks["upper_lip_mid"],
        "L": face.landmarks["upper_lid_mid_L"],
        "R": face.landmarks["upper_lid_mid_R"],
    }
    loops = face.skin.boundary_loops
    position = face.skin.positions

    def nearest(vertex: int) -> IntArray:
        return min(loops, key=lambda loop: float(np.linalg.norm(position[loop] - position[vertex], axis=1).min()))

    return nearest(at["mouth"]), nearest(at["L"]), nearest(at["R"])


def lip_share(face: Face) -> FloatArray:
    """How much each vertex (N,) belongs to the red of the lips: 1 at the mouth, 0 outside the vermilion border.

    The border runs along an edge loop through the landmarks of the vermilion, above and below.
    """
    mouth = openings(face)[0]
    ring = rings(face.skin, mouth, 12).astype(np.float64)
    upper = float(ring[[face.landmarks[n] for n in ("cupid_bow_L", "cupid_bow_R")]].mean())
    lower = float(ring[face.landmarks["lower_vermilion"]])
    position = face.skin.positions
    corner = position[[face.landmarks["mouth_corner_L"], face.landmarks["mouth_corner_R"]]].mean(axis=0)
    above = smooth(position[:, 1], corner[1] - 1.5, corner[1] + 1.5)
    border = lower + (upper - lower) * above
    wide = np.abs(position[:, 0]) / abs(position[face.landmarks["mouth_corner_L"], 0])
    return smooth(ring - border, 0.6, -0.6) * smooth(wide, *RED_CORNER)


def near(face: Face, names: tuple[str, ...], reach: float) -> FloatArray:
    """Gaussian (N,) of the distance to the nearest of some landmarks; ``reach`` is its standard deviation in mm."""
    places = face.skin.positions[[face.landmarks[n] for n in names]]
    distance = np.linalg.norm(face.skin.positions[:, None] - places[None], axis=2).min(axis=1)
    return np.asarray(np.exp(-0.5 * (distance / reach) ** 2))


def _lid_distance(face: Face) -> FloatArray:
    """Distance (N,) in mm to the nearest lid margin."""
    margin = np.concatenate(openings(face)[1:])
    position = face.skin.positions
    return np.asarray(np.linalg.norm(position[:, None] - position[margin][None], axis=2).min(axis=1))


def _lash_line(face: Face) -> FloatArray:
    """How dark the roots of the lashes make each vertex (N,), the upper ones more than the lower ones."""
    position = face.skin.positions
    dark = np.zeros(len(position))
    for eye in face.eyes:
        edge = lid_line(position, face.skin.triangles, eye).places(position)
        if len(edge):
            distance = np.linalg.norm(position[:, None] - edge[None], axis=2)
            level = (edge[edge[:, 0].argmin(), 1] + edge[edge[:, 0].argmax(), 1]) / 2
            upper = edge[distance.argmin(axis=1), 1] > level
            dark = np.maximum(dark, np.where(upper, 0.75, 0.40) * smooth(distance.min(axis=1), LASH_REACH, 0.3))
    return dark


def complexion(face: Face) -> Complexion:
    """Colours and gloss of every skin vertex, read off landmarks and openings."""
    palette = palette_of(face)
    position = face.skin.positions
    colours = np.broadcast_to(np.array(palette.skin), position.shape).copy()

    def lay(colour: Colour, share: FloatArray) -> None:
        colours[:] += (np.array(colour) - colours) * share[:, None]

    cheeks = near(face, ("cheek_L", "cheek_R"), 15.0)
    nose = np.maximum(near(face, ("nose_tip",), 9.0), near(face, ("ala_L", "ala_R"), 7.0))
    tragus = abs(float(position[face.landmarks["tragus_L"], 0]))
    ears = smooth(np.abs(position[:, 0]), tragus - 2.0, tragus + 8.0)
    chin = near(face, ("chin",), 13.0)
    lids = _lid_distance(face)
    lips = lip_share(face)
    lay(palette.pale, near(face, ("supraglabella", "frontal_eminence_L", "frontal_eminence_R"), 24.0))
    lay(palette.pale, 0.6 * near(face, ("suborbital_L", "suborbital_R"), 9.0))
    lay(palette.flush, 0.38 * cheeks)
    lay(palette.flush, 0.42 * nose)
    lay(palette.flush, 0.55 * ears)
    lay(palette.flush, 0.18 * chin)
    lay(palette.lids, 0.55 * smooth(lids, 11.0, 2.0))
    lay(palette.lash_line, _lash_line(face))
    lay(palette.lips, 0.92 * lips)

    shine = 1.0 + 0.5 * nose - 0.25 * cheeks + 0.5 * lips
    shine += 0.25 * near(face, ("supraglabella", "glabella"), 18.0) - 0.35 * ears
    return Complexion(np.clip(colours, 0.0, 1.0), np.asarray(shine))
