"""The playhead: the time of the clip that is looked at, still or playing, and what the face does then."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace

from psygnal import Signal

from app.document import Document
from app.playback.clock import AchievedRate, Clock, Now
from facemodel.actions import Expression, field_names
from facemodel.animation.clip import Animation
from facemodel.animation.editing.expressions import keyed, with_expression
from facemodel.animation.evaluation import Evaluator, Pose
from facemodel.animation.timecode import frame_of, snapped, time_of
from facemodel.project import Project

NEUTRAL = Pose({}, {})


class Playhead:
    """Shows the animation of a document at a time, over its sliders and without a step to undo.

    It follows the document: whatever changes its animation is seen at once.  Frames that cannot be drawn in time are
    left out, the clip never slows.

    Parameters
    ----------
    document : whose animation is shown
    now : the real clock
    """

    moved = Signal(float)
    """(seconds) it stands at another time."""
    posed = Signal(object)
    """(Pose) what the face does now; weights are shown by the document, `Pose.rigid` moves head and eyes."""
    playing_changed = Signal(bool)
    """(whether it plays)"""

    def __init__(self, document: Document, now: Now = time.perf_counter) -> None:
        self._document = document
        self._clock = Clock(now)
        self._achieved = AchievedRate(now)
        self._time = document.project.animation.start
        self._frame = 0
        self._playing = False
        self._span = (0.0, 0.0, False)
        self._pose = NEUTRAL
        self._evaluator = self._made()
        document.animation_changed.connect(self._follow)
        document.units_changed.connect(self._follow)
        document.project_changed.connect(self._begin)
        self.show()

    @property
    def time(self) -> float:
        """Where it stands, seconds of the clip."""
        return self._time

    @property
    def frame(self) -> int:
        """The frame it stands on, counted from time 0."""
        return frame_of(self._time, self._animation.rate)

    @property
    def playing(self) -> bool:
        """Whether it plays."""
        return self._playing

    @property
    def pose(self) -> Pose:
        """What the face does now."""
        return self._pose

    @property
    def rate(self) -> float | None:
        """Frames really shown per second, over the last second of playing."""
        return self._achieved.rate

    @property
    def dropped(self) -> int:
        """Frames left out since it began to play."""
        return self._achieved.dropped

    def go(self, seconds: float, *, snap: bool = False) -> None:
        """Stand at a time, the nearest frame's if it snaps; if it plays it goes on from there."""
        at = snapped(seconds, self._animation.rate) if snap else float(seconds)
        if self._playing:
            self._clock.start(at, *self._span)
        self._stand(at)

    def go_frames(self, count: int) -> None:
        """Go on by frames, or back."""
        rate = self._animation.rate
        self.go(time_of(frame_of(self._time, rate) + count, rate))

    def play(self, span: tuple[float, float] | None = None, loop: bool | None = None) -> None:
        """Play from where it stands, from the start if it stands at the end.

        Parameters
        ----------
        span : from when to when; what the animation says if not given
        loop : whether it begins anew at the end; as the animation says if not given
        """
        animation = self._animation
        start, end = span or (animation.start, animation.end)
        loops = animation.loop if loop is None else loop
        at = self._time if start <= self._time < end - 0.5 / animation.rate else start
        self._span = (start, end, loops)
        self._clock.start(at, *self._span)
        self._achieved.begin()
        self._stand(at)
        self._set_playing(True)

    def pause(self) -> None:
        """Stand still where it is."""
        self._set_playing(False)

    def show(self) -> None:
        """Show what the face does now, whatever was shown in the meantime."""
        before = self._pose
        self._pose = self._evaluator.pose(self._time)
        fields = set(field_names(self._document.project.units))
        self._document.play({name: weight for name, weight in self._pose.weights.items() if name in fields})
        if self._pose != before:
            self.posed.emit(self._pose)

    def tick(self) -> bool:
        """Show the frame that is due now, if it is another one; whether it still plays.

        To be called whenever a frame could be drawn.
        """
        if not self._playing:
            return False
        over = self._clock.over
        rate = self._animation.rate
        frame = frame_of(self._clock.time, rate)
        if frame != self._frame:
            self._achieved.frame(frame - self._frame - 1)
            self._stand(time_of(frame, rate))
        if over:
            self._set_playing(False)
        return self._playing

    def hear(self, seconds: float) -> None:
        """Follow a sound that plays along, which says where in the clip it is."""
        if self._playing:
            self._clock.hear(seconds)

    @property
    def auto_key(self) -> bool:
        """Whether weights that people set become keys at the time it stands at."""
        return self._document.keying is not None

    @auto_key.setter
    def auto_key(self, on: bool) -> None:
        self._document.commit()
        self._document.keying = self._keyed if on else None

    def set_keys(self, names: tuple[str, ...] | None = None) -> None:
        """Key what is shown now: some fields by name, or all that are shown or animated."""
        shown = self._document.shown
        chosen = names if names is not None else tuple({**shown, **self._pose.weights})
        self.key({name: shown.get(name, 0.0) for name in chosen})

    def key(self, values: Mapping[str, float], gesture: str = "") -> None:
        """Key some values of channels, fields or head and eyes, at the time it stands at; held weights are let go."""
        self._document.cancel_preview()
        project = self._document.project
        made = keyed(project.animation, self._time, values, project.units)
        self._document.edit(replace(project, animation=made), "Set keys", gesture)

    def set_expression(self, name: str = "") -> None:
        """Make what is shown now a key expression at the time it stands at."""
        shown = dict(self._document.shown)
        self._document.cancel_preview()
        project = self._document.project
        made = with_expression(project.animation, self._time, shown, name, project.units)
        self._document.edit(replace(project, animation=made), f"Key expression {name}".rstrip())

    def close(self) -> None:
        """Let go of the document; its sliders are shown again."""
        self._set_playing(False)
        self._document.keying = None
        self._document.animation_changed.disconnect(self._follow)
        self._document.units_changed.disconnect(self._follow)
        self._document.project_changed.disconnect(self._begin)
        self._document.play({})

    @property
    def _animation(self) -> Animation:
        return self._document.project.animation

    def _made(self) -> Evaluator:
        project = self._document.project
        return Evaluator(project.animation, project.units)

    def _keyed(self, project: Project, weights: Expression) -> Project:
        """Keys for what is animated already, and for what comes to be another weight than its slider has."""
        wanted = {
            name: weight
            for name, weight in weights.items()
            if project.animation.track(name) is not None or weight != project.expression.get(name, 0.0)
        }
        return replace(project, animation=keyed(project.animation, self._time, wanted, project.units))

    def _begin(self) -> None:
        """Another project: it is looked at first, from where it starts unless it goes on at this time."""
        self._set_playing(False)
        animation = self._animation
        self._follow()
        if not animation.start <= self._time <= animation.end:
            self._stand(animation.start)

    def _follow(self) -> None:
        self._evaluator = self._made()
        self.show()

    def _stand(self, seconds: float) -> None:
        """Stand at a time, kept or new."""
        self._frame = frame_of(seconds, self._animation.rate)
        if seconds != self._time:
            self._time = seconds
            self.show()
            self.moved.emit(seconds)

    def _set_playing(self, on: bool) -> None:
        if on != self._playing:
            self._playing = on
            self.playing_changed.emit(on)
