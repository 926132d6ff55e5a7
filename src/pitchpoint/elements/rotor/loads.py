# SPDX-License-Identifier: Apache-2.0
"""Induced velocities and loads of blade stations."""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.rotor.induction import inflow_angle, loss
from pitchpoint.elements.rotor.polar import coefficient, interval, wrapped
from pitchpoint.elements.rotor.record import AIR, BATCH, COLUMNS, POINT, STATION
from pitchpoint.multibody.channels import F8


@kernel
def induced(b, air, knots, p):
    """Velocity of the air relative to the station, normal and tangential, from its balance of momentum.

    Writes the loss factor and the balance for its derivatives; returns the velocities and a status.
    """
    sx = 1.0 if p["vx"] >= 0.0 else -1.0
    sy = 1.0 if p["vy"] >= 0.0 else -1.0
    flow = (abs(p["vx"]), abs(p["vy"]), sx, sy, b["twist"] + p["pitch"])
    phi, status, x, y, x_p, y_p, x_t, y_t = inflow_angle(b, air, knots, flow, p)
    balance = p["balance"]
    balance[0] = phi if status == OK else 0.0
    balance[7] = p["vx"]
    if status != OK or phi == 0.0:
        return p["vx"], p["vy"], status
    balance[1] = x
    balance[2] = y
    balance[3] = x_p
    balance[4] = y_p
    balance[5] = x_t
    balance[6] = y_t
    s = math.sin(phi)
    p["loss"], _ = loss(b, abs(s))
    # speed from v = W (X, Y); both components, as either may vanish
    w = abs(s) * (flow[0] * x + flow[1] * y) / (x * x + y * y)
    balance[7] = sx * w * s
    return balance[7], sy * w * math.cos(phi), status


@kernel
def skewed(air, b, p, a):
    """Axial induction in the wake of a yawed or tilted rotor (Pitt and Peters 1981).

    The wake is inclined by χ = (1 + 0.6 a) γ (Burton et al. 2011); the induction grows towards the
    most downwind blade.
    """
    chi = (1.0 + 0.6 * min(max(a, 0.0), 1.0)) * p["yaw"]
    chi = min(max(chi, -0.5 * math.pi), 0.5 * math.pi)
    return a * (1.0 + air["skew"] * math.tan(0.5 * chi) * b["share"] * p["downwind"])


@kernel
def steady_inflow(b, air, knots, p):
    """Velocities of the air relative to a station with its steady induction, and status; writes the loss."""
    vx = p["vx"]
    vy = p["vy"]
    p["loss"] = 1.0
    if b["tip"] <= 0.0 or b["hub"] <= 0.0:
        p["loss"] = 0.0
        return vx, vy, OK
    if (air["axial"] == 0 and air["swirl"] == 0) or (vx == 0.0 and vy == 0.0):
        return vx, vy, OK
    ux, uy, status = induced(b, air, knots, p)
    if air["skew"] != 0.0 and p["yaw"] != 0.0 and vx != 0.0:
        ux = vx * (1.0 - skewed(air, b, p, 1.0 - ux / vx))
    return ux, uy, status


@kernel
def set_angles(b, p, ux, uy):
    """Write induction factors, relative speed, inflow angle and angle of attack for the velocities."""
    p["a"] = 1.0 - ux / p["vx"] if p["vx"] != 0.0 else 0.0
    p["a_prime"] = uy / p["vy"] - 1.0 if p["vy"] != 0.0 else 0.0
    p["speed"] = math.sqrt(ux * ux + uy * uy)
    p["phi"] = math.atan2(ux, uy)
    p["alpha"] = wrapped(p["phi"] - b["twist"] - p["pitch"])


@kernel
def set_coefficients(b, knots, p):
    """Write the steady coefficients at the angle of attack; returns the row of the polar."""
    i = interval(knots, b["first"], b["last"], p["alpha"], p["row"])
    p["row"] = i
    p["lift"], _ = coefficient(knots, i, 1, p["alpha"])
    p["drag"], _ = coefficient(knots, i, 3, p["alpha"])
    p["moment"], _ = coefficient(knots, i, 5, p["alpha"])
    return i


@kernel
def set_forces(b, air, p):
    """Write forces and moment per length.

    At the very tip and root of a blade with losses there is no circulation and no load.
    """
    s = math.sin(p["phi"])
    c = math.cos(p["phi"])
    q = 0.5 * air["rho"] * p["speed"] * p["speed"] * b["chord"]
    if p["loss"] == 0.0:
        q = 0.0
    p["f_n"] = q * (p["lift"] * c + p["drag"] * s)
    p["f_t"] = q * (p["lift"] * s - p["drag"] * c)
    p["m_c"] = q * b["chord"] * p["moment"]


@kernel
def station_loads(b, air, knots, p):
    """Inflow, induction and loads of one station; writes the results of the record p, returns a status."""
    ux, uy, status = steady_inflow(b, air, knots, p)
    set_angles(b, p, ux, uy)
    set_coefficients(b, knots, p)
    set_forces(b, air, p)
    p["status"] = status
    return status


@kernel
def stations_entry(ctl, rec, n):
    """Loads of n points; ctl is the address of a BATCH record, rec that of the points."""
    batch = view(ctl, 1, BATCH)[0]
    stations = view(batch["stations"], batch["n"], STATION)
    knots = view(batch["knots"], (batch["rows"], COLUMNS), F8)
    air = view(batch["air"], 1, AIR)[0]
    points = view(rec, n, POINT)
    worst = OK
    for k in range(n):
        status = station_loads(stations[points[k]["station"]], air, knots, points[k])
        worst = max(worst, status)
    return worst
