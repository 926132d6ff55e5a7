# SPDX-License-Identifier: Apache-2.0
"""A mass on a rod in a plane, in Cartesian coordinates: the pendulum as a problem of index 3, for tests."""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements import force, registry
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.channels import constraint_args, constraint_rates
from pitchpoint.multibody.joints import PRISMATIC
from pitchpoint.system.system import assemble

ROWS = 1
RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [("row", "i8"), ("length", "f8"), ("out", "i8")],
    align=True,
)
OUTPUTS = ()
KIND = registry.Kind("rod", __name__, registry.CONSTRAINT)
GRAVITY = 9.81


@kernel
def rod(rec, ctl, fr, g, gtt, Gf):
    """Half the square of the distance from the world origin less that of the length."""
    for e in range(rec.size):
        b = rec[e]
        r = b["row"]
        f = fr[b["i"]]
        s = -0.5 * b["length"] * b["length"]
        u = 0.0
        for k in range(3):
            x = f["r"][k]
            s += 0.5 * x * x
            Gf[r, 0, k] = x
            u += f["tw"][k] * f["tw"][k] + x * f["ac"][k]
        g[r] = s
        gtt[r] = u
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, _, g, _ = constraint_args(ctl)
    _, _, gtt, Gf = constraint_rates(c)
    return rod(view(rec, n, RECORD), c, fr, g, gtt, Gf)


def pendulum(rows=1):
    """Unit mass on a unit rod from x = -1, y = 0 at rest; the row may be there several times."""
    registry.register(KIND)
    along_x = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    along_y = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    bodies = [
        Body(motion=PRISMATIC, axes=along_x, mass=0.0, name="slide"),
        Body(motion=PRISMATIC, parent=1, axes=along_y, mass=1.0, name="mass"),
    ]
    weight = np.zeros(1, force.RECORD)
    weight["i"], weight["value"] = 2, 1.0
    weight["F"][0, 1] = -GRAVITY
    records = np.zeros(rows, RECORD)
    records["i"], records["length"] = 2, 1.0
    system = assemble(bodies, {"force": weight}, {"rod": records})
    state = system.initial_state()
    state.q[:] = (-1.0, 0.0)
    return system, state
