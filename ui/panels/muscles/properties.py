"""All that can be said of the selected muscles, and changed: who they are, their numbers, where they lie."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QLabel, QLayout, QLineEdit, QVBoxLayout, QWidget

from app.actions.context import Context
from app.view_state import ViewState
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS
from ui.panels.muscles.deeds import users_text
from ui.panels.muscles.editing import MuscleEdit
from ui.panels.muscles.fibre_list import FibreList
from ui.panels.muscles.identity import MuscleIdentity
from ui.panels.muscles.parameter_bars import ParameterBars
from ui.panels.muscles.ring_form import RingForm
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar
from ui.widgets.plain_label import PlainLabel

LAY = (
    "take the fibre tool (N), press on the skull and drag to the skin; the ring tool (Shift+N) draws a "
    "sphincter on the skin, the fold tool (Shift+F) a line along which it creases."
)
SELECT = f"Select a muscle here or on the face. To lay a new one {LAY}"
BEGIN = f"This head has no muscles yet. To lay one {LAY} Or fit those of another head: the plus sign has them."


class MuscleProperties(QWidget):
    """Shows the selected muscles; places are those of the one that was selected last.

    Signals
    -------
    compared() : the models are to be compared side by side
    """

    compared = Signal()

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self.edit = MuscleEdit(context, self.show_muscles)
        self.identity = MuscleIdentity(self.edit)
        self.parameters = ParameterBars(self.edit)
        self.fibres = FibreList(self.edit)
        self.ring = RingForm(self.edit)
        self.users = _quiet("")
        self._locked = _quiet("")
        self._nothing = _quiet("")
        self._form = QWidget()
        self._lay_out()
        self.identity.compared.connect(self.compared)
        document = context.document
        for changed in (document.project_changed, document.muscles_changed, document.units_changed):
            changed.connect(lambda _what: self.show_muscles())
        context.view.changed.connect(self._follow)
        self.show_muscles()

    @property
    def bars(self) -> dict[str, NumberBar]:
        """The bars of the numbers by the names of the parameters."""
        return self.parameters.bars

    @property
    def title(self) -> QLineEdit:
        """The field of the title."""
        return self.identity.title

    @property
    def name(self) -> QLineEdit:
        """The field of the name."""
        return self.identity.name

    @property
    def model(self) -> QComboBox:
        """The choice of a model."""
        return self.identity.model

    @property
    def muscles(self) -> tuple[Muscle, ...]:
        """The muscles that are shown, the one selected last first."""
        return self.edit.muscles

    def show_muscles(self) -> None:
        """Show what is selected."""
        muscles = self.muscles
        self._form.setVisible(bool(muscles))
        self._nothing.setVisible(not muscles)
        if not muscles:
            self._nothing.setText(SELECT if self._context.document.project.muscles else BEGIN)
            return
        first, locked = muscles[0], self.edit.locked
        self.identity.show_muscles(muscles)
        self.users.setText(users_text(self._context.document.project, muscles))
        self.parameters.show_muscles(muscles)
        # Both sides of one muscle have one place to show; several muscles have none in common.
        one = all(muscle.name == first.name for muscle in muscles)
        geometry = MODELS[first.model].geometry
        self.fibres.setVisible(one and geometry == "fibres")
        self.ring.setVisible(one and geometry == "ring" and first.ring is not None)
        if not self.fibres.isHidden():
            self.fibres.show_muscle(first)
        if not self.ring.isHidden():
            self.ring.show_muscle(first)
        for part in (self.parameters, self.fibres, self.ring):
            part.setEnabled(not locked)
        self._locked.setVisible(bool(locked))
        self._locked.setText("Locked: unlock it here or in the tree to change it.")

    def focus_title(self) -> None:
        """Put the keyboard into the title."""
        self.title.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.title.selectAll()

    def _follow(self, now: ViewState, before: ViewState) -> None:
        members = ("selected", "muscle", "locked")
        if any(getattr(now, name) != getattr(before, name) for name in members):
            self.show_muscles()

    def _lay_out(self) -> None:
        form = QVBoxLayout(self._form)
        form.setContentsMargins(0, 0, 0, 0)
        form.setSpacing(GRID)
        for part in (self.identity, self._locked, self.parameters, self.users, self.fibres, self.ring):
            form.addWidget(part)
        layout = QVBoxLayout(self)
        layout.setSizeConstraint(QLayout.SizeConstraint.SetMinimumSize)
        layout.setContentsMargins(GRID, GRID, GRID, GRID)
        layout.addWidget(self._nothing)
        layout.addWidget(self._form)
        layout.addStretch(1)


def _quiet(text: str) -> QLabel:
    label = PlainLabel(text)
    label.setProperty("role", "muted")
    label.setWordWrap(True)
    return label
