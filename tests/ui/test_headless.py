"""Pictures need no screen, say clearly what they cannot do, and leave files whole."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from facemodel.errors import ProjectError, UnknownNameError
from facemodel.project import Project
from facemodel.solve import Solution, solve_project
from tests.app.conftest import small_project
from tests.ui.sitter import SMILE, sitter, weights
from ui.headless import gallery_to_file, render_image, render_to_file
from ui.headless.gallery import COLUMNS, PORTRAIT
from ui.headless.sheet import Entry, Section, sheet

SMALL = (200, 160)


@pytest.fixture(scope="module")
def patch() -> tuple[Project, Solution]:
    """A square of skin, solved in an instant."""
    project = small_project()
    return project, solve_project(project)


def test_a_picture_has_the_size_asked_for_and_shows_a_face(tmp_path: Path) -> None:
    path = tmp_path / "face.png"
    render_to_file(*sitter(), weights(**SMILE), path, view="three-quarter", size=SMALL)
    with Image.open(path) as picture:
        assert picture.format == "PNG"
        assert picture.size == SMALL
        pixels = np.asarray(picture.convert("RGB")).astype(int)
    skin = (pixels[..., 0] > pixels[..., 2] + 25).mean()
    assert 0.15 < skin < 0.6


@pytest.mark.parametrize(("view", "nose"), [("left", "left"), ("right", "right")])
def test_side_views_show_the_side_they_name(view: str, nose: str) -> None:
    """Seen from the subject's left the nose points to the left of the picture."""
    pixels = render_image(*sitter(), {}, view=view, size=SMALL).astype(int)
    skin = pixels[..., 0] > pixels[..., 2] + 25
    face = skin[SMALL[1] // 2 : SMALL[1] * 2 // 3]
    columns = np.flatnonzero(face.any(axis=0))
    throat = np.flatnonzero(skin[SMALL[1] * 9 // 10 - 6])
    before, behind = throat.min() - columns.min(), columns.max() - throat.max()
    assert before > behind if nose == "left" else behind > before


def test_the_same_request_gives_the_same_picture() -> None:
    first = render_image(*sitter(), weights(**SMILE), size=SMALL)
    assert np.array_equal(render_image(*sitter(), weights(**SMILE), size=SMALL), first)


def test_the_light_backdrop_is_light(patch: tuple[Project, Solution]) -> None:
    dark, light = (render_image(*patch, {}, size=SMALL, theme=theme)[:3, :3].mean() for theme in ("dark", "light"))
    assert light > dark + 100


def test_a_view_that_does_not_exist_is_named_with_those_that_do(patch: tuple[Project, Solution]) -> None:
    with pytest.raises(UnknownNameError, match="no view “behind”; choose one of front, left"):
        render_image(*patch, {}, view="behind")


def test_something_that_cannot_be_shown_is_named(patch: tuple[Project, Solution]) -> None:
    with pytest.raises(UnknownNameError, match="“bones” cannot be shown; choose from skull"):
        render_image(*patch, {}, show={"bones"})


@pytest.mark.parametrize("size", [(0, 10), (10, 100_000)])
def test_an_impossible_size_is_refused(patch: tuple[Project, Solution], size: tuple[int, int]) -> None:
    with pytest.raises(ValueError, match="cannot be drawn"):
        render_image(*patch, {}, size=size)


def test_a_target_that_cannot_be_written_is_refused_before_anything_is_drawn(
    patch: tuple[Project, Solution], tmp_path: Path
) -> None:
    with pytest.raises(ProjectError, match="no folder"):
        render_to_file(*patch, {}, tmp_path / "missing" / "a.png")
    with pytest.raises(ProjectError, match="no folder"):
        gallery_to_file(*patch, tmp_path / "missing" / "a.png")


def test_a_gallery_shows_every_unit_and_emotion_twice(patch: tuple[Project, Solution], tmp_path: Path) -> None:
    project, solution = patch
    path = tmp_path / "sheet.png"
    gallery_to_file(project, solution, path)
    with Image.open(path) as picture:
        pixels = np.asarray(picture.convert("RGB"))
    assert pixels.shape[1] > COLUMNS * 2 * PORTRAIT[0]
    rows = -(-(1 + len(project.emotions)) // COLUMNS) + -(-len(project.units) // COLUMNS)
    assert pixels.shape[0] > rows * PORTRAIT[1]
    assert (pixels == [0xF2, 0x84, 0x5C]).all(axis=2).any()


def test_long_captions_are_shortened_and_stay_in_their_column() -> None:
    image = np.zeros((40, 200, 3), dtype=np.uint8)
    short = sheet("T", "s", [Section("A", [Entry(image, "1", "n", "n")])], 1)
    long = sheet("T", "s", [Section("A", [Entry(image, "1", "name " * 40, "note " * 40)])], 1)
    assert short.shape == long.shape
    right = long[-140:, -70:].reshape(-1, 3)
    assert (right == right[0]).all()


def test_pictures_come_without_any_display_and_without_a_word(repository: Path, tmp_path: Path) -> None:
    path = tmp_path / "face.png"
    script = (
        "from pathlib import Path\n"
        "from facemodel.solve import solve_project\n"
        "from tests.app.conftest import small_project\n"
        "from ui.headless import render_to_file\n"
        "project = small_project()\n"
        f"render_to_file(project, solve_project(project), {{}}, Path({str(path)!r}), size=(80, 60))\n"
    )
    gone = ("DISPLAY", "WAYLAND_DISPLAY", "VTK_DEFAULT_OPENGL_WINDOW")
    bare = {name: value for name, value in os.environ.items() if name not in gone}
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", script],
        cwd=repository,
        env=bare,
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert path.stat().st_size > 500
