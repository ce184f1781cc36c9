"""Fields about tracks as a whole: what they are made of, and the group that they are listed in."""

from __future__ import annotations

from PySide6.QtWidgets import QComboBox, QInputDialog

from app.timeline.keying import chosen_channels
from app.timeline.layers import add_layer, bake_layers
from app.timeline.timeline import Timeline
from facemodel.animation.editing.tracks import flagged
from facemodel.animation.track import Track
from ui.timeline.inspector.page import Page, push_button


class TrackPage(Page):
    """A track, or several."""

    def __init__(self, timeline: Timeline) -> None:
        self._channels = chosen_channels(timeline)
        super().__init__(timeline, "Track" if len(self._channels) == 1 else f"{len(self._channels)} tracks")
        self.what = self.caption("")
        self.group = QComboBox()
        self.group.setAccessibleName("Group")
        self.group.setToolTip("Where they are listed on the timeline")
        self.group.setPlaceholderText("Several groups")
        self.group.activated.connect(self._take_group)
        self.add(self.group)
        track = timeline.animation.track(self._channels[0]) if len(self._channels) == 1 else None
        if track is not None and track.captured is not None:
            channel = track.channel
            self.gap()
            self.add(
                push_button("Add layer", lambda: add_layer(timeline, channel), "A layer that keys can bend"),
                push_button("Bake", lambda: bake_layers(timeline, [channel]), "Make layers part of the capture"),
            )
        self.refresh()

    def refresh(self) -> None:
        """Say what they are made of, and where they are listed."""
        tracks = [track for track in self.timeline.animation.tracks if track.channel in self._channels]
        if not tracks:
            return
        self.what.setText(_about(tracks[0]) if len(tracks) == 1 else f"{sum(len(each.curve) for each in tracks)} keys")
        self.group.clear()
        self.group.addItem("Group of the face", "")
        for name in sorted({each.group for each in self.timeline.animation.tracks if each.group}):
            self.group.addItem(name, name)
        self.group.addItem("New group…", None)
        groups = {track.group for track in tracks}
        self.group.setCurrentIndex(self.group.findData(groups.pop()) if len(groups) == 1 else -1)

    def _take_group(self, place: int) -> None:
        name = self.group.itemData(place)
        if name is None:
            name, taken = QInputDialog.getText(self, "New group", "Name of the group")
            if not taken or not name.strip():
                self.refresh()
                return
        label = "Group track" if len(self._channels) == 1 else "Group tracks"
        self.timeline.edit(flagged(self.timeline.animation, self._channels, group=name.strip()), label)


def _about(track: Track) -> str:
    """What a track is made of."""
    parts = [f"{len(track.curve)} keys"] if len(track.curve) else []
    if track.captured is not None:
        parts.append(f"{len(track.captured.values):,} samples at {track.captured.rate:g} Hz")
    if track.layers:
        parts.append(f"{len(track.layers)} layers")
    return " · ".join(parts) or "Nothing yet"
