"""The menus of the timeline: about what lies under the pointer, made of the actions that the menu bar has."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QMenu, QWidget

from app.timeline.actions import SHAPING
from app.timeline.keying import key_channels
from app.timeline.lines import Line
from app.timeline.timeline import Timeline
from facemodel.animation.channels import RIGID, channels
from facemodel.animation.editing.eases import EASES
from ui.timeline.hits import Hit
from ui.window.action_binding import ActionBinding

SHAPES = tuple(f"timeline.{entry.key}" for entry in SHAPING)
EASING = tuple(f"timeline.ease.{name}" for name in EASES)
EDIT = ("timeline.cut", "timeline.copy", "timeline.paste", "timeline.duplicate", "timeline.delete")
HERE = ("timeline.key", "timeline.paste", "timeline.marker")
CURVES = (
    "timeline.curves.simplify",
    "timeline.curves.smooth",
    "timeline.curves.warp",
    "timeline.curves.offset",
    "timeline.curves.loop",
    "timeline.curves.bake-keys",
    "timeline.curves.bake-samples",
)
LAYERS = ("timeline.layer.add", "timeline.layer.bake")


class TimelineMenus:
    """Shows menus.

    Parameters
    ----------
    parent : the widget that they belong to
    timeline : what they are about
    binding : the actions of the window
    """

    def __init__(self, parent: QWidget, timeline: Timeline, binding: ActionBinding) -> None:
        self._parent, self._timeline, self._binding = parent, timeline, binding

    def about_hit(self, found: Hit, place: QPoint) -> None:
        """The menu about something on the sheet."""
        menu = self._menu()
        if found.kind in ("keys", "expression"):
            self._put(menu, SHAPES)
            self._put(menu.addMenu("Ease"), EASING)
            menu.addSeparator()
            self._put(menu, (*EDIT, "timeline.mirror", "timeline.snap", "timeline.column"))
        elif found.chosen:
            self._put(menu, (*EDIT, "timeline.mirror"))
        else:
            self._put(menu, HERE)
            menu.addSeparator()
            self._library(menu)
            menu.addSeparator()
            self._put(menu, ("timeline.all", "timeline.frame-all"))
        menu.popup(place)

    def about_line(self, line: Line | None, place: QPoint) -> None:
        """The menu about a line, or about tracks in general."""
        menu = self._menu()
        if line is not None and line.kind in ("track", "layer", "group"):
            self._put(menu, ("timeline.key-chosen", "timeline.all"))
            menu.addSeparator()
            self._put(menu.addMenu("Curves"), CURVES)
            self._put(menu, LAYERS)
            menu.addSeparator()
            self._put(menu, ("timeline.delete",))
            menu.addSeparator()
        self._tracks(menu.addMenu("Add track"))
        self._library(menu)
        self._put(menu, ("timeline.idle",))
        menu.popup(place)

    def about_time(self, _time: float, place: QPoint) -> None:
        """The menu about a moment of the ruler."""
        menu = self._menu()
        self._put(menu, ("timeline.marker", "timeline.range", "timeline.delete"))
        menu.addSeparator()
        self._put(menu, ("timeline.start-here", "timeline.end-here", "timeline.frame-all"))
        menu.popup(place)

    def _menu(self) -> QMenu:
        menu = QMenu(self._parent)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        return menu

    def _put(self, menu: QMenu, keys: Sequence[str]) -> None:
        self._binding.refresh()
        for key in keys:
            menu.addAction(self._binding.qt[key])

    def _library(self, menu: QMenu) -> None:
        inner = menu.addMenu("Add expression")
        for key, action in self._binding.qt.items():
            if key.startswith("timeline.drop."):
                inner.addAction(action)

    def _tracks(self, menu: QMenu) -> None:
        """Channels without a track; each begins with a key under the playhead."""
        project = self._timeline.document.project
        has = {track.channel for track in project.animation.tracks}
        units, rigid = menu.addMenu("Action unit"), menu.addMenu("Head and eyes")
        for channel in channels(project.units):
            if channel.name not in has:
                where = rigid if channel.name in RIGID else units
                name = channel.title if channel.name in RIGID else f"{channel.name}  {channel.title.capitalize()}"
                where.addAction(name).triggered.connect(lambda _on, name=channel.name: self._add(name))

    def _add(self, channel: str) -> None:
        key_channels(self._timeline, [channel])
        self._timeline.change(lines=frozenset((f"track {channel}",)))
