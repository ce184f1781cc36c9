"""Sculpting, blending and carrying expressions by script: the same steps that the mouse makes."""

from dataclasses import replace

import numpy as np
import pytest

from app.document import Document
from app.scripting import run_script
from facemodel.actions import JawMotion
from facemodel.project import Project
from facemodel.solve import solve_project


@pytest.fixture
def solved(document: Document, project: Project) -> Document:
    document.accept(solve_project(project), project)
    return document


def ran(document: Document, text: str) -> str:
    outcome = run_script(text, document)
    assert outcome.error == ""
    return outcome.output.strip()


def test_a_script_pulls_skin_in_one_step(solved: Document) -> None:
    said = ran(solved, "au(17).sculpt.pull((0, 0, 20), (0, 0, 3), radius=25)\nprint(round(au(17).sculpt.largest, 1))")
    assert 2.9 < float(said) < 3.6
    assert list(solved.project.corrections) == ["17"]
    assert len(solved.history.done) == 1
    solved.undo()
    assert solved.project.corrections == {}


def test_a_script_raises_both_sides_weighs_mirrors_copies_and_clears(solved: Document) -> None:
    ran(solved, "au(12).sculpt.stroke('raise', (25, 0, 16), (25, 10, 16), radius=15, mirror=True)")
    left, right = (solved.project.corrections[name].everywhere(81) for name in ("12L", "12R"))
    np.testing.assert_allclose(right, left[solved.project.face.mirror] * [-1, 1, 1], atol=1e-5)
    ran(solved, "s = au(12).sculpt\ns.amount = 0.25\ns.on = False\nprint(s)")
    assert solved.project.corrections["12L"].share == 0
    ran(solved, "au(12).sculpt.copy_to(20)\nau(12).sculpt.clear()")
    assert set(solved.project.corrections) == {"20L", "20R"}
    ran(solved, "au(20).mirror()\nau(20).sculpt.mirror('R')")
    assert set(solved.project.corrections) == {"20L", "20R"}


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("au(17).sculpt.clear()", "Nothing is sculpted"),
        ("au(17).sculpt.pull((0, 0, 20), (1, 2))", "three numbers"),
        ("au(17).sculpt.stroke('pull', (0, 0, 20))", "needs a way"),
        ("au(17).sculpt.stroke('melt', (0, 0, 20))", "melt"),
        ("au(17).sculpt.stroke('raise', 'nowhere')", "nowhere"),
    ],
)
def test_what_cannot_be_sculpted_is_told_in_a_sentence(solved: Document, line: str, why: str) -> None:
    outcome = run_script(line, solved)
    assert why in outcome.error
    assert solved.project.corrections == {}


def test_before_the_face_is_solved_no_script_sculpts(document: Document) -> None:
    assert "not solved" in run_script("au(17).sculpt.stroke('raise', (0, 0, 20))", document).error


def test_a_script_lays_expressions_on_the_pad_and_blends(document: Document) -> None:
    ran(document, "place_expression('happiness', (0.1, 0.9))\nblend_at(0.1, 0.9)")
    assert document.shown == {"12L": 0.9, "12R": 0.9}
    assert document.project.emotions[0].place == (0.1, 0.9)
    ran(document, "place_expression('happiness', None)")
    assert "No expression" in run_script("blend_at(0.5, 0.5)", document).error


def test_a_script_carries_expressions_to_another_project(document: Document, project: Project) -> None:
    text = ran(document, "print(copy_expressions('happiness'))")
    assert text == "happiness: 12=0.9"
    other = Document(replace(project, emotions=()))
    assert ran(other, f"print(paste_expressions({text!r}))") == "('happiness',)"
    assert dict(other.project.emotions[0].weights) == {"12": 0.9}


def test_a_script_shifts_the_jaw_and_checks_the_superposition(solved: Document) -> None:
    ran(solved, "au(26).move_jaw(10, 1, -4)")
    assert solved.project.units[-1].jaw == JawMotion(10.0, 1.0, -4.0)
    solved.undo()
    largest, rms = eval_pair(ran(solved, "au(26).weight = 0.5\nprint(check_superposition())"))
    # The skin follows the arc of the jaw, and nothing touches.
    assert 0 < rms <= largest < 1e-4


def eval_pair(text: str) -> tuple[float, float]:
    """Return two numbers that were printed as a tuple."""
    one, other = (float(part.strip("() ")) for part in text.split(","))
    return one, other
