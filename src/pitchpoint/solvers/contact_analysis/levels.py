# SPDX-License-Identifier: Apache-2.0
"""The same gears at all levels of contact and with a fitted stiffness law: cost and error.

Derivation: docs/theory/flank_contact.md, "Cheaper levels".
"""

from __future__ import annotations

import copy
import math
import time
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.potential_build import Runner, one_after_another
from pitchpoint.contact.potential_range import TableSize
from pitchpoint.core.progress import Progress, silent
from pitchpoint.model.components.flank_contact import (
    FlankContact,
    FlexibleContact,
    PrecomputedContact,
    RigidContact,
)
from pitchpoint.model.write import plain_component
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.law_fit import LawFit, fit_analytic_law
from pitchpoint.solvers.contact_analysis.load_checks import (
    flank_problem,
    misalignment_problem,
    positions_problem,
    refuse,
    torque_problem,
)
from pitchpoint.solvers.contact_analysis.mesh_data import contact_options
from pitchpoint.solvers.contact_analysis.mesh_path import MeshPath
from pitchpoint.solvers.contact_analysis.precompute import TableRequest, contact_table
from pitchpoint.solvers.contact_analysis.solve import contact_dataset, mesh_of, solve_contact
from pitchpoint.system.rules.flexible_teeth import flexible_options

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

SAMPLES = 400
"""Random states at which forces are compared."""
_SEED = 20260131
ROWS = ("rigid", "flexible", "precomputed", "law")
"""Levels in the order of the comparison; `law` is the fitted stiffness law."""


@dataclass(frozen=True, kw_only=True)
class LevelNumbers:
    """Cost and results of one level.

    Attributes
    ----------
    setup_s
        Time to make the mesh ready, for the pre-computed level with its table [s].
    evaluation_s
        Time of one evaluation of force and tangent along the mesh cycle [s].
    te_mean, te_pp
        Transmission error under the torque, mean and peak to peak [m].
    stiffness
        Mean mesh stiffness at the torque, derivative of the force [N/m].
    force_rms, force_max
        Difference of the force from flexible contact at random phases and approaches, over the force of the
        torque.
    """

    setup_s: float
    evaluation_s: float
    te_mean: float
    te_pp: float
    stiffness: float
    force_rms: float
    force_max: float


@dataclass(frozen=True, kw_only=True)
class Levels:
    """Comparison of the levels of one mesh.

    Attributes
    ----------
    fit
        The fitted law and rigid stiffness.
    numbers
        Cost and results by level, `ROWS`.
    table
        Origin of the table: "computed", or the file of the model.
    misalignment
        Misalignment of the flanks in the plane of action [rad].
    analyses
        Contact analyses with surfaces by level, as from `solve_contact`: those of pre-computed contact are
        recomputed from the states of the table.
    phase, transmission_error
        Mesh phases [base pitches] and transmission error under the torque by level [m], shape (n,) each.
    """

    fit: LawFit
    numbers: Mapping[str, LevelNumbers]
    table: str
    misalignment: float
    analyses: Mapping[str, xr.Dataset]
    phase: Array
    transmission_error: Mapping[str, Array]


def compare_levels(
    model: Model,
    mesh: str | None = None,
    *,
    torque: float,
    flank: int = 1,
    misalignment: float | None = None,
    positions: int = 64,
    size: TableSize | None = None,
    run: Runner = one_after_another,
    progress: Progress = silent,
) -> Levels:
    """Cost and error of all levels of contact of a mesh and of the fitted law, against flexible contact.

    Parameters
    ----------
    model
        The model. Flexible contact has the options of its mesh if that is flexible or pre-computed; otherwise
        the defaults.
    mesh
        Name of the mesh; may be omitted if there is only one.
    torque
        Torque on gear 1 [N m]; only the magnitude counts.
    flank
        1: front flanks (gear 1 drives counter-clockwise), -1: back flanks.
    misalignment
        Misalignment of the flanks in the plane of action [rad]; None: that of the housing.
    positions
        Mesh phases over one base pitch.
    size
        Size of the table if the model has none.
    run
        Execution of the tasks of the table, as `build_potential_table`.
    progress
        Called after each level.

    Raises
    ------
    SolverError
        If an argument is out of range, a state has no solution, or the teeth of a gear differ.
    """
    name = mesh_of(model, mesh)
    refuse(
        torque_problem(torque, several=False),
        positions_problem(positions),
        misalignment_problem(misalignment),
        flank_problem(flank),
    )
    torque = float(np.asarray(torque).item())
    if misalignment is not None:
        model = _misaligned(model, name, misalignment, flank)
    flexible = model.replace(f"meshes.{name}.contact", _flexible(model.meshes[name].contact))
    fit = fit_analytic_law(flexible, name, torque, flank)
    began = time.perf_counter()
    precomputed, origin = _precomputed(model, flexible, name, torque, size, run)
    table_s = time.perf_counter() - began if origin == "computed" else 0.0
    models = {
        "flexible": flexible,
        "rigid": model.replace(f"meshes.{name}.contact", _rigid(flexible, name, fit)),
        "precomputed": precomputed,
        "law": model.replace_all({f"meshes.{name}.contact": None, f"meshes.{name}.stiffness": fit.law}),
    }
    phase = np.arange(positions) / positions
    states = FlankStates(flexible, name, flank)
    force = states.force_of(torque)
    first = states.states(phase)
    first["by_force"], first["force"] = 1, force
    states.solve(first)
    reference = _Reference(phase, force, first["x_0"].copy(), float(first["first"].min()))
    found: dict[str, LevelNumbers] = {}
    approach: dict[str, Array] = {}
    analyses: dict[str, xr.Dataset] = {}
    exact: Array | None = None
    for k, (level, one) in enumerate(models.items()):
        path = MeshPath(one, name, flank)
        numbers, forces, approach[level] = _measured(path, reference, exact)
        exact = forces if exact is None else exact
        if level == "precomputed":
            numbers = replace(numbers, setup_s=numbers.setup_s + table_s)
        found[level] = numbers
        if level == "precomputed":
            analyses[level] = _recomputed(states, torque, phase, approach[level])
        elif level != "law":
            analyses[level] = solve_contact(one, name, torque=torque, positions=positions, flank=flank)
        progress(k + 1, len(models), f"{name}: {level}")
    return Levels(
        fit=fit,
        numbers={level: found[level] for level in ROWS},
        table=origin,
        misalignment=states.misalignment,
        analyses={level: analyses[level] for level in ROWS if level in analyses},
        phase=phase,
        transmission_error={level: approach[level] - reference.first for level in ROWS},
    )


@dataclass(frozen=True)
class _Reference:
    """Phases, force [N], approaches of flexible contact and lowest approach of first contact [m]."""

    phase: Array
    force: float
    approach: Array
    first: float


def _misaligned(model: Model, name: str, misalignment: float, flank: int) -> Model:
    """Model whose housing misaligns one flank by an angle in its plane of action [rad]."""
    alpha = model.pairs[name].alpha_wt
    across = flank * misalignment * math.cos(alpha)
    tilts = {"in_plane": misalignment * math.sin(alpha), "out_of_plane": across}
    return model.replace(f"meshes.{name}.misalignment", tilts)


def _recomputed(flanks: FlankStates, torque: float, phase: Array, approach: Array) -> xr.Dataset:
    """Contact analysis at given approaches of flexible contact."""
    at = flanks.states(phase)
    at["x_0"] = approach
    nodes = flanks.solve(at, keep_nodes=True)
    assert nodes is not None
    data = contact_dataset(flanks, np.array([torque]), phase, [(at, nodes)])
    data.attrs |= contact_options(flanks) | {"level": "precomputed", "mesh": flanks.mesh}
    return data


def _measured(
    path: MeshPath, reference: _Reference, exact: Array | None
) -> tuple[LevelNumbers, Array, Array]:
    """Numbers of one level, its forces at the random states, and its approaches under the torque."""
    rng = np.random.default_rng(_SEED)
    psi = rng.random(SAMPLES)
    x = reference.first + (float(reference.approach.max()) - reference.first) * rng.random(SAMPLES)
    forces = path.forces(psi, x)[0]
    error = np.zeros(1) if exact is None else (forces - exact) / reference.force
    approach = path.approaches(reference.phase, reference.force, reference.approach)
    stiffness = path.forces(reference.phase, approach)[1]
    numbers = LevelNumbers(
        setup_s=path.setup_s,
        evaluation_s=path.evaluation_time(reference.phase, approach),
        te_mean=float(approach.mean()) - reference.first,
        te_pp=float(np.ptp(approach)),
        stiffness=float(stiffness.mean()),
        force_rms=float(np.sqrt(np.mean(error**2))),
        force_max=float(np.abs(error).max()),
    )
    return numbers, forces, approach


def _flexible(contact: FlankContact | None) -> FlexibleContact:
    """Flexible contact of a mesh."""
    if isinstance(contact, PrecomputedContact):
        return flexible_options(contact)
    if isinstance(contact, FlexibleContact):
        return contact
    if isinstance(contact, RigidContact):
        return FlexibleContact(
            planes=min(contact.planes, 101), oil=contact.oil, structural=contact.structural
        )
    return FlexibleContact()


def _rigid(flexible: Model, name: str, fit: LawFit) -> RigidContact:
    """Rigid contact with the fitted stiffness and the planes of flexible contact."""
    contact: Any = flexible.meshes[name].contact
    return RigidContact(stiffness=fit.rigid_stiffness, planes=contact.planes)


def _precomputed(
    model: Model, flexible: Model, name: str, torque: float, size: TableSize | None, run: Runner
) -> tuple[Model, str]:
    """Model with pre-computed contact, and the origin of its table."""
    own = model.meshes[name].contact
    if isinstance(own, PrecomputedContact):
        return model, own.file
    request = TableRequest(torque=torque)
    tables = {
        side: contact_table(flexible, name, request, flank, size=size, run=run)
        for side, flank in (("front", 1), ("back", -1))
    }
    options = plain_component(flexible.meshes[name].contact)
    stored = SimpleNamespace(tables=tables, inputs={"contact": options})
    mesh = replace(flexible.meshes[name], contact=PrecomputedContact(file="computed", tables=stored))
    found = copy.copy(flexible)
    # not `Model.replace`, which requires a file
    object.__setattr__(found, "meshes", {**flexible.meshes, name: mesh})
    return found, "computed"
