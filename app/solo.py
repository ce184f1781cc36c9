"""Which expression is to be seen: the sliders', or one action unit alone."""

from __future__ import annotations

from app.document import Document
from app.view_state import ViewState
from facemodel.actions import Expression


def seen(document: Document, state: ViewState) -> Expression:
    """What a document shows, or in the Actions workspace the selected unit at 1 if that is asked for alone."""
    if state.solo and state.workspace == "actions":
        for unit in document.project.units:
            if unit.number == state.unit:
                return dict.fromkeys(unit.fields, 1.0)
    return document.shown
