# SPDX-License-Identifier: Apache-2.0
"""Slow roll through whole mesh periods: transmission error with and without load, stiffness, load sharing.

One spin is advanced in equal angular steps, with the equilibrium of all other coordinates under the loads at
each step. Speeds are zero: inertia, damping and (smoothed Coulomb) friction forces vanish, so the result is
the limit of the dynamics for vanishing speed. Drives and balancing torques follow the loads (`holding`).

The unloaded transmission error is that for vanishing torque with the flanks in contact and undeformed
bearings: the kinematic error of the flanks (modifications, deviations, prescribed error) and half the
backlash.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import SolverError, join_notes
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT, INTERRUPTED, OK, sentence
from pitchpoint.core.words import listed
from pitchpoint.model.components.law import Balance
from pitchpoint.model.scenario import QuasiStatic, Scenario
from pitchpoint.model.tooth_errors import periods_of_errors
from pitchpoint.solvers.controls import refuse_rates
from pitchpoint.solvers.element_tangents import without_friction
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.gear_trains import mesh_orders, rotations
from pitchpoint.solvers.operating_point import operating_point
from pitchpoint.solvers.quasistatic.holding import Holding
from pitchpoint.solvers.quasistatic.loads import loads_at_speed
from pitchpoint.solvers.quasistatic.notes import balance_notes, friction_notes, load_notes
from pitchpoint.solvers.quasistatic.path import (
    held_in_roll,
    periods_per_turn,
    pitches_of,
    rolled_on,
    without_deflections,
)
from pitchpoint.solvers.quasistatic.unloaded_mesh import tangent_stiffness, unloaded_error
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.system.meshes import mesh_names, mesh_record
from pitchpoint.system.remarks import deep_contacts
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    import xarray as xr

DIMENSION = "mesh_phase_position"


@dataclass(frozen=True)
class MeshRoll:
    """One mesh over the roll; arrays of shape (n,).

    Parameters
    ----------
    unloaded
        Transmission error for vanishing torque [m], along the base tangent, from the middle of the backlash.
    tangent_stiffness
        Derivative of the mesh force with respect to the transmission error [N/m].
    share
        Load share of every tooth pair, shape (n, n_pair).
    pitches
        Travel in tooth pitches per period of the rolled mesh; 0 at rest, None if it is driven through closed
        loops, whose ratio varies.
    """

    unloaded: Array
    tangent_stiffness: Array
    share: Array
    pitches: Fraction | None = Fraction(1)

    @property
    def repeats_after(self) -> int:
        """Periods of the rolled mesh after which the phase of this mesh repeats; 0 for never."""
        return 0 if self.pitches is None else self.pitches.denominator


@dataclass(frozen=True)
class Roll:
    """A quasi-static roll.

    Parameters
    ----------
    mesh
        The rolled mesh.
    position
        Position in periods, shape (n,), n = points * periods + 1.
    rows
        All channels, shape (n, no), in the order of the channels of the system.
    meshes
        Results by mesh.
    holding
        Holding torques [N m], shape (n,), by body, of held bodies without drive and balancing torque.
    notes
        Notes for the user.
    status, sentence
        Status code and its description; a roll that stopped early contains the points before.
    errors_repeat
        Periods after which the errors of the teeth of both gears of the rolled mesh repeat.
    """

    mesh: str
    position: Array
    rows: Array
    meshes: dict[str, MeshRoll]
    holding: dict[str, Array]
    notes: tuple[str, ...] = ()
    status: int = OK
    sentence: str = ""
    errors_repeat: int = 1

    @property
    def cycle_notes(self) -> tuple[str, ...]:
        """Notes on cycles of meshes and errors that whole periods in a finished roll do not cover."""
        if self.status != OK:
            return ()
        periods = round(float(self.position[-1]))
        own = (
            f"the errors of the teeth of {self.mesh} repeat after {self.errors_repeat} periods, and its mean "
            f"and peak to peak are those of {periods}",
        )
        parts: dict[tuple[int, str], list[str]] = {}
        for name, mesh in self.meshes.items():
            cycles = Fraction(0) if mesh.pitches is None else mesh.pitches * periods
            if mesh.pitches is None or cycles.denominator != 1:
                what = "" if mesh.pitches is None else "peak to peak is" if cycles < 1 else "mean is"
                parts.setdefault((mesh.repeats_after, what), []).append(name)
        found = []
        for (after, what), names in parts.items():
            one = len(names) == 1
            who, its = f"mesh{'' if one else 'es'} {listed(names)}", "its" if one else "their"
            if what:
                when = f"repeat{'s' if one else ''} after {after} periods of {self.mesh}"
                found.append(f"{who} {when}, and {its} {what} that of {periods}")
            else:
                where = f"{'is' if one else 'are'} driven through a closed loop"
                found.append(f"{who} {where}, and {its} values are those of this part of the cycle")
        return (*own, *found) if periods % self.errors_repeat else tuple(found)


def roll_through(
    system: System,
    what: Scenario | str | None = None,
    points: int = 100,
    periods: int = 1,
    *,
    mesh: str | None = None,
    others: bool | Collection[str] = True,
    progress: Progress = silent,
    look: Callable[[System, State, Array], None] | None = None,
    at: Sequence[int] | None = None,
    along: Array | None = None,
) -> Roll:
    """Roll slowly through mesh periods; parameters as in `solve_quasistatic`, and the mesh for a scenario.

    `Roll.meshes` contains the rolled mesh and `others`: names, or True for all. `look` is called at each
    position with the evaluated system, its state and its channels. `at`: numbers of the rolled periods,
    counted from the initial position, instead of the first ones. `along`: rates of the coordinates in whose
    direction the roll goes; default: the speeds of the scenario.
    """
    scenario, mesh, points, periods = _plan(system, what, points, periods, mesh)
    if system.model is None:
        raise SolverError("a slow roll needs a system compiled from a model (gear ratios)", INCONSISTENT)
    refuse_rates(system, "a slow roll")
    # balance the torques without friction, which a slow roll neglects
    scenario = _begun(system, replace(scenario, quasi_static=QuasiStatic(mesh=mesh)))
    point = operating_point(without_friction(system, joints=True), scenario)
    own = loads_at_speed(point.system, point.state)
    k = mesh_names(own).index(mesh)
    state = point.state.copy()
    state.v[:] = 0.0
    held = held_in_roll(own, k, state)
    spin = held[0]
    direction = -1.0 if (point.state.v if along is None else along)[spin] < 0.0 else 1.0
    rates = rotations(own, (spin,))[:, 0]
    step = direction * 2.0 * np.pi / (periods_per_turn(own, k, rates) * points)
    where = np.arange(periods) if at is None else np.array(at)
    jumps = np.append(np.diff(where) - 1, 0) * points  # steps to the next period that is rolled
    n = points * where.size + 1
    rows, reaction = np.zeros((n, own.sizes["no"])), np.zeros((n, len(held)))
    names = mesh_names(own)
    observed = [m for m, x in enumerate(names) if others is True or m == k or (others and x in others)]
    unloaded, tangent = np.zeros((len(names), n)), np.zeros((len(names), n))
    state = find_equilibrium(own, state, held).state
    clear = without_deflections(own, state, held)
    owners = Holding.of(own, held)
    done, status, text, on, last = 0, OK, sentence(OK), 1, None
    try:
        for s in range(n):
            found = owners.reach(own, state, last, spin, on * step, rates)
            state, reaction[s] = found.state, found.reaction
            rows[s] = owners.observe(own, found)
            if look is not None:
                look(own, state, rows[s])
            for m in observed:
                tangent[m, s] = tangent_stiffness(own, state, m)
                contact = rows[s][own.layout.channel(f"contact_state[{names[m]}]")]
                unloaded[m, s] = unloaded_error(own, clear, m, contact)
            on = 1 + int(jumps[s // points]) if (s + 1) % points == 0 else 1
            last, (state, clear) = state, [rolled_on(own, x, spin, step, rates, on) for x in (state, clear)]
            done = s + 1
            progress(done, n, f"{mesh}: roll")
    except KeyboardInterrupt:
        status, text = INTERRUPTED, sentence(INTERRUPTED)
    except SolverError as error:
        status, text = error.status, f"{error} (after {done} of {n} points)"
    rows, holding = rows[:done], owners.others(reaction[:done])
    curves = {m: (unloaded[m, :done], tangent[m, :done]) for m in observed}
    meshes = _mesh_rolls(own, rows, curves, rates, (spin, k))
    spans = {
        c.name: {"min": column.min(initial=np.inf), "max": column.max(initial=-np.inf)}
        for c, column in zip(own.layout.channels, rows.T, strict=True)
    }
    notes = (
        *([f"the slow roll has the loads at {point.at}"] if point.at else []),
        *load_notes(own, holding, rows),
        *balance_notes(point.system, point.cycle, rows),
        *friction_notes(system),
        *deep_contacts(own.model, [spans]),
    )
    after = math.lcm(*periods_of_errors(system.model, mesh))
    return Roll(mesh, np.arange(done) / points, rows, meshes, holding, notes, status, text, after)


def _mesh_rolls(
    system: System, rows: Array, curves: dict[int, tuple[Array, Array]], rates: Array, rolled: tuple[int, int]
) -> dict[str, MeshRoll]:
    """Results by mesh over the points done; `rolled`: the rotated spin and the index of its mesh."""
    names, orders = mesh_names(system), list(mesh_orders(system, rates).values())
    return {
        names[m]: MeshRoll(
            *own,
            _shares(system, rows, names[m], int(mesh_record(system, m)["n_pair"])),
            pitches_of(system, m, rolled, orders[m] / orders[rolled[1]]),
        )
        for m, own in curves.items()
    }


def _plan(
    system: System, what: Scenario | str | None, points: int, periods: int, mesh: str | None = None
) -> tuple[Scenario, str, int, int]:
    """Determine scenario, mesh, points and periods from the arguments."""
    names = mesh_names(system)
    scenarios = {} if system.model is None else system.model.scenarios
    if isinstance(what, str) and what in names:
        mesh, what = what, None
    elif isinstance(what, str) and what not in scenarios:
        known = ", ".join((*names, *scenarios)) or "none"
        raise SolverError(f"no mesh or scenario {what!r}; there are: {known}", INCONSISTENT)
    chosen = scenarios[what] if isinstance(what, str) else what
    chosen = chosen or system.scenario or Scenario()
    if chosen.quasi_static is not None:
        q = chosen.quasi_static
        mesh, points, periods = mesh or q.mesh, q.points, q.periods
    if mesh is None and len(names) != 1:
        raise SolverError(f"choose the mesh to roll; there are: {', '.join(names) or 'none'}", INCONSISTENT)
    mesh = mesh or names[0]
    if mesh not in names:
        raise SolverError(
            f"no mesh {mesh!r} between bodies; there are: {', '.join(names) or 'none'}", INCONSISTENT
        )
    if points < 2 or periods < 1:
        raise SolverError("a roll needs at least 2 points and 1 period", INCONSISTENT)
    return chosen, mesh, points, periods


def _begun(system: System, scenario: Scenario) -> Scenario:
    """Scenario of the initial state, which with closed loops need not be in equilibrium."""
    loads = {} if system.model is None else system.model.loads
    if not is_looped(system) or any(isinstance(load.torque, Balance) for load in loads.values()):
        return scenario
    return replace(scenario, start="assembled")


def _shares(system: System, rows: Array, name: str, n_pair: int) -> Array:
    if n_pair == 0:
        return np.zeros((len(rows), 0))
    first = system.layout.channel(f"pair_force[{name}.0]")
    forces = np.abs(rows[:, first : first + n_pair])
    total = forces.sum(axis=1, keepdims=True)
    return np.divide(forces, total, out=np.zeros_like(forces), where=total > 0.0)


def solve_quasistatic(
    system: System,
    what: Scenario | str | None = None,
    points: int = 100,
    periods: int = 1,
    *,
    progress: Progress = silent,
) -> xr.Dataset:
    """Slow roll through whole periods of one mesh.

    Parameters
    ----------
    system
        The compiled model.
    what
        Name of a mesh, or a scenario (or its name) with `quasi_static`; loads are those at t = 0, torques
        over the speed those at the speeds of the scenario. Default:
        the scenario the system was compiled with, or the only mesh.
    points, periods
        Points per mesh period and number of periods, unless the scenario gives them.
    progress
        Called after every point.

    Returns
    -------
    xarray.Dataset
        Over `mesh_phase_position` (periods rolled): all channels of the system, and by mesh
        unloaded_transmission_error [m], tangent_stiffness [N/m], load_share[MESH.PAIR]; without dimension
        transmission_error_mean and transmission_error_peak_to_peak, loaded and unloaded [m].

    Raises
    ------
    SolverError
        If the mesh does not exist, or a point has no equilibrium.
    """
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes, channel_attributes

    began = time.perf_counter()
    roll = roll_through(system, what, points, periods, progress=progress)
    _, mesh, points, periods = _plan(system, what, points, periods)
    options = {"mesh": mesh, "points": points, "periods": periods}
    attrs = attributes(system, "quasistatic", roll.status, time.perf_counter() - began, **options)
    words = {"units": "1", "long_name": f"periods of {roll.mesh} rolled"}
    data = xr.Dataset(
        {t.name: ((DIMENSION,) * t.rolled, t.values, channel_attributes(t)) for t in tables(system, roll)},
        coords={DIMENSION: ((DIMENSION,), roll.position, words)},
        attrs={**attrs, "notes": join_notes((*roll.notes, *roll.cycle_notes))},
    )
    if roll.status != OK:
        raise SolverError(roll.sentence, roll.status, data)
    return data


@dataclass(frozen=True)
class Table:
    """One quantity of a roll: a scalar, or values over the positions, shape (n,)."""

    name: str
    values: Any
    unit: str
    long_name: str

    @property
    def rolled(self) -> bool:
        """Whether it has a value per position."""
        return bool(np.ndim(self.values))


def statistics(found: Table) -> dict[str, Any]:
    """Mean, rms of the alternating part, minimum and maximum of a quantity over whole periods."""
    # the last point repeats the first one, except for meshes with incomplete cycles
    once = found.values[:-1] if len(found.values) > 1 else found.values
    return {
        "unit": found.unit,
        "mean": float(once.mean()),
        "rms": float(once.std()),
        "min": float(found.values.min()),
        "max": float(found.values.max()),
    }


def tables(system: System, roll: Roll) -> list[Table]:
    """All results of a roll: channels, and the values and statistics of `MeshRoll` for every mesh."""
    found = [
        Table(c.name, roll.rows[:, k], c.unit, c.long_name) for k, c in enumerate(system.layout.channels)
    ]
    words = "torque that holds the body"
    found += [Table(f"holding_torque[{body}]", held, "N m", words) for body, held in roll.holding.items()]
    for name, mesh in roll.meshes.items():
        loaded = roll.rows[:, system.layout.channel(f"transmission_error[{name}]")]
        without = "transmission error without load"
        found += [
            Table(f"unloaded_transmission_error[{name}]", mesh.unloaded, "m", without),
            Table(f"tangent_stiffness[{name}]", mesh.tangent_stiffness, "N/m", "slope of the mesh force"),
        ]
        for word, te in (("", loaded), ("unloaded_", mesh.unloaded)):
            text, key = f"{word.replace('_', ' ')}transmission error", f"{word}transmission_error"
            # the last point repeats the first one
            mean = float(te[: max(len(te) - 1, 1)].mean()) if len(te) else float("nan")
            span = float(np.ptp(te)) if len(te) else float("nan")
            found.append(Table(f"{key}_mean[{name}]", mean, "m", f"mean of the {text}"))
            found.append(Table(f"{key}_peak_to_peak[{name}]", span, "m", f"range of the {text}"))
        for k in range(mesh.share.shape[1]):
            found.append(Table(f"load_share[{name}.{k}]", mesh.share[:, k], "1", f"share of tooth pair {k}"))
    return found
