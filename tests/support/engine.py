# SPDX-License-Identifier: Apache-2.0
"""Small systems made from numbers, for tests of the compiled core."""

from __future__ import annotations

import numpy as np

from pitchpoint.elements import bearing, coupling, damping, ratio, torque
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble


def frame(rng):
    """Random right-handed frame."""
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    if np.linalg.det(q) < 0.0:
        q[:, 0] *= -1.0
    return q


def positive(rng, n=6):
    """Random symmetric positive definite matrix."""
    b = rng.normal(size=(n, n))
    return b @ b.T + 0.1 * np.eye(n)


def couplings(rows):
    """Coupling records from rows (i, j, stiffness, damping, gap)."""
    records = np.zeros(len(rows), coupling.RECORD)
    for record, (i, j, k, d, gap) in zip(records, rows, strict=True):
        record["i"], record["j"], record["k"], record["d"], record["gap"] = i, j, k, d, gap
    return records


def torques(rows):
    """Constant torques from rows (body, value)."""
    records = np.zeros(len(rows), torque.RECORD)
    for record, (i, value) in zip(records, rows, strict=True):
        record["i"], record["value"] = i, value
    return records


def gear_rows(rows):
    """Rigid gear couplings from rows (i, j, z1, z2)."""
    records = np.zeros(len(rows), ratio.RECORD)
    records["q_i"] = records["q_j"] = records["q_k"] = ratio.SPIN
    for record, (i, j, z1, z2) in zip(records, rows, strict=True):
        record["i"], record["j"], record["c_i"], record["c_j"] = i, j, z1, z2
    return records


def bearings(rows):
    """Bearings to ground or between bodies from rows (i, j, K, D)."""
    records = np.zeros(len(rows), bearing.RECORD)
    records["B"] = np.eye(3)
    for record, (i, j, K, D) in zip(records, rows, strict=True):
        record["i"], record["j"], record["K"], record["D"] = i, j, K, D
    return records


def chain(inertias, stiffnesses, **kinds):
    """Torsional chain, spring k between body k and k + 1."""
    bodies = [Body(polar_inertia=inertia, name=f"disc{k}") for k, inertia in enumerate(inertias)]
    rows = [(k + 1, k + 2, stiffness, 0.0, 0.0) for k, stiffness in enumerate(stiffnesses)]
    return assemble(bodies, {"coupling": couplings(rows), **kinds})


def rattle(gap=1e-3, moment=100.0, damping=5.0):
    """Two discs with backlash between them, pressed together."""
    bodies = [Body(polar_inertia=0.0115, name="a"), Body(polar_inertia=0.0115, name="b")]
    banks = {
        "coupling": couplings([(1, 2, 2e6, damping, gap)]),
        "torque": torques([(1, moment), (2, -moment)]),
    }
    return assemble(bodies, banks)


def rotor(k_tilt=0.0, mass=2.0, i_p=0.3, i_t=0.2, **more):
    """One free body on a bearing that is soft in nothing but what is given."""
    K = np.diag([1e6, 1e6, 1e6, k_tilt, k_tilt, 0.0])
    body = Body(motion=FREE, mass=mass, polar_inertia=i_p, transverse_inertia=i_t, name="rotor", **more)
    return assemble([body], {"bearing": bearings([(1, 0, K, np.zeros((6, 6)))])})


def frequencies(M, K):
    """Natural frequencies [Hz] of an undamped system, ascending."""
    squares = np.linalg.eigvals(np.linalg.solve(M, K)).real
    return np.sqrt(np.sort(np.where(squares > 0.0, squares, 0.0))) / (2.0 * np.pi)


def differences(system, state, key, step=1e-6):
    """Derivative of the residual by central differences over q, v or a."""
    n = system.sizes["nd"]
    found = np.zeros((n, n))
    for c in range(n):
        sides = []
        for sign in (1.0, -1.0):
            moved = state.copy()
            getattr(moved, key)[c] += sign * step
            sides.append(evaluate.residual(system, moved))
        found[:, c] = (sides[0] - sides[1]) / (2.0 * step)
    return found


def damping_records(D, dofs):
    """Cut a dense damping matrix into records; dofs are first coordinate and number of each body."""
    least = 1e-14 * np.abs(D).max(initial=0.0)
    rows = []
    for i, (di, ni) in enumerate(dofs):
        for j, (dj, nj) in enumerate(dofs):
            block = D[di : di + ni, dj : dj + nj]
            if np.abs(block).max(initial=0.0) > least:
                record = np.zeros((), damping.RECORD)
                record["i"], record["j"] = i, j
                record["D"][:ni, :nj] = block
                rows.append(record)
    return np.array(rows, damping.RECORD).reshape(-1)
