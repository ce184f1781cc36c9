"""The console does what the mouse does: typed, run as one step, taken back by the usual keys."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest

from tests.ui.hands import drag
from tests.ui.window.seen import points
from ui.panels.console_panel import EXAMPLES, GOES_ON, PROMPT, WELCOME, ConsolePanel
from ui.window.main_window import MainWindow

CTRL = Qt.KeyboardModifier.ControlModifier
Key = Qt.Key


@pytest.fixture
def console(qtbot, window: MainWindow) -> ConsolePanel:
    """Open the console from the menu, which puts the keyboard into it."""
    dock = window.docks["console"]
    assert not dock.isVisible()
    dock.toggleViewAction().trigger()
    panel = dock.widget()
    qtbot.waitUntil(panel.line.hasFocus)
    return panel


def test_the_palette_opens_it(qtbot, window) -> None:
    QTest.keyClick(window, Key.Key_P, CTRL | Qt.KeyboardModifier.ShiftModifier)
    qtbot.waitUntil(window.palette_box.isVisible)
    QTest.keyClicks(window.palette_box.focusWidget(), "console")
    QTest.keyClick(window.palette_box.focusWidget(), Key.Key_Return)
    qtbot.waitUntil(window.docks["console"].widget().line.hasFocus)


def enter(console: ConsolePanel, *lines: str) -> str:
    """Type lines; what is told about them, without what was typed."""
    before = len(console.output.toPlainText())
    for line in lines:
        QTest.keyClicks(console.line, line)
        QTest.keyClick(console.line, Key.Key_Return)
    told = console.output.toPlainText()[before:].splitlines()
    return "\n".join(line for line in told if not line.startswith((PROMPT, GOES_ON)))


def test_an_entry_is_one_step_and_undo_takes_it_back(qtbot, window, document, console) -> None:
    before = document.project
    assert enter(console, "au(12).weight = 0.5; au(17).weight = 0.25") == ""
    assert document.project.expression == {"12L": 0.5, "12R": 0.5, "17": 0.25}
    assert window.expression.rows[17].slider.weight == 0.25
    qtbot.waitUntil(window.binding.qt["edit.undo"].isEnabled)
    QTest.keyClick(console.line, Key.Key_Z, CTRL)
    assert document.project.expression == before.expression
    assert document.history.to_undo is None


def test_what_it_proposes_works(window, document, console) -> None:
    assert console.output.placeholderText() == WELCOME
    told = enter(console, *EXAMPLES)
    assert "stopped" not in told
    assert told.splitlines()[-1].strip("'") == "6L=1.0 6R=1.0 12L=1.0 12R=1.0"
    assert "au(12): lip corner puller, 12L, 12R" in told
    assert "zygomaticus_major_L" in told


def test_values_are_shown_and_names_stay(console) -> None:
    assert enter(console, "w = 0.25", "w * 2") == "0.5"


def test_it_sees_what_the_mouse_did(window, document, console) -> None:
    drag(window.expression.rows[17].slider, 0.0, 0.5)
    assert float(enter(console, "au(17).weight")) == document.shown["17"] > 0


def test_an_error_is_one_sentence_and_changes_nothing(document, console) -> None:
    before = document.project
    told = enter(console, "au(12).weight = 0.5; au(99)")
    assert told.startswith("The script stopped at line 1: There is no action unit “99”")
    assert document.project is before


def test_a_block_goes_on_until_an_empty_line(document, console) -> None:
    enter(console, "for n in (12, 17):", "    au(n).weight = 0.5")
    assert console.prompt.text() == GOES_ON
    assert document.project.expression == {}
    enter(console, "")
    assert console.prompt.text() == PROMPT
    assert set(document.project.expression) == {"12L", "12R", "17"}
    assert len(document.history.done) == 1


def test_escape_leaves_a_block(document, console) -> None:
    enter(console, "for n in (12, 17):")
    QTest.keyClick(console.line, Key.Key_Escape)
    assert enter(console, "1 + 1") == "2"


def test_a_pasted_script_runs_as_a_whole(document, console) -> None:
    QGuiApplication.clipboard().setText("for n in (12, 17):\n    au(n).weight = 0.5\nprint('done')")
    QTest.keyClick(console.line, Key.Key_V, CTRL)
    QTest.keyClick(console.line, Key.Key_Return)
    assert console.output.toPlainText().splitlines()[-1] == "done"
    assert len(document.history.done) == 1


def test_up_and_down_go_through_what_was_entered(console) -> None:
    enter(console, "1 + 1", "2 + 2")
    QTest.keyClicks(console.line, "draft")
    seen = []
    for key in (Key.Key_Up, Key.Key_Up, Key.Key_Up, Key.Key_Down, Key.Key_Down):
        QTest.keyClick(console.line, key)
        seen.append(console.line.text())
    assert seen == ["2 + 2", "1 + 1", "1 + 1", "2 + 2", "draft"]


def test_the_pure_linear_sum_is_shown_and_left_again_without_a_step(qtbot, window, document, console) -> None:
    document.set_weights({"24": 1.0, "17": 1.0})
    kept, steps = points(window), document.history.done
    switch = window.binding.qt["view.linear"]
    assert enter(console, "linear_sum()") == ""
    qtbot.waitUntil(switch.isChecked)
    straight = points(window)
    assert np.abs(straight - kept).max() > 0.5
    assert "stopped" in enter(console, "linear_sum(False); au('nobody')")
    assert np.abs(points(window) - straight).max() < 1e-4
    assert enter(console, "linear_sum(False)") == ""
    qtbot.waitUntil(lambda: not switch.isChecked())
    assert np.abs(points(window) - kept).max() < 1e-4
    assert document.history.done == steps
