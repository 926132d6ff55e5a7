# SPDX-License-Identifier: Apache-2.0
"""Modes that a time step must resolve, weighted by their excitation through meshes, contacts and loads.

Finite-element bodies have modes far above all excitation; steps that resolve them would make runs hours long.
With an implicit method these modes respond quasi-statically, which is correct. A mode with the share s of the
excited response may have an error 1/s times larger; since the error is second order in the step, its weighted
frequency is f sqrt(s). Shares: of the strain energy of the mode in meshes, contacts and other nonlinear
springs; of the compliance of the loaded coordinates. Explicit methods must resolve every mode to be stable.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.elements.kind import FORCE, TORQUE
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.solvers.element_tangents import switched
from pitchpoint.system import evaluate
from pitchpoint.system.residual import NEWTON

if TYPE_CHECKING:
    from pitchpoint.solvers.initial_state.start import Start
    from pitchpoint.system.system import System

Array = NDArray[np.float64]

RIGID = 1e-3
"""Frequency over the highest frequency below which a mode counts as rigid, before squaring [1]."""


def counted_frequency(start: Start, explicit: bool = False) -> float:
    """Highest modal frequency [Hz] at the start of a run, weighted by the root of the excited share.

    Parameters
    ----------
    start
        Start of the run.
    explicit
        Whether the method is explicit: all modes then have the weight 1.
    """
    system, state = start.system, start.state
    if not state.q.size:
        return 0.0
    M = evaluate.matrix(system, state, 1.0, 0.0, 0.0, NEWTON)
    K = evaluate.matrix(system, state, 0.0, 0.0, 1.0, NEWTON)
    if explicit or not any(registry.find(kind).fine for kind in system.records):
        values = np.linalg.eigvals(np.linalg.solve(M, K)).real
        return float(np.sqrt(max(values.max(), 0.0)) / (2.0 * np.pi))
    root = np.linalg.inv(np.linalg.cholesky(0.5 * (M + M.T)))
    values, shapes = np.linalg.eigh(root @ (0.5 * (K + K.T)) @ root.T)
    shapes = root.T @ shapes
    omega = np.sqrt(np.maximum(values, 0.0))
    bends = omega > RIGID * omega[-1] * RIGID
    share = np.zeros(len(omega))
    for found in (_excited_energy(start, shapes), _loaded_compliance(system, shapes, omega, bends)):
        share = np.maximum(share, found)
    if not share.any():  # excited by drives, base motion or release only
        share = values
    weight = np.sqrt(np.clip(share / np.where(bends, values, np.inf), 0.0, 1.0))
    return float((omega * weight).max() / (2.0 * np.pi))


def _excited_energy(start: Start, shapes: Array) -> Array:
    """Twice the strain energy of every mode in nonlinear elements."""
    system, state = start.system, start.state
    parts = []
    for on in ({kind: slice(None) for kind in system.records if registry.find(kind).excites}, {}):
        with switched(system, on):
            parts.append(evaluate.matrix(system, state, 0.0, 0.0, 1.0, NEWTON))
    excited = 0.5 * (parts[0] + parts[0].T) - 0.5 * (parts[1] + parts[1].T)
    return np.asarray(np.einsum("ik,ij,jk->k", shapes, excited, shapes))


def _ends(system: System, role: str) -> set[int]:
    """Indices of the bodies, without ground, on which loads of a role act."""
    return {int(r[end]) for r in system.rows(role) for end in "ij"} - {0}


def _loaded_compliance(system: System, shapes: Array, omega: Array, bends: NDArray[np.bool_]) -> Array:
    """Largest share of every mode in the compliance of a loaded coordinate, times its omega^2.

    A torque loads the spin of its body, a force may load any coordinate of its body.
    """
    body = system.program["body"]
    spins = {spin_of(body, b) for b in _ends(system, TORQUE)}
    pushed = set()
    for b in _ends(system, FORCE):
        while b:  # its own or shared coordinates, else those of the body it is mounted on
            owner = body[int(body[b]["shares"]) or b]
            pushed |= set(range(int(owner["dof"]), int(owner["dof"]) + int(owner["n"])))
            b = int(body[b]["parent"]) if body[b]["n"] == 0 else 0
    found = np.zeros(len(omega))
    for k in sorted({s for s in spins if s >= 0} | pushed):
        compliance = np.where(bends, shapes[k] ** 2 / np.where(bends, omega, 1.0) ** 2, 0.0)
        whole = float(compliance.sum())
        if whole > 0.0:
            found = np.maximum(found, compliance / whole * omega**2)
    return found
