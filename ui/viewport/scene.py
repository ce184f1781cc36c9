"""The scene: the face of a project on a plotter, lit, with the overlays that the view state asks for.

It draws nothing by itself: whoever changes it asks for a picture afterwards, at most once per frame.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pyvista as pv
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.differences import same_head
from app.muscle_pulls import MusclePulls
from app.solo import unit_in_hand
from app.view_state import ViewState
from facemodel.actions import Expression
from facemodel.kinematics import rig_of
from facemodel.muscles import Muscle
from facemodel.neutral import neutral_basis
from facemodel.project import Project
from facemodel.solve import Solution
from facemodel.superposition import Superposition
from fem.types import FloatArray
from ui.viewport.backdrop import hang
from ui.viewport.camera import (
    DIRECTIONS,
    Frame,
    aspect_of,
    draw_all,
    head_frame,
    level,
    look_closely,
    look_from,
    orbit,
    picture_scale,
    project_in_parallel,
    reach,
)
from ui.viewport.figure import Figure
from ui.viewport.lights import light
from ui.viewport.mount import HeadMount
from ui.viewport.muscle_fields import muscle_named, muscle_pull
from ui.viewport.overlays.chosen import ChosenOverlays
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.paint import Coat, paint_of, painted
from ui.viewport.pick import Hit, first_hit, ray_through, skin_vertex
from ui.viewport.shading import Ghost

CLOSE = 32.0
"""Half the height of the picture, millimetres, in which a place of the face is looked at."""

RESCALED = 0.02
"""Change of the picture's scale after which what has a size on the screen is made anew."""


class Scene:
    """The face of a project, drawn.

    Parameters
    ----------
    plotter : a `pyvista.Plotter`, in a window or off the screen

    Attributes
    ----------
    plotter, renderer : where it draws
    figure : the face as it is drawn; none before the first project
    mount : carries all of it as the head is held
    coat : paints the skin where nothing glows, before influence and supports do; then call `repaint`
    overlays : what can be drawn with the skin; ``skull`` is the bone, which can be carried and dyed
    state : what is shown
    """

    def __init__(self, plotter: pv.BasePlotter, theme: str = "dark") -> None:
        self.plotter = plotter
        self.renderer: vtkRenderer = plotter.renderer
        self.figure: Figure | None = None
        self.state = ViewState()
        self.mount = HeadMount()
        self._drawn: Drawn | None = None
        self.coat: Coat | None = None
        self._pulls = MusclePulls()
        self.overlays = ChosenOverlays(self.renderer)
        self.skull = self.overlays.skull
        plotter.camera_set = True
        light(self.renderer)
        self.renderer.SetUseOIT(False)
        draw_all(self.renderer)
        self.dress(theme)

    def dress(self, theme: str) -> None:
        """Hang the backdrop of a theme, ``dark`` or ``light``."""
        hang(self.renderer, theme)

    def show(self, project: Project, solution: Solution | None = None) -> None:
        """Show a project, at rest; without a solution the neutral face alone.

        The camera stays where it is, except for the first face or one of another size.
        """
        before = self._drawn
        basis = solution.basis if solution is not None else neutral_basis(project)
        same = before is not None and same_head(before.project.face, project.face)
        rig = rig_of(project.units)
        if self.figure is None or not same or not self.figure.posed.adopt(project.face, basis, rig):
            self._become(Figure(Superposition(project.face, basis, rig, linear=self.state.linear)))
        assert self.figure is not None
        self._drawn = self._seen_by(self.state, Drawn(project, self.figure, {}))
        if not same:
            self.look_from(self.state.view if self.state.view in DIRECTIONS else "three-quarter")
        self._ghost()
        self._paint()
        self.overlays.choose(self._drawn, self._wanted, anew=self.overlays.names)

    def _become(self, figure: Figure) -> None:
        for actor in self.figure.actors if self.figure is not None else ():
            self.renderer.RemoveActor(actor)
        self.figure = figure
        for actor in figure.actors:
            self.renderer.AddActor(actor)

    def update_project(self, project: Project) -> None:
        """Take over another value of the same face's project, for example other muscles or weights."""
        if self._drawn is None or not same_head(project.face, self._drawn.project.face):
            self.show(project)
            return
        before = self._drawn.project
        self._drawn = self._seen_by(self.state, replace(self._drawn, project=project))
        if before.units is not project.units:
            self._drawn.figure.posed.rig = rig_of(project.units)
        if any(getattr(before, name) is not getattr(project, name) for name in ("face", "muscles", "units")):
            self._paint()
            self.overlays.choose(self._drawn, self._wanted, anew=self.overlays.names)

    def pose(self, expression: Expression) -> None:
        """Pose the face; one changed weight costs one scaled addition of a field. Draws nothing."""
        if self.figure is None or self._drawn is None:
            return
        self.figure.posed.pose(expression)
        self._drawn = replace(self._drawn, expression=dict(expression))
        self.mount.hold(self.figure.posed.stance.head)
        self.figure.follow()
        self._follow()

    def apply(self, state: ViewState) -> None:
        """Show what a view state asks for; only what differs from before is touched, the camera never is."""
        before, self.state = self.state, state
        project_in_parallel(self.renderer.GetActiveCamera(), not state.perspective)
        if self._drawn is None:
            return
        self._drawn = self._seen_by(state, self._drawn)
        self.skull.tried = (state.jaw_open, state.jaw_slide, state.jaw_side) if state.jaw_tried else None
        if state.linear != self._drawn.figure.posed.linear:
            self._drawn.figure.posed.straighten(state.linear)
            self.pose(self._drawn.expression)
        self._ghost()
        if painted(state) != painted(before):
            self._paint()
        changed = {"influence": state.muscle != before.muscle, "muscles": state.hidden != before.hidden}
        self.overlays.choose(self._drawn, self._wanted, anew=[name for name in changed if changed[name]])
        self._follow()

    @property
    def drawn(self) -> Drawn | None:
        """What is on the screen; none before the first project."""
        return self._drawn

    def repaint(self) -> None:
        """Lay on the skin anew whatever lies on it."""
        self._paint()
        if self._drawn is not None:
            self.overlays.choose(self._drawn, self._wanted)

    def glow(self, keys: frozenset[str]) -> None:
        """Make the skin glow where some muscles pull; an empty set ends it."""
        if self._drawn is not None and keys != self._drawn.glowing:
            self._drawn = replace(self._drawn, glowing=keys)
            self._paint()
            self._follow()

    def before_frame(self) -> None:
        """To be called before a picture is drawn: what has a size on the screen follows the camera."""
        if self._drawn is None:
            return
        self.mount.carry(self.renderer)
        reach(self.renderer, self._drawn.project.face.skin.box)
        half = picture_scale(self.renderer.GetActiveCamera())
        if abs(half / self._drawn.half_height - 1) > RESCALED:
            self._drawn = replace(self._drawn, half_height=half)
            self.overlays.rescale(self._drawn)

    @property
    def frame(self) -> Frame:
        """What the whole head needs of the picture."""
        if self._drawn is None:
            return Frame(np.zeros(3), 120.0 * np.array([[1.0, 1.0, 1.0], [-1.0, -1.0, -1.0]]))
        return head_frame(self._drawn.project.face)

    @property
    def pivot(self) -> FloatArray:
        """The point (3,) that the camera turns about."""
        return self.frame.centre

    def look_from(self, view: str) -> None:
        """Frame the head in a named view."""
        camera = self.renderer.GetActiveCamera()
        look_from(camera, self.frame, view, aspect_of(self.renderer))
        camera.SetParallelProjection(not self.state.perspective)
        self.renderer.ResetCameraClippingRange()

    def frame_muscle(self, key: str) -> None:
        """Bring the skin that a muscle pulls to the middle of the picture and near, from where one looks now."""
        muscle = muscle_named(self._drawn.project, key) if self._drawn else None
        if muscle is None or self._drawn is None:
            return
        pull = muscle_pull(muscle, face := self._drawn.project.face)
        places = self.mount.outside(face.skin.positions[pull > 0.2 * pull.max()])
        towards = -np.array(self.renderer.GetActiveCamera().GetDirectionOfProjection())
        half = 1.6 * float(np.linalg.norm(places - places.mean(axis=0), axis=1).max())
        look_closely(self.renderer, places.mean(axis=0), towards, half)

    def frame_places(self, places: FloatArray) -> None:
        """Bring places (k, 3) of the skin to the middle of the picture and near, from where the skin faces."""
        if self._drawn is None:
            return
        skin = self._drawn.project.face.skin
        facing = self.mount.outwards(skin.normals[skin.tree.query(places)[1]].sum(axis=0))
        half = CLOSE + float(np.linalg.norm(places - places.mean(axis=0), axis=1).max())
        look_closely(self.renderer, self.mount.outside(places.mean(axis=0)), level(facing), half)

    def turn(self, degrees: float) -> None:
        """Turn the head by some degrees, as on a turntable."""
        orbit(self.renderer.GetActiveCamera(), self.pivot, degrees, 0.0)
        self.renderer.ResetCameraClippingRange()

    def pick(self, x: float, y: float) -> Hit | None:
        """The place of the posed skin under a point of the picture (pixels, from the lower left)."""
        if self.figure is None:
            return None
        posed = self.figure.posed
        return first_hit(posed.points, posed.basis.display.triangles, *self.ray(x, y))

    def ray(self, x: float, y: float) -> tuple[FloatArray, FloatArray]:
        """Origin and unit direction, in the head's own coordinates, of the ray through a point of the picture."""
        origin, along = ray_through(self.renderer, x, y)
        return self.mount.inside(origin), self.mount.inwards(along)

    def muscle_at(self, x: float, y: float) -> Muscle | None:
        """The muscle that lies most under a point of the picture."""
        hit = self.pick(x, y)
        if hit is None or self._drawn is None or self.figure is None:
            return None
        vertex = skin_vertex(self._drawn.project.face, self.figure.posed.basis.display, hit)
        return self._pulls.strongest(self._drawn.project, vertex, self.state.hidden)

    def _seen_by(self, state: ViewState, drawn: Drawn) -> Drawn:
        """What is drawn with what a view state selects of it."""
        unit = unit_in_hand(drawn.project, state)
        return replace(drawn, unit=unit, muscle=state.muscle, others=state.others, hidden=state.hidden)

    def _ghost(self) -> None:
        if self.figure is not None:
            veiled = self.state.skull or self.state.muscles
            self.figure.ghost(Ghost.VEIL if veiled else Ghost.SOLID, bones=self.state.skull)

    def _paint(self) -> None:
        if self.figure is not None and self._drawn is not None:
            self.figure.skin.paint(paint_of(self._drawn, self.state, self.coat))

    @property
    def _wanted(self) -> frozenset[str]:
        """The overlays that are asked for; under a coat there is no influence to have a legend."""
        coated = self.coat is not None
        return frozenset(
            name for name in self.overlays.names if getattr(self.state, name) and not (name == "influence" and coated)
        )

    def _follow(self) -> None:
        if self._drawn is not None:
            self.overlays.follow(self._drawn)
