# SPDX-License-Identifier: Apache-2.0
"""Speed sweep: stepped speeds, up and down; each point starts from the final state of the previous one.

A change of speed adds the kinematic motion of the gear train (all bodies in the ratio of their teeth) to the
velocities and does not change deflections and vibration, so that the response follows its branch up to a
jump.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.jumps import sweep_jumps
from pitchpoint.core.errors import SolverError, join_notes
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INTERRUPTED, NOT_FINITE, OFF_SPEED, OK
from pitchpoint.elements.drive import target_of
from pitchpoint.elements.kind import DRIVE
from pitchpoint.io.sweep_store import STATISTICS, SWEPT
from pitchpoint.solvers.constraints.row_notes import explain, row_notes
from pitchpoint.solvers.contact_counts import new_counts
from pitchpoint.solvers.controls import refuse_sampled
from pitchpoint.solvers.divergence import FAILURES
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.initial_state.start import Start, prepare_start
from pitchpoint.solvers.sampling import Accumulators, new_statistics, read_statistics
from pitchpoint.solvers.speed_drift import runaway
from pitchpoint.solvers.step_choice import mesh_mode, next_chunk
from pitchpoint.solvers.sweep_speeds import at_speed, sweep_orders, sweep_range
from pitchpoint.solvers.time import scenario_of
from pitchpoint.sweep.balance import Balances
from pitchpoint.sweep.drift import LEFT, deviation, drift_notes, left_sentence
from pitchpoint.sweep.mesh_results import results_by_mesh
from pitchpoint.sweep.tables import channel_tables, factor_tables, jump_tables, mesh_tables, places
from pitchpoint.system.meshes import mesh_records
from pitchpoint.system.planet_loads import factors_of
from pitchpoint.system.remarks import deep_contacts
from pitchpoint.system.system import System

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.scenario import Scenario

STEPS_PER_PERIOD = 200
"""Minimum number of steps per period of every mesh and every mesh mode, unless given by the scenario.

For the backlash oscillator of Kahraman and Singh the error of the rms is 5e-5 of half the backlash with 200
steps and 1.0e-4 with 100 steps; it decreases with the square of the step.
"""


@dataclass(frozen=True)
class SweepSummary:
    """Results of a speed sweep.

    Parameters
    ----------
    status, sentence
        Final status and its message.
    mesh
        Swept mesh.
    points
        One mapping per point in the order of computation: direction, speed [rad/s], mesh_frequency [Hz],
        statistics of the swept mesh by quantity (unit, mean, rms, min, max), and the numbers of its contact
        (`io.sweep_store.CONTACTS`); `meshes` contains both for every mesh, the swept mesh first, and
        `channels` the statistics of all channels.
    jumps
        Direction and mesh frequency [Hz] of each jump.
    steps, wall_s
        Total number of steps, wall time [s].
    notes
        Notes on the result.
    """

    status: int
    sentence: str
    mesh: str
    points: list[dict[str, Any]]
    jumps: list[dict[str, Any]]
    steps: int
    wall_s: float
    notes: tuple[str, ...]


@dataclass(frozen=True)
class SweepPlan:
    """Speeds, speed ratios and step sizes of a sweep.

    `order` is the number of mesh periods of the swept mesh per revolution of the swept body, `ratio` the
    speed of each body over that of the swept body, and `fastest` the highest mesh frequency of the train
    over that of the swept mesh.
    """

    mesh: str
    order: float
    speeds: NDArray[np.float64]
    directions: tuple[str, ...]
    ratio: dict[str, float]
    settle: int
    measure: int
    steps: int | None
    fastest: float

    @property
    def frequencies(self) -> NDArray[np.float64]:
        """Mesh frequencies at all speeds [Hz], shape (points,)."""
        return np.abs(self.speeds) * self.order / (2.0 * math.pi)

    def points(self) -> Iterator[tuple[str, float]]:
        """Directions and speeds [rad/s] in the order of computation."""
        for direction in self.directions:
            for speed in self.speeds if direction == "up" else self.speeds[::-1]:
                yield direction, float(speed)

    def steps_at(self, frequency: float, mesh_mode: float) -> int:
        """Number of steps per period of the swept mesh."""
        if self.steps is not None:
            return self.steps
        return math.ceil(STEPS_PER_PERIOD * max(self.fastest, mesh_mode / frequency) * (1.0 - 1e-12))


def plan_sweep(system: System, scenario: Scenario) -> SweepPlan:
    """Plan of a sweep; parameters as in `run_sweep`.

    Raises
    ------
    SolverError
        If the scenario is not a sweep, or the swept mesh has no relative motion when the swept body rotates.
    """
    model, sweep = system.model, scenario.sweep
    if model is None or sweep is None:
        raise SolverError("the scenario is not a sweep", NOT_FINITE)
    mesh, orders = sweep_orders(system, scenario)
    order = orders[mesh]
    return SweepPlan(
        mesh=mesh,
        order=order,
        speeds=np.linspace(*sweep_range(system, scenario), sweep.points),
        directions=("up", "down") if sweep.direction == "both" else (sweep.direction,),
        ratio=model.start_speeds(replace(scenario, speed={sweep.body: 1.0})),
        settle=sweep.settle_periods,
        measure=sweep.measure_periods,
        steps=sweep.steps_per_period,
        fastest=max(orders.values()) / order,
    )


class _SweepRun:
    """Sweep in progress: integrator run, present speed and step counts."""

    def __init__(self, system: System, scenario: Scenario, plan: SweepPlan) -> None:
        self.plan, self.scenario = plan, scenario
        first = next(plan.points())[1]
        self.body = scenario.sweep.body  # type: ignore[union-attr]
        start = self._start(system, scenario, first)
        self.balances = Balances(
            start, (speed for _, speed in plan.points()), lambda speed: self._start(system, scenario, speed)
        )
        self.system, self.notes = start.system, (*start.notes, *self.balances.notes())
        self.waves = {name: drive.ripple.values() for name, drive in scenario.drive.items()}
        self.mode = max(mesh_mode(row, self.system) for row in mesh_records(self.system))
        self.speed = first
        self.run = generalized_alpha.start(self.system, start.state, self._step(first))
        self.steps = 0
        self.chunk = 1000

    def _start(self, system: System, scenario: Scenario, speed: float) -> Start:
        """Start at a speed."""
        return prepare_start(*at_speed(system, scenario, speed))

    def _frequency(self, speed: float) -> float:
        return abs(speed) * self.plan.order / (2.0 * math.pi)

    def _step(self, speed: float) -> float:
        f = self._frequency(speed)
        return 1.0 / (f * self.plan.steps_at(f, self.mode))

    def go_to(self, speed: float) -> None:
        """Change the mean speed of the whole train, with its drives and balancing torques."""
        w, t = self.system.workspace, self.run.t
        share = 1.0  # of the ripple of the swept body in its present speed
        for record in self.system.rows(DRIVE):
            name = self.system.layout.bodies[int(record["i"])]
            before, mean = target_of(record, t)[1], float(record["speed"])
            record["speed"] = speed * self.plan.ratio[name]
            record["angle"] += (mean - record["speed"]) * t
            if name == self.body and mean != 0.0:
                share = before / mean
        for name, ratio in self.plan.ratio.items():
            if ratio != 0.0:
                w.v[self.system.spin(name)] += (speed - self.speed) * ratio * share
        w.v += self.balances.set(self.system, self.run.state(), self.speed, speed)
        self.speed = speed
        self.run.change_step(self._step(speed))

    def cut_ripple(self, speed: float, window: float) -> float:
        """Deviation of the mean speed [rad/s] over a window [s] that does not contain whole waves."""
        angle = sum(
            2.0 * wave.amplitude / abs(self.plan.ratio[name])
            for name, waves in self.waves.items()
            if self.plan.ratio.get(name)
            for wave in waves
        )
        return angle / window + self.balances.allowance(self.system.spin(self.body), speed, window)

    def left(self, point: dict[str, Any]) -> bool:
        """Whether a point is not one of the sweep, because its mean speed is another one."""
        found, allowed = deviation(point, self.body, self.plan.measure, self.cut_ripple)
        return abs(found) >= LEFT + allowed

    def runaway(self) -> str:
        """Sentence on the unstable operating point that the speed left before the sweep failed; else ''."""
        start, at = (
            self.balances.starts.get(self.speed),
            replace(self.scenario, speed={self.body: self.speed}),
        )
        return "" if start is None else runaway(start, at, self.run.state())

    def advance(self, periods: int, sums: Accumulators | None) -> int:
        """Integrate over some mesh periods, with statistics unless `sums` is None; returns the status."""
        f = self._frequency(self.speed)
        left = periods * self.plan.steps_at(f, self.mode)
        while left > 0:
            begun, n = time.perf_counter(), min(left, self.chunk)
            chunk = self.run.advance(n, statistics=sums)
            self.steps += chunk.steps
            left -= chunk.steps
            if chunk.status != OK:
                return int(chunk.status)
            if n == self.chunk:
                self.chunk = next_chunk(n, time.perf_counter() - begun)
        return OK

    def point(self, direction: str, sums: Accumulators) -> dict[str, Any]:
        """Results of one point of the sweep."""
        found = read_statistics(sums)
        channels = {
            c.name: {
                "unit": c.unit,
                "mean": float(found.mean[k]),
                "rms": float(found.rms[k]),
                "min": float(found.least[k]),
                "max": float(found.most[k]),
            }
            for k, c in enumerate(self.system.layout.channels)
        }
        meshes = results_by_mesh(self.system, self.plan.mesh, channels, found, sums)
        return {
            "direction": direction,
            "speed": self.speed,
            "mesh_frequency": self._frequency(self.speed),
            **meshes[self.plan.mesh],
            "meshes": meshes,
            **self._factors(channels),
            "channels": channels,
        }

    def _factors(self, channels: dict[str, Any]) -> dict[str, float]:
        """Mesh load factors of the planetary stages."""
        return {} if self.system.model is None else factors_of(self.system.model, channels)


def run_sweep(
    system: System,
    scenario: Scenario | None = None,
    *,
    progress: Progress = silent,
    sink: Callable[[dict[str, Any]], None] | None = None,
) -> SweepSummary:
    """Run a speed sweep.

    Parameters
    ----------
    system
        System compiled with the scenario.
    scenario
        Scenario with `sweep`; default: that of the system.
    progress
        Called after each point with the number of finished points.
    sink
        Called with each finished point, for example by a result file.

    Returns
    -------
    SweepSummary
        Results, also of a failed or interrupted sweep with the points finished so far.

    Raises
    ------
    SolverError
        If the sweep cannot start.
    """
    chosen = scenario_of(system, scenario)
    begun = time.perf_counter()
    refuse_sampled(system, "a speed sweep")
    plan = plan_sweep(system, chosen)
    walk = _SweepRun(system, chosen, plan)
    points: list[dict[str, Any]] = []
    status, words, total = OK, "", len(plan.speeds) * len(plan.directions)
    try:
        for direction, speed in plan.points():
            walk.go_to(speed)
            status = walk.advance(plan.settle, None)
            sums = new_statistics(walk.system.sizes["no"], new_counts(walk.system))
            status = status if status != OK else walk.advance(plan.measure, sums)
            if status != OK:
                break
            point = walk.point(direction, sums)
            if walk.left(point):
                status = OFF_SPEED
                words = left_sentence(point, walk.body, walk.balances.unstable(speed))
                break
            points.append(point)
            if sink is not None:
                sink(points[-1])
            progress(len(points), total, f"{points[-1]['mesh_frequency']:.5g} Hz {direction}")
    except KeyboardInterrupt:
        status = INTERRUPTED
    return SweepSummary(
        status=status,
        sentence=words or explain(walk.system, status) + (walk.runaway() if status in FAILURES else ""),
        mesh=plan.mesh,
        points=points,
        jumps=[{"direction": j.direction, "mesh_frequency": j.frequency} for j in sweep_jumps(points)],
        steps=walk.steps,
        wall_s=time.perf_counter() - begun,
        notes=(
            *walk.notes,
            *row_notes(walk.system),
            *deep_contacts(system.model, (p["channels"] for p in points)),
            *drift_notes(points, walk.body, plan.measure, walk.cut_ripple, walk.balances.unstable),
        ),
    )


def sweep_speed(
    system: System, scenario: Scenario | None = None, *, progress: Progress = silent
) -> xr.Dataset:
    """Speed sweep as a dataset.

    Parameters
    ----------
    system, scenario, progress
        See `run_sweep`.

    Returns
    -------
    xarray.Dataset
        Dimensions `direction` and `mesh_frequency` [Hz]; for each quantity of the swept mesh
        `QUANTITY_mean`, `_rms`, `_min`, `_max`, and the numbers of its contact, such as
        `contact_loss_share`, `impact_rate` [1/s] and `closing_speed_max` [m/s]; these numbers of every mesh
        by name, such as `contact_loss_share[stage]`; all channels of the system by name, such as
        `bearing_force[left.fx]`, with the third dimension `statistic` (mean, rms, min, max);
        `load_sharing_factor[STAGE]` of planetary stages; `jump_direction` (index in `direction`) and
        `jump_mesh_frequency` [Hz] over `jump`. Missing points are NaN. The attributes contain the notes.
        Result files of `pitchpoint sweep` have the same names of channels and jumps.

    Raises
    ------
    SolverError
        If the sweep fails; `partial` contains the dataset so far.
    """
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    found = run_sweep(system, scenario, progress=progress)
    directions = sorted({p["direction"] for p in found.points}, reverse=True)
    grid = sorted({p["mesh_frequency"] for p in found.points})
    at = places(found.points, directions, grid)
    data = {
        **mesh_tables(found.points, at),
        **channel_tables(system.layout.channels, found.points, at),
        **factor_tables(found.points, at),
        **jump_tables(found.jumps, directions),
    }
    coords: dict[str, Any] = {
        "direction": directions,
        "mesh_frequency": ("mesh_frequency", np.array(grid), {"units": "Hz", "long_name": "mesh frequency"}),
        "statistic": list(STATISTICS),
        "jump": np.arange(len(found.jumps)),
    }
    attrs = attributes(system, "speed sweep", found.status, found.wall_s)
    attrs |= {"notes": join_notes(found.notes), SWEPT: found.mesh}
    result = xr.Dataset(data, coords=coords, attrs=attrs)
    if found.status != OK:
        raise SolverError(found.sentence, found.status, result)
    return result
