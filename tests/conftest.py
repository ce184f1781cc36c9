"""What all tests share: caches and settings of their own, so that a run neither reads nor leaves any."""

import os
import shutil
import signal
import tempfile
from pathlib import Path

import pytest

from tests import draws

draws.register()

_OWN_FOLDERS = ("XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME")

_scratch = pytest.StashKey[Path]()
_before = pytest.StashKey[dict[str, str | None]]()


def pytest_configure(config: pytest.Config) -> None:
    """Point the user's folders at scratch ones before anything is imported that reads them; one thread, as in `ui`."""
    draws.hold_still()
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # A shell starts its background jobs deaf to Ctrl+C, and the programs that tests start would inherit that.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    scratch = Path(tempfile.mkdtemp(prefix="risorius-tests-"))
    config.stash[_scratch] = scratch
    config.stash[_before] = {name: os.environ.get(name) for name in _OWN_FOLDERS}
    for name in _OWN_FOLDERS:
        os.environ[name] = str(scratch / name.lower())


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
