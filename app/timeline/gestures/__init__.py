"""What a hand does on the timeline: press, move, release; one gesture is one step, and Esc leaves no trace of it."""

from app.timeline.gestures.gesture import Gesture, Spot

__all__ = ["Gesture", "Spot"]
