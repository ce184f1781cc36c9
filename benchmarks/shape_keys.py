"""Blender's side of the comparison, for a Python that has ``bpy``: evaluate shape keys, print the seconds as JSON.

python shape_keys.py POINTS KEYS
"""

from __future__ import annotations

import json
import sys
import time

import bpy
import numpy as np

REPEATS = 11


def grid(side: int) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (side^2, 3) and quads of a square."""
    ticks = np.linspace(0.0, 1.0, side)
    x, y = (axis.ravel() for axis in np.meshgrid(ticks, ticks))
    corner = np.arange(side * side).reshape(side, side)
    quads = np.stack([corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]], axis=-1)
    return np.column_stack([x, y, np.zeros_like(x)]), quads.reshape(-1, 4)


def keyed_object(points: int, keys: int) -> bpy.types.Object:
    """A grid of about so many points with shape keys."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    vertices, quads = grid(round(points**0.5))
    mesh = bpy.data.meshes.new("grid")
    mesh.from_pydata(vertices.tolist(), [], quads.tolist())
    made = bpy.data.objects.new("grid", mesh)
    bpy.context.scene.collection.objects.link(made)
    made.shape_key_add(name="Basis")
    rng = np.random.default_rng(0)
    for number in range(keys):
        key = made.shape_key_add(name=f"key {number}")
        moved = vertices + 0.01 * rng.random(vertices.shape)
        key.data.foreach_set("co", moved.astype(np.float32).ravel())
        key.value = 0.5
    return made


def evaluated(made: bpy.types.Object, out: np.ndarray) -> None:
    """Evaluate the object and read its vertices."""
    graph = bpy.context.evaluated_depsgraph_get()
    graph.update()
    made.evaluated_get(graph).data.vertices.foreach_get("co", out)


def seconds(made: bpy.types.Object, chosen: list[int]) -> list[float]:
    """Seconds to see the mesh after the values of some keys changed."""
    keys = made.data.shape_keys.key_blocks
    out = np.empty(3 * len(made.data.vertices), dtype=np.float32)
    taken = []
    for repeat in range(REPEATS + 2):
        start = time.perf_counter()
        for number in chosen:
            keys[number + 1].value = 0.3 + 0.001 * ((number + repeat) % 100)
        evaluated(made, out)
        taken.append(time.perf_counter() - start)
    return taken[2:]


if __name__ == "__main__":
    points, keys = (int(argument) for argument in sys.argv[1:])
    grid_object = keyed_object(points, keys)
    result = {"all": seconds(grid_object, list(range(keys))), "one": seconds(grid_object, [7])}
    print(json.dumps(result))
