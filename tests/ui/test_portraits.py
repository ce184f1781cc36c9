"""Portraits show the expressions of the face in hand, and are taken anew when they no longer do."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget

from app.authoring.emotions import renamed, with_expression
from app.document import Document
from facemodel.sculpting.correction import correction_of
from facemodel.solve import solve_project
from tests.ui.hands import let_go
from ui.portraits import NEUTRAL, Portraits
from ui.portraits.studio import SIZE
from ui.theme.apply import apply_theme
from ui.theme.roles import DARK, LIGHT


@pytest.fixture(autouse=True)
def _nobody_is_busy(monkeypatch: pytest.MonkeyPatch, shown) -> None:
    """No hand is at work, and nobody changes anything, so that there is nothing to wait for."""
    monkeypatch.setattr("ui.portraits.portraits.REST", 20)
    let_go(shown(QWidget()))


@pytest.fixture
def solved(document: Document) -> Document:
    document.accept(solve_project(document.project), document.project)
    return document


def wait(qtbot, portraits: Portraits) -> None:
    qtbot.waitUntil(lambda: portraits.complete)


def pixels(picture: QImage | None) -> np.ndarray:
    assert picture is not None
    assert (picture.width(), picture.height()) == SIZE
    plain = picture.convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(plain.constBits(), dtype=np.uint8).reshape(SIZE[1], plain.bytesPerLine())
    return rows[:, : 3 * SIZE[0]].astype(int).reshape(SIZE[1], SIZE[0], 3)


def test_every_expression_has_one_and_they_differ(solved, portraits, qtbot):
    portraits.refresh()
    wait(qtbot, portraits)
    rest, happy = pixels(portraits.picture(NEUTRAL)), pixels(portraits.picture("happiness"))
    assert rest.std() > 5
    assert np.abs(rest - happy).max() > 20
    assert portraits.picture("nobody") is None


def test_only_what_no_longer_shows_the_face_is_taken_anew(solved, portraits, qtbot):
    portraits.refresh()
    wait(qtbot, portraits)
    taken: list[str] = []
    portraits.taken.connect(taken.append)
    solved.edit(with_expression(solved.project, "sulk", {"17": 1.0}), "Keep")
    wait(qtbot, portraits)
    assert taken == ["sulk"]
    solved.edit(renamed(solved.project, "sulk", "pout"), "Rename")
    wait(qtbot, portraits)
    assert taken == ["sulk", "pout"]
    before = pixels(portraits.picture("pout"))
    bump = np.zeros((len(solved.project.face.skin.positions), 3))
    bump[30:50, 2] = 20.0
    solved.edit(replace(solved.project, corrections={"17": correction_of(bump)}), "Sculpt")
    wait(qtbot, portraits)
    assert np.abs(pixels(portraits.picture("pout")) - before).max() > 20


def test_none_is_taken_while_a_hand_holds_a_weight(solved, portraits, qtbot):
    portraits.refresh()
    solved.preview({"17": 0.5})
    qtbot.wait(300)
    assert portraits.picture(NEUTRAL) is None
    solved.commit()
    wait(qtbot, portraits)
    assert portraits.picture(NEUTRAL) is not None


def test_without_a_solution_there_is_nothing_to_take(document, portraits, qtbot):
    portraits.refresh()
    qtbot.wait(300)
    assert portraits.complete
    assert portraits.picture(NEUTRAL) is None


def test_another_theme_has_another_backdrop(solved, portraits, qtbot, qapp):
    portraits.refresh()
    wait(qtbot, portraits)
    dark = pixels(portraits.picture(NEUTRAL))[0, 0].mean()
    try:
        apply_theme(qapp, LIGHT)
        portraits.refresh()
        wait(qtbot, portraits)
        assert pixels(portraits.picture(NEUTRAL))[0, 0].mean() > dark + 40
    finally:
        apply_theme(qapp, DARK)


def test_a_closed_studio_takes_no_more(solved, qtbot):
    portraits = Portraits(solved)
    portraits.refresh()
    portraits.close()
    solved.edit(with_expression(solved.project, "sulk", {"17": 1.0}), "Keep")
    qtbot.wait(300)
    assert portraits.picture("sulk") is None
