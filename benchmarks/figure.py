"""One measured figure, and how its times are taken."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from fem.types import FloatArray


@dataclass(frozen=True)
class Figure:
    """A measured value and the yardstick it is held against.

    Attributes
    ----------
    what : what was measured, on how much
    value, unit : the median; None for a remark
    against : the yardstick in words; empty if there is none
    ratio : median of value over yardstick, each pair taken at nearly the same moment
    limit : the largest ratio that is good enough
    """

    what: str
    value: float | None = None
    unit: str = ""
    against: str = ""
    ratio: float | None = None
    limit: float | None = None

    @property
    def verdict(self) -> str:
        """``pass`` or ``MISS``; empty where there is no limit."""
        if self.ratio is None or self.limit is None:
            return ""
        return "pass" if self.ratio <= self.limit else "MISS"


class Unmeasured(Exception):  # noqa: N818 - it is a finding, not an error
    """Something that cannot be measured here, with the reason."""


def told_by(command: Sequence[str], environment: Mapping[str, str] | None = None, patience: float = 1800.0) -> str:
    """What a process of its own prints.

    Raises
    ------
    Unmeasured
        If it fails or takes more seconds than there is patience for, with its last line.
    """
    try:
        done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=patience, check=True)
    except subprocess.TimeoutExpired as error:
        raise Unmeasured(f"{' '.join(command)} took more than {patience:g} seconds.") from error
    except subprocess.CalledProcessError as error:
        last = (error.stderr.strip() or "it said nothing").splitlines()[-1]
        raise Unmeasured(f"{' '.join(command)} ended with status {error.returncode}: {last}") from error
    return done.stdout


def interleaved(steps: Mapping[str, Callable[[], object]], repeats: int) -> dict[str, FloatArray]:
    """Seconds of every step (repeats,), taken in turns, so that what else the machine does falls on all of them.

    Every step runs once before, unmeasured.
    """
    seconds: dict[str, list[float]] = {name: [] for name in steps}
    for repeat in range(repeats + 1):
        for name, step in steps.items():
            start = time.perf_counter()
            step()
            if repeat:
                seconds[name].append(time.perf_counter() - start)
    return {name: np.array(taken) for name, taken in seconds.items()}


def compared(
    what: str, measured: FloatArray, against: str, yardstick: FloatArray, limit: float | None = None
) -> Figure:
    """The figure of some seconds (n,) beside those of its yardstick."""
    return Figure(what, *readable(measured), against, float(np.median(measured / yardstick)), limit)


def alone(what: str, measured: FloatArray) -> Figure:
    """The figure of some seconds (n,) without a yardstick."""
    return Figure(what, *readable(measured))


def readable(seconds: FloatArray) -> tuple[float, str]:
    """Median of some seconds in a unit that suits it."""
    median = float(np.median(seconds))
    return (median, "s") if median >= 1.0 else (1000 * median, "ms")
