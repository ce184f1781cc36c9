"""Solving a project: told as it goes, stopped when asked, and clear about a face that nothing holds."""

import re
from dataclasses import replace

import numpy as np
import pytest

from facemodel.errors import FaceError
from facemodel.project import Project, Settings
from facemodel.solve import Cancelled, Solution, solve_project
from fem import Support
from tests.app.conftest import small_project

SMALL = small_project()


def test_progress_rises_from_nothing_to_the_whole() -> None:
    shares: list[float] = []
    texts: list[str] = []

    def watch(text: str, share: float) -> None:
        shares.append(share)
        texts.append(text)

    solve_project(SMALL, watch)
    assert 0.0 <= shares[0] < 0.1
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert all(texts)
    counted = [match.groups() for text in texts if (match := re.search(r"(\d+) of (\d+)", text))]
    assert counted[-1][0] == counted[-1][1] != "0"


@pytest.mark.parametrize("after", [1, 2, 3, 5])
def test_whoever_watches_may_stop_it(after: int) -> None:
    calls = 0

    def stop(_text: str, _share: float) -> None:
        nonlocal calls
        calls += 1
        if calls == after:
            raise Cancelled

    with pytest.raises(Cancelled):
        solve_project(SMALL, stop)
    assert calls == after, "nothing is told after the end"


def test_a_stopped_solve_leaves_no_trace() -> None:
    def stop(_text: str, share: float) -> None:
        if share > 0.3:
            raise Cancelled

    before = solve_project(SMALL).basis
    with pytest.raises(Cancelled):
        solve_project(SMALL, stop)
    after = solve_project(SMALL).basis
    assert np.array_equal(before.fields, after.fields)
    assert np.array_equal(before.slopes, after.slopes)


def loosened(project: Project, stiffness: float = 0.0) -> Project:
    face = project.face
    layers = replace(
        face.layers,
        stiffness=np.full_like(face.layers.stiffness, stiffness),
        volume=np.zeros_like(face.layers.volume),
        supports=np.full_like(face.layers.supports, Support.FREE),
    )
    everything = np.ones_like(face.solved)
    return replace(project, face=replace(face, layers=layers, solved=everything))


def test_a_face_that_nothing_holds_is_named_with_its_place_and_the_remedy() -> None:
    with pytest.raises(FaceError, match=r"loose around skin vertex \d+.*Paint tissue stiffness or a support"):
        solve_project(loosened(SMALL))


def test_the_default_face_without_bone_and_rim_is_loose_too(project: Project) -> None:
    with pytest.raises(FaceError, match=r"loose around skin vertex \d+"):
        solve_project(loosened(project))


def test_tissue_alone_holds_a_face() -> None:
    assert np.isfinite(solve_project(loosened(SMALL, 0.01)).basis.fields).all()


def test_figures_tell_of_chart_size_and_time(solution: Solution) -> None:
    assert solution.chart.flips == 0
    assert 1.0 < solution.chart.p95 < solution.chart.worst
    assert solution.unknowns > 20_000
    assert {"assembly", "factorisation", "solve", "sample"} <= set(solution.seconds)
    assert all(seconds >= 0 for seconds in solution.seconds.values())


@pytest.mark.parametrize("element", ["hct9", "hct12"])
def test_density_changes_what_is_drawn_and_not_what_is_solved(element: str) -> None:
    coarse = solve_project(replace(SMALL, settings=Settings(element, 1)))  # type: ignore[arg-type]
    fine = solve_project(replace(SMALL, settings=Settings(element, 4)))  # type: ignore[arg-type]
    assert fine.unknowns == coarse.unknowns
    assert fine.basis.display.moving > 4 * coarse.basis.display.moving
    for name in coarse.basis.names:
        assert fine.basis.peak(name) >= coarse.basis.peak(name) * (1 - 1e-6)
        at_vertices = len(SMALL.face.skin.positions)
        assert fine.basis.moving_field(name)[:at_vertices] == pytest.approx(
            coarse.basis.moving_field(name)[:at_vertices], abs=1e-6
        )


def test_both_elements_tell_the_same_story(solution: Solution, project: Project) -> None:
    few = replace(project, units=tuple(u for u in project.units if u.number in (12, 26)), settings=Settings("hct9", 3))
    other = solve_project(few).basis
    for name in other.names:
        one, two = solution.basis.moving_field(name), other.moving_field(name)
        assert np.linalg.norm(one - two) < 0.05 * np.linalg.norm(one)
