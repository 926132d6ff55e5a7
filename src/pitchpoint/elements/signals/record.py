# SPDX-License-Identifier: Apache-2.0
"""Record of the signals of a system: sensors, blocks and actuators in evaluation order.

All signals of a system are records of one array. Their values V, their derivatives W by the sources (sensors
and states), the derivatives of the sources by the motion of two bodies, and all tables are in one pool:

    V (nodes), W (nodes, sources), rows (sources, 2, 18): by x, x', x'' of the bodies i and j, then the tables
"""

from __future__ import annotations

import numpy as np

#: Sensors: kinematic quantities between two frames, states, loads.
(
    POSITION,
    VELOCITY,
    ACCELERATION,
    DISTANCE,
    DISTANCE_RATE,
    ANGLE,
    ANGULAR_VELOCITY,
    ANGULAR_ACCELERATION,
    STATE,
    REACTION_FORCE,
    REACTION_MOMENT,
    CHANNEL,
) = range(1, 13)
#: Blocks: linear combination, limits, table, formula, user law, output of a sampled controller.
LINEAR, SATURATION, TABLE, FORMULA, LAW, HELD = range(20, 26)
#: Actuators: about the common axis, along the line between two points, fixed direction, rate of a state.
TORQUE, STRUT, FORCE, RATE = range(30, 34)
LINK = 40
"""Tangent of the actuator on body i by the motion of body j."""

LIMITED = ".limited"
"""End of the name of the limited rate of a state."""

WORLD, BODY_I, BODY_J = 0, 1, 2
"""Axes of the direction of a `FORCE`."""
TIME, NOTHING = -1, -2
"""Inputs of a formula that are not signals: the time, no input."""
UNITS = ("", "1", "m", "m/s", "m/s^2", "rad", "rad/s", "rad/s^2", "N", "N m", "W")

ROW = 18
"""Values of one body in the row of a source: derivatives by displacement, velocity, acceleration."""

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("op", "i8"),  # operation, see above
        ("slot", "i8"),  # index in V; -1 for a link
        ("a", "i8"),  # slots of the inputs; links: pool offsets of the wrench of the actuator,
        ("b", "i8"),  # of the row of the source
        ("c", "i8"),  # and of the weight of the source
        ("source", "i8"),  # column of W, for sensors and states
        ("nodes", "i8"),  # length of V
        ("sources", "i8"),  # columns of W
        ("start", "i8"),  # pool offset of its values; of the unit wrenches for actuators
        ("n", "i8"),  # inputs of a combination, points of a table, words of a formula, bodies beyond a joint
        ("channel", "i8"),  # index of the measured observation
        ("axes", "i8"),  # of a force: WORLD, BODY_I or BODY_J
        ("unit", "i8"),  # of the value, see UNITS
        ("pool", "i8"),
        ("law", "i8"),
        ("p_i", "f8", 3),  # point on body i from its origin, axes of the body [m]
        ("p_j", "f8", 3),  # point on body j likewise
        ("x_i", "f8", 3),  # direction on body i whose angle is measured
        ("e", "f8", 3),  # axis of a component, fixed to body j; direction of zero angle
        ("y", "f8", 3),  # direction on body j of an angle of 90 deg
        ("F", "f8", 6),  # force and moment of a `FORCE` at a signal of 1
        ("low", "f8"),  # limits; of an angle: its value with all coordinates zero [rad]
        ("high", "f8"),
        ("value", "f8"),  # constant part of a combination
        ("out", "i8"),
    ],
    align=True,
)
