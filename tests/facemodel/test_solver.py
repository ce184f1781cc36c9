"""The living solver: whatever was edited, cancelled or failed before, it gives what a fresh solve gives."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.actions import ActionUnit, JawMotion
from facemodel.errors import FaceError
from facemodel.face import Layers
from facemodel.loads import contractions
from facemodel.muscles import Cosine, Fibre, Muscle
from facemodel.project import Project
from facemodel.solve import Cancelled, FaceSystem, Solution, face_system, solve_project
from facemodel.solver import FaceSolver, Work
from facemodel.staleness import stale_fields
from fem import Support
from tests.io.small_project import small_project

Edit = Callable[[Project], Project]

TOLERANCE = 1e-9
"""Relative; both solvers do the same sums, in another order at most."""


def with_muscle(project: Project, key: str, **changes: object) -> Project:
    muscles = tuple(replace(m, **changes) if m.key == key else m for m in project.muscles)  # type: ignore[arg-type]
    return replace(project, muscles=muscles)


def with_unit(project: Project, number: int, **changes: object) -> Project:
    units = tuple(replace(u, **changes) if u.number == number else u for u in project.units)  # type: ignore[arg-type]
    return replace(project, units=units)


def with_layers(project: Project, **changes: object) -> Project:
    layers: Layers = replace(project.face.layers, **changes)  # type: ignore[arg-type]
    return replace(project, face=replace(project.face, layers=layers))


def moved_fibre(project: Project, shift: float, key: str = "zygomaticus_major_L") -> Project:
    muscle = next(m for m in project.muscles if m.key == key)
    fibres = tuple(Fibre(f.origin, f.attachment + np.array([shift, 0.5 * shift, 0.0])) for f in muscle.fibres)
    return with_muscle(project, key, fibres=fibres)


def painted(project: Project, layer: str, vertices: list[int], factor: float) -> Project:
    values = getattr(project.face.layers, layer).copy()
    values[vertices] = values[vertices] * factor
    return with_layers(project, **{layer: values})


def supported(project: Project, vertices: list[int], kind: Support) -> Project:
    kinds = project.face.layers.supports.copy()
    kinds[vertices] = kind
    return with_layers(project, supports=kinds)


def turned(project: Project, degrees: float) -> Project:
    """The same with the tissue's grain of all skin at an angle."""
    angle = np.radians(degrees)
    grain = np.tile([np.cos(angle), np.sin(angle), 0.0], (len(project.face.skin.positions), 1))
    return with_layers(project, direction=grain)


def other_bone(project: Project, depth: float) -> Project:
    skull = replace(project.face.skull, anchors=project.face.skull.anchors - [0.3 * depth, 0.0, depth])
    return replace(project, face=replace(project.face, skull=skull))


def other_jawbone(project: Project, share: float) -> Project:
    skull = replace(project.face.skull, jawbone=project.face.skull.jawbone * share)
    return replace(project, face=replace(project.face, skull=skull))


def pseudo_muscle(project: Project, pull: float) -> Project:
    """The same with a muscle that displaces, contracted by the pucker."""
    fibre = Fibre(np.array([5.0, 30.0, 0.0]), np.array([0.0, -5.0, 10.0]))
    cosine = Cosine(np.array([50.0, 50.0, 50.0]), pull, np.ones(3))
    muscle = Muscle("puller", "M", "Puller", "lip", "cosine", (fibre,), None, 30.0, 1.0, 0.0, 1, cosine=cosine)
    kept = tuple(m for m in project.muscles if m.key != "puller")
    with_it = replace(project, muscles=(*kept, muscle))
    return with_unit(with_it, 18, muscles={"orbicularis_oris": 1.0, "puller": 0.5})


def another_unit(project: Project, number: int, weight: float) -> Project:
    unit = ActionUnit(number, f"unit {number}", "diagonal", True, {"zygomaticus_major": weight}, 5.0)
    return replace(project, units=(unit, *(u for u in project.units if u.number != number)))


AMOUNT = st.floats(0.5, 2.0)
VERTICES = st.lists(st.integers(0, 24), min_size=1, max_size=4, unique=True)
EDITS: st.SearchStrategy[Edit] = st.one_of(
    st.builds(lambda a: lambda p: moved_fibre(p, a), AMOUNT),
    st.builds(lambda a: lambda p: with_muscle(p, "orbicularis_oris", strength=0.01 * a), AMOUNT),
    st.builds(lambda a: lambda p: with_unit(p, 12, muscles={"zygomaticus_major": a}), AMOUNT),
    st.builds(lambda a: lambda p: with_unit(p, 26, jaw=JawMotion(10 * a, a)), AMOUNT),
    st.builds(lambda a: lambda p: another_unit(p, 99, a), AMOUNT),
    st.builds(lambda: lambda p: replace(p, units=p.units[::-1])),
    st.builds(lambda a: lambda p: pseudo_muscle(p, 0.2 * a), AMOUNT),
    st.builds(
        lambda layer, v, a: lambda p: painted(p, layer, v, a),
        st.sampled_from(["stretching", "bending", "stiffness"]),
        VERTICES,
        AMOUNT,
    ),
    st.builds(lambda a: lambda p: turned(p, 40 * a), AMOUNT),
    st.builds(lambda v, kind: lambda p: supported(p, v, kind), VERTICES, st.sampled_from(list(Support))),
    st.builds(lambda a: lambda p: other_bone(p, a), AMOUNT),
    st.builds(lambda a: lambda p: other_jawbone(p, a / 2), AMOUNT),
    st.builds(
        lambda density, element: lambda p: replace(p, settings=replace(p.settings, density=density, element=element)),
        st.integers(1, 3),
        st.sampled_from(["hct9", "hct12"]),
    ),
    st.builds(lambda: lambda p: small_project()),
)


def assert_same(found: Solution, expected: Solution) -> None:
    one, other = found.basis, expected.basis
    assert one.names == other.names
    assert found.unknowns == expected.unknowns
    assert found.chart == expected.chart
    assert np.array_equal(one.jaw, other.jaw)
    for name in ("points", "normals", "slopes", "triangles"):
        assert np.array_equal(getattr(one.display, name), getattr(other.display, name))
    for mine, fresh in ((one.fields, other.fields), (one.slopes, other.slopes)):
        assert mine.shape == fresh.shape
        assert mine.dtype == np.float32
        assert np.linalg.norm(mine - fresh) <= TOLERANCE * np.linalg.norm(fresh)


def interrupted(solver: FaceSolver, project: Project, after: int) -> None:
    """Solve and cancel at the given call of the progress, if there are that many."""
    calls = iter(range(after + 1))

    def progress(_text: str, _share: float) -> None:
        if next(calls, after) == after:
            raise Cancelled

    try:
        solver.solve(project, progress)
    except Cancelled:
        return


@settings(max_examples=20)
@given(st.lists(st.tuples(EDITS, st.integers(0, 8)), min_size=1, max_size=6))
def test_after_any_edits_and_cancellations_it_gives_what_a_fresh_solve_gives(steps: list[tuple[Edit, int]]) -> None:
    solver, project = FaceSolver(), small_project()
    for edit, call in steps:
        interrupted(solver, edit(project), call)
        if call % 2:
            project = edit(project)
        assert_same(solver.solve(project), solve_project(project))


@settings(max_examples=30)
@given(EDITS)
def test_fields_that_are_not_stale_are_as_they_were(edit: Edit) -> None:
    before = small_project()
    after = edit(before)
    stale = stale_fields(before, after)
    assert stale <= {name for unit in after.units for name in unit.fields}
    solver = FaceSolver()
    old, new = solver.solve(before).basis, solver.solve(after).basis
    for name in set(new.names) - stale:
        assert np.array_equal(old.field(name), new.field(name))
        assert np.array_equal(old.jaw[old.index[name]], new.jaw[new.index[name]])


@pytest.mark.parametrize(
    ("edit", "stale"),
    [
        (lambda p: p, set()),
        (lambda p: p.posed({"12L": 1.0}), set()),
        (lambda p: with_muscle(p, "orbicularis_oris", title="Lips", group="mouth"), set()),
        (lambda p: with_unit(p, 18, note="oo"), set()),
        (lambda p: moved_fibre(p, 1.0), {"12L"}),
        (lambda p: moved_fibre(p, -1.0, "zygomaticus_major_R"), {"12R"}),
        (lambda p: with_unit(p, 12, muscles={"zygomaticus_major": 0.7}), {"12L", "12R"}),
        (lambda p: another_unit(p, 99, 0.3), {"99L", "99R"}),
        (lambda p: with_unit(p, 26, jaw=JawMotion(5.0)), {"26"}),
        (lambda p: other_jawbone(p, 0.5), {"26"}),
        (lambda p: painted(p, "stretching", [12], 2.0), {"12L", "12R", "18", "26"}),
        (lambda p: supported(p, [12], Support.SLIDING), {"12L", "12R", "18", "26"}),
        (lambda p: with_unit(p, 18, muscles={"nothing": 1.0}), {"12L", "12R", "18", "26"}),
    ],
)
def test_an_edit_makes_stale_what_it_touches(edit: Edit, stale: set[str]) -> None:
    assert stale_fields(small_project(), edit(small_project())) == stale


def test_painting_what_is_held_anyway_costs_and_spoils_nothing() -> None:
    project = small_project()
    held = np.unique(project.face.skin.triangles[~project.face.solved]).tolist()
    corner = np.setdiff1d(held, project.face.skin.triangles[project.face.solved]).tolist()
    repainted = painted(painted(project, "stiffness", corner, 3.0), "bending", corner, 0.2)
    repainted = supported(repainted, held, Support.FREE)
    assert stale_fields(project, repainted) == frozenset()
    solver = FaceSolver()
    before = solver.solve(project)
    assert solver.solve(repainted).basis is before.basis


def solved_once(project: Project) -> FaceSolver:
    solver = FaceSolver()
    solver.solve(project)
    return solver


def work_of(edit: Edit) -> Work:
    project = small_project()
    solver = solved_once(project)
    solver.solve(edit(project))
    return solver.work


def test_a_moved_fibre_costs_one_back_substitution() -> None:
    assert work_of(lambda p: moved_fibre(p, 1.0)) == Work(triangles=0, factorised=False, columns=1, fields=1)


def test_another_weight_costs_no_solve() -> None:
    heavier = work_of(lambda p: with_unit(p, 12, muscles={"zygomaticus_major": 0.7}))
    assert heavier == Work(triangles=0, factorised=False, columns=0, fields=2)


def test_nothing_new_costs_nothing() -> None:
    assert work_of(lambda p: replace(p, units=tuple(replace(u) for u in p.units))) == Work()


def test_a_stroke_integrates_only_the_triangles_it_touches() -> None:
    work = work_of(lambda p: painted(p, "bending", [12], 3.0))
    skin = small_project().face
    around = (skin.skin.triangles[skin.solved] == 12).any(axis=1).sum()
    assert work.triangles == around
    assert work.factorised
    assert work.fields == 4


def test_a_cancelled_solve_keeps_the_factors_until_others_are_asked_for() -> None:
    project = small_project()
    solver = solved_once(project)
    interrupted(solver, painted(project, "stretching", [12], 3.0), 1)
    solver.solve(project)
    assert not solver.work.factorised


def test_a_failed_solve_is_told_and_leaves_the_solver_fit() -> None:
    project = small_project()
    solver = solved_once(project)
    loose = painted(project, "stiffness", list(range(25)), 0.0)
    loose = replace(loose, face=replace(loose.face, solved=np.arange(len(loose.face.solved)) >= 0))
    loose = supported(loose, list(range(25)), Support.FREE)
    with pytest.raises(FaceError, match="loose around skin vertex"):
        solver.solve(loose)
    with pytest.raises(FaceError, match="contracts the muscle “nothing”"):
        solver.solve(with_unit(project, 12, muscles={"nothing": 1.0}))
    assert_same(solver.solve(project), solve_project(project))


def test_a_vertex_that_slides_keeps_its_height_over_the_skin() -> None:
    project = supported(painted(small_project(), "stiffness", list(range(25)), 0.2), [12], Support.SLIDING)
    solution = FaceSolver().solve(replace(project, settings=replace(project.settings, density=1)))
    normal = project.face.skin.normals[12]
    place = np.flatnonzero((solution.basis.display.points == project.face.skin.positions[12]).all(axis=1))[0]
    for name in solution.basis.names:
        moved = solution.basis.field(name)[place].astype(np.float64)
        assert abs(moved @ normal) < 1e-6 * max(np.linalg.norm(moved), 1e-3)
        assert np.linalg.norm(moved) > 1e-3, "along the skin it is free"


def test_a_field_mixed_of_what_its_muscles_do_alone_is_that_of_their_loads_together(
    project: Project, assembled: FaceSystem
) -> None:
    """To 1e-12 on the default face, which is why another weight needs no solve."""
    contracted = contractions(project.units, project.muscles)
    names = [name for name in ("4L", "9R", "43L", "18L", "22", "25") if name in contracted]
    sources = sorted({key for name in names for key in contracted[name]})
    alone = tuple(ActionUnit(k + 1, "", "jaw", False, {key: 1.0}, 1.0) for k, key in enumerate(sources))
    each = tuple(replace(m, name=m.key, side="M") for m in project.muscles)
    loads = face_system(replace(project, units=alone, muscles=each)).loads
    columns = assembled.system.solve(loads)
    together = assembled.system.solve(assembled.loads[..., [assembled.names.index(name) for name in names]])
    for number, name in enumerate(names):
        mixed = sum(weight * columns[..., sources.index(key)] for key, weight in contracted[name].items())
        assert np.linalg.norm(mixed - together[..., number]) < 1e-12 * np.linalg.norm(together[..., number])


def test_on_the_default_face_a_moved_fibre_needs_no_new_factors(project: Project, solution: Solution) -> None:
    solver = FaceSolver()
    solver.solve(project)
    pulled = solver.solve(moved_fibre(project, 2.0))
    assert solver.work.columns == 1
    assert not solver.work.factorised
    assert stale_fields(project, moved_fibre(project, 2.0)) == {"12L"}
    assert not np.array_equal(pulled.basis.field("12L"), solution.basis.field("12L"))
    assert np.array_equal(pulled.basis.field("12R"), solution.basis.field("12R"))
    assert_same(solver.solve(project), solution)
