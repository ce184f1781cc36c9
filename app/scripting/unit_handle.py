"""Action units in scripts: ``au(12).weight = 0.8``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from app.authoring import intensities, motions, parting, units
from app.authoring.merging import merged
from app.authoring.mirroring import mirrored_unit
from app.intensity import letter_of, weight_of
from app.scripting.desk import ScriptDesk
from app.scripting.sculpt_handle import SculptHandle
from facemodel.actions import ActionUnit, Group, JawMotion
from facemodel.motions import EyeMotion, HeadMotion, TongueMotion
from facemodel.project import Project


class UnitHandle:
    """An action unit of the project, by its number.

    Parameters
    ----------
    desk : what the script works on
    number : of the unit
    """

    def __init__(self, desk: ScriptDesk, number: int) -> None:
        self._desk, self._number = desk, number

    def __repr__(self) -> str:
        unit = self._unit
        return f"au({unit.number}): {unit.name}, {', '.join(unit.fields)}"

    @property
    def _unit(self) -> ActionUnit:
        return units.unit_of(self._desk.project, self._number)

    @property
    def number(self) -> int:
        """Its number."""
        return self._number

    @number.setter
    def number(self, number: int) -> None:
        self._do(lambda project: units.renumbered(project, self._number, number), "Renumber")
        self._number = number

    @property
    def name(self) -> str:
        """What it is called."""
        return self._unit.name

    @name.setter
    def name(self, name: str) -> None:
        self._do(lambda project: units.renamed(project, self._number, name), "Rename")

    @property
    def note(self) -> str:
        """A line for people."""
        return self._unit.note

    @note.setter
    def note(self, note: str) -> None:
        self._do(lambda project: units.with_note(project, self._number, note), "Note of")

    @property
    def limit(self) -> float:
        """The largest weight that its sliders take."""
        return self._unit.limit

    @limit.setter
    def limit(self, limit: float) -> None:
        self._do(lambda project: units.with_limit(project, self._number, limit), "Limit")

    @property
    def fields(self) -> tuple[str, ...]:
        """Names of its sliders."""
        return self._unit.fields

    @property
    def weight(self) -> float:
        """Where its slider stands; of two sides the larger one."""
        return max(self._desk.project.expression.get(field, 0.0) for field in self.fields)

    @weight.setter
    def weight(self, weight: float) -> None:
        self._desk.document.set_weights(dict.fromkeys(self.fields, weight))

    @property
    def letter(self) -> str:
        """The intensity of FACS that its weight is scored as, A to E; empty for none."""
        return letter_of(self.weight, self._unit)

    @letter.setter
    def letter(self, letter: str) -> None:
        self.weight = weight_of(letter, self._unit)

    @property
    def letters(self) -> tuple[float, ...]:
        """The weights at which A, B, C, D and E begin."""
        return self._unit.letters

    @letters.setter
    def letters(self, letters: Sequence[float]) -> None:
        self._do(lambda project: intensities.with_letters(project, self._number, letters), "Intensities of")

    @property
    def group(self) -> Group:
        """Where it is listed, see `facemodel.actions.GROUP_TITLES`."""
        return self._unit.group

    @group.setter
    def group(self, group: Group) -> None:
        self._do(lambda project: units.with_group(project, self._number, group), "Group of")

    @property
    def paired(self) -> bool:
        """Whether left and right move apart, see `split` and `join`."""
        return self._unit.paired

    @property
    def muscles(self) -> dict[str, float]:
        """Activation of each muscle at weight 1, by its name without side; a copy, see `contract`."""
        return dict(self._unit.muscles)

    def contract(self, muscle: str, activation: float) -> None:
        """Contract a muscle, by its name without side, more or less; 0 takes it out."""
        self._do(lambda project: units.with_activation(project, self._number, muscle, activation), "Change")

    @property
    def jaw(self) -> JawMotion | None:
        """What it does to the jaw, see `move_jaw`."""
        return self._unit.jaw

    def move_jaw(self, degrees: float, slide: float = 0.0, side: float = 0.0) -> None:
        """Open the jaw by degrees and slide it forward and to the subject's left by millimetres at weight 1."""
        self._do(lambda project: units.with_jaw(project, self._number, degrees, slide, side), "Change")

    @property
    def sculpt(self) -> SculptHandle:
        """What is sculpted on it, and the brush that sculpts it."""
        return SculptHandle(self._desk, self._number)

    def mirror(self) -> None:
        """Do on the right what it did on the left, and the other way round."""
        partners = self._desk.ground.partners(self._desk.project.face)
        self._do(partial(mirrored_unit, number=self._number, partners=partners), "Mirror")

    def eyes(self) -> EyeMotion | None:
        """What it does to the eyes, see `turn_eyes`."""
        return self._unit.eyes

    def turn_eyes(self, turn: float = 0.0, lift: float = 0.0, spread: float = 0.0) -> None:
        """Turn the eyes at weight 1 by degrees to the subject's left, up, and each of them outwards."""
        self._do(lambda project: motions.with_eyes(project, self._number, turn, lift, spread), "Change")

    @property
    def head(self) -> HeadMotion | None:
        """What it does to the head, see `move_head`."""
        return self._unit.head

    def move_head(self, turn: float = 0.0, lift: float = 0.0, tilt: float = 0.0, forward: float = 0.0) -> None:
        """At weight 1, turn the head left, chin up and to the left shoulder by degrees, and move it by mm."""
        self._do(lambda project: motions.with_head(project, self._number, turn, lift, tilt, forward), "Change")

    @property
    def tongue(self) -> TongueMotion | None:
        """What it does to the tongue, see `move_tongue`."""
        return self._unit.tongue

    def move_tongue(self, out: float = 0.0, lift: float = 0.0) -> None:
        """At weight 1, bring the tip of the tongue out by millimetres, bent up before the teeth by degrees."""
        self._do(lambda project: motions.with_tongue(project, self._number, out, lift), "Change")

    def duplicate(self) -> UnitHandle:
        """A copy of it, behind it in the list."""
        project, number = units.with_duplicate(self._desk.project, self._number)
        self._do(lambda _: project, "Duplicate")
        return UnitHandle(self._desk, number)

    def split(self) -> None:
        """Give left and right a slider each."""
        self._do(partial(parting.split, number=self._number), "Split")

    def join(self) -> None:
        """Give left and right one slider."""
        self._do(partial(parting.joined, number=self._number), "Join")

    def merge(self, other: UnitHandle | int, own: float = 1.0, share: float = 1.0) -> None:
        """Do so much of its own, and of what another unit does, in place of both."""
        number = other if isinstance(other, int) else other.number
        self._do(partial(merged, number=self._number, other=number, own=own, share=share), "Merge")

    def move(self, place: int) -> None:
        """Put it at another place of the list, counted from 0."""
        self._do(partial(units.moved_unit, number=self._number, place=place), "Move")

    def delete(self) -> None:
        """Take it out of the project, and out of every expression."""
        self._do(partial(units.without_units, numbers=[self._number]), "Delete")

    def _do(self, change: Callable[[Project], Project], verb: str) -> None:
        self._desk.edit(change, f"{verb} {self._unit.name}")
