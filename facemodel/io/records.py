"""Muscles, action units, emotions and settings as JSON of a project document, and back from checked records."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

import numpy as np

from facemodel.actions import EXAGGERATED, LETTERS, ActionUnit, Emotion, JawMotion
from facemodel.io.schema import (
    CosineRecord,
    EmotionRecord,
    FibreRecord,
    MuscleRecord,
    ProfilesRecord,
    SettingsRecord,
    SphincterRecord,
)
from facemodel.io.unit_schema import UnitRecord
from facemodel.motions import EyeMotion, HeadMotion, TongueMotion
from facemodel.muscles import Cosine, Fibre, Muscle, Profile, Profiles, Sphincter
from facemodel.project import Settings
from fem.types import FloatArray


def point_json(vector: FloatArray) -> list[float]:
    """A vector (3,) as plain numbers."""
    return [float(x) for x in vector]


def weights_json(weights: Mapping[str, float]) -> dict[str, float]:
    """Weights by name as plain numbers."""
    return {name: float(weight) for name, weight in weights.items()}


def muscle_json(muscle: Muscle) -> dict[str, Any]:
    """What `MuscleRecord` reads; what only some muscles have is left out of the others."""
    document: dict[str, Any] = {
        "name": muscle.name,
        "side": muscle.side,
        "title": muscle.title,
        "group": muscle.group,
        "model": muscle.model,
        "fibres": [_fibre_json(fibre) for fibre in muscle.fibres],
        "ring": None if muscle.ring is None else _ring_json(muscle.ring),
        "width": float(muscle.width),
        "kappa": float(muscle.kappa),
        "strength": float(muscle.strength),
        "count": int(muscle.count),
    }
    if muscle.profiles is not None:
        document["profiles"] = {
            "sigma": _profile_json(muscle.profiles.sigma),
            "tau": _profile_json(muscle.profiles.tau),
        }
    if muscle.cosine is not None:
        document["cosine"] = {
            "box": point_json(muscle.cosine.box),
            "share": float(muscle.cosine.share),
            "factors": point_json(muscle.cosine.factors),
        }
    if not muscle.linked:
        document["linked"] = False
    if muscle.colour:
        document["colour"] = muscle.colour
    return document


def _fibre_json(fibre: Fibre) -> dict[str, Any]:
    ends = {"origin": point_json(fibre.origin), "attachment": point_json(fibre.attachment)}
    return ends | ({"via": [point_json(point) for point in fibre.via]} if fibre.via else {})


def _profile_json(profile: Profile) -> dict[str, Any]:
    return {"at": [float(x) for x in profile.at], "values": [float(x) for x in profile.values]}


def _ring_json(ring: Sphincter) -> dict[str, Any]:
    return {
        "centre": point_json(ring.centre),
        "long_axis": point_json(ring.long_axis),
        "short_axis": point_json(ring.short_axis),
        "sector": point_json(ring.sector),
        "focus": float(ring.focus),
        "inward": float(ring.inward),
        "forward": float(ring.forward),
    }


def muscle_of(record: MuscleRecord) -> Muscle:
    """The muscle of a record."""
    return Muscle(
        name=record.name,
        side=record.side,
        title=record.title,
        group=record.group,
        model=record.model,
        fibres=tuple(_fibre_of(fibre) for fibre in record.fibres),
        ring=None if record.ring is None else _ring_of(record.ring),
        width=record.width,
        kappa=record.kappa,
        strength=record.strength,
        count=record.count,
        profiles=None if record.profiles is None else _profiles_of(record.profiles),
        cosine=None if record.cosine is None else _cosine_of(record.cosine),
        linked=record.linked,
        colour=record.colour,
    )


def _fibre_of(record: FibreRecord) -> Fibre:
    via = tuple(np.array(point) for point in record.via)
    return Fibre(np.array(record.origin), np.array(record.attachment), via)


def _profiles_of(record: ProfilesRecord) -> Profiles:
    sigma, tau = (Profile(each.at, each.values) for each in (record.sigma, record.tau))
    return Profiles(sigma, tau)


def _cosine_of(record: CosineRecord) -> Cosine:
    return Cosine(np.array(record.box), record.share, np.array(record.factors))


def _ring_of(record: SphincterRecord) -> Sphincter:
    return Sphincter(
        centre=np.array(record.centre),
        long_axis=np.array(record.long_axis),
        short_axis=np.array(record.short_axis),
        sector=np.array(record.sector),
        focus=record.focus,
        inward=record.inward,
        forward=record.forward,
    )


def unit_json(unit: ActionUnit) -> dict[str, Any]:
    """What `UnitRecord` reads; a limit and letters that are the usual ones are left out."""
    document: dict[str, Any] = {
        "number": int(unit.number),
        "name": unit.name,
        "group": unit.group,
        "paired": bool(unit.paired),
        "muscles": weights_json(unit.muscles),
        "amplitude": float(unit.amplitude),
        "jaw": None if unit.jaw is None else _jaw_json(unit.jaw),
        "note": unit.note,
    }
    if unit.limit != EXAGGERATED:
        document["limit"] = float(unit.limit)
    if unit.letters != LETTERS:
        document["letters"] = [float(weight) for weight in unit.letters]
    for name, motion in (("eyes", unit.eyes), ("head", unit.head), ("tongue", unit.tongue)):
        if motion is not None:
            document[name] = {part: float(value) for part, value in asdict(motion).items()}
    return document


def _jaw_json(jaw: JawMotion) -> dict[str, float]:
    """A motion that stays in the middle says nothing of a side."""
    middle = {"degrees": float(jaw.degrees), "slide": float(jaw.slide)}
    return middle | {"side": float(jaw.side)} if jaw.side else middle


def unit_of(record: UnitRecord) -> ActionUnit:
    """The action unit of a record."""
    return ActionUnit(
        number=record.number,
        name=record.name,
        group=record.group,
        paired=record.paired,
        muscles=dict(record.muscles),
        amplitude=record.amplitude,
        jaw=None if record.jaw is None else JawMotion(record.jaw.degrees, record.jaw.slide, record.jaw.side),
        note=record.note,
        limit=record.limit,
        letters=record.letters,
        eyes=None if record.eyes is None else EyeMotion(**record.eyes.model_dump()),
        head=None if record.head is None else HeadMotion(**record.head.model_dump()),
        tongue=None if record.tongue is None else TongueMotion(**record.tongue.model_dump()),
    )


def emotion_json(emotion: Emotion) -> dict[str, Any]:
    """What `EmotionRecord` reads; one that is not on the pad has no place."""
    place = {} if emotion.place is None else {"place": [float(x) for x in emotion.place]}
    return {"name": emotion.name, "weights": weights_json(emotion.weights), **place}


def emotion_of(record: EmotionRecord) -> Emotion:
    """The emotion of a record."""
    return Emotion(record.name, dict(record.weights), record.place)


def settings_json(settings: Settings) -> dict[str, Any]:
    """What `SettingsRecord` reads."""
    return {"element": settings.element, "density": int(settings.density)}


def settings_of(record: SettingsRecord) -> Settings:
    """The settings of a record."""
    return Settings(record.element, record.density)
