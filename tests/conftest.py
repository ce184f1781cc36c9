"""What all tests share: caches and settings of their own, so that a run neither reads nor leaves any."""

import gc
import os
import shutil
import signal
import tempfile
from pathlib import Path
from typing import Any

import pytest

from tests import draws

draws.register()

_SHARED = "XDG_CACHE_HOME"
_OWN = ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME")

_scratch = pytest.StashKey[Path]()
_before = pytest.StashKey[dict[str, str | None]]()


def pytest_configure(config: pytest.Config) -> None:
    """Point the user's folders at scratch ones before anything is imported that reads them; one thread, as in `ui`."""
    draws.hold_still()
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # A shell starts its background jobs deaf to Ctrl+C, and the programs that tests start would inherit that.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    config.stash[_before] = {name: os.environ.get(name) for name in (_SHARED, *_OWN)}
    run, own = _folders(config)
    config.stash[_scratch] = own
    os.environ[_SHARED] = str(run / _SHARED.lower())
    for name in _OWN:
        os.environ[name] = str(own / name.lower())


def _folders(config: pytest.Config) -> tuple[Path, Path]:
    """The scratch folder of this run, and that of this process in it; faces are solved once for all processes."""
    worker: dict[str, Any] | None = getattr(config, "workerinput", None)
    if worker is None:
        run = Path(tempfile.mkdtemp(prefix="risorius-tests-"))
        return run, run
    run = Path(worker["scratch"])
    own = run / worker["workerid"]
    own.mkdir()
    return run, own


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: Any) -> None:
    """Tell another process of this run where the run's scratch folder is."""
    node.workerinput["scratch"] = str(node.config.stash[_scratch])


def pytest_collection_finish() -> None:
    """Leave what stays to the end out of every later search for garbage; windows have it searched when they close."""
    gc.collect()
    gc.freeze()


def pytest_unconfigure(config: pytest.Config) -> None:
    """Put the environment back and remove the scratch folders."""
    for name, value in config.stash[_before].items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value
    shutil.rmtree(config.stash[_scratch])


@pytest.fixture(scope="session")
def repository() -> Path:
    """Return the root of the repository."""
    return Path(__file__).resolve().parent.parent
