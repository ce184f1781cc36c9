"""``python blender_play.py FILE FOLDER RATE FRAME ...``, for a Python that has ``bpy``: play a face in Blender.

For every frame, counted from 0, FOLDER gets ``FRAME.npz`` with the places (n, 3) of all vertices by the name of their
object, in metres with y up.  What was found is printed as JSON.
"""

import json
import sys
from pathlib import Path

import bpy
import numpy as np


def opened(path: str, rate: float) -> None:
    """Open a file in an empty scene that runs at its rate."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps, scene.render.fps_base = round(rate), round(rate) / rate
    if path.endswith(".glb"):
        bpy.ops.import_scene.gltf(filepath=path)
    else:
        bpy.ops.wm.usd_import(filepath=path, set_frame_range=True)


def places() -> dict[str, np.ndarray]:
    """Where all vertices are now."""
    graph = bpy.context.evaluated_depsgraph_get()
    found = {}
    for thing in bpy.context.scene.objects:
        if thing.type != "MESH":
            continue
        seen = thing.evaluated_get(graph)
        mesh = seen.to_mesh()
        flat = np.empty(3 * len(mesh.vertices), dtype=np.float32)
        mesh.vertices.foreach_get("co", flat)
        seen.to_mesh_clear()
        matrix = np.array(seen.matrix_world)
        x, y, z = (flat.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]).T
        found[thing.data.name if thing.name.startswith("Mesh") else thing.name] = np.stack([x, z, -y], axis=1)
    return found


if __name__ == "__main__":
    file, folder, rate, *frames = sys.argv[1:]
    opened(file, float(rate))
    scene = bpy.context.scene
    first = scene.frame_start
    for frame in frames:
        scene.frame_set((0 if file.endswith(".glb") else first) + int(frame))
        np.savez(Path(folder) / f"{frame}.npz", **places())
    keys = [mesh.shape_keys for mesh in bpy.data.meshes if mesh.shape_keys]
    about = {
        "version": bpy.app.version_string,
        "shapes": max((len(each.key_blocks) - 1 for each in keys), default=0),
        "first": first,
        "range": [scene.frame_start, scene.frame_end],
        "objects": [f"{o.type} {o.name}" for o in scene.objects],
    }
    print("\n" + json.dumps(about))
