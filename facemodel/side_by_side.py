"""Two things at once: a second thread takes what it has begun before the first one is through with its own."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, wait
from typing import TypeVar

Mine = TypeVar("Mine")
Other = TypeVar("Other")

_second = ThreadPoolExecutor(1, thread_name_prefix="side-by-side")


def side_by_side(mine: Callable[[], Mine], other: Callable[[], Other]) -> tuple[Mine, Other]:
    """What both give, the other one done in a second thread if a core is free for it.

    If the second thread has not begun when the first is through, its part is taken back: nobody waits for a core that
    is busy.  Both are to write in different places, and to spend their time where other threads may run.
    """
    there = _second.submit(other)
    try:
        made = mine()
    finally:
        taken_back = there.cancel()
        if not taken_back:
            wait([there])
    return made, other() if taken_back else there.result()
