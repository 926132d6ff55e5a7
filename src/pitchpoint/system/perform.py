# SPDX-License-Identifier: Apache-2.0
"""The one kernel through which Python asks a system questions.

Every kernel that Python calls is linked and optimised together with all that it calls. One door for all
questions makes that happen once instead of five times: a quarter of the cold start.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.bodies import BODY
from pitchpoint.multibody.channels import CTL, F8, FRAME
from pitchpoint.multibody.kinematics import rest_pose
from pitchpoint.system.linear import solve_acceleration
from pitchpoint.system.residual import evaluate_events, observe, residual, wrap
from pitchpoint.system.workspace import MACH

#: Questions.
REST, RESIDUAL, OBSERVE, EVENTS, ACCELERATE, WRAP = range(6)


@kernel
def perform(at, question, t, jac, cm, cd, ck, where):
    """Answer one question about the state in the workspace.

    REST: write what never changes. RESIDUAL: residual and matrix (jac, cm, cd, ck). OBSERVE, EVENTS: fill the
    array at `where`. ACCELERATE: accelerations and multipliers (ck = rate that pulls constraints back).
    WRAP: bring spins into (-pi, pi].
    """
    if question == RESIDUAL:
        return residual(at, t, jac, cm, cd, ck)
    if question == OBSERVE:
        return observe(at, t, where)
    if question == EVENTS:
        return evaluate_events(at, t, where)
    if question == ACCELERATE:
        return solve_acceleration(at, t, ck)
    if question == WRAP:
        wrap(at)
        return OK
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nb = c["nb"]
    rest_pose(view(m["body"], nb, BODY), view(c["fr"], nb, FRAME), view(m["J"], (m["npath"], 6, 6), F8))
    return OK


def ask(
    at: int,
    question: int,
    t: float = 0.0,
    jac: int = 0,
    factors: tuple[float, float, float] = (0.0, 0.0, 0.0),
    where: int = 0,
) -> int:
    """Call `perform` with plain numbers; returns its status."""
    cm, cd, ck = factors
    return int(
        perform(int(at), int(question), float(t), int(jac), float(cm), float(cd), float(ck), int(where))
    )
