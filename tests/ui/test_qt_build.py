"""The Qt that is installed must not eat Python's own singletons, or the editor dies after some thousand calls."""

import sys
from collections.abc import Callable

import pytest
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QApplication, QWidget

CALLS = 400


class Bell(QObject):
    rung = Signal()


def references_lost(call: Callable[[], object], singleton: object) -> int:
    """Return how many references to None, True or False go while something is called."""
    before = sys.getrefcount(singleton)
    for _ in range(CALLS):
        call()
    return before - sys.getrefcount(singleton)


@pytest.mark.parametrize("singleton", [None, True, False])
def test_calls_and_signals_take_no_references_away(qapp: QApplication, singleton: object) -> None:
    widget, bell = QWidget(), Bell()
    assert references_lost(widget.update, singleton) < CALLS / 2
    assert references_lost(bell.rung.emit, singleton) < CALLS / 2
