"""Ctrl+C while something is learned: once it is a request, twice it ends the program."""

import signal

import pytest

from app.cli.stopping import Stopping
from facemodel.solution import Cancelled


def test_ctrl_c_ends_the_next_step_and_no_other() -> None:
    said: list[str] = []
    with Stopping(lambda text, _share: said.append(text)) as told:
        told("learning", 0.1)
        signal.raise_signal(signal.SIGINT)
        with pytest.raises(Cancelled):
            told("still learning", 0.2)
        told("comparing", 0.9)
    assert said == ["learning", "still learning", "comparing"]


def test_pressed_again_it_does_not_wait() -> None:
    with Stopping(lambda _text, _share: None):
        signal.raise_signal(signal.SIGINT)
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)


def test_afterwards_ctrl_c_is_what_it_was() -> None:
    before = signal.getsignal(signal.SIGINT)
    with Stopping(lambda _text, _share: None):
        assert signal.getsignal(signal.SIGINT) is not before
    assert signal.getsignal(signal.SIGINT) is before
