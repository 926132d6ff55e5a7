# SPDX-License-Identifier: Apache-2.0
"""Loads of a blade station over several time steps: linear in its inputs and states about an origin.

The inputs are the velocities of the air relative to the station, the angle of its chord, and yaw and azimuth
for the skewed wake. They follow the motion and the wind at every evaluation, so that the loads are
continuous within a step; their error is of second order in the change of the inputs since the origin.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.rotor.polar import wrapped
from pitchpoint.elements.rotor.slopes import DOWNWIND, INPUTS, THETA, VX, VY, YAW, F

WHOLE = 1.0 - 1e-6
"""Share of the time of extrapolation that counts as all of it: times of steps have rounding errors."""


@kernel
def read_states(b, fr):
    """Read the states of a station from its hidden bodies."""
    b["state"][0] = fr[b["l1"]]["spin"]
    b["state"][1] = fr[b["l2"]]["spin"]
    b["state"][2] = fr[b["l3"]]["spin"]
    b["state"][3] = fr[b["l4"]]["spin"]
    b["state"][4] = fr[b["l5"]]["spin"]


@kernel
def write_rates(b, fr):
    """Add the rates of the states to the forces on the hidden bodies."""
    fr[b["l1"]]["F"][5] += b["rates"][0]
    fr[b["l2"]]["F"][5] += b["rates"][1]
    fr[b["l3"]]["F"][5] += b["rates"][2]
    fr[b["l4"]]["F"][5] += b["rates"][3]
    fr[b["l5"]]["F"][5] += b["rates"][4]


@kernel
def keep_origin(b, t):
    """Store the loads at a time as the origin; their derivatives remain in the record."""
    p = b["point"]
    x = b["origin"]
    x[VX] = p["vx"]
    x[VY] = p["vy"]
    x[THETA] = p["pitch"]
    x[YAW] = p["yaw"]
    x[DOWNWIND] = p["downwind"]
    loads = b["loads"]
    loads[0] = p["f_n"]
    loads[1] = p["f_t"]
    loads[2] = p["m_c"]
    for n in range(F + 1 - INPUTS):
        x[INPUTS + n] = b["state"][n]
        loads[3 + n] = b["rates"][n]
    b["since"] = t


@kernel
def extrapolate(b, fr):
    """Write the loads, and the rates of the states, by their derivatives at the origin."""
    p = b["point"]
    x = b["origin"]
    L = b["slopes"]
    Q = b["by_rate"]
    loads = b["loads"]
    d = (
        p["vx"] - x[VX],
        p["vy"] - x[VY],
        wrapped(p["pitch"] - x[THETA]),
        p["yaw"] - x[YAW],
        p["downwind"] - x[DOWNWIND],
    )
    f_n = loads[0]
    f_t = loads[1]
    m_c = loads[2]
    for n in range(INPUTS):
        f_n += L[0, n] * d[n]
        f_t += L[1, n] * d[n]
        m_c += L[2, n] * d[n]
    if b["inflow"] != 0:
        read_states(b, fr)
        for r in range(5):
            rate = loads[3 + r]
            for n in range(INPUTS):
                rate += Q[r, n] * d[n]
            for n in range(5):
                rate += Q[r, INPUTS + n] * (b["state"][n] - x[INPUTS + n])
            b["rates"][r] = rate
        for n in range(5):
            change = b["state"][n] - x[INPUTS + n]
            f_n += L[0, INPUTS + n] * change
            f_t += L[1, INPUTS + n] * change
            m_c += L[2, INPUTS + n] * change
        write_rates(b, fr)
    p["f_n"] = f_n
    p["f_t"] = f_t
    p["m_c"] = m_c
