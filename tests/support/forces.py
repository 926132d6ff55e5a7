# SPDX-License-Identifier: Apache-2.0
"""Checks that every force element passes, on bodies in a tree, on ground and on the fast path."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pitchpoint.multibody.bodies import FREE, TORSION, Body
from pitchpoint.multibody.joints import FLOATING, SPHERICAL
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import differences, frame, positive

#: Pairs of bodies of `mechanism`: a round one, one on ground, two of a chain, neighbours on one parent.
ENDS = [(1, 0), (2, 0), (1, 2), (2, 3), (4, 3), (3, 0)]


def swapped(record):
    """The same element with its two bodies in the other order."""
    other = record.copy()
    other["i"], other["j"] = record["j"], record["i"]
    for name in ("p", "A"):
        if f"{name}_i" in record.dtype.names:
            other[f"{name}_i"], other[f"{name}_j"] = record[f"{name}_j"], record[f"{name}_i"]
    return other


def mechanism(rng, states=0, places=None):
    """A round body, a tumbling one, and two that hang on the latter; then hidden bodies for states."""
    places = 0.3 * rng.normal(size=(4, 3)) if places is None else places
    spread = [positive(rng, 3) for _ in range(4)]
    common = [
        {
            "position": places[k],
            "axes": frame(rng),
            "mass": 1.0 + k,
            "com": 0.1 * rng.normal(size=3),
            "inertia": np.trace(spread[k]) * np.eye(3) - spread[k],
        }
        for k in range(4)
    ]
    round_one = {"mass": 1.0, "polar_inertia": 0.2, "transverse_inertia": 0.15, "center": 0.05}
    round_one |= {key: common[0][key] for key in ("position", "axes")}
    bodies = [
        Body(motion=FREE, name="round", **round_one),
        Body(motion=FLOATING, name="base", **common[1]),
        Body(motion=SPHERICAL, parent=2, name="arm", **common[2]),
        Body(motion=TORSION, parent=2, name="wheel", **common[3]),
    ]
    return bodies + [Body(motion=TORSION, polar_inertia=1.0, name=f"state{k}") for k in range(states)]


def shafts(rng, states=0):
    """A round body and a carrier with two planets, one upside down; all axes nearly parallel."""
    flip = np.diag([1.0, -1.0, -1.0])
    inertia = {"mass": 1.0, "polar_inertia": 0.2, "transverse_inertia": 0.15}
    places = 0.3 * rng.normal(size=(4, 3))
    bodies = [
        Body(motion=FREE, position=places[0], name="shaft", **inertia),
        Body(motion=TORSION, position=places[1], name="carrier", **inertia),
        Body(motion=TORSION, parent=2, position=places[2], name="planet", **inertia),
        Body(motion=TORSION, parent=2, position=places[3], axes=flip, name="other", **inertia),
    ]
    return bodies + [Body(motion=TORSION, polar_inertia=1.0, name=f"state{k}") for k in range(states)]


def moving(system, rng, size=0.4, tilt=None):
    """State with displacements, rates and accelerations in all coordinates."""
    state = system.initial_state()
    n = system.sizes["nd"]
    state.q, state.v, state.a = size * rng.normal(size=n), rng.normal(size=n), rng.normal(size=n)
    if tilt is not None:
        for k, name in enumerate(system.layout.coordinates):
            if name.rsplit(".", 1)[1] in ("alpha", "beta"):
                state.q[k] *= tilt / size
                state.v[k] *= tilt
    return state


def check_matrices(system, state, most=1e-7, step=1e-6):
    """Exact M, D and K against central differences; `most` is the error over the largest entry."""
    for found, key in zip(evaluate.linearize(system, state), "avq", strict=True):
        wanted = differences(system, state, key, 1.0 if key == "a" else step)  # linear in a
        error = np.abs(found - wanted).max()
        assert error <= most * max(1.0, np.abs(wanted).max()), (key, error, np.abs(wanted).max())


def wrenches(system, state):
    """Wrenches of the elements alone on all bodies, ground first, about their origins; shape (nb, 6)."""
    evaluate.residual(system, state)
    with_elements = system.workspace.fr["F"].copy()
    guides = {kind: system.records[kind] for kind in ("guide",) if kind in system.records}
    bare = assemble(system.bodies, guides, pools={kind: system.pools[kind] for kind in guides})
    order = [system.layout.coordinate(name) for name in bare.layout.coordinates]  # it may be another one
    q, v, a = (x[order] for x in (state.q, state.v, state.a))
    evaluate.residual(bare, replace(state, q=q, v=v, a=a))
    found = with_elements - bare.workspace.fr["F"]
    found[0] = with_elements[0]
    return found


def check_balance(system, state, scale=1.0):
    """Forces and moments on all bodies, ground too, have no resultant; hidden bodies do not count."""
    F = wrenches(system, state)
    fr = system.workspace.fr
    real = [k for k in range(F.shape[0]) if k == 0 or not system.bodies[k - 1].name.startswith("state")]
    # ground's accumulator holds what acts on it about its origin
    total = sum(F[k, :3] for k in real)
    moment = sum(F[k, 3:] + np.cross(fr["r"][k], F[k, :3]) for k in real)
    size = scale * max(1e-9, np.abs(F).max())
    np.testing.assert_allclose(total, 0.0, atol=1e-12 * size)
    np.testing.assert_allclose(moment, 0.0, atol=1e-12 * size)


def markers(system, record, state):
    """Places and axes of the two markers of a record, in the world."""
    wrenches(system, state)
    r, A = [], []
    for end in "ij":
        k = int(record[end][0])
        f = system.workspace.fr[k]
        S = f["S"] if k else np.eye(3)
        r.append(f["r"] + S @ record["p_" + end][0])
        A.append(S @ record["A_" + end][0])
    return r, A


def power(system, state):
    """Power of the elements on all bodies but ground and hidden ones [W]."""
    F = wrenches(system, state)
    fr = system.workspace.fr
    real = [k for k, body in enumerate(system.bodies, start=1) if not body.name.startswith("state")]
    return sum(F[k] @ fr["tw"][k] for k in real)


def moved_world(bodies, rng):
    """The same bodies after the world has been turned and moved: bodies, turn (3, 3)."""
    turn, shift = frame(rng), rng.normal(size=3)
    moved = [
        body
        if body.name.startswith("state")
        else replace(body, position=turn @ body.position + shift, axes=turn @ body.axes)
        for body in bodies
    ]
    return moved, turn, shift


def along(system, state, rate):
    """State a moment later along its rates: for time derivatives by differences."""
    later = state.copy()
    later.q = state.q + rate * state.v
    later.t = state.t + rate
    return later
