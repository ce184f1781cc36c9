"""The menu bar, derived from the table of actions."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QMenuBar

from app.actions.action import Action
from app.actions.table import MENUS
from ui.window.action_binding import ActionBinding


def fill_menus(bar: QMenuBar, binding: ActionBinding, docks: Sequence[QAction] = ()) -> None:
    """Make the menus anew; the switches of the docks stand at the head of “Window”."""
    old = [action.menu() for action in bar.actions()]
    bar.clear()
    for menu in old:
        menu.deleteLater()
    for title in MENUS:
        menu = QMenu(title, bar)
        bar.addMenu(menu)
        if title == "Window" and docks:
            menu.addActions(list(docks))
            menu.addSeparator()
        _fill(menu, [action for action in binding.actions if action.menu[:1] == (title,)], 1, binding)


def _fill(menu: QMenu, actions: Sequence[Action], depth: int, binding: ActionBinding) -> None:
    """Add actions whose path ends here, and submenus where the first action of a longer path stands."""
    group: int | None = None
    inner: dict[str, list[Action]] = {}
    for action in actions:
        if len(action.menu) > depth:
            inner.setdefault(action.menu[depth], []).append(action)
    for action in actions:
        title = action.menu[depth] if len(action.menu) > depth else None
        if title is not None and title not in inner:
            continue
        if group is not None and action.group != group:
            menu.addSeparator()
        group = action.group
        if title is None:
            menu.addAction(binding.qt[action.id])
        else:
            deeper = QMenu(title, menu)
            menu.addMenu(deeper)
            _fill(deeper, inner.pop(title), depth + 1, binding)
