"""Muscles of another head: chosen, reported and laid in one step."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog

from app.authoring.bare import bare_project
from app.authoring.fitted_muscles import with_fitted_muscles
from facemodel.io.project_file import save_project
from facemodel.projects import new_project
from facemodel.sameness import same
from tests.app.desk import Desk
from ui.panels.muscles.deeds import fit
from ui.panels.muscles.fitting_page import FittingPage


@pytest.fixture
def page(shown, tmp_path) -> FittingPage:
    return shown(FittingPage(None, bare_project("ben"), tmp_path))


def ready(page: FittingPage, qtbot) -> None:
    qtbot.waitUntil(page.fit.isEnabled)


def test_the_report_is_there_before_anything_is_changed(page, qtbot):
    assert page.source.currentData() == "ada"
    assert not page.fit.isEnabled()
    ready(page, qtbot)
    assert f"{len(new_project().muscles)} muscles by" in page.report.text()
    QTest.mouseClick(page.fit, Qt.MouseButton.LeftButton)
    assert page.result() == QDialog.DialogCode.Accepted
    assert len(page.outcome.project.muscles) == len(new_project().muscles)


def test_a_project_s_muscles_are_taken_from_its_file(page, qtbot, tmp_path):
    ready(page, qtbot)
    ada = new_project("ada")
    path = tmp_path / "mine.risorius"
    save_project(replace(ada, muscles=ada.muscles[:4], units=(), emotions=()), path)
    page.take_file(path)
    assert not page.fit.isEnabled()
    ready(page, qtbot)
    assert "4 muscles by" in page.report.text()
    assert page.source.currentText() == "mine"


def test_a_file_that_is_no_project_is_said_to_be_none(page, qtbot, tmp_path):
    ready(page, qtbot)
    path = tmp_path / "broken.risorius"
    path.write_text("nothing")
    page.take_file(path)
    qtbot.waitUntil(lambda: page.report.property("role") == "error")
    assert "broken.risorius" in page.report.text()
    assert not page.fit.isEnabled()


def test_fitted_muscles_are_one_step(context, desk: Desk):
    document = context.document
    ada, bare = new_project("ada"), bare_project("chen")
    document.restore(bare, None)
    desk.fitted = with_fitted_muscles(bare, replace(ada, muscles=ada.muscles[:8]))
    fit(context)
    assert len(document.project.muscles) == 8
    assert document.history.done == ("Fit muscles of another head",)
    assert "8 muscles by" in desk.messages[-1]
    document.undo()
    assert same(document.project.muscles, bare.muscles)


def test_locked_muscles_are_not_replaced(context, desk: Desk):
    ada = new_project("ada")
    project = replace(new_project("ben"), units=(), emotions=())
    context.document.restore(project, None)
    context.view.lock(["corrugator_L"])
    desk.fitted = with_fitted_muscles(project, ada)
    fit(context)
    assert context.document.history.done == ()
    assert "locked" in desk.messages[-1]
