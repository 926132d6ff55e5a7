# SPDX-License-Identifier: Apache-2.0
"""Loads of a slow roll: the limit of zero speed, with the torques of the operating point."""

from __future__ import annotations

import numpy as np

from pitchpoint.elements.signal import CONSTANT, set_constant
from pitchpoint.elements.torque import KIND, values_of
from pitchpoint.solvers.load_cycle import relative_turn
from pitchpoint.system.system import State, System

SAME = 1e-9
"""Relative difference over the angle up to which a torque depends on the speed alone."""
ANGLES = np.linspace(0.0, 8.0 * np.pi, 289)
"""Angles at which torques are compared [rad]."""


def loads_at_speed(system: System, state: State) -> System:
    """Copy of a system in which torques over the speed alone keep their values at the speeds of a state.

    Examples are fans and the characteristics of motors: at the speed of a slow roll, zero, they would leave
    the meshes without load. Torques that also depend on the angle are those at zero speed.
    """
    own = system.copy()
    if KIND.name not in own.records:
        return own
    records = own.records[KIND.name].copy()
    for record in records:
        if int(record["form"]) == CONSTANT:
            continue
        angle, speed, _ = relative_turn(own, state, record)
        at_speed, at_rest = (values_of(record, state.t, angle + ANGLES, w) for w in (speed, 0.0))
        size = float(np.abs(at_speed).max())
        if speed != 0.0 and np.ptp(at_speed) <= SAME * size and abs(at_speed[0] - at_rest[0]) > SAME * size:
            set_constant(record, float(at_speed[0]))
    return own.with_params({KIND.name: records})
