"""The viewport draws as finely as it can keep up with, by its own frames, and says when that changes."""

import time

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu
from pytestqt.qtbot import QtBot

from app.quality import FRAMES, QUICKEST, SLOWEST
from app.settings import UserSettings
from tests.ui.hands import drag
from tests.ui.window.seen import differs, next_frame, picture, pixel
from ui.window.canvas import FRAME, STILL
from ui.window.main_window import MainWindow

SMILE = 12

TICK = 0.02
"""Seconds by which a timer of Qt's may come early: a twentieth of its time."""


def entry(menu: QMenu, *path: str) -> QAction:
    """Return the entry of a menu that begins with the last of some titles, through submenus of the others."""
    action = next(each for each in menu.actions() if each.text().startswith(path[0]))
    return action if len(path) == 1 else entry(action.menu(), *path[1:])


def choose(window: MainWindow, title: str) -> None:
    entry(window.menuBar(), "View", "Drawing quality", title).trigger()


def swing(window: MainWindow) -> None:
    """Drag the smile to and fro, for more frames than the quality is judged by."""
    canvas = window.viewport.canvas
    before = canvas.frames
    while canvas.frames < before + 2 * FRAMES:
        for share in (0.9, 0.2):
            drag(window.expression.rows[SMILE].slider, 0.5, share, steps=4)
            next_frame(window)


def test_a_choice_of_the_menu_is_taken_at_once_and_kept(window: MainWindow, settings: UserSettings) -> None:
    for title, level in (("Full", "full"), ("Balanced", "balanced"), ("Fast", "fast")):
        choose(window, title)
        assert window.viewport.canvas.moving == window.context.view.state.level == level
        assert settings.preferences.quality == level
        window.binding.refresh()
        assert entry(window.menuBar(), "View", "Drawing quality", title).isChecked()
        assert window.status.state.text().endswith(level)
    assert window.viewport.canvas.resting == "balanced"


def test_what_was_chosen_comes_back_at_the_next_start(open_window, document, settings: UserSettings) -> None:
    settings.change(quality="balanced", least_rate=60.0)
    state = open_window(document).context.view.state
    assert (state.quality, state.level, state.least_rate) == ("balanced", "balanced", 60.0)


def test_frames_that_are_too_slow_bring_it_down_and_it_says_so(window: MainWindow, qtbot: QtBot) -> None:
    view, canvas = window.context.view, window.viewport.canvas
    choose(window, "Automatic")
    view.change(least_rate=SLOWEST)
    next_frame(window)
    qtbot.waitUntil(lambda: canvas.moving != "fast")
    view.change(least_rate=QUICKEST)
    qtbot.waitUntil(lambda: swing(window) or canvas.moving != canvas.resting)
    assert view.state.level == canvas.moving
    said = window.status.hint.text()
    assert said.startswith("Drawing quality went down to")
    assert "ms a frame" in said
    window.binding.refresh()
    assert "now)" in entry(window.menuBar(), "View", "Drawing quality", "Automatic").text()


def test_by_hand_it_stays_however_slow_it_is(window: MainWindow) -> None:
    choose(window, "Balanced")
    window.context.view.change(least_rate=QUICKEST)
    swing(window)
    assert window.viewport.canvas.moving == window.context.view.state.level == "balanced"


def test_a_face_at_rest_is_drawn_once_more_and_a_hand_puts_that_off(window: MainWindow, qtbot: QtBot) -> None:
    choose(window, "Fast")
    canvas = window.viewport.canvas
    frames = [-np.inf]
    gaps: list[float] = []
    canvas.rested.connect(lambda drawing: gaps.append(time.perf_counter() - drawing / 1000 - frames[-1]))
    canvas.drawn.connect(lambda _drawing: frames.append(time.perf_counter()))
    next_frame(window)
    qtbot.waitUntil(lambda: bool(gaps))
    drawn = canvas.frames
    QTest.qWait(500)
    assert canvas.frames == drawn
    begun = time.perf_counter()
    while time.perf_counter() < begun + 3 * STILL:
        next_frame(window)
    assert min(gaps) > STILL - TICK


def test_the_time_that_a_frame_takes_is_not_waited_for_again(window: MainWindow) -> None:
    canvas = window.viewport.canvas
    canvas.before_frame.append(lambda: time.sleep(FRAME))
    next_frame(window)
    assert canvas.due == 0.0


def test_fewer_pixels_leave_what_lies_under_the_pointer_where_it_is(window: MainWindow) -> None:
    choose(window, "Fast")
    next_frame(window)
    canvas, scene, face = window.viewport.canvas, window.viewport.scene, window.context.document.project.face
    assert canvas.ren_win.GetSize() == (canvas.width(), canvas.height())
    nose = face.skin.positions[face.landmarks["nose_tip"]]
    place = pixel(window, nose)
    hit = scene.pick(place.x(), canvas.height() - 1 - place.y())
    assert hit is not None
    assert np.linalg.norm(hit.place - nose) < 2.0


@pytest.mark.parametrize("overlay", ["", "muscles", "influence"])
def test_full_quality_shades_the_face_and_leaves_the_backdrop(window: MainWindow, overlay: str) -> None:
    window.context.view.change(view="front", muscle="zygomaticus_major_L")
    if overlay:
        window.context.view.toggle(overlay)
    window.context.document.set_weights({"26": 1.0, "25": 1.0})
    choose(window, "Balanced")
    plain = picture(window)
    choose(window, "Full")
    shaded = picture(window)
    assert differs(shaded, plain)
    assert np.abs(shaded[:20] - plain[:20]).max() <= 3
    assert shaded.mean() < plain.mean()
    choose(window, "Balanced")
    assert not differs(picture(window), plain)


@pytest.mark.parametrize("lines", [{"wireframe": True}, {"layer": "stiffness", "contours": True}])
def test_thin_lines_are_as_whole_in_full_quality_as_in_balanced(window: MainWindow, lines: dict[str, object]) -> None:
    window.context.view.change(view="front", **lines)
    choose(window, "Balanced")
    whole = picture(window)
    choose(window, "Full")
    assert not differs(picture(window), whole)
    window.context.view.change(wireframe=False, layer="")
    bare = picture(window)
    choose(window, "Balanced")
    assert differs(picture(window), bare)


def test_a_window_closes_in_full_quality(window: MainWindow) -> None:
    choose(window, "Full")
    next_frame(window)
    QTest.mouseMove(window.viewport.canvas, QPoint(20, 20))
    assert window.close()
    assert not window.isVisible()
