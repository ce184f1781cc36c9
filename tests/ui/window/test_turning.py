"""An animation turns head and eyes while it moves the face."""

import numpy as np
from PySide6.QtWidgets import QApplication

from facemodel.kinematics import NO_TURN


def test_face_and_head_move_in_one_frame_that_is_posed_once(window, document, qtbot, monkeypatch):
    scene, poses = window.viewport.scene, []
    pose = scene.pose
    qtbot.wait(200)
    monkeypatch.setattr(scene, "pose", lambda expression: (poses.append(expression), pose(expression)))
    document.play({"12L": 0.5})
    window.viewport.turn_head({"head.yaw": 20.0})
    qtbot.waitUntil(lambda: bool(poses))
    QApplication.processEvents()
    assert poses == [{"12L": 0.5}]
    assert not np.allclose(scene.figure.posed.stance.head, np.eye(4))
    window.viewport.turn_head(NO_TURN)
    qtbot.waitUntil(lambda: len(poses) == 2)
    assert np.allclose(scene.figure.posed.stance.head, np.eye(4))
