"""A hand on the panel, and what the face does."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMessageBox

from tests.ui.hands import drag, move
from tests.ui.window.seen import differs, picture, points

Button = QMessageBox.StandardButton
CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
SMILE = 12


def test_a_drag_moves_skin_and_picture_and_is_one_step(window, document):
    rest, before = points(window), picture(window)
    drag(window.expression.rows[SMILE].slider, 0.1, 0.9)
    moved = points(window)
    assert np.linalg.norm(moved - rest, axis=1).max() > 5.0
    assert differs(picture(window), before)
    assert document.shown["12L"] == document.shown["12R"] == pytest.approx(0.8, abs=0.02)
    assert document.history.done == ("Lip corner puller",)

    QTest.keyClick(window, Qt.Key.Key_Z, CTRL)
    assert np.allclose(points(window), rest, atol=1e-4)
    assert not differs(picture(window), before)
    QTest.keyClick(window, Qt.Key.Key_Z, CTRL | SHIFT)
    assert np.allclose(points(window), moved, atol=1e-4)


def test_escape_in_a_drag_restores_the_face(window, document):
    rest = points(window)
    slider = window.expression.rows[SMILE].slider
    drag(slider, 0.1, 0.9, release=False)
    assert np.abs(points(window) - rest).max() > 5.0
    QTest.keyClick(slider, Qt.Key.Key_Escape)
    assert np.allclose(points(window), rest, atol=1e-4)
    assert document.history.done == ()


@pytest.mark.parametrize("steps", [0, 1])
@pytest.mark.parametrize("modifiers", [CTRL, CTRL | SHIFT], ids=["undo", "redo"])
def test_undo_and_redo_in_a_drag_restore_the_face_and_end_the_drag(window, document, modifiers, steps):
    if steps:
        document.set_weights({"17": 0.3})
    slider, before, done = window.expression.rows[SMILE].slider, document.shown, document.history.done
    drag(slider, 0.1, 0.6, release=False)
    assert document.shown != before
    QTest.keyClick(slider, Qt.Key.Key_Z, modifiers)
    assert (document.shown, document.history.done, slider.weight) == (before, done, 0.0)
    move(slider, QPoint(round(0.9 * slider.width()), slider.height() // 2))
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton)
    assert (document.shown, document.history.done, slider.weight) == (before, done, 0.0)
    drag(slider, 0.1, 0.6)
    assert len(document.history.done) == steps + 1
    QTest.keyClick(slider, Qt.Key.Key_Z, CTRL)
    assert document.shown == before


def test_many_moves_are_few_frames(window):
    canvas = window.viewport.canvas
    picture(window)
    before = canvas.frames
    drag(window.expression.rows[SMILE].slider, 0.1, 0.9, steps=200)
    QTest.qWait(100)
    assert 1 <= canvas.frames - before < 50


def test_a_click_on_an_emotion_shows_it(window, document):
    rest = points(window)
    QTest.mouseClick(window.expression.emotions.buttons["surprise"], Qt.MouseButton.LeftButton)
    assert document.shown["26"] == 1.0
    assert np.abs(points(window) - rest).max() > 5.0


def test_one_side_moves_alone(window, project):
    rest = points(window)
    row = window.expression.rows[SMILE]
    QTest.mouseClick(row.split, Qt.MouseButton.LeftButton)
    drag(row.sides[0], 0.05, 0.95)
    moved = np.linalg.norm(points(window) - rest, axis=1)
    left = rest[:, 0] > 10
    assert moved[left].max() > 5 * moved[rest[:, 0] < -10].max()


def test_the_exaggeration_reaches_the_skin(window, document):
    rest = points(window)
    document.set_weights({"12": 1.0})
    full = np.linalg.norm(points(window) - rest, axis=1).max()
    drag(window.expression.rows[SMILE].slider, 0.0, 0.6, CTRL)
    assert np.linalg.norm(points(window) - rest, axis=1).max() > 1.3 * full


def test_closing_the_window_in_a_drag_asks_nothing_and_keeps_nothing(window, document):
    slider = window.expression.rows[SMILE].slider
    drag(slider, 0.1, 0.6, release=False)
    assert window.close()
    move(slider, QPoint(round(0.9 * slider.width()), slider.height() // 2))
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton)
    assert document.shown == {}
    assert document.history.done == ()
