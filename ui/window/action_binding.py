"""The table of actions as Qt actions: one each, kept up to date, shared by menus, toolbar, shortcuts and palette."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from html import escape

from psygnal import SignalInstance
from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow

from app.actions.action import Action, perform, shortcuts_of
from app.actions.context import Context, state_signals, table_signals
from ui.theme.action_icons import GLYPHS
from ui.theme.icons import icon

Table = Callable[[Context], tuple[Action, ...]]
"""All actions there are now."""

SETTLE = 40
"""Milliseconds for which the state may change further before menus follow: a drag changes it at every move."""


class ActionBinding(QObject):
    """Makes Qt actions of the table and lets them follow what they act on.

    Parameters
    ----------
    window : that has them
    context : what they act on
    table : all of them
    also : further signals after which they may be possible, on, or called something else

    Signals
    -------
    table_changed() : there may be other actions than before
    """

    table_changed = Signal()

    def __init__(
        self, window: QMainWindow, context: Context, table: Table, also: Sequence[SignalInstance] = ()
    ) -> None:
        super().__init__(window)
        self._window = window
        self._context = context
        self._table = table
        self.actions: tuple[Action, ...] = ()
        self.qt: dict[str, QAction] = {}
        self._state_timer = QTimer(self, singleShot=True, interval=SETTLE)
        self._state_timer.timeout.connect(self.refresh)
        self._table_timer = QTimer(self, singleShot=True, interval=0)
        self._table_timer.timeout.connect(self.rebuild)
        for signal in (*state_signals(context), *also):
            signal.connect(self._state_changed)
        for signal in table_signals(context):
            signal.connect(self._table_may_change)
        self.rebuild()

    def rebuild(self) -> None:
        """Read the table again; actions that stay keep their Qt action."""
        self.actions = self._table(self._context)
        gone = set(self.qt) - {action.id for action in self.actions}
        for key in gone:
            self._window.removeAction(self.qt[key])
            self.qt.pop(key).deleteLater()
        for action in self.actions:
            self._dress(self.qt.get(action.id) or self._add(action.id), action)
        self.refresh()
        self.table_changed.emit()

    def refresh(self) -> None:
        """Bring titles, marks and possibilities up to date."""
        self._state_timer.stop()
        for action in self.actions:
            shown = self.qt[action.id]
            shown.setText(action.title_now(self._context).replace("&", "&&"))
            shown.setEnabled(action.enabled(self._context))
            if action.kind != "command":
                shown.setChecked(action.checked(self._context))

    def settle(self) -> None:
        """Catch up with the state if it has changed: a key may come sooner than the menus follow."""
        if self._state_timer.isActive():
            self.refresh()

    def perform(self, key: str) -> None:
        """Do an action by its id."""
        for action in self.actions:
            if action.id == key:
                perform(action, self._context)
                break
        self.refresh()

    def keys(self, action: Action) -> str:
        """The first keys of an action as people read them on this system."""
        keys = shortcuts_of(action, self._context.settings.preferences)
        return QKeySequence(keys[0]).toString(QKeySequence.SequenceFormat.NativeText) if keys else ""

    def _add(self, key: str) -> QAction:
        made = QAction(self)
        made.setObjectName(key)
        made.triggered.connect(lambda: self.perform(key))
        if key in GLYPHS:
            made.setIcon(icon(GLYPHS[key]))
        self._window.addAction(made)
        self.qt[key] = made
        return made

    def _dress(self, shown: QAction, action: Action) -> None:
        shown.setCheckable(action.kind != "command")
        shown.setIconVisibleInMenu(action.kind == "command")
        shown.setShortcuts([QKeySequence(key) for key in shortcuts_of(action, self._context.settings.preferences)])
        shown.setStatusTip(action.hint)
        keys = self.keys(action)
        title = escape(action.title.rstrip("…"))
        shown.setToolTip(f"<b>{title}</b>{f' ({escape(keys)})' if keys else ''}<br>{escape(action.hint)}")

    def _state_changed(self) -> None:
        if not self._state_timer.isActive():
            self._state_timer.start()

    def _table_may_change(self) -> None:
        self._table_timer.start()
