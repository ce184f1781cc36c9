"""The skull in scripts: ``skull.move(z=-3)``, ``skull.snap()``, ``skull.load("skull.obj")``."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from app.authoring import skull as authoring
from app.authoring.jaw import with_jaw_axis
from app.scripting.desk import ScriptDesk
from app.scripting.painting import Painter, Where
from app.skull_fitting import PLACES, SkullFitting
from facemodel.errors import SkullError, UnknownNameError
from facemodel.face import AT_REST, Pose, Skull, Triple
from facemodel.project import Project
from facemodel.skull.findings import Findings, findings
from facemodel.skull.fitting import KINDS, Kind
from facemodel.skull.jaw_region import whole_skull
from facemodel.skull.tissue_depths import LandmarkDepth, landmark_depths
from fem.types import BoolArray, FloatArray


class SkullHandle:
    """The skull of the project.

    Parameters
    ----------
    desk : what the script works on
    painter : knows the places of the skin by name
    """

    def __init__(self, desk: ScriptDesk, painter: Painter) -> None:
        self._desk, self._painter = desk, painter
        self.origins = True

    def __repr__(self) -> str:
        value = self.value
        return f"skull: {len(value.cranium.triangles)} + {len(value.mandible.triangles)} triangles, {self.pose}"

    @property
    def value(self) -> Skull:
        """The skull as it is now, a frozen value."""
        return self._desk.project.face.skull

    @property
    def pose(self) -> Pose:
        """How it was moved since it was made."""
        return self.value.placement.pose

    def place(
        self, shift: Triple | None = None, turn: Triple | None = None, scale: Triple | float | None = None
    ) -> None:
        """Lay it in another pose: millimetres, degrees and factors along x, y and z; what is left out stays."""
        given: dict[str, Triple] = {}
        for name, numbers in (("shift", shift), ("turn", turn)):
            if numbers is not None:
                given[name] = _triple(numbers)
        if scale is not None:
            given["scale"] = (float(scale),) * 3 if isinstance(scale, int | float) else _triple(scale)
        pose = replace(self.pose, **given)
        self._edit(lambda project: authoring.with_pose(project, pose, self.origins), "Place skull")

    def move(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> None:
        """Move it by millimetres from where it is."""
        self.place(shift=_triple(np.add(self.pose.shift, (x, y, z))))

    def reset(self) -> None:
        """Put it back to where it was made."""
        self._edit(lambda project: authoring.with_pose(project, AT_REST, self.origins), "Reset skull")

    def template(self) -> None:
        """Go back to the skull that the face is shipped with."""
        self._edit(lambda project: authoring.at_template(project, self.origins), "Template skull")

    def snap(self, scales: bool = True) -> None:
        """Lay bone as deep under the landmarks as the tables say."""
        self._edit(lambda project: authoring.snapped_to_depths(project, scales, self.origins), "Snap skull")

    def depths(self) -> tuple[LandmarkDepth, ...]:
        """How deep bone lies at the landmarks, and how deep it should."""
        return landmark_depths(self._desk.project.face)

    def check(self) -> Findings:
        """Where bone comes through the skin, and which springs are not solved."""
        return findings(self._desk.project.face)

    def load(self, path: str | Path, picks: Mapping[str, Sequence[float]] | None = None, kind: Kind = "axes") -> float:
        """Take a skull from an OBJ, PLY or STL file; returns by how many millimetres rms its landmarks are missed.

        Parameters
        ----------
        path : of the file
        picks : places of landmarks on it, in its own axes and unit, such as ``{"nasion": (0, 5.2, 4.6)}``; those that
            are left out are picked where they may be by the shape of the skull if none is given at all
        kind : how it may be scaled: ``alike``, ``axes`` or ``bent``
        """
        # Here and not above: the reader of meshes takes a while to load, and few scripts need it.
        from facemodel.io.bone_file import read_bone

        if kind not in KINDS:
            raise UnknownNameError(f"A skull is scaled “alike”, by its “axes” or “bent”, not “{kind}”.")
        unknown = [name for name in picks or {} if name not in PLACES]
        if unknown:
            raise UnknownNameError(f"“{unknown[0]}” is not picked on skulls; choose of {', '.join(PLACES)}.")
        fitting = SkullFitting()
        fitting.begin(read_bone(Path(path)), Path(path).name, self._desk.project)
        assert fitting.guest is not None
        for name, place in (picks or {}).items():
            fitting.pick(name, np.array(_triple(place)))
        if picks is None:
            fitting.propose()
        fitting.scale(kind)
        self._edit(lambda project: fitting.used(project, self.origins), f"Import skull {fitting.guest.title}")
        return fitting.fit.rms if fitting.fit is not None else 0.0

    def vertices(self) -> FloatArray:
        """Places (M, 3) of the vertices of both bones as one; a copy."""
        return whole_skull(self.value).mesh.positions.copy()

    def jaw(self) -> BoolArray:
        """Which of them (M,) are jaw; a copy."""
        return whole_skull(self.value).jaw.copy()

    def proposed_jaw(self) -> BoolArray:
        """Which of them (M,) may be jaw."""
        return authoring.proposed_region(self._desk.project)

    def make_jaw(self, vertices: Iterable[bool]) -> None:
        """Make some of them (M,) the jaw, and all other bone the cranium."""
        region = np.fromiter(vertices, dtype=np.bool_)
        count = len(whole_skull(self.value).mesh.positions)
        if region.shape != (count,):
            raise SkullError(f"The jaw is chosen by {count} truth values, one for each vertex of the skull.")
        self._edit(lambda project: authoring.with_jaw_region(project, region), "Choose the jaw")

    def jaw_axis(self, right: Where, left: Where) -> None:
        """Let the jaw turn about the line through two places, the subject's right condyle and the left one."""
        ends = self._painter.place(right), self._painter.place(left)
        self._edit(lambda project: with_jaw_axis(project, *ends), "Place the jaw’s axis")

    def _edit(self, made: Callable[[Project], Project], label: str) -> None:
        self._desk.edit(made, label)


def _triple(numbers: Iterable[float]) -> Triple:
    given = [float(number) for number in numbers]
    if len(given) != 3:
        raise SkullError("A place, a turn or a scale is three numbers, along x, y and z.")
    return given[0], given[1], given[2]
