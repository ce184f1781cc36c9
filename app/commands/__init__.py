"""Commands: what is done to a project and undone, as frozen values.

A command holds the difference and nothing else.  ``do`` and ``undo`` are pure: they make another project
of the one they are given.
"""

from app.commands.animation import EditAnimation, edit_animation
from app.commands.command import Command, array_bytes
from app.commands.content import EditContent, edit_content
from app.commands.corrections import SetCorrections, set_corrections
from app.commands.keyed import KeyedDelta
from app.commands.painting import (
    ArrayName,
    PaintedRows,
    PaintLayers,
    layer_array,
    paint_deltas,
    paint_layers,
    with_layer_array,
)
from app.commands.skull import SetSkull, set_skull
from app.commands.weights import SetWeights, set_weights
from app.commands.whole import ReplaceProject, Several

__all__ = [
    "ArrayName",
    "Command",
    "EditAnimation",
    "EditContent",
    "KeyedDelta",
    "PaintLayers",
    "PaintedRows",
    "ReplaceProject",
    "SetCorrections",
    "SetSkull",
    "SetWeights",
    "Several",
    "array_bytes",
    "edit_animation",
    "edit_content",
    "layer_array",
    "paint_deltas",
    "paint_layers",
    "set_corrections",
    "set_skull",
    "set_weights",
    "with_layer_array",
]
