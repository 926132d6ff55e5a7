# SPDX-License-Identifier: Apache-2.0
"""Computation of the table of the elastic potential: axes, states in an order for warm starts, measured errors.

The points of the mesh phase are dense where tooth pairs enter and leave contact: there the force has kinks, and
their position depends on load and misalignment. The density follows second differences of the force in a
preliminary scan. All other axes are fixed by range and size.

Derivation: docs/decisions/0033-potential-table.md, "Axes".
"""

from __future__ import annotations

import dataclasses
import math
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.potential_axes import TableAxis
from pitchpoint.contact.potential_fit import FURTHER, U_A, U_KAPPA, U_S, U_X, PotentialTable, fit_potential
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
_SCAN = 4
"""Phases of the preliminary scan per point of the phase axis."""
_SCAN_APPROACHES = 6
_SCAN_MISALIGNMENT = 0.6
"""Share of the largest misalignment in the preliminary scan, which also has zero."""
_EVEN = 0.5
"""Weight of equal steps in the density of the phase axis."""
_GRADING = 1.25
"""Power of the spacing of misalignments: denser about zero, where contact over the whole width begins."""
CHECKS = 2000
"""Number of random states at which errors are measured."""
ERRORS = ("force", "travel_force", "tilting_moment", "centre_force")
"""Measured errors of the derivatives by x, s, kappa and a."""


@dataclass(frozen=True)
class TableRange:
    """Range of a table.

    Parameters
    ----------
    approach
        Lowest approach at which any teeth touch, and highest approach [m].
    misalignment
        Largest absolute misalignment [rad]; 0: fixed at zero.
    centre_distance
        Smallest and largest centre distance [m]; equal: fixed.
    tolerances
        Deviations of a fixed misalignment [rad] and of a fixed centre distance [m] that are neglected.
    """

    approach: tuple[float, float]
    misalignment: float = 0.0
    centre_distance: tuple[float, float] = (0.0, 0.0)
    tolerances: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        """Check the numbers."""
        numbers = (*self.approach, self.misalignment, *self.centre_distance, *self.tolerances)
        if not all(isinstance(n, float | int) and math.isfinite(n) for n in numbers):
            raise refuse("range", "are not numbers", numbers, "finite numbers", "give SI values")
        for name, (low, high), least in (
            ("approach", self.approach, 1e-15),
            ("centre_distance", self.centre_distance, 0.0),
        ):
            if high - low < least:
                raise refuse(f"range.{name}", "does not increase", (low, high), "low < high", "swap the ends")
        if min(self.misalignment, *self.tolerances) < 0.0:
            raise refuse(
                "range", "is negative", min(self.misalignment, *self.tolerances), ">= 0", "change the sign"
            )


@dataclass(frozen=True)
class TableSize:
    """Number of points of the axes; misalignment and centre distance have one point if fixed."""

    phase: int = 64
    approach: int = 24
    misalignment: int = 9
    centre_distance: int = 5


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
        array = np.asarray(values, dtype=np.float64)
        if array.shape != (count, self.columns):
            wanted = (count, self.columns)
            raise SolverError(
                f"the potential returns values of shape {array.shape} instead of {wanted}", REFUSED
            )
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
        states come in lines along the approach, up and down in turn, so that neighbours differ by one step. The
        values of a state are potential [J], its derivatives by phase, approach, misalignment and centre
        distance, and the further quantities, which vanish without contact.
    span, size
        Range of the table, number of points.
    nominal
        Values to which the errors are related.
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
        Table with measured errors: of force, travel force per base pitch, tilting moment and centre force (the
        derivatives by x, s, kappa and a) and of the further quantities per nominal force.

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
    centres, kappas = _centres(span, size), _kappas(span, size)
    if isinstance(checks, bool) or checks < 1:
        raise refuse("checks", "is not a number of states", checks, ">= 1", "give a number")
    scan = _scan(span, size)
    count = size.phase * size.approach * kappas.count * centres.count
    sampler = _Sampler(source, FURTHER + len(quantities), run, progress, scan[..., 0].size + count + checks)
    forces = sampler.sample(scan, "scan of the mesh phase")[..., U_X]
    phases = _phases(forces.reshape(-1, _SCAN * size.phase, _SCAN_APPROACHES), size.phase)
    axes = (TableAxis("phase", phases, True, 1.0), _approaches(span, size), kappas, centres)
    values = sampler.sample(_grid(axes), "elastic potential")
    values = values.reshape(centres.count, kappas.count, size.phase, size.approach, -1)
    values[:, :, 1::2] = values[:, :, 1::2, ::-1]
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
    >>> exact = np.array([[0.04, 0.0, 4040.0, 0.0, 0.0]])
    >>> found = measured_errors(table, np.array([[0.0, 3e-5, 0.0, 0.0]]), exact, NominalValues(4000.0, 1.0, 1.0))
    >>> [round(v, 9) for v in found["force"]]
    [0.01, 0.01, 1.01]
    """
    packed = table.packed
    read = np.array([potential(packed, *state) for state in states])
    ratios = np.zeros((len(states), len(table.quantities)))
    for state, row in zip(states, ratios, strict=True):
        force_ratios(packed, *state, row)
    found = {}
    for name, column, scale in zip(ERRORS, (U_X, U_S, U_KAPPA, U_A), nominal.scales, strict=True):
        found[name] = _sizes(read[:, column] / scale, exact[:, column] / scale)
    for k, name in enumerate(table.quantities):
        found[name] = _sizes(
            ratios[:, k] * read[:, U_X] / nominal.force, exact[:, FURTHER + k] / nominal.force
        )
    return found


def _sizes(read: FloatArray, exact: FloatArray) -> tuple[float, float, float]:
    error = np.abs(read - exact)
    rms = [float(np.sqrt(np.mean(v**2))) for v in (error, exact)]
    return rms[0], float(error.max()), rms[1]


def _approaches(span: TableRange, size: TableSize) -> TableAxis:
    """Equal steps; the first point is one step below the lowest contact."""
    if size.approach < 4:
        raise refuse("size.approach", "points are too few", size.approach, ">= 4", "add points")
    low, high = span.approach
    step = (high - low) / (size.approach - 2)
    return TableAxis("approach", high - step * np.arange(size.approach)[::-1])


def _kappas(span: TableRange, size: TableSize) -> TableAxis:
    """Symmetric misalignments, denser about zero."""
    if span.misalignment == 0.0:
        return TableAxis("misalignment", np.zeros(1), tolerance=span.tolerances[0])
    if size.misalignment < 3:
        raise refuse("size.misalignment", "points are too few", size.misalignment, ">= 3", "add points")
    u = np.linspace(-1.0, 1.0, size.misalignment)
    return TableAxis("misalignment", span.misalignment * np.sign(u) * np.abs(u) ** _GRADING, True)


def _centres(span: TableRange, size: TableSize) -> TableAxis:
    """Equal steps of the centre distance."""
    low, high = span.centre_distance
    if low == high:
        return TableAxis("centre_distance", np.array([low]), tolerance=span.tolerances[1])
    if size.centre_distance < 3:
        raise refuse("size.centre_distance", "points are too few", size.centre_distance, ">= 3", "add points")
    return TableAxis("centre_distance", np.linspace(low, high, size.centre_distance), True)


def _scan(span: TableRange, size: TableSize) -> FloatArray:
    """States of the preliminary scan, lines along the approach, shape (n, approaches, 4)."""
    if not 4 <= size.phase <= 1024:
        raise refuse("size.phase", "is not a number of points", size.phase, "4 to 1024", "change it")
    phases = np.arange(_SCAN * size.phase) / (_SCAN * size.phase)
    approaches = np.linspace(*span.approach, _SCAN_APPROACHES + 1)[1:]
    kappa = _SCAN_MISALIGNMENT * span.misalignment
    kappas = [0.0] if kappa == 0.0 else [-kappa, 0.0, kappa]
    grid = np.meshgrid(kappas, phases, approaches, np.mean(span.centre_distance), indexing="ij")
    return np.stack([grid[1], grid[2], grid[0], grid[3]], -1).reshape(-1, _SCAN_APPROACHES, 4)


def _phases(forces: FloatArray, count: int) -> FloatArray:
    """Points of the phase axis from the forces of the scan, shape (kappas, phases, approaches).

    A kink of the force over the phase costs an error in proportion to the step; equal shares of the square sum
    require a density as the fourth root of the mean square of the kinks.
    """
    kinks = np.roll(forces, -1, 1) - 2.0 * forces + np.roll(forces, 1, 1)
    density = np.mean(kinks**2, axis=(0, 2)) ** 0.25
    for _ in range(4):  # kinks between the scanned states
        density = (np.roll(density, 1) + density + np.roll(density, -1)) / 3.0
    density += _EVEN * np.mean(density) + 1e-300
    sums = np.concatenate([[0.0], np.cumsum(0.5 * (density + np.roll(density, -1)))])
    return np.interp(np.arange(count) / count, sums / sums[-1], np.linspace(0.0, 1.0, len(sums)))


def _grid(axes: tuple[TableAxis, ...]) -> FloatArray:
    """States of all points, lines along the approach, up and down in turn, shape (n_a n_kappa n_s, n_x, 4)."""
    s, x, kappa, a = (axis.points for axis in axes)
    grid = np.meshgrid(a, kappa, s, x, indexing="ij")
    states = np.stack([grid[2], grid[3], grid[1], grid[0]], -1)
    states[:, :, 1::2] = states[:, :, 1::2, ::-1]
    return states.reshape(-1, len(x), 4)


def _random_states(span: TableRange, table: PotentialTable, count: int) -> FloatArray:
    """Random states in the range, sorted by phase for warm starts, lines of one state, shape (n, 1, 4)."""
    chance = np.random.default_rng(1)
    low, high = span.approach
    points = [axis.points for axis in table.axes[2:]]
    states = np.column_stack(
        [
            np.sort(chance.random(count)),
            chance.uniform(low, high, count),
            *(chance.uniform(p[0], p[-1], count) for p in points),
        ]
    )
    return states[:, None, :]
