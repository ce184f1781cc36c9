"""A piece that is opened to be seen plays, with its timeline below it."""

from collections.abc import Callable
from dataclasses import replace
from threading import Event

from pytestqt.qtbot import QtBot

from app.document import Document
from facemodel.animation.clip import STILL, Animation
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.track import Track
from facemodel.project import Project
from facemodel.solution import Progress, Solution
from ui.window.main_window import MainWindow

SMILE = Animation((Track("12L", curve_of([Key(0, 0.0), Key(1, 1.0)])),), end=1.0)


def test_it_plays_as_soon_as_it_is_solved(
    open_window: Callable[..., MainWindow], project: Project, qtbot: QtBot
) -> None:
    document = Document(replace(project, animation=SMILE))
    window = open_window(document, wait=False)
    window.context.host.perform()
    playhead = window.timeline.timeline.playhead
    qtbot.waitUntil(lambda: not window.timeline.dock.is_folded)
    qtbot.waitUntil(lambda: document.shown.get("12L", 0.0) > 0.1)
    qtbot.waitUntil(lambda: not playhead.playing)
    assert not document.dirty
    document.edit(replace(document.project, animation=replace(SMILE, end=2.0)), "Longer")
    assert not playhead.playing


def test_what_does_not_move_stays_as_it_is(window: MainWindow, document: Document) -> None:
    assert document.project.animation is STILL
    window.context.host.perform()
    assert window.timeline.dock.is_folded
    assert not window.timeline.timeline.playhead.playing


def test_another_project_that_comes_before_it_is_solved_does_not_play(
    open_window: Callable[..., MainWindow], project: Project, solution: Solution, qtbot: QtBot
) -> None:
    let = Event()

    def solve(_project: Project, _progress: Progress) -> Solution:
        assert let.wait(20)
        return solution

    document = Document(replace(project, animation=SMILE))
    window = open_window(document, solve, wait=False)
    window.context.host.perform()
    document.begin(replace(project, animation=replace(SMILE, end=2.0)))
    let.set()
    qtbot.waitUntil(lambda: document.solution is not None)
    assert not window.timeline.timeline.playhead.playing
