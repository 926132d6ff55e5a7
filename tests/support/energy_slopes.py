# SPDX-License-Identifier: Apache-2.0
"""Forces of a mesh alone from its stored energy, by differences: the reference of every conservative law."""

from __future__ import annotations

import numpy as np

from tests.support.mesh_alone import moved


def shaken(m, tilt, seed=1):
    """Both bodies displaced by random small amounts."""
    rng = np.random.default_rng(seed)
    size = np.array([1e-5, 1e-5, 5e-5, tilt, tilt, 0.0])
    m.frames = moved(moved(m.frames, 0, size * rng.normal(size=6)), 1, size * rng.normal(size=6))
    return m


def slope_of_energy(m, spins=False):
    """Minus the derivative of the stored energy over world twists of both bodies, shape (2, 6).

    With `spins` the last column belongs to the spin angle of the body instead of the z axis of the world.
    """
    slope = np.zeros((2, 6))
    for body in range(2):
        for k in range(6):
            step = np.zeros(6)
            step[k] = 2e-9 if k < 3 else 2e-8
            energy = []
            for sign in (1, -1):
                if spins and k == 5:
                    frames = m.frames.copy()
                    frames["phi"][body] += sign * step[5]
                else:
                    frames = moved(m.frames, body, sign * step)
                m.evaluate(frames)
                energy.append(m.get("elastic_energy"))
            slope[body, k] = -(energy[0] - energy[1]) / (2 * step[k])
    return slope


def along_spins(m, F):
    """Wrenches with the torque about the spin axis in place of that about the z axis of the world."""
    F = F.copy()
    for body in range(2):
        F[body, 5] = F[body, 3:] @ m.frames["R"][body][:, 2]
    return F
