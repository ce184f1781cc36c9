"""Pulling a point of the face: the sliders follow the hand, as if it had moved them."""

from __future__ import annotations

from collections.abc import Collection

from app.document import Document
from app.sides import both_sides
from facemodel.animation.pulling import pulled
from fem.types import FloatArray


class PointPull:
    """One gesture, from the press on a point to its release; it is one step, or keys where the document is keying.

    Parameters
    ----------
    document : whose face is pulled; it has to be solved
    point : of the drawn skin
    among : fields that may move; all if not given
    linked : whether the other side does the same
    """

    def __init__(
        self, document: Document, point: int, among: Collection[str] | None = None, linked: bool = False
    ) -> None:
        self._linked = linked
        self._document, self._point, self._among = document, point, among
        self._before = dict(document.shown)
        self._moved: set[str] = set()

    def move(self, target: FloatArray, sight: FloatArray | None = None) -> None:
        """Show the face with the point as near to a place (3,) as it comes, millimetres; nothing without a solution.

        Parameters
        ----------
        target : where the point is to be
        sight : (3,) unit vector along which it does not matter where the point is
        """
        solution, units = self._document.solution, self._document.project.units
        if solution is None:
            return
        made = pulled(solution.basis, self._point, target, self._before, units, self._among, sight)
        changed = {name for name, weight in made.items() if weight != self._before.get(name, 0.0)}
        self._moved |= changed
        weights = {name: made.get(name, 0.0) for name in self._moved}
        self._document.preview(both_sides(weights, units, self._linked))

    def release(self) -> None:
        """Keep what is shown."""
        self._document.commit("Pull the face")

    def cancel(self) -> None:
        """Let the face go back."""
        self._document.cancel_preview()
