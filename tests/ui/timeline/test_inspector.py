"""Fields say what is chosen and change it: a drag is one step, Esc takes it back, arithmetic is understood."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit, QPushButton

from app.timeline.chosen import Chosen
from tests.ui.hands import drag
from tests.ui.timeline.stage import Stage
from ui.timeline.inspector.field import FieldBar
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_edit import NumberEdit

SUBJECTS = {
    "clip": Chosen(),
    "keys": Chosen({("12L", 0): (1,)}),
    "many keys": Chosen({("12L", 0): (0, 1), ("17", 0): (0,)}),
    "mixed keys": Chosen({("12L", 0): (0,), ("head.yaw", 0): (1,)}),
    "event": Chosen(events=frozenset(("smirk 1",))),
    "clip of events": Chosen(events=frozenset(("smirk 1", "smirk 2"))),
    "expression": Chosen(expressions=frozenset((1.0,))),
    "sound": Chosen(sounds=frozenset((1,))),
    "sounds": Chosen(sounds=frozenset((1, 2))),
    "marker": Chosen(markers=frozenset((1.5,))),
    "range": Chosen(ranges=frozenset(("Line",))),
}


def field(stage: Stage, label: str) -> NumberBar:
    found = [bar for bar in stage.panel.inspector.findChildren(NumberBar) if bar.label == label and bar.isVisible()]
    assert found, [bar.label for bar in stage.panel.inspector.findChildren(NumberBar)]
    return found[-1]


def type_into(bar: NumberBar, text: str) -> None:
    bar.edit()
    editor = bar.findChild(NumberEdit)
    editor.selectAll()
    QTest.keyClicks(editor, text)
    QTest.keyClick(editor, Qt.Key.Key_Return)


def choose(stage: Stage, chosen: Chosen) -> None:
    stage.timeline.choose(chosen)
    stage.settle()


@pytest.mark.parametrize("name", SUBJECTS)
def test_every_field_that_is_dragged_is_one_step_and_escape_takes_it_back(stage: Stage, name: str) -> None:
    choose(stage, SUBJECTS[name])
    labels = [bar.label for bar in stage.panel.inspector.page.fields if bar.isVisible() and bar.isEnabled()]
    assert labels
    for label in labels:
        bar, before = field(stage, label), stage.context.document.project
        drag(bar, 0.2, 0.6, release=False)
        QTest.keyClick(bar, Qt.Key.Key_Escape)
        assert stage.context.document.history.done == (), label
        drag(bar, 0.25, 0.55)
        assert len(stage.steps) <= 1, label
        stage.context.document.undo()
        assert stage.context.document.project.animation.tracks == before.animation.tracks or not stage.steps
        choose(stage, SUBJECTS[name])


def test_the_value_of_several_keys_is_typed_once_for_all(stage: Stage) -> None:
    choose(stage, SUBJECTS["many keys"])
    type_into(field(stage, "Value"), "0.5/2")
    assert stage.curve("12L").values[:2].tolist() == [0.25, 0.25]
    assert stage.curve("17").values[0] == 0.25
    assert stage.steps == ("Value",)


def test_a_time_is_typed_as_people_write_it(stage: Stage) -> None:
    choose(stage, SUBJECTS["keys"])
    type_into(field(stage, "Time"), "00:00:01:15")
    assert stage.curve("12L").times[1] == pytest.approx(1.5)
    stage.settle()
    type_into(field(stage, "Time"), "36f")
    assert stage.curve("12L").times[1] == pytest.approx(1.2)


def test_the_six_parameters_of_an_event_are_fields(stage: Stage) -> None:
    choose(stage, SUBJECTS["event"])
    for label, member, text in (
        ("Onset latency", "onset", "0.05"),
        ("Acceleration", "acceleration", "2"),
        ("Peak amplitude", "amplitude", "80%"),
        ("Peak latency", "peak", "0.4"),
        ("Deceleration", "deceleration", "3"),
        ("Offset latency", "offset", "1.1"),
    ):
        type_into(field(stage, label), text)
        event = next(each for each in stage.animation.events if each.key == "smirk 1")
        assert getattr(event, member) == pytest.approx(float(text.rstrip("%")) / (100 if "%" in text else 1))
    assert len(stage.steps) == 6


def test_shapes_and_flags_are_buttons(stage: Stage) -> None:
    choose(stage, SUBJECTS["keys"])
    page = stage.panel.inspector.page
    QTest.mouseClick(page.shapes["bezier"], Qt.MouseButton.LeftButton)
    stage.settle()
    assert page.shapes["bezier"].isChecked()
    QTest.mouseClick(page.weighted, Qt.MouseButton.LeftButton)
    QTest.mouseClick(page.broken, Qt.MouseButton.LeftButton)
    assert bool(stage.curve("12L").weighted[1])
    assert bool(stage.curve("12L").broken[1])
    page.ease.setCurrentIndex(3)
    page.ease.activated.emit(3)
    assert len(stage.steps) == 4


@pytest.mark.parametrize(
    ("name", "read"),
    [
        ("expression", lambda animation: animation.expressions[0].name),
        ("marker", lambda animation: animation.markers[0].name),
        ("range", lambda animation: animation.ranges[0].name),
        ("sound", lambda animation: animation.speech.phonemes[1].symbol),
    ],
)
def test_names_are_typed(stage: Stage, name: str, read) -> None:
    choose(stage, SUBJECTS[name])
    line = stage.panel.inspector.page.findChild(QLineEdit)
    line.selectAll()
    QTest.keyClicks(line, "IY")
    QTest.keyClick(line, Qt.Key.Key_Return)
    assert read(stage.animation) == "IY"
    assert len(stage.steps) == 1


@pytest.mark.parametrize(
    ("line", "label"),
    [("layer 26 1", "Knot spacing"), ("life", "Blinks"), ("speech", "Strength"), ("audio", "Start")],
)
def test_a_chosen_line_has_fields_of_its_own(stage: Stage, line: str, label: str) -> None:
    stage.timeline.change(lines=frozenset((line,)))
    stage.settle()
    before = stage.animation
    drag(field(stage, label), 0.3, 0.7)
    assert stage.animation is not before
    assert stage.steps == (label,)


def test_a_page_about_speech_leads_to_its_dialogs(stage: Stage) -> None:
    stage.timeline.change(lines=frozenset(("speech",)))
    stage.settle()
    for button in stage.panel.inspector.page.findChildren(QPushButton):
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert stage.opened == ["type", "visemes"]


@pytest.mark.parametrize("key", ["simplify", "smooth", "bake-keys", "bake-samples", "warp", "offset", "loop"])
def test_what_is_done_to_curves_is_seen_at_once_and_kept_or_dropped(stage: Stage, key: str) -> None:
    before = stage.animation
    stage.timeline.change(page=key, lines=frozenset(("track 26",)))
    stage.settle()
    page = stage.panel.inspector.page
    bar = next(iter(page.bars.values()))
    drag(bar, 0.3, 0.6)
    assert stage.animation.track("26") is not before.track("26")
    apply, cancel = page.findChildren(QPushButton)
    QTest.mouseClick(cancel, Qt.MouseButton.LeftButton)
    assert stage.steps == ()
    assert stage.animation.track("26") is before.track("26")
    stage.timeline.change(page=key)
    stage.settle()
    apply, _ = stage.panel.inspector.page.findChildren(QPushButton)
    drag(next(iter(stage.panel.inspector.page.bars.values())), 0.3, 0.7)
    QTest.mouseClick(apply, Qt.MouseButton.LeftButton)
    assert len(stage.steps) == 1
    assert stage.timeline.state.page == ""


def test_choosing_something_else_takes_a_preview_back(stage: Stage) -> None:
    before = stage.animation.track("26")
    stage.timeline.change(page="smooth", lines=frozenset(("track 26",)))
    stage.settle()
    drag(next(iter(stage.panel.inspector.page.bars.values())), 0.3, 0.7)
    stage.click(stage.at("track 17", 1.0))
    stage.settle()
    assert stage.timeline.state.page == ""
    assert stage.animation.track("26") is before


def test_fields_follow_what_hands_do_elsewhere(stage: Stage) -> None:
    choose(stage, SUBJECTS["keys"])
    stage.drag(stage.at("track 12L", 1.0), stage.at("track 12L", 1.5))
    stage.settle()
    assert field(stage, "Time").value == pytest.approx(1.5, abs=0.02)
    stage.context.document.undo()
    stage.settle()
    assert field(stage, "Time").value == 1.0


def test_the_fields_make_way_and_come_when_asked(stage: Stage) -> None:
    stage.window.resize(640, 500)
    stage.settle()
    assert not stage.panel.inspector.isVisible()
    QTest.mouseClick(stage.transport.fields, Qt.MouseButton.LeftButton, pos=QPoint(8, 8))
    assert stage.panel.inspector.isVisible()
    assert isinstance(stage.panel.inspector.page.fields[0], FieldBar)
