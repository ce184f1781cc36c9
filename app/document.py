"""The document: the one mutable owner of a project, its file, its history and its solution."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from app.authoring.bare import bare_project
from app.commands import Command, ReplaceProject, set_weights
from app.commands.edit import edit
from app.differences import Changes, changes
from app.document_state import DocumentState
from app.history import History
from app.solved import Solved
from app.weights import checked_weights, emotion_weights, in_order, whole_expression, with_weights
from facemodel.errors import ProjectError
from facemodel.io.project_file import load_project, save_project
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solve import Solution


class Document(DocumentState):
    """A project in hand.  Everything that changes it goes through here; everyone who shows it listens.

    Intents belong to one thread.  Weights that are held (`preview`) when another intent comes are committed first:
    nothing seen is lost.

    Raises
    ------
    RisoriusError
        By any intent that is given what cannot be done; the document is then as it was before.
    """

    def play(self, weights: Mapping[str, float]) -> None:
        """Show weights by field over those of the project, until the next call or until somebody sets them."""
        self._played = dict(weights)
        self._show()

    def preview(self, weights: Mapping[str, float]) -> None:
        """Show other weights without a step to undo; further calls add to those that are held."""
        self._held.update(checked_weights(weights, self._project))
        self._show()

    def commit(self, label: str = "") -> None:
        """Make the held weights one step to undo; nothing if there are none or they change nothing."""
        held, self._held = self._held, {}
        self._weigh(held, label)

    def cancel_preview(self) -> None:
        """Let go of the held weights; what was committed last is shown again."""
        self._held = {}
        self._show()

    def run(self, command: Command) -> None:
        """Do a command and remember it."""
        self.commit()
        self._do(command)

    def edit(self, after: Project, label: str, gesture: str = "") -> None:
        """Go to another state of the project, as pure functions on projects give it, in one step.

        Parameters
        ----------
        after : made of `project`
        label : what the step is called
        gesture : consecutive steps with the same gesture, such as one drag of a slider, become one
        """
        self.commit()
        self._do(edit(self._project, after, label, gesture))

    def retract(self, gesture: str) -> None:
        """Take a gesture back that is under way, as if it had never begun; nothing if no step is of it."""
        self.commit()
        step = self._history.to_undo
        if step is not None and gesture and step.gesture == gesture:
            project = step.undo(self._project)
            self._history.drop_last()
            self._become(project)

    def undo(self) -> None:
        """Take the last step back; nothing if there is none."""
        self.commit()
        step = self._history.to_undo
        if step is not None:
            project = step.undo(self._project)
            self._history.step_back()
            self._become(project)

    def redo(self) -> None:
        """Do the last undone step again; nothing if there is none."""
        self.commit()
        step = self._history.to_redo
        if step is not None:
            project = step.do(self._project)
            self._history.step_forth()
            self._become(project)

    def set_weights(self, weights: Mapping[str, float], label: str = "", gesture: str = "") -> None:
        """Give some units other weights, in one step.

        Parameters
        ----------
        weights : by any name that `facemodel.actions.resolve` knows
        label : what the step is called; the unit's name if empty
        gesture : consecutive steps with the same gesture, such as nudges of one field, become one
        """
        checked = checked_weights(weights, self._project)
        self.commit()
        self._weigh(checked, label, gesture)

    def set_expression(self, weights: Mapping[str, float], label: str) -> None:
        """Put an expression in the place of the one there is, in one step."""
        checked = checked_weights(weights, self._project)
        self.commit()
        self._weigh(whole_expression(checked, self._project), label)

    def apply_emotion(self, name: str, strength: float = 1.0) -> None:
        """Show an emotion and nothing else, in one step."""
        weights = emotion_weights(name, strength, self._project)
        self.commit()
        self._weigh(weights, f"{name.capitalize()} {strength:.0%}")

    def reset_expression(self) -> None:
        """All weights to zero, in one step."""
        self.set_expression({}, "Neutral face")

    def switch_face(self, face_key: str) -> None:
        """Go to another individual and keep the expression, in one step."""
        other = new_project(face_key)
        self.commit()
        kept = {name: weight for name, weight in self._project.expression.items() if weight != 0}
        kept_on = replace(other, expression=kept, animation=self._project.animation)
        self._do(ReplaceProject(other.face.title, self._project, kept_on))

    def new(self, face_key: str) -> None:
        """Begin a project on one of the shipped faces; history and file are forgotten."""
        self._begin(new_project(face_key), None)

    def new_bare(self, face_key: str) -> None:
        """Begin a project on the head of a shipped face, with no muscle, no paint and no action unit."""
        self._begin(bare_project(face_key), None)

    def begin(self, project: Project) -> None:
        """Begin with a project that was made elsewhere, an example say; history and file are forgotten."""
        self._begin(project, None)

    def open(self, path: Path) -> None:
        """Read a project; if that fails all stays as it was."""
        self._begin(load_project(path), path)

    def restore(self, project: Project, path: Path | None) -> None:
        """Go on with a project that was brought back after a crash, as changes of its file that are not saved."""
        self._begin(project, path, saved=False)

    def save(self, path: Path | None = None) -> None:
        """Write the project, to its own file if none is named.

        Raises
        ------
        ProjectError
            If it cannot be written, or has no file and none is named; file and document stay as they were.
        """
        target = path or self._path
        if target is None:
            raise ProjectError("This project has no file yet; choose one with “Save as”.")
        self.commit()
        save_project(self._project, target)
        self._path, self._saved = target, self._project
        self._history.mark_saved()
        self.saved_changed.emit()

    def accept(self, solution: Solution, solved: Project) -> None:
        """Take the solution of a snapshot; one of another head, or of an outdated project, is dropped."""
        if self._solutions.accept(Solved(solution, solved), self._project):
            self.solution_changed.emit(self.solution)

    def _weigh(self, weights: Mapping[str, float], label: str, gesture: str = "") -> None:
        """Give fields weights that a person set: to the sliders, or as keys where `keying` says so."""
        self._played = {name: each for name, each in self._played.items() if name not in weights}
        if self.keying is None or not weights:
            self._do(set_weights(self._project, weights, label, gesture))
        else:
            self._do(edit(self._project, self.keying(self._project, weights), label or "Set keys", gesture))

    def _do(self, command: Command) -> None:
        if not command.changes:
            self._show()
            return
        project = command.do(self._project)
        self._history.push(command)
        self._become(project)

    def _begin(self, project: Project, path: Path | None, saved: bool = True) -> None:
        begun = in_order(project)
        self._history = History(saved=saved)
        self._held, self._played = {}, {}
        self._path, self._saved = path, begun if saved else None
        self._become(begun, Changes(whole=True))

    def _become(self, project: Project, known: Changes | None = None) -> None:
        """Take another state of the project and tell everyone what is different."""
        before, stood = self._project, self._solutions.standing
        self._project = project
        found = known or changes(before, project)
        if found:
            self._solutions.follow(project)
        shown = with_weights(project.expression, self._played)
        expression_moved, self._shown = self._shown != shown, shown
        self.tell_changes(found, project)
        if self._solutions.standing != stood:
            self.solution_changed.emit(self.solution)
        if expression_moved or found.whole:
            self.expression_changed.emit(self._shown)
        self.history_changed.emit()
        self.saved_changed.emit()

    def _show(self) -> None:
        expression = with_weights(self._project.expression, {**self._played, **self._held})
        if expression != self._shown:
            self._shown = expression
            self.expression_changed.emit(expression)
