"""Eyeballs, teeth, tongue, lashes, lid sockets and mouth lining, from the base mesh's own pieces."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.optimize import least_squares
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import splu

from facemodel.actions import Side
from facemodel.face import Carrier, Eye, Part, PartKind
from facemodel.making.cut import Cut, island_of, uv_islands
from facemodel.making.wheel import BaseMesh
from facemodel.mesh import Mesh
from facemodel.smooth import smooth_step
from fem.types import FloatArray, IntArray

LASH_GROUPS = {
    "L": ("helper-l-eyelashes-1", "helper-l-eyelashes-2"),
    "R": ("helper-r-eyelashes-1", "helper-r-eyelashes-2"),
}
EYE_GROUPS = {"L": "helper-l-eye", "R": "helper-r-eye"}
NEAREST = 4
"""Skin vertices that carry a lash vertex: enough to be smooth, few enough to stay on its own lid."""


def fitted_sphere(points: FloatArray) -> tuple[FloatArray, float]:
    """Least-squares sphere through points (n, 3): centre (3,) and radius."""
    matrix = np.column_stack([2 * points, np.ones(len(points))])
    solution = np.linalg.lstsq(matrix, (points**2).sum(axis=1), rcond=None)[0]
    return solution[:3], float(np.sqrt(solution[3] + solution[:3] @ solution[:3]))


LID_GAP = 0.3
"""Millimetres between the eyeball and the lid margins that rest on it."""

CARUNCLE = 4.0
"""Millimetres about the inner corner of the eye where the lids do not touch the eyeball."""


def eye(side: Side, base: BaseMesh, shape: FloatArray, margin: FloatArray) -> Eye:
    """One eyeball of a shape (V, 3), pushed back until the lids rest on it.

    The radius is that of the base mesh's eye, whose front stands millimetres before the lids; the centre is the
    one with which the lid margins lie nearest to the eyeball's surface.

    Parameters
    ----------
    margin : (n, 3) the loop of the skin around this eye
    """
    centre, radius = fitted_sphere(shape[np.unique(base.groups[EYE_GROUPS[side]][:, :, 0])])
    inner = margin[np.abs(margin[:, 0]).argmin()]
    resting = margin[np.linalg.norm(margin - inner, axis=1) > CARUNCLE]
    fitted = least_squares(lambda c: np.linalg.norm(resting - c, axis=1) - radius - LID_GAP, centre)
    return Eye(side, np.asarray(fitted.x), radius)


def _triangles(quads: IntArray) -> tuple[IntArray, IntArray]:
    """Triangles numbered from zero and the base vertices they use."""
    q = quads[:, :, 0]
    used, triangles = np.unique(np.concatenate([q[:, [0, 1, 2]], q[:, [0, 2, 3]]]), return_inverse=True)
    return triangles.reshape(-1, 3).astype(np.int64), used


def rigid(base: BaseMesh, shape: FloatArray, group: str, name: str, kind: PartKind, carrier: Carrier) -> Part:
    """A part that moves as one piece."""
    triangles, used = _triangles(base.groups[group])
    none = np.zeros((0, 0))
    return Part(name, kind, carrier, Mesh(shape[used], triangles), none.astype(np.int64), none)


def _harmonic_shares(mesh: Mesh, rim: IntArray) -> FloatArray:
    """Weights (n, len(rim)) that carry rim values smoothly over a pocket; rows sum to one."""
    degree = np.asarray(mesh.adjacency.sum(axis=1)).ravel()
    laplacian = csr_array(diags_array(degree) - mesh.adjacency)
    inner = np.setdiff1d(np.arange(len(mesh.positions)), rim)
    shares = np.zeros((len(mesh.positions), len(rim)))
    shares[rim, np.arange(len(rim))] = 1.0
    factor = splu(laplacian[inner][:, inner].tocsc())
    shares[inner] = factor.solve(-laplacian[inner][:, rim].toarray())
    return shares


def pocket(base: BaseMesh, shape: FloatArray, cut: Cut, seed: int, name: str, kind: PartKind) -> Part:
    """A pocket of the base mesh (mouth, eye socket) that hangs on the loop of the skin where it was cut off.

    Parameters
    ----------
    seed : a base vertex inside the pocket
    """
    quads = island_of(base.groups["body"], uv_islands(base.groups["body"]), seed)
    triangles, used = _triangles(quads)
    mesh = Mesh(shape[used], triangles)
    skin_of = {int(a): k for k, (a, _) in enumerate(cut.ends)}
    rim = np.array([k for k, v in enumerate(used) if int(v) in skin_of])
    if kind == "lining":
        mesh = mesh.moved(_withdrawn(mesh.positions, mesh.positions[rim]))
    shares = _harmonic_shares(mesh, rim)
    if kind == "lining":
        shares = _with_own_lip(shares, shape[used], rim)
    anchors = np.broadcast_to(np.array([skin_of[int(used[k])] for k in rim]), shares.shape).copy()
    return Part(name, kind, "skin", mesh, anchors, shares)


def _with_own_lip(shares: FloatArray, points: FloatArray, rim: IntArray) -> FloatArray:
    """Shares (n, len(rim)) by which the floor of the mouth follows the lower lip alone and its roof the upper one.

    Without it the floor would rise against a jaw that opens, and hide the lower teeth.
    """
    level = points[rim][:, 1].mean()
    t = np.clip((level - points[:, 1]) / LIP_SEAM, -1, 1)
    low = (1 + np.sin(np.pi / 2 * t)) / 2
    is_low = low[rim]
    own = shares * (low[:, None] * is_low + (1 - low[:, None]) * (1 - is_low) + 1e-6)
    own[rim] = shares[rim]
    return np.asarray(own / own.sum(axis=1, keepdims=True))


LIP_SEAM = 5.0
"""Millimetres above and below the slit over which the lining goes from the one lip to the other."""


def lowered_tongue(part: Part) -> Part:
    """The tongue at rest behind the lower teeth: the base mesh's fills the closed mouth to the palate."""
    points = part.mesh.positions
    floor = points[:, 1].min()
    flat = np.stack([points[:, 0] * 0.92, floor + 0.55 * (points[:, 1] - floor), points[:, 2] - 5.0], axis=1)
    return replace(part, mesh=part.mesh.moved(flat))


def _withdrawn(points: FloatArray, rim: FloatArray) -> FloatArray:
    """Points (n, 3) of the mouth's pocket drawn in behind its rim.

    Its walls run a millimetre under the skin of cheeks and chin, and would come through when the lips move; what
    shows of them is the dark behind the teeth.
    """
    away = np.linalg.norm(points[:, None] - rim[None], axis=2).min(axis=1)
    share = smooth_step((away - WITHDRAW_FROM) / (WITHDRAW_TO - WITHDRAW_FROM))[:, None]
    inward = (rim.mean(axis=0) - points) * WITHDRAW_SHRINK - [0.0, 0.0, WITHDRAW_BACK]
    return np.asarray(points + share * inward)


WITHDRAW_FROM, WITHDRAW_TO = 2.0, 12.0
WITHDRAW_SHRINK = np.array([0.35, 0.35, 0.0])
WITHDRAW_BACK = 8.0
"""Millimetres from the rim between which the lining is drawn in, the share by which it narrows, and how far back."""


def lashes(base: BaseMesh, shape: FloatArray, skin: FloatArray, loop: IntArray, side: str) -> Part:
    """Upper and lower lashes of one eye, carried by the nearest vertices of their own lid's margin."""
    level = skin[loop][:, 1].mean()
    pieces = [_triangles(base.groups[group]) for group in LASH_GROUPS[side]]
    positions = np.concatenate([shape[used] for _, used in pieces])
    anchors, shares = [], []
    for _, used in pieces:
        upper = shape[used][:, 1].mean() > level
        margin = loop[(skin[loop][:, 1] > level) == upper]
        distance = np.linalg.norm(shape[used][:, None] - skin[margin][None], axis=2)
        near = np.argsort(distance, axis=1)[:, :NEAREST]
        weight = 1 / (np.take_along_axis(distance, near, axis=1) + 0.1)
        anchors.append(margin[near])
        shares.append(weight / weight.sum(axis=1, keepdims=True))
    starts = np.cumsum([0] + [len(used) for _, used in pieces[:-1]])
    triangles = np.concatenate([t + start for (t, _), start in zip(pieces, starts, strict=True)])
    mesh = Mesh(positions, triangles)
    return Part(f"lashes-{side}", "lashes", "skin", mesh, np.concatenate(anchors), np.concatenate(shares))
