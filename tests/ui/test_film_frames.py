"""The frames of a film show what the animation says: skin, head, eyes and where one looks from."""

from dataclasses import replace

import numpy as np
import pytest

from app.film import ANTIALIAS, Film, FilmError
from facemodel.animation.clip import Animation
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.track import Track
from tests.ui.sitter import sitter, weights
from ui.headless import film_frames, render_image
from ui.viewport.surface import ByteArray

SMALL = (160, 160)


def film(film: Film, *tracks: tuple[str, float]) -> list[ByteArray]:
    """Film channels that go from nothing to a value within two frames."""
    project, solution = sitter()
    animation = Animation(
        tuple(Track(name, curve_of([Key(0, 0.0, "linear"), Key(1 / 12, value)])) for name, value in tracks),
        rate=12.0,
        end=2 / 12,
    )
    return list(film_frames(film.take(replace(project, animation=animation)), solution, film))


def skin(picture: ByteArray) -> np.ndarray:
    return picture[..., 0].astype(int) > picture[..., 2].astype(int) + 25


def centre(mask: np.ndarray) -> tuple[float, float]:
    """Return the middle of a mask, right and down."""
    down, right = np.nonzero(mask)
    return float(right.mean()), float(down.mean())


def test_a_frame_is_the_picture_of_its_expression() -> None:
    first, last = film(Film(SMALL), *weights(AU12=1.0).items())
    project, solution = sitter()
    neutral = render_image(project, solution, {}, size=SMALL).astype(int)
    smiling = render_image(project, solution, weights(AU12=1.0), size=SMALL).astype(int)
    assert np.abs(first - neutral).mean() < 0.5
    assert np.abs(last - smiling).mean() < 0.5
    assert np.abs(last - neutral).mean() > 0.5


def test_the_head_goes_where_its_channels_say() -> None:
    first, last = film(Film(SMALL), ("head.x", 30.0), ("head.y", 20.0))
    (right, down), (later_right, later_down) = centre(skin(first)), centre(skin(last))
    assert later_right > right + 5
    assert later_down < down - 4


def test_the_head_turns_to_its_own_left() -> None:
    """Seen from the front the nose then points to the right of the picture."""
    _, last = film(Film(SMALL), ("head.yaw", 75.0))
    face = np.flatnonzero(skin(last)[80:107].any(axis=0))
    throat = np.flatnonzero(skin(last)[138])
    assert face.max() - throat.max() > throat.min() - face.min() + 10


def test_the_head_looks_up_and_tilts_to_its_left_shoulder() -> None:
    _, up = film(Film(SMALL), ("head.pitch", 30.0))
    level, tilted = film(Film(SMALL), ("head.roll", 30.0))
    assert np.flatnonzero(skin(up).any(axis=1)).min() > np.flatnonzero(skin(level).any(axis=1)).min() + 2
    assert centre(skin(tilted)[:60])[0] > centre(skin(level)[:60])[0] + 10


def test_eyes_turn_within_the_head() -> None:
    first, last = film(Film((240, 240), close=True), ("eyeL.yaw", 30.0), ("eyeR.yaw", 30.0))
    changed = np.abs(last.astype(int) - first.astype(int)).max(axis=2) > 30
    down, _ = np.nonzero(changed)
    assert changed.sum() > 40
    assert np.ptp(down) < 40


def test_a_turntable_goes_round_once_and_ends_before_its_begin() -> None:
    project, solution = sitter()
    round_ = Film((120, 120), rate=12.0, span=(0.0, 4 / 12), turns=1.0, antialias="off")
    front, side, back, other = film_frames(round_.take(project), solution, round_)
    assert skin(front).sum() > 0
    columns = [np.flatnonzero(skin(each)[60:75].any(axis=0)) for each in (front, side, back, other)]
    widths = [np.ptp(each) for each in columns]
    assert widths[1] > widths[0]
    assert widths[3] == pytest.approx(widths[1], abs=4)
    assert not np.array_equal(front, back)


def test_the_more_antialiasing_the_nearer_to_the_finest() -> None:
    off, fine, finest = (film(Film(SMALL, antialias=kind), ("12L", 0.1))[0].astype(int) for kind in ANTIALIAS)
    assert ((off - finest) ** 2).mean() > 2 * ((fine - finest) ** 2).mean() > 0


def test_what_no_driver_can_draw_is_refused() -> None:
    project, solution = sitter()
    huge = Film((8192, 8192), turns=1.0, antialias="finest")
    with pytest.raises(FilmError, match="choose a side of at most 5461 pixels, or less antialiasing"):
        next(film_frames(huge.take(project), solution, huge))
