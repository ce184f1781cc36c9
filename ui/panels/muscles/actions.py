"""All that can be done with muscles, in the order of its menu."""

from __future__ import annotations

from app.actions.action import Action
from ui.panels.muscles.deeds import EDITING_ACTIONS
from ui.panels.muscles.sight_deeds import SIGHT_ACTIONS

MUSCLE_ACTIONS: tuple[Action, ...] = tuple(sorted((*EDITING_ACTIONS, *SIGHT_ACTIONS), key=lambda action: action.group))
"""For the tree's buttons and menu, the menu bar and the palette."""
