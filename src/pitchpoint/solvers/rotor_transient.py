# SPDX-License-Identifier: Apache-2.0
"""Loads of a rigid rotor over time with dynamic inflow and dynamic stall."""

from __future__ import annotations

import time as clock
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import Message, ModelError, SolverError
from pitchpoint.core.kernel import invoke, kernel, view
from pitchpoint.core.provenance import content_hash, provenance
from pitchpoint.core.status import OK
from pitchpoint.elements.rotor.loads import set_angles, set_coefficients, set_forces, steady_inflow
from pitchpoint.elements.rotor.polar import coefficient
from pitchpoint.elements.rotor.record import AIR, BATCH, COLUMNS, POINT, STATION
from pitchpoint.elements.rotor.unsteady import (
    SHARE,
    advance_inflow,
    advance_separation,
    attached_lift,
    inflow_times,
    stalling_lift,
)
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.geometry.rotor.flow import RotorFlow
from pitchpoint.multibody.channels import F8
from pitchpoint.solvers.rotor_performance import StationBatch, along_blade, operating_points
from pitchpoint.solvers.rotor_wind import station_points

if TYPE_CHECKING:
    import xarray as xr

FloatArray = NDArray[np.float64]

MARCH = np.dtype(
    [("batch", "i8"), ("times", "i8"), ("states", "i8"), ("each", "i8"), ("inflow", "i8")], align=True
)
STATES = 8
"""States of a station: z and w of the axial and tangential induction, f, and the last steady values."""


@kernel
def advance_station(b, air, knots, p, x, h, inflow):
    """Advance the states x of a station by h (negative: steady values), and write its loads; a status."""
    ux, uy, status = steady_inflow(b, air, knots, p)
    steady_n = p["vx"] - ux
    steady_t = uy - p["vy"]
    if inflow != 0 and p["loss"] > 0.0:
        if h < 0.0:
            x[0] = (1.0 - SHARE) * steady_n
            x[1] = steady_n
            x[2] = (1.0 - SHARE) * steady_t
            x[3] = steady_t
        else:
            speed = max(abs(p["vx"]), 0.1)
            times = inflow_times(steady_n / speed, b["share"], b["radius"], speed)
            x[0], x[1] = advance_inflow(x[0], x[1], 0.5 * (x[5] + steady_n), times, h)
            x[2], x[3] = advance_inflow(x[2], x[3], 0.5 * (x[6] + steady_t), times, h)
        ux = p["vx"] - x[1]
        uy = p["vy"] + x[3]
        x[5] = steady_n
        x[6] = steady_t
    set_angles(b, p, ux, uy)
    i = set_coefficients(b, knots, p)
    if b["slope"] > 0.0:
        steady_f, _ = coefficient(knots, i, 7, p["alpha"])
        if h < 0.0:
            x[4] = steady_f
        else:
            x[4] = advance_separation(x[4], 0.5 * (x[7] + steady_f), b["chord"], p["speed"], h)
        x[7] = steady_f
        attached = attached_lift(p["alpha"], b["alpha_0"], b["slope"])
        separated, _ = coefficient(knots, i, 9, p["alpha"])
        p["lift"] = stalling_lift(p["lift"], steady_f, attached, separated, x[4])
    set_forces(b, air, p)
    p["status"] = status
    return status


@kernel
def march_entry(ctl, rec, n):
    """Loads at n times; ctl is the address of a MARCH record, rec that of the points, each time in turn."""
    march = view(ctl, 1, MARCH)[0]
    batch = view(march["batch"], 1, BATCH)[0]
    stations = view(batch["stations"], batch["n"], STATION)
    knots = view(batch["knots"], (batch["rows"], COLUMNS), F8)
    air = view(batch["air"], 1, AIR)[0]
    each = march["each"]
    times = view(march["times"], n, F8)
    states = view(march["states"], (each, STATES), F8)
    points = view(rec, n * each, POINT)
    worst = OK
    for t in range(n):
        h = times[t] - times[t - 1] if t > 0 else -1.0
        for k in range(each):
            p = points[t * each + k]
            status = advance_station(stations[p["station"]], air, knots, p, states[k], h, march["inflow"])
            worst = max(worst, status)
    return worst


def solve_rotor_transient(
    rotor: Rotor,
    time: ArrayLike,
    wind_speed: ArrayLike,
    rotor_speed: ArrayLike,
    pitch: ArrayLike = 0.0,
    *,
    flow: RotorFlow | None = None,
    dynamic_inflow: bool = True,
    dynamic_stall: bool = True,
) -> xr.Dataset:
    """Thrust, torque and power of a rigid rotor over time, with given wind, speed and pitch.

    The induced velocity follows its steady value by two filters in series (Øye 1990), the point of
    separation of the airfoils by one (Øye 1991); both are integrated exactly for the mean steady value of a
    step. The run starts from steady induction and separation. `flow.sectors` has no effect: every blade has
    its azimuth.

    Parameters
    ----------
    rotor
        The rotor; blade 1 is up at the first time.
    time
        Times, increasing, shape (n,) [s].
    wind_speed
        Wind speeds at hub height, number or shape (n,) [m/s].
    rotor_speed
        Rotor speeds, number or shape (n,) [rad/s].
    pitch
        Pitch angles, number or shape (n,) [rad].
    flow
        Air and options.
    dynamic_inflow, dynamic_stall
        Whether induction and stall have states; without both, the loads are steady at each time.

    Returns
    -------
    xarray.Dataset
        Over `time`: `rotor_thrust` [N], `rotor_torque` [N m], `rotor_power` [W]; over `time` and `blade`:
        `azimuth` [rad] and `root_flap_moment` [N m].

    Raises
    ------
    ModelError
        If values are out of range.
    SolverError
        If the balance of momentum of a station has no solution.

    Examples
    --------
    Without lift there is no induction: thrust is the drag of both blades, 2 · ½ ρ V² c_d c L.

    >>> from pitchpoint.geometry.rotor.blade import Blade
    >>> from pitchpoint.geometry.rotor.polar import Polar
    >>> plate = Polar(alpha=[-3.14159265359, 0.0, 3.14159265359], lift=[0, 0, 0], drag=[0.1, 0.1, 0.1])
    >>> blade = Blade(span=[0, 10], chord=[1, 1], twist=[0, 0], polars=[plate], polar_index=[0, 0])
    >>> rotor = Rotor(blade=blade, blades=2, hub_radius=1.0)
    >>> free = RotorFlow(axial_induction=False, tangential_induction=False, tip_loss=False, hub_loss=False)
    >>> solve_rotor_transient(rotor, [0.0, 1.0], 10.0, 0.0, flow=free).rotor_thrust.values.round(6).tolist()
    [122.5, 122.5]
    """
    begun = clock.perf_counter()
    flow = flow or RotorFlow()
    instants = np.asarray(time, float)
    if instants.ndim != 1 or instants.size < 2 or not (np.diff(instants) > 0.0).all():
        raise ModelError([Message("time", "does not increase", limit="at least two increasing times")])
    given = (np.broadcast_to(np.asarray(x, float), instants.shape) for x in (wind_speed, rotor_speed))
    try:
        wind, speed = given
        operation = operating_points(rotor, wind, speed, pitch, None)
    except ValueError as error:
        if isinstance(error, ModelError):
            raise
        raise ModelError(
            [Message("operation", "has not one value per time", limit=str(instants.size))]
        ) from None
    if operation[0].size != instants.size:
        raise ModelError([Message("pitch", "has not one value per time", limit=str(instants.size))])
    turned = np.r_[0.0, np.cumsum(np.diff(instants) * 0.5 * (speed[1:] + speed[:-1]))]
    azimuth = turned[:, None] + 2.0 * np.pi * np.arange(rotor.blades) / rotor.blades
    points = station_points(rotor, flow, operation, azimuth)
    status = _march(rotor, flow, points, instants, dynamic_inflow, dynamic_stall)
    data = _dataset(rotor, points, instants, operation[1], azimuth)
    options = {**asdict(flow), "dynamic_inflow": dynamic_inflow, "dynamic_stall": dynamic_stall}
    data.attrs |= provenance(
        model_hash=content_hash(rotor),
        solver="rotor_transient",
        options=options,
        status=status,
        wall_s=clock.perf_counter() - begun,
    )
    if status != OK:
        raise SolverError("the balance of momentum of a blade station has no solution", status, data)
    return data


def _march(
    rotor: Rotor, flow: RotorFlow, points: NDArray[Any], instants: FloatArray, inflow: bool, stall: bool
) -> int:
    """Fill the results of the records of all times."""
    batch = StationBatch(rotor, flow, stall)
    each = points[0].size
    states = np.zeros((each, STATES))
    march = np.zeros(1, MARCH)
    march["batch"], march["times"], march["states"] = batch.at, instants.ctypes.data, states.ctypes.data
    march["each"], march["inflow"] = each, inflow
    return invoke(march_entry, march.ctypes.data, points.ctypes.data, len(points))


def _dataset(
    rotor: Rotor, points: NDArray[Any], instants: FloatArray, speed: FloatArray, azimuth: FloatArray
) -> xr.Dataset:
    """Totals of all blades."""
    import xarray as xr

    axial = points["f_n"] * np.cos(rotor.inclination)
    radial = points["f_n"] * np.sin(rotor.inclination)
    arm = rotor.radius - rotor.root_radius, rotor.axial - rotor.axial[0]
    thrust = along_blade(rotor, axial).sum(axis=1)
    torque = along_blade(rotor, points["f_t"] * rotor.radius).sum(axis=1)
    flap = along_blade(rotor, axial * arm[0] - radial * arm[1])
    each = ("time", "blade")
    data = {
        "rotor_thrust": (("time",), thrust, {"units": "N", "long_name": "thrust along the rotor axis"}),
        "rotor_torque": (("time",), torque, {"units": "N m", "long_name": "torque about the rotor axis"}),
        "rotor_power": (("time",), torque * speed, {"units": "W", "long_name": "power of the rotor"}),
        "azimuth": (each, azimuth, {"units": "rad", "long_name": "azimuth of a blade, 0 upwards"}),
        "root_flap_moment": (each, flap, {"units": "N m", "long_name": "flapwise moment at the blade root"}),
    }
    coords = {"time": (("time",), instants, {"units": "s", "long_name": "time"})}
    return xr.Dataset(data, coords=coords)
