"""A sound that plays along with the animation: what is handed to the loudspeaker is the clock that pictures follow."""

from app.audio.accompaniment import Accompaniment
from app.audio.speaker import AudioError, open_speaker

__all__ = ["Accompaniment", "AudioError", "open_speaker"]
