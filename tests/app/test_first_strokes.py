"""What a newcomer's first stroke does, before anybody has set a value."""

from dataclasses import replace

import numpy as np
import pytest

from app.authoring.bare import unpainted
from app.document import Document
from app.tools import TOOLS, Bench, ToolBox
from app.view import View
from facemodel.painting.brush import MODES
from facemodel.painting.layers import PAINT_LAYERS, PaintLayer
from facemodel.project import Project
from tests.app.test_tools import on_skin, stroke

SEEN = 0.4
"""Part of what was there that a change has to be, so that nobody doubts it."""

TURNED = 10.0
"""Degrees of grain that are seen to have turned."""

MODED = [
    (layer, mode)
    for layer in PAINT_LAYERS
    for mode in MODES[layer.kind]
    if mode not in ("smooth", "comb", "erase") and not (mode == "scale" and layer.default == 0)
]
"""Layers and what brushes do to them; any multiple of nothing is nothing."""


@pytest.mark.parametrize(("layer", "mode"), MODED, ids=[f"{layer.key}-{mode}" for layer, mode in MODED])
def test_the_first_stroke_on_every_layer_does_something(project: Project, layer: PaintLayer, mode: str) -> None:
    bare = replace(project, face=unpainted(project.face))
    document, view = Document(bare), View()
    view.change(workspace="tissue")
    box = ToolBox(Bench(document, view), TOOLS)
    box.take("brush")
    box.bench.brush.change(layer=layer.key)
    box.bench.brush.set_mode(mode)  # type: ignore[arg-type]
    stroke(box, (-10, 0), (10, 0))
    before, after = (layer.values(each.face) for each in (bare, document.project))
    under = on_skin(bare.face, 0, 0).skin
    assert under is not None
    changed = abs(after[under.vertex] - before[under.vertex])
    if layer.kind == "amount":
        ordinary = layer.typical or before[under.vertex]
        assert changed > (SEEN if mode == "set" else SEEN / 4) * ordinary
    else:
        assert changed > (TURNED / 2 if layer.kind == "angle" else 0)
    assert np.array_equal(after[0], before[0])
