# SPDX-License-Identifier: Apache-2.0
"""Mesh phases of flexible teeth for relief design: nodes, compliances and local contacts, computed once."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.hertz import half_width, peak_pressure, plane_strain_compliance
from pitchpoint.contact.unilateral_work import ContactWorkspace
from pitchpoint.core.kernel import invoke
from pitchpoint.elements.mesh.surface.nodes import ON_PATH
from pitchpoint.elements.mesh.surface.scratch import flexible_arrays
from pitchpoint.geometry.modification_terms import lead_gap, profile_gap
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.relief.design_states import (
    DESIGN,
    FOUND,
    PHASE,
    PLACED,
    solve_design,
)

Array = NDArray[np.float64]


class FlexiblePhases:
    """Mesh phases of a flank with flexible teeth, ready for any modifications.

    Parameters
    ----------
    flanks
        The mesh; its modifications are replaced.
    rows
        Modifications of the mesh (`geometry.modification_terms`), shape (2, N_TERM).
    places
        Mesh phases [base pitches], shape (phases,).
    misalignments
        Angles between the flanks in the plane of action [rad].
    approach
        Approach up to which nodes are considered [m]: maximum approach of any design.
    """

    def __init__(
        self, flanks: FlankStates, rows: Array, places: Array, misalignments: Array, approach: float
    ) -> None:
        self.shape = misalignments.size, places.size
        self._kept: list[NDArray[Any]] = []
        self.phases = np.zeros(self.shape, PHASE)
        for m, kappa in enumerate(misalignments):
            for p, place in enumerate(places):
                self._place(self.phases[m, p], flanks, rows, (float(place), float(kappa), approach))

    def _place(self, phase: Any, flanks: FlankStates, rows: Array, at: tuple[float, float, float]) -> None:
        """Store the nodes of one phase; `at`: mesh phase, misalignment, approach."""
        states = flanks.states(at[0])
        states["kappa"], states["x_0"] = at[1], at[2]
        nodes = flanks.solve(states, keep_nodes=True)
        assert nodes is not None
        n = int(states["n_nodes"][0])
        node = nodes[0, :n]
        placed = placed_nodes(flanks, node)
        placed["gap"] = at[2] - node["x"]
        record = flanks.record
        for gear in range(2):
            z = node["z"] + (float(record["w1"]) - gear) * float(record["now"]["dz"])
            placed["zeta"][:, gear] = z / (0.5 * float(record["b1"] if gear == 0 else record["b2"]))
            modified = profile_gap(rows[gear], placed["t"][:, gear]) + lead_gap(
                rows[gear], placed["zeta"][:, gear]
            )
            placed["gap"] -= modified
        _, local, C, *_ = flexible_arrays(record, n)
        kept = [placed, C.copy(), local.copy()]
        self._kept += kept
        phase["n"] = n
        phase["nodes"], phase["C"], phase["local"] = (array.ctypes.data for array in kept)

    @property
    def most(self) -> int:
        """Maximum number of nodes of a phase."""
        return int(self.phases["n"].max())


def placed_nodes(flanks: FlankStates, node: NDArray[np.void]) -> NDArray[np.void]:
    """Places on the profiles and what the pressures depend on; the other fields are 0.

    Parameters
    ----------
    flanks
        The mesh.
    node
        Contact nodes, any shape.

    Returns
    -------
    ndarray of PLACED, shape of `node`

    Notes
    -----
    Removed material h(L) over the length of roll L adds the curvature (r_b/L)² (h″ − h′/L) + h′ sin²β_b/L, as
    in `stepped_flanks`. The gaps are along the base tangent, h/cos β_b.
    """
    record = flanks.record
    width = float(record["now"]["z_hi"] - record["now"]["z_lo"]) / int(record["slices"])
    cos_b = 1.0 / math.sqrt(1.0 + float(record["tan_b"]) ** 2)
    materials = [flanks.model.gears[g].material_data for g in flanks.model.meshes[flanks.mesh].gears]
    soft = [plane_strain_compliance(m.youngs_modulus, m.poisson_ratio) for m in materials]
    placed = np.zeros(node.shape, PLACED)
    one, two = np.moveaxis(node["roll"], -1, 0)
    on_path = node["place"] == ON_PATH
    placed["edge"] = ~on_path
    with np.errstate(divide="ignore", invalid="ignore"):
        radius = one * two / (one + two) / cos_b
        press = peak_pressure(1.0 / width, half_width(1.0 / width, radius, *soft))
        placed["press"] = np.where(on_path & (radius > 0.0), press, 0.0)
        for gear, roll in enumerate((one, two)):
            low, high = record["roll"][gear]
            r_b = float(record[f"r_b{gear + 1}"])
            length = np.sign(r_b) * roll
            placed["t"][..., gear] = (length - low) / (high - low)
            scale, bent = radius * cos_b / (high - low), (r_b / length) ** 2
            placed["curved"][..., gear, 0] = np.nan_to_num(scale * (1.0 - cos_b**2 - bent) / length)
            placed["curved"][..., gear, 1] = np.nan_to_num(scale * bent / (high - low))
    return placed


class DesignSolver:
    """Solver of designs in one thread: workspace and results.

    Parameters
    ----------
    phases
        Nodes of the mesh, shared by all threads.
    loads
        Forces along the base tangent, increasing [N], shape (loads,).
    """

    def __init__(self, phases: FlexiblePhases, loads: Array) -> None:
        self.phases, self.loads = phases, loads
        most = phases.most
        self.work = ContactWorkspace.of(most)
        self.gaps = np.zeros((2, most))
        self.rows = np.zeros(0)
        count = phases.phases.size
        self.found = np.zeros((count, loads.size), FOUND)
        self.found["load"] = loads
        self.design = np.zeros(1, DESIGN)
        d = self.design[0]
        d["phases"], d["n_phase"] = phases.phases.ctypes.data, count
        d["found"], d["n_load"] = self.found.ctypes.data, loads.size
        d["gaps"], d["most"] = self.gaps.ctypes.data, most
        d["width"] = self.work.v.shape[1]
        for name in ("state", "on", "v", "U"):
            d[name] = getattr(self.work, name).ctypes.data

    def solve(self, rows: Array) -> NDArray[np.void]:
        """Results of a design at all phases and loads.

        Parameters
        ----------
        rows
            Modifications of both gears, shape (2, N_TERM).

        Returns
        -------
        ndarray of FOUND, shape (misalignments, loads, phases)
        """
        self.rows = np.ascontiguousarray(rows)
        self.design["rows"] = self.rows.ctypes.data
        invoke(solve_design, 0, self.design.ctypes.data, 1)
        cases, positions = self.phases.shape
        return self.found.reshape(cases, positions, self.loads.size).transpose(0, 2, 1).copy()
