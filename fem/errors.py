"""What can go wrong between a surface and its solution."""

from fem.types import IntArray


class FemError(ValueError):
    """A surface, tensor, support or load that cannot be solved as given."""


class SingularSystemError(FemError):
    """The supports and springs leave part of the surface free to move.

    Parameters
    ----------
    message
        One sentence saying where the surface is loose and what would hold it.
    vertices
        (k,) vertices of the loose part, the loosest first.
    """

    def __init__(self, message: str, vertices: IntArray) -> None:
        super().__init__(message)
        self.vertices = vertices
