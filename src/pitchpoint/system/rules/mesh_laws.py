# SPDX-License-Identifier: Apache-2.0
"""Stiffness, damping, friction and excitation of meshes."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.impact import restitution_factor
from pitchpoint.contact.mesh_cycle import pair_cycle
from pitchpoint.contact.stiffness.description import Description, PairShape, PhaseStiffness
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.model.components.stiffness import UserStiffness
from pitchpoint.system.rules.flank_contact import SurfaceContact, surfaces
from pitchpoint.system.rules.stiffness import describe_stiffness
from pitchpoint.system.rules.turning_inertia import turning_inertia

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pitchpoint.model.components.bevel_mesh import BevelMesh
    from pitchpoint.model.components.mesh import ContactDamping, Mesh, TransmissionError
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

HEAVY_LOAD = 0.01
"""Penetration over module of heavily loaded teeth, at which a nonlinear law is linearised."""


@dataclass(frozen=True, kw_only=True)
class MeshLaws:
    """Stiffness, damping, friction and excitation of a mesh; damping in N s/m along the base tangent.

    `surface` is the contact of tooth surfaces, None for a law over the path of contact or the mesh phase.
    `user` are the parameters of a user-defined stiffness law; the law itself is linked by the system.
    """

    stiffness: Description
    surface: SurfaceContact | None = None
    slices: int = 0
    k_ref: float = 0.0
    d_in: float = 0.0
    d_out: float = 0.0
    s_0: float = 1e-6
    smooth: bool = False
    chi: float = 0.0
    d_gap: float = 0.0
    d_start: float = 0.0
    t_end: float = 0.0
    mu: float = 0.0
    v_eps: float = 0.01
    mu_s: float | None = None
    v_s: float | None = None
    e_cos: Array = field(default_factory=lambda: np.zeros(0))
    e_sin: Array = field(default_factory=lambda: np.zeros(0))
    orders1: Array = field(default_factory=lambda: np.zeros((0, 3)))
    orders2: Array = field(default_factory=lambda: np.zeros((0, 3)))
    user: Array | None = None


def mean_stiffness(pair: GearPair, stiffness: Description) -> float:
    """Mean total stiffness of a mesh over one mesh cycle, along the base tangent [N/m^power]."""
    if isinstance(stiffness, PhaseStiffness):
        return stiffness.mean
    return pair_cycle(stiffness, pair.eps_alpha, n=2).mean * stiffness.c_prime * pair.b_w


def usual_slope(pair: GearPair, stiffness: Description) -> float:
    """Mean tangent stiffness of a heavily loaded mesh over one mesh cycle, along the base tangent [N/m]."""
    if isinstance(stiffness, PhaseStiffness):
        return stiffness.mean
    return mean_stiffness(pair, stiffness) / stiffness.c_prime * stiffness.slope(HEAVY_LOAD * pair.gear1.m_n)


def mesh_laws(model: Model, name: str) -> MeshLaws:
    """Stiffness, damping, friction and excitation of one mesh; damping ratios become coefficients."""
    mesh = model.meshes[name]
    stiffness = describe_stiffness(model, name)
    pair = model.pairs[name]
    k = mean_stiffness(pair, stiffness)
    radii = [0.5 * model.gears[g].geometry.d_b for g in mesh.gears]
    whole = stiffness.c_prime * pair.b_w if isinstance(stiffness, PairShape) else None
    losses = flank_losses(model, mesh, radii, (math.cos(pair.gear1.beta_b), whole, k))
    found: dict[str, Any] = {"stiffness": stiffness, "k_ref": k, **losses}
    modified = any(model.gears[g].is_modified for g in mesh.gears)
    grids = modified and isinstance(stiffness, PairShape)
    if mesh.contact is not None:
        gears = [model.gears[g] for g in mesh.gears]
        found["surface"] = surfaces(mesh.contact, pair, gears, (mesh.offset1, mesh.offset2))
    found["slices"] = mesh.slices if mesh.width == "slices" or grids else 0
    if isinstance(mesh.stiffness, UserStiffness):
        found["user"] = np.array(mesh.stiffness.python.parameters or (0.0,))
    if mesh.transmission_error is not None:
        found |= _excitation(mesh.transmission_error)
    return MeshLaws(**found)


def flank_losses(
    model: Model, mesh: Mesh | BevelMesh, radii: Sequence[float], flanks: tuple[float, float | None, float]
) -> dict[str, Any]:
    """Damping and friction of a mesh of gears with the given base radii [m].

    `flanks`: cos(beta_b), stiffness of a pair in contact over the whole face width (None without pairs), and
    mean mesh stiffness, both along the base tangent [N/m].
    """
    cos_b, whole, k = flanks
    critical = 2.0 * math.sqrt(k * _reduced_mass(model, mesh.gears, radii))
    found: dict[str, Any] = {}
    if mesh.damping is not None:
        found |= flank_damping(mesh.damping, cos_b, whole, k, critical)
    if mesh.damper is not None:
        value = mesh.damper.value if mesh.damper.ratio is None else mesh.damper.ratio * critical
        found["d_gap"] = value or 0.0
    if mesh.transient_damping is not None:
        found["d_start"] = mesh.transient_damping.rate / radii[0] ** 2
        found["t_end"] = mesh.transient_damping.until
    if mesh.friction is not None:
        found |= {"mu": mesh.friction.mu, "v_eps": mesh.friction.v_eps}
        found |= {"mu_s": mesh.friction.static, "v_s": mesh.friction.static_speed}
    return found


def put_losses(row: Any, laws: MeshLaws) -> None:
    """Set damping and friction of a mesh record; the geometry must be set.

    Parameters
    ----------
    row
        Record of a mesh of cylindrical or bevel gears.
    laws
        Laws of the mesh.
    """
    contact = row["contact"]
    for name in ("d_in", "d_out", "s_0", "smooth", "chi", "mu", "v_eps"):
        contact[name] = getattr(laws, name)
    contact["mu_s"] = laws.mu if laws.mu_s is None else laws.mu_s
    contact["v_s"] = laws.v_eps if laws.v_s is None else laws.v_s
    contact["normal"] = math.sqrt(1.0 + row["tan_b"] * row["tan_b"])
    row["d_gap"], row["d_start"], row["t_end"] = laws.d_gap, laws.d_start, laws.t_end
    row["rubs"] = laws.mu > 0.0


def flank_damping(
    damping: ContactDamping, cos_b: float, whole: float | None, k: float, critical: float
) -> dict[str, Any]:
    """Contact damping along the base tangent at the mean stiffness k.

    Forces along the base tangent are those normal to the flanks times cos(beta_b), overlaps those divided by
    cos(beta_b). `whole`: stiffness of one pair in contact over the whole face width [N/m]; None without
    pairs.
    """
    if damping.restitution is not None:
        return {"chi": restitution_factor(damping.restitution) / damping.speed * cos_b}
    if damping.pair is not None:
        assert whole is not None  # the model layer requires a law of one pair
        d_in = damping.pair * cos_b**2 * k / whole
    else:
        d_in = (damping.d_in if damping.ratio is None else damping.ratio * critical) or 0.0
    d_out = d_in if damping.d_out is None else damping.d_out
    s_0 = damping.s_0 if damping.pair is None else damping.s_0 / cos_b
    return {"d_in": d_in, "d_out": d_out, "s_0": s_0, "smooth": damping.law == "smooth"}


def _excitation(error: TransmissionError) -> dict[str, Array]:
    """Coefficient arrays of a static transmission error."""
    n = max(len(error.cosine), len(error.sine))
    cosine, sine = np.zeros(n), np.zeros(n)
    cosine[: len(error.cosine)] = error.cosine
    sine[: len(error.sine)] = error.sine
    return {
        "e_cos": cosine,
        "e_sin": sine,
        "orders1": np.array(error.shaft1, dtype=float).reshape(-1, 3),
        "orders2": np.array(error.shaft2, dtype=float).reshape(-1, 3),
    }


def _reduced_mass(model: Model, gears: Sequence[str], radii: Sequence[float]) -> float:
    """Reduced mass of a mesh on its line of action [kg] due to the spins of both gears and attached bodies.

    Zero without bodies.
    """
    inverse = 0.0
    for gear, r_b in zip(gears, radii, strict=True):
        body = model.body_of(gear)
        if body is not None and model.bodies[body].moves != "fixed":
            polar = turning_inertia(model, body)
            inverse += r_b**2 / polar if polar > 0.0 else 0.0
    return 1.0 / inverse if inverse > 0.0 else 0.0
