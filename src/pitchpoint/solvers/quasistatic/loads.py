# SPDX-License-Identifier: Apache-2.0
"""Loads of a slow roll: the limit of zero speed, with the torques of the operating point."""

from __future__ import annotations

import numpy as np

from pitchpoint.elements.signal import CONSTANT, OVER_ANGLE, Pool, set_constant, set_table
from pitchpoint.elements.torque import KIND, values_of
from pitchpoint.solvers.load_cycle import pulsating_loads, relative_turn
from pitchpoint.solvers.load_orders import angles_of, with_pool
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

SAME = 1e-9
"""Relative difference over the angle up to which a torque depends on the speed alone."""
ANGLES = np.linspace(0.0, 8.0 * np.pi, 289)
"""Angles at which torques are compared [rad]."""


def loads_at_speed(system: System, state: State) -> System:
    """Copy of a system whose torques are those at the speeds of a state, whatever the speed.

    Examples are fans and the characteristics of motors: at the speed of a slow roll, zero, they would leave
    the meshes without load. A torque over speed and angle becomes a table over the angle if it repeats.
    """
    own = system.copy()
    if KIND.name not in own.records:
        return own
    repeating = {load.number: load for load in pulsating_loads(own, state, np.zeros((len(state.v), 0)))}
    records, pool = own.records[KIND.name].copy(), Pool()
    pool.add(own.pools.get(KIND.name, np.zeros(0)))
    for k, record in enumerate(records):
        if int(record["form"]) == CONSTANT:
            continue
        angle, speed, _ = relative_turn(own, state, record)
        at_speed, at_rest = (values_of(record, state.t, angle + ANGLES, w) for w in (speed, 0.0))
        size = float(np.abs(at_speed).max())
        if np.abs(at_speed - at_rest).max() <= SAME * size:
            continue
        if np.ptp(at_speed) <= SAME * size:
            set_constant(record, float(at_speed[0]))
        elif k in repeating and repeating[k].by_angle:
            over, base = angles_of(repeating[k])
            values = repeating[k].at_angles(over, speed)
            over, values = np.append(over, 2.0 * np.pi / base), np.append(values, values[0])
            set_table(record, pool, over, values, OVER_ANGLE, 2.0 * np.pi / base)
    return with_pool(own, records, pool)


def loads_at_state(system: System, state: State) -> System:
    """Copy of a system whose torques are constant, with their values at a state."""
    own = system.copy()
    if KIND.name not in own.records:
        return own
    evaluate.residual(own, state)
    records = own.records[KIND.name].copy()
    for record in records:
        if int(record["form"]) != CONSTANT:
            angle, speed, _ = relative_turn(own, state, record)
            set_constant(record, float(values_of(record, state.t, [angle], [speed])[0]))
    return own.with_params({KIND.name: records})
