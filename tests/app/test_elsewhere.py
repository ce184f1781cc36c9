"""An export in a process of its own is the export that the editor would have made, and can be stopped at any time."""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from app.film.elsewhere import WORKER, Errand, run_errand
from app.film.film import Film, FilmError
from app.film.order import KINDS, Order, kind_of, order_of
from facemodel.io.export import EXPORTS, Asked, export_project
from facemodel.io.film import FILMS
from facemodel.io.weights.writing import WEIGHT_EXPORTS
from facemodel.solution import Cancelled
from tests.io.animated import PROJECT, SOLUTION


@pytest.fixture(autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RISORIUS_CACHE", str(tmp_path_factory.mktemp("cache")))


def errand(out: Path, asked: Asked = Asked(), film: Film = Film()) -> Errand:  # noqa: B008 - frozen values
    return Errand(Order(out, kind_of(out).key, film, asked), PROJECT, SOLUTION, out.parent)


def test_it_writes_what_the_editor_would_have_written(tmp_path: Path) -> None:
    seen: list[tuple[str, float]] = []
    said = run_errand(errand(tmp_path / "there.glb"), lambda text, share: seen.append((text, share)))
    assert said == export_project(PROJECT, SOLUTION, tmp_path / "here.glb")
    assert (tmp_path / "there.glb").read_bytes() == (tmp_path / "here.glb").read_bytes()
    assert [share for _, share in seen] == sorted(share for _, share in seen)
    assert seen[-1][0] == "Fitting shapes, frame 13 of 13"


def test_a_sequence_is_counted(tmp_path: Path) -> None:
    assert run_errand(errand(tmp_path / "face.obj", Asked(span=(0.0, 0.5)))) == "7 numbered files"
    assert len(os.listdir(tmp_path)) == 7


def test_a_failure_is_told_as_it_was_said(tmp_path: Path) -> None:
    with pytest.raises(FilmError, match=r"none.*there is no folder"):
        run_errand(errand(tmp_path / "none" / "face.glb"))


def test_it_stops_when_it_is_told_to_and_leaves_nothing(tmp_path: Path) -> None:
    def cancel(text: str, _share: float) -> None:
        if text.startswith("Writing frames, 3"):
            raise Cancelled

    with pytest.raises(Cancelled):
        run_errand(errand(tmp_path / "face.obj", Asked(rate=120.0)), cancel)
    assert os.listdir(tmp_path) == []


def test_it_stops_when_the_editor_is_gone(tmp_path: Path) -> None:
    """Killed, an editor says nothing to anybody; the pipe breaks, and that is enough."""
    room, out = tmp_path / "room", tmp_path / "out"
    room.mkdir()
    out.mkdir()
    script = (
        "import os\nfrom pathlib import Path\n"
        "from tests.app.test_elsewhere import errand, run_errand\n"
        "from facemodel.io.export import Asked\n"
        "def die(text, share):\n    if text.startswith('Writing frames, 2'): os._exit(9)\n"
        f"run_errand(errand(Path({str(out / 'face.obj')!r}), Asked(rate=120.0)), die)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        check=False,
        cwd=Path.cwd(),
        env={**os.environ, "TMPDIR": str(room)},
    )
    assert done.returncode == 9, done.stderr
    ends = time.monotonic() + 30
    while os.listdir(out) and time.monotonic() < ends:
        time.sleep(0.05)
    assert os.listdir(out) == []
    assert os.listdir(room) == []


def test_a_process_that_ends_by_itself_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.film.elsewhere.WORKER", "there.is.no.such.module")
    with pytest.raises(FilmError, match=r"ended before it was done \(.*there\.is\.no\.such\.module.*once more"):
        run_errand(errand(tmp_path / "face.glb"))


def test_the_worker_is_where_it_is_said_to_be(repository: Path) -> None:
    assert (repository / Path(*WORKER.split("."))).with_suffix(".py").exists()


@pytest.mark.parametrize("film", [Film(), Film((64, 48), 60.0, (0.5, 1.5), "left", True, -1.0, "off", False, "light")])
@pytest.mark.parametrize("asked", [Asked(), Asked(False, 24.0, (0.0, 1.0), "clip", 8)])
def test_an_order_survives_its_way_to_another_process(film: Film, asked: Asked) -> None:
    order = Order(Path("/tmp/ü b.mp4"), ".mp4", film, asked)
    assert order_of(json.loads(json.dumps(order.as_json()))) == order


def test_every_format_that_can_hold_an_animation_can_be_ordered() -> None:
    able = {suffix for suffix, each in EXPORTS.items() if each.animates or each.frame is not None}
    assert set(KINDS) == able | set(FILMS) | set(WEIGHT_EXPORTS)
