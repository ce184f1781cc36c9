"""Muscles, action units, emotions and settings as the records of a project document, and back."""

from __future__ import annotations

import numpy as np

from facemodel.actions import ActionUnit, Emotion, JawMotion
from facemodel.io.face_arrays import as_point
from facemodel.io.schema import (
    EmotionRecord,
    FibreRecord,
    JawMotionRecord,
    MuscleRecord,
    SettingsRecord,
    SphincterRecord,
    UnitRecord,
)
from facemodel.muscles import Fibre, Muscle, Sphincter
from facemodel.project import Settings


def muscle_record(muscle: Muscle) -> MuscleRecord:
    """The record of a muscle; raises `pydantic.ValidationError` if a value is out of its range."""
    return MuscleRecord(
        name=muscle.name,
        side=muscle.side,
        title=muscle.title,
        group=muscle.group,
        model=muscle.model,
        fibres=tuple(
            FibreRecord(origin=as_point(fibre.origin), attachment=as_point(fibre.attachment))
            for fibre in muscle.fibres
        ),
        ring=None if muscle.ring is None else _ring_record(muscle.ring),
        width=float(muscle.width),
        kappa=float(muscle.kappa),
        strength=float(muscle.strength),
        count=int(muscle.count),
    )


def _ring_record(ring: Sphincter) -> SphincterRecord:
    return SphincterRecord(
        centre=as_point(ring.centre),
        long_axis=as_point(ring.long_axis),
        short_axis=as_point(ring.short_axis),
        sector=as_point(ring.sector),
        focus=float(ring.focus),
        inward=float(ring.inward),
        forward=float(ring.forward),
    )


def muscle_of(record: MuscleRecord) -> Muscle:
    """The muscle of a record."""
    return Muscle(
        name=record.name,
        side=record.side,
        title=record.title,
        group=record.group,
        model=record.model,
        fibres=tuple(Fibre(np.array(f.origin), np.array(f.attachment)) for f in record.fibres),
        ring=None if record.ring is None else _ring_of(record.ring),
        width=record.width,
        kappa=record.kappa,
        strength=record.strength,
        count=record.count,
    )


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


def unit_record(unit: ActionUnit) -> UnitRecord:
    """The record of an action unit; raises `pydantic.ValidationError` if a value is out of its range."""
    return UnitRecord(
        number=unit.number,
        name=unit.name,
        group=unit.group,
        paired=unit.paired,
        muscles={name: float(share) for name, share in unit.muscles.items()},
        amplitude=float(unit.amplitude),
        jaw=None
        if unit.jaw is None
        else JawMotionRecord(degrees=float(unit.jaw.degrees), slide=float(unit.jaw.slide)),
        note=unit.note,
    )


def unit_of(record: UnitRecord) -> ActionUnit:
    """The action unit of a record."""
    return ActionUnit(
        number=record.number,
        name=record.name,
        group=record.group,
        paired=record.paired,
        muscles=dict(record.muscles),
        amplitude=record.amplitude,
        jaw=None if record.jaw is None else JawMotion(record.jaw.degrees, record.jaw.slide),
        note=record.note,
    )


def emotion_record(emotion: Emotion) -> EmotionRecord:
    """The record of an emotion; raises `pydantic.ValidationError` if a value is out of its range."""
    return EmotionRecord(
        name=emotion.name, weights={name: float(weight) for name, weight in emotion.weights.items()}
    )


def emotion_of(record: EmotionRecord) -> Emotion:
    """The emotion of a record."""
    return Emotion(record.name, dict(record.weights))


def settings_record(settings: Settings) -> SettingsRecord:
    """The record of the settings; raises `pydantic.ValidationError` if a value is out of its range."""
    return SettingsRecord(element=settings.element, density=settings.density)


def settings_of(record: SettingsRecord) -> Settings:
    """The settings of a record."""
    return Settings(record.element, record.density)
