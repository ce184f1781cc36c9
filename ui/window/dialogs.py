"""Questions and answers."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from app.actions.context import Answer, FileQuestion

Button = QMessageBox.StandardButton


def ask_path(parent: QWidget, question: FileQuestion) -> Path | None:
    """A file chosen in the system's dialog; none if the person thought better of it."""
    endings = " ".join(f"*{suffix}" for suffix in (question.suffix, *question.also))
    kinds = f"{question.kind} ({endings})"
    ask = QFileDialog.getSaveFileName if question.writes else QFileDialog.getOpenFileName
    chosen, _kind = ask(parent, question.title, str(question.start), kinds)
    return Path(chosen) if chosen else None


def ask_unsaved(parent: QWidget, name: str) -> Answer:
    """What to do with unsaved changes."""
    box = QMessageBox(parent)
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setWindowTitle("Unsaved changes")
    box.setIcon(QMessageBox.Icon.NoIcon)
    box.setText(f"“{name}” has changes that are not saved.")
    box.setInformativeText("Discarded changes cannot be brought back.")
    box.setStandardButtons(Button.Save | Button.Discard | Button.Cancel)
    box.setDefaultButton(Button.Save)
    box.setEscapeButton(Button.Cancel)
    answers: dict[int, Answer] = {Button.Save.value: "save", Button.Discard.value: "discard"}
    return answers.get(box.exec(), "cancel")


def ask_stop(parent: QWidget, name: str) -> bool:
    """Whether an export that is under way may be stopped."""
    box = QMessageBox(parent)
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setWindowTitle("Export under way")
    box.setIcon(QMessageBox.Icon.NoIcon)
    box.setText(f"“{name}” is still being exported.")
    box.setInformativeText("Stop the export, and close the window? A file that was there before stays.")
    box.setStandardButtons(Button.Discard | Button.Cancel)
    box.button(Button.Discard).setText("Stop and close")
    box.button(Button.Cancel).setText("Go on")
    box.setDefaultButton(Button.Cancel)
    return box.exec() == Button.Discard


def show_error(parent: QWidget, sentence: str, details: str = "") -> None:
    """One sentence that says what went wrong, where, and what to do about it."""
    box = QMessageBox(parent)
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setWindowTitle("Risorius")
    box.setIcon(QMessageBox.Icon.Warning)
    box.setText(sentence)
    if details:
        box.setDetailedText(details)
    box.setStandardButtons(Button.Ok)
    box.exec()
