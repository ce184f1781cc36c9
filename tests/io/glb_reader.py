"""A reader of binary glTF by the letter of its specification, that also plays its animation."""

import json
import struct
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation


class Glb:
    """A reader of binary glTF by the letter of its specification."""

    def __init__(self, data: bytes) -> None:
        magic, version, length = struct.unpack_from("<4sII", data)
        assert (magic, version, length) == (b"glTF", 2, len(data))
        size, kind = struct.unpack_from("<I4s", data, 12)
        assert kind == b"JSON"
        assert size % 4 == 0
        self.json: dict[str, Any] = json.loads(data[20 : 20 + size])
        rest, kind = struct.unpack_from("<I4s", data, 20 + size)
        assert kind == b"BIN\0"
        self.bin = data[28 + size : 28 + size + rest]
        self.meshes = {mesh["name"]: mesh for mesh in self.json["meshes"]}

    def view(self, number: int, dtype: str) -> np.ndarray:
        view = self.json["bufferViews"][number]
        assert view.get("byteOffset", 0) % 4 == 0
        start = view.get("byteOffset", 0)
        return np.frombuffer(self.bin[start : start + view["byteLength"]], dtype)

    def array(self, number: int) -> np.ndarray:
        accessor = self.json["accessors"][number]
        dtype = {5123: "<u2", 5125: "<u4", 5126: "<f4"}[accessor["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        values = np.zeros((accessor["count"], width), dtype)
        if "bufferView" in accessor:
            values = self.view(accessor["bufferView"], dtype).reshape(-1, width).copy()
        assert len(values) == accessor["count"]
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            kind = {5123: "<u2", 5125: "<u4"}[sparse["indices"]["componentType"]]
            rows = self.view(sparse["indices"]["bufferView"], kind)
            assert len(rows) == sparse["count"]
            assert np.all(np.diff(rows.astype(int)) > 0)
            values[rows] = self.view(sparse["values"]["bufferView"], dtype).reshape(-1, width)
        if "min" in accessor:
            assert np.array_equal(values.min(axis=0), np.array(accessor["min"], dtype))
            assert np.array_equal(values.max(axis=0), np.array(accessor["max"], dtype))
        return values

    def posed(self, name: str, weights: list[float], attribute: str = "POSITION") -> np.ndarray:
        primitive = self.meshes[name]["primitives"][0]
        total = self.array(primitive["attributes"][attribute]).astype(float)
        for weight, target in zip(weights, primitive.get("targets", []), strict=False):
            total += weight * self.array(target[attribute])
        return total

    @property
    def times(self) -> np.ndarray:
        """Seconds of the keys of the animation, which all its channels share."""
        inputs = {sampler["input"] for sampler in self.json["animations"][0]["samplers"]}
        assert len(inputs) == 1
        return self.array(inputs.pop())[:, 0]

    def playing(self, key: int) -> dict[str, np.ndarray]:
        """Where the vertices of every mesh are at a key of the animation, in metres."""
        nodes = [dict(node) for node in self.json["nodes"]]
        animation = self.json["animations"][0]
        count = len(self.times)
        for channel in animation["channels"]:
            values = self.array(animation["samplers"][channel["sampler"]]["output"])
            nodes[channel["target"]["node"]][channel["target"]["path"]] = values.reshape(count, -1)[key]
        found: dict[str, np.ndarray] = {}

        def walk(number: int, matrix: np.ndarray) -> None:
            node = nodes[number]
            own = np.eye(4)
            own[:3, :3] = Rotation.from_quat(node.get("rotation", [0, 0, 0, 1])).as_matrix()
            own[:3, 3] = node.get("translation", [0, 0, 0])
            matrix = matrix @ own
            if "mesh" in node:
                mesh = self.json["meshes"][node["mesh"]]
                weights = node.get("weights", mesh.get("weights", []))
                places = self.posed(mesh["name"], list(weights))
                found[mesh["name"]] = places @ matrix[:3, :3].T + matrix[:3, 3]
            for child in node.get("children", []):
                walk(child, matrix)

        walk(self.json["scenes"][0]["nodes"][0], np.eye(4))
        return found
