# SPDX-License-Identifier: Apache-2.0
"""Mean torques of a slow roll: loads that repeat over the angle count with their mean over it.

A slow roll is the limit of zero speed. It starts with the balancing torques of a run at low speed, constant
torques whose work balances over the revolution (decision 0029), and names them; from there they follow the
loads (`holding`). Loads over time count at the start.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.gear_trains import rotations
from pitchpoint.solvers.load_cycle import LoadCycle, pulsating_loads
from pitchpoint.solvers.load_waves import grid_of
from pitchpoint.solvers.quasistatic.path import held_in_roll
from pitchpoint.solvers.steady_motion import window
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names
from pitchpoint.system.system import State, System


def roll_cycle(system: System, state: State, mesh: str | None) -> LoadCycle | None:
    """Mean torques of loads that repeat over the angle, for a roll from rest; None if there are none.

    Parameters
    ----------
    system, state
        The system, and the state at the start, at rest.
    mesh
        The rolled mesh; None for the only one.

    Notes
    -----
    The period of the result is the angle [rad] of the rotated body, not a time. With closed loops, whose
    ratios vary, loads count at the start.
    """
    names = mesh_names(system)
    if is_looped(system) or state.v.any() or (mesh is None and len(names) != 1):
        return None
    spin = held_in_roll(system, names.index(mesh or names[0]), state)[0]
    turning = state.copy()
    turning.v[:] = rotations(system, (spin,))[:, 0]
    evaluate.residual(system, turning)
    found = pulsating_loads(system, turning, np.zeros((system.sizes["nd"], 0)))
    loads = [load for load in found if load.by_angle and not load.timed]
    rates = np.array(sorted({abs(rate) for load in loads for rate in load.rates}))
    if not rates.size:
        return None
    h, points, period = grid_of(rates)
    weights: Array = np.full(points, 1.0 / points) if period > 0.0 else window(points)
    turned = np.arange(points, dtype=np.float64) * h
    means = {
        load.number: float(weights @ load.at_angles(load.angle + load.speed * turned, 0.0)) for load in loads
    }
    rest = np.zeros(system.sizes["nd"])
    return LoadCycle(
        means=means,
        period=period,
        averaged=period if period > 0.0 else h * points,
        error=0.0,
        offset=rest,
        lowest=rest,
        highest=rest,
        swing=rest,
        body=system.layout.coordinates[spin].rsplit(".", 1)[0],
    )
