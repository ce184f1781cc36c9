"""The command as a process of its own: exit status, signals and pipes as a shell sees them."""

import os
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from facemodel.animation.clip import Animation
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.track import Track
from facemodel.io.project_file import save_project
from facemodel.projects import new_project
from tests.io.small_project import small_project

RISORIUS = [sys.executable, "-W", "error", "-m", "ui.launch"]
WITHOUT_DISPLAY = {
    name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
}


def run(*words: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*RISORIUS, *map(str, words)],
        capture_output=True,
        encoding="utf-8",
        env={**WITHOUT_DISPLAY, "PYTHONIOENCODING": "utf-8"},
        cwd=Path.cwd(),
        check=False,
    )


def test_a_failure_is_one_line_and_a_status(tmp_path: Path) -> None:
    ended = run("info", tmp_path / "none.risorius")
    assert ended.returncode == 1
    assert ended.stdout == ""
    assert len(ended.stderr.splitlines()) == 1
    assert "none.risorius” cannot be opened: there is no such file" in ended.stderr


def test_the_command_line_needs_neither_qt_nor_vtk(tmp_path: Path) -> None:
    """Everything but drawing works on a machine that could not even load them."""
    script = (
        "import sys; from ui.launch import main;"
        "assert main(['new', sys.argv[1]]) == 0; assert main(['info', sys.argv[1]]) == 0;"
        "heavy = {'PySide6', 'qtpy', 'vtk', 'vtkmodules', 'pyvista', 'pyvistaqt'} & set(sys.modules);"
        "assert not heavy, heavy"
    )
    command = [sys.executable, "-c", script, str(tmp_path / "a.risorius")]
    subprocess.run(command, check=True, capture_output=True, cwd=Path.cwd())


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="elsewhere there is always a display")
def test_without_a_display_the_editor_says_so() -> None:
    ended = run("edit")
    assert ended.returncode == 1
    assert "There is no display for the editor" in ended.stderr
    assert len(ended.stderr.splitlines()) == 1


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX systems")
def test_control_c_stops_a_solve(tmp_path: Path) -> None:
    path = tmp_path / "face.risorius"
    save_project(new_project(), path)
    environment = {**os.environ, "RISORIUS_CACHE": str(tmp_path / "cache")}
    process = subprocess.Popen(
        [*RISORIUS, "solve", str(path)], stderr=subprocess.PIPE, text=True, env=environment, cwd=Path.cwd()
    )
    assert process.stderr is not None
    assert process.stderr.readline() == "Assembling the skin\n"
    process.send_signal(signal.SIGINT)
    rest = process.stderr.read()
    process.stderr.close()
    assert process.wait() == 130
    assert rest.endswith("risorius: stopped\n")
    assert "Traceback" not in rest
    assert not (tmp_path / "cache").exists()


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX systems")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_export_that_is_told_to_end_leaves_nothing(tmp_path: Path, number: signal.Signals) -> None:
    smile = Animation((Track("12L", curve_of([Key(0, 0.0), Key(1, 1.0)])),), end=60.0, rate=120.0)
    save_project(replace(small_project(), animation=smile), tmp_path / "face.risorius")
    words = ["animate", str(tmp_path / "face.risorius"), str(tmp_path / "face.obj")]
    process = subprocess.Popen([*RISORIUS, *words], stderr=subprocess.PIPE, text=True, cwd=Path.cwd())
    assert process.stderr is not None
    while "Writing frames" not in process.stderr.readline():
        assert process.poll() is None
    process.send_signal(number)
    rest = process.stderr.read()
    process.stderr.close()
    assert process.wait() == 130
    assert rest.endswith("risorius: stopped\n")
    assert os.listdir(tmp_path) == ["face.risorius"]


@pytest.mark.skipif(os.name == "nt", reason="pipes of POSIX systems")
def test_a_reader_that_has_enough_is_no_failure_to_shout_about(tmp_path: Path) -> None:
    path = tmp_path / "smile.risorius"
    save_project(small_project(), path)
    reading, writing = os.pipe()
    os.close(reading)
    process = subprocess.run(
        [*RISORIUS, "info", str(path)], stdout=writing, stderr=subprocess.PIPE, text=True, check=False, cwd=Path.cwd()
    )
    os.close(writing)
    assert process.stderr == ""


@pytest.fixture
def smile(tmp_path: Path) -> Path:
    path = tmp_path / "smile.risorius"
    save_project(small_project(), path)
    return path


def test_a_picture_needs_no_display(smile: Path, tmp_path: Path) -> None:
    neutral, pucker = tmp_path / "neutral.png", tmp_path / "pucker.png"
    for out, weight in ((neutral, 0), (pucker, 1)):
        ended = run("render", smile, out, "--au", f"18={weight}", "--size", "160x120")
        assert ended.returncode == 0, ended.stderr
        assert "Traceback" not in ended.stderr
    with Image.open(neutral) as before, Image.open(pucker) as after:
        assert before.size == after.size == (160, 120)
        assert np.abs(np.asarray(before, float) - np.asarray(after, float)).max() > 5


def test_a_library_that_is_missing_is_named(smile: Path, tmp_path: Path) -> None:
    script = (
        "import sys; sys.modules['vtkmodules.vtkRenderingCore'] = None; from ui.launch import main;"
        "sys.exit(main(sys.argv[1:]))"
    )
    command = [sys.executable, "-c", script, "render", str(smile), str(tmp_path / "a.png")]
    ended = subprocess.run(command, capture_output=True, encoding="utf-8", check=False, cwd=Path.cwd())
    assert ended.returncode == 1
    assert "vtkRenderingCore" in ended.stderr.splitlines()[-1]
    assert "install libgl1" in ended.stderr.splitlines()[-1]
    assert "Traceback" not in ended.stderr
