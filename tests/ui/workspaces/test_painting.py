"""Painting a layer with the mouse."""

from itertools import pairwise

import numpy as np
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.solving import EditingSolve
from tests.ui.window.seen import differs, next_frame, picture
from tests.ui.workspaces.conftest import at, stroke
from tests.ui.workspaces.test_switching import camera

EXACT = 1e-9
"""Millimetres; two ways to the same place differ by rounding."""


def away_from(path: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """Return the distance of positions from a path through space."""
    away = np.full(len(positions), np.inf)
    for start, end in pairwise(path):
        way = end - start
        share = np.clip((positions - start) @ way / (way @ way), 0, 1)
        away = np.minimum(away, np.linalg.norm(positions - start - share[:, None] * way, axis=1))
    return away


def test_a_stroke_paints_under_its_path_and_nowhere_else_and_undo_brings_back_every_bit(tissue, document):
    before = document.project
    places = [at(tissue, 0.57, 0.64), at(tissue, 0.585, 0.60), at(tissue, 0.59, 0.56)]
    path = np.array([tissue.hands.sight.pointer(p.x(), p.y()).skin.position for p in places])
    stroke(tissue, places)
    skin = before.face.skin.positions
    painted = document.project.face.layers.stiffness != before.face.layers.stiffness
    away = away_from(path, skin)
    # A way on the skin is never shorter than through the air, and on a cheek never half as long again.
    assert not painted[away > 9.0].any()
    front = before.face.skin.normals[:, 2] > 0.2
    assert painted[front & (away < 9.0 / 1.5)].all()
    assert painted.sum() > 10
    after = document.project.face.layers.stiffness.copy()
    assert document.history.to_undo.label == "Paint tissue stiffness"
    QTest.keyClick(tissue, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert document.history.to_undo is None
    assert np.array_equal(document.project.face.layers.stiffness, before.face.layers.stiffness)
    document.redo()
    assert np.array_equal(document.project.face.layers.stiffness, after)


def test_a_stroke_is_seen_while_it_is_made_and_esc_takes_it_back(tissue, document):
    stroke(tissue, [at(tissue, 0.30, 0.10)])
    bare = picture(tissue)
    before = document.project
    stroke(tissue, [at(tissue, 0.57, 0.64), at(tissue, 0.59, 0.56)], release=False)
    assert tissue.toolbox.busy
    tissue.toolbox.tool.leave()
    assert differs(picture(tissue), bare)
    QTest.keyClick(tissue.viewport.canvas, Qt.Key.Key_Escape)
    assert not tissue.toolbox.busy
    tissue.toolbox.tool.leave()
    assert not differs(picture(tissue), bare)
    assert document.project is before
    assert document.history.to_undo is None


def test_keys_and_the_wheel_with_ctrl_change_the_brush_and_leave_the_camera(tissue):
    brush, canvas = tissue.toolbox.bench.brush, tissue.viewport.canvas
    seen_from = camera(tissue)
    QTest.keyClick(canvas, Qt.Key.Key_BracketRight)
    assert brush.state.radius > 9.0
    QTest.keyClick(canvas, Qt.Key.Key_BracketLeft)
    assert abs(brush.state.radius - 9.0) < EXACT
    QTest.keyClick(canvas, Qt.Key.Key_X)
    assert brush.state.mirror
    middle = QPointF(canvas.rect().center())
    turn = QWheelEvent(
        middle,
        QPointF(canvas.mapToGlobal(canvas.rect().center())),
        QPoint(),
        QPoint(0, 120),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.ControlModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(canvas, turn)
    assert brush.state.radius > 9.0
    assert camera(tissue) == seen_from
    assert tissue.panels.panel("tissue").brush.radius.value == brush.state.radius


def test_only_what_a_lasso_selects_is_painted(tissue, document):
    window, face = tissue, document.project.face
    QTest.keyClick(window.viewport.canvas, Qt.Key.Key_B, Qt.KeyboardModifier.ShiftModifier)
    assert window.toolbox.tool.id == "lasso"
    corners = [(0.52, 0.50), (0.60, 0.50), (0.60, 0.70), (0.52, 0.70), (0.52, 0.51)]
    stroke(window, [at(window, *corner) for corner in corners])
    selected = window.toolbox.bench.regions.selected(face)
    assert selected is not None
    # From the front the subject's left is at the right; what lies behind what is seen is not selected.
    assert (face.skin.positions[selected, 0] > 0).all()
    ears = face.skin.positions[[face.landmarks["tragus_L"], face.landmarks["tragus_R"]], 2]
    assert (face.skin.positions[selected, 2] > ears.max()).all()
    QTest.keyClick(window.viewport.canvas, Qt.Key.Key_B)
    stroke(window, [at(window, 0.45, 0.58), at(window, 0.56, 0.58)])
    painted = document.project.face.layers.stiffness != face.layers.stiffness
    assert painted.any()
    assert selected[painted].all()


def test_a_stroke_is_solved_in_the_background_with_the_expression_kept_on(open_window, document, qtbot):
    window = open_window(document, EditingSolve())
    qtbot.waitUntil(lambda: not window.context.solving.job.running)
    document.set_weights({"12": 0.8})
    window.context.view.look_from("front")
    window.context.view.change(workspace="tissue")
    qtbot.waitUntil(lambda: not window.context.solving.job.running)
    next_frame(window)
    first, posed = document.solution.basis, window.viewport.scene.figure.posed
    before = posed.points.copy()
    window.toolbox.bench.brush.change(radius=15.0, strength=1.0)
    window.toolbox.bench.brush.set_value(0.05)
    stroke(window, [at(window, 0.57, 0.64), at(window, 0.59, 0.56)])
    assert document.stale
    qtbot.waitUntil(lambda: not document.stale)
    next_frame(window)
    assert not np.array_equal(document.solution.basis.moving_field("12L"), first.moving_field("12L"))
    assert document.shown["12L"] == 0.8
    # The same figure goes on, posed by the new fields, and the face before is one switch away.
    assert window.viewport.scene.figure.posed is posed
    after = posed.points.copy()
    assert document.last_change_map().max() > 0.1
    assert not np.allclose(after, before, atol=0.1)
    window.context.view.change(before=True)
    next_frame(window)
    assert np.allclose(posed.points, before, atol=1e-4)
