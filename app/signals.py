"""What a document tells those who show it."""

from __future__ import annotations

from psygnal import Signal

from app.differences import Changes
from facemodel.project import Project


class DocumentSignals:
    """The signals of a document.  All those of one intent are emitted after the whole state is settled."""

    project_changed = Signal(object)
    """(Project) another head or other settings: everything drawn is to be made anew.  What is less is told alone:"""
    layers_changed = Signal(str, object)
    """(name of a painted array, its skin vertices (k,) with other values)"""
    skull_changed = Signal()
    """The bones or the hinge of the jaw are others."""
    muscles_changed = Signal(object)
    """(frozenset of keys) of muscles that changed, came, went or stand elsewhere in the list."""
    units_changed = Signal(object)
    """(frozenset of numbers) of action units that changed, came, went or stand elsewhere in the list."""
    emotions_changed = Signal(object)
    """(frozenset of names) of emotions that changed, came, went or stand elsewhere in the list."""
    corrections_changed = Signal(object)
    """(frozenset of field names) whose correction, sculpted on top of what is solved, changed, came or went."""
    animation_changed = Signal(object)
    """(frozenset of channels and names) whose track changed, came, went or stands elsewhere, and of the other members
    of `facemodel.animation.clip.Animation` that changed; together with `project_changed` all may be others."""
    expression_changed = Signal(object)
    """(Expression) what is to be shown now, `shown`."""
    solution_changed = Signal(object)
    """(Solution | None) another basis, or none, or the one there is has become stale or fresh."""
    history_changed = Signal()
    """Other steps to undo or redo."""
    saved_changed = Signal()
    """`path` or `dirty` may be different."""

    def tell_changes(self, found: Changes, project: Project) -> None:
        """Emit what follows from the changes that led to a project, and no more."""
        if found.whole:
            self.project_changed.emit(project)
            return
        if found.skull:
            self.skull_changed.emit()
        for name, vertices in found.layers.items():
            self.layers_changed.emit(name, vertices)
        for signal, which in (
            (self.muscles_changed, found.muscles),
            (self.units_changed, found.units),
            (self.emotions_changed, found.emotions),
            (self.corrections_changed, found.corrections),
            (self.animation_changed, found.animation),
        ):
            if which:
                signal.emit(which)
