"""Small pictures of the face in hand, one for every named expression, taken off the screen while nobody is busy."""

from ui.portraits.portraits import NEUTRAL, Portraits

__all__ = ["NEUTRAL", "Portraits"]
