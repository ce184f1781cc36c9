"""The muscles of a project: names that are unique, units that keep their muscles, nothing lost."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.errors import MuscleError, UnknownNameError
from facemodel.io.project_file import project_bytes, project_of
from facemodel.laying.collection import (
    added,
    deleted,
    duplicated,
    muscle_of,
    new_muscle,
    on_other_side,
    renamed,
    users_of,
    with_muscle,
)
from facemodel.laying.fibres import laid_fibre
from facemodel.laying.names import checked_name, name_from, unique_name
from facemodel.laying.rings import laid_ring
from facemodel.project import Project
from tests.facemodel.skin import by
from tests.io.small_project import identical

words = st.text("abcdefgh_23", min_size=1, max_size=6)


@given(words, st.sets(words, max_size=30))
def test_a_unique_name_is_not_taken_and_the_wanted_one_if_it_is_free(wanted: str, taken: set[str]) -> None:
    name = unique_name(wanted, taken)
    assert name not in taken
    assert (name == wanted) == (wanted not in taken)
    assert unique_name(name, taken) == name


@given(st.text(max_size=200))
def test_any_title_makes_a_name(title: str) -> None:
    name = name_from(title)
    assert checked_name(name, ()) == name or name.endswith(("_l", "_r", "_m"))


def test_names_of_titles_are_readable() -> None:
    assert name_from("Zygomaticus major") == "zygomaticus_major"
    assert name_from("Orbicularis oculi, pars orbitalis (oberer Teil) · ä") == (
        "orbicularis_oculi_pars_orbitalis_oberer_teil_a"
    )
    assert name_from("…") == "muscle"


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("", "cannot name a muscle"),
        ("zygo maticus", "cannot name a muscle; .*“zygo_maticus”"),
        ("x" * 101, "up to 100"),
        ("smile_L", "leave “_L” out"),
        ("risorius", "There is a muscle “risorius” already"),
    ],
)
def test_a_name_that_cannot_be_is_refused_with_a_reason(project: Project, name: str, says: str) -> None:
    with pytest.raises(MuscleError, match=says):
        renamed(project, "procerus", name)


def test_a_renamed_muscle_keeps_its_sides_and_its_units_and_can_be_renamed_back(project: Project) -> None:
    there = renamed(project, "zygomaticus_major", "smiler")
    assert {m.key for m in there.muscles} - {m.key for m in project.muscles} == {"smiler_L", "smiler_R"}
    assert users_of(there, "smiler") == users_of(project, "zygomaticus_major") == (12,)
    assert identical(renamed(there, "smiler", "zygomaticus_major"), project)
    assert identical(renamed(project, "risorius", "risorius"), project)
    with pytest.raises(UnknownNameError, match="no muscle “smiler”"):
        renamed(project, "smiler", "other")


def test_deleting_both_sides_tells_who_used_the_muscle(project: Project) -> None:
    gone = deleted(project, {"zygomaticus_major_L", "zygomaticus_major_R", "procerus"})
    assert gone.users == {"procerus": users_of(project, "procerus"), "zygomaticus_major": (12,)}
    assert 4 in gone.users["procerus"]
    assert len(gone.project.muscles) == len(project.muscles) - 3
    assert all("procerus" not in unit.muscles for unit in gone.project.units)
    users, kept = ({unit.number: unit for unit in each.units} for each in (project, gone.project))
    assert kept[4].muscles.keys() == users[4].muscles.keys() - {"procerus"}
    assert project_of(project_bytes(gone.project)).muscles, "what is left can be saved and opened"


def test_deleting_one_side_leaves_the_other_with_its_units(project: Project) -> None:
    gone = deleted(project, ["risorius_L"])
    assert gone.users == {}
    assert users_of(gone.project, "risorius") == users_of(project, "risorius")
    assert identical(gone.project.units, project.units)
    with pytest.raises(UnknownNameError, match="no muscle “risorius_X”"):
        deleted(project, ["risorius_X"])


def test_a_duplicate_lies_where_the_muscle_lies_under_names_of_its_own(project: Project) -> None:
    more, keys = duplicated(project, ["risorius_L", "risorius_R", "procerus"])
    assert keys == ("risorius_2_L", "risorius_2_R", "procerus_2")
    again, keys = duplicated(more, ["risorius_2_L"])
    assert keys == ("risorius_3_L",)
    copy, first = muscle_of(again, "risorius_3_L"), muscle_of(project, "risorius_L")
    assert identical(replace(copy, name="risorius"), first)
    assert identical(again.muscles[: len(project.muscles)], project.muscles)


@given(st.lists(st.integers(0, 44), max_size=12))
def test_whatever_is_added_all_keys_stay_unique(project: Project, picked: list[int]) -> None:
    muscles = [project.muscles[k % len(project.muscles)] for k in dict.fromkeys(picked)]
    more, keys = added(project, muscles)
    assert len({muscle.key for muscle in more.muscles}) == len(more.muscles)
    assert [muscle.key for muscle in more.muscles[len(project.muscles) :]] == list(keys)


def test_a_new_muscle_from_bare_hands(project: Project) -> None:
    face = project.face
    bare = replace(project, muscles=(), units=())
    cheek, corner = (face.skin.positions[face.landmarks[name]] for name in ("cheek_L", "mouth_corner_L"))
    muscle = new_muscle(bare, "Zygomaticus major", "cheek", fibres=(laid_fibre(face, cheek, corner),))
    assert (muscle.key, muscle.model, muscle.count) == ("zygomaticus_major_L", "fibre", 50)
    laid = with_muscle(bare, muscle)
    both, keys = on_other_side(laid, [muscle.key])
    assert keys == ("zygomaticus_major_R",)
    right = muscle_of(both, keys[0])
    assert right.fibres[0].attachment == pytest.approx(face.skin.positions[face.landmarks["mouth_corner_R"]])
    same, _ = on_other_side(both, [muscle.key])
    assert len(same.muscles) == 2, "what is there already is replaced"
    second = new_muscle(both, "Zygomaticus major", "cheek", fibres=(laid_fibre(face, cheek * [-1, 1, 1], corner),))
    assert second.name == "zygomaticus_major_2"


def test_a_new_sphincter_lies_across_the_midline(project: Project) -> None:
    face = project.face
    lips = face.skin.positions[face.landmarks["upper_vermilion"]]
    ring = laid_ring(face, lips, lips + by(22.0, 0, -10.0), 9.0)
    muscle = new_muscle(project, "Orbicularis oris", "lip", ring=ring)
    assert (muscle.key, muscle.model, muscle.side) == ("orbicularis_oris", "sphincter", "M")
    with pytest.raises(MuscleError, match="lies across the midline"):
        on_other_side(with_muscle(project, muscle), ["orbicularis_oris"])


def test_a_muscle_that_cannot_be_used_is_not_taken(project: Project) -> None:
    point = project.face.skin.positions[project.face.landmarks["cheek_L"]]
    flat = replace(muscle_of(project, "risorius_L"), fibres=(laid_fibre(project.face, point, point, bone="free"),))
    with pytest.raises(MuscleError, match="begins and ends at one point"):
        with_muscle(project, flat)
