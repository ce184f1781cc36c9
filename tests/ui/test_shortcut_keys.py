"""Who has which keys after a change."""

from app.actions.action import Action, shortcuts_of
from app.preferences import Preferences
from ui.window.shortcut_keys import with_keys


def nothing(_context) -> None:
    """Do nothing; these actions only have keys."""


SKULL = Action("view.skull", "Skull", nothing, shortcut="K")
UNDO = Action("edit.undo", "Undo", nothing, shortcut="Ctrl+Z", also=("Alt+Backspace",))
ACTIONS = (SKULL, UNDO)


def changed(action: Action, keys: str, preferences: Preferences) -> tuple[Preferences, tuple[Action, ...]]:
    shortcuts, robbed = with_keys(action, keys, ACTIONS, preferences)
    return preferences.model_copy(update={"shortcuts": shortcuts}), robbed


def test_an_action_takes_new_keys():
    preferences, robbed = changed(SKULL, "Ctrl+K", Preferences())
    assert shortcuts_of(SKULL, preferences) == ("Ctrl+K",)
    assert robbed == ()


def test_keys_belong_to_one_action_only():
    preferences, robbed = changed(SKULL, "Alt+Backspace", Preferences())
    assert robbed == (UNDO,)
    assert shortcuts_of(SKULL, preferences) == ("Alt+Backspace",)
    assert shortcuts_of(UNDO, preferences) == ()


def test_keys_can_be_taken_away_and_given_back():
    without, _ = changed(SKULL, "", Preferences())
    assert shortcuts_of(SKULL, without) == ()
    again, _ = changed(SKULL, "K", without)
    assert again == Preferences()
