"""The owner of what is chosen and seen on the timeline of a document."""

from __future__ import annotations

from dataclasses import replace
from itertools import count
from typing import Any

from psygnal import Signal

from app.document import Document
from app.playback.playhead import Playhead
from app.timeline.chosen import Chosen, carried, changeable
from app.timeline.clipping import NOTHING_COPIED, Clipping
from app.timeline.state import TimelineState
from facemodel.animation.clip import Animation
from facemodel.sameness import same

GESTURES = count(1)
"""Numbers that tell the gestures of a session apart."""


class Timeline:
    """Holds one `TimelineState` over a document and its playhead, and tells when it becomes another.

    Parameters
    ----------
    document : whose animation it is
    playhead : where in time one is

    Attributes
    ----------
    clip : what was copied last
    """

    changed = Signal(object, object)
    """(TimelineState now, TimelineState before)"""

    def __init__(self, document: Document, playhead: Playhead) -> None:
        self.document = document
        self.playhead = playhead
        self.clip: Clipping = NOTHING_COPIED
        self._state = TimelineState()
        self._known = document.project.animation
        document.animation_changed.connect(self._follow)
        document.project_changed.connect(self._follow)

    @property
    def state(self) -> TimelineState:
        """What is chosen and how it is shown."""
        return self._state

    @property
    def chosen(self) -> Chosen:
        """What the next deed is about."""
        return self._state.chosen

    @property
    def animation(self) -> Animation:
        """What is shown."""
        return self.document.project.animation

    @property
    def rate(self) -> float:
        """Frames per second."""
        return self.animation.rate

    def change(self, **members: Any) -> None:
        """Change some members of the state; nothing is emitted if they are so already."""
        before, self._state = self._state, replace(self._state, **members)
        if self._state != before:
            self.changed.emit(self._state, before)

    def choose(self, chosen: Chosen) -> None:
        """Let the next deed be about other things, but for what is locked.

        A page of parameters that was about the old ones closes.
        """
        chosen = changeable(chosen, self.animation)
        self.change(chosen=chosen, page="" if chosen != self.chosen else self._state.page)

    def edit(self, after: Animation, label: str, gesture: str = "", chosen: Chosen | None = None) -> None:
        """Go to another animation in one step, if it is another, and choose what stands there now.

        Parameters
        ----------
        after : made of `animation`
        label : what the step is called
        gesture : consecutive steps with the same gesture become one
        chosen : what is chosen then; what was chosen as far as it is still there if not given
        """
        project = self.document.project
        if not same(after, project.animation):
            self.document.edit(replace(project, animation=after), label, gesture)
        if chosen is not None:
            self.choose(carried(chosen, after, self.animation))

    def _follow(self, *_what: object) -> None:
        before, self._known = self._known, self.animation
        self.change(chosen=changeable(carried(self.chosen, before, self._known), self._known))


class LiveChange:
    """One gesture on the animation: every state of it is seen at once, and all together are one step.

    Once somebody else has changed the animation, by a key in the middle of a drag say, the gesture is over: what it
    would go on to is made of what is no more.

    Parameters
    ----------
    timeline : what is worked on
    label : what the step is called

    Attributes
    ----------
    base : the animation before the gesture, which all of its states are made of
    chosen : what was chosen then
    """

    def __init__(self, timeline: Timeline, label: str) -> None:
        timeline.document.commit()
        self.timeline = timeline
        self.base = self._stands = timeline.animation
        self.chosen = timeline.chosen
        self._label = label
        self._gesture = f"timeline {next(GESTURES)}"

    def show(self, after: Animation, chosen: Chosen | None = None) -> None:
        """Go to another state of the gesture; nothing if it is over."""
        if self.timeline.animation is self._stands:
            self.timeline.edit(after, self._label, self._gesture, chosen)
            self._stands = self.timeline.animation

    def cancel(self) -> None:
        """All is as it was before the gesture."""
        self.timeline.document.retract(self._gesture)
        self.timeline.choose(self.chosen)
