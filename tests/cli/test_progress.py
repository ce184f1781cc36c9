"""Progress on a terminal stays on one line and leaves nothing behind; in a file it is a few plain lines."""

import io
import re

import pytest

from app.cli.progress import ProgressLine


class Terminal(io.StringIO):
    encoding = "utf-8"

    def isatty(self) -> bool:
        return True


class OldTerminal(Terminal):
    encoding = "latin-1"


def visible(text: str) -> str:
    return re.sub(r"\x1b\[K", "", text)


def test_a_terminal_gets_one_line_that_is_taken_away(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "60")
    stream = Terminal()
    line = ProgressLine(stream)
    for step in range(5):
        line(f"Solving action units, {step} of 4, which is a text that is far too long", step / 4)
    line.clear()
    assert "\n" not in stream.getvalue()
    drawn = [part for part in visible(stream.getvalue()).split("\r") if part]
    assert all(len(part) < 60 for part in drawn)
    assert "100%" in drawn[-1]
    assert stream.getvalue().endswith("\r\x1b[K")


def test_a_terminal_without_blocks_gets_plain_characters() -> None:
    stream = OldTerminal()
    ProgressLine(stream)("Sampling", 1.0)
    assert "####" in stream.getvalue()


def test_a_file_gets_one_line_for_each_phase() -> None:
    stream = io.StringIO()
    line = ProgressLine(stream)
    for text in ("Assembling the skin", "Solving action units, 1 of 9", "Solving action units, 9 of 9"):
        line(text, 0.5)
    line.clear()
    assert stream.getvalue() == "Assembling the skin\nSolving action units\n"
