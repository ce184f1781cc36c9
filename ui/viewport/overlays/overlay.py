"""What all overlays share: they own actors in a renderer and follow what is drawn."""

from __future__ import annotations

from dataclasses import dataclass

from vtkmodules.vtkRenderingCore import vtkProp, vtkRenderer

from facemodel.actions import ActionUnit, Expression
from facemodel.project import Project
from ui.viewport.figure import Figure


@dataclass(frozen=True, eq=False)
class Drawn:
    """What is on the screen.

    Attributes
    ----------
    project : whose face it is
    figure : the face as it is drawn
    expression : the weights it is posed with
    unit : the action unit that is worked on; none where whole expressions are
    muscle : key of the selected muscle; empty for none
    others : keys of those that are selected with it
    glowing : keys of the muscles under the pointer
    hidden : keys of the muscles that are not drawn
    half_height : half the height of the picture at the head, millimetres
    """

    project: Project
    figure: Figure
    expression: Expression
    unit: ActionUnit | None = None
    muscle: str = ""
    others: frozenset[str] = frozenset()
    glowing: frozenset[str] = frozenset()
    hidden: frozenset[str] = frozenset()
    half_height: float = 150.0

    @property
    def pulling(self) -> Expression:
        """The weights whose forces are shown: of the unit that is worked on all, else those it is posed with."""
        return self.expression if self.unit is None else self.unit.full


class Overlay:
    """Something drawn with the skin that can be switched on and off.

    Parameters
    ----------
    renderer : where its actors go

    Attributes
    ----------
    shown : whether it is on
    """

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self._props: list[vtkProp] = []
        self.shown = False

    def show(self, drawn: Drawn) -> None:
        """Switch on, or build anew for another face."""
        self.hide()
        self.shown = True
        self.build(drawn)
        self.follow(drawn)

    def hide(self) -> None:
        """Switch off; every actor that was added goes."""
        for prop in self._props:
            self._renderer.RemoveViewProp(prop)
        self._props.clear()
        self.shown = False

    def add(self, prop: vtkProp) -> None:
        """Put an actor of this overlay into the picture."""
        self._props.append(prop)
        self._renderer.AddViewProp(prop)

    def build(self, drawn: Drawn) -> None:
        """Make the actors."""
        raise NotImplementedError

    def follow(self, drawn: Drawn) -> None:
        """Take over pose, selection and scale of the picture."""
