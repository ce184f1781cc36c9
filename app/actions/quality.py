"""How finely the face is drawn, in the menu “View”."""

from __future__ import annotations

from app.actions.action import Action
from app.actions.context import Context
from app.quality import QUALITY_TITLES, Quality

PATH = ("View", "Drawing quality")

RATES = (15, 24, 30, 60)
"""Frames a second that are offered to be kept: what is still followed, film, video, what a screen shows."""

HINTS: dict[Quality, str] = {
    "automatic": "As fine as moves fluidly here: steps down by itself in a motion that stutters, and up again at rest",
    "full": "Smooth edges, and shade where skin comes near to skin as it is posed",
    "balanced": "Smooth edges, and the shade of the resting face",
    "fast": "Fewer pixels and rough edges while the face moves; smooth again once it rests",
}


def _quality(quality: Quality) -> Action:
    title = f"{QUALITY_TITLES[quality]} quality"

    def caption(context: Context) -> str:
        state = context.view.state
        found = quality == state.quality == "automatic"
        return f"{title} ({QUALITY_TITLES[state.level].lower()} now)" if found else title

    return Action(
        f"quality.{quality}",
        title,
        lambda context: context.view.change(quality=quality),
        menu=PATH,
        group=6,
        hint=HINTS[quality],
        kind="choice",
        checked=lambda context: context.view.state.quality == quality,
        caption=caption,
    )


def _rate(rate: int) -> Action:
    return Action(
        f"quality.rate-{rate}",
        f"At least {rate} frames a second",
        lambda context: context.view.change(least_rate=float(rate)),
        menu=PATH,
        group=7,
        hint=f"The automatic quality steps down where the face moves at less than {rate} frames a second",
        kind="choice",
        enabled=lambda context: context.view.state.quality == "automatic",
        checked=lambda context: context.view.state.least_rate == rate,
    )


QUALITY_ACTIONS = (*(_quality(quality) for quality in QUALITY_TITLES), *(_rate(rate) for rate in RATES))
