"""One of our own heads as if somebody had measured it."""

from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.calibration.points68 import EXACT, ROUGH
from facemodel.face import Face
from fem.types import FloatArray, IntArray

TURN = Rotation.from_euler("xyz", [20.0, -35.0, 10.0], degrees=True).as_matrix()
SHIFT = np.array([120.0, -40.0, 300.0])


def landmarks68(face: Face) -> IntArray:
    """Return the vertices of the 68 points; those that no landmark of ours knows lie on the nose."""
    vertices = np.full(68, face.landmarks["nose_tip"])
    for name, points in {**ROUGH, **EXACT}.items():
        vertices[list(points)] = face.landmarks[name]
    return vertices


def arrays(face: Face, names: list[str], deltas: FloatArray) -> dict[str, np.ndarray]:
    """Return what a file of the face holds, turned and shifted."""
    return {
        "neutral": (face.skin.positions @ TURN + SHIFT).astype(np.float32),
        "triangles": face.skin.triangles.astype(np.int32),
        "landmarks68": landmarks68(face).astype(np.int32),
        "names": np.array(names),
        "deltas": (deltas @ TURN).astype(np.float32),
        "quads": np.zeros((1, 4), dtype=np.int32),
    }


def write(path: Path, contents: dict[str, np.ndarray]) -> Path:
    np.savez(path, **contents)
    return path
