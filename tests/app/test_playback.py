"""The playhead shows what happens at a time, in real time, and turns what hands do into keys."""

from dataclasses import replace

import numpy as np
import pytest

from app.actions import Context
from app.document import Document
from app.playback import Clock, Playhead
from app.posing import PointPull
from facemodel.animation.clip import Animation
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.timecode import frame_of, read_time, snapped, time_of, written
from facemodel.animation.track import Track


class Watch:
    """A real clock that a test can let run."""

    def __init__(self) -> None:
        self.seconds = 100.0

    def __call__(self) -> float:
        return self.seconds

    def wait(self, seconds: float) -> None:
        self.seconds += seconds


RISE = Track("12L", curve_of([Key(0, 0, "linear"), Key(2, 1)]))
TURN = Track("head.yaw", curve_of([Key(0, 0, "linear"), Key(2, 20)]))


def animate(document: Document, animation: Animation) -> None:
    document.edit(replace(document.project, animation=animation), "Animate")


@pytest.fixture
def watch() -> Watch:
    return Watch()


@pytest.fixture
def playhead(document: Document, watch: Watch) -> Playhead:
    animate(document, Animation((RISE, TURN), end=2.0))
    return Playhead(document, watch)


def test_scrubbing_shows_the_face_and_makes_no_step(document: Document, playhead: Playhead) -> None:
    steps = document.history.done
    playhead.go(1.0)
    assert document.shown == {"12L": 0.5}
    assert playhead.pose.rigid == {"head.yaw": 10.0}
    playhead.go(0.513, snap=True)
    assert playhead.time == 0.5
    assert document.history.done == steps
    assert document.project.expression == {}


def test_what_this_face_does_not_have_is_kept_and_not_shown(document: Document, playhead: Playhead) -> None:
    animate(document, Animation((RISE, replace(RISE, channel="34"))))
    playhead.go(1.0)
    assert document.shown == {"12L": 0.5}
    assert playhead.pose.weights["34"] == 0.5


def test_what_is_not_animated_stays_with_its_slider(document: Document, playhead: Playhead) -> None:
    document.set_weights({"17": 0.4})
    playhead.go(1.0)
    assert document.shown == {"17": 0.4, "12L": 0.5}


def test_playing_follows_the_real_clock_and_leaves_out_frames(playhead: Playhead, watch: Watch) -> None:
    times: list[float] = []
    playhead.moved.connect(times.append)
    playhead.play()
    for _ in range(10):
        watch.wait(0.1)
        assert playhead.tick()
    assert times == pytest.approx([k / 10 for k in range(1, 11)])
    assert playhead.rate == pytest.approx(10.0)
    assert playhead.dropped == 20
    watch.wait(1.5)
    assert not playhead.tick()
    assert playhead.time == 2.0
    assert not playhead.playing


def test_a_frame_is_shown_once_however_often_it_could_be_drawn(playhead: Playhead, watch: Watch) -> None:
    times: list[float] = []
    playhead.moved.connect(times.append)
    playhead.play()
    for _ in range(60):
        watch.wait(1 / 240)
        playhead.tick()
    assert len(times) == 7
    assert playhead.dropped == 0


def test_a_loop_begins_anew_and_a_range_is_played_alone(playhead: Playhead, watch: Watch) -> None:
    playhead.play((0.5, 1.0), loop=True)
    assert playhead.time == 0.5
    watch.wait(0.7)
    playhead.tick()
    assert playhead.time == pytest.approx(0.7, abs=1 / 30)
    watch.wait(1000.0)
    assert playhead.tick()
    playhead.pause()
    assert not playhead.tick()


def test_playing_from_the_end_begins_at_the_start(playhead: Playhead) -> None:
    playhead.go(2.0)
    playhead.play()
    assert playhead.time == 0.0


def test_going_somewhere_while_it_plays_goes_on_from_there(playhead: Playhead, watch: Watch) -> None:
    playhead.play()
    playhead.go(1.0)
    watch.wait(0.5)
    playhead.tick()
    assert playhead.time == pytest.approx(1.5)


@pytest.mark.parametrize("fast", [0.999, 1.001])
def test_it_stays_within_a_frame_of_a_sound_over_five_minutes(watch: Watch, fast: float) -> None:
    clock = Clock(watch)
    clock.start(0.0, 0.0, 600.0, loops=False)
    for report in range(1, 5 * 60 * 50):
        watch.wait(0.02)
        heard = report * 0.02 * fast
        clock.hear(heard)
        assert abs(clock.time - heard) < 1 / 120


def test_a_sound_that_jumped_is_followed_at_once(watch: Watch) -> None:
    clock = Clock(watch)
    clock.start(0.0, 0.0, 60.0, loops=False)
    clock.hear(5.0)
    assert clock.time == 5.0


def test_another_project_is_looked_at_before_it_is_played(document: Document, playhead: Playhead) -> None:
    playhead.go(1.5)
    playhead.play()
    other = replace(document.project, animation=Animation((RISE,), end=1.0))
    document.restore(other, None)
    assert not playhead.playing
    assert (playhead.time, document.shown) == (0.0, {})
    playhead.go(0.5)
    document.restore(document.project, None)
    assert (playhead.time, document.shown) == (0.5, {"12L": 0.25})


def test_an_edit_is_seen_at_once_and_so_is_its_undoing(document: Document, playhead: Playhead) -> None:
    playhead.go(1.0)
    animate(document, Animation((replace(RISE, curve=curve_of([Key(0, 0.8)])),)))
    assert document.shown == {"12L": 0.8}
    document.undo()
    assert document.shown == {"12L": 0.5}


def test_auto_key_makes_keys_of_what_sliders_do(document: Document, playhead: Playhead) -> None:
    playhead.auto_key = True
    playhead.go(1.0)
    document.preview({"12L": 0.9})
    document.commit()
    assert document.project.expression == {}
    assert document.shown["12L"] == pytest.approx(0.9)
    assert document.project.animation.track("12L").curve.times.tolist() == [0, 1, 2]  # type: ignore[union-attr]
    document.set_weights({"17": 0.3, "20L": 0.0})
    assert document.project.animation.track("17") is not None
    assert document.project.animation.track("20L") is None
    playhead.auto_key = False
    document.set_weights({"17": 0.6})
    assert document.project.expression == {"17": 0.6}


def test_without_auto_key_a_slider_is_kept_until_the_next_move_and_can_be_keyed(
    document: Document, playhead: Playhead
) -> None:
    playhead.go(1.0)
    document.set_weights({"12L": 0.9})
    assert document.shown["12L"] == 0.9
    playhead.set_keys(("12L",))
    assert document.shown["12L"] == pytest.approx(0.9)
    playhead.go(0.0)
    assert document.shown.get("12L", 0.0) == 0.0
    document.undo()
    playhead.go(1.0)
    assert document.shown["12L"] == 0.5


def test_everything_shown_is_keyed_at_once(document: Document, playhead: Playhead) -> None:
    playhead.go(1.0)
    document.set_weights({"17": 0.4})
    playhead.set_keys()
    assert {t.channel for t in document.project.animation.tracks if t.curve.near(1.0) is not None} == {"12L", "17"}
    playhead.key({"head.yaw": -15.0})
    assert playhead.pose.rigid == {"head.yaw": -15.0}


def test_three_key_expressions_make_an_animation(document: Document) -> None:
    playhead = Playhead(document, Watch())
    playhead.set_expression("neutral")
    playhead.go(1.0)
    document.apply_emotion("happiness")
    playhead.set_expression("happiness")
    playhead.go(2.0)
    document.apply_emotion("surprise")
    playhead.set_expression("surprise")
    document.reset_expression()
    assert [each.name for each in document.project.animation.expressions] == ["neutral", "happiness", "surprise"]
    playhead.go(0.0)
    assert document.shown == {}
    playhead.go(1.0)
    assert document.shown == pytest.approx({"12L": 0.9, "12R": 0.9})
    playhead.go(2.0)
    assert document.shown == pytest.approx({"26": 0.8, "20L": 0.1})


def test_stepping_goes_by_frames_and_closing_shows_the_sliders_again(document: Document, playhead: Playhead) -> None:
    playhead.go_frames(3)
    assert (playhead.frame, playhead.time) == (3, pytest.approx(0.1))
    playhead.go_frames(-3)
    assert playhead.frame == 0
    playhead.go(1.0)
    playhead.close()
    assert document.shown == {}
    animate(document, Animation())


def test_a_pulled_point_moves_sliders_or_makes_keys(context: Context) -> None:
    document = context.document
    context.solving.solve()
    assert document.solution is not None
    basis = document.solution.basis
    point = int(np.argmax(np.linalg.norm(basis.moving_field("12L"), axis=1)))
    target = basis.display.points[point] + 0.7 * basis.moving_field("12L")[point]
    pull = PointPull(document, point, among={"12L"})
    pull.move(target + 3.0)
    pull.move(target)
    assert document.shown["12L"] == pytest.approx(0.7, abs=0.05)
    pull.cancel()
    assert document.shown == {}
    playhead = Playhead(document, Watch())
    playhead.auto_key = True
    playhead.go(1.0)
    pull = PointPull(document, point, among={"12L"})
    pull.move(target)
    pull.release()
    assert document.project.expression == {}
    assert document.shown["12L"] == pytest.approx(0.7, abs=0.05)
    assert document.history.done == ("Pull the face",)


@pytest.mark.parametrize("rate", [12.0, 23.976, 24.0, 25.0, 29.97, 30.0, 59.94, 60.0, 120.0])
def test_time_is_read_as_it_is_written(rate: float) -> None:
    for frame in (0, 1, 59, 60, 1798, 1799, 1800, 17981, 17982, 17983, 35964, 107892, -75):
        time = time_of(frame, rate)
        assert read_time(written(time, rate, "timecode"), rate) == pytest.approx(time, abs=1e-9)
        assert read_time(written(time, rate, "frames"), rate) == pytest.approx(time, abs=1e-9)
        assert read_time(written(time, rate, "seconds"), rate) == pytest.approx(time, abs=6e-4)
        assert frame_of(time, rate) == frame
        assert snapped(time + 0.3 / rate, rate) == pytest.approx(time)


def test_drop_frame_timecode_stays_with_the_clock() -> None:
    rate = 30000 / 1001
    assert written(3600.0, rate, "timecode") == "01:00:00;00"
    assert written(time_of(1800, rate), rate, "timecode") == "00:01:00;02"


@pytest.mark.parametrize(
    ("text", "time"),
    [
        ("36", 1.5),
        ("36f", 1.5),
        ("1.5s", 1.5),
        ("1,5 sec", 1.5),
        ("1:12", 1.5),
        ("-0:12", -0.5),
        ("1:24", None),
        ("x", None),
        ("", None),
    ],
)
def test_people_write_time_in_many_ways(text: str, time: float | None) -> None:
    assert read_time(text, 24.0) == time


def test_a_plain_number_counts_what_is_shown() -> None:
    assert read_time("2", 24.0, "seconds") == 2.0
    assert read_time("48", 24.0, "timecode") == 2.0
