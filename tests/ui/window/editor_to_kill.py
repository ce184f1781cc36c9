"""The editor at work until it is killed: a slider is dragged, and what the bottom line says then is printed."""

import sys

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from tests.ui.hands import drag
from ui.window.main import make_application, run
from ui.window.main_window import MainWindow

UNIT = 17


def work() -> None:
    """Drag as soon as the window is up; go on reading the bottom line."""
    (window,) = (each for each in QApplication.topLevelWidgets() if isinstance(each, MainWindow))
    drag(window.expression.rows[UNIT].slider, 0.0, 0.5)

    def look() -> None:
        if window.status.kept.isVisible():
            print(window.status.kept.text(), window.context.document.shown[str(UNIT)], flush=True)

    watch = QTimer(window, interval=50)
    watch.timeout.connect(look)
    watch.start()


if __name__ == "__main__":
    make_application()
    QTimer.singleShot(0, work)
    sys.exit(run())
