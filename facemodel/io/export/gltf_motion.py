"""The animation of a glTF file: weights of morph targets, and the motion of head, jaw and eyes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from pygltflib import (
    ANIM_LINEAR,
    Animation,
    AnimationChannel,
    AnimationChannelTarget,
    AnimationSampler,
)

from facemodel.io.export.gltf_buffer import GltfBuffer
from facemodel.io.export.gltf_mesh import METRES
from facemodel.io.export.gltf_nodes import GltfNodes
from facemodel.io.export.performance import Performance


class GltfMotion:
    """Collects the channels of one animation."""

    def __init__(self, played: Performance, buffer: GltfBuffer) -> None:
        self._played = played
        self._buffer = buffer
        self._times = buffer.samples(played.times, bounded=True)
        self._samplers: list[AnimationSampler] = []
        self._channels: list[AnimationChannel] = []
        self._weights: dict[tuple[int, ...], int] = {}

    def animation(self, name: str, nodes: GltfNodes, morphs: Mapping[str, Sequence[int]]) -> Animation:
        """The animation.

        Parameters
        ----------
        name : what it is called
        nodes : what is moved
        morphs : for each mesh which shapes of the performance its targets are
        """
        for mesh, chosen in morphs.items():
            if chosen:
                self._add(nodes.meshes[mesh], "weights", self._weights_of(tuple(chosen)))
        for joint in self._played.joints:
            node = nodes.joints.get(joint.name)
            if node is None:
                continue
            if joint.shifts:
                self._add(node, "translation", self._sampler(self._buffer.samples(METRES * joint.places)))
            if joint.rotates:
                self._add(node, "rotation", self._sampler(self._buffer.samples(joint.turns)))
        return Animation(name=name, samplers=self._samplers, channels=self._channels)

    def _weights_of(self, chosen: tuple[int, ...]) -> int:
        """The sampler of some weights; meshes with the same targets share it."""
        if chosen not in self._weights:
            values = self._played.weights[:, list(chosen)]
            self._weights[chosen] = self._sampler(self._buffer.samples(values.ravel()))
        return self._weights[chosen]

    def _sampler(self, output: int) -> int:
        self._samplers.append(AnimationSampler(input=self._times, output=output, interpolation=ANIM_LINEAR))
        return len(self._samplers) - 1

    def _add(self, node: int, path: str, sampler: int) -> None:
        target = AnimationChannelTarget(node=node, path=path)
        self._channels.append(AnimationChannel(sampler=sampler, target=target))
