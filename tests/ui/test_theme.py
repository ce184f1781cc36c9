"""Colours that can be read, and icons that follow the theme."""

import pytest
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QApplication

from ui.panels.muscles.tree_cells import switch_ink
from ui.theme.apply import apply_theme, current_theme
from ui.theme.chosen import chosen_ground, quiet_ink
from ui.theme.colour import contrast
from ui.theme.icons import icon
from ui.theme.roles import DARK, LIGHT, THEMES, Theme
from ui.widgets.bar_paint import fill_colour

READABLE, VISIBLE = 4.5, 3.0
"""What WCAG 2.2, AA, asks of writing, and of controls that are no writing."""


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES.keys())
@pytest.mark.parametrize("ground", ["window", "panel", "raised", "hover"])
@pytest.mark.parametrize("writing", ["text", "muted"])
def test_writing_can_be_read_on_every_ground(theme: Theme, ground: str, writing: str):
    assert contrast(getattr(theme, ground), getattr(theme, writing)) >= READABLE


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES.keys())
@pytest.mark.parametrize("state", ["accent", "ok", "warn", "error", "left", "right", "both"])
def test_states_and_sides_can_be_read_on_the_panel(theme: Theme, state: str):
    assert contrast(theme.panel, getattr(theme, state)) >= READABLE


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES.keys())
def test_what_is_wrong_in_a_field_and_the_open_workspace_can_be_read(theme: Theme):
    assert contrast(theme.raised, theme.error) >= READABLE
    assert contrast(theme.window, theme.accent) >= READABLE


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES.keys())
def test_writing_that_recedes_can_be_read_on_a_chosen_row(theme: Theme):
    ground = chosen_ground(theme)
    assert contrast(ground, quiet_ink(theme, chosen=True)) >= READABLE
    assert contrast(ground, quiet_ink(theme, chosen=True)) < contrast(ground, theme.text)
    assert quiet_ink(theme) == QColor(theme.muted)


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES.keys())
@pytest.mark.parametrize("side", ["left", "right", "both"])
def test_the_number_of_a_bar_can_be_read_on_its_fill(theme: Theme, side: str):
    assert contrast(fill_colour(getattr(theme, side), theme), theme.text) >= READABLE


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES.keys())
@pytest.mark.parametrize("ground", ["window", "panel", "raised", "hover"])
def test_a_quiet_icon_recedes_and_can_still_be_seen_on_every_ground(qapp: QApplication, theme: Theme, ground: str):
    apply_theme(qapp, theme)
    seen = {quiet: max(contrast(getattr(theme, ground), ink) for ink in inks(quiet)) for quiet in (True, False)}
    apply_theme(qapp, DARK)
    assert VISIBLE <= seen[True] < seen[False]


def inks(quiet: bool) -> set[str]:
    """Return the colours of the pixels of an icon that are all its own."""
    picture = icon("close-thick", quiet).pixmap(32, 32).toImage()
    pixels = (picture.pixelColor(x, y) for x in range(picture.width()) for y in range(picture.height()))
    return {pixel.name() for pixel in pixels if pixel.alpha() == 255}


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES.keys())
def test_an_eye_or_a_padlock_that_is_off_recedes_and_can_still_be_seen(theme: Theme):
    for ground in (theme.window, theme.panel, theme.hover):
        off, half, on = (contrast(ground, switch_ink(theme, share)) for share in (0.0, 0.5, 1.0))
        assert VISIBLE <= off < half < on


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES.keys())
def test_writing_on_the_accent_can_be_read(theme: Theme):
    assert contrast(theme.accent, theme.on_accent) >= READABLE


def test_contrast_of_black_and_white_is_the_largest_there_is():
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#777777") == pytest.approx(1)


def test_a_theme_dresses_the_application(qapp: QApplication):
    for theme in (LIGHT, DARK):
        apply_theme(qapp, theme)
        assert current_theme() is theme
        assert qapp.palette().text().color() == QColor(theme.text)


def test_an_icon_made_before_takes_the_colour_of_the_theme_put_on_after(qapp: QApplication):
    skull = icon("skull-outline")

    def ink() -> set[str]:
        picture = skull.pixmap(32, 32).toImage()
        pixels = (picture.pixelColor(x, y) for x in range(picture.width()) for y in range(picture.height()))
        return {pixel.name() for pixel in pixels if pixel.alpha() == 255}

    apply_theme(qapp, LIGHT)
    assert LIGHT.muted in ink()
    apply_theme(qapp, DARK)
    assert DARK.muted in ink()
