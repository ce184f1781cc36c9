"""All contact of a face, site by site: what is moved at the mouth is moved nowhere else."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from time import perf_counter
from typing import Protocol

import numpy as np

from facemodel.contact.ball import OnEyeball, near_eyeball
from facemodel.contact.lids import Lids, lay_lids
from facemodel.contact.mouth import Mouth, lay_lips
from facemodel.contact.normals import TurnedNormals, normals_of
from facemodel.contact.teeth import rows_of_teeth
from facemodel.display import DisplaySurface
from facemodel.face import Eye, Face
from facemodel.kinematics import STILL, Stance, stance_of
from facemodel.rows import put_rows
from facemodel.side_by_side import side_by_side
from fem.types import Float32Array, IntArray

INWARDS = 8.0
"""Millimetres that take lips into the teeth."""

KEPT = 3
"""Drawn surfaces whose contact is remembered: that of the document, one more, and one for an export."""


class Rule(Protocol):
    """One thing that skin does where it meets something."""

    def move(self, here: Float32Array, stance: Stance) -> None:
        """Move the posed points (n, 3) of its site, in place."""
        ...


@dataclass(frozen=True, eq=False)
class Site:
    """A place where skin meets something.

    Attributes
    ----------
    rows : (n,) live points that may be moved there
    skin : which of them are skin, the last ones: from this number on
    normals : turns the normals of that skin
    rules : in the order in which they move it
    """

    rows: IntArray
    skin: int
    normals: TurnedNormals
    rules: Sequence[Rule]

    def settle(
        self, live: Float32Array, normals: Float32Array, slopes: Float32Array, stance: Stance
    ) -> Float32Array | None:
        """Move what has to be moved, in place, and return where its points (n, 3) were; see `Contact.settle`."""
        before = live.take(self.rows, axis=0)
        here = before.copy()
        for rule in self.rules:
            rule.move(here, stance)
        moved = here - before
        if not moved.any():
            return None
        put_rows(live, self.rows, here)
        self.normals.turn(normals, slopes, moved[self.skin :])
        return before


WORTH = 3e-4
"""Seconds that the eyes took for the last pose, from which on a second thread is worth its start for the next one."""

Untouched = Sequence[tuple[IntArray, Float32Array]]
"""Live points (n,), and where they were (n, 3) before contact moved them."""


class Contact:
    """Where the skin of a face meets lids, lips, teeth and eyeballs."""

    def __init__(self, face: Face, display: DisplaySurface) -> None:
        self._sites: list[Site] = []
        self._taken = 0.0
        rest = live_at_rest(face, display)
        for number, eye in enumerate(face.eyes):
            self._open_eye(face, display, eye, number, rest)
        mouth = lay_mouth(face, display)
        if mouth is not None:
            self._add(face, display, *mouth)
        self._rehearse(face, display, rest)

    def _rehearse(self, face: Face, display: DisplaySurface, rest: Float32Array) -> None:
        """Press everything together once, so that no loop is left to be compiled while somebody waits for a picture."""
        live = rest.copy()
        for site in self._sites:
            if len(site.rows):
                live[site.rows, 1] = live[site.rows, 1].mean()
                live[site.rows, 2] -= INWARDS
        normals = display.normals.astype(np.float32)
        slopes = np.ascontiguousarray(display.slopes, dtype=np.float32).reshape(6, -1)
        stance = stance_of(face, STILL.posture(face, {}), np.eye(4))
        normals_of(slopes, normals)
        self.settle(live, normals, slopes, stance)

    def _open_eye(self, face: Face, display: DisplaySurface, eye: Eye, number: int, rest: Float32Array) -> None:
        lids = lay_lids(face, display, eye)
        if lids is None:
            rows = np.flatnonzero(near_eyeball(eye, rest))
            self._add(face, display, rows, [OnEyeball(eye, number, rest[rows])])
        else:
            rows, columns = lids
            rules: list[Rule] = [Lids(columns, eye, number, rest[rows]), OnEyeball(eye, number, rest[rows])]
            self._add(face, display, rows, rules)

    def _add(self, face: Face, display: DisplaySurface, rows: IntArray, rules: Sequence[Rule]) -> None:
        first = sum(count for _, count in display.carried)
        skin = int(np.searchsorted(rows, first))
        self._sites.append(Site(rows, skin, TurnedNormals(face, display, rows[skin:] - first), rules))

    def settle(self, live: Float32Array, normals: Float32Array, slopes: Float32Array, stance: Stance) -> Untouched:
        """Keep the skin from going through what it meets, in place, and return what lies otherwise than before.

        Parameters
        ----------
        live : (L, 3) posed points of the carried parts and of the moving skin
        normals : (P, 3) of the skin
        slopes : (6, S) of the moving skin as the sum of the fields has them
        stance : how jaw, eyes and head stand
        """

        def settle(sites: Sequence[Site]) -> tuple[Untouched, float]:
            begun = perf_counter()
            found = [(site.rows, site.settle(live, normals, slopes, stance)) for site in sites]
            return [(rows, before) for rows, before in found if before is not None], perf_counter() - begun

        # The mouth comes last, and costs about as much as both eyes do.
        tasks = partial(settle, self._sites[-1:]), partial(settle, self._sites[:-1])
        both = side_by_side(*tasks) if self._taken > WORTH else (tasks[0](), tasks[1]())
        (mouth, _), (eyes, self._taken) = both
        return [*eyes, *mouth]


def lay_mouth(face: Face, display: DisplaySurface) -> tuple[IntArray, Sequence[Rule]] | None:
    """The live points about the mouth and the rules that move them; none on a face without the slit of a mouth."""
    mouth = lay_lips(face, display)
    if mouth is None:
        return None
    rows, pair = mouth
    rest = live_at_rest(face, display)
    return rows, [Mouth(pair, rows_of_teeth(face), rest[rows])]


def live_at_rest(face: Face, display: DisplaySurface) -> Float32Array:
    """The live points (L, 3) at rest: those of the parts that the skin carries, then those of the moving skin."""
    parts = [part.mesh.positions for part in face.parts if part.carrier == "skin"]
    return np.concatenate([*parts, display.points[: display.moving]]).astype(np.float32)


_known: deque[tuple[Face, DisplaySurface, Contact]] = deque(maxlen=KEPT)


def contact_of(face: Face, display: DisplaySurface) -> Contact:
    """The contact of a drawn face, remembered; any thread may have it made before it is wanted."""
    for known, drawn, contact in tuple(_known):
        if drawn is display and _alike(known, face):
            return contact
    made = Contact(face, display)
    _known.append((face, display, made))
    return made


def _alike(one: Face, other: Face) -> bool:
    """Whether two faces touch themselves in the same places, painted as they may be."""
    return one is other or all(
        getattr(one, name) is getattr(other, name) for name in ("skin", "parts", "eyes", "landmarks", "chart")
    )
