# SPDX-License-Identifier: Apache-2.0
"""Speeds that a scenario prescribes, and the rates of a train for the speed of one of its bodies."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.elements import drive as drive_element
from pitchpoint.elements.kind import DRIVE
from pitchpoint.elements.ratio import place_of
from pitchpoint.model.scenario import Scenario
from pitchpoint.model.shafts import station_names
from pitchpoint.solvers.gear_trains import rotations, spins_of_train
from pitchpoint.system.system import System


def speeds_of(system: System, scenario: Scenario) -> dict[str, float]:
    """Speed of every body at the start [rad/s]; driven bodies start with the speed of their drive."""
    model = system.model
    if model is None:
        raise SolverError("the system was not made from a model; give a state instead of a scenario", 0)
    known = dict(scenario.speed)
    for name, record in drive_records(system):
        if place_of(record, "i") != int(record["spin_i"]):
            continue
        known[name] = drive_element.target_of(record, 0.0)[1]
    # drives may deviate from the gear ratio within the backlash
    found = {**model.start_speeds(replace(scenario, speed=known)), **known}
    for name, places in model.stations.items():
        found |= dict.fromkeys(station_names(name, len(places)), found[name])
    return found


def highest_speeds(system: System, scenario: Scenario) -> dict[str, float]:
    """Given speeds of bodies in a scenario [rad/s]; for drives the highest one, with its sign."""
    found = dict(scenario.speed)
    times = np.linspace(0.0, scenario.duration or 1.0, 401)
    for name, record in drive_records(system):
        if place_of(record, "i") == int(record["spin_i"]):
            found[name] = max((drive_element.target_of(record, t)[1] for t in times), key=abs)
    return found


def body_rates(system: System, body: str, scenario: Scenario | None = None) -> NDArray[np.float64]:
    """Rates of all coordinates, shape (nd,), for one body at 1 rad/s together with its train.

    The direction of rotation is that of the scenario, positive if the body is at rest there. A body fixed to
    a shaft has the speed of the shaft. Speeds that this does not determine, as in a planetary gear set with
    three free members, have the ratio of the speeds of the scenario; bodies that it drives or holds at zero
    speed are at rest.
    """
    model = system.model
    if model is None:
        return np.asarray(rotations(system, (system.spin(body),))[:, 0])
    chosen = scenario or system.scenario or Scenario()
    known, body = highest_speeds(system, chosen), turning_body(system, body)
    own = model.start_speeds(replace(chosen, speed=known)).get(body, 0.0)
    others = {}
    if known.keys() - {body}:
        train = spins_of_train(system, system.spin(body))
        beside = {n: w for n, w in known.items() if n != body and system.spin(n) in train}
        others = {n: w / abs(own) if own else 0.0 for n, w in beside.items() if own or not w}
    rates, sense = np.zeros(system.sizes["nd"]), -1.0 if own < 0.0 else 1.0
    for name, ratio in model.start_speeds(replace(chosen, speed={body: sense} | others)).items():
        if ratio != 0.0:
            rates[system.spin(name)] = ratio
    return rates


def turning_body(system: System, body: str) -> str:
    """Body of the model with the spin of a body: the shaft of a station or of a body that is fixed to it."""
    spin, names = system.spin(body), system.layout.bodies
    model = system.model
    if model is None:
        return body
    stations = {s: n for n, places in model.stations.items() for s in station_names(n, len(places))}
    own = system.program["body"]["spin"]
    owner = next(name for name, at in zip(names, own, strict=True) if int(at) == spin)
    return stations.get(owner, owner)


def drive_records(system: System) -> list[tuple[str, np.void]]:
    """Name of the body and record of every drive."""
    system.workspace  # noqa: B018 - fills in the pool addresses of the records
    return [(system.layout.bodies[int(r["i"])], r) for r in system.rows(DRIVE)]
