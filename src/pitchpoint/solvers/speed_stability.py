# SPDX-License-Identifier: Apache-2.0
"""Stability of the speed at which the torques of a train balance.

A deviation w of the free rotations from the operating point follows m dw/dt = s w with the inertia m and the
slope s of all torques over the speed. A positive eigenvalue of m^-1 s is the rate at which the deviation
grows: an excess of speed causes a torque that increases it further. A constant torque, such as that of
`torque: balance`, has no slope and changes nothing. A single train is stable if the slope of the sum of its
torques is negative: d(sum of torques)/d(speed) < 0.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, note
from pitchpoint.core.units import format_quantity
from pitchpoint.elements.kind import CLUTCH
from pitchpoint.elements.signal import CONSTANT
from pitchpoint.elements.torque import slopes_of
from pitchpoint.solvers.element_tangents import without_friction
from pitchpoint.solvers.equilibrium.balancing import LOAD
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.equilibrium.unknowns import rest_matrix
from pitchpoint.solvers.gear_trains import free_motions
from pitchpoint.solvers.load_cycle import pulsating_loads, relative_turn
from pitchpoint.solvers.load_orders import angles_of
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

ROUND_OFF = 1e-9
"""Positive eigenvalue over the largest possible one that is rounding."""
REMEDY = (
    "drive or hold a body of the train, add a controller, or give a torque that falls with the speed: the "
    "characteristic of a motor instead of a constant torque, a load whose braking torque rises with the speed"
)


@dataclass(frozen=True)
class UnstableSpeed:
    """Operating point from which the speed runs away.

    Parameters
    ----------
    load, body
        The load that feeds the deviation most, and its body.
    speed
        Speed of the body at the operating point [rad/s].
    slope
        Slope of the sum of all torques over the speed, reduced to the body [N m s/rad]; positive.
    rate
        Rate at which a deviation of the speed grows [1/s].
    """

    load: str
    body: str
    speed: float
    slope: float
    rate: float

    def __str__(self) -> str:
        at = format_quantity(self.speed, "angular_speed", 4)
        doubles = format_quantity(math.log(2.0) / self.rate, "time", 3)
        return (
            f"the operating point, {self.body} at {at}, is unstable: because of {self.load}, the sum of the "
            f"torques rises with the speed (slope +{self.slope:.3g} N m s/rad, stable below 0), and a "
            f"deviation of the speed doubles every {doubles}"
        )

    def note(self) -> Message:
        """The sentence with its remedy."""
        return note(str(self), remedy=REMEDY)


def unstable_speed(system: System, state: State) -> UnstableSpeed | None:
    """The fastest growing deviation from constant speed, if there is one.

    Torques that repeat with the angle count with their mean slope, flanks and joints without friction. None
    also for machines with closed loops, whose inertia changes, and with clutches or actuators.

    Parameters
    ----------
    system, state
        The system with its balancing torques, and the mean speeds.
    """
    own = without_friction(system, joints=True).copy()
    model, motions = own.model, free_motions(own)
    if model is None or LOAD not in own.records or model.actuators or own.kinds(CLUTCH) or is_looped(own):
        return None
    motions = motions[:, np.abs(motions.T) @ np.abs(state.v) > 0.0]
    if not motions.size:
        return None
    damping, mass = (
        motions.T @ rest_matrix(own, state, NEWTON, factors) @ motions
        for factors in ((0.0, 1.0, 0.0), (1.0, 0.0, 0.0))
    )
    slopes = -damping
    loads = []
    repeating = {load.number: load for load in pulsating_loads(own, state, motions)}
    for k, record in enumerate(own.records[LOAD]):
        if int(record["form"]) == CONSTANT:
            continue
        angle, speed, row = relative_turn(own, state, record)
        now = mean = float(slopes_of(record, state.t, [angle], [speed])[2][0])
        if k in repeating and repeating[k].by_angle:
            mean = float(slopes_of(record, state.t, angles_of(repeating[k])[0], speed)[2].mean())
        share = row @ motions
        slopes = slopes + (mean - now) * np.outer(share, share)
        loads.append((mean, share, k, speed))
    values, shapes = np.linalg.eig(np.linalg.solve(mass, slopes))
    worst = int(np.argmax(values.real))
    rate, shape = float(values[worst].real), shapes[:, worst].real
    fed = [(mean * float(share @ shape) ** 2, share, k, speed) for mean, share, k, speed in loads]
    size = sum(abs(power) for power, *_ in fed)
    if not fed or rate * float(shape @ mass @ shape) <= ROUND_OFF * size:
        return None
    power, share, k, speed = max(fed, key=lambda one: one[0])
    body = own.layout.bodies[int(own.records[LOAD][k]["i"])]
    net = float(shape @ slopes @ shape) / float(share @ shape) ** 2
    return UnstableSpeed(own.names[LOAD][k], body, speed, net, rate) if power > 0.0 else None
