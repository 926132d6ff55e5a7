# SPDX-License-Identifier: Apache-2.0
"""Velocity of the wind at points in space and time: profile, transient of IEC 61400-1, box of turbulence.

Kernels of elements call `wind_velocity` for one point or `wind_at` for several; neither allocates. The frame
has x downwind at direction 0, y to the left for a view downwind and z upward from the ground.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK, TABLE_RANGE

UNIFORM, POWER, LOGARITHMIC = 0, 1, 2
"""Profiles over the height."""
NO_GUST, OPERATING_GUST, RISE, VERTICAL_SHEAR, HORIZONTAL_SHEAR = 0, 1, 2, 3, 4
"""Shapes of the transient over time."""
EDGE = 1e-6
"""Distance beyond the edge of a grid that counts as on it, in grid spacings: single precision of files."""
LONGEST = 1e12
"""Time from the begin of a box, in samples, up to which the place between two samples is resolved."""

F8 = np.dtype("f8")
F4 = np.dtype("f4")

WIND = np.dtype(
    [
        ("speed", "f8"),  # at hub height [m/s]
        ("z_hub", "f8"),  # height of the hub [m]
        ("profile", "i8"),  # UNIFORM, POWER, LOGARITHMIC
        ("exponent", "f8"),  # of the power law
        ("roughness", "f8"),  # roughness length [m]
        ("level", "f8"),
        ("rise", "f8"),  # cosine and sine of the angle above the horizontal plane
        ("cos", "f8"),
        ("sin", "f8"),  # cosine and sine of the direction from x towards y
        ("veer", "f8"),  # change of direction with height [rad/m]
        ("gust", "i8"),  # shape of the transient
        ("start", "f8"),
        ("duration", "f8"),  # of the transient [s]
        ("amplitude", "f8"),  # of the transient [m/s]
        ("angle", "f8"),  # change of direction of the transient [rad]
        ("diameter", "f8"),  # of the rotor, for shears [m]
        ("box", "i8"),  # address of the velocities of the box, 0 without one
        ("n_t", "i8"),
        ("n_z", "i8"),
        ("n_y", "i8"),  # size of the box
        ("dt", "f8"),
        ("dz", "f8"),
        ("dy", "f8"),  # steps of the box [s], [m], [m]
        ("bottom", "f8"),  # height of the lowest row [m]
        ("right", "f8"),  # y of the first column [m]
        ("convection", "f8"),  # speed that carries the box [m/s]
        ("shift", "f8"),  # x of the samples at their own time [m]
        ("periodic", "i8"),  # 1: the box repeats
    ],
    align=True,
)
"""One wind."""

QUERY = np.dtype(
    [("wind", "i8"), ("positions", "i8"), ("velocities", "i8"), ("t", "f8"), ("point", "i8")], align=True
)
"""Arguments of `evaluate_wind`: addresses of wind, positions and velocities, time; result: point outside."""


@kernel
def mean_speed(w, z):
    """Speed of the profile at a height above ground [m/s]."""
    if w["profile"] == POWER:
        return w["speed"] * math.pow(z / w["z_hub"], w["exponent"])
    if w["profile"] == LOGARITHMIC:
        if z <= w["roughness"]:
            return 0.0
        return w["speed"] * math.log(z / w["roughness"]) / math.log(w["z_hub"] / w["roughness"])
    return w["speed"]


@kernel
def transient(w, across, z, t):
    """Change of the speed [m/s] and of the direction [rad] by the transient.

    Source: IEC 61400-1:2005, 6.3.2, equations 17 to 27.
    """
    shape = w["gust"]
    s = (t - w["start"]) / w["duration"] if shape != NO_GUST else 0.0
    if shape == NO_GUST or s <= 0.0:
        return 0.0, 0.0
    if shape == RISE:
        part = 0.5 * (1.0 - math.cos(math.pi * s)) if s < 1.0 else 1.0
        return w["amplitude"] * part, w["angle"] * part
    if s >= 1.0:
        return 0.0, 0.0
    part = 1.0 - math.cos(2.0 * math.pi * s)
    if shape == OPERATING_GUST:
        return -0.37 * w["amplitude"] * math.sin(3.0 * math.pi * s) * part, 0.0
    arm = z - w["z_hub"] if shape == VERTICAL_SHEAR else across
    return arm / w["diameter"] * w["amplitude"] * part, 0.0


@kernel
def cell(at, n):
    """Lower index, share of the upper one, and whether the place is within a grid of n points."""
    if n == 1:
        return 0, 0.0, 1
    inside = 1 if -EDGE <= at <= n - 1 + EDGE else 0
    at = min(max(at, 0.0), n - 1.0)
    k = min(int(at), n - 2)
    return k, at - k, inside


@kernel
def box_velocity(w, along, across, z, t):
    """Velocity of the box in its own axes and status: linear in time, y and z.

    Below the lowest row the velocities are those of that row; beyond the other edges the status is
    TABLE_RANGE.
    """
    n_t = w["n_t"]
    box = view(w["box"], (n_t, w["n_z"], w["n_y"], 3), F4)
    step = (t - (along - w["shift"]) / w["convection"]) / w["dt"]
    if not abs(step) < LONGEST:
        return 0.0, 0.0, 0.0, TABLE_RANGE
    if w["periodic"]:
        step -= n_t * math.floor(step / n_t)
        step = step if 0.0 <= step < n_t else 0.0
        i = int(step)
        e = step - i
        i_next = i + 1 if i + 1 < n_t else 0
        inside = 1
    else:
        i, e, inside = cell(step, n_t)
        i_next = min(i + 1, n_t - 1)
    j, f, inside_y = cell((across - w["right"]) / w["dy"], w["n_y"])
    k, g, inside_z = cell((max(z, w["bottom"]) - w["bottom"]) / w["dz"], w["n_z"])
    j_next = min(j + 1, w["n_y"] - 1)
    k_next = min(k + 1, w["n_z"] - 1)
    u = 0.0
    v = 0.0
    up = 0.0
    for corner in range(4):
        a = i_next if corner & 1 else i
        b = k_next if corner & 2 else k
        share = (e if corner & 1 else 1.0 - e) * (g if corner & 2 else 1.0 - g)
        left, right = share * f, share * (1.0 - f)
        u += right * box[a, b, j, 0] + left * box[a, b, j_next, 0]
        v += right * box[a, b, j, 1] + left * box[a, b, j_next, 1]
        up += right * box[a, b, j, 2] + left * box[a, b, j_next, 2]
    return u, v, up, OK if inside and inside_y and inside_z else TABLE_RANGE


@kernel
def wind_velocity(w, x, y, z, t):
    """Velocity along x, y and z [m/s] at a point [m] and a time [s], and status.

    The velocity is zero at and below the ground.
    """
    if not math.isfinite(x + y + z + t):
        return 0.0, 0.0, 0.0, NOT_FINITE
    if z <= 0.0:
        return 0.0, 0.0, 0.0, OK
    cos, sin = w["cos"], w["sin"]
    along = cos * x + sin * y
    across = cos * y - sin * x
    more, turn = transient(w, across, z, t)
    speed = mean_speed(w, z) + more
    turn += w["veer"] * (z - w["z_hub"])
    u = speed * w["level"]
    v = 0.0
    if turn != 0.0:
        u, v = u * math.cos(turn), u * math.sin(turn)
    up = speed * w["rise"]
    status = OK
    if w["box"] != 0:
        du, dv, dup, status = box_velocity(w, along, across, z, t)
        u += du
        v += dv
        up += dup
    return cos * u - sin * v, sin * u + cos * v, up, status


@kernel
def wind_at(w, positions, t, velocities):
    """Velocities [m/s] at positions [m], both of shape (n, 3), at a time [s]; status and number of the point.

    The evaluation ends at the first point outside the box.
    """
    for k in range(positions.shape[0]):
        u, v, up, status = wind_velocity(w, positions[k, 0], positions[k, 1], positions[k, 2], t)
        if status != OK:
            return status, k
        velocities[k, 0] = u
        velocities[k, 1] = v
        velocities[k, 2] = up
    return OK, -1


@kernel
def evaluate_wind(_, where, n):
    """Entry point: velocities at n positions, from a `QUERY`."""
    q = view(where, 1, QUERY)
    wind = view(q[0]["wind"], 1, WIND)
    positions = view(q[0]["positions"], (n, 3), F8)
    velocities = view(q[0]["velocities"], (n, 3), F8)
    status, point = wind_at(wind[0], positions, q[0]["t"], velocities)
    q[0]["point"] = point
    return status
