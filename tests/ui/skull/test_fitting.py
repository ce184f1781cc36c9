"""A skull from a file is read in the background, fitted by landmarks that a hand picks on it, and used in one step."""

from pathlib import Path

import numpy as np
import pytest
import trimesh
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMessageBox
from scipy.spatial import KDTree
from scipy.spatial.transform import Rotation

from app.document import Document
from facemodel.sameness import same
from facemodel.skull.depths import whole
from tests.ui.hands import move
from tests.ui.skull.conftest import click
from tests.ui.window.seen import differs, next_frame, picture, pixel
from ui.window.main_window import MainWindow

NAMES = ("nasion", "pogonion", "zygion_L", "gonion_L", "glabella", "rhinion")
"""Landmarks that are seen from the subject's left; they lie in a plane, which tells nothing of the other side."""

ABOUT = 30.0
"""Millimetres about them within which they tell where bone is."""


@pytest.fixture
def file(project, tmp_path: Path) -> Path:
    """The face's own skull in centimetres, lying on its side, a tenth taller."""
    bone = whole(project.face.skull)
    turn = Rotation.from_euler("xyz", (90, 0, 90), degrees=True).as_matrix()
    places = bone.positions * [1.0, 1.1, 1.0] / 10 @ turn.T + [3.0, 70.0, 5.0]
    path = tmp_path / "found.stl"
    trimesh.Trimesh(places, bone.triangles, process=False).export(path)
    return path


@pytest.fixture
def fitting(skull: MainWindow, file: Path, qtbot) -> MainWindow:
    """Read the file and begin to fit it."""
    bench = skull.toolbox.bench
    bench.importing.read(file, bench.deliver)
    qtbot.waitUntil(lambda: bench.fitting.on)
    next_frame(skull)
    return skull


def place_of(editor, name: str) -> np.ndarray:
    """Return the vertex of the guest that is nearest to where a landmark should lie."""
    own = editor.toolbox.bench.fitting
    return own.mesh.positions[own.mesh.tree.query(own.guest.targets[name])[1]]


def pick(editor, name: str) -> None:
    """Ask for a landmark in the list, and click on it in the picture."""
    page = editor.panels.panel("skull").fit
    QTest.mouseClick(page.rows[name], Qt.MouseButton.LeftButton)
    QTest.mouseClick(editor.viewport.canvas, Qt.MouseButton.LeftButton, pos=pixel(editor, place_of(editor, name)))
    QApplication.processEvents()


def test_a_skull_lies_in_the_head_before_anything_is_picked(fitting, document):
    page, own = fitting.panels.panel("skull").fit, fitting.toolbox.bench.fitting
    assert fitting.panels.panel("skull").pages.currentWidget() is page
    assert fitting.toolbox.tool.id == "skull-landmark"
    assert "14 960 triangles" in page.account.text()
    assert "Nasion" in page.lead.text()
    away = document.project.face.skull.cranium.tree.query(own.mesh.positions[:5000])[0]
    assert np.median(away) < 4
    assert not page.use.isEnabled()
    offered = {tool.id for tool in fitting.toolbox.offered("skull")}
    assert offered == {"select", "skull-landmark"}


def test_picks_fit_it_and_say_what_they_miss_and_using_it_is_one_step(fitting, document, tmp_path):
    before = document.project
    page, own = fitting.panels.panel("skull").fit, fitting.toolbox.bench.fitting
    for name in NAMES:
        pick(fitting, name)
    assert set(own.picked) == set(NAMES)
    assert page.rows["nasion"].missed.text().endswith(" mm")
    assert "6 landmarks are missed by" in page.result.text()
    assert page.use.isEnabled()
    assert document.project is before
    targets = [own.guest.targets[name] for name in NAMES]
    click(page.use)
    assert document.history.done == ("Import skull found.stl",)
    assert not own.on
    after = document.project.face.skull
    bone, fitted = whole(before.face.skull), whole(after)
    near = KDTree(targets).query(fitted.positions)[0] < ABOUT
    assert np.median(bone.tree.query(fitted.positions[near])[0]) < 4
    assert 0.6 < len(after.mandible.triangles) / len(before.face.skull.mandible.triangles) < 1.4
    path = tmp_path / "imported.risorius"
    document.save(path)
    reopened = Document(before)
    reopened.open(path)
    assert same(reopened.project.face.skull, after)
    document.undo()
    assert same(document.project.face, before.face)
    assert same(document.project.muscles, before.muscles)


@pytest.mark.parametrize(
    "take_back",
    [
        lambda canvas, _at: QTest.keyClick(canvas, Qt.Key.Key_Escape),
        lambda canvas, _at: QTest.keyClick(canvas, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier),
        lambda canvas, at: QTest.mouseClick(canvas, Qt.MouseButton.RightButton, pos=at),
    ],
    ids=["esc", "undo", "right button"],
)
def test_a_pick_is_dragged_and_put_back(fitting, take_back):
    own, canvas = fitting.toolbox.bench.fitting, fitting.viewport.canvas
    pick(fitting, "pogonion")
    before = own.picked["pogonion"].copy()
    start = pixel(fitting, own.laid(before[None])[0])
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=start)
    for step in range(1, 7):
        move(canvas, start + QPoint(3 * step, -3 * step))
    fitting.hands.flush()
    assert not np.array_equal(own.picked["pogonion"], before)
    take_back(canvas, start)
    move(canvas, start - QPoint(9, 9))
    fitting.hands.flush()
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=start)
    assert np.array_equal(own.picked["pogonion"], before)
    assert not own.held
    row = fitting.panels.panel("skull").fit.rows["pogonion"]
    click(row.drop)
    assert not own.picked


def test_proposed_landmarks_fit_the_own_skull_closely_and_scales_are_those_it_was_made_with(fitting):
    page, own = fitting.panels.panel("skull").fit, fitting.toolbox.bench.fitting
    click(page.deeds.by_name["Propose"])
    assert len(own.picked) == len(own.guest.targets) == 17
    assert own.fit.rms < 2.5
    x, y, z = sorted(own.fit.scale)
    assert (x / z, y / z) == pytest.approx((10 / 1.1 / 10, 1.0), abs=0.06)
    click(page.kinds.button("bent"))
    assert own.fit.rms < 1e-3
    click(page.deeds.by_name["Clear"])
    assert own.fit is None


def test_cancel_brings_the_own_skull_back_and_leaves_no_trace(skull, file, document, qtbot):
    skull.toolbox.leave()
    bare, before = picture(skull), document.project
    bench = skull.toolbox.bench
    bench.importing.read(file, bench.deliver)
    qtbot.waitUntil(lambda: bench.fitting.on)
    assert differs(picture(skull), bare)
    click(skull.panels.panel("skull").fit.cancel)
    assert document.project is before
    assert skull.toolbox.tool.id == "move-skull"
    skull.toolbox.leave()
    assert not differs(picture(skull), bare)


def test_a_file_that_is_no_skull_is_said_in_a_sentence_and_nothing_is_begun(skull, tmp_path, answer, qtbot):
    said = answer(QMessageBox.StandardButton.Ok)
    path = tmp_path / "broken.ply"
    path.write_bytes(b"ply\nformat ascii 1.0\nelement vertex 99999999\nend_header\n")
    bench = skull.toolbox.bench
    bench.importing.read(path, bench.deliver)
    assert skull.panels.panel("skull").bone.stop.isVisible()
    qtbot.waitUntil(lambda: bool(said))
    assert "broken.ply" in said[0]
    assert "should have 99999999 vertices and is shorter than that" in said[0]
    assert not bench.fitting.on
    assert not skull.panels.panel("skull").bone.stop.isVisible()


def test_reading_can_be_stopped(skull, file, qtbot):
    bench = skull.toolbox.bench
    bench.importing.read(file, bench.deliver)
    click(skull.panels.panel("skull").bone.stop)
    assert not bench.importing.running
    QTest.qWait(200)
    assert not bench.fitting.on
