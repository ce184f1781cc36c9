"""The stylesheet: only what Fusion and a palette cannot say."""

from __future__ import annotations

from string import Template

from resources import resource
from ui.theme.chosen import chosen_ground
from ui.theme.colour import blend
from ui.theme.metrics import ROW, SMALL_TYPE
from ui.theme.roles import Theme

SHEET = Template("""
QMainWindow, QMainWindow::separator { background: $window; }
QMainWindow::separator { width: 4px; height: 4px; }
QMainWindow::separator:hover { background: $accent; }
QToolTip { background: $raised; color: $text; border: 1px solid $line; padding: 4px 8px; }

QMenuBar { background: $window; padding: 0 4px; }
QMenuBar::item { background: transparent; padding: 6px 10px; }
QMenuBar::item:selected, QMenuBar::item:pressed { background: $hover; }
QTabBar#workspaces { background: $window; }
QTabBar#workspaces::tab { background: transparent; color: $muted; border: none; border-bottom: 2px solid transparent;
  padding: 5px 12px 4px 12px; margin: 0; }
QTabBar#workspaces::tab:hover { color: $text; }
QTabBar#workspaces::tab:selected { color: $text; border-bottom-color: $accent; }
QTabBar#workspaces::tab:selected:focus { color: $accent; }
QMenu { background: $panel; border: 1px solid $line; padding: 4px 0; }
QMenu::item { padding: 5px 32px 5px 8px; min-height: 16px; }
QMenu::icon { padding-left: 12px; }
QMenu::item:selected { background: $hover; }
QMenu::item:disabled { color: $faint; }
QMenu::separator { height: 1px; background: $line; margin: 4px 0; }

QToolBar { background: $window; border: none; padding: 4px; spacing: 2px; }
QToolBar::separator:vertical { height: 1px; background: $line; margin: 4px; }
QToolBar::separator:horizontal { width: 1px; background: $line; margin: 4px 6px; }
QToolButton { background: transparent; border: none; border-radius: 3px; padding: 5px; }
QToolButton:hover { background: $hover; }
QToolButton:pressed { background: $line; }
QToolButton:checked { background: $chosen; }
QToolButton:focus { border: 1px solid $accent; padding: 4px; }
QToolButton[role="small"] { padding: 2px; }
QToolButton[role="menu"] { padding: 2px 8px 2px 2px; }
QToolButton[role="menu"]::menu-indicator { subcontrol-position: right center; width: 8px; }
QTabBar#parts { background: $panel; }
QTabBar#parts::tab { background: transparent; color: $muted; border: none; border-bottom: 2px solid transparent;
  padding: 4px 8px; margin: 0 0 0 4px; }
QTabBar#parts::tab:hover { color: $text; }
QTabBar#parts::tab:selected { color: $text; border-bottom-color: $accent; }
QTabBar#parts::tab:selected:focus { color: $accent; }
QTabWidget::pane { border: none; }
QComboBox { background: $raised; border: 1px solid $line; border-radius: 3px; padding: 0 6px; min-height: ${field}px; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url("$chevron"); width: 10px; height: 10px; }
QComboBox:hover { background: $hover; }
QComboBox:focus { border-color: $accent; }
QComboBox:disabled { color: $faint; background: $panel; }
QComboBox QAbstractItemView { background: $panel; border: 1px solid $line; padding: 4px 0; outline: none;
    selection-background-color: $chosen; selection-color: $text; }
QSplitter::handle:horizontal { background: $panel; border-right: 1px solid $line; image: none; }
QSplitter::handle:horizontal:hover { border-right-color: $accent; }
QSplitter::handle:vertical { background: $panel; border-top: 1px solid $line; }
QSplitter::handle:vertical:hover { border-top-color: $accent; }
QToolButton[role="choice"] { background: $raised; padding: 4px 6px; }
QToolButton[role="choice"]:hover { background: $hover; }
QToolButton[role="choice"]:checked { background: $chosen; }
QToolButton[role="small"]:focus { padding: 1px; }

QStatusBar { background: $window; color: $muted; }
QStatusBar::item { border: none; }
QStatusBar QLabel { color: $muted; }

QLineEdit { background: $raised; border: 1px solid $line; border-radius: 3px; padding: 0 6px;
  min-height: ${field}px; selection-background-color: $accent; selection-color: $on_accent; }
QLineEdit:focus { border-color: $accent; }
QLineEdit[wrong="true"] { border-color: $error; color: $error; }

QPushButton { background: $raised; border: 1px solid $line; border-radius: 3px; padding: 0 12px;
  min-height: ${field}px; }
QPushButton:hover { background: $hover; }
QPushButton:pressed { background: $line; }
QPushButton:focus { border-color: $accent; }
QPushButton:default { background: $accent; color: $on_accent; border-color: $accent; }
QPushButton:default:hover { background: $accent_hover; }
QPushButton:disabled { color: $faint; background: $panel; border-color: $line; }
QPushButton[role="quiet"] { background: transparent; color: $muted; }
QPushButton[role="quiet"]:hover { background: $hover; color: $text; }
QPushButton[role="status"] { min-height: 18px; padding: 0 8px; font-size: ${small}px; }
QPushButton:flat { background: transparent; border-color: transparent; }

QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }

QProgressBar { background: $raised; border: none; border-radius: 2px; }
QProgressBar::chunk { background: $accent; border-radius: 2px; }

QScrollArea, QAbstractScrollArea { background: transparent; border: none; }
QScrollBar:vertical { background: transparent; width: 8px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 8px; margin: 0; }
QScrollBar::handle { background: $line; border-radius: 3px; min-height: 32px; min-width: 32px; margin: 1px; }
QScrollBar::handle:hover { background: $muted; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QTableView::indicator { width: 12px; height: 12px; border: 1px solid $muted; border-radius: 2px; background: $raised; }
QTableView::indicator:checked { background: $accent; border-color: $accent; }
QListView, QTreeView, QTableView { background: $panel; border: none; outline: none; }
QTableView::item { padding: 0 5px; }
QListView::item { min-height: ${row}px; padding: 0 8px; }
QListView::item:hover { background: $hover; }
QListView::item:selected, QTableView::item:selected { background: $chosen; color: $text; }
QHeaderView::section { background: $panel; color: $muted; border: none; padding: 4px 8px; }

QLabel[role="muted"] { color: $muted; }
QLabel[role="heading"] { color: $muted; font-size: ${small}px; }
QLabel[role="title"] { font-size: 18px; }
QLabel[role="error"] { color: $error; }
QLabel[role="pointer"] { background: $raised; border: 1px solid $line; border-radius: 3px; padding: 3px 8px; }
QWidget[role="panel"] { background: $panel; }
QFrame[role="card"] { background: $panel; border: 1px solid $line; border-radius: 4px; }
QFrame[role="upright"] { background: $line; border: none; max-width: 1px; min-width: 1px; }
QFrame[role="line"] { background: $line; border: none; max-height: 1px; min-height: 1px; }
""")


def stylesheet(theme: Theme) -> str:
    """The rules with the colours of a theme."""
    return SHEET.substitute(
        vars(theme),
        chevron=resource("icons", f"chevron-{theme.name}.svg").as_posix(),
        faint=blend(theme.panel, theme.muted, 0.55).name(),
        chosen=chosen_ground(theme).name(),
        accent_hover=blend(theme.accent, theme.on_accent, 0.14).name(),
        small=SMALL_TYPE,
        row=ROW,
        field=ROW - 2,
    )
