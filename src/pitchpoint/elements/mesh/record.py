# SPDX-License-Identifier: Apache-2.0
"""Record of one gear mesh for the kernels: parameters, outputs and scratch fields.

All lengths in m, angles in rad; gear 1 is body `i`, gear 2 is body `j`; base radii and numbers of teeth are
signed (internal: negative), so that the same formulas apply to external and internal pairs.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.contact.flank_law import FLANK_LAW
from pitchpoint.contact.potential_table import MAX_QUANTITIES
from pitchpoint.elements.kind import RIM
from pitchpoint.elements.mesh.sums import scratch_of_sums

#: Sources of the stiffness, field `source`.
PROFILE = 0  # one tooth pair over its path of contact, superposed over all pairs (parabola or table)
PHASE = 1  # prescribed total stiffness over the mesh phase
SURFACE = 2  # tooth surfaces in contact planes over the face width, at one of three levels

#: Form of a prescribed stiffness given by a user law; the others are those of `contact.pair_shape`.
USER = 3

ROWS = 5
"""Rows of the wrench basis: normal force times 1 and y, friction times 1, z and xi. The lever of the normal
force
is y = z + f tan(beta_b) xi: axial force times path and transverse force times width act about the same
axis."""

#: Values per tooth in the table of a gear: grid of its gap, of its additional compliance and of its level, -1
#: if none; first and last station between which gap and compliance, and the level, vary over z.
N_ROW = 7

_BODIES = [(name, "i8") for name in ("i", "j", "ii", "ij", "ji", "jj")]

_GEOMETRY = [
    ("fixed", "i8"),  # 1: pure rotation of both bodies, fixed line of action
    ("carried", "i8"),  # gear whose base rotates the line of centres (carrier); 0: both on one base
    ("displaced", "i8"),  # 1: a gear is eccentric or wobbles on the axis of its body, or its rim bends
    ("seats", "i8"),  # displacement of the gears on their bodies, offset in the pool; see `mesh.eccentricity`
    *((name, "i8") for name in RIM[2:]),  # hidden bodies of the rim of gear 2, see `mesh.flexible_rim`
    ("pairs", "i8", (len(RIM), len(RIM))),
    ("n_rim", "i8"),  # modal coordinates of the rim, 0: rigid
    ("rim", "i8"),  # its shapes and scratch, offset in the pool
    ("bend_rim", "i8"),
    ("release_rim", "i8"),  # addresses of the functions of `mesh.flexible_rim`
    ("z1", "i8"),
    ("z2", "i8"),  # signed numbers of teeth
    ("r_b1", "f8"),
    ("r_b2", "f8"),  # signed base radii
    ("p_bt", "f8"),  # transverse base pitch
    ("w1", "f8"),  # z1 / (z1 + z2): position of the pitch point on the line from gear 1 to gear 2
    ("w_z", "f8"),  # shift of the common width relative to the pitch point per axial offset of the gears
    ("tan_b", "f8"),  # tan beta_b of gear 1, right hand positive
    ("zc1", "f8"),
    ("zc2", "f8"),  # mid-face positions along the spin axes of the bodies
    ("b1", "f8"),
    ("b2", "f8"),  # face widths
    ("cos1", "f8"),
    ("sin1", "f8"),  # nominal direction from gear 1 to the pitch point, in the frame of body i
    ("cos2", "f8"),
    ("sin2", "f8"),  # the same direction in the frame of body j
    ("skew", "f8", 2),  # tilt of axis 2 relative to axis 1 by the housing: along t, along e [rad]
    ("u0", "f8"),  # initial base-tangent travel, 0 = teeth centred in the backlash
    ("inv_w0", "f8"),  # involute of the zero-backlash working pressure angle (allowances included)
    ("xi_0", "f8"),  # mean path position of the front flank at zero angles, less its involute part
    ("xi_b", "f8"),  # the same for the back flank
    ("rho_a1", "f8"),
    ("rho_a2", "f8"),  # lengths of roll up to the tip form circles: sqrt(r_Fa^2 - r_b^2)
]

_STIFFNESS = [
    ("source", "i8"),
    ("slices", "i8"),  # 0: exact width integral
    ("c_prime", "f8"),  # PROFILE: of one pair per face width [N/m^(power + 1)]; PHASE: mean total [N/m]
    ("S_R", "f8"),
    ("T_R", "f8"),
    ("n_table", "i8"),
    ("table", "i8"),  # PROFILE: table of the pair, as offset in the pool; n_table 0 is the parabola
    ("form", "i8"),  # PHASE: FOURIER, TABLE, RECTANGULAR, USER
    ("n_k", "i8"),
    ("cosine", "i8"),
    ("sine", "i8"),  # PHASE: coefficients, offsets in the pool
    ("deviating", "i8"),  # address of `tooth_pairs.deviating_line`, if some teeth have grids
    ("turning", "i8"),  # address of `mesh.exact_tangent.turning`, if exact tangents are required
    ("law", "i8"),  # PHASE, USER: address of the law
    ("params", "i8"),  # its parameters, offset in the pool
    ("load_limit", "f8"),  # PROFILE: line load below which the pair softens [N/m], 0: linear
    ("k_step", "f8"),  # typical stiffness, for the estimate of the time step [N/m]
]

#: SURFACE only; see `mesh.surface`.
_SURFACE = [
    ("is_rigid", "i8"),
    ("is_flexible", "i8"),  # level, and the address of its kernel; tabulated: flexible as well, for pictures
    ("is_tabulated", "i8"),
    ("rigid", "i8"),
    ("flexible", "i8"),
    ("tabulated", "i8"),
    ("reach", "f8"),  # path before A and beyond E on which tip edges may be in contact [m]
    ("rounding", "f8", 2),  # radii of the tip edges
    (
        "tip_share",
        "f8",
        2,
    ),  # lower bound of a tip gap within reach over curvature eta^2; -1: not known yet
    ("nodes", "i8"),  # nodes of one flank, offset in the pool [max_nodes]
    ("max_nodes", "i8"),
    ("n_nodes", "i8"),  # result: nodes of the flank evaluated last
    ("work", "i8"),  # flexible: further scratch in the pool, see `surface.compliance` and `surface.flexible`
    ("n_slots", "i8"),  # nodes of the last solution, -1: none
    ("n_slot_pairs", "i8"),  # number of tooth pairs whose forces start the next solution
    # influence functions by flank and gear, offsets in the pool; see `surface.compliance`
    ("own", "i8", (2, 2)),
    ("before", "i8", (2, 2)),
    ("after", "i8", (2, 2)),
    ("height", "f8", (2, 2)),  # length of roll at the height 0, and its half range
    ("windup", "f8"),  # compliance of both blanks in torsion, along the base tangent [m/N]
    ("depth", "f8", (2, 4)),  # depth of the reference points of the local contact over the height [m]
    ("plane_width", "f8"),  # nominal width of a contact plane
    ("line", "f8", 2),  # 2 (1 - nu^2)/(pi E cos(beta_b)) over the plane width, of both gears [m/N]
    ("strip", "f8"),  # squared half width of the contact over force and transverse radius [m/N]
    ("kappa_1", "f8"),
    ("kappa_2", "f8"),  # nu/(1 - nu) of both gears
    ("least_roll", "f8"),  # least radius of curvature of a flank in the local contact
    ("overlap", "f8"),  # additional compliance of one node [m/N]
    ("gcp", "i8", 2),
    ("gcp_size", "i8", 2),  # tabulated potentials of front and back flank: offsets in the pool and sizes
    ("gcp_ratios", "f8", (3, MAX_QUANTITIES)),  # scratch: further quantities and slopes, see `force_ratios`
    ("beyond", "i8"),  # result: axes outside whose range a flank in contact has been, bits of the table
    ("oil_rate", "f8"),  # film damping of one plane along the base tangent [N s/m], 0: none
    ("oil_film", "f8"),  # film thickness h along the base tangent
    ("oil_power", "f8"),
    ("structural", "f8"),  # structural damping force over the elastic force
    ("structural_speed", "f8"),  # speed at which it reaches its full value
]

_LOSSES = [
    ("contact", FLANK_LAW),
    ("d_gap", "f8"),  # mesh damper, also acts within the backlash [N s/m]
]

_EXCITATION = [
    ("n_e", "i8"),  # harmonics of the transmission error over the mesh phase
    ("e_cos", "i8"),
    ("e_sin", "i8"),
    ("n_e1", "i8"),  # orders of shaft 1: rows (order, amplitude, phase)
    ("e1", "i8"),
    ("n_e2", "i8"),
    ("e2", "i8"),
    ("t1_0", "i8"),
    ("t2_0", "i8"),  # numbers of the tooth of gear 1 and of the space of gear 2 in mesh at assembly
    ("n_sep", "i8"),  # 1: some teeth have modifications or deviation grids, see `mesh.flank_deviations`
    ("n_t", "i8", 2),  # numbers of teeth in the tables of both gears
    ("teeth", "i8", 2),  # offsets of these tables [flank, tooth, N_ROW]
    ("n_sz", "i8", 4),
    ("n_sx", "i8", 4),  # stations over width and roll: gaps of gear 1, of gear 2, levels of gear 1, of gear 2
    ("sep", "i8", 4),  # offsets of the stacks of grids [row, width, roll], likewise
    ("roll", "f8", (2, 2)),  # range of the length of roll of the grids of both gears [m]
    ("modified", "i8", 2),  # 1: both flanks of a gear have modifications, see `mesh.flank_modifications`
    ("terms", "i8", 2),  # offsets of their rows [flank, N_TERM]
    ("stride", "i8"),  # stations of gaps and compliances per piece of a contact line
    ("sep_min", "f8"),  # minimum of the sum of both gaps
]

#: Scratch: written and read within one call.
_SCRATCH = [
    ("m", "f8", 3),  # mean axis
    ("e", "f8", 3),  # from gear 1 towards the pitch point
    ("t", "f8", 3),  # m x e
    ("P", "f8", 3),  # pitch point in the plane z = 0, where tilt has no effect on the penetration
    ("dn", "f8", 3),  # axis of gear 2 less axis of gear 1
    ("a", "f8"),  # centre distance, signed
    ("c1", "f8"),
    ("c2", "f8"),  # e . n of either axis n, zero for parallel axes
    ("inv_m", "f8"),  # 1 / length of the weighted sum of both axes
    ("q_e", "f8", 3),
    ("q_m", "f8", 3),
    ("q_n", "f8", 3),  # gradients with respect to e, m and dn
    ("cos_a", "f8"),
    ("sin_a", "f8"),
    ("inv_a", "f8"),
    ("dz", "f8"),  # axial position of gear 2 less that of gear 1
    ("u", "f8"),  # base-tangent travel from mid-gap: r_b1 phi1 + r_b2 phi2 + ...
    ("travel", "f8"),  # mean travel along the line of action (phase times p_bt)
    ("turn", "i8"),  # whole base pitches subtracted from `travel`, modulo a common multiple
    ("gap", "f8"),  # total backlash along the base tangent at the actual centre distance
    ("e_t", "f8"),
    ("e_rate", "f8"),  # excitation and its rate
    ("travel_rate", "f8"),
    ("phase_rate", "f8", 2),  # d psi/dt of front and back flank
    ("dz_rate", "f8"),
    ("xi_A_rate", "f8"),
    ("eps_rate", "f8"),
    ("lo_rate", "f8"),
    ("hi_rate", "f8"),  # rates of the fields without `_rate`
    ("line_rate", "f8", 3),
    ("m_rate", "f8", 3),
    ("dir_rate", "f8", 3),  # rates of the line between the mid-faces, of m and of e
    ("xi_A", "f8"),
    ("eps", "f8"),  # path of contact: start from the pitch point [m], length [base pitches]
    ("L", "f8"),  # ramp at both ends of the path [base pitches]
    ("start", "f8", 2),  # offset of the mesh phase of either flank by the gear positions [base pitches]
    ("flank", "i8"),  # current flank: +1 front, -1 back
    ("psi", "f8"),
    ("tooth", "i8"),  # mesh phase in [0, 1) and its whole base pitches
    ("lam", "f8"),  # base pitches per metre of face width along a contact line
    ("kappa", "f8"),  # n_f . dn, loss of penetration per lever y
    ("tilt", "f8"),  # loss of penetration per width along a contact line
    ("tan_a", "f8"),
    ("tan_rate", "f8"),  # tan alpha and its rate, for deviating flanks and surfaces
    ("x_0", "f8"),  # SURFACE: penetration of the flank at the pitch point
    ("by_travel", "f8"),
    ("by_tan", "f8"),
    ("by_dz", "f8"),  # and the energy of the flank, less that by x_0 and tilt: derivatives by mean travel,
    # by tan alpha and by the axial offset
    ("plane_step", "f8"),  # distance of the contact planes
    (
        "place_slope",
        "f8",
        2,
    ),  # of the middle of a plane by the axial offset: at the width 0, and over the width
    ("xi_slope", "f8"),  # of the path position by tan alpha
    ("xi_rate", "f8", 2),  # rate of the path position of a plane: at the width 0, and over the width
    ("x_rate", "f8", 2),  # rate of the penetration of unmodified flanks on the path of contact, likewise
    ("per_z", "f8", 4),
    ("per_roll", "f8", 4),  # grid steps per metre
    ("rows", "i8", (2, N_ROW)),  # grid rows of the two teeth of a pair
    ("line", "f8", 3),  # of a contact line for `deviating_line`: path position, penetration at z = 0, force
    ("growth", "f8"),  # relative rate of the common width, if the stiffness grows with it
    ("z_lo", "f8"),
    ("z_hi", "f8"),  # ends of the common face width
    ("lo_slope", "f8"),
    ("hi_slope", "f8"),  # their derivatives by the axial offset of the gears
    ("moved", "f8", (2, 12)),  # exact tangents: derivative of the first basis rows by one motion of one body
    ("slope", "f8", (2, 12)),  # and of the normal rates by each motion of both bodies
]

RECORD = np.dtype(
    [
        *_BODIES,
        *_GEOMETRY,
        *_STIFFNESS,
        *_SURFACE,
        *_LOSSES,
        *_EXCITATION,
        ("now", np.dtype(_SCRATCH, align=True)),
        *scratch_of_sums(ROWS),
        ("here", "i8"),  # address of this record, for calls through an address
        ("n_pair", "i8"),
        ("rubs", "i8"),  # 1: friction torques are observed
        ("pool", "i8"),  # address of the float array that holds all tables
        ("ev", "i8"),
        ("out", "i8"),
    ],
    align=True,
)

#: Observations of one mesh, in the order they are written; `n_pair` pair forces follow, then `FRICTION`.
OUTPUTS = (
    ("transmission_error", "m", "travel of both gears along the base tangent, from mid-gap"),
    ("deflection", "m", "transmission error less its static excitation"),
    ("mesh_force", "N", "force along the base tangent, front flank positive"),
    ("mesh_stiffness", "N/m", "stiffness of the flanks in contact along the base tangent"),
    ("mesh_phase", "1", "position in the mesh cycle, 0 when a pair enters at mid-face"),
    ("contact_state", "1", "1 front flank, 0 separated, -1 back flank, 2 both"),
    ("normal_force", "N", "force normal to the flanks"),
    ("circumferential_force", "N", "circumferential force on gear 2 at the working pitch circle"),
    ("radial_force", "N", "radial (separating) force"),
    ("axial_force", "N", "axial force on gear 2"),
    ("friction_power", "W", "power loss by sliding friction"),
    ("damping_power", "W", "power loss by contact damping and mesh damper"),
    ("parametric_power", "W", "power supplied by stiffness and excitation varying with the mesh phase"),
    ("elastic_energy", "J", "energy stored in the flanks"),
    ("penetration", "m", "overlap normal to the flanks at the pitch point; negative: distance"),
    ("backlash", "m", "backlash along the base tangent at the actual position of the gears"),
)
N_OUT = len(OUTPUTS)

#: Observations of a mesh with friction: torques of the friction forces alone.
FRICTION = (
    ("friction_torque_1", "N m", "friction of the flanks on gear 1 about its axis"),
    ("friction_torque_2", "N m", "friction of the flanks on gear 2 about its axis"),
)

#: Event functions of one mesh; an event is a change of sign. Those of contact are positive exactly if the sum
#: of the forces of a flank is positive, as in `contact_state`; without contact damping and deviations they
#: are the penetration [m]. Those of pairs rise and fall with the mesh phase: a pair that passes A backwards
#: leaves contact there. Each wraps from 1/2 to -1/2 half a base pitch away, which is not an event, and is
#: valid on the nearer flank only.
EVENTS = (
    ("front_gap", "front flank makes or loses contact"),
    ("back_gap", "back flank makes or loses contact"),
    ("turning_reversal", "the mean travel of the gears reverses"),
    ("pair_entry", "a tooth pair passes the start A of the path of the front flanks at mid-face"),
    ("pair_exit", "a tooth pair passes the end E of the path of the front flanks at mid-face"),
    ("sliding_reversal", "a tooth pair of the front flanks passes the pitch point at mid-face"),
    ("back_pair_entry", "a tooth pair passes the start A of the path of the back flanks at mid-face"),
    ("back_pair_exit", "a tooth pair passes the end E of the path of the back flanks at mid-face"),
    ("back_sliding_reversal", "a tooth pair of the back flanks passes the pitch point at mid-face"),
)


def mesh_outputs(
    record: np.void, of_all: tuple[tuple[str, str, str], ...]
) -> tuple[tuple[str, str, str], ...]:
    """Observations of one record of a mesh.

    Parameters
    ----------
    record
        Record of a mesh of cylindrical or bevel gears.
    of_all
        Observations of every mesh of its kind.
    """
    pairs = range(int(record["n_pair"]))
    forces = ((f"pair_force[{{}}.{k}]", "N", f"force of tooth pair {k}") for k in pairs)
    return (*of_all, *forces, *(FRICTION if record["rubs"] else ()))
