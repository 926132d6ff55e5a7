# SPDX-License-Identifier: Apache-2.0
"""Contact nodes of tooth surfaces: one per tooth pair and contact plane, with penetration and slopes.

The face width in contact is divided into equal contact planes. In each plane the flanks of a pair touch on
the line of action between A and E, and at the tip edge of one gear before A and beyond E (`contact.
tip_contact`). The penetration of a node without deformation is

    x = x_0 - kappa (z + f tan(beta_b) xi) - gaps of both flanks - gap of the tip edge

with the misalignment kappa to first order. It depends on the gears through x_0 and kappa, and through the
path position xi, tan(alpha) and the axial offset at constant x_0 and kappa: the forces have a component for
each of these, so that no energy is created (docs/decisions/0034-flank-contact.md).
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.contact.tip_contact import tip_gap, tip_gap_curvature
from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh.flank_deviations import begin_separation, find_rows, flank_slopes
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.elements.mesh.nodes import drift, set_levers, width_rate
from pitchpoint.elements.mesh.sums import add_friction, add_normal
from pitchpoint.elements.mesh.tooth_pairs import pair_teeth

ON_PATH, TIP_1, TIP_2 = 0, 1, 2
"""Places of a node: on the line of action; tip edge of gear 1 beyond E; tip edge of gear 2 before A."""

#: Contact node of a tooth pair in one plane.
NODE = np.dtype(
    [
        ("pair", "i8"),  # number of the pair, as `contact_lines`
        ("plane", "i8"),
        ("place", "i8"),
        ("z", "f8"),
        ("xi", "f8"),  # width and path position from the pitch point [m]
        ("x", "f8"),  # penetration without deformation [m]
        ("by_xi", "f8"),
        ("by_tan", "f8"),
        ("by_z", "f8", 2),  # its derivatives by path position, by tan(alpha), and by the widths on both gears
        ("roll", "f8", 2),  # lengths of roll on both gears [m], signed
        ("roll_by_xi", "f8", 2),
        ("roll_by_tan", "f8", 2),
        ("soft", "f8"),  # compliance of cracked teeth per face width [m^2/N]
        ("soft_by_roll", "f8", 2),
        ("soft_by_z", "f8", 2),
        ("rate", "f8"),  # rate of x [m/s]
        ("elastic", "f8"),
        ("force", "f8"),  # elastic and total force along the base tangent [N]
    ],
    align=True,
)


@kernel
def begin_surface(b):
    """Set the scratch of the nodes of a flank, and reset its energy slopes."""
    now = b["now"]
    now["by_travel"] = 0.0
    now["by_tan"] = 0.0
    now["by_dz"] = 0.0
    now["growth"] = 0.0
    if b["n_sep"] > 0:
        begin_separation(b)
        return
    now["tan_a"] = now["sin_a"] / now["cos_a"]
    now["tan_rate"] = now["xi_A_rate"] / b["r_b2"]


@kernel
def first_pair(b):
    """Number of the first pair that may be in contact, and their count."""
    now = b["now"]
    reach = b["reach"] / b["p_bt"]
    middle = now["psi"] + 0.5 * now["lam"] * (now["z_lo"] + now["z_hi"])
    reach += 0.5 * abs(now["lam"]) * (now["z_hi"] - now["z_lo"])
    first = -int(math.floor(middle + reach))
    return first, int(math.floor(now["eps"] - middle + reach)) - first + 1


@kernel
def plane_place(b, s):
    """Middle of the contact plane s, from the pitch point along the axes [m]."""
    now = b["now"]
    return now["z_lo"] + (s + 0.5) / b["slices"] * (now["z_hi"] - now["z_lo"])


@kernel
def node_place(b, xi):
    """Place of a node at the path position xi, and its distance from the path of contact [m]."""
    now = b["now"]
    if xi < now["xi_A"]:
        return TIP_2, now["xi_A"] - xi
    end = now["xi_A"] + now["eps"] * b["p_bt"]
    if xi > end:
        return TIP_1, xi - end
    return ON_PATH, 0.0


@kernel
def tip_bounds(b):
    """Half the curvature of the gap of both tip edges: eta^2 times this is less than the gap [1/m]."""
    now = b["now"]
    tan_a = now["tan_a"]
    c_1 = tip_gap_curvature(b["r_b1"], b["r_b2"], b["rho_a1"] - b["rounding"][0], tan_a)
    c_2 = tip_gap_curvature(b["r_b2"], b["r_b1"], b["rho_a2"] - b["rounding"][1], tan_a)
    return 0.25 * c_1, 0.25 * c_2


@kernel
def reaches(b, place, eta, x, bounds):
    """Whether a tip edge may be in contact at the penetration x of the flanks on the line of action [m]."""
    if place == ON_PATH:
        return x > 0.0
    c = bounds[0] if place == TIP_1 else bounds[1]
    return x > c * eta * eta and eta <= b["reach"]


@kernel
def set_node(b, node, xi, z, place, eta, deviating):
    """Set position, penetration and slopes of a node; `deviating`: a tooth of the pair has own flanks.

    `pair` and `plane` have been set. `x_0` in the scratch is the penetration of the flank.
    """
    now = b["now"]
    fh = now["flank"] * b["tan_b"]
    tan_a = now["tan_a"]
    node["place"] = place
    node["z"] = z
    node["xi"] = xi
    node["x"] = now["x_0"] - now["kappa"] * (z + fh * xi)
    node["by_xi"] = -now["kappa"] * fh
    node["by_tan"] = 0.0
    roll = node["roll"]
    by_xi = node["roll_by_xi"]
    by_tan = node["roll_by_tan"]
    roll[0] = xi + b["r_b1"] * tan_a
    roll[1] = b["r_b2"] * tan_a - xi
    by_xi[0] = 1.0
    by_xi[1] = -1.0
    by_tan[0] = b["r_b1"]
    by_tan[1] = b["r_b2"]
    if place == TIP_1:
        _set_tip(b, node, 0, 1, eta, 1.0, b["r_b1"])
    elif place == TIP_2:
        _set_tip(b, node, 1, 0, eta, -1.0, b["r_b2"])
    node["soft"] = 0.0
    node["by_z"][0] = 0.0
    node["by_z"][1] = 0.0
    if not deviating:
        return
    for gear in range(2):
        at = z + (b["w1"] - gear) * now["dz"]
        gap, gap_by_z, gap_by_roll, soft, soft_by_z, soft_by_roll = flank_slopes(b, gear, at, roll[gear])
        node["x"] -= gap
        node["by_xi"] -= gap_by_roll * by_xi[gear]
        node["by_tan"] -= gap_by_roll * by_tan[gear]
        node["by_z"][gear] = -gap_by_z
        node["soft"] += soft
        node["soft_by_roll"][gear] = soft_by_roll
        node["soft_by_z"][gear] = soft_by_z


@kernel
def _set_tip(b, node, edge, mate, eta, way, r_edge):
    """Change a node to contact of the tip edge of gear `edge` (0, 1) with its mate.

    `way`: sign of d(eta)/d(xi); d(eta)/d(tan alpha) is the base radius of the gear with the edge, since the
    end of the path moves by it.
    """
    r = b["r_b2"] if edge == 0 else b["r_b1"]
    L = b["rho_a1"] if edge == 0 else b["rho_a2"]
    gap, by_eta, by_tan, roll, roll_by_eta, roll_by_tan = tip_gap(
        eta, r_edge, r, L - b["rounding"][edge], b["now"]["tan_a"]
    )
    node["x"] -= gap
    node["by_xi"] -= way * by_eta
    node["by_tan"] -= by_tan + by_eta * r_edge
    node["roll"][edge] = L
    node["roll_by_xi"][edge] = 0.0
    node["roll_by_tan"][edge] = 0.0
    node["roll"][mate] = roll
    node["roll_by_xi"][mate] = way * roll_by_eta
    node["roll_by_tan"][mate] = roll_by_tan + roll_by_eta * r_edge


@kernel
def path_slopes(b, z):
    """Derivatives of the path position of a point at a constant fraction of the width, and of its width.

    By mean travel, tan(alpha) and axial offset of the gears; of the width by the offset.
    """
    now = b["now"]
    share = (z - now["z_lo"]) / (now["z_hi"] - now["z_lo"])
    of_z = now["lo_slope"] + share * (now["hi_slope"] - now["lo_slope"])
    fh = now["flank"] * b["tan_b"]
    by_tan = -0.5 * (b["r_b1"] - b["r_b2"]) * now["sin_a"] * now["sin_a"]
    return float(now["flank"]), by_tan, fh * (b["w1"] - 0.5 + of_z), of_z


@kernel
def node_rate(b, node):
    """Rate of the penetration of a node whose levers are set, without deformation [m/s]."""
    now = b["now"]
    lever = b["lever"]
    z = node["z"]
    by_T, by_tan, by_dz, _ = path_slopes(b, z)
    xi_rate = by_T * now["travel_rate"] + by_tan * now["tan_rate"] + by_dz * now["dz_rate"]
    w = lever[0] * b["rate"][0] + lever[1] * b["rate"][1]
    w += node["by_xi"] * xi_rate + node["by_tan"] * now["tan_rate"] - now["kappa"] * drift(b, z)
    z_rate = width_rate(b, z) + b["w1"] * now["dz_rate"]
    return w + node["by_z"][0] * z_rate + node["by_z"][1] * (z_rate - now["dz_rate"])


@kernel
def add_slopes(b, node, f, by_xi, by_tan, by_z):
    """Add the energy slopes of a node: of its penetration times the force f, and further ones.

    `by_xi`, `by_tan`: derivatives of the energy by path position and tan(alpha) at constant penetration [N];
    `by_z`: by the axial position of the plane on gear 1, and likewise on gear 2 [N].
    """
    now = b["now"]
    over_T, over_tan, over_dz, of_z = path_slopes(b, node["z"])
    s = f * node["by_xi"] + by_xi
    now["by_travel"] += s * over_T
    now["by_tan"] += s * over_tan + f * node["by_tan"] + by_tan
    shift = of_z + b["w1"]
    now["by_dz"] += s * over_dz - f * now["kappa"] * (of_z - b["w_z"])
    now["by_dz"] += (f * node["by_z"][0] + by_z[0]) * shift
    now["by_dz"] += (f * node["by_z"][1] + by_z[1]) * (shift - 1.0)


@kernel
def add_to_sums(b, f, c):
    """Add a node with the current levers: force f [N] and its tangent c [N/m]."""
    add_normal(b, f, c)
    if b["contact"]["mu"] > 0.0:
        add_friction(b, 1, f, c)


@kernel
def begin_pair(b, q):
    """Whether a tooth of the pair q has own flanks; sets their grid rows."""
    return b["n_sep"] > 0 and find_rows(b, pair_teeth(b, q))


@kernel
def levers_of(b, node):
    """Set the levers of a node."""
    set_levers(b, node["z"], node["xi"])


@kernel
def node_array(b):
    """Nodes of the current flank, shape (max_nodes,)."""
    return view(pooled(b, b["nodes"]), b["max_nodes"], NODE)
