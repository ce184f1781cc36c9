"""The level of drawing follows the frames taken: down in a motion that stutters, up at rest, never to and fro."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.document import Document
from app.preferences import Preferences
from app.quality import COMFORT, FRAMES, LEVELS, PATIENCE, TRIES, Pacing, checked_quality
from app.scripting.console import run_script
from app.view import View
from facemodel.errors import FaceError, UnknownNameError

RATE = 25.0
SLOW, QUICK = 1.5 * 1000 / RATE, 0.2 * 1000 / RATE
"""Milliseconds of a frame that is too slow for the rate, and of one that is comfortable."""


def move(pacing: Pacing, milliseconds: float, frames: int = FRAMES, posing: float = 0.0) -> bool:
    """Draw some frames alike; whether the level stepped down."""
    return any(pacing.moved(milliseconds, milliseconds - posing) for _ in range(frames))


def test_a_motion_that_stutters_is_drawn_coarser_step_by_step() -> None:
    pacing = Pacing("full", "full", RATE)
    assert move(pacing, SLOW)
    assert pacing.moving == "balanced"
    pacing.begin_anew()
    assert move(pacing, SLOW)
    assert pacing.moving == "fast"
    pacing.begin_anew()
    assert not move(pacing, SLOW)
    assert (pacing.moving, pacing.resting) == ("fast", "full")


def test_a_single_slow_frame_is_no_reason() -> None:
    pacing = Pacing("full", "full", RATE)
    assert not move(pacing, QUICK)
    assert not move(pacing, 20 * SLOW, frames=1)
    assert not move(pacing, QUICK)
    assert pacing.moving == "full"


def test_slow_posing_is_not_blamed_on_drawing() -> None:
    pacing = Pacing("full", "full", RATE)
    assert not move(pacing, SLOW, posing=SLOW - QUICK)
    assert pacing.moving == "full"


def test_it_steps_up_at_rest_where_the_resting_picture_shows_that_there_is_time() -> None:
    pacing = Pacing("full", "fast", RATE)
    assert not pacing.rested(1.2 * COMFORT * 1000 / RATE)
    assert pacing.moving == "fast"
    assert pacing.rested(QUICK)
    assert pacing.moving == "balanced"
    assert pacing.rested(QUICK)
    assert pacing.moving == "full"
    assert not pacing.rested(QUICK)


def test_it_never_goes_above_what_the_driver_is_trusted_with() -> None:
    pacing = Pacing("balanced", "balanced", RATE)
    assert not pacing.rested(QUICK)
    assert pacing.moving == "balanced"


@given(st.lists(st.tuples(st.sampled_from([SLOW, QUICK]), st.sampled_from([SLOW, QUICK])), max_size=60))
def test_it_does_not_flicker_whatever_the_machine_does(gestures: list[tuple[float, float]]) -> None:
    pacing = Pacing("full", "full", RATE)
    ups = 0
    for moving, resting in gestures:
        if move(pacing, moving):
            pacing.begin_anew()
        ups += pacing.rested(resting)
    assert ups <= TRIES * (len(LEVELS) - 1)


def test_a_resting_picture_that_keeps_the_hand_waiting_is_drawn_coarser_from_the_second_time_on() -> None:
    pacing = Pacing("full", "fast", RATE)
    assert not pacing.rested(2 * PATIENCE)
    assert pacing.rested(2 * PATIENCE)
    assert (pacing.moving, pacing.resting) == ("fast", "balanced")


def test_a_script_asks_for_a_quality(document: Document) -> None:
    view = View()
    assert run_script("drawing_quality('full')", document, view=view).error == ""
    assert (view.state.quality, view.state.least_rate) == ("full", 24.0)
    assert run_script("drawing_quality(at_least=60)", document, view=view).error == ""
    assert (view.state.quality, view.state.least_rate) == ("automatic", 60.0)
    assert "“best”" in run_script("drawing_quality('best')", document, view=view).error
    assert "no window" in run_script("drawing_quality()", document).error
    assert not document.history.done


def test_what_is_no_quality_is_refused() -> None:
    assert checked_quality("fast", 30) == ("fast", 30.0)
    with pytest.raises(UnknownNameError, match="choose one of automatic"):
        checked_quality("FAST", 30)
    for rate in (0.0, -3.0, float("nan"), 1e6):
        with pytest.raises(FaceError, match="cannot be kept"):
            checked_quality("fast", rate)


def test_preferences_keep_it() -> None:
    kept = Preferences(quality="fast", least_rate=60.0)
    assert Preferences.model_validate_json(kept.model_dump_json()) == kept
    assert Preferences().quality == "automatic"
