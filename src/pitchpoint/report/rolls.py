# SPDX-License-Identifier: Apache-2.0
"""Slow rolls in a report: length up to the common period, and curves of computed or given rolls."""

from __future__ import annotations

import math
from dataclasses import replace
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
"""Minimum number of points per period of a roll, and total number of points."""
LARGE, POINTS_OF_LARGE = 100, 240
"""Number of coordinates above which a roll has fewer points: each then takes about 10 ms."""
MAX_PERIODS, MAX_TURNS = 12, 60
"""Maximum number of rolled periods: for interacting meshes, and for gears with single-tooth deviations."""
MAX_MESHES = 20
"""Maximum number of rolled meshes, the first ones of the file."""
WHOLE = 0.99
"""Periods that count as one whole period, up to the deflection of the teeth."""
SAME = 1e-3
"""Relative tolerance for equal periods, and for equal stiffness under load and by the law."""
ROUND_OFF = 1e-10
"""Tolerance for equal transmission errors [m]."""


def periods_until_repeat(model: Model, mesh: str) -> int:
    """Number of periods of a mesh after which a slow roll repeats.

    Another mesh of the train repeats when the ratio of the mesh frequencies times the periods is an integer,
    a gear with errors over its turn after whole turns.
    """
    from pitchpoint.model.tooth_errors import periods_of_errors

    turning, order = _rates(model, mesh)
    if not order:
        return 1
    rates = [_order_of(model, name, turning) for name in model.every_mesh]
    for name, one in model.every_mesh.items():
        for gear, periods in zip(one.gears, periods_of_errors(model, name), strict=True):
            body = model.body_of(gear)
            if periods > 1 and body is not None:
                rates.append(abs(turning.get(body, 0.0)))
    return math.lcm(*(_denominator(rate / order) for rate in rates))


def equal_periods(model: Model, one: str, two: str) -> bool:
    """Whether two meshes of a train have the same mesh frequency and repeat together."""
    turning, order = _rates(model, one)
    other = _order_of(model, two, turning) if order else 0.0
    return abs(other - order) <= 1e-9 * order and periods_until_repeat(model, one) == periods_until_repeat(
        model, two
    )


def points_to_roll(coordinates: int) -> int:
    """Total number of points of a roll, fewer for a large machine."""
    return POINTS_OF_LARGE if coordinates > LARGE else ALL_POINTS


def periods_to_roll(model: Model, mesh: str, points: int = ALL_POINTS) -> int:
    """Number of rolled periods for a number of points: until everything repeats, within limits."""
    most = MAX_TURNS if _single_teeth(model) else MAX_PERIODS
    return min(periods_until_repeat(model, mesh), most, points // MIN_POINTS)


def points_per_period(periods: int, points: int = ALL_POINTS) -> int:
    """Points per period, fewer if many periods are rolled."""
    return max(MIN_POINTS, min(POINTS, points // periods))


def _rates(model: Model, mesh: str) -> tuple[dict[str, float], float]:
    """Speeds of all bodies for speed 1 of the first rotating body of a mesh, and its mesh frequency.

    Relative to their parents, as in the model file: planets relative to their carriers.
    """
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.model.scenario import Scenario

    for gear in model.every_mesh[mesh].gears:
        body = model.body_of(gear)
        if body is not None and model.bodies[body].moves != "fixed":
            try:
                turning = model.start_speeds(Scenario(speed={body: 1.0}))
            except PitchpointError:
                return {}, 0.0
            return turning, _order_of(model, mesh, turning)
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
    model: Model, mesh: str, data: MeshCycleData, unit: float | None, system: System, roll: Roll, points: int
) -> MeshCycleData:
    """Mesh cycle with the curves of a roll of whole periods over the mesh phase.

    Parameters
    ----------
    model, mesh, system
        Model, mesh and compiled system of the roll.
    data
        Mesh cycle without the roll.
    unit
        Reference stiffness of its ratios [N/m]; None if the reference is not a stiffness.
    roll
        The roll.
    points
        Points per period of the roll.
    """
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
    cycles, until = _cycles(model, mesh, list(curves.values()), points)
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


def _cycles(model: Model, mesh: str, curves: list[Array], points: int) -> tuple[int, int]:
    """Number of periods after which the curves of a roll repeat, 0 if unknown; and the remarks."""
    periods, until = (len(curves[0]) - 1) // points, periods_until_repeat(model, mesh)
    cycles = shortest_cycle(curves, points, periods)
    if periods < until:
        # the curves may repeat although deviating teeth have not been in mesh yet
        known = not _single_teeth(model) and cycles <= periods // 2
        cycles = cycles if known else 0
    return cycles, until


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
