"""Cross-checks: what is told of an expression was not learned from it."""

from dataclasses import replace

import numpy as np
import pytest

from facemodel.actions import ActionUnit
from facemodel.anatomy.files import shipped_anatomy
from facemodel.anatomy.recipe import Anatomy
from facemodel.calibration.adjust import Change
from facemodel.calibration.forward import Forward, Lender
from facemodel.calibration.goals import Goal
from facemodel.calibration.hold_out import FOLDS, HeldOut, parted
from facemodel.calibration.learned_report import held_out_json, held_out_text
from facemodel.calibration.trial import Trial
from facemodel.faces import load_face

HEAD = load_face("ada")
NUMBERS = (12, 15, 1, 4)
BANDS = {12: "zygomaticus_major", 15: "depressor_anguli_oris", 1: "frontalis_medialis", 4: "corrugator"}
UNITS = tuple(ActionUnit(n, BANDS[n], "diagonal", True, {BANDS[n]: 1.0}, 5.0) for n in NUMBERS)


def of_four_muscles() -> Anatomy:
    """Return the recipe of four muscles in tissue that is the same everywhere."""
    anatomy = shipped_anatomy()
    bands = tuple(band for band in anatomy.bands if band.name in BANDS.values())
    return replace(anatomy, bands=bands, rings=(), tissue=replace(anatomy.tissue, regions=()))


@pytest.fixture(scope="module")
def trial() -> Trial:
    """Return a face on which four muscles were measured that lie where ours do, each on both sides."""
    forward = Forward(HEAD, Lender(HEAD))
    fields = forward.muscle_fields(of_four_muscles())
    aims = [
        Goal(f"{BANDS[n]}_{side}", n, {BANDS[n]: (f"{BANDS[n]}_{side}",)}, None, fields[f"{BANDS[n]}_{side}"])
        for n in NUMBERS
        for side in "LR"
    ]
    return Trial(forward, aims, UNITS)


def test_every_action_unit_is_left_out_once_with_both_its_sides(trial: Trial) -> None:
    out = []
    for fold in range(FOLDS):
        kept, left_out = parted(trial, fold)
        assert not {aim.unit for aim in kept.aims} & {aim.unit for aim in left_out.aims}
        assert len(kept.aims) + len(left_out.aims) == len(trial.aims)
        out += [aim.name for aim in left_out.aims]
    assert sorted(out) == sorted(aim.name for aim in trial.aims)


def test_a_known_mixture_is_told_as_it_is_and_not_as_it_would_serve_best(trial: Trial) -> None:
    smile = trial.only(lambda aim: aim.name == "zygomaticus_major_L")
    groups = {each: (f"{each}_L",) for each in ("zygomaticus_major", "depressor_anguli_oris")}
    both = Trial(trial.forward, [replace(smile.aims[0], groups=groups)], _pulling_both_ways())
    assert both.cosines(of_four_muscles())[0] == pytest.approx([1.0])
    fields = trial.forward.muscle_fields(of_four_muscles())
    smiling, whole = (
        trial.weighted(np.sum([fields[f"{each}_L"] for each in own], axis=0))
        for own in (["zygomaticus_major"], list(groups))
    )
    angle = smiling @ whole / (np.linalg.norm(smiling) * np.linalg.norm(whole))
    assert both.contracted(of_four_muscles(), _pulling_both_ways()) == pytest.approx([angle])
    assert angle < 0.98


def _pulling_both_ways() -> tuple[ActionUnit, ...]:
    return (replace(UNITS[0], muscles={"zygomaticus_major": 1.0, "depressor_anguli_oris": 1.0}),)


def test_the_report_says_what_was_learned_from_and_what_it_is_told_on() -> None:
    check = HeldOut("smiles", "frowns", (Change("mouthFrown_L", 0.80, 0.85), Change("mouthFrown_R", 0.70, 0.71)))
    (entry,) = held_out_json([check])
    assert (entry["learned_from"], entry["told_on"]) == ("smiles", "frowns")
    assert entry["mean_cosine_before"] == pytest.approx(0.75)
    assert entry["mean_cosine_after"] == pytest.approx(np.mean([0.85, 0.71]))
    assert entry["expressions"][0] == {"name": "mouthFrown_L", "before": 0.80, "after": 0.85}
    said = held_out_text([check])
    assert "learned from smiles, told on frowns" in said
    assert "+0.050" in said
    assert "+0.030" in said
