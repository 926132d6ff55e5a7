# SPDX-License-Identifier: Apache-2.0
"""Record of a blade station on moving bodies, its place and axes, and the air relative to it.

A station follows two bodies, the ends of a beam, or one: x = N_i r_i + N_j r_j + S_i a_i + S_j a_j, where N
and the vectors a contain the shape functions of the beam (Hermite) and the offset of the aerodynamic centre.
Its span and chord directions are s = S_i s_i + S_j s_j and c = S_i c_i + S_j c_j. Forces act on both bodies
through the same functions, so that the power of the air is that of the loads at the moving station.

The axes of the station follow from the axis n of the hub: t in the direction of rotation, o outward, and in
the plane of n and o the normal of the blade, downwind. The frames are those of `solvers.rotor_wind`.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.rotor.air import WIND_FIELDS, undisturbed, wind_of
from pitchpoint.elements.rotor.record import AIR, COLUMNS, POINT, STATION
from pitchpoint.elements.wrench import angular_velocity, origin, velocity
from pitchpoint.multibody.channels import F8
from pitchpoint.multibody.vectors import add, cross, dot, into_world, less, row, set_row, times, triple

R, V, S, C, N, T, OUT, E, U, RHO = range(10)
"""Rows of the vectors of a station: place, velocity, span, chord, axis of the hub, direction of rotation,
outward, normal of the blade, air relative to the station, place from the centre of the hub."""

STATES = ("l1", "l2", "l3", "l4", "l5")
"""Fields of the hidden bodies of the states z_n, w_n, z_t, w_t and f (`unsteady`)."""
BODIES = ("i", "j", "k", *STATES)

PLACE: list[tuple[Any, ...]] = [
    ("share_i", "f8"),  # shares of both origins in the place, share_i + share_j = 1
    ("share_j", "f8"),
    ("w_i", "f8"),  # shares of both rotations, w_i + w_j = 1
    ("w_j", "f8"),
    ("a_i", "f8", 3),  # arms, spans and chords in the axes of the bodies
    ("a_j", "f8", 3),
    ("s_i", "f8", 3),
    ("s_j", "f8", 3),
    ("c_i", "f8", 3),
    ("c_j", "f8", 3),
    ("p_k", "f8", 3),  # centre of the rotor and its axis, downwind, in the axes of the hub
    ("axis", "f8", 3),
]

RECORD = np.dtype(
    [(name, "i8") for name in ("i", "j", "ii", "ij", "ji", "jj", "k", "ik", "ki", "jk", "kj", "kk", *STATES)]
    + [("pairs", "i8", (len(BODIES), len(BODIES)))]
    + PLACE
    + [
        ("inflow", "i8"),  # 1: the induced velocities are states
        ("stall", "i8"),  # 1: the point of separation is a state, if the section has lift
        ("first", "i8"),  # 1: first station of a rotor; it has the sums of the rotor
        ("length", "f8"),  # length of the blade of this station [m]
        ("hold", "f8"),  # time over which loads are extrapolated in a loop of fixed steps [s]; 0: never
        ("blade", STATION),
        ("air", AIR),
    ]
    + WIND_FIELDS
    + [
        ("knots", "i8"),  # offset of the rows of the polars in the pool, and their number
        ("rows", "i8"),
        # origin of the extrapolation: its time (NaN: none), inputs and states, loads and rates; the
        # derivatives are in slopes and by_rate
        ("since", "f8"),
        ("origin", "f8", 10),
        ("loads", "f8", 8),
        # scratch: written and read within one call
        ("point", POINT),
        ("x", "f8", (10, 3)),
        ("arm", "f8", (3, 3)),  # arms of bodies i, j and hub in world axes
        ("gradient", "f8", (3, 3)),  # of the wind at the station, row per component
        ("hub_gradient", "f8", (3, 3)),  # and at the centre of the rotor
        ("state", "f8", 5),  # states and their rates
        ("rates", "f8", 5),
        (
            "steady",
            "f8",
            (2, 10),
        ),  # derivatives: of velocities with steady induction, velocities, loads, rates
        ("flow", "f8", (2, 10)),
        ("slopes", "f8", (3, 10)),
        ("by_rate", "f8", (5, 10)),
        ("lift", "f8", 2),
        ("inputs", "f8", 5),  # changes of the inputs for one motion
        ("radius", "f8"),
        ("so", "f8"),  # components of the span along o and n, and their length
        ("sn", "f8"),
        ("size", "f8"),
        ("hub_wind", "f8", 3),  # air relative to the centre of the rotor
        ("aside", "f8", 3),  # its part across the axis, the length of this part, and its angle with the axis
        ("skewness", "f8"),
        ("yaw", "f8"),
        ("sums", "f8", 3),  # thrust, torque and power
        ("out", "i8"),
    ],
    align=True,
)


@kernel
def knots_of(b):
    """Rows of the polars."""
    return view(b["pool"] + 8 * b["knots"], (b["rows"], COLUMNS), F8)


@kernel
def place(b, f, g, h):
    """Set place, velocity and axes of a station."""
    arm_i = into_world(f["S"], triple(b["a_i"], 0))
    arm_j = into_world(g["S"], triple(b["a_j"], 0))
    arm_k = into_world(h["S"], triple(b["p_k"], 0))
    ni = b["share_i"]
    nj = b["share_j"]
    at = add(add(times(ni, origin(f)), times(nj, origin(g))), add(arm_i, arm_j))
    move = add(times(ni, velocity(f)), times(nj, velocity(g)))
    move = add(move, add(cross(angular_velocity(f), arm_i), cross(angular_velocity(g), arm_j)))
    span = add(into_world(f["S"], triple(b["s_i"], 0)), into_world(g["S"], triple(b["s_j"], 0)))
    chord = add(into_world(f["S"], triple(b["c_i"], 0)), into_world(g["S"], triple(b["c_j"], 0)))
    n = into_world(h["S"], triple(b["axis"], 0))
    rho = less(at, add(origin(h), arm_k))
    m = cross(n, rho)
    radius = math.sqrt(dot(m, m))
    t = times(1.0 / radius, m)
    o = cross(t, n)
    so = dot(span, o)
    sn = dot(span, n)
    size = math.sqrt(so * so + sn * sn)
    x = b["x"]
    set_row(x, R, at)
    set_row(x, V, move)
    set_row(x, S, span)
    set_row(x, C, chord)
    set_row(x, N, n)
    set_row(x, T, t)
    set_row(x, OUT, o)
    set_row(x, E, times(1.0 / size, less(times(so, n), times(sn, o))))
    set_row(x, RHO, rho)
    set_row(b["arm"], 0, arm_i)
    set_row(b["arm"], 1, arm_j)
    set_row(b["arm"], 2, arm_k)
    b["radius"] = radius
    b["so"] = so
    b["sn"] = sn
    b["size"] = size


@kernel
def set_gradient(b, at, t, tower, G):
    """Write the gradient of the wind at a point to G by central differences; status."""
    h = 1e-3
    for c in range(3):
        step = (h if c == 0 else 0.0, h if c == 1 else 0.0, h if c == 2 else 0.0)
        for side in range(2):
            there = add(at, step) if side == 0 else less(at, step)
            if tower != 0:
                u, v, up, status = wind_of(b, there, t)
            else:
                u, v, up, status = undisturbed(b, there, t)
            if status != OK:
                return status
            share = (0.5 if side == 0 else -0.5) / h
            if side == 0:
                G[0, c] = 0.0
                G[1, c] = 0.0
                G[2, c] = 0.0
            G[0, c] += share * u
            G[1, c] += share * v
            G[2, c] += share * up
    return OK


@kernel
def hub_inflow(b, h, t, exact):
    """Set the air relative to the centre of the rotor, and with `exact` the gradient there; status."""
    arm = into_world(h["S"], triple(b["p_k"], 0))
    at = add(origin(h), arm)
    u, v, up, status = undisturbed(b, at, t)
    if status == OK and exact != 0:
        status = set_gradient(b, at, t, 0, b["hub_gradient"])
    move = add(velocity(h), cross(angular_velocity(h), arm))
    inflow = less((u, v, up), move)
    along, across, size = across_rotor(into_world(h["S"], triple(b["axis"], 0)), inflow)
    for r in range(3):
        b["hub_wind"][r] = inflow[r]
        b["aside"][r] = across[r]
    b["skewness"] = size
    b["yaw"] = math.atan2(size, along)
    return status


@kernel
def across_rotor(n, inflow):
    """Component of the air relative to the hub along the axis n, the rest, and the length of the rest."""
    along = dot(n, inflow)
    across = less(inflow, times(along, n))
    return along, across, math.sqrt(dot(across, across))


@kernel
def meet_air(b, head, t):
    """Set the velocities of the air relative to a station; `head` has those of the hub. Returns a status."""
    x = b["x"]
    u, v, up, status = wind_of(b, row(x, R), t)
    if status != OK:
        return status
    flow = less((u, v, up), row(x, V))
    set_row(x, U, flow)
    p = b["point"]
    p["vx"] = dot(row(x, E), flow)
    p["vy"] = -dot(row(x, T), flow)
    chord = row(x, C)
    theta = math.atan2(-dot(chord, row(x, E)), dot(chord, row(x, T)))
    p["pitch"] = theta - b["blade"]["twist"]
    p["yaw"] = head["yaw"]
    size = head["skewness"]
    p["downwind"] = dot(row(x, OUT), triple(head["aside"], 0)) / size if size > 0.0 else 1.0
    return OK
