"""The panel and the document, bound both ways."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit

from app.authoring.intensities import with_letters
from app.authoring.units import with_limit
from app.document import Document
from app.view import View
from facemodel.actions import Emotion
from tests.ui.hands import drag, enter, leave, move
from tests.ui.test_small_parts import read
from ui.panels.emotion_match import shown_strength
from ui.panels.expression_panel import ExpressionPanel
from ui.panels.unit_text import muscle_titles, unit_matches, unit_tooltip


@pytest.fixture
def panel(shown, document, view, portraits) -> ExpressionPanel:
    panel = ExpressionPanel(document, view, portraits)
    panel.resize(360, 700)
    return shown(panel)


def visible(panel: ExpressionPanel) -> set[int]:
    return {number for number, row in panel.rows.items() if row.isVisibleTo(panel)}


def test_a_drag_previews_and_release_is_one_step_that_undo_takes_back(panel, document):
    drag(panel.rows[17].slider, 0.1, 0.6, release=False)
    held = document.shown["17"]
    assert held == pytest.approx(0.5, abs=0.01)
    assert document.project.expression == {}
    drag(panel.rows[17].slider, 0.1, 0.6)
    assert document.history.done == ("Chin raiser",)
    document.undo()
    assert panel.rows[17].slider.weight == 0.0
    document.redo()
    assert panel.rows[17].slider.weight == document.project.expression["17"]


def test_escape_in_a_drag_leaves_no_step_and_the_old_weight(panel, document):
    document.set_weights({"17": 0.3})
    slider = panel.rows[17].slider
    drag(slider, 0.1, 0.9, release=False)
    QTest.keyClick(slider, Qt.Key.Key_Escape)
    assert document.shown == {"17": 0.3}
    assert slider.weight == 0.3
    assert len(document.history.done) == 1


def test_one_bar_drives_both_sides(panel, document):
    drag(panel.rows[12].slider, 0.0, 0.5)
    assert document.shown["12L"] == document.shown["12R"] == pytest.approx(0.5, abs=0.01)
    assert len(document.history.done) == 1


def test_the_split_row_moves_one_side_alone_and_its_bar_shows_both(panel, document):
    row = panel.rows[12]
    QTest.mouseClick(row.split, Qt.MouseButton.LeftButton)
    left, right = row.sides
    drag(left, 0.0, 0.5)
    assert document.shown["12L"] == pytest.approx(0.5, abs=0.02)
    assert document.shown.get("12R", 0.0) == 0.0
    assert right.weight == 0.0
    assert row.slider.number == f"C {document.shown['12L']:.2f} · 0.00"


def test_linked_sides_follow_each_other_even_where_a_row_is_split(panel, document, view):
    row = panel.rows[12]
    QTest.mouseClick(row.split, Qt.MouseButton.LeftButton)
    assert not view.state.linked
    QTest.mouseClick(panel.link, Qt.MouseButton.LeftButton)
    assert view.state.linked
    drag(row.sides[1], 0.0, 0.4)
    assert document.shown["12L"] == document.shown["12R"] > 0.3


def test_a_unit_without_sides_offers_no_split(panel):
    assert not panel.rows[17].split.isVisibleTo(panel)
    assert panel.rows[12].split.isVisibleTo(panel)


def test_reset_is_there_once_something_changed_and_relaxes_that_row_alone(panel, document):
    row = panel.rows[17]
    assert not row.clear.isVisibleTo(panel)
    document.set_weights({"17": 0.4, "26": 0.5})
    assert row.changed
    QTest.mouseClick(row.clear, Qt.MouseButton.LeftButton)
    assert document.shown == {"26": 0.5}


def test_reset_all_relaxes_the_face(panel, document):
    document.set_weights({"17": 0.4, "26": 0.5})
    QTest.mouseClick(panel.reset, Qt.MouseButton.LeftButton)
    assert not any(document.shown.values())
    assert not panel.reset.isEnabled()


@pytest.mark.parametrize(
    ("query", "found"),
    [
        ("", {12, 20, 17, 26}),
        ("12", {12}),
        ("AU17", {17}),
        ("12L", {12}),
        ("lip", {12, 20}),
        ("corner lip", {12}),
        ("zygo", {12, 20, 17}),
        ("jaw", {26}),
        ("2", set()),
        ("nose", set()),
    ],
)
def test_the_search_finds_by_number_name_and_muscle(panel, query, found):
    QTest.keyClicks(panel.search, query)
    assert visible(panel) == found
    groups = {panel.rows[number].unit.group for number in found}
    assert {key for key, group in panel.groups.items() if group.isVisibleTo(panel)} == groups


def test_escape_empties_the_search_and_enter_goes_to_the_first_bar(panel):
    QTest.keyClicks(panel.search, "jaw")
    QTest.keyClick(panel.search, Qt.Key.Key_Return)
    assert panel.rows[26].slider.hasFocus()
    panel.focus_search()
    QTest.keyClick(panel.search, Qt.Key.Key_Escape)
    assert len(visible(panel)) == 4


def test_a_group_folds_and_tells_so_and_a_search_looks_into_it(panel):
    told = []
    panel.folds_changed.connect(told.append)
    QTest.mouseClick(panel.groups["jaw"].heading, Qt.MouseButton.LeftButton)
    assert told == [frozenset({"jaw"})]
    assert 26 not in visible(panel)
    QTest.keyClicks(panel.search, "jaw")
    assert 26 in visible(panel)
    panel.search.clear()
    assert 26 not in visible(panel)


def test_a_click_on_an_emotion_is_one_step_to_all_of_it_and_another_click_relaxes(panel, document):
    button = panel.emotions.buttons["happiness"]
    document.set_weights({"17": 0.4})
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert {name: w for name, w in document.shown.items() if w} == {"12L": 0.9, "12R": 0.9}
    assert (button.strength, button.isChecked()) == (1.0, True)
    assert len(document.history.done) == 2
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert not any(document.shown.values())


def test_a_drag_across_an_emotion_sets_its_strength(panel, document):
    button = panel.emotions.buttons["happiness"]
    drag(button, 0.2, 0.5)
    assert button.strength == pytest.approx(0.5, abs=0.02)
    assert document.shown["12L"] == pytest.approx(0.9 * button.strength)
    assert len(document.history.done) == 1


@pytest.mark.parametrize("right", [False, True], ids=["esc", "right button"])
def test_a_drag_across_an_emotion_is_taken_back(panel, document, right):
    document.set_weights({"17": 0.4})
    button = panel.emotions.buttons["surprise"]
    button.setFocus()
    drag(button, 0.2, 0.8, release=False)
    assert "26" in document.shown
    if right:
        QTest.mouseClick(button, Qt.MouseButton.RightButton)
    else:
        QTest.keyClick(button, Qt.Key.Key_Escape)
    assert document.shown == {"17": 0.4}
    move(button, QPoint(button.width() // 2, 5))
    QTest.mouseRelease(button, Qt.MouseButton.LeftButton)
    assert document.shown == {"17": 0.4}
    assert len(document.history.done) == 1


def test_the_strength_bar_scales_the_emotion_that_is_on(panel, document):
    assert not panel.emotions.strength.isEnabled()
    document.apply_emotion("happiness")
    assert panel.emotions.strength.isEnabled()
    drag(panel.emotions.strength, 0.9, 0.4)
    assert document.shown["12R"] == pytest.approx(0.45, abs=0.01)
    assert panel.emotions.buttons["happiness"].strength == pytest.approx(0.5, abs=0.01)


def test_the_strength_bar_names_no_emotion_while_another_bar_is_dragged(panel, document):
    strength = panel.emotions.strength
    for release in (False, True):
        drag(panel.rows[17].slider, 0.1, 0.6, release=release)
        assert strength.label == "Strength"


def test_an_emotion_with_anything_else_is_no_longer_that_emotion():
    happiness = {"12L": 0.9, "12R": 0.9}
    assert shown_strength({"12L": 0.45, "12R": 0.45}, happiness) == pytest.approx(0.5)
    assert shown_strength({"12L": 0.45, "12R": 0.40}, happiness) == 0.0
    assert shown_strength({"12L": 0.45, "12R": 0.45, "17": 0.1}, happiness) == 0.0
    assert shown_strength({"12L": 0.45, "12R": 0.45, "17": 0.0}, happiness) == pytest.approx(0.5)
    assert shown_strength({}, happiness) == 0.0
    assert shown_strength({"12L": 0.5}, {}) == 0.0


def test_hovering_a_bar_names_the_muscles_that_move_it(panel):
    heard = []
    panel.muscles_hovered.connect(heard.append)
    row = panel.rows[12]
    QTest.mouseClick(row.split, Qt.MouseButton.LeftButton)
    for slider in (row.slider, row.sides[1], panel.rows[26].slider):
        enter(slider)
        leave(slider)
    both, right = {"zygomaticus_major_L", "zygomaticus_major_R"}, {"zygomaticus_major_R"}
    assert heard == [both, set(), right, set(), set(), set()]


def test_a_hand_on_the_bar_ends_the_glow_so_that_the_face_is_seen(panel):
    heard = []
    panel.muscles_hovered.connect(heard.append)
    enter(panel.rows[12].slider)
    drag(panel.rows[12].slider, 0.1, 0.4)
    assert heard[-1] == frozenset()


def test_another_project_has_its_own_rows(panel, document, patch):
    fewer = Document(patch)
    assert set(panel.rows) == {unit.number for unit in fewer.project.units}
    other = replace(patch, units=patch.units[:1], emotions=())
    panel.show_project(other)
    QApplication.processEvents()
    assert set(panel.rows) == {12}
    assert panel.emotions.buttons == {}


def test_tab_walks_through_bars_in_the_order_they_are_seen(panel):
    panel.search.setFocus()
    seen = []
    for _ in range(40):
        QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Tab)
        seen.append(QApplication.focusWidget())
    rows = [row.slider for row in panel.rows.values()]
    order = [widget for widget in seen if widget in rows]
    ys = [slider.mapTo(panel, slider.rect().topLeft()).y() for slider in order]
    first = ys[: len(rows)]
    assert first == sorted(first)
    assert set(order) == set(rows)


def test_a_tooltip_names_muscle_and_millimetres(patch):
    titles = muscle_titles(patch.muscles)
    assert "Zygomaticus major" in unit_tooltip(patch.units[0], titles)
    assert "5 mm" in unit_tooltip(patch.units[0], titles)
    assert unit_matches("au 12", patch.units[0], titles)


def test_the_view_is_told_of_the_link_and_tells_it(panel, view: View):
    view.change(linked=False)
    assert not panel.link.isChecked()


def typed(slider, text: str) -> None:
    QTest.mouseDClick(slider, Qt.MouseButton.LeftButton)
    line = slider.findChild(QLineEdit)
    line.selectAll()
    QTest.keyClicks(line, text)
    QTest.keyClick(line, Qt.Key.Key_Return)


@pytest.mark.parametrize("text", ["c", "12C", "60%"])
def test_a_letter_of_facs_typed_into_a_row_sets_it_and_is_shown(panel, document, text):
    typed(panel.rows[12].slider, text)
    assert document.shown == {"12L": 0.6, "12R": 0.6}
    assert panel.rows[12].slider.number == "C 0.60"
    assert document.history.done == ("Lip corner puller",)


def test_the_score_of_another_unit_is_not_taken(panel, document):
    typed(panel.rows[12].slider, "17C")
    assert document.shown == {}
    assert panel.rows[12].slider.findChild(QLineEdit).property("wrong")


def test_letters_that_begin_elsewhere_are_shown_at_once(panel, document):
    document.set_weights({"17": 0.3})
    assert panel.rows[17].slider.number == "B 0.30"
    document.edit(with_letters(document.project, 17, (0.05, 0.1, 0.15, 0.25, 0.9)), "Intensities")
    assert panel.rows[17].slider.number == "D 0.30"


def test_the_bar_of_a_unit_ends_at_its_limit(panel, document):
    document.edit(with_limit(document.project, 17, 0.4), "Limit")
    slider = panel.rows[17].slider
    drag(slider, 0.0, 0.5)
    assert document.shown["17"] == pytest.approx(0.2, abs=0.01)
    drag(slider, 0.0, 1.0, Qt.KeyboardModifier.ControlModifier)
    assert document.shown["17"] == 0.4
    QTest.keyClick(slider, Qt.Key.Key_Home)
    QTest.keyClick(slider, Qt.Key.Key_End)
    assert document.shown["17"] == 0.4
    typed(slider, "1")
    assert slider.weight == document.shown["17"] == 0.4


def test_variants_of_an_emotion_are_folded_away_and_tell_when_one_is_on(panel, document):
    bar = panel.emotions
    assert not bar.variants.isVisible()
    varied = replace(
        document.project,
        emotions=(*document.project.emotions, Emotion("happiness, chin raised", {"12": 0.7, "17": 0.5})),
    )
    document.edit(varied, "Vary")
    button = bar.buttons["happiness, chin raised"]
    assert bar.variants.isVisible()
    assert not button.isVisible()
    QTest.mouseClick(bar.variants.heading, Qt.MouseButton.LeftButton)
    assert button.isVisible()
    assert button.text() == "Chin raised"
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert document.shown["17"] == 0.5
    assert bar.strength.label == "Happiness, chin raised strength"
    assert button.width() < panel.width() / 4


def test_a_unit_is_named_as_it_is_written_wherever_its_row_is_pointed_at(shown, patch, view, portraits):
    name = "<b>smile</b> & wink"
    document = Document(replace(patch, units=tuple(replace(each, name=name) for each in patch.units)))
    row = shown(ExpressionPanel(document, view, portraits)).rows[12]
    row.unfold(True)
    for part in (row.split, row.clear, row.slider, *row.sides):
        assert name.lower() in read(part.toolTip()).lower()
