# SPDX-License-Identifier: Apache-2.0
"""Slow rolls in a report: length up to the common period, and curves of computed or given rolls."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.report.planets import load_sharing

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.solvers.quasistatic.roll import Roll
    from pitchpoint.system.system import System
    from pitchpoint.viz.report.build import MeshCycleData, RollData

Array = np.ndarray
POSITION = "mesh_phase_position"
POINTS, MIN_POINTS, ALL_POINTS = 96, 16, 960
"""Number of points per period of a short roll and of one with deviating teeth, and total number of points."""
POINTS_OF_LONG, MESH_POINTS = 80, 8
"""Minimum number of points per period of a long roll, and per cycle of the fastest mesh."""
LARGE, POINTS_OF_LARGE = 100, 240
"""Number of coordinates above which a roll has fewer points: each then takes about 10 ms."""
MAX_PERIODS, MAX_TURNS = 12, 60
"""Maximum number of rolled periods: for interacting meshes, and for gears with single-tooth deviations."""
MAX_ROLLS = 20
"""Maximum number of rolls, the first ones of the file; meshes of equal periods share a roll."""
WHOLE = 0.99
"""Periods that count as one whole period, up to the deflection of the teeth."""
SAME = 1e-3
"""Relative tolerance for equal periods, and for equal stiffness under load and by the law."""
ROUND_OFF = 1e-10
"""Tolerance for equal transmission errors [m]."""


@dataclass(frozen=True)
class Train:
    """Meshes that move and carry load in a scenario.

    Attributes
    ----------
    loaded
        Meshes that carry load; None: all.
    engaged
        Clutches and brakes that the scenario engages.
    """

    loaded: Collection[str] | None = None
    engaged: tuple[str, ...] | None = None

    def meshes(self, model: Model) -> list[str]:
        """Meshes that influence the others."""
        return [name for name in model.every_mesh if self.loaded is None or name in self.loaded]


ALL = Train()


@dataclass(frozen=True)
class RollPlan:
    """Length of a roll.

    Attributes
    ----------
    until
        Periods after which the roll repeats.
    periods, points
        Rolled periods, and points per period.
    """

    until: int
    periods: int
    points: int


def plan_of(model: Model, mesh: str, coordinates: int, train: Train = ALL) -> RollPlan:
    """Length of the roll of a mesh in a machine with a number of coordinates.

    A period has `MESH_POINTS` points for every cycle of the fastest loaded mesh, so that its transmission
    error is resolved, too.
    """
    total, until = points_to_roll(coordinates), periods_until_repeat(model, mesh, train)
    if _single_teeth(model):
        periods = min(until, MAX_TURNS, total // MIN_POINTS)
        return RollPlan(until, periods, max(MIN_POINTS, min(POINTS, total // periods)))
    turning, order = _rates(model, mesh, train)
    faster = max(
        (_order_of(model, name, turning) / order for name in train.meshes(model) if order), default=1.0
    )
    points = min(total, max(POINTS_OF_LONG, math.ceil(MESH_POINTS * faster)))
    periods = min(until, MAX_PERIODS, total // points)
    return RollPlan(until, periods, max(points, min(POINTS, total // periods)))


def periods_until_repeat(model: Model, mesh: str, train: Train = ALL) -> int:
    """Number of periods of a mesh after which a slow roll repeats.

    Another mesh of the train repeats when the ratio of the mesh frequencies times the periods is an integer,
    a gear with errors over its turn after whole turns.
    """
    from pitchpoint.model.tooth_errors import periods_of_errors

    turning, order = _rates(model, mesh, train)
    if not order:
        return 1
    names = {mesh, *train.meshes(model)}
    rates = [_order_of(model, name, turning) for name in names]
    for name in names:
        for gear, periods in zip(model.every_mesh[name].gears, periods_of_errors(model, name), strict=True):
            body = model.body_of(gear)
            if periods > 1 and body is not None:
                rates.append(abs(turning.get(body, 0.0)))
    return math.lcm(*(_denominator(rate / order) for rate in rates))


def equal_periods(model: Model, one: str, two: str, train: Train = ALL) -> bool:
    """Whether two meshes of a train have the same mesh frequency and repeat together."""
    turning, order = _rates(model, one, train)
    other = _order_of(model, two, turning) if order else 0.0
    return abs(other - order) <= 1e-9 * order and periods_until_repeat(
        model, one, train
    ) == periods_until_repeat(model, two, train)


def points_to_roll(coordinates: int) -> int:
    """Total number of points of a roll, fewer for a large machine."""
    return POINTS_OF_LARGE if coordinates > LARGE else ALL_POINTS


def _rates(model: Model, mesh: str, train: Train) -> tuple[dict[str, float], float]:
    """Speeds of all bodies for speed 1 of the first body of a mesh that can rotate, and its mesh frequency.

    Relative to their parents, as in the model file: planets relative to their carriers.
    """
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.model.scenario import Scenario

    for gear in model.every_mesh[mesh].gears:
        body = model.body_of(gear)
        if body is not None and model.bodies[body].moves != "fixed":
            try:
                turning = model.start_speeds(Scenario(speed={body: 1.0}, engaged=train.engaged))
            except PitchpointError:
                return {}, 0.0
            order = _order_of(model, mesh, turning)
            if order:
                return turning, order
    return {}, 0.0


def _order_of(model: Model, mesh: str, turning: dict[str, float]) -> float:
    """Mesh frequency for given speeds of the bodies; zero if the gears are at rest."""
    from pitchpoint.model.carried_trains import line_carrier, speed_in_space

    machine: Any = model
    one, two = (model.body_of(gear) for gear in model.every_mesh[mesh].gears)
    if one is None or two is None:
        return 0.0
    speed = speed_in_space(machine, turning, one, against=line_carrier(machine, one, two))
    return abs(speed) * model.toothed[model.every_mesh[mesh].gears[0]].number_of_teeth


def _denominator(ratio: float) -> int:
    """Denominator of a ratio of tooth numbers given in double precision.

    Examples
    --------
    >>> _denominator(19 / 57), _denominator(3.0), _denominator(20 / 57)
    (3, 1, 57)
    """
    return Fraction(ratio).limit_denominator(10**6).denominator


def from_roll(
    mesh: str, data: MeshCycleData, unit: float | None, system: System, roll: Roll, plan: RollPlan
) -> MeshCycleData:
    """Mesh cycle with the curves of a roll of whole periods over the mesh phase.

    Parameters
    ----------
    mesh, system
        Mesh and compiled system of the roll.
    data
        Mesh cycle without the roll.
    unit
        Reference stiffness of its ratios [N/m]; None if the reference is not a stiffness.
    roll, plan
        The roll and its length.
    """
    model: Any = system.model
    points = plan.points
    from pitchpoint.analysis.load_sharing import share_along_path

    def channel(name: str) -> Array:
        """Channel of the roll, shape (n,)."""
        values: Array = roll.rows[:, system.layout.channel(f"{name}[{mesh}]")]
        return values

    pair = model.bevel_pairs[mesh] if mesh in model.bevel_meshes else model.pairs[mesh]
    one = roll.meshes[mesh]
    force, te = channel("mesh_force"), channel("transmission_error")
    loaded = bool(np.all(force != 0.0))
    first = slice(0, points + 1)
    sharing = share_along_path(
        channel("mesh_phase")[first],
        one.share[first],
        pair.eps_alpha,
        pair.eps_beta,
        other_flank=float(force.mean()) < 0.0,
    )
    curves = {"without load": one.unloaded} | ({force_title(force): te} if loaded else {})
    cycles, until = _cycles(model, list(curves.values()), plan), plan.until
    phase = whole_phase(channel("mesh_phase"), sharing.offset)
    where, drawn = _drawn(phase, [*curves.values(), one.tangent_stiffness], points * cycles)
    rolled = math.ceil((len(force) - 1) / points)
    slope = drawn[-1] / (unit or 1.0)
    law = np.interp(where % 1.0, data.stiffness.phase, data.stiffness.stiffness_ratio)
    # a jump of the law is between two points of the roll
    differs = float(np.median(np.abs(slope - law))) > SAME * float(data.stiffness.mean)
    shared = loaded and bool(np.any(one.share))  # a prescribed stiffness has no single pairs
    return replace(
        data,
        error_phase=where,
        errors=dict(zip(curves, drawn[:-1], strict=True)),
        cycles=cycles or rolled,
        repeats=cycles or (until if until > rolled else 0),
        loaded_ratio=slope if loaded and differs and unit is not None else (),
        share_way=sharing.way if shared else (),
        share=sharing.share if shared else (),
    )


def _cycles(model: Model, curves: list[Array], plan: RollPlan) -> int:
    """Number of periods after which the curves of a roll repeat, 0 if unknown."""
    periods = (len(curves[0]) - 1) // plan.points
    cycles = shortest_cycle(curves, plan.points, periods)
    if periods < plan.until:
        # the curves may repeat although deviating teeth have not been in mesh yet
        known = not _single_teeth(model) and cycles <= periods // 2
        cycles = cycles if known else 0
    return cycles


def _single_teeth(model: Model) -> bool:
    """Whether a gear has errors over its turn, such as single teeth that differ."""
    from pitchpoint.model.tooth_errors import periods_of_errors

    return any(max(periods_of_errors(model, name)) > 1 for name in model.every_mesh)


def force_title(force: Array) -> str:
    """Name of the load case of a roll: its mean mesh force."""
    from pitchpoint.core.units import format_quantity

    return f"mesh force {format_quantity(abs(float(force.mean())), 'force', 4)}"


def whole_phase(phase: Array, offset: float = 0.0) -> Array:
    """Unwrapped phase of a mesh [base pitches], starting between 0 and 1."""
    whole: Array = np.unwrap(np.asarray(phase, dtype=np.float64) - offset, period=1.0)
    return whole - np.floor(whole.min() + 1e-9)


def shortest_cycle(curves: list[Array], points: int, periods: int) -> int:
    """Number of periods after which all curves repeat within a roll of whole periods; 0 if they do not.

    Examples
    --------
    >>> wave = np.sin(2 * np.pi * np.arange(25) / 8)
    >>> shortest_cycle([wave], 4, 6), shortest_cycle([np.arange(13.0)], 4, 3)
    (2, 0)
    """
    for cycles in range(1, periods + 1):
        if periods % cycles == 0 and all(
            _repeats(c[: points * periods + 1], points * cycles) for c in curves
        ):
            return cycles
    return 0


def _repeats(curve: Array, points: int) -> bool:
    """Whether a curve repeats after a number of points."""
    allowed = max(SAME * float(np.ptp(curve)), ROUND_OFF)
    return curve.size > points and float(np.max(np.abs(curve[points:] - curve[:-points]))) <= allowed


def _drawn(phase: Array, curves: list[Array], points: int) -> tuple[Array, list[Array]]:
    """Phases and curves for the plot: one cycle from phase 0 if they repeat, else the complete roll."""
    if not points:
        order = np.argsort(phase, kind="stable")
        return phase[order], [curve[order] for curve in curves]
    cycle = float(round(abs(phase[points] - phase[0])))
    once = phase[:points] % cycle
    order = np.argsort(once, kind="stable")
    where = once[order]
    return np.concatenate([[0.0], where, [cycle]]), [closed(where, curve[order], cycle) for curve in curves]


def closed(phase: Array, values: Array, cycle: float = 1.0) -> Array:
    """Values of one cycle, shape (n,), extended by those at its ends, the phases 0 and `cycle`."""
    end = np.interp(0.0, [phase[-1] - cycle, phase[0]], [values[-1], values[0]])
    return np.concatenate([[end], values, [end]])


def given_roll(data: xr.Dataset, note: str = "", model: Model | None = None) -> RollData:
    """Transmission errors of a given roll over the periods of each mesh, and load sharing of planets."""
    from pitchpoint.viz.report.build import RollData

    position = np.asarray(data[POSITION].values, dtype=np.float64)
    words = str(data[POSITION].attrs.get("long_name", ""))
    found: dict[str, tuple[Array, dict[str, Array]]] = {}
    for name in map(str, data.data_vars):
        if not name.startswith("unloaded_transmission_error["):
            continue
        mesh = name.partition("[")[2].rstrip("]")
        force = data[f"mesh_force[{mesh}]"].values
        errors = {"without load": data[name].values}
        if np.all(force != 0.0) and force.size:
            errors[force_title(force)] = data[f"transmission_error[{mesh}]"].values
        found[mesh] = _own_periods(position, data[f"mesh_phase[{mesh}]"].values), errors
    rolled = words.removeprefix("periods of ").removesuffix(" rolled")
    planets = {} if model is None else load_sharing(model, data)
    return RollData(curves=found, mesh=rolled if rolled in found else "", note=note, planets=planets)


def _own_periods(position: Array, phase: Array) -> Array:
    """Periods of a mesh since the start of a roll; those of the rolled mesh if they cannot be determined."""
    if phase.size < 2:
        return position
    turned = np.unwrap(np.asarray(phase, dtype=np.float64), period=1.0)
    if float(np.max(np.abs(np.diff(turned)))) > 0.4:
        return position
    own: Array = np.abs(turned - turned[0])
    return own


def without_given(cycles: dict[str, MeshCycleData], rolls: dict[str, RollData]) -> dict[str, MeshCycleData]:
    """Mesh cycles without the transmission errors of meshes with at least one period in a given roll."""
    given = {roll.mesh for roll in rolls.values()}
    for roll in rolls.values():
        given |= {mesh for mesh, (periods, _) in roll.curves.items() if np.ptp(periods) >= WHOLE}
    return {name: replace(c, errors={}) if name in given else c for name, c in cycles.items()}
