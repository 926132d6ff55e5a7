# SPDX-License-Identifier: Apache-2.0
"""Andrews' squeezing mechanism: seven bodies in a tree of revolute joints, three loops closed by pins.

Numbers: F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers, release 2.4, 2008, problem
Andrews; the figure is also in E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, VII.7. The
coordinates are the published angles: each body has an arm along an axis of its own that the angle turns, so
that all zero is a place of the tree, and the rows are the published ones with their signs.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.elements import torque
from pitchpoint.elements.signal import OVER_ANGLE, Pool, set_law
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.system.system import assemble
from tests.support.closures import pins

#: Published names of the angles in the order of our bodies, and their places in the published vector.
ANGLES = ("beta", "theta", "gamma", "delta", "phi", "epsilon", "omega")
PLACES = (0, 1, 2, 4, 3, 6, 5)

START = (
    -0.0617138900142764496,
    0.0,
    0.455279819163070380,
    0.222668390165885885,
    0.487364979543842550,
    -0.222668390165885885,
    1.230547444549821192,
)
END = (
    15.81077119629904,
    -15.75637105984298,
    0.04082224013073101,
    -0.5347301163226948,
    0.5244099658805304,
    0.5347301163226948,
    1.048080741042263,
)
END_SPEED = (1139.920302151208, -1424.379294994111, 11.03291221937134)
START_FORCES = (98.5668703962, -6.1226883443, 0.0, 0.0, 0.0, 0.0)
END_FORCES = (
    199.1753333731910,
    -29.75531228015052,
    23.06654119098399,
    31.45271365475927,
    22.64249232082739,
    11.61740700019673,
)
END_TIME = 0.03

CENTER, A, B, C = (0.0, 0.0), (-0.06934, -0.00227), (-0.03635, 0.03273), (0.014, 0.072)
RR, RA, D, DA, E, EA = 0.007, 0.00092, 0.028, 0.0115, 0.02, 0.01421
SS, SA, SB, SC, SD, TA, TB = 0.035, 0.01874, 0.01043, 0.018, 0.02, 0.02308, 0.00916
U, UA, UB, ZF, ZT, FA = 0.04, 0.01228, 0.00449, 0.02, 0.04, 0.01421
SPRING, LENGTH, DRIVE = 4530.0, 0.07785, 0.033


def spring_moment(t, gamma, p):
    """Moment of the spring between C and a point of the third body, about B."""
    x = SD * math.cos(gamma) + SC * math.sin(gamma)
    y = SD * math.sin(gamma) - SC * math.cos(gamma)
    dx, dy = B[0] + x - C[0], B[1] + y - C[1]
    length = math.hypot(dx, dy)
    force = -SPRING * (length - LENGTH) / length
    return force * (x * dy - y * dx)


def _body(name, parent, position, mass, inertia, com):
    tensor = np.diag([inertia, inertia, inertia])
    return Body(
        motion=TORSION,
        parent=parent,
        position=(*position, 0.0),
        mass=mass,
        com=(*com, 0.0),
        inertia=tensor,
        name=name,
    )


def squeezer():
    """System and published start."""
    along_p = (A[0] + ZT, A[1])
    bodies = [
        _body("beta", 0, CENTER, 0.04325, 2.194e-6, (RA, 0.0)),
        _body("theta", 1, (RR, 0.0), 0.00365, 4.410e-7, (-DA, 0.0)),
        _body("gamma", 0, B, 0.02373, 5.255e-6, (SB, -SA)),
        _body("delta", 0, A, 0.07050, 1.169e-5, (TA, -TB)),
        _body("phi", 4, along_p, 0.00706, 5.667e-7, (0.0, -(E - EA))),
        _body("epsilon", 0, A, 0.05498, 1.912e-5, (UB, -UA)),
        _body("omega", 6, (A[0], A[1] - U), 0.00706, 5.667e-7, (ZF - FA, 0.0)),
    ]
    loads = np.zeros(2, torque.RECORD)
    loads["i"] = (1, 3)
    loads["value"][0] = DRIVE
    pool = Pool()
    set_law(loads[1], pool, (), OVER_ANGLE)
    tip = (-D, 0.0, 0.0)
    rows = [(2, tip, 3, (0.0, -SS, 0.0)), (2, tip, 5, (0.0, -E, 0.0)), (2, tip, 7, (ZF, 0.0, 0.0))]
    system = assemble(
        bodies,
        {"torque": loads},
        {"pin_in_plane": pins(rows)},
        pools={"torque": pool.array()},
        laws={"torque": [None, spring_moment]},
    )
    state = system.initial_state()
    state.q[:] = published(START)
    return system, state


def published(values):
    """A published vector in the order of our coordinates."""
    return np.array([values[k] for k in PLACES])


def angles(state):
    """Angles of a state with their whole turns, in the published order."""
    found = np.zeros(7)
    found[list(PLACES)] = state.q + 2.0 * np.pi * state.turns[1:]
    return found
