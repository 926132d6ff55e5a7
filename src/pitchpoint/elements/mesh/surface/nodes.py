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

from pitchpoint.contact.tip_contact import tip_gap_curvature, tip_gap_floor, tip_gap_from_mean
from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh.flank_deviations import begin_separation, find_rows, flank_slopes
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.elements.mesh.nodes import set_levers
from pitchpoint.elements.mesh.sums import add_friction, add_normal
from pitchpoint.elements.mesh.tooth_pairs import pair_teeth

ON_PATH, TIP_1, TIP_2 = 0, 1, 2
"""Places of a node: on the line of action; tip edge of gear 1 beyond E; tip edge of gear 2 before A."""

#: Contact node of a tooth pair in one plane.
NODE = np.dtype(
    [
        ("pair", "i8"),  # number of the pair, as `contact_lines`
        ("slot", "i8"),  # pairs from the first one with nodes, in descending order of their numbers
        ("plane", "i8"),
        ("place", "i8"),
        ("z", "f8"),
        ("xi", "f8"),  # width and path position from the pitch point [m]
        ("x", "f8"),  # penetration without deformation [m]
        ("plain", "i8"),  # 1: unmodified flanks on the path of contact, the next four fields are 0
        ("by_xi", "f8"),
        ("by_tan", "f8"),
        (
            "by_z",
            "f8",
            2,
        ),  # derivatives of x by path position, without that by the misalignment, by tan(alpha),
        # and by the widths on both gears
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
    width = now["z_hi"] - now["z_lo"]
    now["plane_step"] = width / b["slices"]
    now["growth"] = (now["hi_slope"] - now["lo_slope"]) / width
    if b["n_sep"] > 0:
        begin_separation(b)
    else:
        now["tan_a"] = now["sin_a"] / now["cos_a"]
        now["tan_rate"] = now["xi_A_rate"] / b["r_b2"]
    place = now["place_slope"]
    place[1] = now["growth"]
    place[0] = now["lo_slope"] - now["z_lo"] * place[1]
    now["xi_slope"] = -0.5 * (b["r_b1"] - b["r_b2"]) * now["sin_a"] * now["sin_a"]
    # path positions and penetrations are linear over the width, and so are their rates
    fh = now["flank"] * b["tan_b"]
    xi = now["xi_rate"]
    xi[0] = now["flank"] * now["travel_rate"] + now["xi_slope"] * now["tan_rate"]
    xi[0] += fh * (b["w1"] - 0.5 + place[0]) * now["dz_rate"]
    xi[1] = fh * place[1] * now["dz_rate"]
    x = now["x_rate"]
    x[0] = -now["kappa"] * (fh * xi[0] + (place[0] - b["w_z"]) * now["dz_rate"])
    x[1] = -now["kappa"] * (fh * xi[1] + place[1] * now["dz_rate"])


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
def planes_of(b):
    """Constants of the contact planes of the current flank, for `plane_point`."""
    now = b["now"]
    end = now["xi_A"] + now["eps"] * b["p_bt"]
    path = (now["xi_A"], end, now["psi"], now["lam"], b["p_bt"])
    return (now["z_lo"], now["plane_step"]), path, (now["x_0"], now["kappa"], now["flank"] * b["tan_b"])


@kernel
def plane_point(planes, q, s):
    """Contact point of the pair q in the plane s, without the gaps of the flanks.

    Width from the pitch point along the axes and path position [m]; place and distance from the path of
    contact [m]; penetration on the line of action [m].
    """
    (z_lo, step), (start, end, psi, lam, p_bt), (x_0, kappa, fh) = planes
    z = z_lo + (s + 0.5) * step
    xi = start + (psi + q + lam * z) * p_bt
    x = x_0 - kappa * (z + fh * xi)
    if xi < start:
        return z, xi, TIP_2, start - xi, x
    if xi > end:
        return z, xi, TIP_1, xi - end, x
    return z, xi, ON_PATH, 0.0, x


@kernel
def tip_bounds(b):
    """Lower bounds of the gaps of both tip edges over eta^2 [1/m]; maximum eta, minimum sum of both gaps."""
    one = _tip_bound(b, 0, b["r_b1"], b["r_b2"], b["rho_a1"])
    two = _tip_bound(b, 1, b["r_b2"], b["r_b1"], b["rho_a2"])
    return one, two, b["reach"], b["sep_min"]


@kernel
def _tip_bound(b, edge, r_1, r_2, L):
    """Lower bound for the tip edge of gear 1 or 2 (0 or 1), its share of the curvature from the first use."""
    L -= b["rounding"][edge]
    tan_a = b["now"]["tan_a"]
    c = tip_gap_curvature(r_1, r_2, L, tan_a)
    if not (c > 0.0 and c < math.inf):
        return 0.0
    if b["tip_share"][edge] < 0.0:
        b["tip_share"][edge] = 0.5 * tip_gap_floor(b["reach"], r_1, r_2, L, tan_a) / c
    return b["tip_share"][edge] * c


@kernel
def reaches(bounds, place, eta, x):
    """Whether flanks may be in contact at the penetration x on the line of action [m]."""
    one, two, reach, least = bounds
    if place == ON_PATH:
        return x > least
    c = one if place == TIP_1 else two
    return x - least > c * eta * eta and eta <= reach


@kernel
def is_far(planes, bounds, q, last):
    """Whether the pair q is beyond one end of the path in all planes up to `last`, and out of reach there.

    Distance and penetration are linear over the width, so that the planes at both ends bound them.
    """
    _, _, place, eta, x = plane_point(planes, q, 0)
    _, _, other, eta_1, x_1 = plane_point(planes, q, last)
    return place != ON_PATH and other == place and not reaches(bounds, place, min(eta, eta_1), max(x, x_1))


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
    node["plain"] = 1 if place == ON_PATH and not deviating else 0
    node["by_xi"] = 0.0
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
    for gear in range(2):
        node["soft_by_roll"][gear] = 0.0
        node["soft_by_z"][gear] = 0.0
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
    radius = b["rounding"][edge]
    found = tip_gap_from_mean(eta, r_edge, r, L - radius, b["now"]["tan_a"])
    gap, by_eta, by_tan, roll, roll_by_eta, roll_by_tan, _ = found
    node["x"] -= gap
    node["by_xi"] -= way * by_eta
    node["by_tan"] -= by_tan + by_eta * r_edge
    node["roll"][edge] = L
    node["roll_by_xi"][edge] = 0.0
    node["roll_by_tan"][edge] = 0.0
    node["roll"][mate] = roll - radius
    node["roll_by_xi"][mate] = way * roll_by_eta
    node["roll_by_tan"][mate] = roll_by_tan + roll_by_eta * r_edge


@kernel
def plain_rate(b, z):
    """Rate of the penetration of unmodified flanks at the width z, whose levers are set [m/s]."""
    x_rate = b["now"]["x_rate"]
    return b["rate"][0] + b["lever"][1] * b["rate"][1] + x_rate[0] + x_rate[1] * z


@kernel
def node_rate(b, node):
    """Rate of the penetration of a node whose levers are set, without deformation [m/s]."""
    now = b["now"]
    z = node["z"]
    w = plain_rate(b, z)
    if node["plain"] == 1:
        return w
    xi_rate = now["xi_rate"][0] + now["xi_rate"][1] * z
    w += node["by_xi"] * xi_rate + node["by_tan"] * now["tan_rate"]
    z_rate = (now["place_slope"][0] + now["place_slope"][1] * z + b["w1"]) * now["dz_rate"]
    return w + node["by_z"][0] * z_rate + node["by_z"][1] * (z_rate - now["dz_rate"])


@kernel
def add_slopes(b, node, f, by_xi, by_tan, by_z):
    """Add the energy slopes of a node: of its penetration times the force f, and further ones.

    `by_xi`, `by_tan`: derivatives of the energy by path position and tan(alpha) at constant penetration [N];
    `by_z`: by the axial position of the plane on gear 1, and likewise on gear 2 [N].
    """
    now = b["now"]
    add_plain_slopes(b, f, node["z"])
    s = f * node["by_xi"] + by_xi
    shift = now["place_slope"][0] + now["place_slope"][1] * node["z"] + b["w1"]
    now["by_travel"] += s * now["flank"]
    now["by_tan"] += s * now["xi_slope"] + f * node["by_tan"] + by_tan
    across = (f * node["by_z"][0] + by_z[0]) * shift + (f * node["by_z"][1] + by_z[1]) * (shift - 1.0)
    now["by_dz"] += s * now["flank"] * b["tan_b"] * (shift - 0.5) + across


@kernel
def add_plain_slopes(b, f, z):
    """Add the energy slopes of a force f [N] at the width z [m] that follow from the misalignment alone."""
    now = b["now"]
    fh = now["flank"] * b["tan_b"]
    of_z = now["place_slope"][0] + now["place_slope"][1] * z
    s = -f * now["kappa"] * fh
    now["by_travel"] += s * now["flank"]
    now["by_tan"] += s * now["xi_slope"]
    now["by_dz"] += s * fh * (of_z + b["w1"] - 0.5) - f * now["kappa"] * (of_z - b["w_z"])


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
