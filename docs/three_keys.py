"""A person's first animation: three key expressions, a voice, and lips that say what it says.

Every step is a mouse or key event on the real window; only the answer of the file dialog comes from the caller.
``make pictures`` takes pictures along this way, and a test goes it and looks at what moves.
"""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QToolButton

from docs.first_face import Hand
from ui.timeline.dialogs.speech_page import SpeechPage

STRIP = 10
"""Pixels below the upper edge of the ruler, where a press moves the playhead."""

KEYS: tuple[tuple[float, Mapping[int, float]], ...] = (
    (0.0, {1: 0.7, 2: 0.6}),
    (1.2, {6: 0.6, 12: 0.8}),
    (2.6, {17: 0.5, 4: 0.7}),
)
"""Seconds, and the shares of bars, by action unit, that are dragged there."""

SAID = "HH AH L OW . M AY N EY M IH Z EY D AH"
"""Hello, my name is Ada."""


def go_to(hand: Hand, seconds: float) -> None:
    """Press on the ruler at a time."""
    desk = hand.window.timeline
    hand.click(desk.panel.ruler, QPoint(round(desk.view.scale.x(seconds)), STRIP))


def press(hand: Hand, key: Qt.Key) -> None:
    """Press a key of the window."""
    QTest.keyClick(hand.window, key)
    QApplication.processEvents()


def play(hand: Hand) -> None:
    """Click what plays and pauses."""
    transport, wanted = hand.window.timeline.dock.transport, hand.window.binding.qt["timeline.play"]
    hand.click(next(each for each in transport.findChildren(QToolButton) if each.defaultAction() is wanted))


def three_keys(hand: Hand) -> None:
    """Pose, key, go on, pose again: an astonished face that smiles and then doubts."""
    window = hand.window
    hand.click(window.timeline.dock.transport.fold)
    hand.rest(0.5)
    for seconds, bars in KEYS:
        go_to(hand, seconds)
        for row in [row for row in window.expression.rows.values() if row.changed]:
            hand.click(row.clear)
        for number, share in bars.items():
            hand.slide(window.expression.rows[number].slider, 0.02, share)
        press(hand, Qt.Key.Key_E)


def speak(hand: Hand, sounds: str) -> None:
    """Type sounds that are said from the playhead on, as long as the voice lasts."""
    window = hand.window
    hand.choose_under(window.timeline.dock.transport.add, "Type speech…")
    hand.wait(lambda: any(page.isVisible() for page in window.findChildren(SpeechPage)))
    (page,) = window.findChildren(SpeechPage)
    hand.click(page.kind, page.kind.tabRect(1).center())
    QTest.keyClicks(page.text, sounds)
    if page.fit.isVisible():
        hand.click(page.fit)
    hand.click(page.take)
    hand.wait(lambda: not window.findChildren(SpeechPage))


def walk(hand: Hand) -> None:
    """From the editor as it opens to three keys, a voice, lips in time with it, a blink, and playing all of it."""
    window = hand.window
    three_keys(hand)
    hand.photograph("three-keys")
    go_to(hand, 0.5)
    hand.choose_under(window.timeline.dock.transport.add, "Sound…")
    hand.wait(lambda: window.timeline.sounds.sound is not None)
    speak(hand, SAID)
    go_to(hand, 2.0)
    hand.choose_under(window.timeline.dock.transport.add, "Dynamic expression", "Blink")
    hand.photograph("three-keys-voice")
    go_to(hand, 0.0)
    play(hand)
    playhead = window.timeline.timeline.playhead
    hand.wait(lambda: playhead.time > 0.5)
    play(hand)
