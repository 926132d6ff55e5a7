# SPDX-License-Identifier: Apache-2.0
"""Wind at the stations of the blades of a turning rotor: position, profile, yaw, tilt, tower."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.kernel import invoke
from pitchpoint.elements.rotor.air import SAMPLE, air_entry
from pitchpoint.elements.rotor.record import POINT, tower_rows
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.geometry.rotor.flow import RotorFlow
from pitchpoint.model.wind.steady import SteadyWind
from pitchpoint.system.wind import WindField

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
    c, s = math.cos(flow.yaw), math.sin(flow.yaw)
    if flow.shear_exponent == 0.0 and flow.tower is None:
        return np.broadcast_to(np.array([c, -s, 0.0]), (*height.shape, 3))
    if (height <= 0.0).any():
        low = f"{height.min():g} m"
        raise ModelError([Message("rotor.hub_height", "is the lowest station above ground", low, "> 0")])
    steady = SteadyWind(
        speed=1.0, hub_height=rotor.hub_height, exponent=flow.shear_exponent, direction=-flow.yaw
    )
    at = np.concatenate([position[..., :2], height[..., None]], axis=-1).reshape(-1, 3)
    found = np.empty_like(at)
    sample = np.zeros(1, SAMPLE)
    sample["wind"], sample["box"] = WindField(steady).record, -1
    if flow.tower is not None:
        sections = tower_rows(flow.tower)
        sample["tower"]["n"], sample["pool"] = len(sections), sections.ctypes.data
    sample["positions"], sample["velocities"] = at.ctypes.data, found.ctypes.data
    invoke(air_entry, 0, sample.ctypes.data, len(at))
    return found.reshape(position.shape)
