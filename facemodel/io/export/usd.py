"""USD: the face as a skeleton of head, jaw and eyes with blend shapes, still or playing its animation, in metres."""

from __future__ import annotations

from functools import partial
from typing import BinaryIO, Literal

from facemodel.errors import ProjectError
from facemodel.io.export.asked import AS_IT_IS, Asked
from facemodel.io.export.performance import performance
from facemodel.io.export.still import still_performance
from facemodel.project import Project
from facemodel.solution import Progress, silent
from facemodel.solve import Solution

Kind = Literal["usda", "usdc"]
"""Text, or binary."""


def _write(
    kind: Kind,
    project: Project,
    solution: Solution,
    stream: BinaryIO,
    asked: Asked = AS_IT_IS,
    progress: Progress = silent,
) -> str:
    try:
        from facemodel.io.export.usd_stage import stage_bytes
    except ImportError as error:
        raise ProjectError(
            f"USD cannot be written: the library for it is missing ({error}); install it with “pip install usd-core”, "
            "or export glTF (.glb) instead."
        ) from error
    take = asked.take(project)
    if take is None:
        played = still_performance(project, solution.basis)
    else:
        played = performance(take, solution.basis, asked, progress)
    first = 0 if take is None else round(take.start * take.rate)
    stream.write(stage_bytes(kind, project, solution.basis, played, first))
    return "" if take is None else played.remark


write_usda = partial(_write, "usda")
write_usdc = partial(_write, "usdc")
