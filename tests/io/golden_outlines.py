"""Outlines of exported files: everything but the long arrays, as text.  ``python -m tests.io.golden_outlines`` writes
those that are kept, for whoever has changed a format on purpose and looks at the difference."""

import io
import json
import re
from collections.abc import Callable, Mapping
from pathlib import Path

from facemodel.io.export import EXPORTS, Asked
from facemodel.io.export.pieces import posed_pieces
from facemodel.kinematics import rig_of
from facemodel.superposition import Superposition
from tests.io.animated import PROJECT, SOLUTION
from tests.io.glb_reader import Glb

FOLDER = Path(__file__).parent / "golden"
SHORT = Asked(rate=12.0, span=(0.25, 0.5))
MOST_NUMBERS = 12
"""Numbers of a line; where there are more it is an array, of which they are counted."""

NUMBER = re.compile(r"(?<![\w.])-?\d+\.?\d*(?:e[-+]?\d+)?(?![\w])")


def _model(suffix: str) -> bytes:
    stream = io.BytesIO()
    EXPORTS[suffix].write(PROJECT, SOLUTION, stream, SHORT)
    return stream.getvalue()


def _frame(suffix: str) -> bytes:
    clip = SHORT.take(PROJECT)
    write = EXPORTS[suffix].frame
    assert clip is not None
    assert write is not None
    pose = Superposition(PROJECT.face, SOLUTION.basis, rig_of(PROJECT.units))
    pose.turned = clip.rigid(2)
    pose.pose(clip.expression(2))
    stream = io.BytesIO()
    write(PROJECT.face.title, posed_pieces(pose), stream)
    return stream.getvalue()


def _glb() -> str:
    return json.dumps(Glb(_model(".glb")).json, indent=1, ensure_ascii=False)


def _usda() -> str:
    return "\n".join(map(_short, _model(".usda").decode().splitlines()))


def _short(line: str) -> str:
    count = len(NUMBER.findall(line))
    return line if count <= MOST_NUMBERS or " = " not in line else f"{line.partition('=')[0]}= … {count} numbers"


def _obj() -> str:
    """The first line of every kind in each object."""
    found: list[str] = []
    kinds: set[str] = set()
    for line in _frame(".obj").decode().splitlines():
        kind = line.split()[0]
        if kind == "o":
            kinds = set()
        if kind not in kinds:
            found.append(line)
        kinds.add(kind)
    return "\n".join(found)


def _ply() -> str:
    return _frame(".ply").split(b"end_header")[0].decode()


OUTLINES: Mapping[str, Callable[[], str]] = {
    "face.glb.json": _glb,
    "face.usda": _usda,
    "face.obj": _obj,
    "face.ply.txt": _ply,
}


def numbers_and_rest(text: str) -> tuple[list[float], str]:
    """Split an outline, so that the last digits of numbers, which differ between machines, can be told apart."""
    return [float(found) for found in NUMBER.findall(text)], NUMBER.sub("#", text)


if __name__ == "__main__":
    for name, outline in OUTLINES.items():
        (FOLDER / name).write_text(outline() + "\n", "utf-8")
