"""Solving in the background, as seen from the window."""

import threading
from dataclasses import replace

import numpy as np
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMessageBox

from app.solving import EditingSolve
from facemodel.errors import FaceError
from tests.ui.hands import drag, let_go
from tests.ui.window.seen import picture
from ui.portraits import NEUTRAL, portraits


def test_the_window_lives_and_the_face_stands_while_it_is_solved(open_window, document, slow, qtbot):
    window = open_window(document, slow, wait=False)
    ticks: list[int] = []
    timer = QTimer()
    timer.timeout.connect(lambda: ticks.append(1))
    timer.start(10)
    qtbot.waitUntil(lambda: window.status.bar.isVisible() and window.status.bar.value() > 50)
    qtbot.waitUntil(lambda: len(ticks) > 5)
    qtbot.waitUntil(lambda: window.viewport.shows_face)
    assert picture(window).std() > 10
    drag(window.expression.rows[17].slider, 0.0, 0.5)
    assert document.shown["17"] > 0.4
    assert "0/" in window.status.state.text()


def test_cancel_stops_the_solver_and_keeps_the_face(open_window, document, qtbot):
    stopped = threading.Event()

    def solve(project, progress):
        try:
            while True:
                progress("Factorising", 0.4)
                QTest.qSleep(5)
        finally:
            stopped.set()

    window = open_window(document, solve, wait=False)
    qtbot.waitUntil(window.status.cancel.isVisible)
    QTest.mouseClick(window.status.cancel, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(stopped.is_set)
    qtbot.waitUntil(lambda: not window.status.bar.isVisible())
    qtbot.waitUntil(lambda: window.viewport.shows_face)
    assert document.solution is None
    assert window.binding.qt["solve.now"].isEnabled() or window.context.solving.wanted


def test_a_face_that_cannot_be_solved_is_one_sentence_and_stays(open_window, document, answer, qtbot):
    def solve(project, progress):
        progress("Assembling", 0.1)
        raise FaceError("The face is loose around skin vertex 7: nothing holds it there.")

    said = answer(QMessageBox.StandardButton.Ok)
    window = open_window(document, solve, wait=False)
    qtbot.waitUntil(lambda: bool(said))
    assert said == ["The face is loose around skin vertex 7: nothing holds it there."]
    qtbot.waitUntil(lambda: window.viewport.shows_face)


def test_the_solution_takes_over_what_was_posed_meanwhile(open_window, document, solution, qtbot):
    go = threading.Event()

    def solve(project, progress):
        progress("Assembling", 0.1)
        go.wait(20)
        return solution

    window = open_window(document, solve, wait=False)
    qtbot.waitUntil(lambda: window.viewport.shows_face)
    document.set_weights({"26": 1.0})
    picture(window)
    at_rest = window.viewport.scene.figure.posed.points.copy()
    go.set()
    qtbot.waitUntil(lambda: window.viewport.scene.figure.posed.basis is solution.basis)
    picture(window)
    open_jaw = window.viewport.scene.figure.posed.points
    assert np.linalg.norm(open_jaw - at_rest, axis=1).max() > 5.0
    assert f"solved {len(solution.basis.names)}/{len(solution.basis.names)}" in window.status.state.text()


def test_left_alone_it_takes_a_portrait_of_every_expression(window, document, qtbot, monkeypatch):
    monkeypatch.setattr(portraits, "REST", 0)
    let_go(window.viewport.canvas)
    window.portraits.refresh()
    qtbot.waitUntil(lambda: window.portraits.complete)
    names = [NEUTRAL, *(emotion.name for emotion in document.project.emotions)]
    assert all(window.portraits.picture(name) is not None for name in names)


def test_a_finer_mesh_asked_for_while_solving_and_undone_again_is_what_is_shown(open_window, document, qtbot):
    window = open_window(document, EditingSolve())
    for density in (2, 3, 1):
        settings = replace(document.project.settings, density=density)
        document.edit(replace(document.project, settings=settings), "Density")
        drag(window.expression.rows[17].slider, 0.1, 0.4)
    qtbot.waitUntil(lambda: not document.stale and not window.context.solving.job.running)
    for density in (1, 3, 2):
        qtbot.waitUntil(lambda: not document.stale and window.viewport.shows_face)
        qtbot.waitUntil(lambda d=density: document.solution.basis.display.density == d)
        picture(window)
        assert window.viewport.scene.figure.posed.basis is document.solution.basis
        document.undo(), document.undo()
