"""The default face, solved once for all tests of a run."""

from collections.abc import Callable
from functools import cache

import pytest

from facemodel.basis import Basis
from facemodel.cache import solve_cached
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.faces import load_face
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solve import FaceSystem, Solution, face_system


@pytest.fixture(scope="session")
def project() -> Project:
    """The project that a first start shows; a frozen value."""
    return new_project()


@pytest.fixture(scope="session")
def face(project: Project) -> Face:
    return project.face


@pytest.fixture(scope="session")
def assembled(project: Project) -> FaceSystem:
    """The linear system of the default face; factorised by whichever test needs it first."""
    return face_system(project)


@pytest.fixture(scope="session")
def solution(project: Project) -> Solution:
    """The default face with all of its action units solved."""
    return solve_cached(project)


@pytest.fixture(scope="session")
def basis(solution: Solution) -> Basis:
    return solution.basis


@pytest.fixture(scope="session")
def display(basis: Basis) -> DisplaySurface:
    return basis.display


@pytest.fixture(scope="session")
def shipped() -> Callable[[str], Face]:
    """Load a shipped face, each only once."""
    return cache(load_face)
