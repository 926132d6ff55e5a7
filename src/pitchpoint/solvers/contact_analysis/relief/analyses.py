# SPDX-License-Identifier: Apache-2.0
"""Contact analyses of many designs of the modifications of one mesh, without compiling it again, in threads.

Each analysis starts anew, so that its numbers do not depend on the others, nor on the number of threads.
"""

from __future__ import annotations

import copy
import os
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT, OK, sentence
from pitchpoint.elements.mesh.surface.nodes import ON_PATH
from pitchpoint.geometry.modification_terms import N_TERM
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.load_checks import deflection_problem, refuse
from pitchpoint.solvers.contact_analysis.relief.curves import BEHIND, Curves
from pitchpoint.solvers.contact_analysis.relief.design_states import set_pressures
from pitchpoint.solvers.contact_analysis.relief.flexible_phases import (
    DesignSolver,
    FlexiblePhases,
    placed_nodes,
)

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Conditions:
    """What every design is analysed for.

    Parameters
    ----------
    torques
        Torques on gear 1 [N m], increasing.
    positions
        Mesh phases over one base pitch.
    misalignments
        Angles between the flanks in the plane of action [rad].
    flank
        1: front flanks (gear 1 drives counter-clockwise), -1: back flanks.
    """

    torques: tuple[float, ...]
    positions: int = 64
    misalignments: tuple[float, ...] = (0.0,)
    flank: int = 1

    @property
    def phases(self) -> Array:
        """Mesh phases, and as many close behind them for slopes, shape (2 positions,)."""
        place = (np.arange(self.positions) + 0.5) / self.positions
        return np.concatenate([place, place + BEHIND / self.positions])


class _Solver(Protocol):
    """Analyses in one thread."""

    def curves(self, rows: Array) -> Curves:
        """Analyse one design, rows of shape (2, N_TERM)."""


class Analyses:
    """Analyses of a mesh with any modifications of its loaded flanks.

    Parameters
    ----------
    model
        The model; the mesh has contact of tooth surfaces and one of its gears has modifications.
    mesh
        Name of the mesh.
    conditions
        Torques, phases, misalignments.
    rows
        Modifications of the model, shape (2, N_TERM).
    deepest
        Upper bound of the gap that modifications of any design add at a point of both flanks [m].
    jobs
        Number of threads; default one per core.

    Raises
    ------
    SolverError
        If the mesh has no contact of tooth surfaces or a pre-computed one, or the start has no solution or
        too large a deflection.
    """

    def __init__(
        self,
        model: Model,
        mesh: str,
        conditions: Conditions,
        rows: Array,
        deepest: float,
        jobs: int | None = None,
    ) -> None:
        self.jobs = jobs or os.cpu_count() or 1
        self._flanks = FlankStates(model, mesh, conditions.flank)
        if self._flanks.record["is_tabulated"] == 1:
            raise SolverError(
                f"mesh {mesh}: a pre-computed contact has its modifications in the table; "
                "use level: flexible for relief design",
                INCONSISTENT,
            )
        self._rows = rows
        self._approach = 0.0
        self._phases: FlexiblePhases | None = None
        self._set(conditions)
        if self._flanks.record["is_flexible"] == 1:
            approach = float(self._own().curves(rows).approach.max())
            m_n = model.gears[model.meshes[mesh].gears[0]].geometry.m_n
            refuse(deflection_problem(mesh, approach, m_n, max(conditions.torques)))
            self._approach = approach + deepest
            self._place()

    def under(self, conditions: Conditions) -> Analyses:
        """Analyses under other conditions, at torques not above those of this object."""
        before, other = self.conditions, copy.copy(self)
        other._set(conditions)
        if self._phases is not None and replace(conditions, torques=before.torques) != before:
            other._place()
        return other

    def _set(self, conditions: Conditions) -> None:
        """Set the conditions."""
        self.conditions = conditions
        self._loads = np.array([self._flanks.force_of(torque) for torque in conditions.torques])
        self._own_of = threading.local()

    def _place(self) -> None:
        """Compute the mesh phases of flexible teeth."""
        kappa = np.array(self.conditions.misalignments)
        self._phases = FlexiblePhases(self._flanks, self._rows, self.conditions.phases, kappa, self._approach)

    def _own(self) -> _Solver:
        """Solver for one thread."""
        if self._phases is not None:
            return _Flexible(DesignSolver(self._phases, self._loads))
        return _General(self._flanks, self.conditions, self._loads)

    @contextmanager
    def pool(self) -> Iterator[ThreadPoolExecutor]:
        """Threads for `curves_of`; analyses that have not begun are dropped at the end."""
        executor = ThreadPoolExecutor(self.jobs, thread_name_prefix="relief")
        try:
            yield executor
        finally:
            executor.shutdown(wait=True, cancel_futures=True)

    def curves_of(
        self, designs: Sequence[Array], pool: ThreadPoolExecutor, done: Callable[[], None] = lambda: None
    ) -> list[Curves]:
        """Analyse designs, rows of shape (2, N_TERM) each; results in their order, `done` after each."""
        futures: list[Future[Curves]] = [pool.submit(self.curves, rows) for rows in designs]
        found = []
        try:
            for future in futures:
                found.append(future.result())
                done()
            return found
        except BaseException:
            for future in futures:
                future.cancel()
            raise

    def curves(self, rows: Array) -> Curves:
        """Analyse one design, rows of shape (2, N_TERM), in the calling thread.

        Raises
        ------
        SolverError
            If a state has no solution.
        """
        solver: _Solver | None = getattr(self._own_of, "solver", None)
        if solver is None:
            solver = self._own_of.solver = self._own()
        return solver.curves(rows)


class _Flexible:
    """Flexible teeth."""

    def __init__(self, solver: DesignSolver) -> None:
        self.solver = solver

    def curves(self, rows: Array) -> Curves:
        """Analyse one design, rows of shape (2, N_TERM)."""
        found = self.solver.solve(rows)
        _check(found["status"])
        return Curves.of(found["approach"], found["pressure"], found["edge"])


class _General:
    """Any level: states of the mesh with its modifications replaced."""

    def __init__(self, flanks: FlankStates, conditions: Conditions, loads: Array) -> None:
        self.flanks = flanks = flanks.copy()
        record = flanks.record
        record["modified"] = 1
        record["sep_min"] = -record["p_bt"]  # below any modifications
        phase = conditions.phases
        self.shape = len(conditions.misalignments), loads.size, phase.size
        self.states = flanks.states(np.broadcast_to(phase, self.shape).copy())
        self.states["kappa"] = np.repeat(conditions.misalignments, loads.size * phase.size)
        self.states["force"] = np.tile(np.repeat(loads, phase.size), self.shape[0])

    def curves(self, rows: Array) -> Curves:
        """Analyse one design, rows of shape (2, N_TERM)."""
        flanks, record = self.flanks, self.flanks.record
        for gear in range(2):
            at = int(record["terms"][gear])
            flanks.pool[at : at + 2 * N_TERM] = np.tile(rows[gear], 2)
        record["n_slots"] = -1  # without the forces of the last design
        states = self.states.copy()
        states["by_force"] = 1
        nodes = flanks.solve(states, keep_nodes=True)
        assert nodes is not None
        _check(states["status"])
        held = (np.arange(nodes.shape[1]) < states["n_nodes"][:, None]) & (nodes["force"] > 0.0)
        force = np.where(held, nodes["force"], 0.0)
        on_path = nodes["place"] == ON_PATH
        pressure = np.zeros(force.shape)
        set_pressures(rows, placed_nodes(flanks, nodes).ravel(), force.ravel(), pressure.ravel())
        edge = np.where(on_path, 0.0, force).sum(axis=1) / states["force"]
        return Curves.of(
            *(values.reshape(self.shape) for values in (states["x_0"].copy(), pressure.max(axis=1), edge))
        )


def _check(status: NDArray[np.int64]) -> None:
    """Raise a SolverError for states without a solution."""
    worst = int(status.max())
    if worst != OK:
        raise SolverError(f"a design has no contact state: {sentence(worst)}", worst)
