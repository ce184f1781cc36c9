"""The models of a muscle side by side: found in the background, shown with figures and pictures, chosen by a click."""

import time
from threading import Event

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from facemodel.laying.collection import muscle_of
from facemodel.model_fields import model_fields
from facemodel.solution import Cancelled
from facemodel.solver import FaceSolver
from ui.panels.muscles.comparison.pictures import PictureAsked, drawn, standpoint
from ui.panels.muscles.comparison.window import ComparisonWindow
from ui.panels.muscles.editing import MuscleEdit
from ui.panels.muscles.identity import MuscleIdentity

KEY = "zygomaticus_major_L"
FRONT = np.array([0.0, 0, 1]), np.array([0.0, 1, 0])


@pytest.fixture
def window(shown, context) -> ComparisonWindow:
    context.view.change(workspace="muscles", muscle=KEY)
    parent = shown(QWidget())
    window = ComparisonWindow(parent, context, lambda: FRONT)
    identity = MuscleIdentity(MuscleEdit(context, lambda: None))
    identity.setParent(parent)
    window.chosen.connect(identity.take_model)
    yield window
    window.close()


def settled(window: ComparisonWindow) -> bool:
    return window.again.isVisible() and not window.job.running and not window.drawing.running


def open_(window: ComparisonWindow, qtbot) -> None:
    window.show()
    qtbot.waitUntil(lambda: settled(window))


def test_every_model_of_fibres_has_a_card_with_figures_and_a_picture(window, qtbot):
    open_(window, qtbot)
    assert list(window.cards) == ["fibre", "quadrilateral", "cosine"]
    assert [card.isChecked() for card in window.cards.values()] == [True, False, False]
    assert all(card.has_picture for card in window.cards.values())
    assert all("mm at most" in card.figures[0] for card in window.cards.values())
    assert window.cards["fibre"].figures[1] == "in use"
    assert window.cards["cosine"].figures[1].startswith("cosine ")
    assert (window.legend.legend.unit, window.legend.legend.low) == ("mm", 0.0)


def test_a_click_uses_a_model_in_one_step_and_undo_shows_the_old_one(window, context, qtbot):
    open_(window, qtbot)
    QTest.mouseClick(window.cards["quadrilateral"], Qt.MouseButton.LeftButton)
    assert muscle_of(context.document.project, KEY).model == "quadrilateral"
    assert context.document.history.done == ("Quadrilateral sheet for Zygomaticus major",)
    qtbot.waitUntil(lambda: window.cards["quadrilateral"].figures[1] == "in use")
    context.document.undo()
    qtbot.waitUntil(lambda: window.cards["fibre"].isChecked() and settled(window))


def test_the_window_stays_alive_and_cancel_stops_the_solver(window, qtbot):
    begun, told = Event(), []
    inner = window.job._work

    def slow(asked, progress):
        begun.set()
        try:
            for _ in range(10_000):
                progress("Step", 0.1)
                time.sleep(0.001)
                told.append(1)
        except Cancelled:
            told.append("cancelled")
            raise
        return inner(asked, progress)

    window.job._work = slow
    window.show()
    qtbot.waitUntil(begun.is_set)
    QTest.mouseClick(window.stop, Qt.MouseButton.LeftButton)
    assert "Cancelled" in window.words.text()
    qtbot.waitUntil(lambda: bool(told) and told[-1] == "cancelled")
    assert not any(card.has_picture for card in window.cards.values())


def test_without_a_muscle_it_says_so(window, context, qtbot):
    context.view.change(muscle="")
    window.show()
    assert window.words.text() == "No muscle is selected; click one to compare its models."
    assert window.cards == {}


def test_the_field_in_use_is_the_one_that_the_face_is_solved_with(context):
    context.solving.solve()
    project = context.document.project
    fields = model_fields(project, muscle_of(project, KEY))
    own = fields.fields["fibre"]
    # Action unit 12 contracts this muscle alone, and fully.
    assert np.allclose(own.displacement, context.document.solution.basis.field("12L"), atol=1e-5)
    assert own.cosine == pytest.approx(1.0)
    assert own.largest == pytest.approx(np.linalg.norm(own.displacement, axis=1).max())


def test_pictures_have_one_scale_and_show_what_moves_most_in_its_colour(context):
    project = context.document.project
    fields = model_fields(project, muscle_of(project, KEY), FaceSolver())
    at = standpoint(fields, *FRONT, 1.0)
    moved = {}
    for model in fields.fields:
        picture = drawn(PictureAsked(project.face, fields, model, at, (60, 60)), lambda *_: None).astype(int)
        assert picture.shape == (60, 60, 4)
        skin = picture[picture[..., 3] == 255]
        moved[model] = float((skin[:, 0] - skin[:, 2]).max())
    # Cividis ends in yellow, which is red without blue: only the model that moves most reaches it.
    most = max(fields.fields, key=lambda model: fields.fields[model].largest)
    assert max(moved, key=lambda model: moved[model]) == most
