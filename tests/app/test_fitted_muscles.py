"""Muscles of one head on another: fitted by landmarks, reported, laid in one step and taken back in one."""

from dataclasses import replace

import numpy as np
import pytest

from app.authoring.bare import bare_project
from app.authoring.fitted_muscles import carried_to, with_fitted_muscles
from app.document import Document
from facemodel.errors import MuscleError
from facemodel.laying.collection import deleted, muscle_of
from facemodel.laying.places import kind_of_place
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.sameness import same
from tests.app.desk import do


@pytest.fixture(scope="module")
def ada() -> Project:
    return new_project("ada")


@pytest.fixture(scope="module")
def ben() -> Project:
    return bare_project("ben")


def test_a_bare_head_gets_all_muscles_on_its_own_bone_and_skin(ada: Project, ben: Project) -> None:
    outcome = with_fitted_muscles(ben, ada)
    muscles = outcome.project.muscles
    assert [muscle.key for muscle in muscles] == [muscle.key for muscle in ada.muscles]
    assert outcome.fit.complaints == ()
    for muscle in muscles:
        for fibre, before in zip(muscle.fibres, muscle_of(ada, muscle.key).fibres, strict=True):
            for end in ("origin", "attachment"):
                kind = kind_of_place(ada.face, getattr(before, end))[0]
                assert kind_of_place(ben.face, getattr(fibre, end))[0] == kind


def test_the_report_tells_the_scale_of_the_head_in_each_direction(ada: Project, ben: Project) -> None:
    stretched = np.array([1.2, 1.0, 0.9])
    face, skull = ada.face, ada.face.skull
    wide = replace(
        face,
        skin=replace(face.skin, positions=face.skin.positions * stretched),
        eyes=tuple(replace(eye, centre=eye.centre * stretched) for eye in face.eyes),
        skull=replace(
            skull,
            cranium=replace(skull.cranium, positions=skull.cranium.positions * stretched),
            mandible=replace(skull.mandible, positions=skull.mandible.positions * stretched),
            anchors=skull.anchors * stretched,
        ),
    )
    fit = with_fitted_muscles(replace(ada, face=wide, muscles=()), ada).fit
    assert fit.scale == pytest.approx(stretched, abs=1e-6)
    assert fit.bend < 1e-6
    assert fit.settled < 0.5
    assert fit.sentences[1].startswith("The head is 1.20 times as wide, 1.00 times as high and 0.90 times as deep")


def test_own_muscles_are_replaced_kept_or_taken_out_as_asked(ada: Project) -> None:
    own = with_fitted_muscles(bare_project("ben"), ada).project
    own = deleted(own, ["risorius_L", "risorius_R"]).project
    mine = replace(muscle_of(own, "corrugator_L"), name="mine", width=3.0)
    changed = tuple(replace(each, width=3.0) if each.name == "corrugator" else each for each in own.muscles)
    project = replace(own, muscles=(*changed, mine))
    widths = {}
    for keeping in ("same", "others", "none"):
        after = with_fitted_muscles(project, ada, keeping).project
        names = {muscle.name for muscle in after.muscles}
        assert "risorius" in names
        assert ("mine" in names) == (keeping != "none")
        widths[keeping] = muscle_of(after, "corrugator_L").width
    assert widths["others"] == 3.0
    assert widths["same"] == widths["none"] != 3.0


def test_a_project_goes_to_another_individual_with_all_that_was_made_of_it(ada: Project) -> None:
    project = replace(ada, expression={"12L": 0.5})
    other = new_project("chen")
    outcome = carried_to(project, other)
    assert outcome.project.face is other.face
    assert outcome.project.units == project.units
    assert outcome.project.emotions == project.emotions
    assert outcome.project.expression == {"12L": 0.5}
    assert not same(outcome.project.muscles, other.muscles)


def test_the_menu_takes_muscles_along_in_one_step_and_says_how(ada: Project, context, desk) -> None:
    document: Document = context.document
    document.restore(replace(ada, muscles=ada.muscles[:6], units=()), None)
    before = document.project
    do("face.carry", context)
    do("face.switch.ben", context)
    assert document.project.face.key == "ben"
    assert [muscle.key for muscle in document.project.muscles] == [muscle.key for muscle in before.muscles]
    assert "6 muscles by" in desk.messages[-1]
    document.undo()
    assert document.project.face is before.face
    assert same(document.project.muscles, before.muscles)


def test_a_head_without_landmarks_or_muscles_is_refused_in_a_sentence(ada: Project, project: Project) -> None:
    with pytest.raises(MuscleError, match="set more of them on the new head"):
        with_fitted_muscles(project, ada)
    with pytest.raises(MuscleError, match="has no muscles to fit"):
        with_fitted_muscles(ada, bare_project("ben"))
