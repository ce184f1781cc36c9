"""Landmarks of a video come in wherever other recordings do: by the menu, by a script, on the command line."""

from pathlib import Path

import numpy as np
import pytest

from app.actions import Context
from app.cli import main
from app.document import Document
from app.playback import Playhead
from app.scripting import run_script
from app.timeline.exchange import Exchange
from app.timeline.timeline import Timeline
from facemodel.cache import solve_cached
from facemodel.io.project_file import load_project, save_project
from facemodel.project import Project
from facemodel.projects import new_project
from tests.animation.tracker import Shown, seen
from tests.app.conftest import small_project
from tests.app.desk import Desk
from tests.cli.test_commands import Paper
from tests.timeline.test_exchange import Asked

NEAR = 0.15
"""Of a weight, as `tests.animation.test_landmarks` says."""


@pytest.fixture(scope="module")
def ada() -> Project:
    return new_project()


@pytest.fixture(scope="module")
def smile(ada: Project, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A video of a face at rest that smiles in its last frames."""
    path = tmp_path_factory.mktemp("seen") / "smile.npz"
    frames = [*[Shown()] * 20, *[Shown({"12L": 0.6, "12R": 0.6}, (10.0, 0.0, 0.0))] * 5]
    np.savez(path, landmarks=seen(ada, solve_cached(ada), frames))
    return path


def smiles(project: Project) -> None:
    found = {track.channel: track.captured for track in project.animation.tracks}
    for name, value, near in (("12L", 0.6, NEAR), ("12R", 0.6, NEAR), ("head.yaw", 10.0, 0.5)):
        captured = found[name]
        assert captured is not None
        assert captured.values[0] == pytest.approx(0.0, abs=0.01)
        assert captured.values[-1] == pytest.approx(value, abs=near)


@pytest.mark.parametrize("solved", [True, False], ids=["of a face that is solved", "of one that is not yet"])
def test_the_menu_reads_them_and_shows_the_weights_it_found(
    ada: Project, smile: Path, context: Context, solved: bool
) -> None:
    document, asked = Document(ada), Asked()
    if solved:
        document.accept(solve_cached(ada), ada)
    exchange = Exchange(Timeline(document, Playhead(document)), context, asked)
    assert ".npz" in exchange.openers, "so that it can be dropped on the window"
    context.host.path = smile  # type: ignore[attr-defined]
    exchange.import_capture()
    exchange.close()
    ((capture, path),) = asked.captures
    assert (capture.kind, path) == ("landmarks", smile)
    assert capture.values[-1, capture.channels.index("12L")] == pytest.approx(0.6, abs=NEAR)


def test_a_face_without_landmarks_says_so(smile: Path, context: Context, desk: Desk) -> None:
    document, asked = Document(small_project()), Asked()
    exchange = Exchange(Timeline(document, Playhead(document)), context, asked)
    exchange.read_capture(smile)
    exchange.close()
    assert ["Landmarks of a tracker" in sentence for sentence in desk.errors] == [True]
    assert asked.captures == []


def test_a_script_brings_them_in_as_one_step(ada: Project, smile: Path) -> None:
    document = Document(ada)
    early = run_script(f"import_weights({str(smile)!r})", document)
    assert "The face is not solved as it is now" in early.error
    document.accept(solve_cached(ada), ada)
    outcome = run_script(f"print(import_weights({str(smile)!r}, neutral=0.3))", document)
    assert outcome.error == ""
    assert "The face is at rest at 0.30 s" in outcome.output
    smiles(document.project)
    assert len(document.history.done) == 1
    assert "ends at 0.80 s" in run_script(f"import_weights({str(smile)!r}, neutral=3)", document).error


def test_the_command_line_brings_them_in(
    ada: Project, smile: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    project, out = tmp_path / "ada.risorius", tmp_path / "smiling.risorius"
    save_project(ada, project)
    words = ["animate", project, out, "--capture", smile, "--neutral", "0.2"]
    assert main([str(word) for word in words], Paper().screen) == 0
    assert "risorius: The face is at rest at 0.20 s" in capsys.readouterr().err
    smiles(load_project(out))
    words[-1] = "soon"
    assert main([str(word) for word in words], Paper().screen) != 0
    assert "“soon” is not a number of seconds" in capsys.readouterr().err
