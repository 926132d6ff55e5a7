# SPDX-License-Identifier: Apache-2.0
"""Campbell diagram of a model: default body, speeds and operating range, orders of bearing faults."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress, as_steps, silent
from pitchpoint.core.status import INCONSISTENT

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import ArrayLike

    from pitchpoint.io.container import Header
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.solvers.excitation_orders import Orders
    from pitchpoint.system.system import System

BEARINGS = "bearings"
"""Word for the orders of the faults of all rolling bearings."""
FAULTS = {"ftf": "FTF", "bpfo": "BPFO", "bpfi": "BPFI", "bsf": "BSF"}
KEPT = ("body", "ranking", "operating_speed", "dissipation")
"""Attributes of a dataset that a result file contains among its options."""


def campbell_of(
    model: Model,
    scenario: str | None = None,
    *,
    body: str | None = None,
    speeds: tuple[float, float] | None = None,
    points: int = 41,
    orders: Orders | None = None,
    count: int | None = None,
    frequency: tuple[float, float] | None = None,
    operating: tuple[float, float] | None = None,
    progress: Progress = silent,
) -> xr.Dataset:
    """Campbell diagram of a model.

    Parameters
    ----------
    model, scenario
        The model, and the name of the scenario with loads and operating speed.
    body
        Body of the speed; default: see `body_of_speeds`.
    speeds, points
        Range of its speeds [rad/s], default from zero to 1.2 times the highest operating speed; number of
        speeds.
    orders
        As for `solve_campbell`, and `bearings`.
    count, frequency
        Number of modes; highest frequency [Hz] up to which modes are followed otherwise.
    operating
        Operating range of the body [rad/s]; default: lowest to highest speed of the scenario or of all
        scenarios, see `operating_range`.
    progress
        Called after every speed.

    Raises
    ------
    SolverError
        If nothing rotates, or as for `solve_campbell`.
    """
    from pitchpoint.report.operating_range import operating_range
    from pitchpoint.solvers.campbell import follow_modes
    from pitchpoint.solvers.campbell_dataset import campbell_dataset
    from pitchpoint.solvers.excitation_orders import USUAL, order_words
    from pitchpoint.solvers.linear_system import linearise, lowest
    from pitchpoint.system.compile import compile_model

    chosen = None if scenario is None else [model.scenarios[scenario]]
    body = body or body_of_speeds(model, chosen)
    if body is None:
        raise SolverError("no body rotates, so there is no Campbell diagram", INCONSISTENT)
    system = compile_model(model, scenario)
    linear = linearise(system, scenario, turning=body, progress=as_steps("matrices"))
    if frequency is not None and count is None:
        omega = lowest(linear).omega
        count = int(np.sum(omega <= REACH * 2.0 * math.pi * frequency[1])) + 1
    reached = operating_range(system, body, chosen)
    if speeds is None:
        top = (
            1.2 * max([*(reached or ()), *(operating or ())])
            if reached or operating
            else highest_speed(system, body, lowest(linear, FEW).omega / (2.0 * math.pi))
        )
        if not 0.0 < top < math.inf:
            raise SolverError(
                f"no scenario gives a speed of {body}; give --speeds, such as 0..3000rpm", INCONSISTENT
            )
        speeds = (0.0, top)
    note = _apart(speeds, operating)
    operating = operating or reached
    words = order_words(USUAL if orders is None else orders)
    more = _bearing_orders(model, body) if BEARINGS in words else None
    found = follow_modes(
        system, np.linspace(*speeds, points), body, scenario, count=count, progress=progress, linear=linear
    )
    found = replace(found, notes=(*found.notes, *note))
    return campbell_dataset(
        system, found, orders=[w for w in words if w != BEARINGS], more_orders=more, operating=operating
    )


REACH = 1.25
"""Frequency at rest over the highest one up to which modes are followed: backward whirl falls."""
FEW = 12
"""Number of modes that define the speeds without a scenario."""


def _apart(speeds: tuple[float, float], operating: tuple[float, float] | None) -> tuple[str, ...]:
    """Note on a given operating range of which no speed is computed."""
    if operating is None or (speeds[0] <= operating[1] and operating[0] <= speeds[1]):
        return ()
    ranges = ["–".join(f"{x * 30.0 / math.pi:.5g}" for x in ends) + " rpm" for ends in (operating, speeds)]
    return (f"the operating speeds {ranges[0]} are outside the computed speeds {ranges[1]}; extend --speeds",)


def body_of_speeds(model: Model, scenarios: Iterable[Scenario] | None = None) -> str | None:
    """Reference body of the speed.

    The hub of a wind rotor; in other machines the first rotating body whose speed a scenario gives, other
    than zero: start speeds, drives, sweep. Without one, the first that rotates, has a gear in mesh and is not
    a planet, that is, no rotating body carries it; else the first that rotates. Bodies at rest with the
    clutches that the first scenario engages do not count.

    Parameters
    ----------
    model
        The model.
    scenarios
        Its scenarios in order; default: all.

    Returns
    -------
    str or None
        None if no body rotates.
    """
    in_mesh = {g for mesh in model.every_mesh.values() for g in mesh.gears}
    turning = []
    for name, body in model.bodies.items():
        seat = model.mechanism.seats.get(name)
        if body.moves != "fixed" and seat is not None and "spin" in seat.coordinates:
            turning.append(name)
    hub = next(
        (name for r in model.wind_rotors.values() if (name := r.hub.partition(".")[0]) in turning), None
    )
    if hub is not None:
        return hub
    chosen = list(model.scenarios.values() if scenarios is None else scenarios)
    for scenario in chosen:
        given = next((name for name in _with_speed(scenario) if name in turning), None)
        if given is not None:
            return given
    turning = [name for name in turning if not chosen or _is_free(model, name, chosen[0])]
    own = {n: {*model.bodies[n].gears, *model.bodies[n].bevel_gears} for n in turning}
    geared = (n for n in turning if in_mesh & own[n] and not _carried(model, n, turning))
    return next(geared, turning[0] if turning else None)


def _is_free(model: Model, body: str, scenario: Scenario) -> bool:
    """Whether the engaged clutches and brakes of a scenario leave a body free to rotate."""
    from pitchpoint.core.errors import ModelError
    from pitchpoint.report.frequencies import turning_speeds

    if not scenario.engaged:
        return True
    try:
        return bool(turning_speeds(model, {body: 1.0}, scenario)[body])
    except ModelError:
        return False


def _with_speed(scenario: Scenario) -> list[str]:
    """Bodies whose speed a scenario gives, other than zero."""
    from pitchpoint.model.components.law import Constant

    found = [name for name, speed in scenario.speed.items() if speed != 0.0]
    for name, drive in scenario.drive.items():
        law = drive.speed or drive.angle
        stands = isinstance(law, Constant) and (law.value == 0.0 or law is drive.angle)
        if law is not None and not stands:
            found.append(name)
    return found if scenario.sweep is None else [*found, scenario.sweep.body]


def _carried(model: Model, name: str, turning: Iterable[str]) -> bool:
    """Whether a body is on one that rotates, such as a planet on its carrier."""
    seats = model.mechanism.seats
    while (seat := seats.get(name)) is not None:
        name = seat.parent
        if name in turning:
            return True
    return False


def highest_speed(system: System, body: str, frequency: ArrayLike) -> float:
    """End of a Campbell diagram without scenario [rad/s]: the slowest mesh frequency exceeds all modes there.

    Zero if the body turns no mesh.
    """
    from pitchpoint.solvers.gear_trains import mesh_orders
    from pitchpoint.solvers.initial_state.speeds import body_rates

    orders = mesh_orders(system, body_rates(system, body)).values()
    lowest = min((o for o in orders if o > 0.0), default=math.inf)
    return 1.2 * 2.0 * math.pi * float(np.max(frequency, initial=0.0)) / lowest


def _bearing_orders(model: Model, body: str) -> dict[str, float]:
    """Fault frequencies of all rolling bearings per revolution of a body, such as `BPFO front`."""
    from pitchpoint.report.frequencies import frequencies_of, turning_speeds

    rows = frequencies_of(model, turning_speeds(model, {body: 1.0}))["rolling_bearings"]
    if not rows:
        raise SolverError(
            "orders: bearings: the model has no rolling_bearings, whose elements give the fault frequencies; "
            "add them, or omit bearings",
            INCONSISTENT,
        )
    return {
        f"{word} {name}": math.tau * abs(row[key])
        for name, row in rows.items()
        for key, word in FAULTS.items()
        if row[key]
    }


def campbell_header(header: Header, data: xr.Dataset) -> Header:
    """Header of the result file of a diagram."""
    kept = {name: data.attrs[name] for name in KEPT if name in data.attrs}
    return replace(header, options={**header.options, **kept})
