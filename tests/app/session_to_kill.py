"""A session that works until it is killed; the test that starts it says in which folder, and reads what it prints."""

import itertools
import queue
import sys
from collections.abc import Callable
from pathlib import Path

from app.autosave import Autosave
from app.document import Document
from tests.app.conftest import small_project


def work(folder: Path) -> None:
    """Move a slider for ever; print the time of each state that the journal has."""
    document = Document(small_project())
    inbox: queue.Queue[Callable[[], None]] = queue.Queue()
    autosave = Autosave(document, inbox.put, folder, delay=0.02)
    autosave.written.connect(lambda when: print(when.timestamp(), flush=True))
    for step in itertools.count(1):
        document.set_weights({"17": (step % 200 + 1) / 200})
        try:
            inbox.get(timeout=0.01)()
        except queue.Empty:
            continue


if __name__ == "__main__":
    work(Path(sys.argv[1]))
