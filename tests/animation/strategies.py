"""Animations of every kind, for tests that hold for all of them."""

import numpy as np
from hypothesis import strategies as st

from facemodel.animation.clip import Animation, Audio, KeyExpression, Marker, NamedRange
from facemodel.animation.curve import SHAPES, Curve, Key, curve_of
from facemodel.animation.displacement import Displacement
from facemodel.animation.event import Event
from facemodel.animation.idle import Idle
from facemodel.animation.samples import Samples
from facemodel.animation.speech import Phoneme, Speech, Viseme, Word
from facemodel.animation.track import Track

CHANNELS = ("12L", "12R", "6L", "6R", "26", "17", "43L", "43R", "head.yaw", "eyeL.pitch")

times = st.integers(0, 600).map(lambda frame: frame / 60.0)
values = st.floats(0, 1)
names = st.text(max_size=12)
back = st.tuples(st.floats(-2, 0), st.floats(-2, 2))
ahead = st.tuples(st.floats(0, 2), st.floats(-2, 2))
keys = st.builds(Key, times, values, st.sampled_from(SHAPES), back, ahead, st.booleans(), st.booleans())


either = st.booleans()


def curves(least: int = 0, most: int = 8, overshoot: st.SearchStrategy[bool] = either) -> st.SearchStrategy[Curve]:
    several = st.lists(keys, min_size=least, max_size=most, unique_by=lambda key: key.time)
    return st.builds(curve_of, several, overshoot)


samples = st.builds(
    Samples,
    st.lists(st.floats(0, 1, width=32), min_size=1, max_size=40).map(lambda each: np.array(each, dtype=np.float32)),
    st.sampled_from([24.0, 30.0, 60.0]),
    times,
)
layers = st.builds(
    Displacement,
    curves(0, 4, st.just(False)),
    st.sampled_from([0.05, 0.25, 1.0]),
    st.floats(0, 1),
    st.booleans(),
    names,
)


@st.composite
def tracks(draw: st.DrawFn, channel: str = "12L") -> Track:
    captured = draw(st.none() | samples)
    over = tuple(draw(st.lists(layers, max_size=2))) if captured is not None else ()
    flags = draw(st.tuples(st.booleans(), st.booleans(), st.booleans()))
    return Track(channel, draw(curves()), captured, over, *flags, draw(names))


@st.composite
def events(draw: st.DrawFn, key: str = "event") -> Event:
    onset, peak, offset = sorted(draw(st.tuples(st.floats(0, 2), st.floats(0, 2), st.floats(0, 2))))
    return Event(
        key,
        tuple(draw(st.lists(st.sampled_from(CHANNELS), min_size=1, max_size=3, unique=True))),
        draw(times),
        onset,
        draw(st.floats(1, 10)),
        draw(st.floats(0, 1.5)),
        peak,
        draw(st.floats(1, 10)),
        offset,
        draw(names),
        draw(st.booleans()),
    )


@st.composite
def speeches(draw: st.DrawFn) -> Speech:
    symbols = draw(st.lists(st.sampled_from(["M", "AA1", "P", "iː", "SIL", "OW", "??"]), max_size=8))
    ends = np.cumsum(draw(st.lists(st.floats(0.02, 0.4), min_size=len(symbols), max_size=len(symbols)))).tolist()
    spans = list(zip(symbols, [0.0, *ends], ends, strict=False))
    own = (Viseme("own", ("Q",), {"12": 0.5, "jaw drop": 0.2}, 0.7, True),) if draw(st.booleans()) else ()
    return Speech(
        tuple(Phoneme(*span) for span in spans),
        (Word("hello", 0.0, 1.0),) if draw(st.booleans()) else (),
        own,
        draw(st.floats(0, 2)),
        draw(st.booleans()),
    )


@st.composite
def animations(draw: st.DrawFn) -> Animation:
    channels = draw(st.lists(st.sampled_from(CHANNELS), max_size=4, unique=True))
    start = draw(times)
    return Animation(
        tracks=tuple(draw(tracks(channel)) for channel in channels),
        events=tuple(draw(events(f"event {k}")) for k in range(draw(st.integers(0, 3)))),
        speech=draw(speeches()),
        idle=draw(st.none() | st.builds(Idle, st.integers(0, 9), st.floats(0, 30), st.floats(0, 2))),
        expressions=tuple(KeyExpression(time, "key") for time in sorted(draw(st.sets(times, max_size=3)))),
        rate=draw(st.sampled_from([12.0, 24.0, 29.97, 60.0, 120.0])),
        start=start,
        end=start + draw(st.floats(0.1, 10)),
        loop=draw(st.booleans()),
        markers=tuple(Marker(time, draw(names)) for time in sorted(draw(st.sets(times, max_size=3)))),
        ranges=tuple(NamedRange(draw(names), time, time + 1.0) for time in draw(st.lists(times, max_size=2))),
        audio=draw(st.none() | st.just(Audio("voice/line 1.wav", 0.5))),
    )
