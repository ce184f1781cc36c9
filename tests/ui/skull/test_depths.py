"""How deep the bone lies is seen on the skin and read beside the tables; what is wrong is told and shown."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.authoring.skull import with_pose
from facemodel.face import Pose
from tests.ui.hands import move
from tests.ui.skull.conftest import click, tick
from tests.ui.window.seen import differs, next_frame, picture
from tests.ui.workspaces.test_switching import camera
from ui.viewport.overlays.depth_map import OUT, depth_colours


def drawing(editor, name: str):
    return next(each for each in editor.panels._drawings["skull"] if type(each).__name__ == name)


def pushed_out(editor, qtbot, forward: float = 16.0) -> None:
    """Move the skull forward until it comes through the skin."""
    document = editor.context.document
    document.edit(with_pose(document.project, Pose((0.0, 0.0, forward))), "Move skull")
    qtbot.waitUntil(lambda: editor.toolbox.bench.watch.current)
    next_frame(editor)


def test_the_map_lies_on_the_skin_with_a_legend_in_millimetres(skull):
    bare = picture(skull)
    panel, depth = skull.panels.panel("skull"), drawing(skull, "DepthMap")
    assert depth._legend.legend is None
    tick(panel.depth.map)
    assert skull.context.view.state.depth_map
    assert depth._legend.legend.unit == "mm"
    assert differs(picture(skull), bare)
    tick(panel.depth.map)
    assert depth._legend.legend is None
    skull.toolbox.leave()
    assert not differs(picture(skull), bare)


def test_bone_that_is_outside_has_a_colour_of_its_own():
    colours = depth_colours(np.array([-1.0, 0.0, 25.0]))
    assert colours[0] == pytest.approx(OUT)
    assert not np.allclose(colours[1], OUT, atol=0.2)
    assert colours[2, 0] > 0.9


def test_the_table_says_what_is_wanted_and_what_is_on_both_sides(skull):
    table = skull.panels.panel("skull").depth.table
    lines = table.lines
    assert len(lines) == 21
    assert lines[2].startswith("Nasion: 7.0, 7.")
    assert next(line for line in lines if line.startswith("Zygion")).count(",") == 2
    assert "rms" in skull.panels.panel("skull").depth.words.text()


def test_a_landmark_that_is_pointed_at_is_marked_on_the_face(skull):
    table, marks = skull.panels.panel("skull").depth.table, drawing(skull, "DepthMap")._marks
    next_frame(skull)
    assert not marks["skin"].actor.GetVisibility()
    row = next(k for k, line in enumerate(table.lines) if line.startswith("Pogonion"))
    move(table, QPoint(20, 20 * (row + 1) + 8))
    next_frame(skull)
    assert marks["skin"].actor.GetVisibility()
    face = skull.context.document.project.face
    centre = marks["skin"].actor.GetBounds()[::2]
    assert np.allclose(centre, face.skin.positions[face.landmarks["pogonion"]], atol=1e-3)


def test_a_sound_skull_is_said_to_be_sound(skull):
    lines = skull.panels.panel("skull").faults.lines
    assert lines["pierced"].words.text() == "No bone comes through the skin."
    assert lines["through"].words.text() == "No spring goes through bone."
    assert not any(line.show_me.isVisible() for line in lines.values())


def test_a_skull_that_intersects_the_skin_is_told_where_and_how_deep_and_shown(skull, document, qtbot):
    pushed_out(skull, qtbot)
    lines = skull.panels.panel("skull").faults.lines
    said = lines["pierced"].words.text()
    assert said.startswith("Bone comes through the skin at ")
    assert " mm near the " in said
    assert "go through bone" in lines["through"].words.text()
    assert "not solved" in lines["through"].words.text()
    faults = drawing(skull, "BoneFaults")
    assert faults._marks["pierced"].actor.GetVisibility()
    before = camera(skull)
    click(lines["pierced"].show_me)
    assert camera(skull) != before
    document.undo()
    qtbot.waitUntil(lambda: skull.toolbox.bench.watch.current)
    next_frame(skull)
    assert not faults._marks["pierced"].actor.GetVisibility()
    assert lines["pierced"].words.text() == "No bone comes through the skin."


def test_leaving_the_workspace_takes_all_of_it_off_the_face(skull, qtbot):
    skull.context.view.change(workspace="expression")
    bare = picture(skull)
    skull.context.view.change(workspace="skull")
    skull.context.view.change(depth_map=True)
    pushed_out(skull, qtbot)
    skull.context.document.undo()
    skull.context.view.change(workspace="expression")
    QApplication.processEvents()
    QTest.qWait(50)
    assert not differs(picture(skull), bare)
