"""The tissue between skin and skull as a layer that keeps its volume where that is painted (design section 4)."""

from __future__ import annotations

from facemodel.face import Face
from facemodel.tissue import tissue_thickness
from fem import VolumeLayer
from fem.types import IntArray


def volume_layer(face: Face, vertices: IntArray) -> VolumeLayer:
    """The layer under some skin vertices; stiffness zero where nobody painted it."""
    return VolumeLayer(face.layers.volume[vertices], tissue_thickness(face)[vertices])
