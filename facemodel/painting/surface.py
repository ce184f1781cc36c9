"""The skin as a brush sees it: everything about it that painting needs and that is found once."""

from __future__ import annotations

from functools import cached_property

from scipy.sparse import csr_array

from facemodel.mesh import Mesh
from facemodel.painting.frames import TangentFrames, tangent_frames
from facemodel.painting.geodesic import Geodesics
from facemodel.painting.smoothing import smoothing
from facemodel.painting.sweep import SkinPath


class PaintSurface:
    """A skin to paint on; its tables are made on first use and kept.

    Parameters
    ----------
    mesh : the skin
    """

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh

    @cached_property
    def geodesics(self) -> Geodesics:
        """Distances on the skin."""
        return Geodesics(self.mesh)

    @cached_property
    def path(self) -> SkinPath:
        """Ways over the skin."""
        return SkinPath(self.mesh)

    @cached_property
    def frames(self) -> TangentFrames:
        """Tangents at the vertices."""
        return tangent_frames(self.mesh.normals)

    @cached_property
    def smoothing(self) -> csr_array:
        """One step of evening out."""
        return smoothing(self.mesh)
