"""What this program is."""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, version

from PySide6.QtWidgets import QDialog, QLabel, QVBoxLayout, QWidget

from ui.theme.metrics import GRID


def about_page(parent: QWidget) -> QDialog:
    """Name, version, licence and where the data come from."""
    page = QDialog(parent)
    page.setWindowTitle("About Risorius")
    layout = QVBoxLayout(page)
    layout.setContentsMargins(4 * GRID, 3 * GRID, 4 * GRID, 3 * GRID)
    layout.setSpacing(GRID)
    title = QLabel("Risorius")
    title.setProperty("role", "title")
    layout.addWidget(title)
    layout.addWidget(_muted(f"Version {_version()}"))
    for text in (
        "An editor for facial expression: muscles pull on skin, the skin is solved with finite elements, "
        "and sliders mix the solutions in real time.",
        "Program under the MIT licence. The shipped faces derive from MakeHuman's base mesh and targets, CC0.",
        "Drawn with VTK and Qt; computed with NumPy, SciPy and libigl.",
    ):
        words = QLabel(text)
        words.setWordWrap(True)
        words.setMinimumWidth(48 * GRID)
        layout.addWidget(words)
    return page


def _muted(text: str) -> QLabel:
    label = QLabel(text)
    label.setProperty("role", "muted")
    return label


def _version() -> str:
    try:
        return version("risorius")
    except PackageNotFoundError:
        return "from source"
