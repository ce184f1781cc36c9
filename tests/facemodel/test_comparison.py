"""The sum of fields is what summed loads give in full, also where a jaw turns, which is not linear."""

from dataclasses import replace

from facemodel.actions import ActionUnit, JawMotion
from facemodel.comparison import compared, in_full
from facemodel.solve import solve_project
from tests.app.conftest import small_project


def test_summed_loads_give_the_sum_of_fields_also_along_the_arc_of_the_jaw():
    project = small_project()
    basis = solve_project(project).basis
    jawless = [unit for unit in project.units if unit.jaw is None]
    posed = {field: 0.3 + 0.1 * k for k, unit in enumerate(jawless) for field in unit.fields}
    same = compared(project, posed, basis, in_full(project, posed))
    assert same.moved > 1e-3
    assert same.rms <= same.largest < 2e-5 * max(1.0, same.moved)

    turning = ActionUnit(200, "gape", "jaw", False, {}, 10.0, JawMotion(30.0))
    gaping = replace(project, units=(*project.units, turning))
    half = posed | {"200": 0.5}
    arc = compared(gaping, half, solve_project(gaping).basis, in_full(gaping, half))
    assert arc.largest < 2e-5 * arc.moved
