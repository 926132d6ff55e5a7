# SPDX-License-Identifier: Apache-2.0
"""Quantities between frames by matrices alone: the oracle of the sensors."""

from __future__ import annotations

import numpy as np

from tests.support.trees import poses


def placed(system, state, time):
    """Origins and attitudes of all bodies along q + v t + a t^2/2, ground first."""
    dofs = system.program["body"]["dof"][1:]
    q = state.q + time * state.v + 0.5 * time**2 * state.a
    return poses(system.bodies, q, dofs, state.charts)


def skew(turn):
    """Vector of a skew matrix."""
    return np.array([turn[2, 1], turn[0, 2], turn[1, 0]])


def derivative(function, order, step=2e-3):
    """First or second derivative of a function of time at zero, error of sixth order in the step."""
    f = {k: function(k * step) for k in range(-3, 4)}
    if order == 1:
        found = 45.0 * (f[1] - f[-1]) - 9.0 * (f[2] - f[-2]) + (f[3] - f[-3])
        return found / (60.0 * step)
    found = 270.0 * (f[1] + f[-1]) - 27.0 * (f[2] + f[-2]) + 2.0 * (f[3] + f[-3]) - 490.0 * f[0]
    return found / (180.0 * step**2)


def way(system, state, i, j, points, axis):
    """Component along an axis of body j of the way from its point to that of body i, over time."""

    def at(time):
        frames = placed(system, state, time)
        (r_i, S_i), (r_j, S_j) = frames[i], frames[j]
        return (S_j @ axis) @ (r_i + S_i @ points[0] - r_j - S_j @ points[1])

    return at


def distance(system, state, i, j, points):
    """Distance of two points over time."""

    def at(time):
        frames = placed(system, state, time)
        (r_i, S_i), (r_j, S_j) = frames[i], frames[j]
        return np.linalg.norm(r_i + S_i @ points[0] - r_j - S_j @ points[1])

    return at


def relative_spin(system, state, i, j, axis):
    """Component along an axis of body j of the relative angular velocity, as a function of time."""

    def at(time):
        frames = placed(system, state, time)

        def omega(b):
            rate = derivative(lambda s: placed(system, state, time + s)[b][1], 1)
            return skew(rate @ frames[b][1].T)

        return (frames[j][1] @ axis) @ (omega(i) - omega(j))

    return at
