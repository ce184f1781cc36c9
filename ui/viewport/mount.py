"""The head as it is held: everything in the picture belongs to it, and moves with it as one."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkProp3D, vtkRenderer

from fem.types import FloatArray


class HeadMount:
    """Carries all that is drawn by the motion of the head; what draws and picks goes on in the head's own coordinates.

    Attributes
    ----------
    motion : (4, 4) from the head's own coordinates to those of the picture
    """

    def __init__(self) -> None:
        self.motion = np.eye(4)
        self._matrix = vtkMatrix4x4()
        self._carried = 0

    def hold(self, motion: FloatArray) -> None:
        """Move the head."""
        if np.array_equal(motion, self.motion):
            return
        self.motion = motion
        self._matrix.DeepCopy([float(x) for x in motion.ravel()])

    def carry(self, renderer: vtkRenderer) -> None:
        """Take up whatever has come into the picture and has no motion of its own."""
        props = renderer.GetViewProps()
        if props.GetMTime() == self._carried:
            return
        self._carried = props.GetMTime()
        for prop in props:
            if isinstance(prop, vtkProp3D) and prop.GetUserMatrix() is None:
                prop.SetUserMatrix(self._matrix)

    def outside(self, places: FloatArray) -> FloatArray:
        """Where places (..., 3) of the head are in the picture."""
        return np.asarray(places @ self.motion[:3, :3].T + self.motion[:3, 3])

    def inside(self, places: FloatArray) -> FloatArray:
        """Which places (..., 3) of the head are at places of the picture."""
        return np.asarray((places - self.motion[:3, 3]) @ self.motion[:3, :3])

    def outwards(self, ways: FloatArray) -> FloatArray:
        """Ways (..., 3) of the head as they are in the picture."""
        return np.asarray(ways @ self.motion[:3, :3].T)

    def inwards(self, ways: FloatArray) -> FloatArray:
        """Ways (..., 3) of the picture as seen from the head."""
        return np.asarray(ways @ self.motion[:3, :3])
