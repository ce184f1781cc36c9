"""Fields add up: any expression is the full solve of its summed loads."""

from dataclasses import replace

import numpy as np
import pytest

from facemodel.actions import skin_units
from facemodel.basis import Basis
from facemodel.project import Project
from facemodel.solve import FaceSystem, sampled_basis
from fem.types import FloatArray


@pytest.fixture(scope="module")
def coefficients(assembled: FaceSystem) -> FloatArray:
    """Coefficients (n_dofs, 3, M) of all fields."""
    return assembled.system.solve(assembled.loads)


def relative(found: FloatArray, expected: FloatArray) -> float:
    return float(np.linalg.norm(found - expected) / np.linalg.norm(expected))


@pytest.mark.parametrize("seed", range(3))
def test_superposed_fields_equal_a_full_solve_of_the_summed_loads(
    assembled: FaceSystem, coefficients: FloatArray, seed: int
) -> None:
    weights = np.random.default_rng(seed).uniform(-0.2, 1.0, len(assembled.names))
    at_once = assembled.system.solve(assembled.loads @ weights)
    assert relative(coefficients @ weights, at_once) < 1e-6


def test_the_kept_single_precision_fields_superpose_as_well(
    project: Project, basis: Basis, assembled: FaceSystem
) -> None:
    weights = np.random.default_rng(7).uniform(0.0, 1.0, len(basis.names))
    total = assembled.system.solve((assembled.loads @ weights)[..., None])
    at_once = sampled_basis(project, replace(assembled, names=("sum",)), total)
    skin = slice(3 * sum(count for _, count in basis.display.carried), None)
    for kept, solved in ((basis.fields[:, skin], at_once.fields[:, skin]), (basis.slopes, at_once.slopes)):
        assert relative(weights @ kept.astype(np.float64), solved[0].astype(np.float64)) < 1e-6


def test_left_and_right_are_the_unit_on_both_sides(
    project: Project, assembled: FaceSystem, coefficients: FloatArray
) -> None:
    for unit in skin_units(project.units):
        rows = [assembled.names.index(name) for name in unit.fields]
        both = assembled.system.solve(assembled.loads[..., rows].sum(axis=2))
        assert relative(coefficients[..., rows].sum(axis=2), both) < 1e-6


def test_one_factorisation_serves_every_load(assembled: FaceSystem, coefficients: FloatArray) -> None:
    assert coefficients.shape[2] == len(assembled.names)
    assert assembled.system.factorisations == 1
