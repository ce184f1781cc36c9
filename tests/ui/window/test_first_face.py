"""A person begins from a bare head and, with the mouse alone, makes it smile, raise its brows and open its jaw."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog

from app.solving import EditingSolve
from docs.first_face import Hand, walk
from facemodel.superposition import Superposition
from tests.ui.window.seen import differs, picture
from ui.window.main_window import MainWindow

HAPPENS = 3.0
"""Millimetres that nobody overlooks."""


@pytest.fixture
def walked(open_window, document, tmp_path, monkeypatch) -> MainWindow:
    """The editor after the walk, saved and opened again."""
    path = tmp_path / "first.risorius"
    window = open_window(document, EditingSolve())
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    hand = Hand(window)
    walk(hand)
    QTest.keyClick(window, Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    hand.wait(path.exists)
    made, seen = document.project, picture(window)
    hand.choose("File", "New", "Ben")
    hand.solved()
    QTest.keyClick(window, Qt.Key.Key_O, Qt.KeyboardModifier.ControlModifier)
    hand.solved()
    assert document.project.expression == made.expression
    assert not differs(picture(window), seen)
    return window


def test_a_bare_head_learns_to_smile_to_raise_its_brows_and_to_open_its_jaw(walked, document):
    posed = Superposition(document.project.face, document.solution.basis)
    rest = posed.points.copy()

    def moved(*units: str) -> np.ndarray:
        posed.pose(dict.fromkeys(units, 1.0))
        return posed.points - rest

    def at(x: float, y: float) -> int:
        in_front = np.where(rest[:, 2] > 0, 0.0, 1000.0)
        return int((np.hypot(rest[:, 0] - x, rest[:, 1] - y) + in_front).argmin())

    corner, brow, lip, nose = at(24, -46), at(27, 29), at(0, -55), at(0, 5)
    smile, raised, opened = moved("12L"), moved("1L"), moved("26L", "26R")
    assert smile[corner, 0] > 0.3
    assert smile[corner, 1] > HAPPENS
    assert raised[brow, 1] > HAPPENS
    assert opened[lip, 1] < -5 * HAPPENS
    for field in (smile, raised, opened):
        assert np.linalg.norm(field[nose]) < HAPPENS / 2
