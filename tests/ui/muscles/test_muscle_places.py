"""Where a muscle lies, as numbers: its fibres and where they end and bend, the ring of a sphincter, its state."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit

from app.authoring.bare import bare_project
from app.tools import TOOLS, Bench, ToolBox
from facemodel.laying.collection import muscle_of
from facemodel.laying.places import kind_of_place
from facemodel.laying.sides import mirrored
from facemodel.muscles import Sphincter
from facemodel.projects import new_project
from facemodel.sameness import same
from tests.ui.hands import drag, move
from ui.panels.muscles.panel import MusclesPanel

LEFT, RIGHT = "zygomaticus_major_L", "zygomaticus_major_R"
MOUTH = "orbicularis_oris"


@pytest.fixture
def panel(shown, context) -> MusclesPanel:
    document = context.document
    ring = Sphincter(np.array([0.0, 0, 20]), np.array([16.0, 0, 0]), np.array([0, 9.0, 0]))
    first = document.project.muscles[0]
    mouth = replace(
        first, name=MOUTH, side="M", title="Orbicularis oris", group="lip", model="mouth", fibres=(), ring=ring
    )
    document.edit(replace(document.project, muscles=(*document.project.muscles, mouth)), "Lay a mouth")
    context.view.change(workspace="muscles", muscle=LEFT)
    context.solving.solve()
    panel = MusclesPanel(context, ToolBox(Bench(document, context.view), TOOLS))
    panel.resize(360, 1200)
    return shown(panel)


def type_into(bar, text: str) -> None:
    QTest.mouseDClick(bar, Qt.MouseButton.LeftButton)
    editor = bar.findChild(QLineEdit)
    editor.selectAll()
    QTest.keyClicks(editor, text)
    QTest.keyClick(editor, Qt.Key.Key_Return)


def click(button) -> None:
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def test_a_typed_coordinate_moves_an_end_and_the_partner_follows(panel, context):
    document, before = context.document, context.document.project
    type_into(panel.properties.fibres.fibres[0].attachment.bars[1], "-12 + 1/2")
    moved = muscle_of(document.project, LEFT)
    assert moved.fibres[0].attachment == pytest.approx([15, -11.5, 15])
    assert same(mirrored(moved, document.project.face), muscle_of(document.project, RIGHT))
    assert document.history.to_undo.label == "Move attachment of Zygomaticus major"
    document.undo()
    assert same(document.project.muscles, before.muscles)
    assert panel.properties.fibres.fibres[0].attachment.bars[1].value == -10.0


def test_both_sides_selected_are_moved_once_and_stay_mirror_images(panel, context):
    context.view.change(muscle=RIGHT, others=frozenset({LEFT}))
    type_into(panel.properties.fibres.fibres[0].origin.bars[0], "-26")
    project = context.document.project
    assert muscle_of(project, RIGHT).fibres[0].origin[0] == -26
    assert muscle_of(project, LEFT).fibres[0].origin[0] == pytest.approx(26)


def test_a_coordinate_is_dragged_slowly_in_one_step_and_esc_takes_it_back(panel, context):
    document, before = context.document, context.document.project
    bar = panel.properties.fibres.fibres[0].origin.bars[0]
    drag(bar, 0.2, 0.9, release=False)
    assert 0 < abs(muscle_of(document.project, LEFT).fibres[0].origin[0] - 30) < 60
    QTest.keyClick(bar, Qt.Key.Key_Escape)
    assert same(document.project.muscles, before.muscles)
    drag(bar, 0.2, 0.9)
    assert document.history.done == ("Lay a mouth", "Move origin of Zygomaticus major")


def test_arrow_keys_step_a_coordinate_by_half_a_millimetre_in_one_step_for_each_press(panel, context):
    bar = panel.properties.fibres.fibres[0].origin.bars[2]
    bar.setFocus()
    QTest.keyClick(bar, Qt.Key.Key_Up)
    assert muscle_of(context.document.project, LEFT).fibres[0].origin[2] == 5.5
    QTest.keyClick(bar, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    assert muscle_of(context.document.project, LEFT).fibres[0].origin[2] == 5.4
    QTest.keyClick(bar, Qt.Key.Key_Backspace)
    assert muscle_of(context.document.project, LEFT).fibres[0].origin[2] == 5.4, "nothing resets a place"
    assert len(context.document.history.done) == 3


def test_fibres_are_added_put_in_order_bent_and_taken_out(panel, context):
    document = context.document
    fibres = panel.properties.fibres
    click(fibres.add)
    assert len(muscle_of(document.project, LEFT).fibres) == len(fibres.fibres) == 2
    first, second = muscle_of(document.project, LEFT).fibres
    assert np.linalg.norm(first.attachment - second.attachment) > 2
    click(fibres.fibres[0].buttons["down"])
    assert np.array_equal(muscle_of(document.project, LEFT).fibres[1].attachment, first.attachment)
    click(fibres.fibres[1].buttons["bend"])
    assert len(muscle_of(document.project, LEFT).fibres[1].via) == 1
    type_into(fibres.fibres[1].bends[0].bars[2], "14")
    assert muscle_of(document.project, LEFT).fibres[1].via[0][2] == 14
    click(fibres.fibres[0].buttons["remove"])
    (left,) = muscle_of(document.project, LEFT).fibres
    assert np.array_equal(left.attachment, first.attachment)
    assert not fibres.fibres[0].buttons["remove"].isEnabled(), "a muscle keeps one fibre"
    for _ in range(5):
        document.undo()
    assert document.history.done == ("Lay a mouth",)


def test_a_fibre_with_both_ends_at_one_point_is_refused_in_a_sentence(panel, context, desk):
    document, before = context.document, context.document.project
    attachment = muscle_of(before, LEFT).fibres[0].attachment
    origin = panel.properties.fibres.fibres[0].origin
    type_into(origin.bars[0], f"{attachment[0]}")
    type_into(origin.bars[1], f"{attachment[1]}")
    stands = document.project

    type_into(origin.bars[2], f"{attachment[2]}")
    assert "begins and ends at one point" in desk.messages[-1]

    assert document.project is stands
    assert origin.bars[2].value == stands.muscles[0].fibres[0].origin[2]


def test_a_ring_takes_numbers_and_halves(panel, context):
    document = context.document
    context.view.change(muscle=MOUTH)
    ring = panel.properties.ring
    assert not ring.isHidden()
    assert panel.properties.fibres.isHidden()
    type_into(ring.lengths["long"], "22")
    assert muscle_of(document.project, MOUTH).ring.long_axis == pytest.approx([22, 0, 0])
    type_into(ring.centre.bars[1], "-4")
    assert muscle_of(document.project, MOUTH).ring.centre == pytest.approx([0, -4, 20])
    type_into(ring.tips["short"].bars[1], "8")
    assert muscle_of(document.project, MOUTH).ring.short_axis == pytest.approx([0, 12, 0])
    ring.half.setCurrentIndex(ring.half.findData("up"))
    ring.half.activated.emit(ring.half.currentIndex())
    assert muscle_of(document.project, MOUTH).ring.sector[1] > 0
    assert document.history.to_undo.label == "Part of Orbicularis oris"


def test_a_profile_is_drawn_as_a_curve_in_one_step(panel, context):
    document, before = context.document, context.document.project
    context.view.change(muscle=MOUTH)
    row = panel.properties.parameters.curves["profiles.sigma"]
    curve, knot = row.curve, row.curve.place_of(2).toPoint()
    QTest.mousePress(curve, Qt.MouseButton.LeftButton, pos=knot)
    for step in range(1, 7):
        move(curve, knot + (curve.place_of(1).toPoint() - knot) * step / 12)
    QTest.mouseRelease(curve, Qt.MouseButton.LeftButton, pos=knot)
    drawn = muscle_of(document.project, MOUTH).profiles.sigma
    assert drawn.values[2] < 1.0
    assert drawn.at[2] < 1.0
    assert document.history.to_undo.label == "Inward profile σ of Orbicularis oris"
    assert document.history.done[:-1] == ("Lay a mouth",)
    type_into(row.value, "0.25")
    assert muscle_of(document.project, MOUTH).profiles.sigma.values[2] == 0.25
    click(row.restore)
    assert muscle_of(document.project, MOUTH).profiles.sigma.values[2] == 1.0
    while document.history.done[-1] != "Lay a mouth":
        document.undo()
    assert same(document.project.muscles, before.muscles)
    assert row.curve.profile.values[2] == 1.0


def test_a_muscle_takes_a_colour_of_its_own_and_gives_it_back(panel, context):
    colour = panel.properties.identity.colour
    colour.chosen.emit("#9478bd")
    assert {each.colour for each in context.document.project.muscles[:2]} == {"#9478bd"}
    assert colour.colour == "#9478bd"
    colour.chosen.emit("")
    assert muscle_of(context.document.project, LEFT).colour == ""


def test_a_locked_muscle_shows_its_numbers_and_takes_none(panel, context):
    click(panel.properties.identity.states["muscle.lock"])
    assert context.view.state.locked == {LEFT}
    before = context.document.project
    assert not panel.properties.bars["width"].isEnabled()
    drag(panel.properties.bars["width"], 0.2, 0.7)
    assert context.document.project is before
    click(panel.properties.identity.states["muscle.lock"])
    drag(panel.properties.bars["width"], 0.2, 0.7)
    assert context.document.project is not before


def test_numbers_of_several_muscles_are_changed_together(panel, context):
    context.view.change(muscle=LEFT, others=frozenset({RIGHT, MOUTH}))
    bars = panel.properties.bars
    assert set(bars) == {"width", "strength"}, "what a fibre and a ring have in common"
    assert panel.properties.fibres.isHidden()
    type_into(bars["width"], "17")
    assert {muscle.width for muscle in context.document.project.muscles} == {17.0}
    assert context.document.history.to_undo.label == "Width of Zygomaticus major and Orbicularis oris"


def test_a_force_of_the_jaw_is_laid_from_the_menu(panel, context):
    actions = {action.text(): action for action in panel.new.menu().actions()}
    actions["Force of the jaw"].trigger()
    assert muscle_of(context.document.project, "jaw_force").model == "jaw"
    assert context.view.state.muscle == "jaw_force"
    assert set(panel.properties.bars) == {"strength"}
    actions["Ring on the skin"].trigger()
    assert panel._toolbox.tool.id == "ring"
    assert not panel.snap.isHidden()


def test_what_is_dragged_snaps_as_it_is_told(panel, context):
    box, toolbox = panel.snap, panel._toolbox
    box.skin.setCurrentIndex(box.skin.findData("surface"))
    box.skin.activated.emit(box.skin.currentIndex())
    assert {tool.skin_snap for tool in toolbox.tools if hasattr(tool, "skin_snap")} == {"surface"}


def test_muscles_copied_in_one_project_are_pasted_into_another_head_s(panel, context):
    document = context.document
    ada = new_project("ada")
    document.restore(replace(ada, units=(), emotions=()), None)
    context.view.change(muscle="risorius_L", others=frozenset({"risorius_R"}))
    panel.tree.setFocus()
    QTest.keyClick(panel.tree, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    document.restore(bare_project("ben"), None)
    QTest.keyClick(panel.tree, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    assert [muscle.key for muscle in document.project.muscles] == ["risorius_L", "risorius_R"]
    assert context.view.state.selected == {"risorius_L", "risorius_R"}
    face = document.project.face
    for muscle in document.project.muscles:
        assert {kind_of_place(face, fibre.attachment)[0] for fibre in muscle.fibres} <= {"vertex", "skin"}
    assert document.history.done == ("Paste Risorius",)
    document.undo()
    assert document.project.muscles == ()


def test_a_muscle_is_laid_on_the_other_side_by_its_button_and_locked_ones_stay(panel, context, desk):
    document = context.document
    click(panel.buttons["muscle.link"])
    type_into(panel.properties.bars["width"], "20")
    assert muscle_of(document.project, RIGHT).width != 20
    context.view.lock([RIGHT])
    click(panel.buttons["muscle.mirror"])
    assert "locked" in desk.messages[-1]
    context.view.lock([RIGHT], on=False)
    context.view.change(muscle=LEFT)
    click(panel.buttons["muscle.mirror"])
    assert muscle_of(document.project, RIGHT).width == 20
    assert context.view.state.selected == {RIGHT}
