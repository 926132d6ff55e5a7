# SPDX-License-Identifier: Apache-2.0
"""Cheap descriptions of a mesh from its contact of tooth surfaces: stiffness law and rigid contact.

Derivation: docs/theory/flank_contact.md, "Cheaper levels".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT, OK, REFUSED, sentence
from pitchpoint.elements.mesh.surface.nodes import ON_PATH
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates, under_load
from pitchpoint.solvers.contact_analysis.load_checks import flank_problem, refuse, torque_problem
from pitchpoint.solvers.contact_analysis.solve import mesh_of

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

POSITIONS = 64
"""Mesh phases of a fit."""
_RAMPS = np.linspace(0.0, 1.0, 41)
"""Tip-relief factors T_R that are compared."""
_LEVELS = ("rigid", "flexible")


@dataclass(frozen=True, kw_only=True)
class LawFit:
    """Stiffness law of a mesh fitted to its contact of tooth surfaces.

    Attributes
    ----------
    mesh
        Name of the mesh.
    torque
        Torque on gear 1 of the fit [N m], a magnitude.
    flank
        1: front flanks, -1: back flanks.
    c_prime, S_R, T_R
        Single stiffness [N/m^2], stiffness ratio and tip-relief factor of the law `din3990`.
    rigid_stiffness
        Best constant stiffness of a tooth pair normal to the flanks [N/m], for `level: rigid`.
    pair_error
        Force of one tooth pair in one plane, law against contact: rms over rms of the force.
    mesh_error
        Mesh force over the cycle at the approaches of the contact, rms and maximum over the mesh force.
    rigid_error
        The same of the rigid contact.
    """

    mesh: str
    torque: float
    flank: int
    c_prime: float
    S_R: float
    T_R: float
    rigid_stiffness: float
    pair_error: float
    mesh_error: tuple[float, float]
    rigid_error: tuple[float, float]

    @property
    def law(self) -> dict[str, Any]:
        """`stiffness` of the mesh for a model file, in SI units."""
        return {
            "law": "din3990",
            "single_stiffness": self.c_prime,
            "stiffness_ratio": self.S_R,
            "tip_relief_factor": self.T_R,
        }


@dataclass(frozen=True)
class _Nodes:
    """Contact nodes of all phases: phase index, position on the path [base pitches], penetration [m], force
    [N], width of a plane [m]."""

    phase: NDArray[np.intp]
    place: Array
    x: Array
    force: Array
    plane: float


def fit_analytic_law(model: Model, mesh: str | None = None, torque: float = 0.0, flank: int = 1) -> LawFit:
    """Parabola of the single stiffness, and constant stiffness, that fit the contact of a mesh.

    Parameters
    ----------
    model
        The model; the mesh has rigid or flexible contact.
    mesh
        Name of the mesh; may be omitted if there is only one.
    torque
        Torque on gear 1 [N m]; only the magnitude counts.
    flank
        1: front flanks (gear 1 drives counter-clockwise), -1: back flanks.

    Returns
    -------
    LawFit
        Law, rigid stiffness and their errors.

    Raises
    ------
    SolverError
        If the mesh has no rigid or flexible contact, an argument is out of range, or a state has no solution.

    Notes
    -----
    A node of the law at the path position p carries c′ Δb s(p; S_R, T_R) x with the penetration x without
    deformation. S_R and T_R minimise the sum of squared differences of the node forces over the path from A
    to E, T_R in steps of 0.025; c′ then minimises that of the mesh force over the cycle, which includes tip
    edges. The rigid stiffness minimises the latter for a force that is proportional to the penetration.
    """
    name = mesh_of(model, mesh)
    contact = model.meshes[name].contact
    if contact is None or contact.level not in _LEVELS:
        raise SolverError(
            f"mesh {name}: a law is fitted to rigid or flexible contact; "
            "give it `contact: {level: flexible}`",
            INCONSISTENT,
        )
    refuse(torque_problem(torque, several=False), flank_problem(flank))
    torque = float(np.asarray(torque).item())
    flanks = FlankStates(model, name, flank)
    force = flanks.force_of(torque)
    nodes, eps_alpha = _loaded_nodes(flanks, force)
    on_path = (nodes.place >= 0.0) & (nodes.place <= eps_alpha) & np.isfinite(nodes.place)
    S_R, T_R, pair_error = _shape(nodes, on_path, eps_alpha)
    shape = np.where(on_path, _along(np.where(on_path, nodes.place, 0.0), eps_alpha, S_R, T_R), 0.0)
    c_prime, mesh_error = _scale(nodes, shape, force)
    k, rigid_error = _scale(nodes, np.ones_like(nodes.x), force)
    pair = model.pairs[name]
    return LawFit(
        mesh=name,
        torque=abs(torque),
        flank=flank,
        c_prime=c_prime,
        S_R=S_R,
        T_R=T_R,
        # F_n over x_n of the whole width: along the base tangent F_bt = F_n cos β_b, x_bt = x_n/cos β_b
        rigid_stiffness=k * pair.b_w / math.cos(pair.gear1.beta_b) ** 2,
        pair_error=pair_error,
        mesh_error=mesh_error,
        rigid_error=rigid_error,
    )


def _loaded_nodes(flanks: FlankStates, force: float) -> tuple[_Nodes, float]:
    """Contact nodes under load at all phases, and the transverse contact ratio."""
    states = flanks.states(np.arange(POSITIONS) / POSITIONS)
    states["by_force"], states["force"] = 1, force
    nodes = flanks.solve(states, keep_nodes=True)
    assert nodes is not None
    if states["status"].max() != OK:
        status = int(states["status"].max())
        raise SolverError(f"mesh {flanks.mesh}: no contact state: {sentence(status)}", status)
    at, k = np.nonzero(under_load(states, nodes))
    node = nodes[at, k]
    record = flanks.record
    now = record["now"]
    place = (node["xi"] - now["xi_A"]) / record["p_bt"]
    place = np.where(node["place"] == ON_PATH, place, np.nan)
    plane = float(now["z_hi"] - now["z_lo"]) / int(record["slices"])
    return _Nodes(at, place, node["x"], node["force"], plane), float(now["eps"])


def _along(place: Array, eps_alpha: float, S_R: float, T_R: float) -> Array:
    """Stiffness over c′ at positions on the path."""
    return PairShape(c_prime=1.0, S_R=S_R, T_R=T_R).along(place, eps_alpha)


def _shape(nodes: _Nodes, on_path: NDArray[np.bool_], eps_alpha: float) -> tuple[float, float, float]:
    """S_R, T_R and relative error of the node forces on the path."""
    p, x, force = nodes.place[on_path], nodes.x[on_path], nodes.force[on_path]
    if np.unique(p.round(9)).size < 3:
        raise SolverError(
            "fewer than three positions on the path of contact are under load; increase torque or planes",
            REFUSED,
        )
    best = (math.inf, 1.0, 0.0)
    for T_R in _RAMPS:
        ramp = _along(p, eps_alpha, 1.0, float(T_R))
        unit = nodes.plane * x * ramp
        # c′ (1 - (1 - S_R) q²) = c′ S_R + c′ (1 - S_R)(1 - q²)
        hump = 1.0 - (2.0 * p / eps_alpha - 1.0) ** 2
        found = _non_negative(unit, unit * hump, force)
        rest = float(np.sum((force - found[0] * unit - found[1] * unit * hump) ** 2))
        if rest < best[0] * (1.0 - 1e-6) - 1e-18 * float(np.sum(force**2)):
            best = rest, found[0] / (found[0] + found[1]), float(T_R)
    return best[1], best[2], math.sqrt(best[0] / float(np.sum(force**2)))


def _non_negative(one: Array, two: Array, values: Array) -> tuple[float, float]:
    """Non-negative coefficients of two columns by least squares."""
    free = np.linalg.lstsq(np.column_stack([one, two]), values, rcond=None)[0]
    if free.min() >= 0.0:
        return float(free[0]), float(free[1])
    alone = [max(0.0, float(c @ values) / float(c @ c)) for c in (one, two)]
    rests = [float(np.sum((values - a * c) ** 2)) for a, c in zip(alone, (one, two), strict=True)]
    return (alone[0], 0.0) if rests[0] <= rests[1] else (0.0, alone[1])


def _scale(nodes: _Nodes, shape: Array, force: float) -> tuple[float, tuple[float, float]]:
    """Factor of the mesh force by least squares over the cycle, and its errors, rms and maximum."""
    unit = np.bincount(nodes.phase, nodes.plane * nodes.x * shape, POSITIONS)
    factor = force * float(unit.sum()) / float(unit @ unit)
    error = np.abs(factor * unit / force - 1.0)
    return factor, (float(np.sqrt(np.mean(error**2))), float(error.max()))
