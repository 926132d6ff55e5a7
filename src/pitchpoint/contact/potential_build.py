# SPDX-License-Identifier: Apache-2.0
"""Computation of the table of the elastic potential: states in an order for warm starts, measured errors.

Derivation: docs/theory/stiffness.md, "Pre-computed flank contact".
"""

from __future__ import annotations

import dataclasses
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.potential_axes import TableAxis
from pitchpoint.contact.potential_fit import (
    FURTHER,
    U_A,
    U_KAPPA,
    U_S,
    U_X,
    PotentialTable,
    check_quantities,
    fit_potential,
)
from pitchpoint.contact.potential_range import TableRange, TableSize, fixed_axes, phase_axis, scan_states
from pitchpoint.contact.potential_table import force_ratios, potential
from pitchpoint.contact.stiffness.description import positive, refuse
from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import REFUSED

FloatArray = NDArray[np.float64]
Evaluator = Callable[[FloatArray], FloatArray]
"""Values of states (phase, approach, misalignment, centre distance), shape (n, 4) to (n, 5 + further)."""
Runner = Callable[[Callable[[Any, threading.Event], Any], Sequence[Any], Callable[[Any], None]], bool]
"""Execution of independent tasks, as by `sweep.threads.on_all_cores`; False if interrupted."""

_LINES = 8
"""Number of lines of approach in one task."""
CHECKS = 2000
"""Number of random states at which errors are measured."""
ERRORS = ("force", "travel_force", "tilting_moment", "centre_force")
"""Measured errors of the derivatives by x, s, kappa and a."""


@dataclass(frozen=True)
class NominalValues:
    """Nominal force [N], base pitch [m] and face width [m], to which measured errors are related."""

    force: float
    base_pitch: float
    face_width: float

    def __post_init__(self) -> None:
        """Check the numbers."""
        for name, unit in (("force", "N"), ("base_pitch", "m"), ("face_width", "m")):
            positive(f"nominal.{name}", getattr(self, name), unit)

    @property
    def scales(self) -> tuple[float, float, float, float]:
        """Nominal values of the derivatives by x, s, kappa and a."""
        return self.force, self.force * self.base_pitch, 0.5 * self.force * self.face_width, self.force


@dataclass
class _Sampler:
    """Evaluation of many states with reports of progress."""

    source: Callable[[], Evaluator]
    columns: int
    run: Runner
    progress: Progress
    total: int
    done: int = field(default=0)

    def sample(self, states: FloatArray, note: str) -> FloatArray:
        """Values of lines of states, shape (lines, n, 4) to (lines, n, columns)."""
        found = np.empty((*states.shape[:2], self.columns))
        starts = range(0, len(states), _LINES)

        def work(start: int, stop: threading.Event) -> tuple[int, list[FloatArray], BaseException | None]:
            """Evaluate some lines with an evaluator of their own."""
            values: list[FloatArray] = []
            try:
                evaluate = self.source()
                for line in states[start : start + _LINES]:
                    if stop.is_set():
                        raise KeyboardInterrupt
                    values.append(self._checked(evaluate(line.copy()), len(line)))
            except BaseException as error:  # noqa: BLE001 - raised again in the calling thread
                return start, values, error
            return start, values, None

        def take(result: tuple[int, list[FloatArray], BaseException | None]) -> None:
            """Store lines and report them."""
            start, values, error = result
            if error is not None:
                raise error
            found[start : start + len(values)] = values
            self.done += len(values) * states.shape[1]
            self.progress(self.done, self.total, note)

        if not self.run(work, starts, take):
            raise KeyboardInterrupt
        return found

    def _checked(self, values: FloatArray, count: int) -> FloatArray:
        """Values of the expected shape."""
        array, wanted = np.asarray(values, dtype=np.float64), (count, self.columns)
        if array.shape != wanted:
            words = f"the potential returns values of shape {array.shape} instead of {wanted}"
            raise SolverError(words, REFUSED)
        return array


def one_after_another(
    work: Callable[[Any, threading.Event], Any], pieces: Sequence[Any], take: Callable[[Any], None]
) -> bool:
    """Execute tasks in sequence; returns True.

    Parameters
    ----------
    work
        Executes one task; the event is never set.
    pieces
        Tasks.
    take
        Called with each result.

    Examples
    --------
    >>> one_after_another(lambda piece, stop: piece + 1, [1, 2], print)
    2
    3
    True
    """
    never = threading.Event()
    for piece in pieces:
        take(work(piece, never))
    return True


def build_potential_table(
    source: Callable[[], Evaluator],
    span: TableRange,
    nominal: NominalValues,
    size: TableSize | None = None,
    quantities: Mapping[str, str] | None = None,
    run: Runner = one_after_another,
    progress: Progress = silent,
    checks: int = CHECKS,
) -> PotentialTable:
    """Compute the table of an elastic potential and measure its errors at random states.

    Parameters
    ----------
    source
        Makes an evaluator; each task has its own, so that memory and warm starts belong to one thread. Its
        states come in lines along the approach, up and down in turn, so that neighbours differ by one step.
        The values of a state are potential [J], its derivatives by phase, approach, misalignment and centre
        distance, and the further quantities, which vanish without contact.
    span
        Range of the table.
    nominal
        Values to which the errors are related.
    size
        Number of points.
    quantities
        Unit of the ratio of every further quantity to the force, by name.
    run
        Execution of the tasks, `sweep.threads.on_all_cores` for all cores.
    progress
        Receiver of reports between tasks; it may raise KeyboardInterrupt.
    checks
        Number of random states.

    Returns
    -------
    PotentialTable
        Table with measured errors: of force, travel force per base pitch, tilting moment and centre force
        (the derivatives by x, s, kappa and a) and of the further quantities per nominal force.

    Raises
    ------
    SolverError
        If the values are not those of an elastic potential.
    ModelError
        If range or size are invalid.
    KeyboardInterrupt
        After an interruption.

    Examples
    --------
    >>> def spring(states):
    ...     force = 2.0e8 * np.maximum(states[:, 1] - 1.0e-5, 0.0)
    ...     zero = 0.0 * force
    ...     return np.column_stack([force**2 / 4.0e8, zero, force, zero, zero])
    >>> span, nominal = TableRange((1.0e-5, 5.0e-5)), NominalValues(5000.0, 0.012, 0.02)
    >>> table = build_potential_table(lambda: spring, span, nominal, TableSize(8, 8), checks=50)
    >>> bool(table.errors["force"][1] < 1e-9)
    True
    """
    size, quantities = size or TableSize(), dict(quantities or {})
    check_quantities(quantities)
    if isinstance(checks, bool) or checks < 1:
        raise refuse("checks", "is not a number of states", checks, ">= 1", "give a number")
    x, kappa, a = fixed_axes(span, size)
    scan = scan_states(span, size)
    count = size.phase * x.count * kappa.count * a.count
    sampler = _Sampler(source, FURTHER + len(quantities), run, progress, scan[..., 0].size + count + checks)
    forces = sampler.sample(scan, "scan of the mesh phase")[..., U_X]
    axes = (phase_axis(forces, size.phase), x, kappa, a)
    values = sampler.sample(_grid(axes), "elastic potential")
    values = values.reshape(a.count, kappa.count, size.phase, x.count, -1)
    values[:, :, 1::2] = values[:, :, 1::2, ::-1].copy()
    table = fit_potential(axes, np.ascontiguousarray(values.transpose(2, 3, 1, 0, 4)), quantities)
    states = _random_states(span, table, checks)
    exact = sampler.sample(states, "errors at random states")
    return dataclasses.replace(table, errors=measured_errors(table, states[:, 0], exact[:, 0], nominal))


def measured_errors(
    table: PotentialTable, states: FloatArray, exact: FloatArray, nominal: NominalValues
) -> dict[str, tuple[float, float, float]]:
    """Errors of a table: rms, maximum, and rms of the exact quantity, in nominal values, by name.

    Parameters
    ----------
    table
        The table.
    states
        States, shape (n, 4).
    exact
        Values from the evaluator, shape (n, 5 + further).
    nominal
        Nominal values.

    Examples
    --------
    >>> table = PotentialTable.of_spring(2.0e8, 1.0e-5, 5.0e-5)
    >>> states, exact = np.array([[0.0, 3e-5, 0.0, 0.0]]), np.array([[0.04, 0.0, 4040.0, 0.0, 0.0]])
    >>> found = measured_errors(table, states, exact, NominalValues(4000.0, 1.0, 1.0))
    >>> [round(v, 9) for v in found["force"]]
    [0.01, 0.01, 1.01]
    """
    packed = table.packed
    read = np.array([potential(packed, *state) for state in states])
    ratios = np.zeros((len(states), 3, len(table.quantities)))
    for state, row in zip(states, ratios, strict=True):
        force_ratios(packed, *state, row)
    found = {}
    for name, column, scale in zip(ERRORS, (U_X, U_S, U_KAPPA, U_A), nominal.scales, strict=True):
        found[name] = _sizes(read[:, column] / scale, exact[:, column] / scale)
    for k, name in enumerate(table.quantities):
        product = ratios[:, 0, k] * read[:, U_X]
        found[name] = _sizes(product / nominal.force, exact[:, FURTHER + k] / nominal.force)
    return found


def _sizes(read: FloatArray, exact: FloatArray) -> tuple[float, float, float]:
    """Root mean square and maximum of the error, root mean square of the quantity."""
    error = np.abs(read - exact)
    rms = [float(np.sqrt(np.mean(v**2))) for v in (error, exact)]
    return rms[0], float(error.max()), rms[1]


def _grid(axes: tuple[TableAxis, ...]) -> FloatArray:
    """States of all points, lines along the approach, up and down in turn, (n_a n_kappa n_s, n_x, 4)."""
    s, x, kappa, a = (axis.points for axis in axes)
    grid = np.meshgrid(a, kappa, s, x, indexing="ij")
    states = np.stack([grid[2], grid[3], grid[1], grid[0]], -1)
    states[:, :, 1::2] = states[:, :, 1::2, ::-1].copy()
    return states.reshape(-1, len(x), 4)


def _random_states(span: TableRange, table: PotentialTable, count: int) -> FloatArray:
    """Random states in the range, sorted by phase for warm starts, lines of one state, (n, 1, 4)."""
    chance = np.random.default_rng(1)
    phases, approaches = np.sort(chance.random(count)), chance.uniform(*span.approach, count)
    ends = [(axis.points[0], axis.points[-1]) for axis in table.axes[2:]]
    return np.stack([phases, approaches, *(chance.uniform(*pair, count) for pair in ends)], -1)[:, None]
