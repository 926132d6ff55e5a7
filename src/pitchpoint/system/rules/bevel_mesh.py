# SPDX-License-Identifier: Apache-2.0
"""Records of bevel meshes from bevel gear pairs and their laws."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.mesh_cycle import pair_cycle
from pitchpoint.contact.stiffness.description import Description, PairShape, PhaseStiffness
from pitchpoint.contact.stiffness.din3990 import LOW_LOAD, SingleStiffness, VirtualTooth, stiffness_of_teeth
from pitchpoint.elements.mesh.bevel import record as layout
from pitchpoint.elements.signal import Pool
from pitchpoint.geometry.bevel.cones import spherical_involute
from pitchpoint.geometry.tooth_faults import displaced_gap
from pitchpoint.model.bevel_places import pitch_ray, turned_to
from pitchpoint.model.carried_trains import carrying
from pitchpoint.model.components.stiffness import ConstantStiffness
from pitchpoint.model.components.tooth_faults import PitchError
from pitchpoint.model.frames import body_frame
from pitchpoint.model.mechanism import seat_frame
from pitchpoint.model.shafts import middle_of
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import seat_at
from pitchpoint.system.rules.mesh_laws import MeshLaws, flank_losses, put_losses
from pitchpoint.system.rules.places import Places

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel.pair import BevelPair
    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Placement:
    """Position of the two gears of a bevel mesh with all coordinates zero.

    Parameters
    ----------
    axes1, axes2
        Body frames in world axes, columns; each gear rotates about its third axis.
    apexes
        Positions of the apexes along these axes, from the body origins [m].
    sides
        +1 for a pitch cone that opens towards +z of the body, -1 towards -z.
    angles
        Angles of the centre of tooth 0 at spin 0 about +z of the bodies, from their x axes [rad]; None: a
        tooth of gear 1 and a space of gear 2 are on the pitch ray.
    """

    axes1: Array = field(default_factory=lambda: np.eye(3))
    axes2: Array = field(default_factory=lambda: np.eye(3))
    apexes: tuple[float, float] = (0.0, 0.0)
    sides: tuple[float, float] = (1.0, 1.0)
    angles: tuple[float, float] | None = None


def pitch_rays(place: Placement) -> tuple[float, float]:
    """Angles of the pitch ray about +z of both bodies at zero spin, from their x axes [rad]."""
    one, two = place.sides[0] * place.axes1[:, 2], place.sides[1] * place.axes2[:, 2]
    return pitch_ray(place.axes1, one, two), pitch_ray(place.axes2, two, one)


def square_mean(pair: BevelPair) -> float:
    """Integral of (R/R_m)^2 over the common face width [m]: slices are weighted by lever arm squared."""
    return (pair.R_e**3 - pair.R_i**3) / (3.0 * pair.R_m**2)


def mean_stiffness(pair: BevelPair, stiffness: Description) -> float:
    """Mean total stiffness of a bevel mesh over a mesh cycle, along the base tangent at R_m [N/m]."""
    if isinstance(stiffness, PhaseStiffness):
        return stiffness.mean
    return pair_cycle(stiffness, pair.eps_alpha, n=2).mean * stiffness.c_prime * square_mean(pair)


def _cones(row: Any, pair: BevelPair, place: Placement) -> None:
    g1, g2 = pair.gear1, pair.gear2
    row["side"], row["apex"] = place.sides, place.apexes
    row["z1"], row["z2"] = (int(s * g.z) for s, g in zip(place.sides, (g1, g2), strict=True))
    row["R_m"] = R = pair.R_m
    # ratio from the numbers of teeth: rounded cone angles must not cause a drift between the gears
    base = math.sin(g1.delta_b)
    row["base"] = base, base * g2.z / g1.z
    row["tip"] = g1.sigma_a, g2.sigma_a
    row["r_b1"], row["r_b2"] = R * row["side"] * row["base"]
    row["p_bt"] = R * pair.sigma_p
    row["tan_b"] = math.tan(pair.beta_b)
    row["z_lo"], row["z_hi"] = pair.R_i - R, pair.R_e - R
    rays = pitch_rays(place)
    row["towards"] = [(math.cos(ray), math.sin(ray)) for ray in rays]


def _assembly(row: Any, pair: BevelPair, place: Placement, backlash: float) -> None:
    """Set backlash and initial phase from a tooth of gear 1 and a space of gear 2 next to the pitch ray."""
    gears = (pair.gear1, pair.gear2)
    half = [pair.R_m * math.sin(g.delta_b) * g.psi_b for g in gears]
    rolls = sum(pair.R_m * math.sin(g.delta_b) * spherical_involute(g.sigma_w, g.delta_b) for g in gears)
    row["gap_0"] = backlash - 2.0 * rolls
    tooth = space = 0.0
    p_bt = float(row["p_bt"])
    if place.angles is not None:
        rays = pitch_rays(place)
        tooth, space = (
            abs(float(row[f"r_b{k + 1}"])) * place.sides[k] * (place.angles[k] - rays[k]) for k in range(2)
        )
        space += 0.5 * p_bt
    row["t1_0"] = -round(tooth / p_bt)
    tooth += p_bt * row["t1_0"]
    offset = math.remainder(tooth + space, p_bt)
    row["t2_0"] = -round((tooth + space - offset) / p_bt)
    space = offset - tooth
    row["u0"] = offset
    rest = half[0] - half[1] + 0.5 * p_bt
    row["xi_0"], row["xi_b"] = 0.5 * (rest + tooth - space), 0.5 * (rest - tooth + space)


def _stiffness(row: Any, pair: BevelPair, stiffness: Description) -> None:
    row["contact"]["power"] = 1.0
    if isinstance(stiffness, PairShape):
        row["source"] = layout.PROFILE
        row["c_prime"], row["S_R"], row["T_R"] = stiffness.c_prime, stiffness.S_R, stiffness.T_R
        row["load_limit"] = stiffness.load_limit
        row["n_pair"] = math.ceil(pair.eps_gamma) + 1
    else:
        row["source"] = layout.PHASE
        row["c_prime"], row["spread"] = stiffness.mean, 1.0 / square_mean(pair)


def bevel_row(pair: BevelPair, place: Placement, laws: MeshLaws, backlash: float | None = None) -> np.void:
    """Record of one bevel mesh; body indices, block indices and outputs are set by `assemble`.

    Parameters
    ----------
    pair
        The gear pair; the apexes coincide with all coordinates zero.
    place
        Position of the gears.
    laws
        Stiffness (a parabola, or a constant total one), damping and friction.
    backlash
        Total gap along the base tangent at the mean cone distance [m]; None: backlash of the geometry.

    Returns
    -------
    numpy.void
        One row of `mesh.bevel.record.RECORD`.
    """
    row = np.zeros(1, layout.RECORD)[0]
    _cones(row, pair, place)
    _assembly(row, pair, place, pair.R_m * pair.sigma_j if backlash is None else backlash)
    _stiffness(row, pair, laws.stiffness)
    row["contact"]["k_ref"] = row["k_step"] = laws.k_ref or mean_stiffness(pair, laws.stiffness)
    put_losses(row, laws)
    return row


def bevel_single_stiffness(model: Model, name: str) -> SingleStiffness:
    """Single and mesh stiffness of a bevel mesh to DIN 3990 for its virtual cylindrical gears."""
    pair = model.bevel_pairs[name]
    one, two = (
        VirtualTooth(g.z_vn, g.x_hm, g.rack.h_fP_star, g.alpha_n, g.beta_m) for g in (pair.gear1, pair.gear2)
    )
    gears = [model.bevel_gears[g] for g in model.bevel_meshes[name].gears]
    E1, E2 = (g.material_data.youngs_modulus for g in gears)
    return stiffness_of_teeth((one, two), pair.eps_alpha, moduli=(E1, E2))


def bevel_stiffness(model: Model, name: str) -> Description:
    """Stiffness description of a bevel mesh by the law in the model."""
    law = model.bevel_meshes[name].stiffness
    if isinstance(law, ConstantStiffness):
        return PhaseStiffness(mean=law.value)
    pair = model.bevel_pairs[name]
    c_prime = law.single_stiffness
    if c_prime is None:
        c_prime = bevel_single_stiffness(model, name).c_prime
    limit = LOW_LOAD / math.cos(pair.alpha_t) if law.low_load else 0.0
    return PairShape(c_prime=c_prime, S_R=law.stiffness_ratio, T_R=law.tip_relief_factor, load_limit=limit)


def bevel_laws(model: Model, name: str) -> MeshLaws:
    """Stiffness, damping and friction of one bevel mesh; damping ratios are converted to coefficients."""
    mesh, pair = model.bevel_meshes[name], model.bevel_pairs[name]
    stiffness = bevel_stiffness(model, name)
    k = mean_stiffness(pair, stiffness)
    whole = stiffness.c_prime * square_mean(pair) if isinstance(stiffness, PairShape) else None
    radii = [pair.R_m * math.sin(g.delta_b) for g in (pair.gear1, pair.gear2)]
    losses = flank_losses(model, mesh, radii, (math.cos(pair.beta_b), whole, k))
    return MeshLaws(stiffness=stiffness, k_ref=k, **losses)


def _seat(model: Model, gear: str, R_m: float) -> tuple[int, float, float, Array]:
    """Body number of a gear, axial position of the apex [m], angle of tooth 0 at R_m [rad], body axes."""
    body = str(model.body_of(gear))
    axes = seat_frame(model, model.mechanism.seats[body])[1]
    at = model.bodies[body].bevel_gears[gear]
    middle = middle_of(model.bevel_gears[gear], at) if body in model.shafts else at
    number, apex = seat_at(model, body, middle)  # on an elastic shaft: station at mid-face
    apex += at - middle
    x, y, _ = axes.T @ body_frame(model, body)[1][:, 0]
    angle = model.bevel_angles[gear] + turned_to(model, gear, R_m)
    return number, apex, angle + math.atan2(y, x), axes


def own_teeth(row: Any, pair: BevelPair, gears: Sequence[BevelGear], keep: Callable[[Array], int]) -> None:
    """Set the fields of individual teeth of a mesh record; unchanged for gears without faults.

    Parameters
    ----------
    row
        Record of the mesh.
    pair
        Geometry of the gear pair.
    gears
        The gears in the model.
    keep
        Stores an array in the pool of the kind and returns its offset.

    Notes
    -----
    A tooth displaced by a on the pitch cone at R_m is rotated by a/(R_m sin δ). Its flanks are displaced by
    this angle times R sin δ_b along the base tangent, exact at every cone distance R.
    """
    for k, gear in enumerate(gears):
        if not gear.faults:
            continue
        shape = gear.geometry
        table = np.tile([shape.R_i - pair.R_m, shape.R_e - pair.R_m, 0.0], (gear.number_of_teeth, 1))
        for fault in gear.faults.values():
            tooth = table[fault.tooth]
            if isinstance(fault, PitchError):
                moved = -displaced_gap(shape, "left", fault.severity * fault.amount)
                tooth[2] += moved * pair.R_m / shape.R_m
            else:
                low, high = fault.left(shape.R_i, shape.R_e)
                tooth[:2] = max(tooth[0], low - pair.R_m), min(tooth[1], high - pair.R_m)
        row["n_sep"], row["n_t"][k], row["teeth"][k] = 1, len(table), keep(table)
        row["sep_min"] -= np.abs(table[:, 2]).max()


def bevel_bank(places: Places) -> Bank:
    """All bevel meshes."""
    model = places.model
    rows, names, pool = [], [], Pool()
    for name, mesh in model.bevel_meshes.items():
        if None in [model.body_of(g) for g in mesh.gears]:
            continue
        one, two = (_seat(model, g, model.bevel_pairs[name].R_m) for g in mesh.gears)
        sides = [model.bevel_gears[g].direction for g in mesh.gears]
        place = Placement(
            axes1=one[3],
            axes2=two[3],
            apexes=(one[1], two[1]),
            sides=(sides[0], sides[1]),
            angles=(one[2], two[2]),
        )
        row = bevel_row(model.bevel_pairs[name], place, bevel_laws(model, name), model.backlash(name))
        row["i"], row["j"] = one[0], two[0]
        if row["source"] == layout.PROFILE:  # not with a constant total stiffness (no tooth pairs)
            gears = [model.bevel_gears[g] for g in mesh.gears]
            own_teeth(row, model.bevel_pairs[name], gears, pool.add)
        # the model checks guarantee that at most one gear is on a carrier
        row["carried"] = carrying(model, *(str(model.body_of(g)) for g in mesh.gears)) or 0
        rows.append(row)
        names.append(name)
    return pack("bevel_mesh", layout.RECORD, rows, names, pool=pool.array())
