# SPDX-License-Identifier: Apache-2.0
"""Tables of the elastic potential of a mesh from its flexible contact."""

from __future__ import annotations

import copy
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.potential_build import (
    NominalValues,
    Runner,
    build_potential_table,
    one_after_another,
)
from pitchpoint.contact.potential_fit import PAIR_FORCE
from pitchpoint.contact.potential_range import TableRange, TableSize
from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT, OK, sentence
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.load_checks import (
    deflection_problem,
    flank_problem,
    misalignment_problem,
    refuse,
    torque_problem,
)

if TYPE_CHECKING:
    from pitchpoint.contact.potential_fit import PotentialTable
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

FURTHER = {
    "friction_force": "1",
    "path_before": "m",
    "path_beyond": "m",
    "width_before": "m",
    "width_beyond": "m",
}
"""Further quantities of a table, before the forces of the pairs: unit of their ratio to the force."""
_MARGIN = 1.15
"""Highest approach of a table over the highest of the scan."""
_SCAN = 32
"""Phases of the scan for the range of the approach."""


@dataclass(frozen=True, kw_only=True)
class TableRequest:
    """What a table must cover.

    Parameters
    ----------
    torque
        Highest torque on gear 1 [N m].
    misalignment
        Largest misalignment in the plane of action, either sign [rad]; None: that of the housing.
    centre_distance
        Largest deviation of the centre distance from that of the model, either sign [m].
    """

    torque: float
    misalignment: float | None = None
    centre_distance: float = 0.0

    def __post_init__(self) -> None:
        """Check torque and misalignment; `TableRange` checks the rest."""
        refuse(torque_problem(self.torque, several=False), misalignment_problem(self.misalignment))


class PotentialEvaluator:
    """Potential of one flank and its derivatives by the coordinates of a table, for `build_potential_table`.

    Parameters
    ----------
    model, mesh
        Model and mesh with flexible contact.
    flank
        1: front flanks, -1: back flanks.
    """

    def __init__(self, model: Model, mesh: str, flank: int) -> None:
        self.flanks = FlankStates(model, mesh, flank)
        record = self.flanks.record
        now = record["now"]
        self.pitch = float(record["p_bt"])
        self.radii = float(record["r_b1"]), float(record["r_b2"])
        self.pairs = int(record["n_pair"])
        self.middle = 0.5 * float(now["z_lo"] + now["z_hi"])
        self.lean = flank * float(record["tan_b"]) / self.pitch * self.middle

    def copy(self) -> PotentialEvaluator:
        """Independent copy for another thread."""
        own = copy.copy(self)
        own.flanks = self.flanks.copy()
        return own

    def placed(self, states: Array) -> NDArray[np.void]:
        """States of the flank at rows (phase, approach, misalignment, centre distance), shape (n, 4)."""
        s, x, kappa, a = states.T
        found = self.flanks.states(s - self.lean)
        found["kappa"], found["distance"] = kappa, np.copysign(a, self.flanks.distance)
        found["x_0"] = x + kappa * self.middle
        return found

    def __call__(self, states: Array) -> Array:
        """Potential, its four derivatives, and further quantities at states of shape (n, 4), (n, 5 + more).

        Raises
        ------
        SolverError
            If a state has no solution.
        """
        placed = self.placed(states)
        nodes = self.flanks.solve(placed, keep_nodes=True)
        assert nodes is not None
        if placed["status"].max() != OK:
            bad = int(np.argmax(placed["status"] != OK))
            status = int(placed["status"][bad])
            place = ", ".join(f"{v:.6g}" for v in states[bad])
            raise SolverError(
                f"mesh {self.flanks.mesh}: no contact state at {place} (phase, approach, misalignment, "
                f"centre distance): {sentence(status)}",
                status,
            )
        r_1, r_2 = self.radii
        a = placed["distance"]
        sin = np.sqrt(1.0 - ((r_1 + r_2) / a) ** 2)
        by_s = self.flanks.flank * placed["by_travel"] * self.pitch
        by_xi = by_s / self.pitch
        by_tan = placed["by_tan"] - (-0.5 * (r_1 - r_2) * sin**2 - r_2) * by_xi
        by_a = np.sign(a) * by_tan / ((r_1 + r_2) * sin)
        by_kappa = self.middle * placed["force"] - placed["moment"]
        held = np.arange(nodes.shape[1]) < placed["n_nodes"][:, None]
        force = np.where(held, nodes["elastic"], 0.0)
        xi = nodes["xi"]
        z = nodes["z"] - self.middle
        before, beyond = force * np.heaviside(-xi, 0.5), force * np.heaviside(xi, 0.5)
        pair = nodes["pair"] % self.pairs
        columns = [
            placed["energy"],
            by_s,
            placed["force"],
            by_kappa,
            by_a,
            np.sum(beyond - before, axis=1),
            *(np.sum(part * place, axis=1) for place in (xi, z) for part in (before, beyond)),
            *(np.sum(np.where(pair == k, force, 0.0), axis=1) for k in range(self.pairs)),
        ]
        return np.column_stack(columns)


def quantities(pairs: int) -> dict[str, str]:
    """Unit of the ratio of every further quantity to the force, by name."""
    return {**FURTHER, **{f"{PAIR_FORCE}{k}": "1" for k in range(pairs)}}


def table_span(evaluator: PotentialEvaluator, request: TableRequest) -> TableRange:
    """Range of a table: approaches from first contact to the highest torque, by a scan over all other axes.

    Raises
    ------
    SolverError
        If a state of the scan has no solution, or the deflection is above `MAX_DEFLECTION`.
    """
    flanks = evaluator.flanks
    phase = np.arange(_SCAN) / _SCAN
    low, high = math.inf, 0.0
    nominal = abs(flanks.distance)
    tilt = abs(flanks.misalignment) if request.misalignment is None else request.misalignment
    for delta in _three(request.centre_distance):
        for kappa in _three(tilt):
            rows = np.column_stack(
                [phase, np.zeros(_SCAN), np.full(_SCAN, kappa), np.full(_SCAN, nominal + delta)]
            )
            placed = evaluator.placed(rows)
            placed["by_force"], placed["force"] = 1, flanks.force_of(request.torque)
            flanks.solve(placed)
            if placed["status"].max() != OK:
                raise SolverError(
                    f"mesh {flanks.mesh}: no contact state at {request.torque:g} N m: "
                    f"{sentence(int(placed['status'].max()))}",
                    int(placed["status"].max()),
                )
            shift = kappa * evaluator.middle
            low = min(low, float(placed["first"].min()) - shift)
            high = max(high, float(placed["x_0"].max()) - shift)
    m_n = flanks.model.gears[flanks.model.meshes[flanks.mesh].gears[0]].geometry.m_n
    refuse(deflection_problem(flanks.mesh, high - low, m_n, request.torque))
    return TableRange(
        approach=(low, low + _MARGIN * (high - low)),
        misalignment=tilt,
        centre_distance=(nominal - request.centre_distance, nominal + request.centre_distance),
        tolerances=(1e-6, 1e-6),
    )


def _three(half: float) -> tuple[float, ...]:
    return (0.0,) if half == 0.0 else (-half, 0.0, half)


def contact_table(
    model: Model,
    mesh: str,
    request: TableRequest,
    flank: int = 1,
    *,
    size: TableSize | None = None,
    run: Runner = one_after_another,
    progress: Progress = silent,
) -> PotentialTable:
    """Table of the elastic potential of one flank of a mesh with flexible contact.

    Parameters
    ----------
    model
        The model.
    mesh
        Name of the mesh.
    request
        What the table must cover.
    flank
        1: front flanks, -1: back flanks.
    size
        Number of points of the axes.
    run
        Execution of the tasks, as `build_potential_table`.
    progress
        Receiver of reports.

    Raises
    ------
    SolverError
        If the contact is not flexible, `flank` is not one, teeth of a gear differ from each other, or a state
        has no solution.
    """
    refuse(flank_problem(flank))
    _check(model, mesh)
    evaluator = PotentialEvaluator(model, mesh, flank)
    span = table_span(evaluator, request)
    pair = model.pairs[mesh]
    nominal = NominalValues(evaluator.flanks.force_of(request.torque), evaluator.pitch, pair.b_w)
    return build_potential_table(
        evaluator.copy,
        span,
        nominal,
        size,
        quantities(evaluator.pairs),
        run,
        progress,
    )


def _check(model: Model, mesh: str) -> None:
    """Raise SolverError if a mesh cannot be tabulated."""
    part = model.meshes[mesh]
    if part.contact is None or part.contact.level != "flexible":
        raise SolverError(
            f"mesh {mesh}: a table is computed from flexible contact; give it `contact: {{level: flexible}}`",
            INCONSISTENT,
        )
    differ = [gear for gear in part.gears if model.gears[gear].teeth_differ]
    if differ:
        raise SolverError(
            f"mesh {mesh}: the teeth of {' and '.join(differ)} differ from each other, and a table has one "
            "tooth pair; use flexible contact, or remove deviations and faults of single teeth",
            INCONSISTENT,
        )
