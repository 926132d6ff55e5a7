# SPDX-License-Identifier: Apache-2.0
"""`solve_wind_campbell`: natural frequencies and damping of a turbine over its operating points."""

from __future__ import annotations

import math
import time
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.core.errors import SolverError, join_notes
from pitchpoint.core.progress import Progress, as_steps, silent
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.core.units import format_quantity
from pitchpoint.solvers.campbell import Campbell, follow_modes
from pitchpoint.solvers.linear_system import Linearised, linearise, rates_of
from pitchpoint.solvers.modal import FREQUENCY, RATIO
from pitchpoint.solvers.over_wind import OverWind
from pitchpoint.solvers.speed_drift import UNBALANCED
from pitchpoint.system.system import System

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.scenario import Scenario

UNSETTLED = "has no steady state"
"""Words of the notes on integrators at the start of a scenario."""
MULTIPLES = (1, 2, 3)
"""Multiples of the number of blades among the orders, besides 1P."""


def solve_wind_campbell(
    system: System,
    wind: ArrayLike,
    scenario: Scenario | str | None = None,
    *,
    count: int | None = None,
    progress: Progress = silent,
    linear: Linearised | None = None,
) -> xr.Dataset:
    """Natural frequencies and damping of a wind turbine over the wind speed, at its operating points.

    At every wind speed the speed of the rotor balances the torques, and controllers are in equilibrium, such
    as the pitch above the rated speed. Modes are in multi-blade coordinates: frequencies are those in axes
    that do not turn.

    Parameters
    ----------
    system
        The compiled model, with one rotor in a steady wind.
    wind
        Wind speeds at the hub [m/s], shape (n,), ascending; profile and direction are those of the scenario.
    scenario
        Gives wind and loads; default: the one the system was compiled with.
    count
        Number of modes, the lowest at rest. Default: all of up to 24, otherwise the lowest 16.
    progress
        Called after every wind speed.
    linear
        Result of `linearise`, if already computed.

    Returns
    -------
    xarray.Dataset
        Over `wind_speed`: rotor_speed [rad/s] and pitch [rad], the mean rotation of the blades about the
        axes of their joints on the hub. Over `wind_speed` and `mode`: frequency [Hz], 0 where a mode does not
        oscillate, and damping_ratio, 1 where it is overdamped. `name` is a coordinate of `mode`. Over `order`
        (1P, 3P, ... for three blades) and `wind_speed`: order_frequency [Hz]. Over `resonance`, in ascending
        order of the wind: where a mode has the frequency of an order, with resonance_wind_speed,
        resonance_rotor_speed, resonance_frequency, resonance_damping_ratio, resonance_mode, resonance_order.
        The attribute `omitted_wind_speed` has those without an equilibrium.

    Raises
    ------
    SolverError
        If there is no rotor with blades in a steady wind, or no operating point at any wind speed.
    """
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    began = time.perf_counter()
    speeds = np.atleast_1d(np.asarray(wind, dtype=np.float64))
    if not (speeds.size and speeds.min() > 0.0):
        raise SolverError("wind: wind speeds must be above 0", INCONSISTENT)
    rotor = next(iter(system.model.wind_rotors.values()), None) if system.model is not None else None
    if rotor is None:
        raise SolverError("the model has no wind_rotors, so there are no modes over the wind", INCONSISTENT)
    hub = rotor.hub.partition(".")[0]
    linear = linear or linearise(system, scenario, turning=hub, progress=as_steps("matrices"))
    over = OverWind(linear, rates_of(linear, hub, scenario))
    found = follow_modes(
        system, speeds, hub, scenario, count=count, progress=progress, linear=linear, over=over
    )
    moving = np.flatnonzero(found.frequency.max(axis=0, initial=0.0) > 0.0)  # not the rotation of the rotor
    found = replace(
        found,
        names=tuple(found.names[k] for k in moving),
        frequency=found.frequency[:, moving],
        damping_ratio=found.damping_ratio[:, moving],
    )
    blades = rotor.beams or rotor.bodies
    data = _of_modes(found, over, _pitch_joints(system, hub, rotor), len(blades))
    # the states of the scenario at its start are not those of the operating points
    notes = [text for text in found.notes if not text.startswith(UNBALANCED) and UNSETTLED not in text]
    attrs: dict[str, Any] = {"body": hub, "multiblade": ", ".join(found.rotors)}
    if found.omitted:
        omitted = sorted(found.omitted)
        words = ", ".join(format_quantity(speed, "speed", 4) for speed in omitted)
        notes.append(f"no operating point at a wind of {words}, omitted: {found.omitted[omitted[0]]}")
        attrs["omitted_wind_speed"] = omitted
    attrs["notes"] = join_notes(notes)
    coords = {
        "wind_speed": ("wind_speed", found.speed, {"units": "m/s", "long_name": "wind speed"}),
        "mode": np.arange(1, len(found.names) + 1),
        "name": ("mode", list(found.names), {"long_name": "name of the mode"}),
        "order": [f"{order}P" for order in _orders(len(blades))],
    }
    wall = time.perf_counter() - began
    return xr.Dataset(
        {k: (dims, v, {"units": unit, "long_name": text}) for k, (dims, v, unit, text) in data.items()},
        coords=coords,
        attrs={**attributes(system, "wind_campbell", wall_s=wall), **attrs},
    )


def _orders(blades: int) -> list[int]:
    """1P and multiples of the number of blades."""
    return [1, *(k * blades for k in MULTIPLES)]


def _pitch_joints(system: System, hub: str, rotor: Any) -> list[int]:
    """Coordinates of the rotations of the blades on the hub, of those that have one."""
    model, names = system.model, system.layout.bodies
    assert model is not None
    roots = [model.beams[name].ends[0].partition(".")[0] for name in rotor.beams] or list(rotor.bodies)
    body = system.program["body"]
    numbers = [names.index(root) for root in roots if root in names]
    own = [b for b in numbers if names[int(body[b]["parent"])] == hub and body[b]["spin"] >= 0]
    return [int(body[b]["spin"]) for b in own]


Rows = dict[str, tuple[Any, Any, str, str]]


def _of_modes(found: Campbell, over: OverWind, joints: list[int], blades: int) -> Rows:
    """Variables of the dataset."""
    both, one = ("wind_speed", "mode"), ("wind_speed",)
    points = [over.states.operation(float(wind)) for wind in found.speed]
    rotor = np.array([point.speed for point in points])
    orders = np.abs(rotor) * np.array(_orders(blades))[:, None] / math.tau
    rows: Rows = {
        "rotor_speed": (one, rotor, "rad/s", "speed of the rotor"),
        "frequency": (both, found.frequency, *FREQUENCY),
        "damping_ratio": (both, found.damping_ratio, *RATIO),
        "order_frequency": (("order", "wind_speed"), orders, "Hz", "frequency of the order"),
    }
    if joints:
        pitch = [float(np.mean(point.state.q[joints])) for point in points]
        rows["pitch"] = (one, np.array(pitch), "rad", "pitch of the blades")
    return rows | _of_resonances(found, rotor, orders, blades)


def _of_resonances(found: Campbell, rotor: Any, orders: Any, blades: int) -> Rows:
    """Crossings of modes and orders between the computed wind speeds, by linear interpolation."""
    listed = []
    for order, line in zip(_orders(blades), orders, strict=True):
        away = found.frequency - line[:, None]
        above = away > 0.0
        vibrates = np.minimum(found.frequency[:-1], found.frequency[1:]) > 0.0
        for k, mode in np.argwhere(vibrates & (above[:-1] != above[1:])):
            part = away[k, mode] / (away[k, mode] - away[k + 1, mode])

            def between(values: Any, k: int = k, part: float = part) -> float:
                """Value at the crossing."""
                return float(values[k] + part * (values[k + 1] - values[k]))

            frequency, ratio = found.frequency[:, mode], found.damping_ratio[:, mode]
            values = (between(found.speed), between(rotor), between(frequency), between(ratio))
            listed.append((*values, int(mode) + 1, f"{order}P"))
    listed.sort()
    columns: Any = zip(*listed, strict=True) if listed else ((),) * 6
    winds, speeds, frequencies, ratios, modes, names = columns
    at = ("resonance",)
    return {
        "resonance_wind_speed": (at, np.array(winds, float), "m/s", "wind speed"),
        "resonance_rotor_speed": (at, np.array(speeds, float), "rad/s", "speed of the rotor"),
        "resonance_frequency": (at, np.array(frequencies, float), "Hz", "frequency"),
        "resonance_damping_ratio": (at, np.array(ratios, float), "1", "damping ratio"),
        "resonance_mode": (at, np.array(modes, np.int64), "1", "number of the mode"),
        "resonance_order": (at, np.array(names, dtype=object), "", "order"),
    }
