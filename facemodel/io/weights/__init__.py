"""Weights over time in the formats of other programs.

Whatever is wrong with a file is said in one sentence.  What can be read is: gaps are bridged, a line that was cut off
at the end is left out, and a note says so.
"""

from facemodel.io.weights.reading import READABLE, RECORDINGS, read_capture, read_recording

__all__ = ["READABLE", "RECORDINGS", "read_capture", "read_recording"]
