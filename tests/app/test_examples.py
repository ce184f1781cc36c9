"""Examples open finished: they move, belong to a whole face, and can be saved and opened again."""

from pathlib import Path

import numpy as np
import pytest

from app.actions import Context
from app.examples import EXAMPLES, find_example
from app.examples.smile import SCAR
from app.speech import espeak_program
from facemodel.animation.evaluation import Evaluator, sampled
from facemodel.animation.sound import voiced_span
from facemodel.errors import UnknownNameError
from facemodel.io.audio import read_sound
from facemodel.io.project_file import project_bytes, project_of
from facemodel.painting.layers import LAYER
from facemodel.projects import new_project
from tests.app.desk import Desk, do
from tests.io.small_project import identical

KEYS = [example.key for example in EXAMPLES]


@pytest.fixture
def silent(monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine without a voice."""
    monkeypatch.setenv("PATH", "")


@pytest.mark.parametrize("key", KEYS)
def test_an_example_moves_and_is_a_project_like_any_other(key: str, tmp_path: Path, silent: None) -> None:
    project = find_example(key).made(tmp_path)
    assert identical(project_of(project_bytes(project)), project)
    clip = sampled(project.animation, project.units, 30.0)
    fields = {name for unit in project.units for name in unit.fields}
    weights = clip.values[:, [name in fields for name in clip.channels]]
    assert weights.max() > 0.6
    assert 2.0 < project.animation.duration <= 20.0
    assert project.animation.audio is None


def test_the_painted_cheek_is_stiff_and_the_other_is_not() -> None:
    face, plain = find_example("smile").made(Path()).face, new_project().face
    stiffness = LAYER["stiffness"].values(face) / LAYER["stiffness"].values(plain)
    middle = face.landmarks[SCAR[1]]
    assert stiffness[middle] > 2
    assert stiffness[face.mirror[middle]] == 1
    assert LAYER["stretching-along"].values(face)[middle] == pytest.approx(1.2)


def test_smiles_with_the_eyes_come_slowly_and_one_comes_one_side_first() -> None:
    project = find_example("timing").made(Path())
    evaluator = Evaluator(project.animation, project.units)
    polite, warm, mocking = (part for part in project.animation.ranges)

    def at(moment: float) -> dict[str, float]:
        return evaluator.pose(moment).weights

    assert at(polite.start + 0.4)["12L"] > at(warm.start + 0.4)["12L"]
    assert at(warm.start + 1.2)["6L"] > 0.5
    assert at(polite.start + 1.0)["6L"] == 0
    assert at(mocking.start + 0.3)["12R"] > at(mocking.start + 0.3)["12L"] + 0.2
    assert [marker.name.partition(":")[0] for marker in project.animation.markers] == ["Polite", "Warm", "Mocking"]


@pytest.mark.skipif(espeak_program() is None, reason="eSpeak NG is not installed")
def test_lips_move_while_the_voice_is_heard(tmp_path: Path) -> None:
    animation = find_example("line").made(tmp_path).animation
    assert animation.audio is not None
    begin, end = voiced_span(read_sound(Path(animation.audio.path)))
    sounds = animation.speech.phonemes
    assert sounds[0].start == pytest.approx(animation.audio.start + begin, abs=0.01)
    assert sounds[-1].end == pytest.approx(animation.audio.start + end, abs=0.01)
    assert len(animation.speech.words) in (0, 16)


def test_lips_meet_for_every_closed_sound_of_the_line(silent: None, tmp_path: Path) -> None:
    project = find_example("line").made(tmp_path)
    evaluator = Evaluator(project.animation, project.units)
    for sound in project.animation.speech.phonemes:
        if sound.symbol in ("P", "B", "M"):
            middle = np.array([(sound.start + sound.end) / 2])
            weights = dict(zip(evaluator.channels, evaluator.at(middle)[0], strict=True))
            assert weights["26"] < 0.02
            assert weights["25"] < 0.02


def test_opening_an_example_asks_about_unsaved_work_first(context: Context, desk: Desk) -> None:
    context.document.set_weights({"17": 0.5})
    do("file.example.timing", context)
    assert context.document.project.face.key == "patch"
    desk.answer = "discard"
    do("file.example.timing", context)
    assert context.document.project.face.key == "ada"
    assert context.document.path is None
    assert not context.document.dirty
    assert context.document.history.to_undo is None
    assert desk.messages == [find_example("timing").hint]
    assert desk.calls.count("perform") == 1


def test_an_example_that_is_not_there_is_named_with_those_that_are() -> None:
    with pytest.raises(UnknownNameError, match="no example “frown”; choose one of demo, smile, line, timing"):
        find_example("frown")
