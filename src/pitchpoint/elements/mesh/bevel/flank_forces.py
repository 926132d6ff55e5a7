# SPDX-License-Identifier: Apache-2.0
"""Forces of one flank of a bevel mesh, summed over contact nodes; `mesh.sums.add_node` evaluates a node.

Along a contact line the path position is p = p_0 + lam ln(R/R_m) base pitches, so straight teeth touch along
rays. Five Gauss points on every piece between kinks (start and end of contact, ends of the ramps, separation
of the flanks, sliding reversal at the pitch ray) integrate force, couples and tangents. Slices of a pair at
different R are geometrically similar: the stiffness per face width is constant along the face.

Without observations `watch` is None, and code that only observations need is not compiled.
"""

from __future__ import annotations

import math

from pitchpoint.contact.flank_law import flank_energy
from pitchpoint.contact.lift_off import MAX_STEPS, narrowed, secant
from pitchpoint.contact.pair_shape import pair_shape, pair_shape_rate
from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh.bevel.record import N_OUT, N_OWN, PHASE
from pitchpoint.elements.mesh.observations import add_pair_force
from pitchpoint.elements.mesh.sums import across, add_node
from pitchpoint.multibody.channels import F8

_PLACES = (-0.906179845938664, -0.5384693101056831, 0.0, 0.5384693101056831, 0.906179845938664)
_WEIGHTS = (
    0.2369268850561891,
    0.4786286704993665,
    0.5688888888888889,
    0.4786286704993665,
    0.2369268850561891,
)


@kernel
def _stand(b, R, sigma):
    """Set the levers of a node; returns its penetration along the base tangent [m]."""
    now = b["now"]
    lever = b["lever"]
    c = math.cos(sigma)
    s = math.sin(sigma)
    lever[0] = c
    lever[1] = s
    lever[2] = R
    lever[3] = 1.0
    lever[4] = R * c
    lever[5] = R * s
    return across(b, now["x"]) - now["lacks"] * R / b["R_m"]


@kernel
def _add(b, watch, x, k, limit, feed):
    """Add the node with the current levers; its displacement relative to that at R_m is R/R_m."""
    size = b["lever"][2] / b["R_m"]
    return add_node(b, watch, x, k, limit, feed, None, size * size)


@kernel
def _ray(b, p):
    """Angle between the ray at the path position p and the pitch ray [rad]."""
    return (b["now"]["xi_A"] + p * b["p_bt"]) / b["R_m"]


@kernel
def _line_at(b, p_0, R):
    """Path position of a contact line at the cone distance R; constant for straight teeth."""
    now = b["now"]
    if now["lam"] == 0.0:
        return p_0
    return p_0 + now["lam"] * math.log(R / b["R_m"])


@kernel
def _aside(b, sigma, p_rate):
    """Penetration rate from the motion of the contact line across the flank at p_rate base pitches/s."""
    now = b["now"]
    rate = (now["xi_A_rate"] + p_rate * b["p_bt"]) / b["R_m"]
    return rate * (now["x"][1] * math.cos(sigma) - now["x"][0] * math.sin(sigma))


@kernel
def pair_node(b, watch, p_0, R, weight):
    """Add one node of the pair with its contact line at p_0 at R_m; `weight`: part of the face width [m]."""
    now = b["now"]
    p = _line_at(b, p_0, R)
    sigma = _ray(b, p)
    x = _stand(b, R, sigma)
    scale = b["c_prime"] * weight
    k_rate = 0.0
    x_rate = 0.0
    if watch is not None:
        p_rate = now["phase_rate"][0 if now["flank"] > 0 else 1]
        wider = b["T_R"] * now["eps_rate"]
        k_rate = scale * pair_shape_rate(p, p_rate, now["eps"], now["eps_rate"], b["S_R"], now["L"], wider)
        x_rate = _aside(b, sigma, p_rate)
    k = scale * pair_shape(p, now["eps"], b["S_R"], now["L"])
    return _add(b, watch, x, k, b["load_limit"] * weight, (k_rate, x_rate, 0.0))


@kernel
def _total_node(b, watch, R, weight):
    """Add one node of a constant total stiffness, which acts along the pitch ray."""
    x = _stand(b, R, 0.0)
    return _add(b, watch, x, b["c_prime"] * b["spread"] * weight, 0.0, (0.0, 0.0, 0.0))


@kernel
def _depth(b, p_0, R):
    """Penetration along the base tangent of a contact line at R [m]."""
    return _stand(b, R, 0.0 if b["source"] == PHASE else _ray(b, _line_at(b, p_0, R)))


@kernel
def _edge(b, p_0, a, c, x_a, x_c):
    """Zero of the penetration between a and c, where its signs differ."""
    bracket = (a, c, x_a, x_c, 0)
    small = 1e-15 * (abs(x_a) + abs(x_c))
    R = c
    for _ in range(MAX_STEPS):
        R = secant(bracket)
        x = _depth(b, p_0, R)
        if abs(x) <= small:
            break
        bracket = narrowed(bracket, R, x)
    return R


@kernel
def _gauss(b, watch, p_0, a, c):
    """Integrate with five Gauss points between the cone distances a and c."""
    half = 0.5 * (c - a)
    f = 0.0
    for k in range(5):
        R = a + half * (1.0 + _PLACES[k])
        if b["source"] == PHASE:
            f += _total_node(b, watch, R, half * _WEIGHTS[k])
        else:
            f += pair_node(b, watch, p_0, R, half * _WEIGHTS[k])
    return f


@kernel
def _piece(b, watch, p_0, a, c):
    """Integrate the part of a smooth piece on which the flanks are in contact."""
    x_a = _depth(b, p_0, a)
    x_c = _depth(b, p_0, c)
    if (x_a > 0.0) == (x_c > 0.0):
        return _gauss(b, watch, p_0, a, c)
    edge = _edge(b, p_0, a, c, x_a, x_c)
    if x_a > 0.0:
        return _gauss(b, watch, p_0, a, edge)
    return _gauss(b, watch, p_0, edge, c)


@kernel
def _crossing(b, p_0, p):
    """Cone distance at which a contact line is at the path position p."""
    return b["R_m"] * math.exp((p - p_0) / b["now"]["lam"])


@kernel
def _end(b, p_0, p, leaves):
    """Add the parametric power at the end of a contact line without ramp, at the path position p.

    `leaves` is the rate at which the contact line passes that end [base pitches/s].
    """
    now = b["now"]
    R = _crossing(b, p_0, p)
    if R <= b["R_m"] + now["lo"] or R >= b["R_m"] + now["hi"]:
        return
    x = _depth(b, p_0, R)
    if x > 0.0 and b["S_R"] > 0.0:
        energy = flank_energy(b["contact"], x, x, b["c_prime"] * b["S_R"], b["load_limit"], None)[0]
        b["sums"]["parametric_power"] += energy * leaves * R / abs(now["lam"])


@kernel
def _pair(b, watch, p_0):
    """Integrate over one contact line, split at its kinks."""
    now = b["now"]
    R = b["R_m"] + now["lo"]
    end = b["R_m"] + now["hi"]
    eps = now["eps"]
    lam = now["lam"]
    if R >= end:
        return 0.0
    if lam == 0.0:
        return _piece(b, watch, p_0, R, end) if p_0 >= 0.0 and p_0 <= eps else 0.0
    if watch is not None and now["L"] == 0.0:
        rate = now["phase_rate"][0 if now["flank"] > 0 else 1]
        _end(b, p_0, 0.0, rate)
        _end(b, p_0, eps, now["eps_rate"] - rate)
    L = min(now["L"], 0.5 * eps)
    to_A = _crossing(b, p_0, 0.0)
    to_E = _crossing(b, p_0, eps)
    R = max(R, min(to_A, to_E))
    end = min(end, max(to_A, to_E))
    f = 0.0
    while R < end:
        stop = end
        for k in range(3):
            at = _crossing(b, p_0, L if k == 0 else eps - L if k == 1 else -now["xi_A"] / b["p_bt"])
            if at > R and at < stop:
                stop = at
        f += _piece(b, watch, p_0, R, stop)
        R = stop
    return f


@kernel
def _nominal(b):
    """Set the full common face and no tooth deviations."""
    now = b["now"]
    now["lo"] = b["z_lo"]
    now["hi"] = b["z_hi"]
    now["lacks"] = 0.0


@kernel
def _own(b, q):
    """Apply the deviations of the two teeth of pair q: of gear 1, and of gear 2 before or after its space.

    A pitch deviation is leading on one flank and lagging on the other."""
    now = b["now"]
    flank = now["flank"]
    pair = flank * (int(q) - now["tooth"])
    for gear in range(2):
        n = b["n_t"][gear]
        if n == 0:
            continue
        first = b["t1_0"] + pair if gear == 0 else b["t2_0"] - pair + (1 if flank < 0 else 0)
        table = view(b["pool"] + 8 * b["teeth"][gear], (n, N_OWN), F8)
        tooth = first % n
        now["lo"] = max(now["lo"], table[tooth, 0])
        now["hi"] = min(now["hi"], table[tooth, 1])
        now["lacks"] -= flank * table[tooth, 2]


@kernel
def first_and_last(b):
    """Numbers of the first and the last pair whose contact line may cross the common face."""
    now = b["now"]
    inner = _line_at(b, now["psi"], b["R_m"] + b["z_lo"])
    outer = _line_at(b, now["psi"], b["R_m"] + b["z_hi"])
    return float(math.ceil(-max(inner, outer))), math.floor(now["eps"] - min(inner, outer))


@kernel
def sum_pair(b, watch, q):
    """Sum over the contact line of the pair q, with the deviations of its teeth."""
    _nominal(b)
    if b["n_sep"] > 0:
        _own(b, q)
    return _pair(b, watch, b["now"]["psi"] + q)


@kernel
def sum_flank(b, watch):
    """All pairs of the current flank, or its constant total stiffness."""
    now = b["now"]
    if b["source"] == PHASE:
        _nominal(b)
        _piece(b, watch, 0.0, b["R_m"] + b["z_lo"], b["R_m"] + b["z_hi"])
        return
    q, last = first_and_last(b)
    while q <= last:
        f = sum_pair(b, watch, q)
        if watch is not None and b["request"]["out"] != 0 and b["n_pair"] > 0:
            add_pair_force(b, N_OUT, (now["tooth"] - int(q)) % b["n_pair"], now["flank"] * f)
        q += 1.0
