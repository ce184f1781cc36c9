"""What to try at the first start: watched for on the document and the view, and gone once it is done."""

from __future__ import annotations

from app.actions.context import Context
from app.view_state import ViewState
from facemodel.actions import resolve
from facemodel.errors import UnknownNameError
from facemodel.project import Project
from ui.widgets.hint_card import HintCard
from ui.window.viewport_widget import Viewport

SMILE = "lip corner puller"
SURPRISE = "surprise"
TURN = "turn"


class FirstHints:
    """Shows the card over the viewport until it is followed or closed, and never again after that.

    Parameters
    ----------
    context : what is watched, and where it is remembered that the card was seen
    viewport : what the card lies over
    """

    def __init__(self, context: Context, viewport: Viewport) -> None:
        self._context = context
        self._viewport = viewport
        self.card: HintCard | None = None
        if context.settings.preferences.hint_done:
            return
        self.card = HintCard("Three things to try", _hints(context.document.project))
        self.card.dismissed.connect(self._finish)
        viewport.lay_over(self.card)
        context.document.history_changed.connect(self._follow_history)
        context.view.changed.connect(self._follow_view)

    def _follow_history(self) -> None:
        step = self._context.document.history.to_undo
        if self.card is None or step is None:
            return
        for key in (SMILE, SURPRISE):
            if step.label.lower().startswith(key):
                self.card.tick(key)

    def _follow_view(self, now: ViewState, _before: ViewState) -> None:
        if self.card is not None and now.view == "free":
            self.card.tick(TURN)

    def _finish(self) -> None:
        card, self.card = self.card, None
        if card is not None:
            self._context.document.history_changed.disconnect(self._follow_history)
            self._context.view.changed.disconnect(self._follow_view)
            self._viewport.take_off(card)
            self._context.settings.change(hint_done=True)


def _hints(project: Project) -> list[tuple[str, str]]:
    """Only what this face can do."""
    hints = [(TURN, "Turn the head: <b>right-drag</b> across the face")]
    if any(emotion.name == SURPRISE for emotion in project.emotions):
        hints.insert(0, (SURPRISE, "Click <b>Surprise</b>"))
    try:
        resolve(SMILE, project.units)
    except UnknownNameError:
        return hints
    return [(SMILE, "Drag <b>Lip corner puller</b> to the right"), *hints]
