"""What is wrong with a muscle is said in one sentence; what is right is let through."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.atlas import read_atlas
from facemodel.errors import MuscleError
from facemodel.face import Face
from facemodel.faces import face_keys
from facemodel.laying.checks import checked, complaints
from facemodel.laying.fibres import bent, with_end
from facemodel.laying.values import changed, grouped, parameter_of, reset, titled, values, with_model
from facemodel.muscles import Fibre, Muscle, Profile, Sphincter
from facemodel.muscles.models import MODELS
from facemodel.muscles.parameters import Parameter
from facemodel.project import Project
from resources import resource
from tests.facemodel.skin import by


def named(project: Project, key: str) -> Muscle:
    return next(muscle for muscle in project.muscles if muscle.key == key)


@pytest.mark.parametrize("key", face_keys())
def test_nothing_is_wrong_with_any_shipped_muscle(key: str, shipped: Callable[[str], Face]) -> None:
    face = shipped(key)
    for muscle in read_atlas(resource("atlas", f"{key}.json")).muscles:
        assert complaints(muscle, face) == (), muscle.key
        assert checked(muscle, face) is muscle


def fibred(project: Project) -> Muscle:
    return named(project, "risorius_L")


def ringed(project: Project) -> Muscle:
    return named(project, "orbicularis_oculi_orbitalis_L")


def end_of(muscle: Muscle) -> np.ndarray:
    return muscle.fibres[0].attachment


WRONG: list[tuple[Callable[[Project], Muscle], str]] = [
    (lambda p: replace(fibred(p), fibres=()), "“risorius_L” has no fibre; draw one"),
    (lambda p: with_end(fibred(p), 1, "origin", fibred(p).fibres[1].attachment), "^Fibre 2 of .* at one point; drag"),
    (lambda p: with_end(fibred(p), 0, "origin", by(0, 0, np.nan)), "^Fibre 1 of .* an end that is nowhere"),
    (lambda p: with_end(fibred(p), 0, "origin", by(150, 0, 0)), "^Fibre 1 .* its origin outside the head; drag it in"),
    (lambda p: with_end(fibred(p), 1, "attachment", end_of(fibred(p)) + by(9, 0, 20)), "its attachment outside"),
    (lambda p: bent(fibred(p), 0, by(40, 0, 200))[0], "a point between its ends outside the head"),
    (lambda p: bent(bent(fibred(p), 0, by(40, -30, 10))[0], 0, by(40, -30, 10))[0], "two points at one place"),
    (lambda p: replace(fibred(p), width=0.0), "“Width” of “risorius_L” is 0 mm; it has to be between 1 and 60 mm"),
    (lambda p: replace(fibred(p), strength=-1.0), "“Strength” .* is -1 N/mm²"),
    (lambda p: replace(fibred(p), kappa=float("nan")), "near the attachment” .* is nan; it has to be between"),
    (lambda p: replace(fibred(p), model="mouth"), "has no ring; draw an ellipse"),
    (lambda p: replace(ringed(p), model="fibre"), "has no fibre; draw one"),
    (lambda p: reshaped(ringed(p), short_axis=by(0, 0.1, 0)), "has no width; drag its half axes to 0.5 mm"),
    (lambda p: reshaped(ringed(p), short_axis=by(9, 9, 0)), "are not at a right angle; drag one"),
    (lambda p: reshaped(ringed(p), centre=by(0, 0, 300)), "lies away from the skin; drag its middle"),
    (lambda p: reshaped(ringed(p), centre=by(0, np.inf, 0)), "is nowhere; draw it anew"),
    (lambda p: reshaped(ringed(p), focus=2.0), "“Line of closure” .* is 2; it has to be between 0 and 1"),
    (lambda p: replace(fibred(p), fibres=(Fibre(by(0, 20, -40), by(0, 40, -40)),), width=1.0), "reaches no vertex"),
]


def reshaped(muscle: Muscle, **ring: object) -> Muscle:
    assert isinstance(muscle.ring, Sphincter)
    return replace(muscle, ring=replace(muscle.ring, **ring))  # type: ignore[arg-type]


@pytest.mark.parametrize(("make", "says"), WRONG)
def test_what_is_wrong_is_said(project: Project, make: Callable[[Project], Muscle], says: str) -> None:
    with pytest.raises(MuscleError, match=says):
        checked(make(project), project.face)


@pytest.mark.parametrize(
    ("sigma", "says"),
    [
        (Profile((0.0,), (0.0,)), "two knots or more"),
        (Profile((0.0, 1.0, 1.0), (0.0, 1.0, 0.0)), "two knots or more, from 0 outward"),
        (Profile((0.0, 9.0), (1.0, 0.0)), "reaches beyond 3 half axes"),
        (Profile((0.0, 1.0), (2.0, 0.0)), "a value outside -1 to 1"),
        (Profile((0.0, 1.0), (0.0, 1.0)), "does not end at zero"),
    ],
)
def test_a_profile_that_would_tear_the_skin_is_refused(project: Project, sigma: Profile, says: str) -> None:
    muscle = with_model(named(project, "orbicularis_oris_marginal"), "mouth")
    with pytest.raises(MuscleError, match=f"inward profile σ of “orbicularis_oris_marginal” .*{says}|{says}"):
        changed(muscle, "profiles.sigma", sigma)


@given(st.data())
def test_a_value_in_its_range_is_taken_and_one_outside_is_not(project: Project, data: st.DataObject) -> None:
    model = data.draw(st.sampled_from([name for name in MODELS if name != "jaw"]))
    key = "risorius_L" if MODELS[model].geometry == "fibres" else "orbicularis_oculi_orbitalis_L"
    muscle = with_model(named(project, key), model)
    numbers = [p for p in MODELS[model].parameters if isinstance(p, Parameter)]
    parameter = data.draw(st.sampled_from(numbers))
    value = data.draw(st.floats(parameter.least, parameter.most))
    after = changed(muscle, parameter.name, value)
    assert values(after)[parameter.name] == (round(value) if parameter.whole else value)
    others = {name: each for name, each in values(after).items() if name != parameter.name}
    if not parameter.name.startswith("width"):
        assert others == {name: each for name, each in values(muscle).items() if name != parameter.name}
    assert values(reset(after, parameter.name))[parameter.name] == parameter.default
    beyond = data.draw(st.sampled_from([parameter.least - 1, parameter.most + 1, np.nan, np.inf]))
    with pytest.raises(MuscleError, match="it has to be between"):
        changed(muscle, parameter.name, beyond)


def test_a_parameter_of_another_model_is_not_known(project: Project) -> None:
    muscle = fibred(project)
    with pytest.raises(MuscleError, match=r"\(Fibres\) has no parameter “ring.focus”; it has width, kappa, strength"):
        changed(muscle, "ring.focus", 0.5)
    with pytest.raises(MuscleError, match="is a number; give it one"):
        changed(muscle, "width", Profile((0.0, 1.0), (1.0, 0.0)))
    assert parameter_of(muscle, "width").default == 10.0


def test_another_model_keeps_the_values_for_the_way_back(project: Project) -> None:
    muscle = changed(fibred(project), "kappa", 2.5)
    there = with_model(muscle, "quadrilateral")
    assert values(there).keys() == {"width", "strength"}
    assert values(with_model(there, "fibre")) == values(muscle)
    with pytest.raises(MuscleError, match=r"has no ring.*can be: fibres, quadrilateral sheet, cosine pseudo-muscle"):
        with_model(muscle, "mouth")


def test_titles_and_groups(project: Project) -> None:
    assert titled(fibred(project), "  Risorius Santorini ").title == "Risorius Santorini"
    with pytest.raises(MuscleError, match="needs a title"):
        titled(fibred(project), "  ")
    assert grouped(fibred(project), "lip").group == "lip"
    with pytest.raises(MuscleError, match="no group “ear” of muscles; choose one of brow"):
        grouped(fibred(project), "ear")
