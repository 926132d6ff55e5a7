# SPDX-License-Identifier: Apache-2.0
"""Steady loads and performance of a rotor by blade-element momentum theory."""

from __future__ import annotations

import time
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import Message, ModelError, SolverError
from pitchpoint.core.kernel import invoke
from pitchpoint.core.provenance import content_hash, provenance
from pitchpoint.core.status import OK
from pitchpoint.elements.rotor.loads import stations_entry
from pitchpoint.elements.rotor.record import BATCH, POINT, air_record, polar_rows, station_records
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.geometry.rotor.flow import RotorFlow
from pitchpoint.solvers.rotor_wind import station_points

if TYPE_CHECKING:
    import xarray as xr

FloatArray = NDArray[np.float64]


def solve_rotor_performance(
    rotor: Rotor,
    wind_speed: ArrayLike,
    rotor_speed: ArrayLike | None = None,
    pitch: ArrayLike = 0.0,
    *,
    tip_speed_ratio: ArrayLike | None = None,
    flow: RotorFlow | None = None,
) -> xr.Dataset:
    """Thrust, torque, power and distributed loads of a rotor in steady wind.

    One equation for the inflow angle of each blade station, with a root that is always bracketed (Ning 2014);
    tip and hub loss by Prandtl, heavily loaded rotors by Buhl, skewed wake by Pitt and Peters. Loads are
    averaged over one revolution.

    Parameters
    ----------
    rotor
        The rotor.
    wind_speed
        Wind speeds at hub height, number or shape (n,) [m/s].
    rotor_speed
        Rotor speeds, number or shape (n,) [rad/s].
    pitch
        Pitch angles, leading edge upwind positive, number or shape (n,) [rad].
    tip_speed_ratio
        Instead of `rotor_speed`: Ω R / U with the tip radius R and the wind speed at hub height.
    flow
        Air and options.

    Returns
    -------
    xarray.Dataset
        Over `point`: `rotor_thrust` along the axis, downwind positive [N], `rotor_torque` [N m],
        `rotor_power` [W], `thrust_coefficient` and `power_coefficient` with ½ ρ U² π R² and U,
        `root_flap_moment` of one blade about its root, bending it downwind [N m]. Over `point` and `radius`,
        means over the azimuth: `normal_force` and `tangential_force` per length of the blade [N/m],
        `pitching_moment` per length [N], `axial_induction`, `tangential_induction`, `inflow_angle` and
        `angle_of_attack` [rad], `relative_speed` [m/s], `loss_factor`.

    Raises
    ------
    ModelError
        If values are out of range.
    SolverError
        If the balance of momentum of a station has no solution; `partial` contains the result without
        induction at these stations.

    Examples
    --------
    Blade of constant angle of attack in the middle of the span, loaded to a = 1/3: C_P is just below Betz'
    limit 16/27 = 0.593.

    >>> import numpy as np
    >>> from pitchpoint.geometry.rotor.blade import Blade, Rotor
    >>> from pitchpoint.geometry.rotor.polar import Polar
    >>> plate = Polar(alpha=np.radians([-180, -90, -20, 0, 20, 90, 180]),
    ...               lift=[0, 0, -2, 0, 2, 0, 0], drag=np.zeros(7))
    >>> span = np.linspace(0.0, 47.5, 200)
    >>> ratio = (2.5 + span) / 50 * 12  # local speed ratio
    >>> phi = 2 / 3 * np.arctan(1 / ratio)  # optimum rotor of Glauert
    >>> lift = plate.at(np.radians(5))[0]
    >>> chord = 8 * np.pi * (2.5 + span) / (3 * lift) * (1 - np.cos(phi))
    >>> blade = Blade(span=span, chord=chord, twist=phi - np.radians(5), polars=[plate],
    ...               polar_index=np.zeros(200, int))
    >>> rotor = Rotor(blade=blade, hub_radius=2.5)
    >>> free = RotorFlow(tip_loss=False, hub_loss=False, sectors=1)
    >>> found = solve_rotor_performance(rotor, 8.0, tip_speed_ratio=12.0, flow=free)
    >>> round(float(found.power_coefficient[0]), 4)
    0.5863
    """
    begun = time.perf_counter()
    flow = flow or RotorFlow()
    operation = operating_points(rotor, wind_speed, rotor_speed, pitch, tip_speed_ratio)
    azimuth = 2.0 * np.pi * np.arange(flow.sectors)[None] / flow.sectors
    points = station_points(rotor, flow, operation, azimuth)
    status = evaluate_stations(rotor, flow, points)
    data = _dataset(rotor, flow, operation, points)
    data.attrs |= provenance(
        model_hash=content_hash(rotor),
        solver="rotor_performance",
        options=asdict(flow),
        status=status,
        wall_s=time.perf_counter() - begun,
    )
    if status != OK:
        count = int((points["status"] != OK).sum())
        sentence = f"the balance of momentum has no solution at {count} of {points.size} stations"
        raise SolverError(f"{sentence}; check the polars for jumps", status, data)
    return data


def evaluate_stations(rotor: Rotor, flow: RotorFlow, points: NDArray[Any]) -> int:
    """Fill the results of station records in place.

    Parameters
    ----------
    rotor, flow
        Rotor and options.
    points
        Records of the type `elements.rotor.record.POINT`, contiguous, any shape.

    Returns
    -------
    int
        Worst status.
    """
    batch = StationBatch(rotor, flow)
    return invoke(stations_entry, batch.at, points.ctypes.data, points.size)


class StationBatch:
    """Records of the stations, polars and air of a rotor, for calls of kernels.

    Parameters
    ----------
    rotor, flow
        Rotor and options.
    stall
        Whether the stall of sections with lift is dynamic.
    """

    def __init__(self, rotor: Rotor, flow: RotorFlow, stall: bool = False) -> None:
        self.stations = station_records(rotor, flow.tip_loss, flow.hub_loss, stall)
        self.knots = polar_rows(rotor)
        self.air = air = air_record(flow)
        self.record = batch = np.zeros(1, BATCH)
        batch["stations"], batch["n"] = self.stations.ctypes.data, self.stations.size
        batch["knots"], batch["rows"] = self.knots.ctypes.data, len(self.knots)
        batch["air"] = air.ctypes.data

    @property
    def at(self) -> int:
        """Address of the record; valid while this object exists."""
        return int(self.record.ctypes.data)


def operating_points(
    rotor: Rotor,
    wind_speed: ArrayLike,
    rotor_speed: ArrayLike | None,
    pitch: ArrayLike,
    tip_speed_ratio: ArrayLike | None,
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Wind speeds, rotor speeds and pitch angles, all of one shape (n,).

    Parameters
    ----------
    rotor, wind_speed, rotor_speed, pitch, tip_speed_ratio
        As for `solve_rotor_performance`.
    """
    if (rotor_speed is None) == (tip_speed_ratio is None):
        raise ModelError([Message("operation", "needs a rotor_speed or a tip_speed_ratio, and not both")])
    wind = np.atleast_1d(np.asarray(wind_speed, float))
    if rotor_speed is None:
        speed = np.asarray(tip_speed_ratio, float) * wind / rotor.tip_radius
    else:
        speed = np.asarray(rotor_speed, float)
    try:
        wind, speed, angle = np.broadcast_arrays(wind, np.atleast_1d(speed), np.asarray(pitch, float))
    except ValueError:
        shapes = ", ".join(str(np.shape(x)) for x in (wind_speed, speed, pitch))
        raise ModelError(
            [Message("operation", "are shapes of wind, speed and pitch", shapes, "equal, or single numbers")]
        ) from None
    problems = [
        Message(f"operation.{name}", "is not finite", remedy="give numbers")
        for name, values in (("wind_speed", wind), ("rotor_speed", speed), ("pitch", angle))
        if not np.isfinite(values).all()
    ]
    if not (wind > 0.0).all():
        problems.append(Message("operation.wind_speed", "is out of range", f"{wind.min():g} m/s", "> 0"))
    if problems:
        raise ModelError(problems)
    return wind, speed, angle


def along_blade(rotor: Rotor, values: FloatArray) -> FloatArray:
    """Integral of loads per length over the length of the blade.

    Parameters
    ----------
    rotor
        The rotor.
    values
        Loads per length at the stations, shape (..., n).
    """
    z = rotor.blade.span
    length = np.r_[
        0.0,
        np.cumsum(np.diff(z) / np.cos(0.5 * (rotor.blade.curve_angle[1:] + rotor.blade.curve_angle[:-1]))),
    ]
    return np.trapezoid(values, length, axis=-1)


def _dataset(
    rotor: Rotor, flow: RotorFlow, operation: tuple[FloatArray, ...], points: NDArray[Any]
) -> xr.Dataset:
    """Totals and means over the azimuth."""
    import xarray as xr

    wind, speed, pitch = operation
    mean = {
        name: points[name].mean(axis=1) for name in POINT.names or () if name not in ("station", "status")
    }
    f_n, f_t = mean["f_n"], mean["f_t"]
    axial, radial = f_n * np.cos(rotor.inclination), f_n * np.sin(rotor.inclination)
    thrust = rotor.blades * along_blade(rotor, axial)
    torque = rotor.blades * along_blade(rotor, f_t * rotor.radius)
    arm = rotor.radius - rotor.root_radius, rotor.axial - rotor.axial[0]
    flap = along_blade(rotor, axial * arm[0] - radial * arm[1])
    pressure = 0.5 * flow.density * wind**2 * rotor.area
    totals = {
        "rotor_thrust": (thrust, "N", "thrust along the rotor axis"),
        "rotor_torque": (torque, "N m", "torque about the rotor axis"),
        "rotor_power": (torque * speed, "W", "power of the rotor"),
        "thrust_coefficient": (thrust / pressure, "1", "thrust coefficient"),
        "power_coefficient": (torque * speed / (pressure * wind), "1", "power coefficient"),
        "root_flap_moment": (flap, "N m", "flapwise moment at the root of a blade"),
    }
    fields = {
        "normal_force": ("f_n", "N/m", "force normal to the blade per length"),
        "tangential_force": ("f_t", "N/m", "force in the direction of rotation per length"),
        "pitching_moment": ("m_c", "N", "pitching moment per length"),
        "axial_induction": ("a", "1", "axial induction factor"),
        "tangential_induction": ("a_prime", "1", "tangential induction factor"),
        "inflow_angle": ("phi", "rad", "angle of the relative wind from the rotor plane"),
        "angle_of_attack": ("alpha", "rad", "angle of attack"),
        "relative_speed": ("speed", "m/s", "speed of the air relative to the blade"),
        "loss_factor": ("loss", "1", "factor of tip and hub loss"),
    }
    data: dict[str, Any] = {
        name: (("point",), values, {"units": unit, "long_name": text})
        for name, (values, unit, text) in totals.items()
    }
    for name, (key, unit, text) in fields.items():
        data[name] = (("point", "radius"), mean[key], {"units": unit, "long_name": text})
    ratio = speed * rotor.tip_radius / wind
    coords = {
        "radius": (("radius",), rotor.radius, {"units": "m", "long_name": "distance from the rotor axis"}),
        "wind_speed": (("point",), wind, {"units": "m/s", "long_name": "wind speed at hub height"}),
        "rotor_speed": (("point",), speed, {"units": "rad/s", "long_name": "rotor speed"}),
        "pitch": (("point",), pitch, {"units": "rad", "long_name": "pitch angle"}),
        "tip_speed_ratio": (("point",), ratio, {"units": "1", "long_name": "tip-speed ratio"}),
    }
    return xr.Dataset(data, coords=coords)
