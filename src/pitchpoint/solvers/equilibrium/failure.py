# SPDX-License-Identifier: Apache-2.0
"""Reasons why a system has no equilibrium: loaded unconstrained directions, broken teeth, clearance."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.units import format_quantity
from pitchpoint.elements import registry
from pitchpoint.model.axial_supports import without_axial_support
from pitchpoint.model.components.tooth_faults import BrokenBevelTooth, BrokenTooth
from pitchpoint.model.rings import ring_bodies
from pitchpoint.solvers.element_batches import free_flying
from pitchpoint.solvers.equilibrium.approach import line_and_open_contacts
from pitchpoint.solvers.equilibrium.force_jumps import Rest
from pitchpoint.solvers.equilibrium.unknowns import inverse_of
from pitchpoint.solvers.unloaded_flanks import close_backlash
from pitchpoint.system import evaluate
from pitchpoint.system.remarks import DEEPEST
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.source import coordinate_source
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


HELD = 1e-12
"""Stiffness over the largest, all weighted as lengths, up to which a direction counts as unconstrained."""
LOADED = 1e-6
"""Share of the loads in unconstrained directions from which these are reported as the reason."""
SHARE = 0.5
"""Share of a coordinate in those directions, over the largest, from which it is listed."""
SLACK = 1e-3
"""Stiffness over that without clearance up to which a body is free within its clearance."""
SLOWLY = 1.0
"""Mass factor [1/s^2] of the step that shows where the residual moves the bodies."""
STIFFNESS = {"x": "radial", "y": "radial", "z": "axial", "rx": "tilt", "ry": "tilt", "spin": "torsion"}
FAR = 0.01
"""Axial displacement [m] from which a body has left its bearings."""
WORDS = {
    "radial": "across its axis",
    "axial": "along its axis",
    "tilt": "against tilting",
    "torsion": "about its axis",
}
NAMES = {"alpha": "rx", "beta": "ry"}
"""Names of coordinates in model files and channels."""


def reason(
    system: System, begin: State, free: NDArray[np.int64], found: Rest, steps: int, worst: int
) -> tuple[str, bool]:
    """Message on an iteration that did not converge, and whether a direction is unconstrained.

    Parameters
    ----------
    system
        The system.
    begin
        Initial state of the iteration.
    free
        Coordinates that are not held.
    found
        Last state of the iteration.
    steps
        Number of steps.
    worst
        Coordinate farthest from its goal.
    """
    if names := unconstrained(system, begin, free):
        where = line_and_open_contacts(system, begin, names[0])
        return f"no equilibrium: {advice(names)}{where}{_in_flight(system, names)}", True
    name, words = run_away(system, found.state)
    if name:
        return f"no equilibrium: {words}{_line_of(system, name)}", True
    size = f"{abs(found.residual[worst]):.3g} {'N m' if system.weight[worst] != 1.0 else 'N'}"
    where = coordinate_source(system, system.layout.coordinates[worst])
    remedy = in_clearance(system, found.state, free) or "check loads and stiffness"
    return f"no equilibrium found after {steps} steps: {size} are unbalanced on {where}; {remedy}", False


def _line_of(system: System, name: str) -> str:
    return coordinate_source(system, name).removeprefix(name)


def in_clearance(system: System, state: State, free: NDArray[np.int64]) -> str:
    """Message on a body that the residual moves freely within the clearance of its bearings, or ''.

    Free: without the clearance the stiffness in this direction is more than `1/SLACK` times larger.

    Parameters
    ----------
    system
        The system.
    state
        Last state of the iteration, which did not converge.
    free
        Coordinates that are not held.
    """
    if system.model is None:
        return ""
    own, weight = system.copy(), system.weight[free]
    force = evaluate.residual(own, state)[free]
    mass, stiffness = (
        evaluate.matrix(own, state, *f, NEWTON)[np.ix_(free, free)] for f in ((1, 0, 0), (0, 0, 1))
    )
    moved = inverse_of(stiffness + SLOWLY * mass, np.sqrt(mass.diagonal()))(force)
    for kind, records in own.records.items():
        if (close := registry.find(kind).close) is not None:
            close(records)
    closed = evaluate.matrix(own, state, 0.0, 0.0, 1.0, NEWTON)[np.ix_(free, free)]
    if abs(moved @ stiffness @ moved) > SLACK * (moved @ closed @ moved):
        return ""
    length = np.abs(moved * weight)
    k = int(free[np.argmax(length)])
    body = system.layout.coordinates[k].partition(".")[0]
    bearings = [name for name, part in system.model.rolling_bearings.items() if body in ring_bodies(part)]
    bearings += [name for name, part in system.model.plain_bearings.items() if body in ring_bodies(part)]
    if not bearings:
        return ""
    return (
        f"{body} moves freely within the clearance of {_listed(bearings)}, where almost no force holds it: "
        "reduce the clearance (clearance: 0, axial_clearance: 0), or add a load that the bearing supports, "
        "such as gravity"
    )


def unconstrained(system: System, state: State, free: NDArray[np.int64]) -> tuple[str, ...]:
    """Names of the loaded, unconstrained coordinates, with flanks in contact and bearings without clearance.

    Loads in the null space of the (symmetric) stiffness matrix have no equilibrium.

    Parameters
    ----------
    system
        The system.
    state
        Initial state of the iteration.
    free
        Coordinates that are not held.
    """
    own, at = system.copy(), state.copy()
    close_backlash(own, at)
    free = np.setdiff1d(free, system.states)  # no bearing holds the state of a controller
    weight = own.weight[free]
    loads = evaluate.residual(own, at)[free] / weight
    for kind, records in own.records.items():
        if (close := registry.find(kind).close) is not None:
            close(records)
    stiffness = evaluate.matrix(own, at, 0.0, 0.0, 1.0, NEWTON)[np.ix_(free, free)]
    _, sizes, rows = np.linalg.svd(stiffness / np.outer(weight, weight))
    null = rows[sizes <= HELD * sizes.max(initial=0.0)]
    pushed = np.abs((null @ loads) @ null)
    if not pushed.max(initial=0.0) > LOADED * np.abs(loads).max(initial=0.0):
        return ()
    parts = [system.layout.coordinates[k].rpartition(".") for k in free]
    share = np.where(pushed > 1e-3 * pushed.max(), (null**2).sum(axis=0), 0.0)
    spins = np.array([name == "spin" for _, _, name in parts])
    if share[~spins].any():
        share[spins] = 0.0  # the spin only follows the displacement of its gear
    named = np.flatnonzero(share >= SHARE * share.max())
    return tuple(f"{parts[k][0]}.{NAMES.get(parts[k][2], parts[k][2])}" for k in named)


def advice(names: tuple[str, ...]) -> str:
    """Message on unconstrained coordinates, with a remedy.

    Examples
    --------
    >>> advice(("driven.x", "driven.y", "driven.z", "driven.2.z"))
    'nothing holds driven across its axis and along its axis: add a bearing with radial and axial stiffness'
    """
    found: dict[str, dict[str, None]] = {}
    for name in names:
        body, _, coordinate = name.rpartition(".")
        found.setdefault(body.partition(".")[0], {})[coordinate] = None
    bodies: dict[tuple[str, ...], list[str]] = {}
    for body, coordinates in found.items():
        bodies.setdefault(_directions(coordinates), []).append(body)
    held = " and ".join(f"{_listed(who)} {_in_words(how, len(who) > 1)}" for how, who in bodies.items())
    kinds = dict.fromkeys(STIFFNESS[name.rpartition(".")[2]] for name in names)
    bearing = "a bearing" if len(found) == 1 else "bearings"
    return f"nothing holds {held}: add {bearing} with {_listed(kinds)} stiffness"


def _in_flight(system: System, names: tuple[str, ...]) -> str:
    """How to start the unconstrained bodies if they are connected to no other, or ''."""
    bodies = {system.layout.coordinates[k].rpartition(".")[0] for k in free_flying(system, loaded=True)}
    flies = {name.rpartition(".")[0] for name in names} <= bodies
    return "; `start: assembled` in the scenario starts a body in free flight" if flies else ""


def run_away(system: System, state: State) -> tuple[str, str]:
    """Name of a body that moved out of bearings that do not hold it along its axis, and the message; or ''.

    Parameters
    ----------
    system
        The system.
    state
        Last state of the iteration, which did not converge.
    """
    for body, bearings, side in () if system.model is None else without_axial_support(system.model):
        moved = float(state.q[system.layout.coordinates.index(f"{body}.z")])
        if side == 0 and abs(moved) > FAR:
            supports = "support" if bearings[1:] else "supports"
            return f"{body}.z", (
                f"nothing holds {body} along its axis: {_listed(bearings)} {supports} no axial force; use a "
                "bearing that supports axial forces"
            )
        if side and -side * moved > FAR:
            held, free = ("+z", "-z") if side > 0 else ("-z", "+z")
            return f"{body}.z", (
                f"nothing holds {body} along its axis in its {free} direction: {_listed(bearings)} support "
                f"{held} only; turn one of its bearings around (axial_force_absorption), or add one"
            )
    return "", ""


def _directions(coordinates: Iterable[str]) -> tuple[str, ...]:
    """Directions of the coordinates of a body in words; x or y alone are named."""
    seen = dict.fromkeys(STIFFNESS[c] for c in coordinates)
    only = [c for c in coordinates if STIFFNESS[c] == "radial"]
    in_x = f" in {only[0]}" if len(only) == 1 else ""
    return tuple(WORDS[kind] + (in_x if kind == "radial" else "") for kind in seen)


def _in_words(directions: Iterable[str], several: bool) -> str:
    """Directions of one body or of several."""
    found = _listed(directions)
    return found.replace("its axis", "their axes") if several else found


def _listed(words: Iterable[str]) -> str:
    """Words as a list with "and"."""
    *first, last = words
    return f"{', '.join(first)} and {last}" if first else last


def broken_tooth(system: System, state: State) -> str:
    """Message on a mesh whose only equilibrium has excessive penetration because of a broken tooth, or ''.

    All pairs of a mesh have the same penetration along the line of action. If a broken tooth leaves no pair
    in contact, the gears rotate under their load until another pair reaches the path of contact, at a
    penetration of some millimetres, where it carries any load. Real teeth would touch outside the path of
    contact long before, which no flank law here covers.

    Parameters
    ----------
    system
        The system.
    state
        Last state of the iteration, converged or not.
    """
    gaps = tooth_gaps(system)
    if system.model is None or not gaps:
        return ""
    values = evaluate.observe(system, state)
    for mesh, (channel, most) in gaps.items():
        deflection = abs(float(values[channel]))
        if deflection > most:
            depth, faults = deflection - 0.5 * system.model.backlash(mesh), _broken(system.model)[mesh]
            return (
                f"no equilibrium: no tooth pair carries load in the mesh {mesh} in this position, where "
                f"{' or '.join(faults)} leaves a gap (penetration of the next pair: "
                f"{format_quantity(depth, 'length', 3)}); run a time response, which passes through the gap "
                "(with start: assembled to begin in it), reduce the severity, or increase the contact ratio"
            )
    return ""


def tooth_gaps(system: System) -> dict[str, tuple[int, float]]:
    """Channel of the deflection of each mesh with a broken tooth, and the largest one of an equilibrium [m].

    Parameters
    ----------
    system
        The system.
    """
    model, found = system.model, {}
    known = {c.name: k for k, c in enumerate(system.layout.channels)}
    for mesh in {} if model is None else _broken(model):
        if model is not None and f"deflection[{mesh}]" in known:
            first = model.every_mesh[mesh].gears[0]
            shape = (model.gears[first] if first in model.gears else model.bevel_gears[first]).geometry
            most = 0.5 * model.backlash(mesh) + DEEPEST * shape.m_n
            found[mesh] = known[f"deflection[{mesh}]"], float(most)
    return found


def _broken(model: Model) -> dict[str, list[str]]:
    """Broken-tooth faults of the gears of each mesh, with their lines in the model file."""
    found: dict[str, list[str]] = {}
    for name, mesh in model.every_mesh.items():
        for gear in mesh.gears:
            section = "gears" if gear in model.gears else "bevel_gears"
            for label, fault in getattr(model, section)[gear].faults.items():
                if isinstance(fault, BrokenTooth | BrokenBevelTooth) and fault.severity > 0.0:
                    line = model.line((section, gear, "faults", label))
                    where = f" (line {line})" if line else ""
                    found.setdefault(name, []).append(f"{section}.{gear}.faults.{label}{where}")
    return found
