"""Tensors are in units of the skin, so that the chart leaves no mark on the fields."""

from dataclasses import fields, replace

import numpy as np
import pytest

from facemodel.chart import make_chart
from facemodel.face import Face, Layers
from facemodel.mesh import Mesh, submesh
from facemodel.project import Project, Settings
from facemodel.sampling import ELEMENTS, display_surface, head_surface
from facemodel.solve import face_system
from fem import Support
from fem.types import FloatArray

TESTED = (12, 26)
"""A smile, whose load lies close to the mouth, and the jaw, which loads the lower face."""

PAINTED = tuple(each.name for each in fields(Layers) if each.name != "supports")
"""What is interpolated on a finer mesh."""

Fields = dict[str, FloatArray]


@pytest.fixture(scope="module")
def few(project: Project) -> Project:
    """The default face with the tested units alone."""
    return replace(project, units=tuple(unit for unit in project.units if unit.number in TESTED))


def solved_with(project: Project, chart: FloatArray) -> Fields:
    """Return displacements at the solved vertices, each times the root of its area, by field."""
    assembled = face_system(replace(project, face=replace(project.face, chart=chart)))
    found = assembled.system.solve(assembled.loads)[assembled.region.assembler.dofs.value_dofs]
    areas = submesh(project.face.skin, project.face.solved)[0].vertex_areas
    return {name: np.sqrt(areas)[:, None] * found[..., k] for k, name in enumerate(assembled.names)}


def differences(one: Fields, other: Fields) -> dict[str, float]:
    """Return the norm of the difference over the skin as a share of the norm, by field."""
    return {name: float(np.linalg.norm(one[name] - other[name]) / np.linalg.norm(one[name])) for name in one}


def warped(chart: FloatArray) -> FloatArray:
    """Return the chart stretched and bent by a smooth map of the plane."""
    u, v = chart.T
    return np.column_stack([1.5 * u + 12 * np.sin(v / 60), v + 10 * np.sin(u / 50)])


def lower_face(face: Face) -> Face:
    """Return cheeks, mouth and chin alone, held along the outer rim: small enough to be solved on a fine mesh."""
    at = face.skin.positions
    inside = (at[:, 1] < 8) & (at[:, 2] > -10)
    skin, kept = submesh(face.skin, face.solved & inside[face.skin.triangles].all(axis=1))
    *_, rim = skin.boundary_loops
    layers = replace(face.layers, **{each.name: getattr(face.layers, each.name)[kept] for each in fields(face.layers)})
    skull = replace(face.skull, anchors=face.skull.anchors[kept], jawbone=face.skull.jawbone[kept])
    solved = ~np.isin(skin.triangles, rim).any(axis=1)
    changed = replace(face, skin=skin, solved=solved, layers=layers, skull=skull, parts=(), landmarks={})
    return replace(changed, chart=make_chart(skin))


def refined(face: Face) -> Face:
    """Return the face with every edge of its skin halved on the smooth surface, painted fields interpolated."""
    surface = display_surface(face, head_surface(face, ELEMENTS["hct12"]), 2)
    corners = face.skin.triangles[surface.elements]

    def spread(painted: FloatArray) -> FloatArray:
        return np.einsum("pk,pk...->p...", surface.barycentric, painted[corners])

    skin = Mesh(surface.points.astype(np.float64), surface.triangles)
    painted = {name: spread(getattr(face.layers, name)) for name in PAINTED}
    layers = replace(face.layers, **painted, supports=np.full(len(skin.positions), Support.FREE))
    skull = replace(face.skull, anchors=spread(face.skull.anchors), jawbone=spread(face.skull.jawbone))
    solved = (surface.triangles < surface.moving).all(axis=1)
    return replace(face, skin=skin, solved=solved, layers=layers, skull=skull, chart=make_chart(skin))


def test_two_charts_of_the_face_give_the_same_fields(few: Project) -> None:
    own = solved_with(few, few.face.chart)
    conformal = make_chart(few.face.skin, energy="CONFORMAL")
    for other in (conformal, warped(few.face.chart)):
        found = differences(own, solved_with(few, other))
        assert max(found.values()) < 0.03, found


def test_charts_agree_better_on_a_finer_mesh(few: Project) -> None:
    coarse = replace(few, face=lower_face(few.face), settings=Settings(element="hct9"))
    fine = replace(coarse, face=refined(coarse.face))
    gaps = [differences(solved_with(p, p.face.chart), solved_with(p, warped(p.face.chart))) for p in (coarse, fine)]
    for name in gaps[0]:
        assert gaps[1][name] < 0.6 * gaps[0][name], gaps
