"""Eyes, head and tongue of an action unit: set by numbers, refused out of range, kept in files, merged and parted."""

import pytest

from app.authoring import motions, parting
from app.authoring.merging import merged
from app.authoring.units import unit_of
from app.errors import UnitError
from facemodel.io.project_file import project_bytes, project_of
from facemodel.motions import EyeMotion, HeadMotion, TongueMotion
from facemodel.project import Project


def moving(project: Project) -> Project:
    made = motions.with_eyes(project, 17, turn=-20.0, lift=5.0)
    made = motions.with_head(made, 17, tilt=12.0, forward=8.0)
    return motions.with_tongue(made, 17, out=20.0, lift=-15.0)


def test_what_a_unit_does_to_eyes_head_and_tongue_comes_back_from_its_file(project: Project) -> None:
    unit = unit_of(project_of(project_bytes(moving(project))), 17)
    assert unit.eyes == EyeMotion(-20.0, 5.0)
    assert unit.head == HeadMotion(tilt=12.0, forward=8.0)
    assert unit.tongue == TongueMotion(20.0, -15.0)


def test_motions_of_nothing_are_none(project: Project) -> None:
    still = motions.with_tongue(motions.with_head(motions.with_eyes(moving(project), 17), 17), 17)
    assert unit_of(still, 17) == unit_of(project, 17)


def test_numbers_out_of_range_and_units_with_sides_are_refused(project: Project) -> None:
    with pytest.raises(UnitError, match="turn of the eyes is 100"):
        motions.with_eyes(project, 17, turn=100.0)
    with pytest.raises(UnitError, match="motion of the tongue"):
        motions.with_tongue(project, 17, out=float("nan"))
    with pytest.raises(UnitError, match="head move as one"):
        motions.with_head(project, 12, tilt=5.0)
    with pytest.raises(UnitError, match="no sides to part"):
        parting.split(moving(project), 17)


def test_merging_adds_up_motions_in_their_shares(project: Project) -> None:
    unit = unit_of(merged(moving(project), 26, 17, 1.0, 0.5), 26)
    assert unit.tongue == TongueMotion(10.0, -7.5)
    assert unit.eyes == EyeMotion(-10.0, 2.5)
    assert unit.head == HeadMotion(tilt=6.0, forward=4.0)
