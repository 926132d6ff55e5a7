# SPDX-License-Identifier: Apache-2.0
"""Shapes and workspace of a flexible rim in the pool of the meshes; see `flexible_rim`."""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.kind import RIM

GROUP = 3
"""Modal coordinates per hidden body."""
MAX_MODES = GROUP * (len(RIM) - 2)
"""Maximum number of modal coordinates."""
MAX_WAVES = 32
"""Maximum number of waves of a shape around the circumference."""
WAY = 12 + MAX_MODES
"""Motions of both bodies and coordinates."""

#: Workspace of the rim of one mesh; the rows of its shapes follow in the pool.
WORKSPACE = np.dtype(
    [
        ("rows", "i8"),  # of the shapes: coordinate, waves, component, factors of cosine and sine
        ("waves", "i8"),  # their largest number
        ("cosine", "f8", MAX_WAVES + 1),
        ("sine", "f8", MAX_WAVES + 1),
        ("eta", "f8", (2, MAX_MODES)),  # coordinates and their rates
        ("shape", "f8", (3, MAX_MODES, 6)),  # a_k, c_k and their derivatives by theta, world axes
        ("sum", "f8", (3, 6)),  # the same times eta
        ("flow", "f8", (2, 6)),  # the same times the rates
        ("turn", "f8", 12),  # g_i, g_j
        ("d_turn", "f8", 12),
        ("theta_rate", "f8"),
        ("tw", "f8", 6),  # twist of body j
        ("out", "f8", 3),
        ("along", "f8", 3),  # radius and tangent at theta, world axes
        ("reach", "f8"),  # distance of the centres in the plane of the rim
        ("arm", "f8", 3),  # mid-face of gear 1 from its origin
        ("line", "f8", 3),  # mid-face of gear 1 from the origin of body j
        ("way", "f8", (6, WAY)),  # motion of the frame of the teeth by those of bodies and coordinates
        ("half", "f8", (12, WAY)),
        ("whole", "f8", (WAY, WAY)),
    ],
    align=True,
)

WORKSPACE_BYTES = WORKSPACE.itemsize


def rim_workspace(terms: np.ndarray) -> np.ndarray:
    """Pool entry of a flexible rim with these shapes, rows as in `multibody.ring_modes.ring_terms`."""
    head = np.zeros(1, WORKSPACE)
    head["rows"], head["waves"] = len(terms), int(terms[:, 1].max())
    return np.concatenate([head.view("f8"), np.ravel(terms)])


@kernel
def hidden(b, g):
    """Hidden body of the modal coordinates of group g."""
    if g == 0:
        return b["h1"]
    if g == 1:
        return b["h2"]
    if g == 2:
        return b["h3"]
    if g == 3:
        return b["h4"]
    if g == 4:
        return b["h5"]
    if g == 5:
        return b["h6"]
    if g == 6:
        return b["h7"]
    if g == 7:
        return b["h8"]
    return b["h9"] if g == 8 else b["h10"]


@kernel
def put3(x, first, a):
    """Write three consecutive elements."""
    x[first] = a[0]
    x[first + 1] = a[1]
    x[first + 2] = a[2]
