"""New projects from the shipped faces, and the atlas that lays their muscles."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from facemodel.actions import ActionUnit, JawMotion
from facemodel.atlas import Atlas, read_atlas, write_atlas
from facemodel.errors import ProjectError, UnknownNameError
from facemodel.faces import face_keys
from facemodel.facs import action_units
from facemodel.loads import field_forces
from facemodel.projects import new_project
from resources import resource


@pytest.mark.parametrize("key", face_keys())
def test_a_new_project_is_at_rest_and_every_unit_has_its_forces(key: str) -> None:
    project = new_project(key)
    assert project.face.key == key
    assert project.expression == {}
    assert len(project.emotions) == 16
    names, forces = field_forces(project.units, project.muscles, project.face)
    assert np.isfinite(forces).all()
    without_muscles = {name for unit in project.units if not unit.muscles for name in unit.fields}
    for name, force in zip(names, forces, strict=True):
        assert force.any() or name in without_muscles, name


def test_units_are_the_tables_with_this_faces_strength() -> None:
    project = new_project()
    atlas = read_atlas(resource("atlas", f"{project.face.key}.json"))
    for unit, table in zip(project.units, action_units(), strict=True):
        gain = atlas.gains[table.number] if table.moves_skin else 1.0
        assert (unit.number, unit.name, unit.amplitude) == (table.number, table.name, table.amplitude)
        assert unit.muscles == pytest.approx({name: gain * weight for name, weight in table.muscles.items()})


def test_a_gain_turns_the_jaw_further_and_slides_it_no_further() -> None:
    unit = ActionUnit(26, "jaw drop", "jaw", False, {}, 20.0, JawMotion(10.0, 3.0))
    assert Atlas((), {26: 1.5}).scaled(unit).jaw == JawMotion(15.0, 3.0)
    assert Atlas((), {}).scaled(unit) == unit


def test_an_unknown_face_is_named() -> None:
    with pytest.raises(UnknownNameError, match="nobody"):
        new_project("nobody")


def test_posing_a_project_changes_its_expression_and_nothing_else() -> None:
    project = new_project()
    posed = project.posed({"12L": 0.5})
    assert posed.expression == {"12L": 0.5}
    assert replace(posed, expression={}).face is project.face
    assert project.expression == {}


def test_an_atlas_comes_back_as_it_was_written(tmp_path: Path) -> None:
    atlas = read_atlas(resource("atlas", "ada.json"))
    write_atlas(atlas, "laid by hand", tmp_path / "atlas.json")
    found = read_atlas(tmp_path / "atlas.json")
    assert found.gains == atlas.gains
    assert [muscle.key for muscle in found.muscles] == [muscle.key for muscle in atlas.muscles]
    for one, other in zip(found.muscles, atlas.muscles, strict=True):
        assert (one.width, one.kappa, one.strength, one.count) == (
            other.width,
            other.kappa,
            other.strength,
            other.count,
        )
        for own, theirs in zip(one.fibres, other.fibres, strict=True):
            assert np.array_equal(own.origin, theirs.origin)
            assert np.array_equal(own.attachment, theirs.attachment)


@pytest.mark.parametrize("text", ["", "{", '{"muscles": 3}', '{"provenance": "", "gains": {}, "muscles": [{}]}'])
def test_a_damaged_atlas_says_so(tmp_path: Path, text: str) -> None:
    path = tmp_path / "atlas.json"
    path.write_text(text)
    with pytest.raises(ProjectError, match=r"atlas\.json is damaged; reinstall"):
        read_atlas(path)


def test_a_missing_atlas_says_so(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="cannot be read"):
        read_atlas(tmp_path / "none.json")
