"""Names of muscles: unique, fit for a file, the same on both sides."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

from facemodel.errors import MuscleError
from facemodel.muscles import Muscle

LONGEST = 100
"""Characters of a name, as in the project file."""

NAME = re.compile(r"\w+(?:-\w+)*", re.ASCII)


def name_from(title: str) -> str:
    """A name for files and scripts made of a title for people: ``Zygomaticus major`` to ``zygomaticus_major``."""
    plain = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode().lower()
    return re.sub(r"[^a-z0-9]+", "_", plain).strip("_")[: LONGEST - 8] or "muscle"


def unique_name(wanted: str, taken: Iterable[str]) -> str:
    """A name that is not taken: the one that is wanted, else with the first free number, ``risorius_2``."""
    used = set(taken)
    if wanted not in used:
        return wanted
    stem = re.sub(r"_\d+$", "", wanted)
    return next(name for k in range(2, len(used) + 3) if (name := f"{stem}_{k}") not in used)


def checked_name(name: str, muscles: Iterable[Muscle], but: str = "") -> str:
    """The name itself, if a muscle may have it.

    Parameters
    ----------
    name : without side
    muscles : those whose names are taken
    but : a name that counts as free, since its muscle is to be renamed

    Raises
    ------
    MuscleError
        If it is empty, too long, has other characters than letters, digits, _ and -, ends like a side, or is taken.
    """
    if not NAME.fullmatch(name) or len(name) > LONGEST:
        raise MuscleError(
            f"“{name}” cannot name a muscle; use up to {LONGEST} letters, digits and underscores, "
            f"for example “{name_from(name)}”."
        )
    if re.search(r"_[LRM]$", name):
        raise MuscleError(f"“{name}” ends like a side; leave “{name[-2:]}” out, the side is kept apart.")
    if any(muscle.name == name != but for muscle in muscles):
        raise MuscleError(f"There is a muscle “{name}” already; choose another name.")
    return name
