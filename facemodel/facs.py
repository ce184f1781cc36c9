"""The tables of action units and emotions that ship with Risorius."""

from __future__ import annotations

import json
from typing import Any

from facemodel.actions import ActionUnit, Emotion
from facemodel.io.records import emotion_of, unit_of
from facemodel.io.schema import EmotionRecord
from facemodel.io.unit_schema import UnitRecord
from resources import resource


def action_units() -> tuple[ActionUnit, ...]:
    """The action units of the table, with the relative activation of their muscles."""
    table = json.loads(resource("facs", "action_units.json").read_text(encoding="utf-8"))
    return tuple(unit_of(UnitRecord.model_validate_json(json.dumps(_whole(row)))) for row in table["units"])


def _whole(row: dict[str, Any]) -> dict[str, Any]:
    """A row of the table with what it may leave out."""
    return {"jaw": None, "note": "", **row}


def emotions() -> tuple[Emotion, ...]:
    """The seven emotions, as weights of action units."""
    table = json.loads(resource("facs", "emotions.json").read_text(encoding="utf-8"))
    return tuple(emotion_of(EmotionRecord.model_validate(row)) for row in table["emotions"])
