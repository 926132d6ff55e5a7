# SPDX-License-Identifier: Apache-2.0
"""Record of the signals of a system: what senses, what computes, what acts, in the order of evaluation.

All signals of a system are records of one bank. Their values V, their derivatives W by the sources (sensors
and states), the derivatives of the sources by the motion of two bodies, and all tables lie in one pool:

    V (nodes), W (nodes, sources), rows (sources, 2, 18): by x, x', x'' of the bodies i and j, then the rest
"""

from __future__ import annotations

import numpy as np

#: Sensors: a component, what it is between two frames, or a load.
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
"""A tangent: how the actuator on body i follows the motion of body j."""

WORLD, BODY_I, BODY_J = 0, 1, 2
"""Axes in which the direction of a `FORCE` is given."""
TIME, NOTHING = -1, -2
"""Inputs of a formula that are not signals."""
UNITS = ("", "1", "m", "m/s", "m/s^2", "rad", "rad/s", "rad/s^2", "N", "N m", "W")

ROW = 18
"""Numbers of one body in the row of a source: by displacement, by rate, by acceleration."""

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("op", "i8"),  # what it does
        ("slot", "i8"),  # its place in V; -1 of a link
        ("a", "i8"),  # inputs, as slots; of links: places in the pool of the wrench of the actuator,
        ("b", "i8"),  # of the row of the source
        ("c", "i8"),  # and of the weight of the source
        ("source", "i8"),  # column of W, of sensors and states
        ("nodes", "i8"),  # length of V
        ("sources", "i8"),  # columns of W
        ("start", "i8"),  # first of its own numbers in the pool; actuators keep their unit wrenches there
        ("n", "i8"),  # inputs of a combination, points of a table, words of a formula, bodies beyond a joint
        ("channel", "i8"),  # observation that is listened to
        ("axes", "i8"),  # of a force: WORLD, BODY_I or BODY_J
        ("unit", "i8"),  # of the value, see UNITS
        ("pool", "i8"),
        ("law", "i8"),
        ("p_i", "f8", 3),  # point on body i from its origin, axes of the body [m]
        ("p_j", "f8", 3),  # point on body j likewise
        ("x_i", "f8", 3),  # direction on body i whose angle is sensed
        ("e", "f8", 3),  # axis of a component, fixed to body j; direction from which an angle counts
        ("y", "f8", 3),  # direction on body j at which an angle is a right one
        ("F", "f8", 6),  # force and moment of a `FORCE` at a signal of one
        ("low", "f8"),  # limits; of an angle: what parts it from the spins of the bodies [rad]
        ("high", "f8"),
        ("value", "f8"),  # constant part of a combination
        ("out", "i8"),
    ],
    align=True,
)
