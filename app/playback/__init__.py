"""Playing an animation in real time over a document, without Qt: whoever has a screen calls `Playhead.tick`."""

from app.playback.clock import Clock
from app.playback.playhead import Playhead

__all__ = ["Clock", "Playhead"]
