"""From a moved slider to the drawn frame, against drawing the same mesh with nothing else."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping
from dataclasses import replace

import pyvista as pv
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from benchmarks.figure import Figure, Unmeasured, compared, interleaved
from facemodel.cache import solve_cached
from facemodel.project import Project, Settings
from facemodel.projects import new_project
from facemodel.solve import Solution
from ui.viewport.scene import Scene
from ui.viewport.surface import Surface

DENSITIES: Mapping[str, int] = {"25k": 3, "50k": 4}
SIZE = (1280, 960)
REPEATS = 21
LIMIT = 1.25


def figures() -> Iterator[Figure]:
    """Draw the default face off the screen, as the window does."""
    if sys.platform == "linux" and not os.environ.get("DISPLAY"):
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    for size, density in DENSITIES.items():
        project = replace(new_project(), settings=Settings(density=density))
        yield from _figures_at(size, project, solve_cached(project))


def _figures_at(size: str, project: Project, solution: Solution) -> Iterator[Figure]:
    slider, skin, plain = _Window(project, solution), _Window(project, solution), _PlainWindow(solution)
    if not slider.driver:
        raise Unmeasured("VTK found no OpenGL driver.")
    yield Figure(f"frames of {SIZE[0]} x {SIZE[1]} pixels drawn by {slider.driver}")
    skin.hide_all_but_the_skin()
    plain.look_like(slider)
    taken = interleaved(
        {"slider": slider.move_slider, "again": slider.draw, "skin": skin.draw_moved, "plain": plain.draw_moved},
        REPEATS,
    )
    what = f"slider to drawn frame, {len(slider.scene.figure.posed.points):,} points ({size})"
    yield compared(what, taken["slider"], "the skin alone, drawn as in the editor", taken["skin"], LIMIT)
    yield compared(what, taken["slider"], "the same picture drawn again", taken["again"])
    yield compared(what, taken["slider"], "the skin alone in VTK's plain shading", taken["plain"])
    for window in (slider, skin, plain):
        window.close()


class _Window:
    """The scene of the editor in a picture of its own."""

    def __init__(self, project: Project, solution: Solution) -> None:
        self._plotter = pv.Plotter(off_screen=True, window_size=SIZE, lighting="none")
        self._window = self._plotter.render_window
        self._window.SetMultiSamples(0)
        self.scene = Scene(self._plotter)
        self.scene.show(project, solution)
        self.scene.look_from("three-quarter")
        self._calls = 0
        self.draw()
        report = self._window.ReportCapabilities().splitlines()
        self.driver = next((line.partition(":")[2].strip() for line in report if "renderer string" in line), "")

    def move_slider(self) -> None:
        """Move one of four sliders and draw the frame."""
        self._calls += 1
        self.scene.pose({"12L": 0.3 + 0.001 * self._calls, "12R": 0.5, "26": 0.3, "1L": 0.4})
        self.scene.before_frame()
        self.draw()

    def draw(self) -> None:
        """Draw what is there and wait for the last pixel."""
        self._window.Render()
        self._window.WaitForCompletion()

    def draw_moved(self) -> None:
        """Draw the skin as if its points had moved, which has them sent to the graphics driver."""
        self.scene.figure.skin.surface.moved()
        self.draw()

    def hide_all_but_the_skin(self) -> None:
        """Leave nothing but the skin to be drawn."""
        for actor in self.scene.figure.actors:
            actor.SetVisibility(actor is self.scene.figure.skin.surface.actor)

    def close(self) -> None:
        """Give the graphics memory back."""
        self._plotter.close()


class _PlainWindow:
    """The skin alone, grey, with VTK's own shading and light."""

    def __init__(self, solution: Solution) -> None:
        display = solution.basis.display
        self._surface = Surface(display.points.copy(), display.normals.copy(), display.triangles)
        self._renderer = vtkRenderer()
        self._renderer.AddActor(self._surface.actor)
        self._window = vtkRenderWindow()
        self._window.SetOffScreenRendering(True)
        self._window.SetMultiSamples(0)
        self._window.SetSize(*SIZE)
        self._window.AddRenderer(self._renderer)

    def look_like(self, other: _Window) -> None:
        """Look from where another window looks."""
        self._renderer.SetActiveCamera(other.scene.renderer.GetActiveCamera())

    def draw_moved(self) -> None:
        """Draw as if the points had moved."""
        self._surface.moved()
        self._window.Render()
        self._window.WaitForCompletion()

    def close(self) -> None:
        """Give the graphics memory back."""
        self._window.Finalize()
