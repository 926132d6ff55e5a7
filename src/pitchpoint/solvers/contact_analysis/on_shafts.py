# SPDX-License-Identifier: Apache-2.0
"""Contact analysis of a mesh in its machine: axes as shafts, bearings and housing hold them under load.

A slow roll gives the equilibrium of the whole machine at each position of the mesh. The contact of its flanks
follows from the approach, centre distance and misalignment there; its force is that of the roll.
"""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import plain
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT, OK, sentence
from pitchpoint.elements.mesh.force_directions import flank_tilt
from pitchpoint.elements.mesh.line_of_action import flank_phase
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.root_stress import check_method, with_root_stress
from pitchpoint.solvers.contact_analysis.solve import contact_attributes, contact_dataset, mesh_of
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.system.compile import compile_model
from pitchpoint.system.meshes import mesh_names, mesh_record

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.system.system import System

Array = NDArray[np.float64]


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


def solve_contact_on_shafts(
    model: Model,
    mesh: str | None = None,
    *,
    scenario: Scenario | str | None = None,
    positions: int = 64,
    root_stress: str | None = None,
    progress: Progress = silent,
) -> xr.Dataset:
    """Contact analysis of a mesh in equilibrium with all shafts, bearings and loads of its model.

    Parameters
    ----------
    model
        The model; both gears are on bodies, and the mesh has `contact`.
    mesh
        Name of the mesh; may be omitted if there is only one.
    scenario
        Scenario whose loads apply, or its name; default: the loads at t = 0.
    positions
        Equidistant positions over one base pitch.
    root_stress
        As for `solve_contact`.
    progress
        Called after each position of the roll.

    Returns
    -------
    xarray.Dataset
        As of `solve_contact`, with one torque, that of gear 1 in the mean; over `mesh_phase_position` also
        misalignment [rad] and center_distance [m].

    Raises
    ------
    SolverError
        If the machine has no equilibrium, or the mesh carries no load; with the partial result.
    """
    name = mesh_of(model, mesh)
    check_method(root_stress)
    began = time.perf_counter()
    chosen = model.scenarios[scenario] if isinstance(scenario, str) else scenario
    system = compile_model(model, chosen)
    if name not in mesh_names(system):
        raise SolverError(f"mesh {name}: its gears are not on bodies; give a torque instead", INCONSISTENT)
    found: list[tuple[np.void, float]] = []

    def look(own: System, row: Array) -> None:
        """Keep the mesh at a position of the roll."""
        force = float(row[own.layout.channel(f"mesh_force[{name}]")])
        found.append((mesh_record(own, mesh_names(own).index(name)).copy(), force))

    roll = roll_through(system, chosen, positions, 1, mesh=name, others=False, progress=progress, look=look)
    found = found[:positions]  # the last position repeats the first
    if roll.status != OK and not found:
        raise SolverError(roll.sentence, roll.status)
    mean = float(np.mean([force for _, force in found]))
    if mean == 0.0:
        raise SolverError(f"mesh {name} carries no load", INCONSISTENT)
    flank = 1 if mean > 0.0 else -1
    places = [position_of(record, abs(force), flank) for record, force in found]
    flanks = FlankStates(model, name, flank)
    data = with_root_stress(_analysed(flanks, places), flanks, root_stress)
    options = {"positions": positions, "flank": flank, "shafts": "in equilibrium"}
    data.attrs |= contact_attributes(flanks, roll.status, time.perf_counter() - began, **options)
    data.attrs["notes"] = "; ".join([*roll.notes, *filter(None, [data.attrs["notes"]])])
    if roll.status != OK:
        raise SolverError(roll.sentence, roll.status, data)
    return data


def _analysed(flanks: FlankStates, places: list[Position]) -> xr.Dataset:
    """Contact states at the positions of a roll."""
    phase = np.array([p.phase for p in places])
    order = np.argsort((phase - phase.min()) % 1.0, kind="stable")
    states = flanks.states(phase[order] - math.floor(phase.min()))
    for field in ("x_0", "kappa", "distance", "dz"):
        states[field] = np.array([getattr(p, field) for p in places])[order]
    nodes = flanks.solve(states, keep_nodes=True)
    assert nodes is not None
    status = int(states["status"].max())
    if status != OK:
        raise SolverError(f"mesh {flanks.mesh}: {sentence(status)}", status)
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
    data.attrs["force_of_roll"] = float(np.abs(states["force"] / force - 1.0).max())
    return data
