# SPDX-License-Identifier: Apache-2.0
"""Record of one bevel mesh for the kernels: parameters, outputs and scratch fields.

Lengths in m, angles in rad. Fields read by solvers and reports have the names and meaning of `mesh.record` at
the mean cone distance R_m: r_b1 = R_m sin(delta_b1) and so on. Numbers of teeth and base radii of a gear
whose cone opens towards -z of its body are negative, so that sums over the spins of the bodies are valid.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.contact.flank_law import FLANK_LAW
from pitchpoint.elements.mesh.record import EVENTS, PHASE, PROFILE, mesh_outputs
from pitchpoint.elements.mesh.record import OUTPUTS as OF_MESHES
from pitchpoint.elements.mesh.sums import scratch_of_sums

__all__ = ["EVENTS", "N_OUT", "N_OWN", "OUTPUTS", "PHASE", "PROFILE", "RECORD", "mesh_outputs"]

N_OWN = 3
"""Values per tooth in the table of a gear: inner and outer end of its face, from R_m of the pair, and its
pitch deviation, counter-clockwise about the axis into the gear, as a travel at R_m [m]."""
ROWS = 6
"""Rows of the wrench basis: three for the normal force (two forces, one couple), three for friction."""

_BODIES = [(name, "i8") for name in ("i", "j", "ii", "ij", "ji", "jj")]

_GEOMETRY = [
    ("carried", "i8"),  # gear whose carrier rotates the plane of the axes; 0: both on one base
    ("z1", "i8"),
    ("z2", "i8"),  # numbers of teeth, signed by the direction of the cone
    ("r_b1", "f8"),
    ("r_b2", "f8"),  # base radii at R_m, likewise
    ("side", "f8", 2),  # +1: the cone opens towards +z of the body, -1: towards -z
    ("apex", "f8", 2),  # position of the apex along the spin axis of the body
    ("base", "f8", 2),  # sines of the base cone angles
    ("tip", "f8", 2),  # roll angles of the tip cones, arcs in the plane of action [rad]
    ("R_m", "f8"),  # mean cone distance
    ("p_bt", "f8"),  # base pitch at R_m
    ("tan_b", "f8"),  # tan beta_b of gear 1, right hand positive
    ("z_lo", "f8"),
    ("z_hi", "f8"),  # common face from R_m
    ("towards", "f8", (2, 2)),  # direction from each axis to the pitch ray at assembly, x and y of the body
    ("u0", "f8"),  # initial travel, 0 = teeth centred in the backlash
    ("gap_0", "f8"),  # backlash at R_m less its involute part
    ("xi_0", "f8"),
    ("xi_b", "f8"),  # mean path position of front and back flank at zero angles, less the involute part
    ("t1_0", "i8"),
    ("t2_0", "i8"),  # numbers of the tooth of gear 1 and of the space of gear 2 in mesh at assembly
    ("n_sep", "i8"),  # 1: some teeth have an individual face or pitch deviation
    ("n_t", "i8", 2),  # numbers of teeth in the tables of both gears, 0: none
    ("teeth", "i8", 2),  # offsets of these tables in the pool [tooth, N_OWN]
    ("sep_min", "f8"),  # minimum of the sum of both gaps, at R_m
]

_LAW = [
    ("source", "i8"),
    ("slices", "i8"),  # unused
    ("form", "i8"),
    ("n_k", "i8"),
    ("n_table", "i8"),  # unused: a total stiffness is constant, that of a pair a parabola
    ("c_prime", "f8"),  # PROFILE: of one pair per face width [N/m^2]; PHASE: total at R_m [N/m]
    ("spread", "f8"),  # PHASE: c_prime times this is the stiffness per width [1/m]
    ("S_R", "f8"),
    ("T_R", "f8"),
    ("load_limit", "f8"),
    ("k_step", "f8"),
    ("contact", FLANK_LAW),  # power 1
    ("d_gap", "f8"),
    ("turning", "i8"),  # address of `mesh.bevel.exact_tangent.turning`, if exact tangents are required
]

#: Scratch: written and read within one call.
_SCRATCH = [
    ("axis", "f8", (2, 3)),  # from the apex into each gear
    ("away", "f8", (2, 3)),  # t x axis: from gear 1 towards the pitch ray, from gear 2 away from it
    ("P", "f8", 3),  # pitch point: on the pitch ray at R_m
    ("m", "f8", 3),  # pitch ray p
    ("e", "f8", 3),  # q, normal to the pitch ray in the plane of the axes, towards gear 2
    ("t", "f8", 3),  # p x q
    ("d", "f8", 3),  # position of the apex of gear 1 relative to that of gear 2
    ("aside", "f8", 2),  # contribution of d to travel and gap at the pitch point
    ("N", "f8", 3),  # normal of the plane of action of the current flank
    ("cos_a", "f8"),
    ("sin_a", "f8"),
    ("sin_S", "f8"),  # sine of the shaft angle
    ("cone", "f8", 2),  # cosines of the working pitch cone angles
    ("open", "f8", 2),  # derivatives of the pitch cone angles by the shaft angle
    ("u", "f8"),
    ("e_t", "f8"),  # 0: no excitation
    ("gap", "f8"),
    ("travel", "f8"),
    ("turn", "i8"),
    ("xi_A", "f8"),
    ("eps", "f8"),
    ("L", "f8"),
    ("start", "f8", 2),
    ("travel_rate", "f8"),
    ("phase_rate", "f8", 2),
    ("xi_A_rate", "f8"),
    ("eps_rate", "f8"),
    ("flank", "i8"),
    ("psi", "f8"),
    ("tooth", "i8"),
    ("lo", "f8"),
    ("hi", "f8"),  # common face of the current pair, from R_m
    ("lacks", "f8"),  # gap of its teeth at R_m
    ("lam", "f8"),  # base pitches per ln(R/R_m) along a contact line
    ("x", "f8", 3),  # factors of cos(sigma), sin(sigma) and R in the penetration
    # levers of a node: cos(sigma), sin(sigma), R; 1, R cos(sigma), R sin(sigma)
    ("moved", "f8", (3, 12)),
    ("slope", "f8", (3, 12)),
]

RECORD = np.dtype(
    [
        *_BODIES,
        *_GEOMETRY,
        *_LAW,
        ("now", np.dtype(_SCRATCH, align=True)),
        *scratch_of_sums(ROWS),
        ("here", "i8"),  # address of this record, for calls through an address
        ("n_pair", "i8"),
        ("rubs", "i8"),
        ("pool", "i8"),  # address of the float array that holds all tables
        ("ev", "i8"),
        ("out", "i8"),
    ],
    align=True,
)

#: Observations of one mesh: those of `gear_mesh` at R_m, on gear 2, then those of gear 1; then pair forces
#: and friction torques.
OUTPUTS = (
    *OF_MESHES,
    ("radial_force_1", "N", "radial (separating) force on gear 1"),
    ("axial_force_1", "N", "axial force on gear 1, away from the apex positive"),
)
N_OUT = len(OUTPUTS)
