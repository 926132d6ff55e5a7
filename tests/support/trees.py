# SPDX-License-Identifier: Apache-2.0
"""Trees of bodies once more, by matrices and point masses: the oracle of the multibody tests."""

from __future__ import annotations

import numpy as np

from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import AXES, SCREW, TUMBLING
from pitchpoint.system import evaluate
from tests.support.engine import frame, positive


def tree(rng, motions, parents):
    """Bodies with random frames, places and masses."""
    return [
        Body(
            motion=motion,
            parent=parent,
            position=rng.normal(size=3),
            axes=frame(rng),
            mass=rng.uniform(0.5, 2.0),
            com=0.3 * rng.normal(size=3),
            inertia=positive_inertia(rng),
            lead=0.2 if motion == SCREW else 0.0,
            name=f"b{k}",
        )
        for k, (motion, parent) in enumerate(zip(motions, parents, strict=True), start=1)
    ]


def positive_inertia(rng):
    """Inertia that a mass can have."""
    spread = positive(rng, 3)
    return np.trace(spread) * np.eye(3) - spread


def moving(system, rng):
    state = system.initial_state()
    n = system.sizes["nd"]
    state.q, state.v, state.a = 0.6 * rng.normal(size=n), rng.normal(size=n), rng.normal(size=n)
    return state


def turning(angle, axis):
    """Matrix that turns about a coordinate axis."""
    c, s = np.cos(angle), np.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    found = np.eye(3)
    found[i, i] = found[j, j] = c
    found[i, j], found[j, i] = -s, s
    return found


def poses(bodies, q, dofs, charts):
    """Origin and attitude (axes fixed to the body) of every body, ground first."""
    found = [(np.zeros(3), np.eye(3))]
    tumbling = 0
    for body, dof in zip(bodies, dofs, strict=True):
        rest_r, rest_axes = np.zeros(3), np.eye(3)
        if body.parent:
            parent = bodies[body.parent - 1]
            rest_r, rest_axes = np.asarray(parent.position), np.asarray(parent.axes)
        r_p, S_p = found[body.parent]
        d = np.zeros(6)
        d[list(AXES[body.motion])] = q[dof : dof + len(AXES[body.motion])]
        if body.motion == SCREW:
            d[2] = body.lead * d[5]
        E = S_p @ rest_axes.T @ np.asarray(body.axes)
        r = r_p + S_p @ rest_axes.T @ (np.asarray(body.position) - rest_r) + E @ d[:3]
        C = np.eye(3)
        if body.motion in TUMBLING:
            C = charts[tumbling]
            tumbling += 1
        found.append((r, E @ C @ turning(d[3], 0) @ turning(d[4], 1) @ turning(d[5], 2)))
    return found


def cloud(body):
    """Point masses that have mass, centre of mass and inertia of a body, in its axes."""
    about = np.asarray(body.inertia, float)
    values, axes = np.linalg.eigh(0.5 * np.trace(about) * np.eye(3) - about)  # second moments
    reach = np.sqrt(np.maximum(values, 0.0) * 3.0 / body.mass)
    points = [body.com + sign * reach[k] * axes[:, k] for k in range(3) for sign in (1.0, -1.0)]
    return np.full(6, body.mass / 6.0), np.array(points)


def reference_residual(system, state, step=2e-3):
    """Generalised inertia forces of the point masses: sum of m p'' . dp/dq."""
    bodies = system.bodies
    dofs = system.program["body"]["dof"][1:]

    def places(q):
        frames = poses(bodies, q, dofs, state.charts)[1:]
        return np.concatenate([r + cloud(b)[1] @ S.T for b, (r, S) in zip(bodies, frames, strict=True)])

    weights = np.repeat([b.mass / 6.0 for b in bodies], 6)
    path = {k: places(state.q + k * step * state.v + 0.5 * (k * step) ** 2 * state.a) for k in range(-3, 4)}
    second = 270.0 * (path[1] + path[-1]) - 27.0 * (path[2] + path[-2]) + 2.0 * (path[3] + path[-3])
    second = (second - 490.0 * path[0]) / (180.0 * step**2)
    found = np.zeros(state.q.size)
    for k in range(state.q.size):
        unit = np.zeros(state.q.size)
        unit[k] = step
        near, far = (places(state.q + s * unit) - places(state.q - s * unit) for s in (1.0, 2.0))
        found[k] = np.einsum("p,pi,pi->", weights, second, (8.0 * near - far) / (12.0 * step))
    return found


def accelerated(system, state):
    """Frames after the accelerations of a state have been solved for."""
    evaluate.prepare(system)
    evaluate.load(system, state)
    w = system.workspace
    evaluate.check(system, evaluate.send_request(w, evaluate.ACCELERATE, state.t))
    evaluate.residual(system, evaluate.store(system, state.t))
    return w.fr.copy()
