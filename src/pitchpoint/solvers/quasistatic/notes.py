# SPDX-License-Identifier: Apache-2.0
"""Notes on the loads of a slow roll: unloaded meshes, loads that do not balance, neglected friction.

A body without drive and balancing torque is held in a slow roll, so unbalanced loads do not change a speed:
the holding torque balances them, and a mesh may be unloaded or loaded on its other flank.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import Message, note
from pitchpoint.core.words import listed, ranges
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.solvers.equilibrium.balancing import LOAD, balancing_loads
from pitchpoint.solvers.gear_trains import rotations
from pitchpoint.solvers.initial_state.start import IMBALANCE
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.system.meshes import mesh_names, mesh_records

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.solvers.load_cycle import LoadCycle
    from pitchpoint.system.system import System


def load_notes(system: System, holding: Mapping[str, Array], rows: Array) -> tuple[Message, ...]:
    """Notes on meshes without load, and on torques that are balanced by held bodies only.

    Parameters
    ----------
    system
        The system of the roll.
    holding
        Holding torques [N m] of bodies without drive and balancing torque, by body, shape (n,).
    rows
        All channels, shape (n, no).
    """
    if not len(rows) or system.model is None or not system.model.loads:
        return ()  # a roll without loads is for the flank geometry only
    torques = load_torques(system, rows[0])
    least = max(IMBALANCE * max(map(abs, torques.values()), default=0.0), 1e-9)
    left = {body: -torque for body, torque in holding.items() if np.abs(torque).max() > least}
    over = [f"{_range(torque, least)} on {body}" for body, torque in left.items()]
    empty = [
        mesh
        for mesh, record in zip(mesh_names(system), mesh_records(system), strict=True)
        if np.abs(rows[:, system.layout.channel(f"mesh_force[{mesh}]")] * record["r_b1"]).max() <= least
    ]
    found = []
    relieved, empty = _relieved(system.model, empty)
    for planet, meshes in relieved.items():
        found.append(
            note(
                f"{planet} carries no load: errors of the pins and the clearance of {' and '.join(meshes)} "
                "exceed the deflection of the other planets",
                remedy="increase the torque or reduce the errors if this is not intended",
            )
        )
    if empty:
        why = f", and {' and '.join(over)} are balanced by holding torques" if over else ""
        found.append(
            note(
                f"{_meshes(empty)} no load{why}",
                remedy="load the bodies on both sides of a mesh, one of them with torque: balance, "
                "if this is not intended",
            )
        )
    elif over:
        found.append(
            note(
                f"the loads do not balance: {' and '.join(over)} are balanced by holding torques",
                remedy="set one torque to `balance` if this is not intended",
            )
        )
    return (*found, *(same for body in left if (same := _same_way(system, body, torques))))


def _meshes(names: Sequence[str]) -> str:
    """Meshes that carry something, in words.

    Examples
    --------
    >>> _meshes(["a"]), _meshes(["a", "b", "c"])
    ('mesh a carries', 'meshes a, b and c carry')
    """
    return f"mesh {names[0]} carries" if len(names) == 1 else f"meshes {ranges(names)} carry"


def _relieved(model: Model, empty: Sequence[str]) -> tuple[dict[str, list[str]], list[str]]:
    """Unloaded meshes by planet, where other planets of the stage carry load, and all other meshes."""
    planets: dict[str, list[str]] = {}
    for stage in model.planetary_stages.values():
        sides = [group.names for group in stage.groups]
        for planet, *own in zip(stage.names, *sides, strict=True):
            if set(own) <= set(empty) and not set(sides[0]) <= set(empty):
                planets[planet] = own
    known = {mesh for meshes in planets.values() for mesh in meshes}
    return planets, [mesh for mesh in empty if mesh not in known]


def friction_notes(system: System) -> tuple[str, ...]:
    """Note if meshes or joints have friction: at zero speed, the limit of a slow roll, it vanishes."""
    rubbing = [
        name
        for name, record in zip(mesh_names(system), mesh_records(system), strict=True)
        if record["contact"]["mu"] > 0.0
    ]
    pins = (
        [] if system.model is None else [n for n, j in system.model.joints.items() if j.friction is not None]
    )
    kinds = ("mesh", "meshes", rubbing), ("joint", "joints", pins)
    what = [f"{many if names[1:] else one} {listed(names)}" for one, many, names in kinds if names]
    if not what:
        return ()
    return (
        f"friction of {' and of '.join(what)} is neglected, since a slow roll is computed at zero speed, "
        "where the smoothed friction force is zero: use a time response for friction",
    )


def load_torques(system: System, row: Array) -> dict[str, float]:
    """Torque of every torque load [N m], by name, from a row of channel values."""
    known = {c.name: k for k, c in enumerate(system.layout.channels)}
    loads = system.model.loads if system.model is not None else {}
    return {name: float(row[known[f"torque[{name}]"]]) for name in loads if f"torque[{name}]" in known}


def balance_notes(system: System, cycle: LoadCycle | None, rows: Array) -> tuple[str, ...]:
    """Notes on balancing torques that follow pulsating loads.

    Parameters
    ----------
    system
        The system with the mean balancing torques.
    cycle
        Mean torques of the pulsating loads, if there are any.
    rows
        All channels, shape (n, no).
    """
    if cycle is None or not len(rows):
        return ()
    names, records = system.names[LOAD], system.records[LOAD]
    loads, found = listed([names[k] for k in cycle.means]), []
    # torques of a machine are rounding below those of its largest load
    least = max(
        IMBALANCE * max((abs(t) for row in rows for t in load_torques(system, row).values()), default=0.0),
        1e-9,
    )
    for k in balancing_loads(system):
        torque, mean = rows[:, system.layout.channel(f"torque[{names[k]}]")], float(records[k]["value"])
        if np.abs(torque - mean).max() > least:
            found.append(
                f"{names[k]} balances {loads} at every position, with {_range(torque, least)}, and its mean "
                f"over the whole cycle of the loads is {mean:.4g} N m"
            )
    return tuple(found)


def _range(values: Array, least: float) -> str:
    """A torque [N m], or its range if it varies."""
    lowest, highest = float(values.min()), float(values.max())
    return f"{values[0]:.4g} N m" if highest - lowest <= least else f"{lowest:.4g} to {highest:.4g} N m"


def _same_way(system: System, body: str, torques: dict[str, float]) -> Message | None:
    """Note if all torques on a train act in the same direction: the other flanks are then loaded."""
    rates = rotations(system, (system.spin(body),))[:, 0]
    loads = system.model.loads if system.model is not None else {}
    powers = {
        name: torque * float(np.sign(rates[system.spin(loads[name].body)]))
        for name, torque in torques.items()
        if torque != 0.0
        and spin_of(system.program["body"], system.layout.bodies.index(loads[name].body)) >= 0
    }
    powers = {name: power for name, power in powers.items() if power != 0.0}
    bodies = {loads[name].body for name in powers}
    if len(bodies) < 2 or len(set(np.sign(list(powers.values())))) != 1:
        return None
    first, *others = powers
    return note(
        f"{first} and {' and '.join(others)} drive the train in the same direction, so the working flank is "
        f"not the one that {first} alone would load",
        remedy="change the sign of the braking torque",
    )
