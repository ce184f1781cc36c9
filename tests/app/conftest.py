"""A small face that the real solver solves in an instant, and what stands upon it."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from app.actions import Context
from app.document import Document
from app.jobs import SolveJob
from app.settings import UserSettings
from app.solving import Solving
from app.view import View
from facemodel.actions import ActionUnit, Emotion, JawMotion
from facemodel.face import Eye, Face, Jaw, Layers, Part, Skull
from facemodel.mesh import Mesh
from facemodel.muscles import Fibre, Muscle
from facemodel.project import Project
from facemodel.solve import Cancelled, Progress, Solution, solve_project
from fem.supports import Support
from fem.types import FloatArray
from tests.app.desk import Desk

SIDE = 9
"""Vertices along one edge of the patch of skin."""


def curved_patch() -> tuple[Mesh, FloatArray]:
    """Return a square of skin 80 mm wide, bulging forward, and its chart."""
    u, v = (axis.ravel() for axis in np.meshgrid(np.linspace(-40, 40, SIDE), np.linspace(-40, 40, SIDE)))
    positions = np.column_stack([u, v, 20 - (u**2 + v**2) / 160])
    corner = np.arange(SIDE * SIDE).reshape(SIDE, SIDE)
    a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]))
    triangles = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    return Mesh(positions, triangles.astype(np.int64)), np.column_stack([u, v])


def tetrahedron(centre: tuple[float, float, float]) -> Mesh:
    corners = np.array([[1.0, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    faces = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], dtype=np.int64)
    return Mesh(corners + np.array(centre), faces)


def small_face(title: str = "Patch") -> Face:
    """Return a patch of skin over a bone 5 mm behind it, its lower third over the mandible."""
    skin, chart = curved_patch()
    count = len(skin.positions)
    rim = np.abs(chart).max(axis=1) > 39
    layers = Layers(
        direction=np.tile([1.0, 0, 0], (count, 1)),
        stretching=np.full((count, 2), 0.05),
        bending=np.tile([0.5, 0.5, 0.5], (count, 1)),
        stiffness=np.full(count, 0.002),
        thickness=np.zeros(count),
        sliding=np.full(count, 12.0),
        volume=np.zeros(count),
        supports=np.where(rim, Support.CLAMPED, Support.FREE).astype(np.int64),
    )
    skull = Skull(
        cranium=tetrahedron((0, 0, -20)),
        mandible=tetrahedron((0, -30, -20)),
        anchors=skin.positions - [0, 0, 5.0],
        jawbone=(chart[:, 1] < -15).astype(np.float64),
        jaw=Jaw(np.array([[-40.0, 20, -40], [40, 20, -40]]), np.array([0.0, -20, 5])),
    )
    teeth = Part("teeth-lower", "teeth", "jaw", tetrahedron((0, -20, 5)), np.zeros((0, 0), np.int64), np.zeros((0, 0)))
    eyes = (Eye("L", np.array([20.0, 20, 0]), 8.0), Eye("R", np.array([-20.0, 20, 0]), 8.0))
    return Face(
        key="patch",
        title=title,
        skin=skin,
        solved=np.ones(len(skin.triangles), dtype=np.bool_),
        uv=(chart + 40) / 80,
        mirror=np.arange(count).reshape(SIDE, SIDE)[:, ::-1].ravel(),
        chart=chart,
        landmarks={},
        eyes=eyes,
        parts=(teeth,),
        skull=skull,
        layers=layers,
    )


def cheek_muscle(side: str) -> Muscle:
    sign = 1.0 if side == "L" else -1.0
    fibre = Fibre(np.array([30.0 * sign, 30, 5]), np.array([15.0 * sign, -10, 15]))
    return Muscle(
        "zygomaticus_major",
        side,
        "Zygomaticus major",
        "cheek",
        "fibre",
        (fibre,),
        None,
        12.0,
        2.0,
        0.02,
        5,  # type: ignore[arg-type]
    )


UNITS = (
    ActionUnit(12, "lip corner puller", "diagonal", True, {"zygomaticus_major": 1.0}, 5.0),
    ActionUnit(20, "lip stretcher", "horizontal", True, {"zygomaticus_major": 0.5}, 4.0),
    ActionUnit(17, "chin raiser", "vertical", False, {"zygomaticus_major": 0.3}, 3.0),
    ActionUnit(26, "jaw drop", "jaw", False, {}, 20.0, JawMotion(15.0, 3.0)),
)
EMOTIONS = (Emotion("happiness", {"12": 0.9}), Emotion("surprise", {"26": 0.8, "20L": 0.1}))


def small_project(title: str = "Patch") -> Project:
    muscles = (cheek_muscle("L"), cheek_muscle("R"))
    return Project(small_face(title), muscles, UNITS, EMOTIONS)


@pytest.fixture(scope="session")
def project() -> Project:
    """A project with paired and single units; a frozen value, so that all tests may share it."""
    return small_project()


@pytest.fixture(scope="session")
def other_project() -> Project:
    """A project with another face."""
    return small_project("Other patch")


@pytest.fixture
def document(project: Project) -> Document:
    return Document(project)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "patch.risorius"


@pytest.fixture
def desk() -> Desk:
    return Desk()


def solve_small(project: Project, progress: Progress) -> Solution:
    """Solve the small face, and give up on the large ones: what is tested here does not depend on them."""
    if project.face.key != "patch":
        raise Cancelled
    return solve_project(project, progress)


@pytest.fixture
def context(document: Document, desk: Desk, tmp_path: Path) -> Iterator[Context]:
    job = SolveJob(solve_small)
    yield Context(document, View(), UserSettings(tmp_path / "preferences.json"), Solving(document, job), desk)
    job.close()
