# SPDX-License-Identifier: Apache-2.0
"""Problems and warnings of cylindrical gears and pairs, each with key, value, limit and remedy.

Source: ISO 21771. Derivation: docs/theory/geometry.md, "A pair".
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.geometry.bisection import bisect
from pitchpoint.geometry.involute import inv
from pitchpoint.geometry.meshing_problems import (
    INTERFERENCE_TOLERANCE,
    Words,
    interferences,
    odd_contact,
    problems_of_pair,
    tips_in_roots,
    unequal,
    wrong_hands,
)
from pitchpoint.geometry.tip_edge import large_edge, sharp
from pitchpoint.geometry.tooth_problems import (
    TIP_THICKNESS_LIMIT,
    Found,
    at_key,
    full_rounding,
    problems_of_gear,
    thin_tip,
)
from pitchpoint.geometry.tooth_thickness import tip_thickness

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.geometry.gear_pair import GearPair

_ANGLE_TOLERANCE = 1e-6


def _mm(length: float) -> str:
    return f"{1e3 * abs(length):.4f} mm"


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):g} deg"


def _largest_shift(gear: CylindricalGear) -> str:
    """Remedy for a thin tip: the largest profile shift with sufficient tip thickness, if there is one."""
    if gear.tip_diameter is not None:
        return "reduce tip_diameter" if not gear.is_internal else "increase tip_diameter"
    limit, low = TIP_THICKNESS_LIMIT * gear.m_n, gear.x - 0.05

    def spare(x: float) -> float:
        """Tip thickness above the limit at the profile shift coefficient x [m]."""
        return tip_thickness(gear.replace(x=x)) - limit

    try:
        while spare(low) < 0.0:
            low -= 0.05
        low = bisect(spare, low, low + 0.05)
    except GeometryError:
        return "reduce the profile shift or set tip_diameter"
    return f"use at most {math.floor(100.0 * low) / 100.0:.2f} or set tip_diameter"


def gear_problems(gear: CylindricalGear, where: str = "") -> list[Message]:
    """Everything that makes one gear impossible.

    Parameters
    ----------
    gear
        The gear.
    where
        Path of the gear in the model, prefix of the key in each message.

    Returns
    -------
    list of Message
        Empty for a possible gear.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> problem = gear_problems(CylindricalGear(z=20, m_n=0.003, x=1.4), "gears.pinion")[0]
    >>> problem.where, problem.limit, problem.remedy
    ('gears.pinion.profile_shift_coefficient', 'usually 0.2 m_n', 'use at most 0.94 or set tip_diameter')
    """
    found = []
    deepest = 0.25 * math.pi / math.tan(gear.alpha_n)
    if gear.rack.rho_fP_star_max(gear.alpha_n) < 0.0 and not gear.is_internal:
        message, value = "modules end beyond the point of the tool", f"{gear.rack.h_fP_star:g}"
        place = at_key(where, "rack.dedendum")
        found.append(Message(place, message, value, f"{deepest:.4g}", "use a smaller dedendum"))
    plain = sharp(gear)
    return found + problems_of_gear(
        where,
        lambda: _no_tooth(plain),
        lambda: _thin_tip(plain) if tip_thickness(plain) <= 0.0 else None,
        lambda: large_edge(gear),
    )


def gear_warnings(gear: CylindricalGear, where: str = "") -> list[Message]:
    """Unusual properties of a possible gear: a thin tip, a root radius too large for the tool tip.

    Parameters
    ----------
    gear
        The gear.
    where
        Path of the gear in the model.

    Returns
    -------
    list of Message
        Empty for usual gears, and for impossible ones.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.rack import BasicRack
    >>> gear = CylindricalGear(z=20, m_n=0.003, rack=BasicRack(rho_fP_star=0.8))
    >>> [(p.where, p.limit) for p in gear_warnings(gear, "a")]
    [('a.rack.root_radius', '0.4719')]
    """
    if gear.problems():
        return []
    most = -1.0 if gear.is_internal else gear.rack.rho_fP_star_max(gear.alpha_n)
    return [
        *problems_of_gear(where, lambda: _thin_tip(sharp(gear))),
        *full_rounding(where, gear.rack.rho_fP_star, most),
    ]


def _thin_tip(gear: CylindricalGear) -> Found | None:
    """A thin or pointed tip."""
    thickness = tip_thickness(gear) / gear.m_n
    remedy = _largest_shift(gear) if thickness < TIP_THICKNESS_LIMIT else ""
    return thin_tip(thickness, "m_n", "profile_shift_coefficient", f"{gear.x:g}", remedy)


def _no_tooth(gear: CylindricalGear) -> Found | None:
    """First reason why a gear has no tooth or no flank; None if it has both."""
    if not gear.s_n > 0.0 or not gear.e_n > 0.0:
        message = f"leaves no {'tooth' if gear.s_n <= 0.0 else 'space'} on the reference circle"
        limit = f"tooth thickness 0 to {_mm(gear.p_n)}"
        remedy = "change the profile shift or the thickness allowance"
        return "profile_shift_coefficient", message, f"{gear.x:g}", limit, remedy
    d_f, d_Ff = gear.d_f, gear.d_Ff
    if d_f * gear.sign <= 0.0:
        remedy = "use more teeth or a smaller dedendum"
        return "root_diameter", "leaves no gear body", f"{1e3 * d_f:.4f} mm", "above 0", remedy
    if not gear.d_a > d_f:
        limit = f"{'below' if gear.is_internal else 'above'} the root diameter {_mm(d_f)}"
        remedy = "set tip_diameter or tip_alteration"
        return "tip_diameter", "leaves no tooth height", _mm(gear.d_a), limit, remedy
    if abs(gear.d_a) < abs(gear.d_b):
        remedy = "set tip_diameter or tip_alteration, or change the profile shift"
        limit = f"above {_mm(gear.d_b)}"
        return "tip_diameter", "lies inside the base circle", _mm(gear.d_a), limit, remedy
    if not gear.d_Fa > d_Ff:
        message = "leaves no involute between root fillet and tip"
        value = f"{abs(gear.z)} (root form diameter {_mm(d_Ff)})"
        limit = f"the tip diameter {_mm(gear.d_Fa)}"
        remedy = "use a larger profile shift, more teeth or a smaller dedendum"
        return "number_of_teeth", message, value, limit, remedy
    return None


def pair_problems(pair: GearPair, where: str, names: tuple[str, str], gears: bool = True) -> list[Message]:
    """Everything that makes a pair impossible.

    Parameters
    ----------
    pair
        The pair.
    where
        Path of the pair in the model, prefix of the key in each message.
    names
        Names of the gears in the messages.
    gears
        Also list the problems of each gear alone.

    Returns
    -------
    list of Message
        Empty for a pair that can run.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> gear = CylindricalGear(z=50, m_n=0.003)
    >>> print(pair_problems(GearPair(gear, gear, 0.16), "stage", ("g1", "g2"))[0])
    stage.center_distance: 160.0000 mm keeps the tips apart (limit below 156.0000 mm); reduce the distance
    """
    called = names if gears else None
    return problems_of_pair(
        pair,
        where,
        called,
        lambda: mismatches(pair, where, names),
        lambda: _contact_problems(pair, where, names),
    )


def mismatches(pair: GearPair, where: str, names: tuple[str, str]) -> list[Message]:
    """Differences between the gears that prevent meshing at any centre distance.

    Parameters
    ----------
    pair, where, names
        As in `pair_problems`; profile shifts and centre distance do not count.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> one, two = (CylindricalGear(z=20, m_n=m) for m in (2e-3, 3e-3))
    >>> [problem.text for problem in mismatches(GearPair(one, two, 0.05), "stage", ("a", "b"))]
    ['have unequal normal modules']
    """
    g1, g2 = pair.gear1, pair.gear2
    place = at_key(where, "gears")
    if g1.is_internal and g2.is_internal:
        return [
            Message(
                place,
                "are both internal",
                f"{names[0]} and {names[1]}",
                "one internal gear",
                "make one of them external",
            )
        ]
    if g1.is_internal:
        return [
            Message(
                place,
                "is internal and is given as gear 1",
                names[0],
                "the internal gear is gear 2",
                f"write [{names[1]}, {names[0]}]",
            )
        ]
    found: list[Message] = []
    if not math.isclose(g1.m_n, g2.m_n, rel_tol=1e-9):
        found.append(unequal(place, "normal modules", (g1.m_n, g2.m_n), _mm, names, "normal_module"))
    alpha, beta = (g1.alpha_n, g2.alpha_n), (abs(g1.beta), abs(g2.beta))
    if abs(alpha[0] - alpha[1]) > _ANGLE_TOLERANCE:
        what = "normal pressure angles"
        found.append(unequal(place, what, alpha, _degrees, names, "normal_pressure_angle"))
    if abs(beta[0] - beta[1]) > _ANGLE_TOLERANCE:
        found.append(unequal(place, "helix angles", beta, _degrees, names, "helix_angle"))
    elif g1.hand != "spur" and (g1.hand == g2.hand) != pair.is_internal:
        found.append(wrong_hands(place, (g1.hand, g2.hand), names, pair.is_internal))
    if pair.is_internal and -g2.z <= g1.z:
        value = f"{names[1]} with {-g2.z} teeth"
        message = f"is not larger than its pinion {names[0]}"
        found.append(
            Message(place, message, value, f"above {g1.z} teeth", "give the internal gear more teeth")
        )
    return found


def _contact_problems(pair: GearPair, where: str, names: tuple[str, str]) -> list[Message]:
    """Problems that depend on the centre distance: no contact, interference, tips in roots."""
    g1, g2, a = pair.gear1, pair.gear2, pair.a_w
    place = at_key(where, "center_distance")
    farther = "reduce" if not pair.is_internal else "increase"
    pair.working_pressure_angle(a)  # raises when the base circles have no common tangent
    reach = 0.5 * (g1.d_a + g2.d_a)
    if a >= reach:
        limit = f"{'above' if pair.is_internal else 'below'} {_mm(reach)}"
        message = "keeps the tips apart"
        return [Message(place, message, _mm(a), limit, f"{farther} the distance")]
    found = tips_in_roots(place, (pair.c_1, pair.c_2), names, _words(pair))
    if pair.g_alpha <= 0.0:
        message = f"leaves no path of contact between {names[0]} and {names[1]}"
        limit = "tip circles that overlap on the line of action"
        found.append(
            Message(place, message, _mm(a), limit, f"{farther} the centre distance or lengthen the teeth")
        )
        return found
    return found + _interference(pair, where, names)


def _interference(pair: GearPair, where: str, names: tuple[str, str]) -> list[Message]:
    """Interference of a tip beyond the mate's base circle, or of the tips of an internal pair."""
    place = at_key(where, "gears")
    # in an internal pair the pinion tip cannot interfere at the base circle of the ring gear
    beyond = (-pair.T1A, *(() if pair.is_internal else (pair.T1E - pair.T1T2,)))
    slack = INTERFERENCE_TOLERANCE * pair.gear1.m_n
    found = interferences(pair, place, beyond, slack, names, _words(pair))
    if pair.is_internal and tip_overlap_gap(pair) < -1e-12:
        message = "cut each other outside the path of contact"
        limit = f"angular gap above 0, it is {math.degrees(tip_overlap_gap(pair)):.4g} deg"
        remedy = "use a larger difference in teeth or shorten the tips"
        found.append(Message(place, message, f"tips of {names[0]} and {names[1]}", limit, remedy))
    return found


def _words(pair: GearPair) -> Words:
    """Terms of messages about cylindrical pairs."""
    closer = "reduce" if pair.is_internal else "increase"
    return Words(
        surface="circle",
        tangent="tangent point",
        path=lambda length: f"{1e3 * length:.4f} mm",
        heights=f"{closer} the centre distance, or change tip_diameter or dedendum",
        shifts="increase the mate's profile shift, shorten the tip (tip_diameter) or change the centre "
        "distance",
        lengths="reduce the distance of the axes or lengthen the teeth",
    )


def pair_warnings(pair: GearPair, where: str, names: tuple[str, str]) -> list[Message]:
    """Unusual properties of a possible pair: tips below the mate's involute, moments without contact.

    Parameters
    ----------
    pair
        The pair.
    where
        Path of the pair in the model.
    names
        Names of the gears in the messages.

    Returns
    -------
    list of Message
        Empty if the involutes cover the whole path of contact and at least one tooth pair is always in
        contact; empty for impossible pairs.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> pair = GearPair(CylindricalGear(z=15, m_n=3e-3), CylindricalGear(z=100, m_n=3e-3), a_w=0.1725)
    >>> [problem.text for problem in pair_warnings(pair, "", ("p", "w"))]
    ['reaches below the root form circle of p (undercut)']
    """
    if pair.problems():
        return []
    slack = INTERFERENCE_TOLERANCE * pair.gear1.m_n
    one, two = (
        f"{_mm(gear.d_Ff)}, contact would start at {_mm(d_Nf)}"
        for gear, d_Nf in ((pair.gear1, pair.d_Nf1), (pair.gear2, pair.d_Nf2))
    )
    ends = (pair.T1A_form - pair.T1A, one), (pair.T1E - pair.T1E_form, two)
    return odd_contact(pair, at_key(where, "gears"), ends, slack, names, _words(pair))


def tip_overlap_gap(pair: GearPair) -> float:
    """Angular gap between the tips of an internal pair where the tip circles cross, at the ring gear [rad].

    Parameters
    ----------
    pair
        Internal pair.

    Returns
    -------
    float
        Gap [rad]; negative if the tips interfere. Infinite if the tip circles do not cross.

    Notes
    -----
    θ₁ z₁/|z₂| + inv α_w − inv α_a2 − θ₂ with θ₁ = acos((r_a2² − r_a1² − a²)/(2 a r_a1)) + inv α_a1 − inv α_w
    and θ₂ = acos((a² + r_a2² − r_a1²)/(2 a r_a2))  (KHK, *Gear technical reference*, trochoid interference).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> pair = GearPair(CylindricalGear(z=20, m_n=3e-3), CylindricalGear(z=-60, m_n=3e-3), a_w=-0.06)
    >>> round(math.degrees(tip_overlap_gap(pair)), 4)
    0.8484
    """
    g1, g2, a = pair.gear1, pair.gear2, abs(pair.a_w)
    # the tips before their edges are broken; there is no involute inside the base circle
    d_a2 = min(g2.d_a, g2.d_b)
    r_a1, r_a2 = 0.5 * g1.d_a, 0.5 * abs(d_a2)
    cos_1 = (r_a2 * r_a2 - r_a1 * r_a1 - a * a) / (2.0 * a * r_a1)
    cos_2 = (a * a + r_a2 * r_a2 - r_a1 * r_a1) / (2.0 * a * r_a2)
    if abs(cos_1) > 1.0 or abs(cos_2) > 1.0:
        return math.inf
    inv_w = inv(pair.alpha_wt)
    theta_1 = math.acos(cos_1) + inv(math.acos(g1.d_b / g1.d_a)) - inv_w
    return theta_1 * g1.z / abs(g2.z) + inv_w - inv(math.acos(g2.d_b / d_a2)) - math.acos(cos_2)
