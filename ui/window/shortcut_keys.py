"""Changing the keys of actions: what is stored, and who loses a key that another takes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from app.actions.action import Action, shortcuts_of
from app.preferences import Preferences


def with_keys(
    action: Action, keys: str, actions: Sequence[Action], preferences: Preferences
) -> tuple[dict[str, str], tuple[Action, ...]]:
    """The user's keys after an action is given others.

    Parameters
    ----------
    keys : in Qt's portable spelling; empty for none

    Returns
    -------
    shortcuts : what `Preferences.shortcuts` should become
    robbed : the actions that had these keys and lose them
    """
    robbed = tuple(
        other for other in actions if keys and other.id != action.id and keys in shortcuts_of(other, preferences)
    )
    changed: Mapping[str, str] = {action.id: keys, **{other.id: "" for other in robbed}}
    own = {one.id: one.shortcut for one in actions}
    merged = {**preferences.shortcuts, **changed}
    return {key: value for key, value in merged.items() if own.get(key) != value}, robbed
