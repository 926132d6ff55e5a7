# SPDX-License-Identifier: Apache-2.0
"""Wind at the stations of the blades of a turning rotor: position, profile, yaw, tilt, tower."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.kernel import invoke
from pitchpoint.elements.rotor.record import POINT
from pitchpoint.elements.rotor.tower import TOWER_POINT, tower_entry
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.geometry.rotor.flow import RotorFlow

FloatArray = NDArray[np.float64]


def station_points(
    rotor: Rotor, flow: RotorFlow, operation: tuple[FloatArray, FloatArray, FloatArray], azimuth: FloatArray
) -> NDArray[Any]:
    """Station records with the velocities of the air relative to the blades.

    Parameters
    ----------
    rotor, flow
        Rotor and wind.
    operation
        Wind speeds [m/s], rotor speeds [rad/s] and pitch angles [rad], shape (n,).
    azimuth
        Azimuths of blades, 0 upwards, shape (n, m) or (1, m) [rad].

    Returns
    -------
    ndarray, shape (n, m, number of stations)
        Records of the type `elements.rotor.record.POINT`.
    """
    wind, speed, pitch = operation
    st, ct = math.sin(rotor.tilt), math.cos(rotor.tilt)
    axis, up, left = np.array([ct, 0.0, -st]), np.array([st, 0.0, ct]), np.array([0.0, 1.0, 0.0])
    cos, sin = np.cos(azimuth)[..., None, None], np.sin(azimuth)[..., None, None]
    outward, motion = cos * up - sin * left, -cos * left - sin * up  # azimuth 0: blade up
    slope = rotor.inclination[:, None]
    normal = np.cos(slope) * axis + np.sin(slope) * outward
    centre = (rotor.axial[:, None] - rotor.overhang) * axis + rotor.radius[:, None] * outward
    height = rotor.hub_height + rotor.overhang * axis[2] + centre[..., 2]
    field = wind_field(rotor, flow, centre, height)
    points = np.zeros((wind.size, azimuth.shape[1], slope.size), POINT)
    points["station"] = np.arange(slope.size)
    points["vx"] = wind[:, None, None] * (normal * field).sum(axis=-1)
    points["vy"] = speed[:, None, None] * rotor.radius - wind[:, None, None] * (motion * field).sum(axis=-1)
    points["pitch"] = pitch[:, None, None]
    direction = np.array([math.cos(flow.yaw), -math.sin(flow.yaw), 0.0])
    along = float(axis @ direction)
    across = direction - along * axis
    points["yaw"] = math.atan2(float(np.linalg.norm(across)), along)
    if np.linalg.norm(across) > 0.0:
        points["downwind"] = outward @ across / np.linalg.norm(across)
    return points


def wind_field(rotor: Rotor, flow: RotorFlow, position: FloatArray, height: FloatArray) -> FloatArray:
    """Wind over the wind speed at hub height, in axes of the nacelle: downwind, left, up.

    Parameters
    ----------
    rotor, flow
        Rotor, and wind profile, yaw and tower.
    position
        Points from the axis of the tower in these axes, shape (..., 3) [m].
    height
        Their heights above ground, shape (...) [m].

    Returns
    -------
    ndarray, shape (..., 3)
        Velocities over the wind speed.
    """
    profile = np.ones_like(height)
    if flow.shear_exponent != 0.0:
        if (height <= 0.0).any():
            low = f"{height.min():g} m"
            raise ModelError([Message("rotor.hub_height", "is the lowest station above ground", low, "> 0")])
        profile = (height / rotor.hub_height) ** flow.shear_exponent
    c, s = math.cos(flow.yaw), math.sin(flow.yaw)
    along, across = np.array([c, -s, 0.0]), np.array([s, c, 0.0])
    if flow.tower is None:
        return profile[..., None] * along
    rows = np.zeros(height.shape, TOWER_POINT)
    rows["x"], rows["y"] = position @ along, position @ across
    rows["radius"] = flow.tower.radius_at(height)
    invoke(tower_entry, 0, rows.ctypes.data, rows.size)
    return profile[..., None] * (rows["along"][..., None] * along + rows["across"][..., None] * across)
