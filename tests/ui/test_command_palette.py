"""The palette: type, walk, run."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from ui.theme.apply import apply_theme
from ui.theme.colour import contrast
from ui.theme.metrics import ROW
from ui.theme.roles import DARK, THEMES, Theme
from ui.widgets.command_palette import CommandPalette, PaletteEntry

ENTRIES = (
    PaletteEntry("Skull", "View", "K", (0, 1), payload="skull"),
    PaletteEntry("Undo", "Edit", "Ctrl+Z", enabled=False, payload="undo"),
    PaletteEntry("Neutral face", "Edit", "0", payload="neutral"),
)


def rank(text: str) -> list[PaletteEntry]:
    return [entry for entry in ENTRIES if text.lower() in entry.title.lower()]


@pytest.fixture
def palette(shown) -> CommandPalette:
    host = QWidget()
    host.resize(900, 600)
    palette = CommandPalette(host, rank)
    shown(host)
    palette.open_palette()
    return palette


@pytest.fixture
def ran(palette) -> list[object]:
    ran: list[object] = []
    palette.chosen.connect(ran.append)
    return ran


def test_enter_runs_the_first_match_and_closes(palette, ran):
    QTest.keyClicks(palette.line, "neu")
    QTest.keyClick(palette.line, Qt.Key.Key_Return)
    assert ran == ["neutral"]
    assert not palette.isVisible()


def test_arrows_walk_round_past_what_cannot_be_run(palette, ran):
    for _ in range(3):
        QTest.keyClick(palette.line, Qt.Key.Key_Down)
    QTest.keyClick(palette.line, Qt.Key.Key_Return)
    assert ran == ["neutral"]


def test_up_from_the_first_is_the_last(palette, ran):
    QTest.keyClick(palette.line, Qt.Key.Key_Up)
    QTest.keyClick(palette.line, Qt.Key.Key_Return)
    assert ran == ["neutral"]


def test_a_click_runs_a_line_but_not_one_that_cannot_be_run(palette, ran):
    def click(row: int) -> None:
        place = palette.list.visualRect(palette.list.model().index(row, 0)).center()
        QTest.mouseClick(palette.list.viewport(), Qt.MouseButton.LeftButton, pos=place)

    click(1)
    assert ran == []
    click(0)
    assert ran == ["skull"]


def test_escape_closes_and_nothing_runs(palette, ran):
    QTest.keyClick(palette.line, Qt.Key.Key_Escape)
    assert not palette.isVisible()
    assert ran == []


def test_nothing_that_matches_runs_nothing(palette, ran):
    QTest.keyClicks(palette.line, "zzz")
    QTest.keyClick(palette.line, Qt.Key.Key_Return)
    assert ran == []


def test_it_lies_inside_its_window(palette):
    assert palette.parentWidget().rect().contains(palette.geometry())


def test_a_long_title_ends_before_the_section_and_the_keys(palette):
    def drawn(title: str) -> tuple[QImage, QImage]:
        palette._rank = lambda _text: [PaletteEntry(title, "Muscle", "Ctrl+K")]
        palette.line.setText(title)
        picture = palette.list.viewport().grab().toImage()
        wide = picture.width()
        return picture.copy(0, 0, wide // 2, ROW), picture.copy(wide - 120, 0, 120, ROW)

    (short, ends), (long, also) = drawn("Musculus"), drawn("Musculus " * 30)
    assert short != long
    assert ends == also


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES.keys())
def test_the_section_of_a_command_is_written_as_strongly_as_its_keys(palette, qapp, theme: Theme):
    def ink(keys: str, section: str) -> float:
        palette._rank = lambda _text: [PaletteEntry("", "", enabled=False), PaletteEntry("", section, keys)] * 2
        palette.line.setText(keys + section)
        picture = palette.list.viewport().grab().toImage().copy(0, 2 * ROW + ROW, palette.list.width(), ROW)
        pixels = (picture.pixelColor(x, y) for x in range(picture.width()) for y in range(picture.height()))
        return max(contrast(theme.panel, pixel) for pixel in pixels)

    apply_theme(qapp, theme)
    try:
        assert ink("", "Muscle") > 3
        assert ink("", "Muscle") == pytest.approx(ink("Muscle", ""), rel=0.05)
    finally:
        apply_theme(qapp, DARK)
