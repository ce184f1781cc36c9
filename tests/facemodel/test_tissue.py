"""The tissue between skin and skull: stiff along the normal, soft along the surface, whatever the mesh."""

import numpy as np
import pytest

from facemodel.face import Face
from facemodel.tissue import tissue_springs


def test_sliding_is_softer_than_lifting_by_the_ratio(face: Face) -> None:
    vertices = np.unique(face.skin.triangles[face.solved])
    springs, _, _ = tissue_springs(face, vertices)
    blocks = springs.blocks(len(vertices))
    painted, sliding = face.layers.stiffness[vertices], face.layers.sliding[vertices]
    main = face.skull.anchors[vertices] - face.skin.positions[vertices]
    main /= np.linalg.norm(main, axis=1, keepdims=True)
    along = np.einsum("ni,nij,nj->n", main, blocks, main)
    across = (np.trace(blocks, axis1=1, axis2=2) - along) / 2
    softer = painted / across / sliding
    assert np.median(softer) == pytest.approx(1.0)
    # Where the neighbours' bone lies straight below, struts carry less along the surface, never more.
    assert softer.min() > 1 - 1e-9
    assert np.all(along >= painted * (1 - 1e-9))


def test_stiffness_is_what_was_painted(face: Face) -> None:
    vertices = np.unique(face.skin.triangles[face.solved])
    springs, anchors, jawbone = tissue_springs(face, vertices)
    main = slice(0, len(vertices))
    assert springs.stiffness[main] == pytest.approx(face.layers.stiffness[vertices])
    assert np.array_equal(springs.vertices[main], np.arange(len(vertices)))
    assert np.array_equal(anchors[main], face.skull.anchors[vertices])
    assert np.array_equal(jawbone[main], face.skull.jawbone[vertices])


def test_struts_go_to_the_bone_of_the_neighbours(face: Face) -> None:
    vertices = np.unique(face.skin.triangles[face.solved])
    springs, anchors, _ = tissue_springs(face, vertices)
    adjacency = face.skin.adjacency
    degree = np.diff(adjacency.indptr)[vertices]
    struts = springs.vertices[len(vertices) :]
    assert np.array_equal(np.bincount(struts), degree)
    one = 100
    around = adjacency.indices[adjacency.indptr[vertices[one]] : adjacency.indptr[vertices[one] + 1]]
    own = anchors[len(vertices) :][struts == one]
    assert sorted(map(tuple, own)) == sorted(map(tuple, face.skull.anchors[around]))
    reach = own - face.skin.positions[vertices[one]]
    direction = springs.directions[len(vertices) :][struts == one]
    assert np.cross(reach, direction) == pytest.approx(0.0, abs=1e-9)
