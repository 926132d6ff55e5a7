# SPDX-License-Identifier: Apache-2.0
"""Line of action of a cylindrical pair: contact geometry, travel and phase from two frames.

All quantities follow from invariants of the two gears (distance of the axes, direction of the line of centres
relative to each gear, axial offset) and are independent of a rigid motion of the gearbox. Both flanks use the
same formulas: flank f = +1 drives with gear 1 rotating counter-clockwise, f = -1 with gear 1 rotating
clockwise; the unit vector of its line of action in the transverse plane is n_f = f cos(alpha) t + sin(alpha)
e, with e from gear 1 to the pitch point and t = m x e along the tangent of the pitch circles.

The positions of the flanks along the line of action, from the pitch point, are xi1 = r_b1 (Phi1 + psi_b1 -
inv alpha) and xi2 = p_bt/2 - r_b2 (Phi2 + psi_b2 - inv alpha) (involute geometry, signed r_b2; Phi = angle of
a tooth of gear 1 or a space of gear 2 from the line of centres). Their difference is the penetration and
contains the backlash at the actual centre distance, their mean is the mesh phase.
"""

from __future__ import annotations

import math

from pitchpoint.contact.pair_shape import phase_stiffness
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import BAD_CENTRE, OK, UNBOUNDED
from pitchpoint.multibody.channels import F8

FARTHEST = 2.0**40
"""Travel in base pitches above which tooth pairs are not counted: the solution has diverged."""
MAX_PAIRS = 1e4
"""Length of the path of contact in base pitches above which the solution is invalid."""


@kernel
def pooled(b, offset):
    """Address of a table of a mesh at `offset` in the pool of the kind."""
    return b["pool"] + 8 * offset


@kernel
def line_of_action(b, f, g):
    """Set the scratch of mesh `b` from the frames `f` (body of gear 1) and `g` (body of gear 2).

    For purely rotating gears the line of action is fixed: compilation sets it once with `fixed` = 0.
    """
    now = b["now"]
    if b["fixed"] == 1:
        _travel(b, f["phi"], f["turns"], g["phi"], g["turns"])
        return countable(now["u"], now["travel"], b["p_bt"], now["eps"])
    w1 = b["w1"]
    w2 = 1.0 - w1
    rb = b["r_b1"] + b["r_b2"]
    m = now["m"]
    e = now["e"]
    t = now["t"]
    dn = now["dn"]
    P = now["P"]
    Rf = f["R"]
    Rg = g["R"]
    # axes, line of centres, pitch point
    cx = g["r"][0] + b["zc2"] * Rg[0, 2] - f["r"][0] - b["zc1"] * Rf[0, 2]
    cy = g["r"][1] + b["zc2"] * Rg[1, 2] - f["r"][1] - b["zc1"] * Rf[1, 2]
    cz = g["r"][2] + b["zc2"] * Rg[2, 2] - f["r"][2] - b["zc1"] * Rf[2, 2]
    for k in range(3):
        m[k] = w1 * Rf[k, 2] + w2 * Rg[k, 2]
        dn[k] = Rg[k, 2] - Rf[k, 2]
    s = 1.0 / math.sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2])
    now["inv_m"] = s
    m[0] *= s
    m[1] *= s
    m[2] *= s
    dz = cx * m[0] + cy * m[1] + cz * m[2]
    ex = cx - dz * m[0]
    ey = cy - dz * m[1]
    ez = cz - dz * m[2]
    a = math.sqrt(ex * ex + ey * ey + ez * ez)
    if not a * a > rb * rb:
        return BAD_CENTRE
    signed_a = a if rb > 0.0 else -a
    e[0] = ex / signed_a
    e[1] = ey / signed_a
    e[2] = ez / signed_a
    now["a"] = signed_a
    now["c1"] = e[0] * Rf[0, 2] + e[1] * Rf[1, 2] + e[2] * Rf[2, 2]
    now["c2"] = e[0] * Rg[0, 2] + e[1] * Rg[1, 2] + e[2] * Rg[2, 2]
    t[0] = m[1] * e[2] - m[2] * e[1]
    t[1] = m[2] * e[0] - m[0] * e[2]
    t[2] = m[0] * e[1] - m[1] * e[0]
    P[0] = f["r"][0] + b["zc1"] * Rf[0, 2] + w1 * cx
    P[1] = f["r"][1] + b["zc1"] * Rf[1, 2] + w1 * cy
    P[2] = f["r"][2] + b["zc1"] * Rf[2, 2] + w1 * cz
    now["dz"] = dz
    place_gears(b, rb / signed_a)
    # rotation of the line of centres relative to each gear frame
    x = e[0] * Rf[0, 0] + e[1] * Rf[1, 0] + e[2] * Rf[2, 0]
    y = e[0] * Rf[0, 1] + e[1] * Rf[1, 1] + e[2] * Rf[2, 1]
    turn1 = math.atan2(b["cos1"] * y - b["sin1"] * x, b["cos1"] * x + b["sin1"] * y)
    x = e[0] * Rg[0, 0] + e[1] * Rg[1, 0] + e[2] * Rg[2, 0]
    y = e[0] * Rg[0, 1] + e[1] * Rg[1, 1] + e[2] * Rg[2, 1]
    turn2 = math.atan2(b["cos2"] * y - b["sin2"] * x, b["cos2"] * x + b["sin2"] * y)
    whole1 = f["turns"]
    whole2 = g["turns"]
    if b["carried"] == 1:
        whole2 += carried_turns(g, f, turn2, turn1)
    elif b["carried"] == 2:
        whole1 += carried_turns(f, g, turn1, turn2)
    else:
        # both frames are on one base: the line of centres rotates equally relative to both
        turn2 -= 2.0 * math.pi * math.floor((turn2 - turn1) / (2.0 * math.pi) + 0.5)
        turned = turns_of_line(b, f["phi"] - turn1, whole1, g["phi"] - turn2, whole2)
        whole1 -= turned
        whole2 -= turned
    _travel(b, f["phi"] - turn1, whole1, g["phi"] - turn2, whole2)
    return countable(now["u"], now["travel"], b["p_bt"], now["eps"])


@kernel
def countable(u, travel, pitch, eps):
    """Status UNBOUNDED if the solution has diverged so far that tooth pairs cannot be counted, else OK.

    Beyond 2^53 pitches adding 1 does not change a number, and the loop over pairs would not terminate.

    Parameters
    ----------
    u, travel
        Deflection and mean travel along the base tangent [m].
    pitch
        Base pitch [m].
    eps
        Length of the path of contact in pitches [-].
    """
    if abs(u) + abs(travel) < FARTHEST * pitch and abs(eps) < MAX_PAIRS:
        return OK
    return UNBOUNDED


@kernel
def turns_of_line(b, phi1, turns1, phi2, turns2):
    """Whole turns of the line of centres, which neither frame determines, from the spins of both gears.

    One turn of the line adds p_bt (z1 + z2) to the travel. The teeth in mesh are always the nearest ones, so
    that the travel is at most half of that.
    """
    teeth = b["z1"] + b["z2"]
    over = (b["r_b1"] * phi1 + b["r_b2"] * phi2) / b["p_bt"] + (b["z1"] * turns1 + b["z2"] * turns2)
    return int(math.floor(over / teeth + 0.5))


@kernel
def carried_turns(f, g, turn_f, turn_g):
    """Whole turns by which the line of centres, fixed to the base of gear g, lags behind gear f.

    Relative to gear f it has rotated with the base of g plus a small angle (`turn_g`); the remainder `turn_f`
    is known. The bases rotate with the spins of the bodies that support the gears.
    """
    rest = (g["base"] - f["base"] + turn_g - turn_f) / (2.0 * math.pi)
    return -(int(math.floor(rest + 0.5)) + g["base_turns"] - f["base_turns"])


@kernel
def _travel(b, phi1, turns1, phi2, turns2):
    """Set base-tangent travel and mean travel; integer whole turns avoid a loss of precision."""
    now = b["now"]
    s1 = b["r_b1"] * phi1
    s2 = b["r_b2"] * phi2
    n1 = b["z1"] * turns1
    n2 = b["z2"] * turns2
    now["u"] = s1 + s2 + b["p_bt"] * (n1 + n2) + b["u0"] + b["tan_b"] * now["dz"]
    n = n1 - n2
    half = n % 2
    now["turn"] = (n - half) // 2
    now["travel"] = 0.5 * (s1 - s2 + b["p_bt"] * half)


@kernel
def place_gears(b, cos_a):
    """Set working pressure angle, backlash, path of contact, common face width and offsets of the phases.

    A and E are the intersections of the tip circles with the line of action; widths are relative to the plane
    of the pitch point. The axial offset of the gears has been set.
    """
    now = b["now"]
    now["cos_a"] = cos_a
    now["sin_a"] = math.sqrt(1.0 - cos_a * cos_a)
    now["inv_a"] = now["sin_a"] / cos_a - math.acos(cos_a)
    now["gap"] = 2.0 * (b["r_b1"] + b["r_b2"]) * (now["inv_a"] - b["inv_w0"])
    tan_a = now["sin_a"] / now["cos_a"]
    xi_A = b["r_b2"] * tan_a - b["rho_a2"]
    eps = (b["rho_a1"] - b["r_b1"] * tan_a - xi_A) / b["p_bt"]
    now["xi_A"] = xi_A
    now["eps"] = eps
    now["L"] = b["T_R"] * (eps - math.floor(eps))
    dz = now["dz"]
    shift = b["w1"] * dz
    lo2 = dz - 0.5 * b["b2"]
    hi2 = dz + 0.5 * b["b2"]
    now["z_lo"] = max(-0.5 * b["b1"], lo2) - shift
    now["z_hi"] = min(0.5 * b["b1"], hi2) - shift
    now["lo_slope"] = (1.0 if lo2 >= -0.5 * b["b1"] else 0.0) - b["w1"]
    now["hi_slope"] = (1.0 if hi2 < 0.5 * b["b1"] else 0.0) - b["w1"]
    middle = -0.5 * (b["r_b1"] - b["r_b2"]) * now["inv_a"] - xi_A
    skew = b["tan_b"] * (b["w1"] - 0.5) * dz
    now["start"][0] = (middle + skew) / b["p_bt"]
    now["start"][1] = (middle - skew) / b["p_bt"]


@kernel
def flank_phase(b, flank):
    """Mesh phase of the front (+1) or back (-1) flank, whole base pitches included up to `turn`."""
    now = b["now"]
    if flank > 0:
        return now["start"][0] + (b["xi_0"] + now["travel"]) / b["p_bt"]
    return now["start"][1] + (b["xi_b"] - now["travel"]) / b["p_bt"]


@kernel
def begin_flank(b, flank, width):
    """Set phase of a flank and slope of its contact lines over `width` [m].

    `width`: 1 m for lines straight over the face width; mean cone distance for lines over its logarithm.
    """
    now = b["now"]
    now["flank"] = flank
    psi = flank_phase(b, flank)
    whole = math.floor(psi)
    now["psi"] = psi - whole
    now["tooth"] = int(whole) + flank * now["turn"]
    now["lam"] = flank * b["tan_b"] * width / b["p_bt"]


@kernel
def excitation(b, f, g, psi):
    """Set the static transmission error e(psi, phi1, phi2) and its rate."""
    now = b["now"]
    now["e_t"] = 0.0
    now["e_rate"] = 0.0
    if b["n_e"] > 0:
        n = b["n_e"]
        value, slope = phase_stiffness(
            psi, 0, n, view(pooled(b, b["e_cos"]), n, F8), view(pooled(b, b["e_sin"]), n, F8)
        )
        now["e_t"] = value - 1.0
        now["e_rate"] = slope * now["phase_rate"][0]
    if b["n_e1"] > 0:
        _shaft_orders(b, view(pooled(b, b["e1"]), (b["n_e1"], 3), F8), f["phi"], f["turns"], f["spin"])
    if b["n_e2"] > 0:
        _shaft_orders(b, view(pooled(b, b["e2"]), (b["n_e2"], 3), F8), g["phi"], g["turns"], g["spin"])


@kernel
def _shaft_orders(b, rows, phi, turns, omega):
    now = b["now"]
    for k in range(rows.shape[0]):
        order = rows[k, 0]
        whole = order * turns
        angle = order * phi + 2.0 * math.pi * (whole - math.floor(whole)) + rows[k, 2]
        now["e_t"] += rows[k, 1] * math.cos(angle)
        now["e_rate"] -= rows[k, 1] * math.sin(angle) * order * omega


@kernel
def spin_motion(b, o1, o2):
    """Set travel and phase rates of gears at fixed positions that rotate at o1 and o2 [rad/s]."""
    now = b["now"]
    now["travel_rate"] = 0.5 * (b["r_b1"] * o1 - b["r_b2"] * o2)
    now["phase_rate"][0] = now["travel_rate"] / b["p_bt"]
    now["phase_rate"][1] = -now["phase_rate"][0]


@kernel
def motion(b, f, g):
    """Set the rates in the scratch of mesh `b` from the velocities of both bodies."""
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
    # angular velocities of the gears relative to the line of centres
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
    """Set the rates of path of contact, common width and phases from the translation of the gears."""
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
