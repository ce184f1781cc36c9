"""What part of the timeline is looked at, as actions."""

from __future__ import annotations

from app.actions.action import Action
from app.actions.context import Context
from app.timeline.chosen import times_of
from app.timeline.entry import MENU
from ui.timeline.view import TimelineView

LEAST = 0.5
"""Seconds that are shown about a single moment."""


def sight_actions(view: TimelineView) -> tuple[Action, ...]:
    """Actions on a view."""

    def frame_chosen(_context: Context) -> None:
        timeline = view.timeline
        reach = times_of(timeline.animation, timeline.chosen)
        if reach is None:
            view.show_all()
        else:
            middle, half = (reach[0] + reach[1]) / 2, max(reach[1] - reach[0], LEAST) / 2
            view.frame(middle - half, middle + half)

    look = (MENU, "Look")
    return (
        Action(
            "timeline.frame-all",
            "Frame all",
            lambda _context: view.show_all(),
            menu=look,
            group=5,
            hint="Bring all that is played into view (Home over the timeline)",
        ),
        Action(
            "timeline.frame-chosen",
            "Frame what is chosen",
            frame_chosen,
            menu=look,
            group=5,
            hint="Bring what is chosen into view (F over the timeline)",
        ),
    )
