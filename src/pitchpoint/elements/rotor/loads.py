# SPDX-License-Identifier: Apache-2.0
"""Induced velocities and loads of blade stations."""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.rotor.induction import inflow_angle, loss_factor, momentum
from pitchpoint.elements.rotor.polar import coefficient, interval, wrapped
from pitchpoint.elements.rotor.record import AIR, BATCH, POINT, STATION
from pitchpoint.multibody.channels import F8


@kernel
def induced(b, air, knots, p):
    """Velocity of the air relative to the station, normal and tangential, from its balance of momentum.

    Writes the loss factor; returns the velocities and a status.
    """
    sx = 1.0 if p["vx"] >= 0.0 else -1.0
    sy = 1.0 if p["vy"] >= 0.0 else -1.0
    flow = (abs(p["vx"]), abs(p["vy"]), sx, sy, b["twist"] + p["pitch"])
    phi, status = inflow_angle(b, air, knots, flow)
    if status != OK or phi == 0.0:
        return p["vx"], p["vy"], status
    s = math.sin(phi)
    p["loss"] = loss_factor(b, abs(s))
    x, y = momentum(b, air, knots, flow, phi)
    # speed from v = W (X, Y); both components, as either may vanish
    w = abs(s) * (flow[0] * x + flow[1] * y) / (x * x + y * y)
    return sx * w * s, sy * w * math.cos(phi), status


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
def station_loads(b, air, knots, p):
    """Inflow, induction and loads of one station; writes the results of the record p, returns a status.

    At the very tip and root of a blade with losses there is no circulation and no load.
    """
    vx = p["vx"]
    vy = p["vy"]
    ux = vx
    uy = vy
    p["loss"] = 1.0
    status = OK
    free = b["tip"] <= 0.0 or b["hub"] <= 0.0
    if free:
        p["loss"] = 0.0
    elif (air["axial"] != 0 or air["swirl"] != 0) and (vx != 0.0 or vy != 0.0):
        ux, uy, status = induced(b, air, knots, p)
    a = 1.0 - ux / vx if vx != 0.0 else 0.0
    if air["skew"] != 0.0 and p["yaw"] != 0.0 and a != 0.0:
        a = skewed(air, b, p, a)
        ux = vx * (1.0 - a)
    p["a"] = a
    p["a_prime"] = uy / vy - 1.0 if vy != 0.0 else 0.0
    p["speed"] = math.sqrt(ux * ux + uy * uy)
    p["phi"] = math.atan2(ux, uy)
    p["alpha"] = wrapped(p["phi"] - b["twist"] - p["pitch"])
    i = interval(knots, b["first"], b["last"], p["alpha"])
    cl, _ = coefficient(knots, i, 1, p["alpha"])
    cd, _ = coefficient(knots, i, 3, p["alpha"])
    cm, _ = coefficient(knots, i, 5, p["alpha"])
    p["lift"] = cl
    p["drag"] = cd
    p["moment"] = cm
    s = math.sin(p["phi"])
    c = math.cos(p["phi"])
    q = 0.0 if free else 0.5 * air["rho"] * p["speed"] * p["speed"] * b["chord"]
    p["f_n"] = q * (cl * c + cd * s)
    p["f_t"] = q * (cl * s - cd * c)
    p["m_c"] = q * b["chord"] * cm
    p["status"] = status
    return status


@kernel
def stations_entry(ctl, rec, n):
    """Loads of n points; ctl is the address of a BATCH record, rec that of the points."""
    batch = view(ctl, 1, BATCH)[0]
    stations = view(batch["stations"], batch["n"], STATION)
    knots = view(batch["knots"], (batch["rows"], 7), F8)
    air = view(batch["air"], 1, AIR)[0]
    points = view(rec, n, POINT)
    worst = OK
    for k in range(n):
        status = station_loads(stations[points[k]["station"]], air, knots, points[k])
        worst = max(worst, status)
    return worst
