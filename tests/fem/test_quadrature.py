"""Triangle rules against the closed form of Dirichlet's integral."""

from math import factorial

import numpy as np
import pytest

from fem import rule_of_degree


@pytest.mark.parametrize("degree", range(1, 10))
def test_rule_integrates_every_monomial_of_its_degree(degree: int) -> None:
    rule = rule_of_degree(degree)
    assert rule.degree >= degree
    for i in range(rule.degree + 1):
        for j in range(rule.degree + 1 - i):
            k = rule.degree - i - j
            exact = 2.0 * factorial(i) * factorial(j) * factorial(k) / factorial(rule.degree + 2)
            found = rule.weights @ np.prod(rule.points ** np.array([i, j, k]), axis=1)
            assert found == pytest.approx(exact, rel=1e-13)


@pytest.mark.parametrize("degree", [5, 7, 9])
def test_rule_is_not_exact_one_degree_higher(degree: int) -> None:
    rule = rule_of_degree(degree)
    n = rule.degree + 1
    errors = [
        abs(
            rule.weights @ (rule.points[:, 0] ** i * rule.points[:, 1] ** (n - i))
            - 2.0 * factorial(i) * factorial(n - i) / factorial(n + 2)
        )
        for i in range(n + 1)
    ]
    assert max(errors) > 1e-7


@pytest.mark.parametrize("degree", [5, 7, 9])
def test_points_are_inside_and_weights_positive(degree: int) -> None:
    rule = rule_of_degree(degree)
    assert rule.points.min() > 0.0
    assert rule.weights.min() > 0.0
    assert rule.points.sum(axis=1) == pytest.approx(1.0)
