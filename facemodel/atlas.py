"""The muscle atlas of a face: where its muscles run and how strongly its action units contract them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from pydantic import ValidationError

from facemodel.actions import ActionUnit, JawMotion
from facemodel.errors import ProjectError
from facemodel.io.disk import replacing
from facemodel.io.readable import readable
from facemodel.io.record_types import Name, Record, Weight
from facemodel.io.records import muscle_json, muscle_of
from facemodel.io.schema import MuscleRecord
from facemodel.muscles import Muscle


@dataclass(frozen=True, eq=False)
class Atlas:
    """Muscles of one face.

    Attributes
    ----------
    muscles : with origins and attachments on that face
    gains : for each action unit's number the factor on the activations of the table, which makes it move the skin
        of that face as far as the table says
    """

    muscles: tuple[Muscle, ...]
    gains: Mapping[int, float]

    def scaled(self, unit: ActionUnit) -> ActionUnit:
        """The action unit with this face's activations."""
        gain = self.gains.get(unit.number, 1.0)
        jaw = None if unit.jaw is None else _scaled(unit.jaw, gain)
        return replace(unit, muscles={name: gain * weight for name, weight in unit.muscles.items()}, jaw=jaw)


def _scaled(jaw: JawMotion, gain: float) -> JawMotion:
    """A motion of the jaw that is larger or smaller: of its opening, or of its thrust and shift if it does not open."""
    if jaw.degrees:
        return replace(jaw, degrees=jaw.degrees * gain)
    return replace(jaw, slide=jaw.slide * gain, side=jaw.side * gain)


class AtlasDocument(Record):
    """The JSON of an atlas."""

    provenance: str
    gains: dict[Name, Weight]
    muscles: tuple[MuscleRecord, ...]


def read_atlas(path: Path) -> Atlas:
    """Read an atlas.

    Raises
    ------
    ProjectError
        If the file is missing or not an atlas.
    """
    try:
        document = AtlasDocument.model_validate_json(path.read_bytes())
    except OSError as error:
        raise ProjectError(f"The muscle atlas {path} cannot be read ({error.strerror}); reinstall Risorius.") from error
    except ValidationError as error:
        raise ProjectError(f"The muscle atlas {path} is damaged; reinstall Risorius.") from error
    gains = {int(number): gain for number, gain in document.gains.items()}
    return Atlas(tuple(muscle_of(record) for record in document.muscles), gains)


def write_atlas(atlas: Atlas, provenance: str, path: Path) -> None:
    """Write an atlas as JSON."""
    document = {
        "provenance": provenance,
        "gains": {str(number): gain for number, gain in atlas.gains.items()},
        "muscles": [muscle_json(muscle) for muscle in atlas.muscles],
    }
    with replacing(path) as stream:
        stream.write(readable(document))
