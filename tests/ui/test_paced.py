"""What need not be seen in every frame is shown now and then, and its newest value in the end."""

import pytest
from PySide6.QtWidgets import QApplication

from ui.widgets.paced import Paced


@pytest.fixture
def shown() -> list[int]:
    return []


@pytest.fixture
def pace(qapp: QApplication, shown: list[int]) -> Paced:
    return Paced(shown.append, qapp)


def test_the_first_is_shown_at_once_and_the_newest_soon_after(pace: Paced, shown: list[int], qtbot) -> None:
    for value in range(5):
        pace.offer(value)
    assert shown == [0]
    qtbot.waitUntil(lambda: shown == [0, 4])


def test_what_cannot_wait_takes_the_place_of_what_waits(pace: Paced, shown: list[int], qtbot) -> None:
    pace.offer(1)
    pace.offer(2)
    pace.hurry(3)
    pace.offer(4)
    pace.offer(5)
    assert shown == [1, 3, 4]
    qtbot.waitUntil(lambda: shown == [1, 3, 4, 5])
