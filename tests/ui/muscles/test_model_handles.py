"""Every model's handles dragged over the face with the mouse, and rings drawn on it, in the real window."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from facemodel.laying.collection import jaw_muscle, muscle_of, with_muscle
from facemodel.laying.handles import Handle, handles
from facemodel.laying.places import nearest
from facemodel.laying.sides import mirrored
from facemodel.muscles import Muscle, Profile
from facemodel.muscles.parameters import value_of
from facemodel.sameness import same
from tests.ui.hands import move
from tests.ui.window.conftest import document, open_window, project, settings, solution  # noqa: F401
from tests.ui.window.conftest import window as window
from tests.ui.window.seen import differs, next_frame, picture, pixel
from ui.widgets.legend_card import LegendCard
from ui.window.main_window import MainWindow

SMILE, MOUTH = "zygomaticus_major_L", "orbicularis_oris_marginal"
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def editor(window) -> MainWindow:
    window.context.view.look_from("front")
    window.context.view.change(workspace="muscles")
    window.toolbox.take("fibre")
    next_frame(window)
    return window


def under(editor: MainWindow, key: str, **members: object) -> Muscle:
    """Give a muscle other members, as one who comes later would find it, and select it."""
    work = editor.context.document
    muscle = replace(muscle_of(work.project, key), **members)
    work.edit(with_muscle(work.project, muscle), "Prepare")
    editor.context.view.change(muscle=key)
    next_frame(editor)
    return muscle


def handle(editor: MainWindow, key: str, part: str, place: int = 0) -> Handle:
    work = editor.context.document.project
    found = handles(muscle_of(work, key), work.face)
    return next(each for each in found if (each.part, each.place) == (part, place))


def drag(editor: MainWindow, start: QPoint, way: QPoint, release: bool = True, keys=Qt.KeyboardModifier.NoModifier):
    canvas = editor.viewport.canvas
    QTest.mousePress(canvas, LEFT, keys, start)
    for step in range(1, 7):
        move(canvas, start + way * step / 6, keys)
    editor.hands.flush()
    QApplication.processEvents()
    if release:
        QTest.mouseRelease(canvas, LEFT, keys, start + way)


def number(muscle: Muscle, name: str) -> float:
    """The value of a parameter; of a profile, where it ends."""
    value = value_of(muscle, name)
    return value.at[-1] if isinstance(value, Profile) else value


@pytest.mark.parametrize(
    ("key", "model", "part", "place", "way", "name", "more", "label"),
    [
        (SMILE, "quadrilateral", "radius", 0, (0, -14), "width", True, "Widen"),
        (SMILE, "cosine", "share", 0, (8, -14), "cosine.share", True, "Change share of"),
        (SMILE, "cosine", "box", 0, (14, 0), "cosine.box.x", True, "Change box of"),
        (MOUTH, "mouth", "reach", 0, (16, 0), "profiles.sigma", True, "Widen"),
        (MOUTH, "sphincter", "radius", 0, (12, 0), "width", True, "Widen"),
        (MOUTH, "cosine_ring", "factor", 0, (-12, 0), "cosine.factors.x", False, "Change K of"),
        (MOUTH, "cosine_ring", "box", 1, (0, -18), "cosine.box.y", True, "Change box of"),
    ],
)
def test_a_dragged_handle_is_its_number(editor, key, model, part, place, way, name, more, label):
    work = editor.context.document
    before = under(editor, key, model=model)
    grip = handle(editor, key, part, place)
    start, stood = pixel(editor, grip.point), work.project
    drag(editor, start, QPoint(*way))
    after = muscle_of(work.project, key)
    assert work.history.to_undo.label == f"{label} {after.title}"
    assert (number(after, name) > number(before, name)) == more
    seen = pixel(editor, handle(editor, key, part, place).point) - start
    assert seen.x() * way[0] + seen.y() * way[1] > 0, "it went where the hand went"
    QTest.keyClick(editor, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert same(work.project.muscles, stood.muscles)


def test_the_tip_of_a_ring_is_dragged_over_the_skin(editor):
    before = under(editor, MOUTH, model="sphincter")
    drag(editor, pixel(editor, handle(editor, MOUTH, "short").point), QPoint(0, -12))
    after = muscle_of(editor.context.document.project, MOUTH)
    assert np.linalg.norm(after.ring.short_axis) > np.linalg.norm(before.ring.short_axis) + 1
    assert abs(after.ring.short_axis @ after.ring.long_axis) < 1e-9


def test_the_arrow_of_the_jaw_is_dragged_to_a_larger_force(editor):
    work = editor.context.document
    jaw = jaw_muscle(work.project)
    work.edit(with_muscle(work.project, jaw), "Prepare")
    editor.context.view.change(muscle=jaw.key)
    next_frame(editor)
    drag(editor, pixel(editor, handle(editor, jaw.key, "force").point), QPoint(0, 40))
    assert muscle_of(work.project, jaw.key).strength > jaw.strength
    assert work.history.to_undo.label == "Strengthen Jaw force"


def test_a_ring_is_drawn_on_the_skin_on_both_sides_and_esc_draws_none(editor):
    work = editor.context.document
    editor.toolbox.take("ring")
    calm, before = picture(editor), work.project
    cheek = before.face.skin.positions[before.face.landmarks["cheek_L"]]
    start = pixel(editor, cheek)
    drag(editor, start, QPoint(24, 4), release=False)
    assert editor.toolbox.busy
    assert differs(picture(editor), calm)
    QTest.keyClick(editor.viewport.canvas, Qt.Key.Key_Escape)
    assert work.project is before
    QTest.mouseRelease(editor.viewport.canvas, LEFT)
    drag(editor, start, QPoint(24, 4))
    left, right = work.project.muscles[-2:]
    assert (left.side, right.side, left.model) == ("L", "R", "sphincter")
    assert nearest(before.face.skin, left.ring.centre)[2][0] < 1.0
    assert same(mirrored(left, before.face), right)
    assert 0.5 < np.linalg.norm(left.ring.short_axis) / np.linalg.norm(left.ring.long_axis) < 0.75
    assert editor.context.view.state.muscle == left.key
    assert work.history.done == ("Lay Cheek sphincter",)
    QTest.keyClick(editor, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert same(work.project.muscles, before.muscles)


def test_a_drag_keeps_several_muscles_selected(editor):
    under(editor, SMILE)
    editor.context.view.select_also(MOUTH)
    drag(editor, pixel(editor, handle(editor, SMILE, "attachment").point), QPoint(14, -10))
    assert editor.context.view.state.selected == {SMILE, MOUTH}


def test_the_skull_is_seen_while_fibres_are_laid_and_not_longer(editor):
    view = editor.context.view
    assert view.state.skull
    editor.toolbox.take("select")
    assert not view.state.skull
    editor.toolbox.take("fibre")
    view.change(workspace="expression")
    assert not view.state.skull
    assert not view.state.muscles


def test_colours_on_the_skin_have_a_legend_with_their_unit(editor):
    def legends():
        return [card.legend for card in editor.viewport.findChildren(LegendCard) if card.legend is not None]

    assert legends() == []
    under(editor, SMILE)
    (legend,) = legends()
    assert (legend.title, legend.unit) == ("Pulls the skin", "kPa")
    under(editor, SMILE, model="cosine")
    (legend,) = legends()
    assert legend.unit == "mm"
    assert 0 < legend.high < 40


def test_a_ring_is_selected_by_a_click_on_it(editor):
    work = editor.context.document
    editor.toolbox.take("select")
    ring = muscle_of(work.project, "orbicularis_oculi_palpebralis_L").ring
    outer = ring.centre + (ring.long_axis if ring.long_axis[0] > 0 else -ring.long_axis)
    QTest.mouseClick(editor.viewport.canvas, LEFT, pos=pixel(editor, outer))
    assert editor.context.view.state.muscle == "orbicularis_oculi_palpebralis_L"


def test_nothing_is_laid_beside_the_face_and_why_is_said(editor):
    work = editor.context.document
    editor.context.view.change(muscle="")
    start = pixel(editor, muscle_of(work.project, SMILE).fibres[0].origin)
    drag(editor, start, QPoint(10 - start.x(), 10 - start.y()))
    assert work.history.done == ()
    assert editor.status.hint.text() == "A fibre ends in the skin; let go over the face."


def test_a_fold_is_drawn_along_the_skin_on_both_sides(editor):
    work = editor.context.document
    editor.toolbox.take("fold")
    before, marks = work.project, work.project.face.landmarks
    skin = before.face.skin.positions
    start = pixel(editor, skin[marks["cheek_L"]])
    drag(editor, start, pixel(editor, skin[marks["mouth_corner_L"]] + [10.0, 0.0, 0.0]) - start)
    left, right = work.project.muscles[-2:]
    assert (left.side, right.side, left.model, right.model) == ("L", "R", "fold", "fold")
    line = left.fibres[0].points
    assert len(line) > 2
    assert nearest(before.face.skin, line)[2].max() < 1e-6
    assert same(mirrored(left, before.face), right)
    assert work.history.done[0].startswith("Lay ")
    QTest.keyClick(editor, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert same(work.project.muscles, before.muscles)
