"""A skull from elsewhere while it is fitted to the head: what was picked on it, and where it comes to lie.

It is no part of the project until it is used, so that nothing of it is saved or undone; then it is one step.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from psygnal import Signal
from scipy.spatial.transform import Rotation

from app.authoring.skull import known_skull, with_bone
from facemodel.errors import SkullError
from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.project import Project
from facemodel.skull.fitting import FEWEST, Kind, SkullFit, bone_targets, fitted
from facemodel.skull.mending import Bone
from facemodel.skull.naming import spoken
from facemodel.skull.placement import carried
from facemodel.skull.registration import laid_on, proposed
from fem.types import FloatArray

PLACES: Mapping[str, str] = {
    "nasion": "the root of the nose, where the nasal bones meet the forehead",
    "pogonion": "the foremost point of the chin",
    "zygion_L": "the outermost point of the cheek’s arch, on the skull’s own left",
    "zygion_R": "the outermost point of the cheek’s arch, on the skull’s own right",
    "gonion_L": "the angle of the jaw, where its lower edge turns up, left",
    "gonion_R": "the angle of the jaw, where its lower edge turns up, right",
    "glabella": "the foremost point between the brows",
    "rhinion": "the lower end of the nasal bones",
    "mid_philtrum": "the hollow between the nose’s spine and the upper incisors",
    "chin_lip_fold": "the hollow between the lower incisors and the chin",
    "menton": "the lowest point of the chin",
    "supraorbital_L": "the upper rim of the orbit, above its middle, left",
    "supraorbital_R": "the upper rim of the orbit, above its middle, right",
    "suborbital_L": "the lower rim of the orbit, below its middle, left",
    "suborbital_R": "the lower rim of the orbit, below its middle, right",
    "lateral_orbit_L": "the cheek bone below the outer corner of the orbit, left",
    "lateral_orbit_R": "the cheek bone below the outer corner of the orbit, right",
}
"""What can be picked on a skull, the most telling first, and where it is found."""

SURE = 6
"""Picks from which on their fit says better where the others are than the shape of the whole skull."""

QUARTER = 90.0


@dataclass(frozen=True, eq=False)
class Guest:
    """A skull that is being fitted.

    Attributes
    ----------
    bone : as it was read
    title : what people call it
    face : the head that it is fitted to
    targets : where (3,) on that head the bone of each landmark should lie
    """

    bone: Bone
    title: str
    face: Face
    targets: Mapping[str, FloatArray]


class SkullFitting:
    """Holds the skull that is being fitted, if there is one.

    Attributes
    ----------
    guest : the skull; none while nothing is fitted
    active : the landmark that is asked for
    pointed : the picked landmark under the pointer; empty for none
    held : whether a hand holds a pick, which keeps the skull where it is
    """

    changed = Signal()
    """Another skull, pick or fit."""

    def __init__(self) -> None:
        self.guest: Guest | None = None
        self.active = self.pointed = ""
        self.held = False
        self._kind: Kind = "axes"
        self._picked: dict[str, FloatArray] = {}
        self._first: FloatArray = np.eye(4)
        self._fit: SkullFit | None = None
        self._mesh: Mesh | None = None

    @property
    def on(self) -> bool:
        """Whether a skull is being fitted."""
        return self.guest is not None

    @property
    def kind(self) -> Kind:
        """How it may be scaled."""
        return self._kind

    @property
    def picked(self) -> Mapping[str, FloatArray]:
        """Places (3,) by landmark, in the skull's own axes and unit."""
        return self._picked

    @property
    def fit(self) -> SkullFit | None:
        """The fit by what is picked; none as long as that is too little."""
        return self._fit

    @property
    def ready(self) -> bool:
        """Whether enough is picked to use it."""
        return self._fit is not None and len(self._picked) >= FEWEST

    @property
    def mesh(self) -> Mesh:
        """The skull as it lies in the head now."""
        assert self.guest is not None
        if self._mesh is None:
            own = self.guest.bone.mesh
            self._mesh = own.moved(self.laid(own.positions))
        return self._mesh

    def begin(self, bone: Bone, title: str, project: Project, first: FloatArray | None = None) -> None:
        """Begin to fit a skull to the head of a project.

        Parameters
        ----------
        first : (4, 4) how it is laid into the head before anything is picked; found by its shape if not given

        Raises
        ------
        SkullError
            If the head has too few landmarks.
        """
        found = bone_targets(project.face)
        targets = {name: found[name] for name in PLACES if name in found}
        if len(targets) < FEWEST:
            raise SkullError(
                f"“{project.face.title}” has {len(targets)} landmarks over bone and at least {FEWEST} are needed "
                "to fit a skull; choose another face."
            )
        self.guest = Guest(bone, title, project.face, targets)
        self._first = laid_on(bone.mesh, known_skull(project)) if first is None else first
        self._picked, self.active, self._kind, self.held = {}, next(iter(targets)), "axes", False
        self._settle()

    def end(self) -> None:
        """Think better of it."""
        if self.guest is not None:
            self.guest, self._fit, self._mesh, self._picked = None, None, None, {}
            self.active = self.pointed = ""
            self.changed.emit()

    def choose(self, name: str) -> None:
        """The landmark that is picked next."""
        if name != self.active and self.guest is not None and name in self.guest.targets:
            self.active = name
            self.changed.emit()

    def point(self, name: str) -> None:
        """The picked landmark under the pointer; empty for none."""
        if name != self.pointed:
            self.pointed = name
            self.changed.emit()

    def pick(self, name: str, place: FloatArray) -> None:
        """Say where (3,) a landmark is on the skull, in its own axes and unit; a skull that is held lies still."""
        self._picked[name] = np.asarray(place, dtype=np.float64)
        self._settle()

    def let_go(self, onward: bool = False) -> None:
        """The hand let go of a pick: the skull is fitted to it, and if asked the next free landmark comes up."""
        self.held = False
        if onward and self.guest is not None:
            free = [name for name in self.guest.targets if name not in self._picked]
            self.active = free[0] if free else self.active
        self._settle()

    def forget(self, name: str) -> None:
        """Take a pick back."""
        if self._picked.pop(name, None) is not None:
            self.active = name
            self._settle()

    def restore(self, picked: Mapping[str, FloatArray]) -> None:
        """Have these picks and no others."""
        self._picked, self.held = dict(picked), False
        self._settle()

    def propose(self) -> None:
        """Pick what is not picked yet where it may be by the shape of the skull."""
        if self.guest is None:
            return
        missing = {name: place for name, place in self.guest.targets.items() if name not in self._picked}
        if missing:
            sure = self._fit is not None and len(self._picked) >= SURE
            way = self._fit.way if self._fit is not None and sure else self._first
            self.restore({**self._picked, **proposed(self.guest.bone.mesh, way, missing)})

    def scale(self, kind: Kind) -> None:
        """Scale it in another way."""
        self._kind = kind
        self._settle()

    def turn(self, axis: int) -> None:
        """Turn a skull that nothing is picked on by a quarter about an axis of the head."""
        if self.guest is None or self._fit is not None:
            return
        middle = carried(self.guest.bone.mesh.positions.mean(axis=0)[None], self._first)[0]
        quarter = np.eye(4)
        quarter[:3, :3] = Rotation.from_rotvec(QUARTER * np.eye(3)[axis], degrees=True).as_matrix()
        quarter[:3, 3] = middle - quarter[:3, :3] @ middle
        self._first = quarter @ self._first
        self._settle()

    def used(self, project: Project, origins: bool = True) -> Project:
        """The project with this skull as it lies in its head.

        Raises
        ------
        SkullError
            If too little is picked, or it would not lie in the head.
        """
        if self.guest is None or not self.ready:
            raise SkullError(f"{len(self._picked)} landmarks are picked and at least {FEWEST} are needed; pick more.")
        return with_bone(project, self.mesh, origins)

    def laid(self, points: FloatArray) -> FloatArray:
        """Where places (n, 3) of the skull lie in the head now."""
        return carried(points, self._first) if self._fit is None else self._fit(points)

    def _settle(self) -> None:
        """Fit anew, unless a pick is held: the skull must not slip away under the hand."""
        if self.guest is not None and not self.held:
            self._mesh = None
            try:
                self._fit = fitted(self._picked, self.guest.targets, self._kind)
            except SkullError:
                # Too little is picked yet, or all of it on a line: it lies as it was laid at first.
                self._fit = None
        self.changed.emit()


def title_of(name: str) -> str:
    """A landmark of `PLACES` as the head of a line."""
    said = spoken(name)
    return said[:1].upper() + said[1:]
