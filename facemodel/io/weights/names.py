"""Names that trackers give to what they see."""

from __future__ import annotations

from collections.abc import Mapping

_LISTED = """
    EyeBlinkLeft EyeLookDownLeft EyeLookInLeft EyeLookOutLeft EyeLookUpLeft EyeSquintLeft EyeWideLeft
    EyeBlinkRight EyeLookDownRight EyeLookInRight EyeLookOutRight EyeLookUpRight EyeSquintRight EyeWideRight
    JawForward JawLeft JawRight JawOpen MouthClose MouthFunnel MouthPucker MouthLeft MouthRight MouthSmileLeft
    MouthSmileRight MouthFrownLeft MouthFrownRight MouthDimpleLeft MouthDimpleRight MouthStretchLeft
    MouthStretchRight MouthRollLower MouthRollUpper MouthShrugLower MouthShrugUpper MouthPressLeft
    MouthPressRight MouthLowerDownLeft MouthLowerDownRight MouthUpperUpLeft MouthUpperUpRight BrowDownLeft
    BrowDownRight BrowInnerUp BrowOuterUpLeft BrowOuterUpRight CheekPuff CheekSquintLeft CheekSquintRight
    NoseSneerLeft NoseSneerRight TongueOut
"""

ARKIT = tuple(_LISTED.split())
"""The 52 blend shapes of ARKit, in the order and spelling of Live Link Face."""

TURNS = (
    "HeadYaw",
    "HeadPitch",
    "HeadRoll",
    "LeftEyeYaw",
    "LeftEyePitch",
    "LeftEyeRoll",
    "RightEyeYaw",
    "RightEyePitch",
    "RightEyeRoll",
)
"""What Live Link Face has behind them, radians."""

_KNOWN: Mapping[str, str] = {name.casefold(): name for name in (*ARKIT, *TURNS)}


def live_link_name(text: str) -> str | None:
    """The name as Live Link Face spells it, of ``jawOpen``, ``JawOpen``, ``jaw_open`` or ``EyeBlink_L``; else none."""
    bare = text.strip().rpartition(".")[2].replace("_", "").replace(" ", "").casefold()
    if bare in _KNOWN:
        return _KNOWN[bare]
    side = {"l": "left", "r": "right"}.get(bare[-1:])
    return _KNOWN.get(bare[:-1] + side) if side else None


def arkit_name(name: str) -> str:
    """The name as ARKit spells it: ``eyeBlinkLeft`` for ``EyeBlinkLeft``."""
    return name[:1].lower() + name[1:]
