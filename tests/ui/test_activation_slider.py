"""A bar that is dragged, typed into and stepped through."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QVBoxLayout, QWidget

from tests.ui.hands import drag
from ui.widgets.activation_slider import ActivationSlider

LEFT = Qt.MouseButton.LeftButton
CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


class Heard:
    """What a slider said, in order."""

    def __init__(self, slider: ActivationSlider) -> None:
        self.weights: list[float] = []
        self.ends: list[str] = []
        slider.previewed.connect(self.weights.append)
        slider.committed.connect(lambda: self.ends.append("committed"))
        slider.cancelled.connect(lambda: self.ends.append("cancelled"))


@pytest.fixture
def slider(shown) -> ActivationSlider:
    slider = ActivationSlider("Lip corner puller")
    slider.resize(200, 24)
    return shown(slider)


@pytest.fixture
def heard(slider) -> Heard:
    return Heard(slider)


def test_the_fill_follows_the_pointer_and_release_commits_once(slider, heard):
    drag(slider, 0.1, 0.6)
    assert slider.weight == pytest.approx(0.5, abs=0.01)
    assert heard.weights == sorted(heard.weights)
    assert heard.ends == ["committed"]


def test_a_drag_starts_from_the_weight_wherever_it_is_taken(slider, heard):
    slider.set_weight(0.5)
    drag(slider, 0.9, 0.7)
    assert slider.weight == pytest.approx(0.3, abs=0.01)


def test_a_click_changes_nothing(slider, heard):
    QTest.mouseClick(slider, Qt.MouseButton.LeftButton, pos=QPoint(150, 12))
    assert (slider.weight, heard.weights, heard.ends) == (0.0, [], [])


def test_full_is_the_end_unless_ctrl_is_held(slider, heard):
    drag(slider, 0.0, 3.0)
    assert slider.weight == 1.0
    drag(slider, 0.0, 0.5, CTRL)
    assert slider.weight == pytest.approx(1.5, abs=0.01)
    drag(slider, 0.0, 9.0, CTRL)
    assert slider.weight == 2.0


def test_an_exaggerated_weight_can_be_lowered_without_ctrl(slider, heard):
    slider.set_weight(1.6)
    drag(slider, 0.5, 0.4)
    assert slider.weight == pytest.approx(1.5, abs=0.01)


def test_shift_is_ten_times_finer(slider, heard):
    drag(slider, 0.0, 0.5, SHIFT)
    assert slider.weight == pytest.approx(0.05, abs=0.002)


def test_escape_restores_what_was(slider, heard):
    slider.set_weights(0.2, 0.4)
    drag(slider, 0.0, 0.5, release=False)
    assert slider.weight > 0.8
    QTest.keyClick(slider, Qt.Key.Key_Escape)
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=QPoint(100, 12))
    assert slider.number == "0.20 · 0.40"
    assert heard.ends == ["cancelled"]


def test_a_held_arrow_is_one_gesture(slider, heard):
    slider.setFocus()
    for _ in range(3):
        QTest.keyPress(slider, Qt.Key.Key_Right)
    assert heard.ends == []
    QTest.keyRelease(slider, Qt.Key.Key_Right)
    assert heard.weights == [0.05, 0.1, 0.15]
    assert heard.ends == ["committed"]


@pytest.mark.parametrize(
    ("key", "modifier", "weight"),
    [
        (Qt.Key.Key_Right, Qt.KeyboardModifier.NoModifier, 0.55),
        (Qt.Key.Key_Left, Qt.KeyboardModifier.NoModifier, 0.45),
        (Qt.Key.Key_Left, SHIFT, 0.49),
        (Qt.Key.Key_PageUp, Qt.KeyboardModifier.NoModifier, 0.7),
        (Qt.Key.Key_Home, Qt.KeyboardModifier.NoModifier, 0.0),
        (Qt.Key.Key_End, Qt.KeyboardModifier.NoModifier, 1.0),
        (Qt.Key.Key_Backspace, Qt.KeyboardModifier.NoModifier, 0.0),
    ],
)
def test_keys_step_the_weight(slider, heard, key, modifier, weight):
    slider.set_weight(0.5)
    QTest.keyClick(slider, key, modifier)
    assert slider.weight == pytest.approx(weight)
    assert heard.ends == ["committed"]


@pytest.mark.parametrize(
    ("typed", "weight"), [("0.25", 0.25), ("80%", 0.8), ("1/3", 1 / 3), ("0.5+0.1", 0.6), ("7", 2.0), ("-1", 0.0)]
)
def test_a_double_click_takes_arithmetic(slider, heard, typed, weight):
    QTest.mouseDClick(slider, Qt.MouseButton.LeftButton, pos=QPoint(50, 12))
    edit = slider.findChild(QLineEdit)
    QTest.keyClicks(edit, typed)
    QTest.keyClick(edit, Qt.Key.Key_Return)
    assert slider.weight == pytest.approx(weight)
    assert heard.ends == ["committed"]


def test_the_keyboard_goes_where_it_is_asked_to_when_a_number_is_left(shown):
    both = QWidget()
    slider, other = ActivationSlider("Lip corner puller"), QLineEdit()
    column = QVBoxLayout(both)
    column.addWidget(slider)
    column.addWidget(other)
    shown(both)
    for typed, leave in (
        ("0.4", lambda _: QTest.mouseClick(other, LEFT)),
        ("oops", lambda _: QTest.mouseClick(other, LEFT)),
        ("0.6", lambda edit: QTest.keyClick(edit, Qt.Key.Key_Tab)),
    ):
        slider.setFocus()
        QTest.keyClick(slider, Qt.Key.Key_Return)
        edit = both.focusWidget()
        QTest.keyClicks(edit, typed)
        leave(edit)
        assert both.focusWidget() is other
    assert slider.weight == pytest.approx(0.6)


def test_nonsense_stays_open_and_escape_leaves_the_weight(slider, heard):
    slider.set_weight(0.4)
    slider.edit()
    edit = slider.findChild(QLineEdit)
    QTest.keyClicks(edit, "much")
    QTest.keyClick(edit, Qt.Key.Key_Return)
    assert edit.isVisible()
    assert edit.property("wrong") is True
    QTest.keyClick(edit, Qt.Key.Key_Escape)
    assert not edit.isVisible()
    assert (slider.weight, heard.weights, heard.ends) == (0.4, [], [])


def test_a_right_click_resets(slider, heard, qtbot):
    slider.set_weight(0.7)
    QTest.mouseClick(slider, Qt.MouseButton.RightButton, pos=QPoint(50, 12))
    QApplication.processEvents()
    assert slider.weight == 0.0
    assert heard.ends == ["committed"]


def test_the_wheel_is_left_to_the_panel(slider, heard, qtbot):
    slider.set_weight(0.7)
    turned = wheel(slider)
    QApplication.sendEvent(slider, turned)
    assert not turned.isAccepted()
    assert slider.weight == 0.7


def wheel(widget):
    place = QPointF(widget.rect().center())
    return QWheelEvent(
        place,
        QPointF(widget.mapToGlobal(widget.rect().center())),
        QPoint(0, 0),
        QPoint(0, 120),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )


def test_assistive_technology_reads_and_sets_percent(slider, heard):
    slider.set_weight(0.8)
    assert (slider.accessibleName(), slider.value()) == ("Lip corner puller", 80)
    slider.setValue(30)
    assert slider.weight == 0.3
    assert heard.ends == ["committed"]


def test_showing_a_weight_says_nothing(slider, heard):
    slider.set_weight(0.8)
    assert heard.weights == []


def test_more_weight_is_more_fill(slider):
    def coloured() -> int:
        picture = slider.grab().toImage()
        ground = picture.pixelColor(picture.width() - 4, 4)
        return sum(picture.pixelColor(x, 4) != ground for x in range(4, picture.width() - 4))

    slider.set_weight(0.25)
    quarter = coloured()
    slider.set_weight(0.75)
    assert coloured() - quarter == pytest.approx(0.5 * slider.width(), abs=4)
