"""A hand that sculpts moves the unit in hand, as it is seen, in one step and without a trace when it is cancelled."""

from dataclasses import replace

import numpy as np
import pytest

from app.authoring import sculpting
from app.document import Document
from app.solo import seen
from app.tools import Bench, Pointer, SculptTool, SelectTool, ToolBox
from app.view import View
from facemodel.project import Project
from facemodel.sculpting.brush import RAISED
from facemodel.sculpting.sampler import DrawnChange
from facemodel.solution import Solution
from facemodel.solve import solve_project
from facemodel.superposition import Superposition
from fem.types import FloatArray
from tests.app.test_tools import facing, on_skin

NEAR = 1e-3
"""Millimetres; single precision over a face."""


@pytest.fixture(scope="module")
def solved(project: Project) -> Solution:
    return solve_project(project)


@pytest.fixture
def box(document: Document, solved: Solution) -> ToolBox:
    document.accept(solved, document.project)
    view = View()
    view.change(workspace="actions", unit=17)
    box = ToolBox(Bench(document, view), (SelectTool, SculptTool))
    box.bench.sculpt.change(radius=15.0, mirror=False)
    box.take("sculpt")
    return box


@pytest.fixture
def changes(box: ToolBox) -> list[DrawnChange | None]:
    found: list[DrawnChange | None] = []
    box.bench.sight.shifted.connect(found.append)
    return found


def sculpt(box: ToolBox, *places: tuple[float, float], modifiers: frozenset[str] = frozenset()) -> None:
    face = box.bench.document.project.face
    box.press(on_skin(face, *places[0], modifiers=modifiers))
    for place in places[1:]:
        box.move(on_skin(face, *place, modifiers=modifiers))
    box.release(on_skin(face, *places[-1], modifiers=modifiers))


def pull(box: ToolBox, start: tuple[float, float], way: FloatArray, release: bool = True) -> None:
    """Take hold of a place and carry it along, as seen from straight before the face."""
    pointer = on_skin(box.bench.document.project.face, *start)
    assert pointer.skin is not None
    end = Pointer(pointer.x, pointer.y, skin=pointer.skin, ray=facing(pointer.skin.position + way))
    box.press(pointer)
    box.move(Pointer(pointer.x, pointer.y, skin=None, ray=facing(pointer.skin.position + way / 2)))
    box.move(end)
    if release:
        box.release(end)


def posed(document: Document, view: View) -> FloatArray:
    """Return what is seen when all of it is drawn from the document."""
    assert document.solution is not None
    made = Superposition(document.project.face, document.solution.basis)
    made.pose(seen(document, view.state))
    return made.points.astype(np.float64)


def test_a_unit_that_is_not_in_the_mix_is_seen_alone_while_it_is_sculpted(box: ToolBox, document: Document) -> None:
    view = box.bench.view
    document.set_weights({"26": 0.5})
    assert seen(document, view.state) == {"17": 1.0}
    assert "AU 17 alone" in box.tool.advice
    document.set_weights({"17": 0.4})
    assert seen(document, view.state) == {"17": 0.4, "26": 0.5}
    assert "in the mix, at 0.40" in box.tool.advice
    box.take("select")
    document.set_weights({"17": 0.0})
    assert seen(document, view.state) == {"26": 0.5}


def test_a_stroke_is_drawn_while_it_lasts_and_is_one_step(
    box: ToolBox, document: Document, changes: list[DrawnChange | None], project: Project
) -> None:
    before = posed(document, box.bench.view)
    assert document.solution is not None
    live = Superposition(project.face, document.solution.basis)
    live.pose({"17": 1.0})
    box.bench.sight.shifted.connect(lambda change: live.settle() if change is None else live.shift(change))
    pull(box, (0, 0), np.array([3.0, 4.0, 0]), release=False)
    assert document.project is project
    assert np.abs(live.points - before).max() > 3
    held = live.points.copy()
    box.cancel()
    assert changes[-1] is None
    assert np.array_equal(live.points, before.astype(np.float32))
    assert document.history.done == ()
    pull(box, (0, 0), np.array([3.0, 4.0, 0]))
    assert document.history.done == ("Pull AU 17",)
    np.testing.assert_allclose(posed(document, box.bench.view), held, atol=NEAR)
    document.undo()
    assert document.project.corrections == {}
    assert np.array_equal(posed(document, box.bench.view), before)


def test_in_the_mix_the_face_goes_with_the_hand_whatever_the_unit_weighs(box: ToolBox, document: Document) -> None:
    document.set_weights({"17": 0.25, "12L": 0.5})
    before = posed(document, box.bench.view)
    way = np.array([2.0, 0.0, 0.0])
    pull(box, (0, 0), way)
    moved = posed(document, box.bench.view) - before
    # The place under the hand goes exactly with it, the nearest vertex a little farther.
    assert 2.0 <= moved[:, 0].max() < 2.5
    assert 8.0 <= document.project.corrections["17"].largest < 10.0
    assert list(document.project.corrections) == ["17"]


def test_both_sides_of_a_unit_take_their_own_and_the_image_is_on_the_other(box: ToolBox, document: Document) -> None:
    box.bench.view.change(unit=12)
    box.bench.sculpt.change(mirror=True, mode="raise")
    sculpt(box, (25, 0), (25, 10))
    left, right = (document.project.corrections[name] for name in ("12L", "12R"))
    skin = document.project.face.skin.positions
    assert (skin[left.vertices, 0] > -12).all()
    count, partners = len(skin), document.project.face.mirror
    np.testing.assert_allclose(right.everywhere(count), left.everywhere(count)[partners] * [-1, 1, 1], atol=1e-5)


def test_a_side_that_is_seen_alone_takes_all_and_the_other_one_its_image(box: ToolBox, document: Document) -> None:
    box.bench.view.change(unit=12)
    document.set_weights({"12L": 1.0})
    box.bench.sculpt.change(mode="raise")
    sculpt(box, (-25, 0))
    assert list(document.project.corrections) == ["12L"]
    assert 0.3 * RAISED < document.project.corrections["12L"].largest <= 0.5 * RAISED
    document.undo()
    box.bench.sculpt.change(mirror=True)
    sculpt(box, (-25, 0))
    made = document.project.corrections
    assert list(made) == ["12L", "12R"]
    assert (document.project.face.skin.positions[made["12L"].vertices, 0] < 0).all()
    assert (document.project.face.skin.positions[made["12R"].vertices, 0] > 0).all()


def test_control_lowers_shift_smooths_and_erasing_all_leaves_no_layer(box: ToolBox, document: Document) -> None:
    box.bench.sculpt.change(mode="raise", radius=25.0, hardness=1.0)
    sculpt(box, (0, 0), modifiers=frozenset({"control"}))
    assert document.project.corrections["17"].everywhere(81)[40, 2] < -0.3
    sculpt(box, (0, 0), modifiers=frozenset({"shift"}))
    assert document.history.done[-1] == "Smooth AU 17"
    box.bench.sculpt.change(mode="erase", radius=70.0)
    sculpt(box, (0, 0))
    assert document.project.corrections == {}


def test_what_cannot_be_sculpted_is_told_and_nothing_happens(box: ToolBox, document: Document) -> None:
    told: list[str] = []
    box.failed.connect(told.append)
    box.bench.view.change(unit=None)
    sculpt(box, (0, 0))
    assert "choose one" in told[-1]
    box.bench.view.change(unit=17)
    pull(box, (0, 0), np.array([2.0, 0, 0]))
    document.edit(sculpting.with_switch(document.project, 17, False), "Off")
    sculpt(box, (0, 0))
    assert "switch it on" in told[-1]
    document.undo()
    unit = replace(document.project.units[2], muscles={"zygomaticus_major": 2.0})
    document.edit(replace(document.project, units=(*document.project.units[:2], unit, document.project.units[3])), "x")
    sculpt(box, (0, 0))
    assert "not solved" in told[-1]
    document.undo()
    box.bench.view.change(before=True)
    sculpt(box, (0, 0))
    assert "before the last solve" in told[-1]
    assert not box.busy


def test_undo_or_another_unit_in_the_middle_of_a_stroke_lets_it_go(
    box: ToolBox, document: Document, changes: list[DrawnChange | None]
) -> None:
    document.set_weights({"12": 0.5})
    box.press(on_skin(document.project.face, 0, 0))
    document.undo()
    assert not box.busy
    assert changes[-1] is None
    box.press(on_skin(document.project.face, 0, 0))
    box.bench.view.change(unit=12)
    assert not box.tool.busy
    box.release(on_skin(document.project.face, 0, 0))
    assert document.history.done == ()


def test_a_pen_that_presses_half_sculpts_half(box: ToolBox, document: Document) -> None:
    box.bench.sculpt.change(mode="raise")
    box.bench.sculpt.set_strength(1.0)
    face = document.project.face
    box.press(on_skin(face, 0, 0, pressure=0.5))
    box.release(on_skin(face, 0, 0, pressure=0.0))
    half = document.project.corrections["17"].largest
    document.undo()
    sculpt(box, (0, 0))
    assert half == pytest.approx(document.project.corrections["17"].largest / 2, rel=1e-5)
