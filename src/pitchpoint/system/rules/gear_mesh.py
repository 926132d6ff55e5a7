# SPDX-License-Identifier: Apache-2.0
"""Records of cylindrical gear meshes from gear pairs and their laws."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.stiffness.description import Description, PairShape
from pitchpoint.core.errors import CompileError
from pitchpoint.core.kernel import invoke, plain
from pitchpoint.core.status import OK, sentence
from pitchpoint.elements.gear_mesh import entry
from pitchpoint.elements.mesh import record as layout
from pitchpoint.elements.mesh.line_of_action import place_gears
from pitchpoint.elements.signal import Pool
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.involute import inv
from pitchpoint.model.components.sensor import LoadSensor
from pitchpoint.model.components.stiffness import UserStiffness
from pitchpoint.model.frames import GROUND, split
from pitchpoint.model.gear_axes import mesh_frame
from pitchpoint.model.mechanism import seat_frame
from pitchpoint.multibody.channels import CTL, FRAME
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import seat_at
from pitchpoint.system.rules.flank_contact import pairs_in_reach, set_surfaces
from pitchpoint.system.rules.flexible_rim import set_rim
from pitchpoint.system.rules.gear_displacement import is_displaced, set_displacements
from pitchpoint.system.rules.mesh_laws import MeshLaws, mean_stiffness, mesh_laws, put_losses, usual_slope
from pitchpoint.system.rules.places import Places
from pitchpoint.system.rules.separation import separation_grids
from pitchpoint.system.rules.stiffness import user_law
from pitchpoint.system.rules.wear import worn_flanks

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

#: Stores an array in the pool of the kind and returns its offset.
Keep = Callable[[Array], int]


@dataclass(frozen=True, kw_only=True)
class Placement:
    """Position of the two gears of a mesh with all coordinates zero.

    Parameters
    ----------
    origin1, origin2
        Origins of the bodies in the world [m], shape (3,).
    offset1, offset2
        Axial positions of the mid-faces in the bodies [m].
    phi1, phi2
        Angles of the centre of tooth 0 at spin 0 about the z axis of `axes`, from its x axis [rad].
    turn1, turn2
        Angles of the body frames, likewise [rad].
    axes
        Reference frame of the angles, columns, shape (3, 3); both gears rotate about its third axis.
    fixed
        Whether both bodies can only spin and their joint loads are not used.
    widths
        Face widths of both gears [m]; None: those of the pair, which has only the common face width.
    """

    origin1: Array
    origin2: Array
    offset1: float = 0.0
    offset2: float = 0.0
    phi1: float = 0.0
    phi2: float = 0.0
    turn1: float = 0.0
    turn2: float = 0.0
    axes: Array = field(default_factory=lambda: np.eye(3))
    fixed: bool = False
    widths: tuple[float, float] | None = None


def _wrap(value: float, period: float) -> tuple[float, int]:
    turns = round(value / period)
    return value - turns * period, turns


def _widths(row: Any, b1: float, b2: float) -> None:
    """Set the face widths; the common width moves with the narrower gear, or with the mean of equal ones."""
    row["b1"], row["b2"] = b1, b2
    row["w_z"] = (0.5 if b1 == b2 else 0.0 if b1 < b2 else 1.0) - row["w1"]


def _geometry(row: Any, pair: GearPair, place: Placement) -> None:
    g1, g2 = pair.gear1, pair.gear2
    row["z1"], row["z2"] = g1.z, g2.z
    row["r_b1"], row["r_b2"] = 0.5 * g1.d_b, 0.5 * g2.d_b
    row["p_bt"] = p_bt = 2.0 * math.pi * row["r_b1"] / g1.z
    row["w1"] = g1.z / (g1.z + g2.z)
    row["tan_b"] = math.tan(g1.beta_b)
    row["zc1"], row["zc2"] = place.offset1, place.offset2
    _widths(row, *(place.widths or (g1.b, g2.b)))
    line = place.axes.T @ (place.origin2 - place.origin1) * math.copysign(1.0, pair.a_w)
    gamma = math.atan2(line[1], line[0])
    row["cos1"], row["sin1"] = math.cos(gamma - place.turn1), math.sin(gamma - place.turn1)
    row["cos2"], row["sin2"] = math.cos(gamma - place.turn2), math.sin(gamma - place.turn2)
    # angles of a tooth of gear 1 and of a space of gear 2 relative to the pitch point
    towards2 = gamma + (math.pi if g2.z > 0 else 0.0)
    tooth = place.phi1 - gamma
    space = place.phi2 + math.pi / g2.z - towards2
    z1, z2 = (float(place.axes[:, 2] @ origin) for origin in (place.origin1, place.origin2))
    dz = z2 + place.offset2 - z1 - place.offset1
    # angles of the nearest tooth and space; the sum of the remainders is the assembly offset
    n = _wrap(row["r_b1"] * tooth, p_bt)[1]
    row["t1_0"] = -n
    tooth -= n * p_bt / row["r_b1"]
    offset, n = _wrap(row["r_b1"] * tooth + row["r_b2"] * space + row["tan_b"] * dz, p_bt)
    row["t2_0"] = -n if g2.z > 0 else n
    space -= n * p_bt / row["r_b2"]
    row["u0"] = offset - row["tan_b"] * dz
    half1, half2 = row["r_b1"] * g1.psi_b, row["r_b2"] * g2.psi_b
    turn = row["r_b1"] * tooth - row["r_b2"] * space
    rest = half1 - half2 + 0.5 * p_bt
    row["xi_0"] = 0.5 * (rest + turn)
    row["xi_b"] = 0.5 * (rest - turn)
    for k, gear in ((1, g1), (2, g2)):
        sign = math.copysign(1.0, gear.z)
        r_b = 0.5 * gear.d_b
        row[f"rho_a{k}"] = sign * math.sqrt(max(0.25 * gear.d_Fa**2 - r_b**2, 0.0))


def _stiffness(row: Any, stiffness: Description, keep: Keep) -> None:
    if isinstance(stiffness, PairShape):
        row["source"] = layout.PROFILE
        row["c_prime"], row["S_R"], row["T_R"] = stiffness.c_prime, stiffness.S_R, stiffness.T_R
        row["load_limit"], row["contact"]["power"] = stiffness.load_limit, stiffness.power
        if stiffness.table is not None:
            row["n_table"], row["table"] = stiffness.table.size, keep(stiffness.table)
        return
    row["source"] = layout.PHASE
    row["c_prime"], row["contact"]["power"] = stiffness.mean, 1.0
    row["form"] = stiffness.form
    row["n_k"], first, second = stiffness.arrays()
    row["cosine"], row["sine"] = keep(first), keep(second)


def mesh_row(
    pair: GearPair, place: Placement, laws: MeshLaws, keep: Keep, backlash: float | None = None
) -> np.void:
    """Record of one mesh; body indices, block indices and outputs are set by `assemble`.

    Parameters
    ----------
    pair
        The gear pair at its working centre distance; signs of ISO 21771.
    place
        Position of the gears.
    laws
        Stiffness, damping, friction, excitation.
    keep
        Stores an array in the pool of the kind and returns its offset.
    backlash
        Total gap along the base tangent at the working centre distance [m]; None: backlash of the geometry.

    Returns
    -------
    numpy.void
        One row of `mesh.record.RECORD`.
    """
    row = np.zeros(1, layout.RECORD)[0]
    _geometry(row, pair, place)
    alpha = pair.alpha_wt
    r_b = row["r_b1"] + row["r_b2"]
    gap = pair.j_bt if backlash is None else backlash
    row["inv_w0"] = inv(alpha) - gap / (2.0 * r_b)
    _stiffness(row, laws.stiffness, keep)
    row["slices"] = laws.slices
    row["contact"]["k_ref"] = laws.k_ref or mean_stiffness(pair, laws.stiffness)
    row["k_step"] = usual_slope(pair, laws.stiffness)
    put_losses(row, laws)
    if laws.user is not None:
        row["form"], row["params"] = layout.USER, keep(laws.user)
    if laws.e_cos.size:
        row["n_e"], row["e_cos"], row["e_sin"] = laws.e_cos.size, keep(laws.e_cos), keep(laws.e_sin)
    for k, orders in ((1, laws.orders1), (2, laws.orders2)):
        if orders.size:
            row[f"n_e{k}"], row[f"e{k}"] = len(orders), keep(orders)
    if laws.surface is not None:
        set_surfaces(row, pair, laws.surface, keep)
    if place.fixed:
        _freeze(row, place)
    return row


def mesh_bank(places: Places) -> Bank:
    """All meshes whose gears are mounted on bodies."""
    model = places.model
    pool = Pool()
    rows, names, laws = [], [], []
    for name, mesh in model.meshes.items():
        if None in [model.body_of(g) for g in mesh.gears]:
            continue
        gears = [model.gears[g] for g in mesh.gears]
        place, numbers = _placement(model, name)
        skew = (0.0, 0.0) if mesh.misalignment is None else mesh.misalignment.skew
        row = _tooth_row(model, name, place, pool.add)
        row["i"], row["j"], row["skew"] = *numbers, skew
        set_displacements(row, gears, (place.phi1 - place.turn1, place.phi2 - place.turn2), pool.add)
        set_rim(row, model, name, pool.add)
        law = mesh.stiffness
        where = f"meshes.{name}.stiffness.python"
        laws.append(user_law(law.python, where).function if isinstance(law, UserStiffness) else None)
        rows.append(row)
        names.append(name)
    return pack("gear_mesh", layout.RECORD, rows, names, pool=pool.array(), laws=tuple(laws))


def _placement(model: Model, name: str) -> tuple[Placement, list[int]]:
    """Position of the gears of a mesh on their bodies, and the numbers of these."""
    mesh = model.meshes[name]
    one, two = (str(model.body_of(g)) for g in mesh.gears)
    gears = [model.gears[g] for g in mesh.gears]
    seats = [_seat(model, b, g) for b, g in zip((one, two), mesh.gears, strict=True)]
    axes = mesh_frame(model, one)
    skew = (0.0, 0.0) if mesh.misalignment is None else mesh.misalignment.skew
    place = Placement(
        axes=axes,
        origin1=seats[0][2],
        origin2=seats[1][2],
        offset1=seats[0][1],
        offset2=seats[1][1],
        phi1=model.phasing.tooth_angle[mesh.gears[0]],
        phi2=model.phasing.tooth_angle[mesh.gears[1]] + mesh.twist,
        turn1=_turn(axes.T @ seats[0][3]),
        turn2=_turn(axes.T @ seats[1][3]),
        fixed=all(_only_spins(model, b) for b in (one, two))
        and not any(is_displaced(g) or g.flexible_rim is not None for g in gears)
        and skew == (0.0, 0.0),
        widths=(gears[0].face_width, gears[1].face_width),
    )
    return place, [seat[0] for seat in seats]


def assembled_teeth(model: Model, name: str) -> np.void:
    """Record of a mesh with its teeth and path of contact as assembled, without bodies and stiffness.

    Fields of the path, `now["start"]`, `now["eps"]`, and numbers of teeth for `tooth_pairs.pair_teeth`.
    """
    pair, row = model.pairs[name], np.zeros(1, layout.RECORD)[0]
    place, _ = _placement(model, name)
    _geometry(row, pair, place)
    row["inv_w0"] = inv(pair.alpha_wt)
    shift = place.axes[:, 2] @ (place.origin2 - place.origin1)
    row["now"]["dz"] = float(shift) + place.offset2 - place.offset1
    plain(place_gears)(row, math.cos(pair.alpha_wt))
    return row


def _tooth_row(model: Model, name: str, place: Placement, keep: Keep) -> np.void:
    """Record of a mesh of a model with the deviations and faults of its teeth, without bodies."""
    mesh, pair = model.meshes[name], model.pairs[name]
    gears = [model.gears[g] for g in mesh.gears]
    laws = mesh_laws(model, name)
    row = mesh_row(pair, place, laws, keep, model.backlash(name))
    if row["source"] != layout.PHASE:  # not with a prescribed total stiffness (no tooth pairs)
        surfaces = row["source"] == layout.SURFACE
        row["n_pair"] = pairs_in_reach(pair) if surfaces else math.ceil(pair.eps_gamma) + 1
        worn = worn_flanks(pair, laws.stiffness, gears, (mesh.offset1, mesh.offset2))
        separation_grids(row, gears, keep, worn)
    return row


def mesh_alone(model: Model, name: str) -> Bank:
    """Record of one mesh on fixed parallel axes at its centre distance, without bodies.

    The widths overlap as in the model; the teeth are those of an assembly with tooth 0 of gear 1 on the line
    of centres.
    """
    mesh, pair, pool = model.meshes[name], model.pairs[name], Pool()
    gears = [model.gears[g] for g in mesh.gears]
    internal = pair.gear2.z < 0
    space = (math.pi if internal else 0.0) + (0.0 if internal else math.pi) - math.pi / pair.gear2.z
    place = Placement(
        origin1=np.zeros(3),
        origin2=np.array([abs(pair.a_w), 0.0, mesh.offset1 - mesh.offset2]),
        phi1=math.pi if internal else 0.0,
        phi2=space,
        fixed=True,
        widths=(gears[0].face_width, gears[1].face_width),
    )
    row = _tooth_row(model, name, place, pool.add)
    return pack("gear_mesh", layout.RECORD, [row], [name], pool=pool.array())


def _seat(model: Model, body: str, gear: str) -> tuple[int, float, Array, Array]:
    """Number of the body of a gear, mid-face position in its frame [m], origin and axes of the frame."""
    at, axes = seat_frame(model, model.mechanism.seats[body])
    z = model.bodies[body].gears[gear]
    number, rest = seat_at(model, body, z)
    if body in model.shafts:
        at = at + axes[:, 2] * (z - rest)
    return number, rest, at, axes


def _only_spins(model: Model, body: str) -> bool:
    """Whether a body is on ground, can only spin or is fixed, and its joint load is not used.

    The fast path of such gears computes torques only. Joint friction and load sensors need the full mesh
    force.
    """
    seat = model.mechanism.seats[body]
    rubs = seat.joint is not None and model.joints[seat.joint].friction is not None
    sensed = any(isinstance(s, LoadSensor) and split(s.at)[0] == body for s in model.sensors.values())
    return seat.base == GROUND and seat.kind in ("revolute", "fixed") and not rubs and not sensed


def _turn(axes: Array) -> float:
    """Angle about the z axis of a frame whose z axis is parallel [rad]."""
    return math.atan2(axes[1, 0], axes[0, 0])


def _freeze(row: Any, place: Placement) -> None:
    """Compute the constant line of action of gears that only spin by one call of the element."""
    frames = np.zeros(2, FRAME)
    frames["r"] = place.origin1, place.origin2
    for k, angle in enumerate((place.turn1, place.turn2)):
        c, s = math.cos(angle), math.sin(angle)
        frames["R"][k] = place.axes @ ((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0))
    rows = np.zeros(1, layout.RECORD)
    rows[0] = row
    for name in ("source", "n_pair", "n_e", "n_e1", "n_e2", "n_sep", "i"):
        rows[name] = 0  # geometry only
    rows["j"] = 1
    # a gap so large that no flank is in contact, also for internal gears
    rows["inv_w0"] = -math.copysign(1e9, row["r_b1"] + row["r_b2"])
    ctl = np.zeros(1, CTL)
    ctl["fr"], ctl["nb"] = frames.ctypes.data, 2
    tangents = np.zeros((1, 6, 6))
    ctl["kk"], ctl["np"] = tangents.ctypes.data, 1
    status = invoke(entry, ctl.ctypes.data, rows.ctypes.data, 1)
    if status != OK:
        raise CompileError(f"a mesh cannot be placed: {sentence(status)}")
    row["now"] = rows["now"][0]
    row["now"]["gap"] = 2.0 * (row["r_b1"] + row["r_b2"]) * (row["now"]["inv_a"] - row["inv_w0"])
    row["fixed"] = 1
