# SPDX-License-Identifier: Apache-2.0
"""Flank contact law at one contact node: penetration to force and tangents.

Scalars in, scalars out. Cylindrical and bevel meshes, and every other element with contacting flanks, call
the law for each contact node and add up the results.

The elastic force is k x^power, with reduced stiffness at low load and an optional compliance in series.
Damping is proportional to the rate of the overlap; its coefficient increases from first contact to the
penetration s_0, or is proportional to the elastic force (impact damping with a coefficient of restitution).
The force is never negative (no adhesion). Friction opposes the local sliding and is regularised around zero.

Forces, penetrations and rates are along the base tangent.

Source: Mauer, SIMPACK User Meeting (2006), for stiffness, damping and friction of a gear pair; softening
ISO 6336-1.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.contact.damping import linear_ramp, ramp
from pitchpoint.contact.elastic import low_load, power_force, series_energy, series_overlap, stored_energy
from pitchpoint.contact.friction import static_dynamic
from pitchpoint.core.kernel import kernel

#: Parameters of the law, one record per mesh.
FLANK_LAW = np.dtype(
    [
        ("power", "f8"),  # exponent of the elastic force over the overlap; 1 is linear
        ("k_ref", "f8"),  # mean mesh stiffness; damping of a node: d k/k_ref [N/m^power]
        ("d_in", "f8"),
        ("d_out", "f8"),  # contact damping at k_ref for approach and separation [N s/m]
        ("s_0", "f8"),  # penetration of full damping [m]
        ("smooth", "i8"),  # ramp of the damping up to s_0: 0 linear, 1 cubic
        ("chi", "f8"),  # instead of d: damping force over elastic force and approach speed [s/m], 0: off
        ("mu", "f8"),
        (
            "v_eps",
            "f8",
        ),  # dynamic coefficient of friction and the sliding velocity at which it is reached [m/s]
        ("mu_s", "f8"),
        ("v_s", "f8"),  # static coefficient and its sliding velocity, 0 < v_s < v_eps [m/s]
        ("normal", "f8"),  # force normal to the flanks over that along the base tangent, 1/cos(beta_b)
    ],
    align=True,
)


@kernel(inline=True)
def flank_force(law, x, k, limit, w, soft):
    """Force of overlapping flanks at one contact node, and its derivatives.

    Parameters
    ----------
    law
        Record of `FLANK_LAW`.
    x
        Penetration, > 0 [m].
    k
        Stiffness of the node, > 0 [N/m^power].
    limit
        Force below which a linear contact softens [N]; 0: no softening.
    w
        Rate of the penetration [m/s].
    soft
        Compliance in series with the contact [m/N], or None. Damping then acts on the overlap of the contact
        and its rate only.

    Returns
    -------
    tuple
        Force [N], >= 0; its derivatives by x and by w, not set to zero where the force is limited to 0;
        elastic force [N] and its derivative by x; overlap of the contact [m]; force over secant stiffness,
        the distance to contact loss [m].

    Examples
    --------
    >>> law = np.zeros(1, FLANK_LAW)[0]
    >>> law["power"], law["k_ref"], law["d_in"], law["s_0"] = 1.0, 4e8, 2e3, 1e-6
    >>> found = flank_force(law, 5e-6, 4e8, 0.0, 0.1, None)  # 2000 N elastic, 200 N damping
    >>> [round(float(value), 9) for value in found]
    [2200.0, 400000000.0, 2000.0, 2000.0, 400000000.0, 5e-06, 5.5e-06]
    """
    u = x
    own = 1.0  # du/dx; `bent` is its derivative by x
    bent = 0.0
    if soft is not None and soft > 0.0:
        u = series_overlap(x, k, law["power"], soft)
    f, by_x = power_force(u, k, law["power"])
    if soft is not None and soft > 0.0:
        own = 1.0 / (1.0 + soft * by_x)
        bent = (1.0 - law["power"]) * by_x / u * soft * own * own * own
        by_x *= own
    secant = f / x
    if limit > 0.0:
        force, tangent = low_load(f, limit)
        f *= force
        by_x *= tangent
    elastic = f
    stiffness = by_x
    part = k / law["k_ref"]  # a division that need not wait for the rate
    d = (law["d_in"] if w > 0.0 else law["d_out"]) * part
    if law["chi"] > 0.0:
        d = law["chi"] * f
        f += d * w * own
        by_x *= 1.0 + law["chi"] * w * own
    elif d > 0.0:
        share, slope = ramp(u, law["s_0"]) if law["smooth"] == 1 else linear_ramp(u, law["s_0"])
        full = d
        d *= share
        f += d * w * own
        by_x += full * w * slope * own * own
    if soft is not None:
        by_x += d * w * bent
        d *= own
    # no adhesion: flanks separate instead of pulling, and the remaining elastic energy is dissipated
    return max(f, 0.0), by_x, d, elastic, stiffness, u, f / secant


@kernel
def node_damping(law, f, k, w):
    """Damping of a node whose elastic force follows from a system of nodes.

    Parameters
    ----------
    law
        Record of `FLANK_LAW`.
    f
        Elastic force, > 0 [N].
    k
        Typical stiffness of the node [N/m]; its overlap counts as f/k.
    w
        Rate of the penetration [m/s].

    Returns
    -------
    tuple
        Damping force [N]; its derivatives by the elastic force and by w.

    Examples
    --------
    >>> law = np.zeros(1, FLANK_LAW)[0]
    >>> law["k_ref"], law["d_in"], law["s_0"] = 4e8, 2e3, 1e-6
    >>> [float(value) for value in node_damping(law, 2000.0, 4e8, 0.1)]
    [200.0, 0.0, 2000.0]
    """
    if law["chi"] > 0.0:
        return law["chi"] * f * w, law["chi"] * w, law["chi"] * f
    full = (law["d_in"] if w > 0.0 else law["d_out"]) * k / law["k_ref"]
    if full == 0.0:
        return 0.0, 0.0, 0.0
    share, slope = ramp(f / k, law["s_0"]) if law["smooth"] == 1 else linear_ramp(f / k, law["s_0"])
    return full * share * w, full * slope * w / k, full * share


@kernel
def flank_energy(law, x, u, k, limit, soft):
    """Energy stored at a contact node, and its derivatives by the stiffness and by the series compliance.

    Parameters
    ----------
    law, x
        As in `flank_force`.
    u
        Overlap of the contact returned by `flank_force` [m].
    k, limit, soft
        As in `flank_force`.

    Returns
    -------
    tuple
        Energy [J]; its derivatives at constant x by k and by `soft` (0 if `soft` is None).

    Examples
    --------
    >>> law = np.zeros(1, FLANK_LAW)[0]
    >>> law["power"] = 1.0
    >>> [float(value) for value in flank_energy(law, 2.0, 2.0, 3.0, 0.0, None)]
    [6.0, 2.0, 0.0]
    """
    if soft is not None:
        return series_energy(x, u, k, law["power"], soft, limit)
    energy, by_k = stored_energy(x, k, law["power"], limit)
    return energy, by_k, 0.0


@kernel
def flank_friction(law, f, v):
    """Friction force at a contact node with base-tangent force f [N] and sliding velocity v [m/s].

    Parameters
    ----------
    law
        Record of `FLANK_LAW`.
    f
        Force along the base tangent [N].
    v
        Sliding velocity [m/s].

    Returns
    -------
    tuple
        Friction force [N], which opposes the sliding, with the sign of v; its derivatives by f and by v.

    Examples
    --------
    >>> law = np.zeros(1, FLANK_LAW)[0]
    >>> law["mu"], law["v_eps"], law["mu_s"], law["v_s"], law["normal"] = 0.08, 0.02, 0.08, 0.01, 1.0
    >>> [float(value) for value in flank_friction(law, 1000.0, -1.0)]
    [-80.0, -0.08, 0.0]
    """
    s, slope = static_dynamic(v, law["mu_s"], law["mu"], law["v_s"], law["v_eps"])
    by_f = law["normal"] * s
    return by_f * f, by_f, law["normal"] * f * slope
