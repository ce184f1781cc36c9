"""A piece that was opened to be seen plays by itself, with its timeline below the face."""

from __future__ import annotations

from typing import TYPE_CHECKING

from facemodel.solution import Solution

if TYPE_CHECKING:
    from ui.window.main_window import MainWindow


def perform(window: MainWindow) -> None:
    """Open the timeline and play what is open, as soon as its face is solved; nothing if nothing moves by then."""
    document = window.context.document
    wanted = document.project.animation

    def begin(solution: Solution | None) -> None:
        if solution is None:
            return
        document.solution_changed.disconnect(begin)
        if wanted.moves and document.project.animation is wanted:
            window.timeline.dock.open()
            window.timeline.timeline.playhead.play()

    document.solution_changed.connect(begin)
    if not document.stale:
        begin(document.solution)
