# SPDX-License-Identifier: Apache-2.0
"""Energy of rigid bodies and beams of a system at a state, and the power of internal damping, by NumPy."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System


def energy_of(system: System, state: State, gravity: float) -> tuple[float, float]:
    """Energy of motion, weight and beams [J], and power lost in the beams [W].

    `system` must not be that of a run, whose workspace would be overwritten.
    """
    evaluate.residual(system, state)
    total = loss = 0.0
    for body, f in zip(system.program["body"], system.workspace.fr, strict=True):
        if body["state"]:
            continue
        v, o, c = f["tw"][:3], f["tw"][3:], f["S"] @ body["com"]
        inertia = f["S"] @ body["inertia"] @ f["S"].T
        total += 0.5 * body["mass"] * v @ v + body["mass"] * v @ np.cross(o, c) + 0.5 * o @ inertia @ o
        total += body["mass"] * gravity * (f["r"] + c)[2]
    for b in system.records["beam"]:
        one = _beam(b)
        w, w1 = b["w"], b["w1"][:5]
        spins = np.array([b["omega"][k] @ w[3 + k] for k in range(2)])
        total += 0.5 * np.einsum("kl,ki,li->", b["M"], w1, w1) + 0.5 * spins @ b["polar"] @ spins
        total += gravity * (b["M"][:2] @ w[:5]).sum(axis=0)[2] + one[0]
        loss += one[1]
    return float(total), float(loss)


def _beam(b: np.void) -> tuple[float, float]:
    """Strain energy of a beam and the power of its internal damping."""
    w, w1, eta, length = b["w"], b["w1"], b["eta"], b["length"]
    angle = math.atan2(np.linalg.norm(np.cross(w[3], w[4])), w[3] @ w[4])
    slopes, slopes1, bent1 = b["S"][0], b["S"][2], b["D"][2]
    u = b["ell"] - length + length * (angle**2 / 24.0 + slopes @ slopes / 40.0)
    u1 = (b["axial"] / b["k_u"] - u) / eta if eta else 0.0
    twist1 = b["m"] @ (b["omega"][1] - b["omega"][0])
    twist = b["torque"] / b["k_t"] - eta * twist1
    y, y1 = w[5:7] @ w[2], w1[5:7] @ w[2] + w[5:7] @ w1[2]
    stored = b["k_u"] * u**2 + b["k_t"] * twist**2 + b["k_d"] * angle**2 + b["k_s"] * slopes @ slopes
    stored += b["c_a"] * y @ y + 2.0 * b["c_b"] * y[0] * y[1]
    lost = b["k_u"] * u1**2 + b["k_t"] * twist1**2 + b["k_d"] * bent1 @ bent1 + b["k_s"] * slopes1 @ slopes1
    lost += b["c_a"] * y1 @ y1 + 2.0 * b["c_b"] * y1[0] * y1[1]
    return 0.5 * stored, eta * lost
