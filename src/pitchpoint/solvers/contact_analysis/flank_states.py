# SPDX-License-Identifier: Apache-2.0
"""Static states of one flank of a mesh on fixed axes, solved in compiled code."""

from __future__ import annotations

import copy
import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import invoke
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.elements.mesh.record import SURFACE
from pitchpoint.elements.mesh.surface.nodes import NODE
from pitchpoint.elements.mesh.surface.states import STATE, solve_states
from pitchpoint.system.link import link
from pitchpoint.system.rules.gear_mesh import mesh_alone

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]


def housing_misalignment(model: Model, mesh: str, flank: int) -> float:
    """Misalignment of the flanks of a mesh by the housing of its model, in the plane of action [rad]."""
    tilt = model.meshes[mesh].misalignment
    return 0.0 if tilt is None else tilt.of_flanks(model.pairs[mesh].alpha_wt, flank)


class FlankStates:
    """One mesh with contact of tooth surfaces, on fixed parallel axes.

    Parameters
    ----------
    model
        The model; bodies and loads are not used.
    mesh
        Name of the mesh.
    flank
        1: front flanks (gear 1 drives counter-clockwise), -1: back flanks.

    Raises
    ------
    SolverError
        If the mesh has no contact of tooth surfaces.
    """

    def __init__(self, model: Model, mesh: str, flank: int = 1) -> None:
        self.model, self.mesh, self.flank = model, mesh, flank
        bank = mesh_alone(model, mesh)
        self.records = bank.records
        if self.record["source"] != SURFACE:
            raise SolverError(
                f"mesh {mesh} has no contact of tooth surfaces; give the mesh `contact: {{level: …}}`",
                INCONSISTENT,
            )
        assert bank.pool is not None
        self.kind, self.pool = bank.kind, bank.pool
        self.offset = float(self.record["now"]["dz"])
        self._link()

    def _link(self) -> None:
        link({self.kind: self.records}, {self.kind: self.pool}, {})

    def copy(self) -> FlankStates:
        """Independent copy for another thread."""
        own = copy.copy(self)
        own.records, own.pool = self.records.copy(), self.pool.copy()
        own._link()
        return own

    @property
    def record(self) -> np.void:
        """Record of the mesh."""
        return self.records[0]

    @property
    def distance(self) -> float:
        """Signed centre distance of the model [m]."""
        return self.model.pairs[self.mesh].a_w

    @property
    def misalignment(self) -> float:
        """Misalignment of the flanks by the housing of the model, in the plane of action [rad]."""
        return housing_misalignment(self.model, self.mesh, self.flank)

    def states(self, phase: ArrayLike) -> NDArray[np.void]:
        """States at given mesh phases [base pitches], shape (n,), at the place of the gears in the model.

        The phase is 0 when a pair starts contact at A in the middle of the common width. Centre distance,
        axial offset and misalignment are those of the model.
        """
        phase = np.asarray(phase, dtype=np.float64).ravel()
        found = np.zeros(phase.size, STATE)
        whole = np.floor(phase)
        found["record"], found["flank"] = self.records.ctypes.data, self.flank
        found["pairs"], found["psi"] = whole, phase - whole
        found["distance"], found["dz"], found["kappa"] = self.distance, self.offset, self.misalignment
        return found

    def solve(self, states: NDArray[np.void], keep_nodes: bool = False) -> NDArray[np.void] | None:
        """Solve states in place, in their order.

        Parameters
        ----------
        states
            States as from `states`, with x_0 or force set; each should be close to the one before.
        keep_nodes
            Whether to return the contact nodes, shape (n, max_nodes); the first n_nodes of a state are valid.
        """
        nodes = None
        if keep_nodes:
            nodes = np.zeros((states.size, int(self.record["max_nodes"])), NODE)
            states["nodes"] = nodes.ctypes.data + nodes.strides[0] * np.arange(states.size)
        invoke(solve_states, 0, states.ctypes.data, states.size)
        states["nodes"] = 0
        return nodes

    @property
    def widths(self) -> Array:
        """Middles of the contact planes from the pitch point along the axes [m], shape (planes,)."""
        now, n = self.record["now"], int(self.record["slices"])
        return np.asarray(now["z_lo"] + (np.arange(n) + 0.5) / n * (now["z_hi"] - now["z_lo"]))

    def force_of(self, torque: float) -> float:
        """Force along the base tangent of a torque on gear 1 [N]."""
        return abs(torque) / float(self.record["r_b1"])

    def period(self) -> float:
        """Base pitch in radians of gear 1."""
        return 2.0 * math.pi / int(self.record["z1"])


def under_load(states: NDArray[np.void], nodes: NDArray[np.void]) -> NDArray[np.bool_]:
    """Contact nodes under load, shape (n, max_nodes)."""
    used = np.arange(nodes.shape[1]) < states["n_nodes"][:, None]
    return np.asarray(used & (nodes["force"] > 0.0))
