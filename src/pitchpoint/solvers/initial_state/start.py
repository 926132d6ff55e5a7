# SPDX-License-Identifier: Apache-2.0
"""Initial state of a scenario: speeds by the gear ratios, loaded flanks, balancing torques."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import Message, SolverError, note
from pitchpoint.core.units import format_quantity
from pitchpoint.elements import drive as drive_element
from pitchpoint.elements.kind import MESH, TORQUE
from pitchpoint.model.components.joint import COORDINATES, RATES
from pitchpoint.model.mechanism import given
from pitchpoint.model.scenario import Scenario
from pitchpoint.model.shafts import station_names
from pitchpoint.solvers.constraints.assembly import assemble_state, close_loops
from pitchpoint.solvers.element_batches import free_flying
from pitchpoint.solvers.equilibrium.balancing import LOAD, balancing_loads
from pitchpoint.solvers.equilibrium.centring import centred
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.equilibrium.solve import NOW, Equilibrium, balance_torques
from pitchpoint.solvers.equilibrium.unknowns import ROUNDING, rest_matrix, signal_states
from pitchpoint.solvers.gear_trains import (
    driven_coordinates,
    held_spins,
    rates_through_loops,
)
from pitchpoint.solvers.initial_state.clutches import settle_clutches, slipping_clutches
from pitchpoint.solvers.initial_state.filters import (
    acting_torques,
    rest_of_controls,
    slipping_frictions,
    states_of_inputs,
)
from pitchpoint.solvers.initial_state.servos import without_positioned
from pitchpoint.solvers.initial_state.speeds import drive_records, speeds_of
from pitchpoint.solvers.initial_state.vibration import with_vibration
from pitchpoint.solvers.load_cycle import LoadCycle, load_cycle
from pitchpoint.solvers.mean_balance import cycle_instants, cycle_notes
from pitchpoint.solvers.model_damping import with_damping
from pitchpoint.solvers.quasistatic.mean_loads import roll_cycle
from pitchpoint.solvers.speed_drift import UNBALANCED
from pitchpoint.system.meshes import forget_contacts
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pitchpoint.model.model import Model


SAME = 1e-6
"""Deviation from a given value up to which it counts as equal [m, rad, m/s, rad/s], as in closing loops."""
WHY = {
    "start": "it follows from loads, loops and drives; start: assembled in the scenario uses given values",
    "speed": "it follows from the speeds of the scenario and the gear ratios",
}


def given_starts(model: Model, key: str) -> Iterator[tuple[str, str, str, float]]:
    """Yield joint, its coordinate, the coordinate name in the system, and the value of all given starts.

    Parameters
    ----------
    model
        The model.
    key
        "start" for coordinates, "speed" for their rates.
    """
    for seat in model.mechanism.seats.values():
        if seat.joint is None:
            continue
        values = getattr(model.joints[seat.joint], key)
        words = COORDINATES[seat.kind] or seat.coordinates
        for word, own in zip(words, seat.coordinates, strict=True):
            if own in values:
                yield seat.joint, own, f"{seat.body}.{word}", values[own]


def start_notes(system: System, state: State, driven: Collection[int]) -> tuple[Message, ...]:
    """Notes on start values or rates of joints from which the initial state deviates.

    Parameters
    ----------
    system
        The system.
    state
        Initial state of the run.
    driven
        Coordinates with prescribed motion; they are reported without a run by
        `model.remarks.keys_without_effect`.
    """
    model = system.model
    if model is None:
        return ()
    found = []
    turns = {int(spin): 2.0 * np.pi * state.turns[body] for spin, body in system.program["spins"]}
    for key in ("start", "speed"):
        for joint, word, name, value in given_starts(model, key):
            k = system.layout.coordinate(name)
            if k in driven:
                continue
            at = float(state.v[k] if key == "speed" else state.q[k] + turns.get(k, 0.0))
            tumbled = key == "start" and _tumbled(system, state, name)
            if abs(at - value) <= SAME and not tumbled:
                continue
            dimension = model.joints[joint].dimension(word)
            unit = RATES[dimension] if key == "speed" else dimension
            now = "elsewhere" if tumbled else f"at {format_quantity(round(at, 9) + 0.0, unit, 4)}"
            found.append(
                Message(
                    f"joints.{joint}.{key}",
                    f"{word} starts {now}, not at {format_quantity(value, unit, 4)}: {WHY[key]}",
                    line=model.line(("joints", joint, key)),
                    kind="note",
                )
            )
    return tuple(found)


def _tumbled(system: System, state: State, name: str) -> bool:
    """Whether the rotation chart of a body refers to another attitude than that of the model file."""
    number = system.layout.bodies.index(name.rpartition(".")[0])
    chart = int(system.program["body"]["chart"][number])
    return chart >= 0 and not np.allclose(state.charts[chart], np.eye(3))


IMBALANCE = 1e-6
"""Net torque over the largest torque above which a run notes that its loads do not balance."""


@dataclass(frozen=True)
class Start:
    """Start of a scenario.

    Parameters
    ----------
    system
        The system with balancing torques and damping.
    state
        State at t = 0.
    notes
        Notes for the user.
    cycle
        Mean torques of pulsating loads, if there are any; of a slow roll at rest over its angle.
    rest
        State without the ripple of these loads: deflected by the mean torques, with the mean rates. Default:
        `state`.
    """

    system: System
    state: State
    notes: tuple[str, ...] = ()
    cycle: LoadCycle | None = None
    rest: State | None = None

    @property
    def mean(self) -> State:
        """State with the mean rates and deflections, without the ripple of pulsating loads."""
        return self.state if self.rest is None else self.rest


def prepare_start(system: System, scenario: Scenario) -> Start:
    """Compute the initial state of a scenario.

    Parameters
    ----------
    system
        Compiled with the same scenario.
    scenario
        Gives speeds and drives.

    Raises
    ------
    SolverError
        If there is no equilibrium to start from.
    """
    forget_contacts(system)
    speeds = speeds_of(system, scenario)
    state = system.initial_state()
    for name, speed in speeds.items():
        if speed != 0.0:
            state.v[system.spin(name)] = speed
    driven = list(driven_coordinates(system))
    for place, (name, record) in zip(driven, drive_records(system), strict=True):
        value, rate, _ = drive_element.target_of(record, 0.0)
        state.q[place], state.v[place] = value, rate
        if place == int(record["spin_i"]):
            _turn_to(system, state, name, value)
    held = without_positioned(system, state, held_spins(system), driven)
    if scenario.start == "assembled":
        state = centred(system, state, {*held, *driven}, loaded=False)
        state, notes = _closed(system, scenario, state, driven)
        mean, cycle = state, None
        if balancing_loads(system):
            system, *_, cycle = _at_rest(system, scenario, state, held, driven)
        state = slipping_clutches(system, state if cycle is None else _rippled(state, cycle))
        state = states_of_inputs(system, slipping_frictions(system, state))
        notes = (*notes, *start_notes(system, state, driven), *_cycle_notes(system, state, cycle, mean))
        return Start(with_damping(system, state), state, notes, cycle, mean)
    state = _from_given(system, state, driven)
    system, found, notes, cycle = _at_rest(system, scenario, state, held, driven)
    state, more = _closed(system, scenario, found.state, driven, rest=True)
    notes = (*notes, *more, *start_notes(system, state, driven))
    mean, system = state, with_damping(system, state)
    if cycle is not None:
        state = with_vibration(system, _rippled(state, cycle), cycle, held, driven)
    return Start(system, state, (*notes, *_cycle_notes(system, state, cycle, mean)), cycle, mean)


def _rippled(state: State, cycle: LoadCycle) -> State:
    """Copy of a state with the ripple of the rates."""
    found = state.copy()
    found.v += cycle.offset
    return found


def _cycle_notes(system: System, state: State, cycle: LoadCycle | None, mean: State) -> tuple[str, ...]:
    """Notes on the mean torques and the ripple, if torques balance them."""
    return () if cycle is None or not balancing_loads(system) else cycle_notes(system, state, cycle, mean.v)


def _at_rest(
    system: System, scenario: Scenario, state: State, held: Sequence[int], driven: Sequence[int]
) -> tuple[System, Equilibrium, tuple[str, ...], LoadCycle | None]:
    """The system with its balancing torques, its equilibrium, notes, and the steady motion under its loads.

    Pulsating loads count with their mean, in the balance and in the equilibrium. The ripple is that at the
    angles of the equilibrium; trains without balancing torque have none at the start.
    """
    balancing = balancing_loads(system)
    cycle = load_cycle(system, state, held, driven)
    if balancing and cycle is None and scenario.quasi_static is not None:
        cycle = roll_cycle(system, state, scenario.quasi_static.mesh)
    mean = system if cycle is None else cycle.applied(system)
    instants = cycle_instants(system, state)[:2] if balancing else NOW
    mean, balanced, fixed, skipped = balance_torques(mean, state, held, driven, instants)
    known = {*driven, *balanced}
    state = centred(mean, state, {*fixed, *known})
    found, signal_notes = rest_of_controls(mean, state, fixed, known)
    mean, found, remarks = settle_clutches(mean, found, driven, balanced)
    notes = (*signal_notes, *_notes(mean, found, {*known, *free_flying(mean)}), *remarks)
    if skipped:
        count = f"{skipped} of {np.count_nonzero(instants[1])} instants of the mesh cycle"
        text = f"the balancing torques are means without {count}, which have no equilibrium"
        notes = (*notes, note(f"{text}, such as those at a missing tooth"))
    if cycle is None:
        return mean, found, notes, None
    records = system.records[LOAD].copy()
    records["value"][balancing] = mean.records[LOAD]["value"][balancing]
    system = system.with_params({LOAD: records})
    deflected = load_cycle(system, found.state, held, driven) or cycle  # of a slow roll at rest: the same
    return system, found, notes, deflected if balancing else replace(deflected, offset=0.0 * deflected.offset)


def _turn_to(system: System, state: State, body: str, angle: float) -> None:
    """Set the angle of a body [rad] as remainder and whole turns, for a shaft at all stations."""
    places = system.model.stations.get(body, (0.0,)) if system.model is not None else (0.0,)
    for name in station_names(body, len(places)):
        number, turns = system.layout.bodies.index(name), round(angle / (2.0 * np.pi))
        state.turns[number] = turns
        state.q[system.spin(name)] = angle - 2.0 * np.pi * turns


def _from_given(system: System, state: State, driven: Sequence[int]) -> State:
    """Initial guess of the equilibrium: loops closed at the start values of the joints.

    Coordinates without load retain these values. Loops that do not close there are closed by the equilibrium.
    """
    model = system.model
    if model is None or not is_looped(system):
        return state
    places = {system.layout.coordinate(c) for c in given(model.mechanism, model, "start")}
    if not places:
        return state
    try:
        return close_loops(system, state, {*driven, *places}, drawn=True)
    except SolverError:
        return state


def _closed(
    system: System, scenario: Scenario, state: State, driven: Sequence[int], rest: bool = False
) -> tuple[State, tuple[str, ...]]:
    """Close the loops with the start values of the joints fixed; returns state and notes.

    With `rest`, the loops are closed by the equilibrium already, and only the rates are made consistent.
    """
    model = system.model
    if model is None or not is_looped(system):
        return state, ()
    if rest:
        rates = {*driven, *(system.layout.coordinate(c) for c in given(model.mechanism, model, "speed"))}
        rates |= {system.spin(body) for body in scenario.speed}
        found = assemble_state(system, state, keep=driven, keep_rates=rates)
        return _passed_on(system, found.state, driven, rates), ()
    keep, rates = (
        {*driven, *(system.layout.coordinate(c) for c in given(model.mechanism, model, key))}
        for key in ("start", "speed")
    )
    rates |= {system.spin(body) for body in scenario.speed}
    found = assemble_state(system, state, keep=keep, keep_rates=rates)
    return _passed_on(system, found.state, keep, rates), found.report()


def _passed_on(system: System, state: State, keep: Collection[int], rates: Collection[int]) -> State:
    """Make the rates consistent with gear trains and closed loops, where trains are joined through loops."""
    if not system.kinds(MESH) or not rates:
        return state
    state.v[:] = rates_through_loops(system, state, rates)
    return assemble_state(system, state, keep=keep, keep_rates=rates).state


def _rounding(system: System, state: State) -> float:
    """Largest rounding error of a force or torque at a state [N, N m]: of stiffness times 1 m and 1 rad."""
    K = rest_matrix(system, state, NEWTON, (0.0, 0.0, 1.0))
    return ROUNDING * float((abs(K) @ (np.abs(state.q) + 1.0)).max(initial=0.0))


def _largest_torque(system: System, found: Equilibrium) -> float:
    """Largest torque of the loads at an equilibrium [N m], of formulas and tables too."""
    names = [f"torque[{name}]" for kind in system.kinds(TORQUE) for name in system.names[kind]]
    places = [k for k, c in enumerate(system.layout.channels) if c.name in names]
    return float(np.abs(found.observe(system)[places]).max(initial=0.0)) if places else 0.0


def _notes(system: System, found: Equilibrium, known: set[int]) -> tuple[Message, ...]:
    """Notes on loads that do not balance, so that the speed will change."""
    notes = []
    least = max(IMBALANCE * _largest_torque(system, found), 1e-9)
    left = [abs(r) for s, r in zip(found.held, found.reaction, strict=True) if s not in known]
    if max(left, default=0.0) > least:
        least = max(least, _rounding(system, found.state))
        if signal_states(system).size:  # torques of controllers
            least = max(least, IMBALANCE * float(acting_torques(system, found.state)[list(found.held)].max()))
    for spin, reaction in zip(found.held, found.reaction, strict=True):
        body = system.layout.coordinates[spin].rsplit(".", 1)[0]
        if spin not in known and abs(reaction) > least:
            notes.append(
                note(
                    f"{UNBALANCED}: net torque of {-reaction:.4g} N m on {body}, so the speed will change",
                    remedy="set one torque to `balance` or drive a body if this is not intended",
                )
            )
    return tuple(notes)
