# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies of point masses and springs, for tests of reduction and of the floating frame."""

from __future__ import annotations

import numpy as np

from pitchpoint.multibody.structure import make_structure


def truss(seed=1, stiffness=1e4):
    """Nine point masses in space, every pair joined by a spring along its line."""
    rng = np.random.default_rng(seed)
    places = rng.uniform(-1.0, 1.0, size=(9, 3))
    masses = rng.uniform(0.5, 2.0, size=9)
    K = np.zeros((27, 27))
    for a in range(9):
        for b in range(a):
            e = places[a] - places[b]
            e /= np.linalg.norm(e)
            row = np.zeros(27)
            row[3 * a : 3 * a + 3], row[3 * b : 3 * b + 3] = e, -e
            K += stiffness * np.outer(row, row)
    return make_structure(K, np.diag(np.repeat(masses, 3)), places)


def reference_forces(body, shape, stiffness, frame, eta, origin=(0.0, 0.0, 0.0), gravity=(0.0, 0.0, 0.0)):
    """Wrench on the frame and modal forces of the point masses of a body, by their accelerations.

    `frame` is a record with r, S, tw, ac; `eta` has coordinates, rates and second rates as rows.
    """
    S, w, alpha = frame["S"], frame["tw"][3:], frame["ac"][3:]
    masses = body.M.diagonal().reshape(-1, 3)[:, 0]
    x, rate, second = ((shape @ row).reshape(-1, 3) @ S.T for row in eta)
    arm = (body.places - origin) @ S.T + x
    acceleration = frame["ac"][:3] + np.cross(alpha, arm) + np.cross(w, np.cross(w, arm))
    acceleration += 2.0 * np.cross(w, rate) + second - gravity
    force = -masses[:, None] * acceleration
    modal = np.einsum("pi,pik->k", force, np.einsum("ij,pjk->pik", S, shape.reshape(-1, 3, shape.shape[1])))
    return (
        np.concatenate([force.sum(axis=0), np.cross(arm, force).sum(axis=0)]),
        modal - np.asarray(stiffness) @ eta[0],
    )
