"""Learning anatomy from measured expressions: what is known to be wrong is found, within bounds, and no more."""

from dataclasses import replace

import numpy as np
import pytest

from facemodel.actions import ActionUnit, field_names
from facemodel.anatomy.files import shipped_anatomy
from facemodel.anatomy.recipe import Anatomy
from facemodel.calibration.adjust import ENOUGH, Learned, learned
from facemodel.calibration.forward import Forward, Lender
from facemodel.calibration.goals import Goal, goals, with_mixtures
from facemodel.calibration.knobs import MOST_TURNS, knobs, turned
from facemodel.calibration.report import wanted_fields
from facemodel.calibration.slopes import slopes, small_turns
from facemodel.calibration.trial import Trial
from facemodel.faces import load_face
from facemodel.facs import action_units
from facemodel.solution import Cancelled, silent
from fem.types import FloatArray

HEAD = load_face("ada")

FORETOLD, GRAIN = 0.3, 1e-5
"""Share of a turn's effect by which the slope of tissue, which bends, may miss it; muscles are met but for rounding."""

SMILE = ActionUnit(12, "smile", "diagonal", True, {"zygomaticus_major": 1.0}, 15.0)


def smiling(anatomy: Anatomy) -> Anatomy:
    """Return a recipe of one muscle, in tissue that is the same everywhere."""
    bands = tuple(band for band in anatomy.bands if band.name == "zygomaticus_major")
    return replace(anatomy, bands=bands, rings=(), tissue=replace(anatomy.tissue, regions=()))


OURS = smiling(shipped_anatomy())
KNOBS = [knob.name for knob in knobs(OURS)]


def turned_by(**steps: float) -> Anatomy:
    amounts = np.zeros(len(KNOBS))
    for name, step in steps.items():
        amounts[KNOBS.index(f"zygomaticus_major {name.replace('_', ' ')}")] = step
    return turned(OURS, knobs(OURS), amounts)


@pytest.fixture(scope="module")
def forward() -> Forward:
    return Forward(HEAD, Lender(HEAD))


@pytest.fixture(scope="module")
def measured(forward: Forward) -> FloatArray:
    """Return the smile of somebody whose muscle is wider and begins higher on the cheek bone."""
    return forward.muscle_fields(turned_by(width=1.0, origin_up=1.0))["zygomaticus_major_L"]


@pytest.fixture(scope="module")
def trial(forward: Forward, measured: FloatArray) -> Trial:
    goal = Goal("mouthSmile_L", 12, {"zygomaticus_major": ("zygomaticus_major", "zygomaticus_major_L")}, None, measured)
    return Trial(forward, [goal], [SMILE])


@pytest.fixture(scope="module")
def found(trial: Trial) -> Learned:
    return learned([trial], OURS, silent)


def test_learning_comes_nearer_and_says_by_how_much(found: Learned, trial: Trial) -> None:
    assert found.after > found.before + 0.3 * (1 - found.before)
    assert found.before == pytest.approx(trial.cosines(OURS)[0][0])
    assert found.after == pytest.approx(trial.cosines(found.anatomy)[0][0])


def test_learning_that_is_stopped_keeps_what_it_has(trial: Trial) -> None:
    def stop_in_the_second_round(text: str, _share: float) -> None:
        if "round 2" in text:
            raise Cancelled

    found = learned([trial], OURS, stop_in_the_second_round)
    assert found.stopped
    assert found.turns
    assert found.after > found.before + ENOUGH
    assert found.after == pytest.approx(trial.cosines(found.anatomy)[0][0])


def test_slopes_foretell_what_a_small_turn_does(trial: Trial) -> None:
    told: list[tuple[int, int]] = []
    smalls = small_turns(knobs(OURS), np.zeros(len(KNOBS)))
    (slope,) = slopes(trial, OURS, knobs(OURS), smalls, lambda done, total: told.append((done, total)))
    assert told == sorted(told)
    assert told[-1][0] < told[-1][1] == len(KNOBS)
    here = trial.cosines(OURS)[0][0]
    assert slope.cosine(np.zeros(len(KNOBS)))[0] == pytest.approx(here, abs=GRAIN)
    for number, knob in enumerate(knobs(OURS)):
        turns = np.zeros(len(KNOBS))
        turns[number] = smalls[number]
        true = trial.cosines(turned(OURS, knobs(OURS), turns))[0][0] - here
        off = GRAIN if knob.muscle else FORETOLD * abs(true) + GRAIN
        assert slope.cosine(turns)[0] - here == pytest.approx(true, abs=off), knob.name


def test_no_knob_goes_beyond_its_bounds(found: Learned) -> None:
    assert found.turns
    assert set(found.turns) <= set(KNOBS)
    assert all(0 < abs(step) <= MOST_TURNS for step in found.turns.values())


def test_the_true_muscle_is_met_exactly(trial: Trial) -> None:
    assert trial.cosines(turned_by(width=1.0, origin_up=1.0))[0] == pytest.approx([1.0])


def test_what_was_learned_of_the_mixture_goes_into_the_units(found: Learned) -> None:
    other = replace(SMILE, number=20)
    made = with_mixtures([SMILE, other], found.mixtures)
    assert made[0].muscles == pytest.approx({"zygomaticus_major": 1.0})
    assert made[1] is other


def test_only_what_one_unit_alone_answers_is_learned_from() -> None:
    units = action_units()
    names = ["mouthSmile_L", "mouthPucker", "mouthLeft", "jawOpen", "eyeLookUpLeft"]
    wanted, left_out = wanted_fields(names, field_names(units))
    nothing = np.zeros((3, 3))
    aims = goals(dict.fromkeys(names, nothing), wanted, units)
    assert [aim.name for aim in aims] == ["mouthSmile_L", "mouthPucker", "jawOpen"]
    smiling = ("zygomaticus_major", "nasolabial_fold_superior", "nasolabial_fold_inferior")
    assert aims[0].groups == {name: (name, f"{name}_L") for name in smiling}
    assert aims[2].jaw is not None
    assert set(left_out) == {"eyeLookUpLeft"}
