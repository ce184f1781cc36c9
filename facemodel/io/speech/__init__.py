"""Phonemes over time in the formats of other programs."""

from facemodel.io.speech.reading import READABLE, read_speech
from facemodel.io.speech.spoken import Spoken

__all__ = ["READABLE", "Spoken", "read_speech"]
