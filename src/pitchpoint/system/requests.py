# SPDX-License-Identifier: Apache-2.0
"""Single kernel for all evaluations of one state that Python requests.

Time and factors are passed in the control record, so that the kernel has the signature of an entry and
requires no wrapper.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.core.kernel import invoke, kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.bodies import BODY
from pitchpoint.multibody.channels import CTL, F8, FRAME
from pitchpoint.multibody.kinematics import rest_pose
from pitchpoint.system.linear import solve, solve_acceleration
from pitchpoint.system.residual import evaluate_events, observe, residual, wrap
from pitchpoint.system.workspace import MACH

if TYPE_CHECKING:
    from pitchpoint.system.workspace import Workspace

#: Codes of the evaluations.
REST, RESIDUAL, OBSERVE, EVENTS, ACCELERATE, WRAP, SOLVE = range(7)


@kernel
def handle_request(at, request, where):
    """Evaluate the state in the workspace, with time and factors of the control record; returns the status.

    REST: write constant values. RESIDUAL: residual and matrix (jac, cm, cd, ck). OBSERVE, EVENTS: fill the
    array at `where`. ACCELERATE: accelerations and multipliers (ck = stabilisation rate of the constraints).
    WRAP: wrap spins to (-pi, pi]. SOLVE: correction of residual and rows with the present factors.
    """
    c = view(at, 1, CTL)[0]
    t = c["t"]
    if request == RESIDUAL:
        return residual(at, t, c["jac"], c["cm"], c["cd"], c["ck"])
    if request == OBSERVE:
        return observe(at, t, where)
    if request == EVENTS:
        return evaluate_events(at, t, where)
    if request == ACCELERATE:
        return solve_acceleration(at, t, c["ck"])
    if request == WRAP:
        wrap(at)
        return OK
    if request == SOLVE:
        solve(at)
        return OK
    m = view(c["mach"], 1, MACH)[0]
    nb = c["nb"]
    rest_pose(view(m["body"], nb, BODY), view(c["fr"], nb, FRAME), view(m["J"], (m["npath"], 6, 6), F8))
    return OK


def send_request(
    workspace: Workspace,
    request: int,
    t: float = 0.0,
    jac: int = 0,
    factors: tuple[float, float, float] = (0.0, 0.0, 0.0),
    where: int = 0,
    entry: Any = handle_request,
) -> int:
    """Set the control record and call `handle_request` or another entry; returns the status."""
    ctl = workspace.ctl[0]
    ctl["t"], ctl["jac"] = t, jac
    ctl["cm"], ctl["cd"], ctl["ck"] = factors
    return invoke(entry, workspace.at, request, int(where))
