# SPDX-License-Identifier: Apache-2.0
"""Forces of one flank of a bevel mesh: the law of a node, and where the nodes lie.

Along a contact line the path position is p = p_0 + lam ln(R/R_m) base pitches, so straight teeth touch along
rays. Five Gauss points on every piece between kinks (start and end of contact, ends of the ramps, where the
flanks part, the pitch ray where sliding turns) integrate force, couples and tangents. Slices of a pair at
different R are alike but for their size: its stiffness per face width is the same all along.

Where nothing is observed, `watch` is None, and what only observations need is left out when compiled.
"""

from __future__ import annotations

import math

from pitchpoint.contact.damping import linear_ramp, ramp
from pitchpoint.contact.elastic import low_load, stored_energy
from pitchpoint.contact.friction import static_dynamic
from pitchpoint.contact.pair_shape import pair_shape, pair_shape_rate
from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.bevel_mesh_record import N_OUT, N_OWN, PHASE, ROWS
from pitchpoint.multibody.channels import F8

#: Fields of `more`; FORCE adds the base-tangent forces of nodes, NEAREST is the largest force over stiffness.
STIFFNESS, FRICTION, DAMPING, PARAMETRIC, ENERGY, FORCE, NEAREST = range(7)
N_MORE = 7

_PLACES = (-0.906179845938664, -0.5384693101056831, 0.0, 0.5384693101056831, 0.906179845938664)
_WEIGHTS = (
    0.2369268850561891,
    0.4786286704993665,
    0.5688888888888889,
    0.4786286704993665,
    0.2369268850561891,
)
_TRIES = 60
"""Most steps of the search for the edge of contact; some five are taken."""

_NOWHERE = -0.1
"""Distance from contact [m] of a flank where no pair of teeth is."""


@kernel
def begin_sums(b):
    """Empty sums."""
    for p in range(ROWS):
        b["acc"][p] = 0.0
        for q in range(ROWS):
            b["T"][p, q] = 0.0
    for k in range(N_MORE):
        b["more"][k] = 0.0
    b["more"][NEAREST] = _NOWHERE


@kernel
def _across(b, values):
    """A quantity of the normal rows at the node."""
    lever = b["lever"]
    return values[0] * lever[0] + values[1] * lever[1] + values[2] * lever[2]


@kernel
def _stand(b, R, sigma):
    """Levers of a node; gives its penetration along the base tangent [m]."""
    lever = b["lever"]
    c = math.cos(sigma)
    s = math.sin(sigma)
    lever[0] = c
    lever[1] = s
    lever[2] = R
    lever[3] = 1.0
    lever[4] = R * c
    lever[5] = R * s
    return _across(b, b["x"]) - b["lacks"] * R / b["R_m"]


@kernel
def _damping(b, x, k, f):
    """Damping of a node [N s/m] with the elastic force f, and its derivative by the penetration."""
    if b["chi"] > 0.0:
        return b["chi"] * f, b["chi"] * k
    d = (b["d_in"] if _across(b, b["w"]) > 0.0 else b["d_out"]) * k / b["k_ref"]
    if d == 0.0:
        return 0.0, 0.0
    share, slope = ramp(x, b["s_0"]) if b["smooth"] == 1 else linear_ramp(x, b["s_0"])
    return d * share, d * slope


@kernel
def _node(b, ctl, watch, x, k, limit, feed):
    """Add one node whose levers stand; returns its force along the base tangent [N].

    `x` penetration [m], `k` stiffness [N/m], `limit` force below which it softens [N]; `feed` rates of the
    stiffness and of the penetration where no force pushes.
    """
    more = b["more"]
    if x <= 0.0 or k <= 0.0:
        if watch is not None and k > 0.0:
            more[NEAREST] = max(more[NEAREST], x)
        return 0.0
    rate = _across(b, b["w"])
    elastic = k * x
    slope = k
    if limit > 0.0:
        less, softer = low_load(elastic, limit)
        elastic *= less
        slope *= softer
    d, bent = _damping(b, x, slope if b["chi"] > 0.0 else k, elastic)
    total = elastic + d * rate
    # a flank that would have to pull lets go, and the work of its elastic force is lost
    f = max(total, 0.0)
    if watch is not None:
        energy, by_k = stored_energy(x, k, 1.0, limit)
        size = b["lever"][2] / b["R_m"]
        more[NEAREST] = max(more[NEAREST], total / k)
        more[PARAMETRIC] += by_k * feed[0] + elastic * feed[1]
        more[DAMPING] += (f - elastic) * rate
        more[ENERGY] += energy
        more[FORCE] += f
        if f > 0.0:
            more[STIFFNESS] += slope * size * size
    if f > 0.0:
        _add(b, ctl, watch, f, ctl["ck"] * (slope + bent * rate) + ctl["cd"] * d)
    return f


@kernel
def _add(b, ctl, watch, f, c):
    """Add force and tangent c of a node, and its friction against the local sliding."""
    lever = b["lever"]
    acc = b["acc"]
    T = b["T"]
    jac = ctl["jac"] != 0
    for p in range(3):
        acc[p] += f * lever[p]
        if jac:
            for q in range(3):
                T[p, q] += c * lever[p] * lever[q]
    if b["mu"] == 0.0:
        return
    v = b["w"][3] * lever[3] + b["w"][4] * lever[4] + b["w"][5] * lever[5]
    s, ds = static_dynamic(v, b["mu_s"], b["mu"], b["v_s"], b["v_eps"])
    per = math.sqrt(1.0 + b["tan_b"] * b["tan_b"])  # per force normal to the flanks
    if watch is not None:
        b["more"][FRICTION] += per * s * f * v
    for p in range(3, 6):
        acc[p] += per * s * f * lever[p]
        if jac:
            for q in range(3):
                T[p, q] += per * s * c * lever[p] * lever[q]
            for q in range(3, 6):
                T[p, q] += per * f * ds * ctl["cd"] * lever[p] * lever[q]


@kernel
def _ray(b, p):
    """Angle of the ray at the path position p from the pitch ray [rad]."""
    return (b["xi_A"] + p * b["p_bt"]) / b["R_m"]


@kernel
def _line_at(b, p_0, R):
    """Path position of a contact line at the cone distance R; along straight teeth always the same."""
    if b["lam"] == 0.0:
        return p_0
    return p_0 + b["lam"] * math.log(R / b["R_m"])


@kernel
def _aside(b, sigma, p_rate):
    """Rate of the penetration of a place that the contact line runs over at p_rate base pitches/s."""
    rate = (b["xi_A_rate"] + p_rate * b["p_bt"]) / b["R_m"]
    return rate * (b["x"][1] * math.cos(sigma) - b["x"][0] * math.sin(sigma))


@kernel
def _pair_node(b, ctl, watch, p_0, R, weight):
    """One node of the pair whose contact line is at p_0 at R_m, with its share of the face width [m]."""
    p = _line_at(b, p_0, R)
    sigma = _ray(b, p)
    x = _stand(b, R, sigma)
    scale = b["c_prime"] * weight
    k_rate = 0.0
    x_rate = 0.0
    if watch is not None:
        p_rate = b["phase_rate"][0 if b["flank"] > 0 else 1]
        wider = b["T_R"] * b["eps_rate"]
        k_rate = scale * pair_shape_rate(p, p_rate, b["eps"], b["eps_rate"], b["S_R"], b["L"], wider)
        x_rate = _aside(b, sigma, p_rate)
    k = scale * pair_shape(p, b["eps"], b["S_R"], b["L"])
    return _node(b, ctl, watch, x, k, b["load_limit"] * weight, (k_rate, x_rate))


@kernel
def _total_node(b, ctl, watch, R, weight):
    """One node of a constant total stiffness, which acts along the pitch ray."""
    x = _stand(b, R, 0.0)
    return _node(b, ctl, watch, x, b["c_prime"] * b["spread"] * weight, 0.0, (0.0, 0.0))


@kernel
def _depth(b, p_0, R):
    """Penetration along the base tangent of a contact line at R [m]."""
    return _stand(b, R, 0.0 if b["source"] == PHASE else _ray(b, _line_at(b, p_0, R)))


@kernel
def _edge(b, p_0, a, c, x_a, x_c):
    """Where between a and c, at which it has different signs, the penetration is zero (Illinois)."""
    R = c
    least = 1e-15 * (abs(x_a) + abs(x_c))
    for _ in range(_TRIES):
        R = (a * x_c - c * x_a) / (x_c - x_a)
        x = _depth(b, p_0, R)
        if abs(x) <= least:
            break
        if (x > 0.0) == (x_c > 0.0):
            c = R
            x_c = x
            x_a *= 0.5
        else:
            a = c
            x_a = x_c
            c = R
            x_c = x
    return R


@kernel
def _gauss(b, ctl, watch, p_0, a, c):
    """Five Gauss points between the cone distances a and c."""
    half = 0.5 * (c - a)
    f = 0.0
    for k in range(5):
        R = a + half * (1.0 + _PLACES[k])
        if b["source"] == PHASE:
            f += _total_node(b, ctl, watch, R, half * _WEIGHTS[k])
        else:
            f += _pair_node(b, ctl, watch, p_0, R, half * _WEIGHTS[k])
    return f


@kernel
def _piece(b, ctl, watch, p_0, a, c):
    """The part of a smooth piece on which the flanks touch."""
    x_a = _depth(b, p_0, a)
    x_c = _depth(b, p_0, c)
    if (x_a > 0.0) == (x_c > 0.0):
        return _gauss(b, ctl, watch, p_0, a, c)
    edge = _edge(b, p_0, a, c, x_a, x_c)
    if x_a > 0.0:
        return _gauss(b, ctl, watch, p_0, a, edge)
    return _gauss(b, ctl, watch, p_0, edge, c)


@kernel
def _crossing(b, p_0, p):
    """Cone distance at which a contact line is at the path position p."""
    return b["R_m"] * math.exp((p - p_0) / b["lam"])


@kernel
def _end(b, p_0, p, leaves):
    """What the end of a contact line without ramp takes along, at the path position p: parametric power.

    `leaves` is the rate at which the contact line passes that end [base pitches/s].
    """
    R = _crossing(b, p_0, p)
    if R <= b["R_m"] + b["lo"] or R >= b["R_m"] + b["hi"]:
        return
    x = _depth(b, p_0, R)
    if x > 0.0 and b["S_R"] > 0.0:
        energy = stored_energy(x, b["c_prime"] * b["S_R"], 1.0, b["load_limit"])[0]
        b["more"][PARAMETRIC] += energy * leaves * R / abs(b["lam"])


@kernel
def _pair(b, ctl, watch, p_0):
    """Sum over one contact line, split at its kinks."""
    R = b["R_m"] + b["lo"]
    end = b["R_m"] + b["hi"]
    eps = b["eps"]
    lam = b["lam"]
    if R >= end:
        return 0.0
    if lam == 0.0:
        return _piece(b, ctl, watch, p_0, R, end) if p_0 >= 0.0 and p_0 <= eps else 0.0
    if watch is not None and b["L"] == 0.0:
        rate = b["phase_rate"][0 if b["flank"] > 0 else 1]
        _end(b, p_0, 0.0, rate)
        _end(b, p_0, eps, b["eps_rate"] - rate)
    L = min(b["L"], 0.5 * eps)
    to_A = _crossing(b, p_0, 0.0)
    to_E = _crossing(b, p_0, eps)
    R = max(R, min(to_A, to_E))
    end = min(end, max(to_A, to_E))
    f = 0.0
    while R < end:
        stop = end
        for k in range(3):
            at = _crossing(b, p_0, L if k == 0 else eps - L if k == 1 else -b["xi_A"] / b["p_bt"])
            if at > R and at < stop:
                stop = at
        f += _piece(b, ctl, watch, p_0, R, stop)
        R = stop
    return f


@kernel
def _nominal(b):
    """The whole shared face, teeth in their places."""
    b["lo"] = b["z_lo"]
    b["hi"] = b["z_hi"]
    b["lacks"] = 0.0


@kernel
def _own(b, q):
    """What the two teeth of the pair q have of their own: the tooth of gear 1 and that before or behind the
    space of gear 2. Displaced teeth stand before their place on one flank and behind it on the other."""
    flank = b["flank"]
    pair = flank * (int(q) - b["tooth"])
    for gear in range(2):
        n = b["n_t"][gear]
        if n == 0:
            continue
        first = b["t1_0"] + pair if gear == 0 else b["t2_0"] - pair + (1 if flank < 0 else 0)
        table = view(b["pool"] + 8 * b["teeth"][gear], (n, N_OWN), F8)
        tooth = first % n
        b["lo"] = max(b["lo"], table[tooth, 0])
        b["hi"] = min(b["hi"], table[tooth, 1])
        b["lacks"] -= flank * table[tooth, 2]


@kernel
def sum_flank(b, ctl, watch):
    """All pairs of the current flank, or its constant total stiffness."""
    _nominal(b)
    if b["source"] == PHASE:
        _piece(b, ctl, watch, 0.0, b["R_m"] + b["z_lo"], b["R_m"] + b["z_hi"])
        return
    first = _line_at(b, b["psi"], b["R_m"] + b["z_lo"])
    last = _line_at(b, b["psi"], b["R_m"] + b["z_hi"])
    q = float(math.ceil(-max(first, last)))
    stop = math.floor(b["eps"] - min(first, last))
    while q <= stop:
        if b["n_sep"] > 0:
            _nominal(b)
            _own(b, q)
        f = _pair(b, ctl, watch, b["psi"] + q)
        if watch is not None and ctl["out"] != 0 and b["n_pair"] > 0:
            slot = (b["tooth"] - int(q)) % b["n_pair"]
            view(ctl["out"], ctl["no"], F8)[b["out"] + N_OUT + slot] += b["flank"] * f
        q += 1.0
