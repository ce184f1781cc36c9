"""What need not be seen in every frame is shown now and then, and its newest value in the end."""

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QApplication

from ui.widgets.paced import Paced


def test_every_value_is_shown_as_it_comes(qapp: QApplication) -> None:
    shown: list[int] = []
    pace = Paced(shown.append, qapp)
    for value in range(3):
        pace.offer(value)
    assert shown == [0, 1, 2]


def test_while_it_is_slow_only_the_first_and_the_newest_are_shown(qapp: QApplication) -> None:
    shown: list[int] = []
    home = QObject()
    pace = Paced(shown.append, home)
    pace.be_slow(True)
    for value in range(5):
        pace.offer(value)
    assert shown == [0]
    pace.be_slow(False)
    assert shown == [0, 4]
    pace.offer(5)
    assert shown == [0, 4, 5]


def test_what_waits_is_shown_in_its_time(qapp: QApplication, qtbot) -> None:
    shown: list[int] = []
    pace = Paced(shown.append, qapp)
    pace.be_slow(True)
    pace.offer(1)
    pace.offer(2)
    qtbot.waitUntil(lambda: shown == [1, 2])
