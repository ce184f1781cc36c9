"""MPEG-4 face animation parameters as text (ISO/IEC 14496-2, annex C), version 2.1.

The first line has the version, a name, frames per second and their number.  Every frame has a line of 68 marks, 1 for
each parameter that it gives, and a line with its number and the values of these.  Values of distances are in units of
the face (`FAPU`), 1024 to each; turns are in hundred-thousandths of a radian.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from facemodel.animation.capture import Capture
from facemodel.io.damage import DamageError
from facemodel.io.weights.table import decoded

Unit = Literal["MNS", "MW", "ENS", "ES", "IRISD", "AU", ""]
"""Mouth to nose, width of the mouth, eye to nose, between the eyes, iris, angle; none of the first two parameters."""

COUNT = 68
AGAIN = "write it again with the program that it comes from"

FAPS: tuple[tuple[str, Unit], ...] = (
    ("viseme", ""),
    ("expression", ""),
    ("open_jaw", "MNS"),
    ("lower_t_midlip", "MNS"),
    ("raise_b_midlip", "MNS"),
    ("stretch_l_cornerlip", "MW"),
    ("stretch_r_cornerlip", "MW"),
    ("lower_t_lip_lm", "MNS"),
    ("lower_t_lip_rm", "MNS"),
    ("raise_b_lip_lm", "MNS"),
    ("raise_b_lip_rm", "MNS"),
    ("raise_l_cornerlip", "MNS"),
    ("raise_r_cornerlip", "MNS"),
    ("thrust_jaw", "MNS"),
    ("shift_jaw", "MW"),
    ("push_b_lip", "MNS"),
    ("push_t_lip", "MNS"),
    ("depress_chin", "MNS"),
    ("close_t_l_eyelid", "IRISD"),
    ("close_t_r_eyelid", "IRISD"),
    ("close_b_l_eyelid", "IRISD"),
    ("close_b_r_eyelid", "IRISD"),
    ("yaw_l_eyeball", "AU"),
    ("yaw_r_eyeball", "AU"),
    ("pitch_l_eyeball", "AU"),
    ("pitch_r_eyeball", "AU"),
    ("thrust_l_eyeball", "ES"),
    ("thrust_r_eyeball", "ES"),
    ("dilate_l_pupil", "IRISD"),
    ("dilate_r_pupil", "IRISD"),
    ("raise_l_i_eyebrow", "ENS"),
    ("raise_r_i_eyebrow", "ENS"),
    ("raise_l_m_eyebrow", "ENS"),
    ("raise_r_m_eyebrow", "ENS"),
    ("raise_l_o_eyebrow", "ENS"),
    ("raise_r_o_eyebrow", "ENS"),
    ("squeeze_l_eyebrow", "ES"),
    ("squeeze_r_eyebrow", "ES"),
    ("puff_l_cheek", "ES"),
    ("puff_r_cheek", "ES"),
    ("lift_l_cheek", "ENS"),
    ("lift_r_cheek", "ENS"),
    ("shift_tongue_tip", "MW"),
    ("raise_tongue_tip", "MNS"),
    ("thrust_tongue_tip", "MW"),
    ("raise_tongue", "MNS"),
    ("tongue_roll", "AU"),
    ("head_pitch", "AU"),
    ("head_yaw", "AU"),
    ("head_roll", "AU"),
    ("lower_t_midlip_o", "MNS"),
    ("raise_b_midlip_o", "MNS"),
    ("stretch_l_cornerlip_o", "MW"),
    ("stretch_r_cornerlip_o", "MW"),
    ("lower_t_lip_lm_o", "MNS"),
    ("lower_t_lip_rm_o", "MNS"),
    ("raise_b_lip_lm_o", "MNS"),
    ("raise_b_lip_rm_o", "MNS"),
    ("raise_l_cornerlip_o", "MNS"),
    ("raise_r_cornerlip_o", "MNS"),
    ("stretch_l_nose", "ENS"),
    ("stretch_r_nose", "ENS"),
    ("raise_nose", "ENS"),
    ("bend_nose", "ENS"),
    ("raise_l_ear", "ENS"),
    ("raise_r_ear", "ENS"),
    ("pull_l_ear", "ENS"),
    ("pull_r_ear", "ENS"),
)
"""All parameters by number, the first is 1, and the unit that each is measured in."""

FAP_NAMES = tuple(name for name, _ in FAPS)


def read_fap(data: bytes, rate: float | None = None) -> Capture:
    """A capture from the bytes of a file of face animation parameters, in their own units.

    The two parameters of whole visemes and expressions are left out.

    Raises
    ------
    DamageError
        If it is no such file, cut short, or a line is not as it has to be.
    """
    lines = [line.split() for line in decoded(data).splitlines() if line.strip() and not line.lstrip().startswith("#")]
    own, count = _head(lines)
    body = lines[1:]
    if len(body) < 2 * count:
        raise DamageError(
            f"frame {len(body) // 2}", f"is where it ends, and it should have {count} frames", "read a whole copy of it"
        )
    values = np.zeros((count, COUNT))
    given = np.zeros(COUNT, dtype=np.bool_)
    for frame in range(count):
        mask, numbers = _marks(body[2 * frame], frame), _numbers(body[2 * frame + 1], frame)
        whole, mask[:2] = int(mask[:2].sum()), False
        # A whole viseme or expression has several values, all before those that have one each.
        few = len(numbers) - 1 - int(mask.sum()) - whole
        if few < 0 or (few > 0 and not whole):
            told = len(numbers) - 1
            raise DamageError(f"frame {frame}", f"gives {told} values for {int(mask.sum()) + whole} marks", AGAIN)
        values[frame] = values[frame - 1] if frame else 0.0
        values[frame, mask] = numbers[len(numbers) - int(mask.sum()) :]
        given |= mask
    notes = () if rate is None or rate == own else (f"It says {own:g} frames a second and was taken as {rate:g}.",)
    names = tuple(name for name, here in zip(FAP_NAMES, given.tolist(), strict=True) if here)
    return Capture("fap", names, values[:, given].astype(np.float32), rate or own, 0.0, notes)


def _head(lines: list[list[str]]) -> tuple[float, int]:
    head = lines[0] if lines else []
    try:
        version, own, count = head[0], float(head[-2]), int(head[-1])
    except (IndexError, ValueError) as error:
        raise DamageError("line 1", "is not a version, a name, frames per second and their number", AGAIN) from error
    if not version.startswith("2") or not 1.0 <= own <= 1000.0 or count < 1:
        raise DamageError("line 1", "is not that of a file of version 2.1 with some frames", AGAIN)
    return own, count


def _marks(words: list[str], frame: int) -> np.ndarray:
    if len(words) != COUNT or not set(words) <= {"0", "1"}:
        raise DamageError(f"frame {frame}", f"has no line of {COUNT} marks, each 0 or 1", AGAIN)
    return np.array([word == "1" for word in words])


def _numbers(words: list[str], frame: int) -> list[float]:
    try:
        found = [float(word) for word in words]
    except ValueError:
        raise DamageError(f"frame {frame}", "has a value that is no number", AGAIN) from None
    if not np.isfinite(found).all():
        raise DamageError(f"frame {frame}", "has a value that is no number", AGAIN)
    return found
