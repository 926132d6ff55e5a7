# SPDX-License-Identifier: Apache-2.0
"""Gear mesh: force of two toothed bodies on each other, from their frames alone.

Frame channel. `mesh_line` finds where the flanks are, `mesh_nodes` sums what they do along their contact
lines, this file turns the sums into wrenches, tangents and observations. Forces act along the normal in the
transverse plane of each flank plus their axial share: N_f = n_f - f tan(beta_b) m per unit of base-tangent
force.

Tangents hold at frozen mesh phase and frozen line of action: what the Newton iteration, static equilibrium
and modes about an operating point need. The change of the stiffness with the phase shows up as parametric
power.
"""

from __future__ import annotations

import math

from pitchpoint.contact.pair_shape import phase_stiffness
from pitchpoint.core.kernel import call_law, kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.gear_mesh_record import (
    EVENTS,
    MAX_PAIRS,
    N_ACC,
    N_OUT,
    OUTPUTS,
    PHASE,
    RECORD,
    USER,
)
from pitchpoint.elements.mesh_line import (
    excitation,
    line_of_action,
    mean_position,
    path_of_contact,
    pooled,
    rates,
)
from pitchpoint.elements.mesh_nodes import phase_flank, profile_flank
from pitchpoint.multibody.channels import events, frame_args, observations

__all__ = ["EVENTS", "MAX_PAIRS", "OUTPUTS", "RECORD", "entry", "gear_mesh"]


def outputs(record):
    """Observations of one record: those of every mesh and the forces of its tooth pairs."""
    pairs = range(int(record["n_pair"]))
    return (*OUTPUTS, *((f"pair_force[{{}}.{k}]", "N", f"force of tooth pair {k}") for k in pairs))


@kernel
def _directions(b, f, g, flank):
    """Wrench basis of one flank on both bodies: normal force (1, y), friction (1, z, xi)."""
    m = b["m"]
    e = b["e"]
    t = b["t"]
    P = b["P"]
    ca = flank * b["cos_a"]
    sa = b["sin_a"]
    h = flank * b["tan_b"]
    for side in range(2):
        B = b["basis_i"] if side == 0 else b["basis_j"]
        o = f["r"] if side == 0 else g["r"]
        sign = -1.0 if side == 0 else 1.0
        x = P[0] - o[0]
        y = P[1] - o[1]
        z = P[2] - o[2]
        for k in range(3):
            k1 = (k + 1) % 3
            k2 = (k + 2) % 3
            n = ca * t[k] + sa * e[k]
            n1 = ca * t[k1] + sa * e[k1]
            n2 = ca * t[k2] + sa * e[k2]
            tau = m[k1] * n2 - m[k2] * n1
            B[0, k] = sign * (n - h * m[k])
            B[1, k] = 0.0
            B[1, 3 + k] = sign * tau
            B[2, k] = sign * tau
            B[3, k] = 0.0
            B[3, 3 + k] = -sign * n
            B[4, k] = 0.0
            B[4, 3 + k] = sign * m[k]
        for r in (0, 2):
            B[r, 3] = y * B[r, 2] - z * B[r, 1]
            B[r, 4] = z * B[r, 0] - x * B[r, 2]
            B[r, 5] = x * B[r, 1] - y * B[r, 0]


@kernel
def _flank_rates(b):
    """Normal and sliding rates of the current flank at the pitch point, with their slopes."""
    B = b["basis_j"]
    dv = b["dv"]
    dw = b["dw"]
    r = b["rate"]
    r[0] = B[0, 0] * dv[0] + B[0, 1] * dv[1] + B[0, 2] * dv[2] - b["flank"] * b["e_rate"]
    r[1] = B[1, 3] * dw[0] + B[1, 4] * dw[1] + B[1, 5] * dw[2]
    r[2] = B[2, 0] * dv[0] + B[2, 1] * dv[1] + B[2, 2] * dv[2]
    r[3] = B[3, 3] * dw[0] + B[3, 4] * dw[1] + B[3, 5] * dw[2]
    r[4] = B[4, 3] * dw[0] + B[4, 4] * dw[1] + B[4, 5] * dw[2]


@kernel
def _width(b):
    """Shared face width from the plane of the pitch point."""
    shift = b["w1"] * b["dz"]
    b["z_lo"] = max(-0.5 * b["b1"], b["dz"] - 0.5 * b["b2"]) - shift
    b["z_hi"] = min(0.5 * b["b1"], b["dz"] + 0.5 * b["b2"]) - shift


@kernel
def _place(b, flank):
    """Phase and contact-line slope of one flank, into the scratch."""
    b["flank"] = flank
    p_bt = b["p_bt"]
    fh = flank * b["tan_b"]
    xi = mean_position(b, flank) + fh * (b["w1"] - 0.5) * b["dz"]
    psi = (xi - b["xi_A"]) / p_bt
    whole = math.floor(psi)
    b["psi"] = psi - whole
    b["tooth"] = int(whole) + flank * b["turn"]
    b["lam"] = fh / p_bt
    b["L"] = b["T_R"] * (b["eps"] - math.floor(b["eps"]))


@kernel
def _stiffness_ratio(b):
    """k(psi)/mean of a prescribed stiffness and its slope; user laws have no slope."""
    if b["form"] == USER:
        return call_law(b["law"], 0.0, b["psi"], b["pool"] + 8 * b["params"]) / b["c_prime"], 0.0
    n = b["n_k"]
    return phase_stiffness(b["psi"], b["form"], n, pooled(b, b["cosine"], n), pooled(b, b["sine"], n))


@kernel
def _flank(b, ctl, f, g, flank, x_0):
    """Sum one flank into `acc`."""
    _place(b, flank)
    _directions(b, f, g, flank)
    _flank_rates(b)
    B = b["basis_j"]
    dn = b["dn"]
    # n_f is minus the moment of B[3]
    b["kappa"] = -(B[3, 3] * dn[0] + B[3, 4] * dn[1] + B[3, 5] * dn[2])
    b["tilt"] = b["kappa"]
    if b["source"] == PHASE:
        ratio, slope = _stiffness_ratio(b)
        if not math.isfinite(ratio):
            return NOT_FINITE
        phase_flank(b, ctl, x_0, ratio, slope)
    else:
        b["tilt"] = b["kappa"] * (1.0 + b["tan_b"] * b["tan_b"])
        profile_flank(b, ctl, x_0)
    return OK


@kernel
def _add_wrench(b, f, g):
    acc = b["acc"]
    n = 5 if b["mu"] > 0.0 else 2
    for p in range(n):
        s = acc[p]
        for k in range(6):
            f["F"][k] += s * b["basis_i"][p, k]
            g["F"][k] += s * b["basis_j"][p, k]


@kernel
def _coefficient(acc, p, q):
    """Entry (p, q) of the tangent in the wrench basis."""
    if p < 2:
        return acc[5 + p + q] if q < 2 else 0.0
    r = p - 2
    if q < 2:
        return acc[8 + 2 * r + q]
    s = q - 2
    lo = min(r, s)
    hi = max(r, s)
    return acc[14 + hi] if lo == 0 else acc[16 + lo + hi - 1] if lo == 1 else acc[19]


@kernel
def _add_tangent(b, kk):
    acc = b["acc"]
    size = 5 if b["mu"] > 0.0 else 2
    for p in range(size):
        for q in range(size):
            c = _coefficient(acc, p, q)
            if c == 0.0:
                continue
            for k in range(6):
                ci = c * b["basis_i"][p, k]
                cj = c * b["basis_j"][p, k]
                for n in range(6):
                    kk[b["ii"], k, n] += ci * b["basis_i"][q, n]
                    kk[b["ij"], k, n] += ci * b["basis_j"][q, n]
                    kk[b["ji"], k, n] += cj * b["basis_i"][q, n]
                    kk[b["jj"], k, n] += cj * b["basis_j"][q, n]


@kernel
def _mesh_damper(b, ctl, f, g, kk):
    """Damper along the base tangent, in the gap too; returns its force and power."""
    m = b["m"]
    t = b["t"]
    P = b["P"]
    Bi = b["basis_i"]
    Bj = b["basis_j"]
    rate = -b["e_rate"]
    for k in range(3):
        d = b["cos_a"] * t[k] - b["tan_b"] * m[k]
        Bi[0, k] = -d
        Bj[0, k] = d
        rate += d * b["dv"][k]
    for side in range(2):
        B = Bi if side == 0 else Bj
        o = f["r"] if side == 0 else g["r"]
        x = P[0] - o[0]
        y = P[1] - o[1]
        z = P[2] - o[2]
        B[0, 3] = y * B[0, 2] - z * B[0, 1]
        B[0, 4] = z * B[0, 0] - x * B[0, 2]
        B[0, 5] = x * B[0, 1] - y * B[0, 0]
    s = b["d_gap"] * rate
    for k in range(6):
        f["F"][k] += s * Bi[0, k]
        g["F"][k] += s * Bj[0, k]
    if ctl["jac"] != 0:
        c = ctl["cd"] * b["d_gap"]
        for k in range(6):
            for n in range(6):
                kk[b["ii"], k, n] += c * Bi[0, k] * Bi[0, n]
                kk[b["ij"], k, n] += c * Bi[0, k] * Bj[0, n]
                kk[b["ji"], k, n] += c * Bj[0, k] * Bi[0, n]
                kk[b["jj"], k, n] += c * Bj[0, k] * Bj[0, n]
    return s, s * rate


@kernel
def _write(b, out, psi, damper_power):
    """Observations that do not depend on the flank; sums were added by `_write_flank`."""
    k = b["out"]
    out[k] = b["u"]
    out[k + 1] = b["u"] - b["e_t"]
    out[k + 4] = psi
    out[k + 11] += damper_power


@kernel
def _write_flank(b, out, flank):
    """Add one flank to the observations."""
    k = b["out"]
    acc = b["acc"]
    F = acc[0]
    out[k + 2] += flank * F
    out[k + 3] += acc[20]
    if F > 0.0:
        out[k + 5] = 2.0 if out[k + 5] == 1.0 else float(flank)
    out[k + 6] += F * math.sqrt(1.0 + b["tan_b"] * b["tan_b"])
    out[k + 7] += flank * F * b["cos_a"]
    out[k + 8] += F * b["sin_a"]
    out[k + 9] -= flank * F * b["tan_b"]
    out[k + 10] += acc[21]
    out[k + 11] += acc[22]
    out[k + 12] += acc[23]
    out[k + 13] += acc[24]
    for p in range(b["n_pair"]):
        out[k + N_OUT + p] += b["pair"][p]


@kernel
def _roots(b, ev, psi, front, back, spin):
    """Event functions: gaps of both flanks, entry and exit of a pair, change of the sliding direction."""
    k = b["ev"]
    ev[k] = front
    ev[k + 1] = back
    ev[k + 2] = math.sin(2.0 * math.pi * psi)
    ev[k + 3] = math.sin(2.0 * math.pi * (psi - b["eps"]))
    ev[k + 4] = math.sin(2.0 * math.pi * (psi + b["xi_A"] / b["p_bt"])) * spin


@kernel
def gear_mesh(rec, ctl, fr, kk):
    """Wrenches, tangents and observations of all meshes; see the module text."""
    c = ctl[0]
    for r in range(rec.size):
        b = rec[r]
        f = fr[b["i"]]
        g = fr[b["j"]]
        status = line_of_action(b, f, g)
        if status != OK:
            c["bad"] = r
            return status
        o1, o2 = rates(b, f, g)
        xi_A, xi_E = path_of_contact(b)
        b["xi_A"] = xi_A
        b["eps"] = (xi_E - xi_A) / b["p_bt"]
        psi = (mean_position(b, 1) - xi_A) / b["p_bt"] + b["tan_b"] * (b["w1"] - 0.5) * b["dz"] / b["p_bt"]
        psi -= math.floor(psi)
        excitation(b, f, g, psi, o1, o2)
        _width(b)
        watch = c["out"] != 0
        if watch:
            out = observations(ctl)
            for k in range(N_OUT + b["n_pair"]):
                out[b["out"] + k] = 0.0
        x = b["u"] - b["e_t"]
        # a flank cannot touch while even its deepest corner is open
        slack = abs(b["dn"][0]) + abs(b["dn"][1]) + abs(b["dn"][2])
        slack *= 0.5 * (b["b1"] + b["b2"]) + abs(b["tan_b"]) * (abs(xi_A) + abs(xi_E) + b["b1"] + b["b2"])
        if b["eps"] > 0.0 and b["z_hi"] > b["z_lo"]:
            for flank in (1, -1):
                x_0 = flank * x - 0.5 * b["gap"]
                if x_0 + slack <= b["sep_min"]:
                    continue
                for k in range(N_ACC):
                    b["acc"][k] = 0.0
                for k in range(b["n_pair"]):
                    b["pair"][k] = 0.0
                status = _flank(b, c, f, g, flank, x_0)
                if status != OK:
                    c["bad"] = r
                    return status
                _add_wrench(b, f, g)
                if c["jac"] != 0:
                    _add_tangent(b, kk)
                if watch:
                    _write_flank(b, observations(ctl), flank)
        power = 0.0
        force = 0.0
        if b["d_gap"] > 0.0:
            force, power = _mesh_damper(b, c, f, g, kk)
        if watch:
            out = observations(ctl)
            out[b["out"] + 2] += force
            _write(b, out, psi, power)
        if c["ev"] != 0:
            _roots(b, events(ctl), psi, x - 0.5 * b["gap"], -x - 0.5 * b["gap"], o1 - o2)
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, kk = frame_args(ctl)
    return gear_mesh(view(rec, n, RECORD), c, fr, kk)
