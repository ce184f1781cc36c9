"""The muscles of a project as a whole: lay, replace, rename, duplicate and delete, with the units that use them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace

from facemodel.actions import ActionUnit
from facemodel.errors import MuscleError, UnknownNameError
from facemodel.laying.checks import checked
from facemodel.laying.names import checked_name, name_from, unique_name
from facemodel.laying.sides import mirrored, partner, put, side_of
from facemodel.muscles import Fibre, Muscle, Sphincter
from facemodel.muscles.muscle import Model
from facemodel.muscles.parameters import COUNT, KAPPA, STRENGTH, WIDTH
from facemodel.project import Project


@dataclass(frozen=True, eq=False)
class Deletion:
    """What is left when muscles are deleted.

    Attributes
    ----------
    project : without them
    users : by the name of each muscle that is gone on both sides, the numbers of the action units that
        contracted it and no longer do
    """

    project: Project
    users: Mapping[str, tuple[int, ...]]


def muscle_of(project: Project, key: str) -> Muscle:
    """The muscle with a key, for example ``risorius_L``.

    Raises
    ------
    UnknownNameError
        If there is none.
    """
    for muscle in project.muscles:
        if muscle.key == key:
            return muscle
    known = ", ".join(muscle.key for muscle in project.muscles) or "none yet"
    raise UnknownNameError(f"There is no muscle “{key}”; this face has {known}.")


def new_muscle(
    project: Project,
    title: str,
    group: str,
    *,
    fibres: tuple[Fibre, ...] = (),
    ring: Sphincter | None = None,
    model: Model | None = None,
) -> Muscle:
    """A muscle with default values that a project does not have yet, on the side where it lies.

    Parameters
    ----------
    title : name for people, from which the name for files is made
    group : which decides its colour
    fibres, ring : what it is made of, see `fibres.laid_fibre` and `rings.laid_ring`
    model : by default fibres or a sphincter, after what it is made of

    Raises
    ------
    MuscleError
        If it cannot be used as it lies.
    """
    return checked(drafted_muscle(project, title, group, fibres=fibres, ring=ring, model=model), project.face)


def drafted_muscle(
    project: Project,
    title: str,
    group: str,
    *,
    fibres: tuple[Fibre, ...] = (),
    ring: Sphincter | None = None,
    model: Model | None = None,
) -> Muscle:
    """A new muscle as `new_muscle` makes it, while it is still in the hand and may lie as it should not."""
    places = [fibre.points[k] for fibre in fibres for k in (0, -1)] + ([ring.centre] if ring else [])
    return Muscle(
        name=unique_name(name_from(title), [each.name for each in project.muscles]),
        side=side_of(project.face, *places),
        title=title.strip() or "Muscle",
        group=group,
        model=model or ("sphincter" if ring is not None and not fibres else "fibre"),
        fibres=fibres,
        ring=ring,
        width=WIDTH.default,
        kappa=KAPPA.default if fibres else 1.0,
        strength=STRENGTH.default,
        count=int(COUNT.default) if fibres else 1,
    )


def jaw_muscle(project: Project) -> Muscle:
    """The force of an opening jaw as a new muscle: it needs nothing but the jaw's axis."""
    return drafted_muscle(project, "Jaw force", "chin", model="jaw")


def with_muscle(project: Project, muscle: Muscle) -> Project:
    """A project with a new muscle, or with a changed one in place; its linked partner follows.

    Raises
    ------
    MuscleError
        If the muscle, or the partner that follows, cannot be used as it lies.
    """
    muscles = put(project.muscles, checked(muscle, project.face), project.face)
    other = partner(muscles, muscle)
    if other is not None and all(other is not each for each in project.muscles):
        checked(other, project.face)
    return replace(project, muscles=muscles)


def renamed(project: Project, name: str, to: str) -> Project:
    """A project in which a muscle has another name, on both sides and in the action units that contract it.

    Parameters
    ----------
    name, to : without side

    Raises
    ------
    UnknownNameError
        If there is no such muscle.
    MuscleError
        If the new name is taken or cannot be one.
    """
    if all(muscle.name != name for muscle in project.muscles):
        raise UnknownNameError(f"There is no muscle “{name}” to rename.")
    checked_name(to, project.muscles, but=name)
    muscles = tuple(replace(each, name=to) if each.name == name else each for each in project.muscles)
    units = tuple(_renamed_in(unit, name, to) for unit in project.units)
    return replace(project, muscles=muscles, units=units)


def _renamed_in(unit: ActionUnit, name: str, to: str) -> ActionUnit:
    if name not in unit.muscles:
        return unit
    return replace(unit, muscles={to if key == name else key: weight for key, weight in unit.muscles.items()})


def deleted(project: Project, keys: Collection[str]) -> Deletion:
    """A project without some muscles; units let go of those that are gone on every side.

    Raises
    ------
    UnknownNameError
        If there is no such muscle.
    """
    gone = {muscle_of(project, key).name for key in keys}
    muscles = tuple(muscle for muscle in project.muscles if muscle.key not in keys)
    gone -= {muscle.name for muscle in muscles}
    users = {name: users_of(project, name) for name in sorted(gone) if users_of(project, name)}
    units = tuple(
        replace(unit, muscles={name: weight for name, weight in unit.muscles.items() if name not in gone})
        if gone & unit.muscles.keys()
        else unit
        for unit in project.units
    )
    return Deletion(replace(project, muscles=muscles, units=units), users)


def duplicated(project: Project, keys: Iterable[str]) -> tuple[Project, tuple[str, ...]]:
    """A project with a copy of each muscle at the same place; both sides of one name stay of one name.

    Returns
    -------
    project : with the copies at the end
    keys : of the copies
    """
    return added(project, [muscle_of(project, key) for key in keys])


def added(project: Project, muscles: Iterable[Muscle]) -> tuple[Project, tuple[str, ...]]:
    """A project with more muscles, renamed where their names are taken; both sides of one name stay of one name.

    Returns
    -------
    project : with them at the end
    keys : that they came to have
    """
    taken = {muscle.name for muscle in project.muscles}
    names: dict[str, str] = {}
    new: list[Muscle] = []
    for muscle in muscles:
        if muscle.name not in names:
            names[muscle.name] = unique_name(muscle.name, taken)
            taken.add(names[muscle.name])
        new.append(replace(muscle, name=names[muscle.name]))
    return replace(project, muscles=(*project.muscles, *new)), tuple(muscle.key for muscle in new)


def on_other_side(project: Project, keys: Iterable[str]) -> tuple[Project, tuple[str, ...]]:
    """A project in which the mirror image of each muscle lies on the other side, in place of what was there.

    Returns
    -------
    project : with the mirror images
    keys : of the mirror images

    Raises
    ------
    MuscleError
        If a muscle lies across the midline and has no other side.
    """
    made: list[Muscle] = []
    for muscle in [muscle_of(project, key) for key in keys]:
        if muscle.side == "M":
            raise MuscleError(f"“{muscle.key}” lies across the midline and has no other side.")
        image = mirrored(muscle, project.face)
        other = partner(project.muscles, muscle)
        muscles = project.muscles if other else (*project.muscles, image)
        project = replace(project, muscles=tuple(image if each is other else each for each in muscles))
        made.append(image)
    return project, tuple(image.key for image in made)


def users_of(project: Project, name: str) -> tuple[int, ...]:
    """Numbers of the action units that contract a muscle, by its name without side."""
    return tuple(unit.number for unit in project.units if name in unit.muscles)
