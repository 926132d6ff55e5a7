# SPDX-License-Identifier: Apache-2.0
"""Contact analysis of one mesh over mesh phase and torque: transmission error, stiffness, loads, pressure."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.hertz import half_width, peak_pressure, plane_strain_compliance
from pitchpoint.core.errors import Message, SolverError, join_notes, note
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT, INTERRUPTED, OK, sentence
from pitchpoint.elements.mesh.surface.nodes import ON_PATH
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates, under_load
from pitchpoint.solvers.contact_analysis.load_checks import (
    flank_problem,
    method_problem,
    misalignment_problem,
    positions_problem,
    refuse,
    torque_problem,
)
from pitchpoint.solvers.contact_analysis.mesh_data import contact_options, mesh_geometry
from pitchpoint.solvers.contact_analysis.notes import contact_notes
from pitchpoint.solvers.contact_analysis.root_stress import with_root_stress
from pitchpoint.solvers.contact_analysis.stepped_flanks import edge_turns, step_pressures

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

NODE_FIELDS: dict[str, tuple[str, str]] = {
    "plane_force": ("N", "force of a tooth pair in a contact plane along the base tangent"),
    "line_load": ("N/m", "normal force per length of the contact line"),
    "pressure": ("Pa", "Hertzian pressure of the flanks on the line of action"),
    "edge_pressure": ("Pa", "Hertzian pressure of a rounded tip edge on the mating flank"),
    "roll_1": ("m", "length of roll on gear 1, negative inside its base circle"),
    "roll_2": ("m", "length of roll on gear 2, negative inside its base circle"),
}
"""Variables over torque, phase, tooth pair and plane: units and long names."""


def solve_contact(
    model: Model,
    mesh: str | None = None,
    *,
    torque: float | Sequence[float],
    positions: int = 64,
    misalignment: float | None = None,
    flank: int = 1,
    root_stress: str | None = None,
    progress: Progress = silent,
) -> xr.Dataset:
    """Contact analysis of a mesh on fixed axes over one base pitch.

    Parameters
    ----------
    model
        The model; the mesh has `contact`.
    mesh
        Name of the mesh; may be omitted if there is only one.
    torque
        Torque on gear 1, or several [N m]; only the magnitude counts.
    positions
        Equidistant mesh phases over one base pitch, 4 to 100 000.
    misalignment
        Angle between the flanks in the plane of action [rad], at most 0.1: the gap increases by it towards
        +z. None: that of the housing, `misalignment` of the mesh.
    flank
        1: front flanks (gear 1 drives counter-clockwise), -1: back flanks.
    root_stress
        Root stress by "tangent" (30° tangent of the fillet, ISO 6336-3) or "finite_elements" (both;
        seconds per gear, stored). None: finite elements if the teeth of the contact are.
    progress
        Called after each torque.

    Returns
    -------
    xarray.Dataset
        Over `torque` and `mesh_phase_position`: transmission_error [m] (approach of the flanks along the base
        tangent under load), unloaded_transmission_error, mesh_stiffness (tangent) and secant_stiffness [N/m],
        elastic_energy [J]; over these, `tooth_pair` and `plane`: plane_force [N], line_load [N/m],
        pressure, edge_pressure [Pa], lengths of roll roll_1, roll_2 [m]. NaN where a pair has no contact.
        Inside a base circle the length of roll is negative, and the pressures are NaN.
        Pair n is at n + phase base pitches from A in the middle of the face. Over these and `gear` also
        root_stress [Pa], with finite elements root_stress_fe (`with_root_stress`). Geometry of the mesh over
        `gear`, `mark` (A to E) and `plane`, so that `analysis.flank_contact` needs no model.

    Raises
    ------
    SolverError
        If the mesh has no contact of tooth surfaces, arguments are out of range, or a state has no solution;
        with the partial result.
    """
    name = mesh_of(model, mesh)
    refuse(
        torque_problem(torque),
        positions_problem(positions),
        misalignment_problem(misalignment),
        flank_problem(flank),
        method_problem(root_stress),
    )
    torques = np.atleast_1d(np.asarray(torque, dtype=np.float64))
    began = time.perf_counter()
    flanks = FlankStates(model, name, flank)
    kappa = flanks.misalignment if misalignment is None else float(misalignment)
    phase = np.arange(positions) / positions
    found: list[tuple[NDArray[np.void], NDArray[np.void]]] = []
    status, text = OK, sentence(OK)
    try:
        for n, one in enumerate(torques):
            states = flanks.states(phase)
            states["kappa"], states["by_force"] = kappa, 1
            states["force"] = flanks.force_of(float(one))
            nodes = flanks.solve(states, keep_nodes=True)
            assert nodes is not None
            found.append((states, nodes))
            progress(n + 1, torques.size, f"{name}: contact analysis")
            if states["status"].max() != OK:
                status = int(states["status"].max())
                text = _failure(name, float(one), states)
                break
    except KeyboardInterrupt:
        status, text = INTERRUPTED, sentence(INTERRUPTED)
    if not found:
        raise SolverError(text, status)
    data = contact_dataset(flanks, torques[: len(found)], phase, found)
    data = with_root_stress(data, flanks, root_stress)
    options = {"positions": positions, "misalignment": kappa, "flank": flank}
    data.attrs |= contact_attributes(flanks, status, time.perf_counter() - began, **options)
    if status != OK:
        raise SolverError(text, status, data)
    return data


def mesh_of(model: Model, mesh: str | None) -> str:
    """Name of the mesh to analyse.

    Raises
    ------
    SolverError
        If it does not exist, or the model has several and none is given.
    """
    if mesh is None and len(model.meshes) == 1:
        return next(iter(model.meshes))
    if mesh is None or mesh not in model.meshes:
        what = "choose a mesh" if mesh is None else f"no mesh {mesh!r}"
        raise SolverError(f"{what}; there are: {', '.join(model.meshes) or 'none'}", INCONSISTENT)
    return mesh


def _failure(mesh: str, torque: float, states: NDArray[np.void]) -> str:
    """Description of the first state without a solution."""
    bad = states[int(np.argmax(states["status"] != OK))]
    return (
        f"mesh {mesh}: no contact state at {torque:g} N m, mesh phase {bad['pairs'] + bad['psi']:.4f}: "
        f"{sentence(int(bad['status']))}"
    )


def contact_attributes(flanks: FlankStates, status: int, wall_s: float, **options: Any) -> dict[str, Any]:
    """Attributes of a contact analysis: provenance, model, level and options of the contact."""
    from pitchpoint.core.provenance import content_hash, provenance
    from pitchpoint.model.write import model_text

    found = provenance(
        model_hash=content_hash(flanks.model),
        solver="contact",
        options={"mesh": flanks.mesh, "gears": list(flanks.model.meshes[flanks.mesh].gears), **options},
        status=status,
        wall_s=wall_s,
    )
    about = {"title": flanks.model.title, "model_text": model_text(flanks.model), "mesh": flanks.mesh}
    return {**about, **contact_options(flanks), **found}


def contact_dataset(
    flanks: FlankStates, torques: Array, phase: Array, found: list[tuple[NDArray[np.void], NDArray[np.void]]]
) -> xr.Dataset:
    """Dataset of solved states.

    Parameters
    ----------
    flanks
        The mesh.
    torques
        Torques [N m], shape (n,).
    phase
        Mesh phases [base pitches], shape (m,).
    found
        States, shape (m,), and nodes for each torque.
    """
    import xarray as xr

    over = ("torque", "mesh_phase_position")
    size = (len(found), phase.size)
    states = np.array([s for s, _ in found]).reshape(size)
    first, force = states["first"], states["force"]
    error = states["x_0"] - first.min(axis=1, keepdims=True)
    with np.errstate(divide="ignore", invalid="ignore"):  # states without a solution
        secant = force / (states["x_0"] - first)
    curves = {
        "transmission_error": (error, "m", "approach of the flanks along the base tangent"),
        "unloaded_transmission_error": (
            first - first.min(axis=1, keepdims=True),
            "m",
            "the same at vanishing torque",
        ),
        "mesh_force": (force, "N", "force along the base tangent"),
        "mesh_stiffness": (states["stiffness"], "N/m", "derivative of the force by the approach"),
        "secant_stiffness": (secant, "N/m", "force over the approach from contact"),
        "elastic_energy": (states["energy"], "J", "energy stored in teeth and contacts"),
    }
    variables: dict[str, Any] = {
        name: (over, values, {"units": unit, "long_name": text})
        for name, (values, unit, text) in curves.items()
    }
    pairs = _pairs(found)
    fields, hollow = _node_fields(flanks, found, size, pairs)
    for name, values in fields.items():
        unit, text = NODE_FIELDS[name]
        variables[name] = ((*over, "tooth_pair", "plane"), values, {"units": unit, "long_name": text})
    geometry, axes = mesh_geometry(flanks)
    coords = {
        "torque": (("torque",), torques, {"units": "N m", "long_name": "torque on gear 1"}),
        "mesh_phase_position": (
            ("mesh_phase_position",),
            phase,
            {"units": "1", "long_name": "mesh phase, 0 when a pair reaches A at mid-face"},
        ),
        "tooth_pair": (
            ("tooth_pair",),
            list(pairs),
            {"units": "1", "long_name": "tooth pair; base pitches from A at phase 0"},
        ),
        "plane": (("plane",), flanks.widths, {"units": "m", "long_name": "position over the face width"}),
    }
    notes = {"notes": join_notes([*contact_notes(flanks, found), *_hollow_notes(flanks.mesh, hollow)])}
    return xr.Dataset(variables | geometry, coords=coords | axes, attrs=notes)


def _hollow_notes(mesh: str, contacts: int) -> list[Message]:
    """Note if contacts have no pressure because a flank is hollow."""
    if not contacts:
        return []
    return [
        note(
            f"mesh {mesh}: no pressure at {contacts} contacts, as modifications make a flank more concave "
            "there than its mate is convex, such as negative profile_crowning or a steep relief in a ring"
        )
    ]


def _pairs(found: list[tuple[NDArray[np.void], NDArray[np.void]]]) -> range:
    """Tooth pairs that are in contact at any phase and torque; pair n is n base pitches from A at phase 0."""
    numbers = [-node["pair"] for states, nodes in found for node in _loaded(states, nodes)[1:]]
    ends = [(int(n.min()), int(n.max())) for n in numbers if n.size]
    return range(min((e[0] for e in ends), default=0), max((e[1] for e in ends), default=-1) + 1)


def _loaded(states: NDArray[np.void], nodes: NDArray[np.void]) -> tuple[NDArray[np.intp], NDArray[np.void]]:
    """Indices of the phases of all nodes under load, and the nodes."""
    at, k = np.nonzero(under_load(states, nodes))
    return at, nodes[at, k]


def _node_fields(
    flanks: FlankStates,
    found: list[tuple[NDArray[np.void], NDArray[np.void]]],
    size: tuple[int, int],
    numbers: range,
) -> tuple[dict[str, Array], int]:
    """Fields of the contact nodes by tooth pair and plane, NaN without contact; contacts on hollow flanks."""
    record = flanks.record
    planes = int(record["slices"])
    width = (record["now"]["z_hi"] - record["now"]["z_lo"]) / planes
    cos_b = 1.0 / math.sqrt(1.0 + float(record["tan_b"]) ** 2)
    materials = [flanks.model.gears[g].material_data for g in flanks.model.meshes[flanks.mesh].gears]
    soft = [plane_strain_compliance(m.youngs_modulus, m.poisson_ratio) for m in materials]
    fields = {name: np.full((*size, len(numbers), planes), np.nan) for name in NODE_FIELDS}
    turns = np.zeros((*size, len(numbers), planes))
    for t, (states, nodes) in enumerate(found):
        at, node = _loaded(states, nodes)
        where = (t, at, -node["pair"] - numbers.start, node["plane"])
        one, two = node["roll"].T
        rolls = np.sign(record["r_b1"]) * one, np.sign(record["r_b2"]) * two
        load = node["force"] / width
        on_path = node["place"] == ON_PATH
        inside = np.minimum(*rolls) <= 0.0  # without a radius of curvature
        with np.errstate(divide="ignore", invalid="ignore"):
            radius = np.where(inside | ~on_path, np.nan, one * two / (one + two) / cos_b)
            edge = np.where(inside | on_path, np.nan, _edge_radius(record, node) / cos_b)
        fields["plane_force"][where] = node["force"]
        fields["line_load"][where] = load
        fields["pressure"][where] = peak_pressure(load, half_width(load, radius, *soft))
        fields["edge_pressure"][where] = peak_pressure(load, half_width(load, edge, *soft))
        fields["roll_1"][where], fields["roll_2"][where] = rolls
        turns[where] = edge_turns(record, node)
    return fields, step_pressures(flanks, fields, turns)


def _edge_radius(record: np.void, node: NDArray[np.void]) -> Array:
    """Reduced radius of a rounded tip edge on its mate, transverse section [m]; NaN for sharp edges."""
    edge = np.clip(node["place"] - 1, 0, 1)
    own = np.asarray(record["rounding"])[edge]
    mate = node["roll"][np.arange(node.size), 1 - edge]
    return np.where(own > 0.0, own * mate / (own + mate), np.nan)
