# SPDX-License-Identifier: Apache-2.0
"""Normal contact force over penetration and penetration rate: impact function, Hunt-Crossley, hysteresis.

All laws start from the elastic force K delta^n; the force is never negative (no adhesion).

* IMPACT: K delta^n + C step(delta; 0, 0, d, 1) delta', the impact function of multibody codes.
* HUNT_CROSSLEY: K delta^n (1 + x delta'/v). With the factor x(e) of `restitution_factor` the coefficient of
  restitution is e at the impact speed v, independent of K, the exponent and the mass. It decreases with the
  impact speed, as in experiments.
* HYSTERESIS: K delta^n during compression, e^2 K delta^n during restitution, with a smooth transition between
  both at speeds up to v. The coefficient of restitution is e at all impact speeds well above v.

The laws of Lankarani and Nikravesh (1990) and Flores et al. (2011) need the speed at first contact as a
memory state. Their factors 3 (1 - e^2)/4 and 8 (1 - e)/(5 e) approximate x(e): for e = 0.5 the restitution
is 0.725 and 0.470.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.contact.damping import ramp
from pitchpoint.contact.elastic import power_energy, power_force
from pitchpoint.core.kernel import kernel

IMPACT, HUNT_CROSSLEY, HYSTERESIS = 0, 1, 2

#: Record fields of a contact with one of these laws and the friction of `friction.static_dynamic`.
CONTACT_LAW: list[tuple[Any, ...]] = [
    ("law", "i8"),  # IMPACT, HUNT_CROSSLEY or HYSTERESIS
    ("k", "f8"),  # K [N/m^n]; of triangle surfaces per area [N/m^(n+2)]
    ("power", "f8"),  # exponent n of the elastic force, >= 1
    ("c", "f8"),  # IMPACT: C [N s/m], of triangle surfaces per area
    ("ramp", "f8"),  # IMPACT: penetration of full damping [m]
    ("x", "f8"),  # HUNT_CROSSLEY: x/v [s/m]; HYSTERESIS: force ratio e^2 during restitution
    ("v", "f8"),  # HYSTERESIS: transition speed [m/s]
    ("mu_s", "f8"),  # static coefficient of friction
    ("mu_d", "f8"),  # dynamic coefficient of friction
    ("v_s", "f8"),  # velocity of the static coefficient [m/s]
    ("v_d", "f8"),  # velocity above which the dynamic coefficient applies [m/s]
]


def _balance(x: float, e: float) -> float:
    """Residual of the equation for x(e); zero if a contact of factor x has the restitution e."""
    return math.log1p(x) - math.log1p(-e * x) - x * (1.0 + e)


def restitution_factor(e: float) -> float:
    """Factor x of the force K delta^n (1 + x delta'/v) that gives a coefficient of restitution e at speed v.

    Parameters
    ----------
    e
        Coefficient of restitution, in (0, 1].

    Raises
    ------
    ValueError
        If e is not in (0, 1].

    Notes
    -----
    m delta'' = -K delta^n (1 + a delta') separates into delta' d(delta')/(1 + a delta') and a function of
    delta; between v and -e v, x = a v obeys x (1 + e) = ln((1 + x)/(1 - e x)), exactly for all masses and
    exponents. Y. Gonthier et al., Multibody Syst. Dyn. 11 (2004) 209-233; A. S. Carvalho and J. M. Martins,
    Mech. Mach. Theory 139 (2019) 174-194. Near e = 1 it is the 3 (1 - e)/2 of K. H. Hunt and F. R. E.
    Crossley, J. Appl. Mech. 42 (1975) 440-445.

    Examples
    --------
    >>> round(restitution_factor(0.5), 6)
    1.432751
    """
    if not 0.0 < e <= 1.0:
        raise ValueError("the coefficient of restitution must be in (0, 1]")
    if 1.0 - e < 1e-4:  # series, accurate to (1 - e)^2; the logarithms cancel there
        return 1.5 * (1.0 - e * e) / (1.0 + e**3)
    low, high = 0.5 * (1.0 - e), 1.0 / e
    for _ in range(200):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        if 1.0 - e * middle > 0.0 and _balance(middle, e) < 0.0:
            low = middle
        else:
            high = middle
    return low


def set_impact(record: np.void, k: float, power: float = 1.5, c: float = 0.0, ramp: float = 0.0) -> None:
    """Set the impact function as the law of a contact.

    Parameters
    ----------
    record
        Record with the fields `CONTACT_LAW`.
    k, power
        K [N/m^power] and exponent >= 1 of the elastic force.
    c, ramp
        Damping C [N s/m] and the penetration d at which it reaches its full value [m].

    Examples
    --------
    >>> record = np.zeros((), np.dtype(CONTACT_LAW))
    >>> set_impact(record, 1e9, 1.5, 1e6, 1e-4)
    >>> force = normal_force(record[()], 1e-4, 0.0)
    >>> round(float(force[0]), 6)
    1000.0
    """
    record["law"], record["k"], record["power"], record["c"], record["ramp"] = IMPACT, k, power, c, ramp


def set_restitution(
    record: np.void, k: float, e: float, speed: float, power: float = 1.5, every_speed: bool = False
) -> None:
    """Set a law with a given coefficient of restitution.

    Parameters
    ----------
    record
        Record with the fields `CONTACT_LAW`.
    k
        K [N/m^power] of the elastic force.
    e
        Coefficient of restitution, in (0, 1].
    speed
        Impact speed at which e applies [m/s]; with `every_speed` the speed range around zero within which
        the force changes from compression to restitution.
    power
        Exponent >= 1 of the elastic force.
    every_speed
        Hysteresis instead of Hunt-Crossley: e at all speeds well above `speed`.

    Raises
    ------
    ValueError
        If e is not in (0, 1] or the speed is not above 0.

    Examples
    --------
    >>> record = np.zeros((), np.dtype(CONTACT_LAW))
    >>> set_restitution(record, 1e9, 0.5, 1.0)
    >>> round(float(record["x"]), 6)
    1.432751
    """
    if not speed > 0.0:
        raise ValueError("the reference speed of the coefficient of restitution must be positive")
    record["k"], record["power"], record["v"] = k, power, speed
    if every_speed:
        restitution_factor(e)  # checks the range
        record["law"], record["x"] = HYSTERESIS, e * e
    else:
        record["law"], record["x"] = HUNT_CROSSLEY, restitution_factor(e) / speed


def set_friction(record: np.void, mu_s: float, mu_d: float, v_s: float, v_d: float) -> None:
    """Set static and dynamic friction of a contact.

    Parameters
    ----------
    record
        Record with the fields `CONTACT_LAW`.
    mu_s, mu_d
        Static and dynamic coefficient.
    v_s, v_d
        Sliding velocity of the static coefficient and of full slip [m/s], 0 < v_s < v_d.

    Raises
    ------
    ValueError
        If a coefficient is negative, or the velocities are not 0 < v_s < v_d.

    Examples
    --------
    >>> record = np.zeros((), np.dtype(CONTACT_LAW))
    >>> set_friction(record, 0.1, 0.08, 1e-3, 10e-3)
    >>> float(record["mu_s"])
    0.1
    """
    if min(mu_s, mu_d) < 0.0 or (max(mu_s, mu_d) > 0.0 and not 0.0 < v_s < v_d):
        raise ValueError("friction requires coefficients >= 0 and velocities 0 < v_s < v_d")
    record["mu_s"], record["mu_d"], record["v_s"], record["v_d"] = mu_s, mu_d, v_s, v_d


@kernel
def elastic_force(b, delta):
    """Elastic force K delta^n and its derivative by delta, for delta > 0.

    >>> record = np.zeros((), np.dtype(CONTACT_LAW))
    >>> set_impact(record, 1e9, 1.5)
    >>> tuple(round(float(x), 6) for x in elastic_force(record[()], 1e-4))
    (1000.0, 15000000.0)
    """
    return power_force(delta, b["k"], b["power"])


@kernel
def elastic_energy(b, delta):
    """Elastic energy at a penetration > 0, K delta^(n + 1)/(n + 1) [J].

    >>> record = np.zeros((), np.dtype(CONTACT_LAW))
    >>> set_impact(record, 1e9, 1.5)
    >>> round(float(elastic_energy(record[()], 1e-4)), 9)
    0.04
    """
    return power_energy(delta, b["k"], b["power"])


@kernel
def normal_force(b, delta, rate):
    """Normal force [N] at a penetration [m] and its rate [m/s], derivatives by both, dissipated power [W].

    The dissipated power is the power into the contact that is not stored as elastic energy.

    >>> record = np.zeros((), np.dtype(CONTACT_LAW))
    >>> set_impact(record, 1e9, 1.5, 1e6, 1e-4)
    >>> tuple(round(float(x), 6) for x in normal_force(record[()], 0.5e-4, 1e-3))
    (853.553391, 25606601.717798, 500000.0, 0.5)
    """
    if delta <= 0.0:
        return 0.0, 0.0, 0.0, 0.0
    elastic, stiffness = elastic_force(b, delta)
    force = elastic
    by_delta = stiffness
    by_rate = 0.0
    if b["law"] == IMPACT:
        share, slope = ramp(delta, b["ramp"])
        force += b["c"] * share * rate
        by_delta += b["c"] * slope * rate
        by_rate = b["c"] * share
    elif b["law"] == HUNT_CROSSLEY:
        factor = 1.0 + b["x"] * rate
        force *= factor
        by_delta *= factor
        by_rate = b["x"] * elastic
    else:
        share, slope = ramp(-rate, b["v"])
        factor = 1.0 - (1.0 - b["x"]) * share
        force *= factor
        by_delta *= factor
        by_rate = (1.0 - b["x"]) * slope * elastic
    if force <= 0.0:
        return 0.0, 0.0, 0.0, -elastic * rate
    return force, by_delta, by_rate, (force - elastic) * rate
