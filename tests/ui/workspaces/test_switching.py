"""Going from one workspace to another."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from tests.ui.window.seen import next_frame, points
from ui.window.main_window import MainWindow


def camera(window: MainWindow) -> tuple[object, ...]:
    camera = window.viewport.scene.renderer.GetActiveCamera()
    return camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp(), camera.GetViewAngle()


def test_another_workspace_keeps_camera_and_pose_and_brings_its_panel_and_tools(window, document):
    document.set_weights({"12": 0.6})
    QTest.mousePress(window.viewport.canvas, Qt.MouseButton.RightButton, pos=QPoint(300, 300))
    QTest.mouseMove(window.viewport.canvas, QPoint(350, 310))
    QTest.mouseRelease(window.viewport.canvas, Qt.MouseButton.RightButton, pos=QPoint(350, 310))
    posed, seen_from = points(window), camera(window)
    assert not window.binding.qt["tool.brush"].isVisible()
    place = window.tabs.tabRect(window.tabs.count() - 1).center()
    QTest.mouseClick(window.tabs, Qt.MouseButton.LeftButton, pos=place)
    next_frame(window)
    workspace = window.context.view.state.workspace
    assert workspace == "tissue"
    assert window.panels.currentWidget() is window.panels.panel("tissue")
    assert window.toolbox.tool.id == "brush"
    assert window.binding.qt["tool.brush"].isVisible()
    assert camera(window) == seen_from
    assert (points(window) == posed).all()


def test_tab_over_the_face_goes_round_the_workspaces_and_tab_in_a_panel_does_not(window):
    canvas, count = window.viewport.canvas, window.tabs.count()
    canvas.setFocus()
    seen = []
    for _ in range(count):
        QTest.keyClick(canvas, Qt.Key.Key_Tab)
        seen.append(window.context.view.state.workspace)
        canvas.setFocus()
    assert len(set(seen)) == count
    assert seen[-1] == "expression"
    window.expression.search.setFocus()
    QTest.keyClick(window.expression.search, Qt.Key.Key_Tab)
    assert window.context.view.state.workspace == "expression"
    assert not window.expression.search.hasFocus()


def test_the_open_workspace_is_remembered(window, open_window, document):
    window.context.view.change(workspace="tissue")
    window.close()
    assert open_window(document).context.view.state.workspace == "tissue"
