# SPDX-License-Identifier: Apache-2.0
"""Contact analysis of meshes in their machine: axes as shafts, bearings and housing hold them under load.

A slow roll gives the equilibrium of the whole machine at each position of a mesh over one base pitch. The
contact of its flanks follows from the approach, centre distance and misalignment there; its force is that of
the roll. Meshes of the same mesh frequency share a roll.
"""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError, join_notes, note, split_notes
from pitchpoint.core.kernel import plain
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT, INTERRUPTED, OK, sentence
from pitchpoint.core.words import listed
from pitchpoint.elements.mesh.force_directions import flank_tilt
from pitchpoint.elements.mesh.line_of_action import flank_phase
from pitchpoint.model.components.flank_contact import PrecomputedContact
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.load_checks import method_problem, positions_problem, refuse
from pitchpoint.solvers.contact_analysis.mesh_choice import chosen_meshes, rolled_together, unsuitable
from pitchpoint.solvers.contact_analysis.root_stress import with_root_stress
from pitchpoint.solvers.contact_analysis.solve import contact_attributes, contact_dataset
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.system.compile import compile_model
from pitchpoint.system.meshes import mesh_names, mesh_record

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

IDLE = "it carries no load; load the bodies on both sides of the mesh"
"""Reason of a mesh without load."""
RELIEVED = (
    "it carries no load, as errors of the pins exceed the deflection of the other planets; increase the "
    "torque or reduce the errors"
)
"""Reason of the mesh of a planet without load where others carry load."""
ROUNDING = 1e-13
"""Approach of the flanks from contact that is rounding of the positions of the shafts [m]."""
BOTH = 1e-6
"""Share of the force above which the other flank has it."""
OF_TABLES = 0.05
"""The same with pre-computed contact, whose forces differ by the error of its table."""


@dataclass(frozen=True)
class Position:
    """One position of a mesh in equilibrium: phase [base pitches], approach [m], misalignment [rad], signed
    centre distance and axial offset [m], force along the base tangent [N]."""

    phase: float
    x_0: float
    kappa: float
    distance: float
    dz: float
    force: float


def position_of(record: np.void, force: float, flank: int) -> Position:
    """Position of an evaluated mesh for one of its flanks; `record` is a copy, whose scratch changes.

    Parameters
    ----------
    record
        Record of the mesh.
    force
        Force along the base tangent [N].
    flank
        1: front, -1: back.
    """
    now = record["now"]
    plain(flank_tilt)(record, flank)
    tilt = float(now["kappa"])
    phase = float(plain(flank_phase)(record, flank)) + flank * int(now["turn"])
    x_0 = flank * float(now["u"] - now["e_t"]) - 0.5 * float(now["gap"])
    kappa = 0.0 if record["fixed"] else tilt
    return Position(phase, x_0, kappa, float(now["a"]), float(now["dz"]), force)


@dataclass(frozen=True)
class ContactsOnShafts:
    """Contact analyses of the meshes of a machine in equilibrium.

    Attributes
    ----------
    meshes
        Dataset of each mesh, as of `solve_contact`, with one torque, that of gear 1 in the mean; over
        `mesh_phase_position` also misalignment [rad] and center_distance [m].
    omitted
        Reason by mesh for those that were not analysed.
    failed
        Sentence by mesh for those whose analysis failed; `meshes` has their positions before, if any.
    """

    meshes: dict[str, xr.Dataset] = field(default_factory=dict)
    omitted: dict[str, str] = field(default_factory=dict)
    failed: dict[str, str] = field(default_factory=dict)


def solve_contacts_on_shafts(
    model: Model,
    meshes: Sequence[str] | None = None,
    *,
    scenario: Scenario | str | None = None,
    positions: int = 64,
    root_stress: str | None = None,
    progress: Progress = silent,
) -> ContactsOnShafts:
    """Contact analyses of the meshes of a gearbox, all in equilibrium with its shafts, bearings and loads.

    Parameters
    ----------
    model
        The model; gears in mesh are on bodies.
    meshes
        Names of the meshes; default: all with `contact`. Planets on a carrier are included.
    scenario
        Scenario whose loads apply, or its name; default: the loads at t = 0.
    positions
        Equidistant positions over one base pitch of each mesh.
    root_stress
        As for `solve_contact`.
    progress
        Called after each position of a roll.

    Returns
    -------
    ContactsOnShafts
        Datasets by mesh. Without `meshes`, those with a stiffness law or without load are omitted.

    Raises
    ------
    SolverError
        If an argument is out of range, or the analysis of a mesh fails; the partial result has the other
        meshes.
    """
    refuse(positions_problem(positions), method_problem(root_stress))
    names = chosen_meshes(model, meshes)
    system = compile_model(model, scenario)
    groups = rolled_together(system, names)
    found = ContactsOnShafts(omitted={} if meshes is not None else unsuitable(model))
    statuses: dict[str, int] = {}
    for k, (rolled, group) in enumerate(groups.items()):

        def report(done: float, total: float, note: str = "", before: int = k) -> None:
            """Progress over all rolls."""
            progress(before * total + done, len(groups) * total, note)

        statuses |= _analyse_together(system, rolled, group, positions, root_stress, found, report)
        if INTERRUPTED in statuses.values():
            break
    found = replace(found, meshes={name: found.meshes[name] for name in names if name in found.meshes})
    idle = [name for name, reason in found.failed.items() if reason == IDLE]
    loaded = {model.meshes[name].stage for name in found.meshes} - {None}
    for name in idle:
        if model.meshes[name].stage in loaded:
            found.failed[name] = RELIEVED
    if meshes is None and len(idle) < len(names):
        for name in idle:
            found.omitted[name] = found.failed.pop(name)
    if found.failed:
        left = {statuses[name] for name in found.failed}
        raise SolverError(_sentence(found.failed), INTERRUPTED if INTERRUPTED in left else max(left), found)
    return found


def _sentence(failed: dict[str, str]) -> str:
    """Failures by mesh in one sentence; meshes with the same reason are listed together."""
    reasons: dict[str, list[str]] = {}
    for name, reason in failed.items():
        reasons.setdefault(reason, []).append(name)
    return "; ".join(_words(names, reason) for reason, names in reasons.items())


def _words(names: Sequence[str], reason: str) -> str:
    """Reason of one or more meshes in words.

    Examples
    --------
    >>> _words(["a"], "it carries no load"), _words(["a", "b"], "it carries no load")
    ('mesh a: it carries no load', 'meshes a and b: they carry no load')
    """
    if len(names) == 1:
        return f"mesh {names[0]}: {reason}"
    return f"meshes {listed(names)}: {reason.replace('it carries', 'they carry', 1)}"


def _analyse_together(
    system: System,
    rolled: str,
    group: Sequence[str],
    positions: int,
    root_stress: str | None,
    found: ContactsOnShafts,
    progress: Progress,
) -> dict[str, int]:
    """Roll one mesh and analyse a group of the same mesh frequency; returns the status of those that fail."""
    began = time.perf_counter()
    seen: dict[str, list[tuple[np.void, float]]] = {name: [] for name in group}

    def look(own: System, _: State, row: Array) -> None:
        """Keep the meshes at a position of the roll."""
        names = mesh_names(own)
        for name, kept in seen.items():
            force = float(row[own.layout.channel(f"mesh_force[{name}]")])
            kept.append((mesh_record(own, names.index(name)).copy(), force))

    # points and periods are those of the analysis, not of a slow roll in the scenario
    what = replace(system.scenario or Scenario(), quasi_static=None)
    notes: Sequence[str] = ()
    try:
        roll = roll_through(
            system, what, positions, 1, mesh=rolled, others=False, progress=progress, look=look
        )
        status, text, notes = roll.status, roll.sentence, roll.notes
    except SolverError as error:
        status, text = error.status, str(error)
    model, ended = system.model, dict[str, int]()
    assert model is not None
    for name, kept in seen.items():
        if status != OK:
            ended[name], found.failed[name] = status, text
        if not kept:
            continue
        try:
            # the last position repeats the first
            flanks, data = _analysed(model, name, kept[:positions])
            data = with_root_stress(data, flanks, root_stress)
        except SolverError as error:
            ended[name], found.failed[name] = error.status, str(error)
            continue
        options = {"positions": positions, "flank": flanks.flank, "shafts": "in equilibrium"}
        data.attrs |= contact_attributes(flanks, status, time.perf_counter() - began, **options)
        data.attrs["notes"] = join_notes([*notes, *split_notes(data.attrs["notes"])])
        found.meshes[name] = data
    return ended


def _analysed(model: Model, mesh: str, seen: list[tuple[np.void, float]]) -> tuple[FlankStates, xr.Dataset]:
    """Contact states of a mesh at the positions of a roll: records and forces along the base tangent [N]."""
    mean = float(np.mean([force for _, force in seen]))
    if mean == 0.0:
        raise SolverError(IDLE, INCONSISTENT)
    flank = 1 if mean > 0.0 else -1
    places = [position_of(record, max(flank * force, 0.0), flank) for record, force in seen]
    flanks = FlankStates(model, mesh, flank)
    phase = np.array([p.phase for p in places])
    order = np.argsort((phase - phase.min()) % 1.0, kind="stable")
    states = flanks.states(phase[order] - math.floor(phase.min()))
    for name in ("x_0", "kappa", "distance", "dz"):
        states[name] = np.array([getattr(p, name) for p in places])[order]
    nodes = flanks.solve(states, keep_nodes=True)
    assert nodes is not None
    status = int(states["status"].max())
    if status != OK:
        raise SolverError(sentence(status), status)
    if float((states["x_0"] - states["first"]).max()) < ROUNDING:
        raise SolverError(IDLE, INCONSISTENT)
    force = np.array([p.force for p in places])[order]
    torque = float(np.mean(force)) * float(flanks.record["r_b1"])
    data = contact_dataset(flanks, np.array([torque]), states["pairs"] + states["psi"], [(states, nodes)])
    rolled = "mesh_phase_position"
    data["misalignment"] = (
        (rolled,),
        states["kappa"],
        {"units": "rad", "long_name": "misalignment in the plane of action"},
    )
    data["center_distance"] = (
        (rolled,),
        np.abs(states["distance"]),
        {"units": "m", "long_name": "centre distance under load"},
    )
    apart = np.abs(states["force"] - force)
    data.attrs["force_of_roll"] = float(apart.max() / force.mean())
    limit = OF_TABLES if isinstance(model.meshes[mesh].contact, PrecomputedContact) else BOTH
    wedged = int(np.sum(apart > limit * states["force"].max()))
    if wedged:
        side = "front" if flank > 0 else "back"
        text = (
            f"mesh {mesh}: front and back flanks touch at {wedged} of {len(places)} positions, so that loads "
            f"and pressures are those of the {side} flanks, and the torque is that of both: give the mesh "
            "backlash"
        )
        data.attrs["notes"] = join_notes([note(text), *split_notes(data.attrs["notes"])])
    return flanks, data
