"""What a user chose is there at the next start, and a damaged file costs nothing but the choices in it."""

import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.preferences import MOST_RECENT, Preferences, read_preferences
from app.settings import UserSettings


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "risorius" / "preferences.json"


def test_they_come_back_at_the_next_start(path: Path, tmp_path: Path) -> None:
    settings = UserSettings(path)
    assert settings.preferences == Preferences()
    settings.change(theme="light", geometry="AAEC/+==", hint_done=True, shortcuts={"edit.undo": "Ctrl+U"})
    settings.remember(tmp_path / "one.risorius")
    again = UserSettings(path)
    assert again.preferences == settings.preferences
    assert again.preferences.theme == "light"
    assert again.preferences.folder == tmp_path
    assert again.notice == ""


@given(st.lists(st.integers(0, 15), max_size=40))
def test_recent_files_are_the_last_different_ones_latest_first(opened: list[int]) -> None:
    preferences = Preferences()
    for number in opened:
        preferences = preferences.remembering(Path(f"/folder/{number}.risorius"))
    expected = list(dict.fromkeys(reversed(opened)))[:MOST_RECENT]
    assert [int(path.stem) for path in preferences.recent] == expected


def test_the_environment_can_name_another_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("RISORIUS_CONFIG", str(tmp_path / "elsewhere"))
    UserSettings().change(theme="light")
    assert read_preferences(tmp_path / "elsewhere" / "preferences.json")[0].theme == "light"


def test_a_file_that_is_gone_can_be_forgotten(path: Path, tmp_path: Path) -> None:
    settings = UserSettings(path)
    settings.remember(tmp_path / "one.risorius")
    settings.forget(tmp_path / "one.risorius")
    assert UserSettings(path).preferences.recent == ()


def test_listeners_hear_only_of_differences(path: Path) -> None:
    settings = UserSettings(path)
    heard: list[tuple[Preferences, Preferences]] = []
    settings.changed.connect(lambda now, before: heard.append((now, before)))
    settings.change(theme="light")
    settings.change(theme="light")
    assert [(now.theme, before.theme) for now, before in heard] == [("light", "dark")]


@pytest.mark.parametrize(
    "damage",
    [b"", b"{", b"\xff\xfe\x00", b"[]", b'{"theme": "pink"}', b'{"recent": 7}', b"9" * 5000, b"[" * 100_000],
)
def test_a_damaged_file_is_kept_aside_and_the_defaults_are_used(path: Path, damage: bytes) -> None:
    path.parent.mkdir()
    path.write_bytes(damage)
    settings = UserSettings(path)
    aside = path.with_name("preferences.json.bak")
    assert settings.preferences == Preferences()
    assert str(aside) in settings.notice
    assert aside.read_bytes() == damage
    settings.change(theme="light")
    assert UserSettings(path).notice == ""


def test_what_a_newer_version_added_is_passed_over(path: Path) -> None:
    path.parent.mkdir()
    path.write_text(json.dumps({"theme": "light", "brush": {"size": 3}}))
    preferences, notice = read_preferences(path)
    assert (preferences.theme, notice) == ("light", "")


def test_a_folder_that_cannot_be_written_is_told_and_the_choice_holds(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    settings = UserSettings(tmp_path / "file" / "preferences.json")
    told: list[str] = []
    settings.failed.connect(told.append)
    settings.change(theme="light")
    assert settings.preferences.theme == "light"
    assert len(told) == 1
    assert str(tmp_path / "file") in told[0]
