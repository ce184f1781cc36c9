"""What an action unit does to eyes, head and tongue: motions that no skin has to be solved for."""

from __future__ import annotations

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class EyeMotion:
    """How an action unit turns the eyes at activation 1, degrees.

    Attributes
    ----------
    turn : to the subject's left; below zero to the right
    lift : upwards; below zero down
    spread : of each eye outwards; below zero inwards, towards the nose
    """

    turn: float = 0.0
    lift: float = 0.0
    spread: float = 0.0

    def __bool__(self) -> bool:
        return bool(self.turn or self.lift or self.spread)

    @property
    def mirrored(self) -> EyeMotion:
        """Its mirror image: the eyes turn to the other side."""
        return replace(self, turn=-self.turn) if self.turn else self


@dataclass(frozen=True)
class HeadMotion:
    """How an action unit moves the head at activation 1.

    Attributes
    ----------
    turn : to the subject's left, degrees; below zero to the right
    lift : of the chin, degrees; below zero the head nods
    tilt : towards the left shoulder, degrees; below zero towards the right one
    forward : millimetres; below zero backwards
    """

    turn: float = 0.0
    lift: float = 0.0
    tilt: float = 0.0
    forward: float = 0.0

    def __bool__(self) -> bool:
        return bool(self.turn or self.lift or self.tilt or self.forward)

    @property
    def mirrored(self) -> HeadMotion:
        """Its mirror image: the head turns and tilts to the other side."""
        return replace(self, turn=-self.turn, tilt=-self.tilt) if self.turn or self.tilt else self


@dataclass(frozen=True)
class TongueMotion:
    """How an action unit moves the tongue at activation 1.

    Attributes
    ----------
    out : how far its tip comes forward, millimetres
    lift : degrees by which it is bent up before the teeth; below zero down
    """

    out: float = 0.0
    lift: float = 0.0

    def __bool__(self) -> bool:
        return bool(self.out or self.lift)
