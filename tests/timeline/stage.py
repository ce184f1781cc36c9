"""A bit of everything that can be on a timeline."""

from dataclasses import replace

import numpy as np

from facemodel.animation.clip import Animation, Audio, KeyExpression, Marker, NamedRange
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.displacement import Displacement
from facemodel.animation.event import Event
from facemodel.animation.idle import Idle
from facemodel.animation.samples import Samples
from facemodel.animation.speech import Phoneme, Speech, Word
from facemodel.animation.track import Track
from facemodel.project import Project

SMILE = curve_of([Key(0.5, 0.0), Key(1.0, 0.8), Key(2.0, 0.2, "linear"), Key(3.0, 0.6)])
CHIN = curve_of([Key(1.0, 0.3), Key(2.5, 0.5)])
BENT = curve_of([Key(2.0, 0.7)])
SOUNDS = (Phoneme("M", 1.0, 1.1), Phoneme("AA", 1.1, 1.3), Phoneme("P", 1.3, 1.4), Phoneme("AA", 1.6, 1.8))


def lively() -> Animation:
    """Return keys on both sides, a captured curve under a layer, events, speech, marks and a sound."""
    wave = (0.5 + 0.3 * np.sin(np.arange(241) / 9)).astype(np.float32)
    return Animation(
        tracks=(
            Track("12L", SMILE),
            Track("12R", curve_of([Key(1.0, 0.8)])),
            Track("17", CHIN),
            Track("26", captured=Samples(wave, 60.0), layers=(Displacement(BENT, 0.2, name="Louder"),)),
            Track("head.yaw", curve_of([Key(0.0, 0.0), Key(1.0, 12.0)])),
            Track("20L", curve_of([Key(1.0, 0.1), Key(2.0, 0.4)]), locked=True),
        ),
        events=(
            Event("smirk 1", ("12L",), 0.4, amplitude=0.5, group="Smirk"),
            Event("smirk 2", ("head.roll",), 0.4, amplitude=-3.0, group="Smirk"),
            Event("twitch 1", ("20L", "20R"), 2.2, amplitude=0.3),
        ),
        speech=Speech(SOUNDS, (Word("map", 1.0, 1.4),)),
        idle=Idle(seed=3),
        expressions=(KeyExpression(1.0, "Smile"),),
        end=4.0,
        markers=(Marker(1.5, "Beat"),),
        ranges=(NamedRange("Line", 1.0, 2.0),),
        audio=Audio("voice.wav", 0.5),
    )


def with_animation(project: Project, animation: Animation) -> Project:
    """Return the project with something happening in it."""
    return replace(project, animation=animation)
