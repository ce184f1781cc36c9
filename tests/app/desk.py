"""A person at a window, and what the window lets that person do."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from app.actions import Action, Answer, Context, FileQuestion, all_actions, perform
from app.actions.context import Merge
from app.authoring.fitted_muscles import Fitted
from facemodel.actions import ActionUnit
from facemodel.project import Project


@dataclass
class Desk:
    """A person at a window: answers as it was told, and writes down what the window was asked to do."""

    path: Path | None = None
    script: Path | None = None
    answer: Answer = "cancel"
    merge: Merge | None = None
    fitted: Fitted | None = None
    text: str = ""
    questions: list[FileQuestion | str] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)
    messages: list[str] = field(default_factory=list)
    calls: list[object] = field(default_factory=list)

    def ask_path(self, question: FileQuestion) -> Path | None:
        self.questions.append(question)
        return self.script if question.suffix == ".py" else self.path

    def ask_unsaved(self, name: str) -> Answer:
        self.questions.append(name)
        return self.answer

    def ask_merge(self, unit: ActionUnit, others: Sequence[ActionUnit]) -> Merge | None:
        self.questions.append(f"{unit.number} with one of {', '.join(str(each.number) for each in others)}")
        return self.merge

    def show_error(self, sentence: str) -> None:
        self.errors.append(sentence)

    def show_message(self, sentence: str) -> None:
        self.messages.append(sentence)

    def clipboard(self) -> str:
        return self.text

    def set_clipboard(self, text: str) -> None:
        self.text = text

    def save_picture(self, path: Path) -> None:
        self.calls.append(("save_picture", path))

    def show_export(self) -> None:
        self.calls.append("show_export")

    def perform(self) -> None:
        self.calls.append("perform")

    def may_stop_export(self) -> bool:
        return True

    def focus_unit(self, number: int) -> None:
        self.calls.append(("focus_unit", number))

    def frame_head(self) -> None:
        self.calls.append("frame_head")

    def frame_selection(self) -> None:
        self.calls.append("frame_selection")

    def focus_search(self) -> None:
        self.calls.append("focus_search")

    def ask_fitting(self, project: Project, folder: Path) -> Fitted | None:
        self.questions.append(f"muscles for {project.face.title}")
        return self.fitted

    def compare_models(self) -> None:
        self.calls.append("compare_models")

    def show_palette(self) -> None:
        self.calls.append("show_palette")

    def show_face_information(self) -> None:
        self.calls.append("show_face_information")

    def show_shortcuts(self) -> None:
        self.calls.append("show_shortcuts")

    def show_about(self) -> None:
        self.calls.append("show_about")

    def reset_layout(self) -> None:
        self.calls.append("reset_layout")

    def toggle_full_screen(self) -> None:
        self.calls.append("toggle_full_screen")

    def quit(self) -> None:
        self.calls.append("quit")


def find_action(action_id: str, context: Context) -> Action:
    (found,) = (action for action in all_actions(context) if action.id == action_id)
    return found


def do(action_id: str, context: Context) -> None:
    perform(find_action(action_id, context), context)
