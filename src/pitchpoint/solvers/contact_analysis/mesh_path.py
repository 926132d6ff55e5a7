# SPDX-License-Identifier: Apache-2.0
"""Forces of one mesh at given mesh phases and approaches, evaluated by the element that simulations use.

Unlike `flank_states` this covers every level of contact and the stiffness laws of tooth pairs.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import address, call, invoke, kernel, view
from pitchpoint.core.status import DIVERGED, OK, sentence
from pitchpoint.elements import registry
from pitchpoint.multibody.channels import CTL, F8, FRAME
from pitchpoint.system.link import link
from pitchpoint.system.rules.gear_mesh import mesh_alone

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

POSITION = np.dtype(
    [
        ("phi", "f8", 2),  # spins of both gears [rad]
        ("torque", "f8", 2),  # results: torques on both gears [N m]
        ("stiffness", "f8"),  # torsional stiffness of gear 1 [N m/rad]
        ("status", "i8"),
    ],
    align=True,
)
"""One position of both gears."""

RUN = np.dtype(
    [
        ("entry", "i8"),  # address of the entry of the element
        ("record", "i8"),
        ("ctl", "i8"),
        ("frames", "i8"),
        ("tangents", "i8"),
        ("positions", "i8"),  # addresses of its arguments and of the positions
    ],
    align=True,
)
"""Arguments of `evaluate_positions`."""

_STEPS = 60
"""Maximum number of steps to the approach of a force; five to eight are needed."""
_CONVERGED = 1e-10
"""Error of the force, relative."""
_REPEATS = 3


@kernel
def evaluate_positions(_, where, n):
    """Evaluate forces and tangents of a mesh at n positions in their order; `where`: address of a `RUN`."""
    run = view(where, 1, RUN)[0]
    frames = view(run["frames"], 2, FRAME)
    tangents = view(run["tangents"], (4, 6, 6), F8)
    positions = view(run["positions"], n, POSITION)
    worst = OK
    for k in range(n):
        at = positions[k]
        for body in range(2):
            frames[body]["phi"] = at["phi"][body]
            for row in range(6):
                frames[body]["F"][row] = 0.0
        tangents[0, 5, 5] = 0.0
        status = call(run["entry"], run["ctl"], run["record"], 1)
        at["status"] = status
        worst = max(worst, status)
        for body in range(2):
            at["torque"][body] = frames[body]["F"][5]
        at["stiffness"] = tangents[0, 5, 5]
    return worst


class MeshPath:
    """One flank of a mesh on fixed axes at the centre distance and misalignment of the model, at rest.

    Parameters
    ----------
    model
        The model; bodies, loads and a prescribed transmission error are not used.
    mesh
        Name of the mesh.
    flank
        1: front flanks (gear 1 drives counter-clockwise), -1: back flanks.
    """

    def __init__(self, model: Model, mesh: str, flank: int = 1) -> None:
        began = time.perf_counter()
        self.mesh, self.flank = mesh, flank
        bank = mesh_alone(model, mesh)
        assert bank.pool is not None
        self._records, self._pool = bank.records, bank.pool
        link({bank.kind: self._records}, {bank.kind: self._pool}, {})
        self.setup_s = time.perf_counter() - began
        record = self._records[0]
        for name, value in zip(("i", "j", "ii", "ij", "ji", "jj"), (0, 1, 0, 1, 2, 3), strict=True):
            record[name] = value
        record["n_e"] = record["n_e1"] = record["n_e2"] = 0
        part, pair = model.meshes[mesh], model.pairs[mesh]
        if part.misalignment is not None:
            # the fast path of gears that only spin has no tilt
            record["skew"], record["fixed"] = part.misalignment.skew, 0
        self.radii = float(record["r_b1"]), float(record["r_b2"])
        self._frames, self._ctl, self._kk = np.zeros(2, FRAME), np.zeros(1, CTL), np.zeros((4, 6, 6))
        self._frames["R"] = np.eye(3)
        self._frames["r"][1] = abs(pair.a_w), 0.0, part.offset1 - part.offset2
        ctl = self._ctl
        ctl["fr"], ctl["nb"] = self._frames.ctypes.data, 2
        ctl["kk"], ctl["np"] = self._kk.ctypes.data, 4
        ctl["jac"], ctl["ck"] = 1, 1.0
        self._run = np.zeros(1, RUN)
        self._run["record"], self._run["ctl"] = self._records.ctypes.data, ctl.ctypes.data
        self._run["frames"], self._run["tangents"] = self._frames.ctypes.data, self._kk.ctypes.data
        self._run["entry"] = address(registry.find(bank.kind).entry)

    def forces(self, phase: ArrayLike, approach: ArrayLike) -> tuple[Array, Array]:
        """Forces [N] and tangent stiffness [N/m] along the base tangent at mesh phases and approaches.

        Parameters
        ----------
        phase
            Mesh phases [base pitches], shape (n,); 0 when a pair reaches A in the middle of the face.
        approach
            Penetration of unmodified flanks at the pitch point along the base tangent [m], shape (n,).

        Raises
        ------
        SolverError
            If the mesh cannot be evaluated at a position.
        """
        psi, x = (np.asarray(v, dtype=np.float64).ravel() for v in np.broadcast_arrays(phase, approach))
        record = self._records[0]
        now = record["now"]
        start, xi = (0, record["xi_0"]) if self.flank > 0 else (1, record["xi_b"])
        travel = self.flank * ((psi - now["start"][start]) * record["p_bt"] - xi)
        u = self.flank * (x + 0.5 * now["gap"]) - record["u0"] - record["tan_b"] * now["dz"]
        at = np.zeros(psi.size, POSITION)
        at["phi"] = np.column_stack([0.5 * u + travel, 0.5 * u - travel]) / self.radii
        self._run["positions"] = at.ctypes.data
        began = time.perf_counter()
        status = invoke(evaluate_positions, 0, self._run.ctypes.data, at.size)
        self.last_s = time.perf_counter() - began
        if status != OK:
            k = int(np.argmax(at["status"] != OK))
            raise SolverError(f"mesh {self.mesh}, mesh phase {psi[k]:.4f}: {sentence(status)}", status)
        # the torques by the change of energy with the mean travel are opposite
        force = -0.5 * self.flank * (at["torque"] / self.radii).sum(axis=1)
        return force, at["stiffness"] / self.radii[0] ** 2

    def approaches(self, phase: ArrayLike, force: float, start: ArrayLike) -> Array:
        """Approaches at which the flanks carry a force, shape (n,) [m].

        Parameters
        ----------
        phase
            Mesh phases, shape (n,).
        force
            Force along the base tangent [N].
        start
            Estimates [m], scalar or shape (n,).

        Raises
        ------
        SolverError
            If there is no solution.
        """
        psi = np.asarray(phase, dtype=np.float64)
        x = np.array(np.broadcast_to(start, psi.shape), dtype=np.float64)
        low, high = np.full(psi.shape, -np.inf), np.full(psi.shape, np.inf)
        for _ in range(_STEPS):
            found, slope = self.forces(psi, x)
            if np.all(np.abs(found - force) <= _CONVERGED * force) or np.all(high - low <= 1e-15):
                return x
            low, high = np.where(found < force, x, low), np.where(found >= force, x, high)
            with np.errstate(divide="ignore", invalid="ignore"):
                step = x + (force - found) / slope
            between = np.where(np.isfinite(low + high), 0.5 * (low + high), x + np.sign(force - found) * 2e-5)
            x = np.where(np.isfinite(step) & (step > low) & (step < high), step, between)
        raise SolverError(f"mesh {self.mesh}: no approach with a force of {force:.6g} N", DIVERGED)

    def evaluation_time(self, phase: ArrayLike, approach: ArrayLike) -> float:
        """Wall time of one evaluation of force and tangent along the given positions [s], best of three."""
        times = []
        for _ in range(_REPEATS):
            self.forces(phase, approach)
            times.append(self.last_s)
        return min(times) / max(np.size(phase), 1)
