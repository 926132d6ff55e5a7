# SPDX-License-Identifier: Apache-2.0
"""Forces of two gears that are turned through their ratio and pressed by the same depth everywhere."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model


def turned_forces(model, angles, depth, mesh="stage", bodies=("driver", "driven")):
    """Forces of a mesh [N] where gear 1 has turned by the angles, front flanks pressed by the depth [m]."""
    system = compile_model(model)
    pair = model.pairs[mesh]
    travel = 0.5 * model.backlash(mesh) + depth
    r1, r2 = 0.5 * pair.gear1.d_b, 0.5 * pair.gear2.d_b
    column = system.layout.channel(f"mesh_force[{mesh}]")
    found = []
    for angle in angles:
        state = system.initial_state()
        turned = (angle + 0.5 * travel / r1, -angle * r1 / r2 + 0.5 * travel / r2)
        for body, at in zip(bodies, turned, strict=True):
            turns = round(at / (2.0 * math.pi))
            state.q[system.spin(body)] = at - 2.0 * math.pi * turns
            state.turns[system.layout.bodies.index(body)] = turns
        found.append(evaluate.observe(system, state)[column])
    return np.array(found)


def swaying(t, psi, parameters):
    """Stiffness that falls along the path of contact [N/m]."""
    return 4e8 + 5e7 * (0.5 - psi)
