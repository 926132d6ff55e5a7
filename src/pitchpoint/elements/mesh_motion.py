# SPDX-License-Identifier: Apache-2.0
"""How fast what a mesh consists of changes: travel, centre distance, axial offset, phases, shared width."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel


@kernel
def spin_motion(b, o1, o2):
    """Rates of gears that keep their places and turn at o1 and o2 [rad/s]."""
    now = b["now"]
    now["travel_rate"] = 0.5 * (b["r_b1"] * o1 - b["r_b2"] * o2)
    now["phase_rate"][0] = now["travel_rate"] / b["p_bt"]
    now["phase_rate"][1] = -now["phase_rate"][0]


@kernel
def motion(b, f, g):
    """Rates of the scratch of mesh `b` from the twists of both bodies; see `mesh_line` for the quantities."""
    now = b["now"]
    v = f["tw"]
    w = g["tw"]
    Rf = f["R"]
    Rg = g["R"]
    m = now["m"]
    e = now["e"]
    a = now["a"]
    w1 = b["w1"]
    zc1 = b["zc1"]
    zc2 = b["zc2"]
    # axes and the line between the mid-faces
    axial = 0.0
    along = 0.0
    dm_m = 0.0
    dm_e = 0.0
    line = now["line_rate"]
    dm = now["m_rate"]
    for k in range(3):
        k1 = (k + 1) % 3
        k2 = (k + 2) % 3
        n1 = v[3 + k1] * Rf[k2, 2] - v[3 + k2] * Rf[k1, 2]
        n2 = w[3 + k1] * Rg[k2, 2] - w[3 + k2] * Rg[k1, 2]
        line[k] = w[k] + zc2 * n2 - v[k] - zc1 * n1
        dm[k] = (w1 * n1 + (1.0 - w1) * n2) * now["inv_m"]
        axial += line[k] * m[k]
        along += line[k] * e[k]
        dm_m += dm[k] * m[k]
        dm_e += dm[k] * e[k]
    dz_rate = axial + a * dm_e
    a_rate = along - now["dz"] * dm_e
    # angles of the gears from the line of centres
    o1 = 0.0
    o2 = 0.0
    c1 = now["c1"]
    c2 = now["c2"]
    de = now["dir_rate"]
    for k in range(3):
        turned = dm[k] - dm_m * m[k]
        de[k] = (line[k] - dz_rate * m[k] - now["dz"] * turned - a_rate * e[k]) / a
    for k in range(3):
        k1 = (k + 1) % 3
        k2 = (k + 2) % 3
        o1 += v[3 + k] * (Rf[k, 2] - c1 * e[k]) - de[k] * (Rf[k1, 2] * e[k2] - Rf[k2, 2] * e[k1])
        o2 += w[3 + k] * (Rg[k, 2] - c2 * e[k]) - de[k] * (Rg[k1, 2] * e[k2] - Rg[k2, 2] * e[k1])
    spin_motion(b, o1 / (1.0 - c1 * c1), o2 / (1.0 - c2 * c2))
    _place_rates(b, a_rate, dz_rate)


@kernel
def _place_rates(b, a_rate, dz_rate):
    """Rates of the path of contact, the shared width and the phases where the gears move bodily."""
    now = b["now"]
    cos_a = now["cos_a"]
    sin_a = now["sin_a"]
    p_bt = b["p_bt"]
    alpha_rate = cos_a / (now["a"] * sin_a) * a_rate
    tan_rate = alpha_rate / (cos_a * cos_a)
    xi_A_rate = b["r_b2"] * tan_rate
    now["dz_rate"] = dz_rate
    now["xi_A_rate"] = xi_A_rate
    now["eps_rate"] = -(b["r_b1"] * tan_rate + xi_A_rate) / p_bt
    now["lo_rate"] = now["lo_slope"] * dz_rate
    now["hi_rate"] = now["hi_slope"] * dz_rate
    inv_rate = sin_a * sin_a * tan_rate
    middle = -0.5 * (b["r_b1"] - b["r_b2"]) * inv_rate - xi_A_rate
    skew = b["tan_b"] * (b["w1"] - 0.5) * dz_rate
    now["phase_rate"][0] += (middle + skew) / p_bt
    now["phase_rate"][1] += (middle - skew) / p_bt
