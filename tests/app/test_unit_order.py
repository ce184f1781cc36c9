"""Units are listed in any order, merged in any proportion, and never told to push."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.authoring import units
from app.authoring.merging import merged
from app.authoring.ordering import listed, placed, stepped
from app.errors import UnitError
from facemodel.actions import GROUP_TITLES
from facemodel.project import Project
from facemodel.solve import solve_project


def numbers(project: Project) -> list[int]:
    return [unit.number for unit in listed(project)]


@pytest.fixture(scope="module")
def listing(project: Project) -> Project:
    """Return a project with two units in one group."""
    return units.with_duplicate(project, 12)[0]


def test_a_unit_is_put_in_front_of_another_one_and_takes_its_group(listing: Project) -> None:
    assert numbers(listing) == [17, 20, 12, 101, 26]
    made = placed(listing, 26, "diagonal", 12)
    assert numbers(made) == [17, 20, 26, 12, 101]
    assert units.unit_of(made, 26).group == "diagonal"
    assert numbers(placed(listing, 17, "diagonal", None)) == [20, 12, 101, 17, 26]
    assert placed(listing, 12, "diagonal", 101) is listing


@given(st.sampled_from([12, 20, 17, 26, 101]), st.sampled_from([-1, 1]))
def test_a_step_passes_one_unit_or_goes_over_into_the_next_group(listing: Project, number: int, by: int) -> None:
    before, unit = numbers(listing), units.unit_of(listing, number)
    made = stepped(listing, number, by)
    after = numbers(made)
    assert sorted(after) == sorted(before)
    assert [each for each in after if each != number] == [each for each in before if each != number]
    moved = after.index(number) - before.index(number)
    changed_group = units.unit_of(made, number).group != unit.group
    at_the_end = before[0 if by < 0 else -1] == number
    assert (moved, changed_group) == ((0, False) if at_the_end else (0, True) if changed_group else (by, False))


def test_steps_down_lead_through_every_group_and_back(listing: Project) -> None:
    made, groups = listing, []
    for _ in range(8):
        made = stepped(made, 17, 1)
        groups.append(units.unit_of(made, 17).group)
    assert numbers(made)[-1] == 17
    assert list(dict.fromkeys(groups)) == [g for g in GROUP_TITLES if g in groups]


@pytest.mark.parametrize(("own", "share"), [(1.0, 0.5), (0.25, 2.0), (0.0, 1.0)])
def test_a_merged_unit_does_so_much_of_both(project: Project, own: float, share: float) -> None:
    apart, one = solve_project(project).basis, solve_project(merged(project, 12, 20, own, share)).basis
    summed = own * apart.field("12L") + share * apart.field("20L")
    assert one.field("12L") == pytest.approx(summed, abs=1e-4 * float(abs(summed).max()))


def test_a_share_is_never_negative(project: Project) -> None:
    with pytest.raises(UnitError, match="share of action unit 20"):
        merged(project, 12, 20, 1.0, -0.5)


def test_a_muscle_only_pulls(project: Project) -> None:
    with pytest.raises(UnitError, match="only pulls; choose 0 or more"):
        units.with_activation(project, 12, "zygomaticus_major", -0.1)
