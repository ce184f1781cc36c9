"""Named places of the skin: where tables measure the depth of tissue, and where muscles attach.

Every shipped person is the same base mesh in another shape, so a landmark is one vertex for all of them. It is
given by where it lies on the base shape, which does not change when the skin is cut or numbered anew.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from facemodel.errors import FaceError
from facemodel.making.cut import Cut
from fem.types import FloatArray, IntArray

MIDLINE: Mapping[str, tuple[float, float, float]] = {
    "supraglabella": (0.0, 771.9, 151.4),
    "glabella": (0.0, 751.6, 152.9),
    "nasion": (0.0, 732.3, 150.6),
    "rhinion": (0.0, 710.5, 158.3),
    "nose_tip": (0.0, 690.9, 168.1),
    "subnasale": (0.0, 677.2, 155.8),
    "mid_philtrum": (0.0, 672.2, 157.1),
    "upper_vermilion": (0.0, 668.3, 160.2),
    "upper_lip_incisor": (0.0, 664.9, 158.9),
    "upper_lip_mid": (0.0, 662.7, 151.1),
    "lower_lip_mid": (0.0, 660.2, 150.9),
    "lower_lip_incisor": (0.0, 655.6, 156.6),
    "lower_vermilion": (0.0, 648.9, 155.7),
    "chin_lip_fold": (0.0, 643.0, 149.1),
    "pogonion": (0.0, 632.7, 149.9),
    "chin": (0.0, 627.1, 148.3),
    "menton": (0.0, 616.8, 137.8),
}
"""Landmarks of the midline on the base shape, millimetres.  The lips' mid points lie on the wet line."""

PAIRED: Mapping[str, tuple[float, float, float]] = {
    "eye_inner": (20.4, 727.1, 134.6),
    "eye_outer": (43.5, 727.7, 130.8),
    "upper_lid_mid": (31.4, 732.5, 136.8),
    "lower_lid_mid": (31.0, 724.7, 136.1),
    "mouth_corner": (25.0, 661.5, 137.4),
    "frontal_eminence": (39.8, 785.4, 131.4),
    "supraorbital": (34.0, 746.4, 142.0),
    "suborbital": (32.4, 711.2, 141.2),
    "inferior_malar": (34.9, 695.2, 142.5),
    "lateral_orbit": (49.5, 706.2, 132.6),
    "brow_inner": (16.2, 745.7, 148.9),
    "brow_mid": (33.7, 750.2, 142.3),
    "brow_outer": (48.3, 745.1, 132.6),
    "ala": (16.9, 688.1, 150.7),
    "cupid_bow": (5.3, 669.6, 159.6),
    "cheek": (43.0, 704.1, 137.7),
    "nasolabial": (26.1, 679.1, 144.4),
    "zygion": (69.8, 706.5, 77.8),
    "supraglenoid": (70.8, 722.9, 70.9),
    "gonion": (55.3, 657.9, 78.1),
    "upper_second_molar": (55.6, 672.4, 112.2),
    "mid_masseter": (63.4, 676.0, 84.5),
    "lower_second_molar": (50.9, 651.1, 104.2),
    "tragus": (73.0, 704.9, 61.9),
}
"""Landmarks of the subject's left side; the right one is the mirrored vertex.  Lid points lie on the margins."""

REACH = 0.5
"""Millimetres: a landmark farther than this from every vertex means that the base mesh is another one."""


def _vertex_at(name: str, place: tuple[float, float, float], positions: FloatArray) -> int:
    distance = np.linalg.norm(positions - place, axis=1)
    vertex = int(distance.argmin())
    if distance[vertex] > REACH:
        raise FaceError(
            f"The landmark {name} has no vertex near {place} (the nearest is {distance[vertex]:.1f} mm off); "
            "the landmarks fit the hm08 base mesh in its base shape, in millimetres."
        )
    return vertex


def find_landmarks(positions: FloatArray, mirror: IntArray) -> dict[str, int]:
    """Skin vertices by anatomical name.

    Parameters
    ----------
    positions : (N, 3) skin vertices in the base shape, millimetres
    mirror : (N,) the vertex across the midline

    Returns
    -------
    One vertex per name; paired names end in ``_L`` (the subject's left, +x) and ``_R``.

    Raises
    ------
    FaceError
        if a landmark is on no vertex, or one of the midline is not its own mirror image
    """
    found: dict[str, int] = {}
    for name, place in MIDLINE.items():
        vertex = _vertex_at(name, place, positions)
        if mirror[vertex] != vertex:
            raise FaceError(f"The landmark {name} is off the midline; the mirror map does not fit the skin.")
        found[name] = vertex
    for name, place in PAIRED.items():
        vertex = _vertex_at(name, place, positions)
        found[f"{name}_L"], found[f"{name}_R"] = vertex, int(mirror[vertex])
    return found


def landmarks(cut: Cut, base_positions: FloatArray) -> dict[str, int]:
    """Landmarks of the skin that ``cut`` takes from the base mesh, whose base shape is (V, 3)."""
    return find_landmarks(cut.positions(base_positions), cut.mirror)
