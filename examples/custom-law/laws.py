# SPDX-License-Identifier: Apache-2.0
"""Two user-defined laws: a torque over the angle of its body, and a mesh stiffness over the mesh phase.

Every law is a function f(t, x, p): time, the quantity it depends on, and the numbers under `parameters` in
the model file. It is compiled; code that cannot be compiled runs as plain Python, ten times slower.
"""

from math import cos, pi, sin


def cam_torque(t, angle, p):
    """Torque [N m] of a cam with p[2] lobes: mean p[0], alternating share p[1]."""
    return p[0] * (1.0 + p[1] * sin(p[2] * angle))


def tooth_stiffness(t, psi, p):
    """Mesh stiffness [N/m], psi base pitches after a pair came into contact: mean p[0], three harmonics."""
    w = 2.0 * pi * psi
    return p[0] * (1.0 + p[1] * cos(w) + p[2] * cos(2.0 * w) + p[3] * cos(3.0 * w))


def broken(t, angle, p):
    """A law with an error: it has no torque after p[0] seconds."""
    if t > p[0]:
        raise ValueError("the table of the test rig ends here")
    return 150.0
