# SPDX-License-Identifier: Apache-2.0
"""What makes a gear or a pair impossible, listed completely: where, value, limit, remedy.

Nothing here raises: a loader shows every problem of a file at once.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError, Problem
from pitchpoint.geometry.bisection import bisect
from pitchpoint.geometry.involute import inv
from pitchpoint.geometry.tooth_thickness import tip_thickness

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.geometry.gear_pair import GearPair

# Thinner tips break or burn through in hardening; the usual lower limit of design practice.
TIP_THICKNESS_LIMIT = 0.2
# In modules along the path of contact: less than what tip diameters and centre distances are made to.
INTERFERENCE_TOLERANCE = 0.01
# Below this a pair with undercut teeth does not reliably hand over from one pair of teeth to the next.
USABLE_CONTACT_RATIO = 1.1
_ANGLE_TOLERANCE = 1e-6


def _mm(length: float) -> str:
    return f"{1e3 * abs(length):.4f} mm"


def at_key(where: str, key: str) -> str:
    """Place of a key below the place of its part.

    Parameters
    ----------
    where
        Place of the part, empty for none.
    key
        Name of the key.

    Examples
    --------
    >>> at_key("gears.pinion", "rack"), at_key("", "rack")
    ('gears.pinion.rack', 'rack')
    """
    return f"{where}.{key}" if where else key


def _from_error(where: str, error: GeometryError) -> Problem:
    p = error.problem
    return Problem(at_key(where, p.where), p.message, p.value, p.limit, p.remedy)


def _largest_shift(gear: CylindricalGear) -> str:
    """Advice for a pointed tooth: the largest shift that keeps the tip thick enough, if there is one."""
    if gear.tip_diameter is not None:
        return "reduce tip_diameter" if not gear.is_internal else "increase tip_diameter"
    limit, low = TIP_THICKNESS_LIMIT * gear.m_n, gear.x - 0.05

    def spare(x: float) -> float:
        """Thickness at the tip above the limit, at a profile shift coefficient x [m]."""
        return tip_thickness(gear.replace(x=x)) - limit

    try:
        while spare(low) < 0.0:
            low -= 0.05
        low = bisect(spare, low, low + 0.05)
    except GeometryError:
        return "reduce the profile shift or set tip_diameter"
    return f"use at most {math.floor(100.0 * low) / 100.0:.2f} or set tip_diameter"


def gear_problems(gear: CylindricalGear, where: str = "") -> list[Problem]:
    """Everything that makes one gear impossible.

    Parameters
    ----------
    gear
        The gear.
    where
        Place of the gear in its description, put before the name of the offending key.

    Returns
    -------
    list of Problem
        Empty for a gear that can be made.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> problem = gear_problems(CylindricalGear(z=20, m_n=0.003, x=1.4), "gears.pinion")[0]
    >>> problem.where, problem.limit, problem.remedy
    ('gears.pinion.profile_shift_coefficient', '0.2 m_n', 'use at most 0.94 or set tip_diameter')
    """
    found: list[Problem] = []

    def add(key: str, message: str, value: str, limit: str, remedy: str) -> None:
        """Note a problem at a key of the gear."""
        found.append(Problem(at_key(where, key), message, value, limit, remedy))

    if gear.rack.rho_fP_star_max(gear.alpha_n) < 0.0 and not gear.is_internal:
        deepest = f"{0.25 * math.pi / math.tan(gear.alpha_n):.4g}"
        message = "modules end beyond the point of the tool"
        add("rack.dedendum", message, f"{gear.rack.h_fP_star:g}", deepest, "use a smaller dedendum")
    try:
        missing = _no_tooth(gear)
    except GeometryError as error:
        return [*found, _from_error(where, error)]
    if missing is not None:
        add(*missing)
        return found
    thickness = tip_thickness(gear) / gear.m_n
    if thickness < TIP_THICKNESS_LIMIT:
        message = f"leaves a tip thickness of {thickness:.2g} m_n"
        remedy = _largest_shift(gear)
        add("profile_shift_coefficient", message, f"{gear.x:g}", f"{TIP_THICKNESS_LIMIT:g} m_n", remedy)
    return found


def _no_tooth(gear: CylindricalGear) -> tuple[str, str, str, str, str] | None:
    """Why a gear has no tooth or no flank: key, message, value, limit, remedy; what else is wrong follows."""
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


def pair_problems(pair: GearPair, where: str, names: tuple[str, str], gears: bool = True) -> list[Problem]:
    """Everything that makes a pair impossible.

    Parameters
    ----------
    pair
        The pair.
    where
        Place of the pair in its description, put before the name of the offending key.
    names
        How the messages call the two gears.
    gears
        Also list the problems of each gear alone.

    Returns
    -------
    list of Problem
        Empty for a pair that can run.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> gear = CylindricalGear(z=50, m_n=0.003)
    >>> print(pair_problems(GearPair(gear, gear, 0.16), "stage", ("g1", "g2"))[0])
    stage.center_distance: 160.0000 mm keeps the tips apart (limit below 156.0000 mm); reduce the distance
    """
    found: list[Problem] = []
    if gears:
        for gear, name in zip((pair.gear1, pair.gear2), names, strict=True):
            found += gear_problems(gear, name)
    structural = _mismatches(pair, where, names)
    found += structural
    if structural or any(gear_problems(gear) for gear in (pair.gear1, pair.gear2)):
        # The rest would only repeat that in other words, with numbers that mean nothing.
        return found
    try:
        return found + _contact_problems(pair, where, names)
    except GeometryError as error:
        return [*found, _from_error(where, error)]


def _mismatches(pair: GearPair, where: str, names: tuple[str, str]) -> list[Problem]:
    """Two gears that cannot belong together, whatever the centre distance."""
    g1, g2 = pair.gear1, pair.gear2
    place = at_key(where, "gears")
    if g1.is_internal and g2.is_internal:
        return [
            Problem(
                place,
                "are both internal",
                f"{names[0]} and {names[1]}",
                "one internal gear",
                "make one of them external",
            )
        ]
    if g1.is_internal:
        return [
            Problem(
                place,
                "is internal and stands first",
                names[0],
                "the internal gear is gear 2",
                f"write [{names[1]}, {names[0]}]",
            )
        ]
    found: list[Problem] = []
    if not math.isclose(g1.m_n, g2.m_n, rel_tol=1e-9):
        value = f"{names[0]} {_mm(g1.m_n)}, {names[1]} {_mm(g2.m_n)}"
        found.append(
            Problem(
                place, "have unequal normal modules", value, "equal", "give both gears the same normal_module"
            )
        )
    if abs(g1.alpha_n - g2.alpha_n) > _ANGLE_TOLERANCE:
        value = f"{names[0]} {math.degrees(g1.alpha_n):g} deg, {names[1]} {math.degrees(g2.alpha_n):g} deg"
        remedy = "give both gears the same normal_pressure_angle"
        found.append(Problem(place, "have unequal normal pressure angles", value, "equal", remedy))
    if abs(abs(g1.beta) - abs(g2.beta)) > _ANGLE_TOLERANCE:
        value = (
            f"{names[0]} {math.degrees(abs(g1.beta)):g} deg, {names[1]} {math.degrees(abs(g2.beta)):g} deg"
        )
        found.append(
            Problem(
                place, "have unequal helix angles", value, "equal", "give both gears the same helix_angle"
            )
        )
    elif g1.hand != "spur" and (g1.hand == g2.hand) != pair.is_internal:
        kind, rule = ("internal", "equal") if pair.is_internal else ("external", "opposite")
        value = f"{names[0]} {g1.hand}, {names[1]} {g2.hand}"
        message = f"have hands that do not fit an {kind} pair"
        found.append(Problem(place, message, value, f"{rule} hands", "change the hand of one gear"))
    if pair.is_internal and -g2.z <= g1.z:
        value = f"{names[1]} with {-g2.z} teeth"
        message = f"is not larger than its pinion {names[0]}"
        found.append(
            Problem(place, message, value, f"above {g1.z} teeth", "give the internal gear more teeth")
        )
    return found


def _contact_problems(pair: GearPair, where: str, names: tuple[str, str]) -> list[Problem]:
    """No contact, interference, tips in roots: what depends on the centre distance."""
    g1, g2, a = pair.gear1, pair.gear2, pair.a_w
    place = at_key(where, "center_distance")
    farther = "reduce" if not pair.is_internal else "increase"
    closer = "increase" if not pair.is_internal else "reduce"
    pair.working_pressure_angle(a)  # raises when the base circles have no common tangent
    reach = 0.5 * (g1.d_a + g2.d_a)
    if a >= reach:
        limit = f"{'above' if pair.is_internal else 'below'} {_mm(reach)}"
        message = "keeps the tips apart"
        return [Problem(place, message, _mm(a), limit, f"{farther} the distance")]
    found: list[Problem] = []
    for clearance, tip, root in ((pair.c_1, names[0], names[1]), (pair.c_2, names[1], names[0])):
        if clearance < 0.0:
            message = f"is the tip clearance of {tip} in the root of {root}"
            remedy = f"{closer} the centre distance, or change tip_diameter or dedendum"
            found.append(Problem(place, message, f"{1e3 * clearance:.4f} mm", "above 0", remedy))
    if pair.g_alpha <= 0.0:
        message = f"leaves no path of contact between {names[0]} and {names[1]}"
        limit = "tip circles that overlap on the line of action"
        found.append(
            Problem(place, message, _mm(a), limit, f"{farther} the centre distance or lengthen the teeth")
        )
        return found
    return found + _interference(pair, where, names)


def _interference(pair: GearPair, where: str, names: tuple[str, str]) -> list[Problem]:
    """A tip that wants contact beyond the mate's base circle, or runs through the mate's tip (internal)."""
    place = at_key(where, "gears")
    slack = INTERFERENCE_TOLERANCE * pair.gear1.m_n
    remedy = "increase the mate's profile shift, shorten the tip (tip_diameter) or change the centre distance"
    found: list[Problem] = []
    ends = [(-pair.T1A, pair.gear1, names[1], names[0])]
    if not pair.is_internal:
        ends.append((pair.T1E - pair.T1T2, pair.gear2, names[0], names[1]))
    # A rack reaches deeper than any mate's tip: where it has undercut the gear, nothing is left to collide
    # with, and the question is only whether enough involute remains to carry the motion.
    remains = pair.eps_alpha_form + pair.eps_beta
    for beyond, mate, tip, name in ends:
        if beyond > slack and not (mate.undercut and remains >= USABLE_CONTACT_RATIO):
            message = f"interferes with the root of {name}: it would touch beyond the base circle"
            limit = f"the tangent point, it is {_mm(beyond)} beyond"
            if mate.undercut:
                limit += f", and undercut leaves a contact ratio of {remains:.3g} of {USABLE_CONTACT_RATIO:g}"
            found.append(Problem(place, message, f"tip of {tip}", limit, remedy))
    if pair.is_internal and tip_overlap_gap(pair) < -1e-12:
        message = "cut each other outside the path of contact"
        limit = f"angular gap above 0, it is {math.degrees(tip_overlap_gap(pair)):.4g} deg"
        remedy = "use a larger difference in teeth or shorten the tips"
        found.append(Problem(place, message, f"tips of {names[0]} and {names[1]}", limit, remedy))
    return found


def pair_warnings(pair: GearPair, where: str, names: tuple[str, str]) -> list[Problem]:
    """What is odd about a pair that can be built: flank missing below its mate's tip, gaps between contacts.

    Where a tip reaches below the mate's root form circle the geometry still follows the tip circles (as
    published contact ratios do), but the involute ends sooner, in a fillet or an undercut. It depends on the
    tool, which is rarely known exactly, so it does not forbid the pair. A total contact ratio below one
    leaves moments without any contact.

    Parameters
    ----------
    pair
        The pair.
    where
        Place of the pair in its description.
    names
        How the messages call the two gears.

    Returns
    -------
    list of Problem
        Empty where the involutes cover the whole path of contact and one pair always carries, and for
        impossible pairs.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> pair = GearPair(CylindricalGear(z=15, m_n=3e-3), CylindricalGear(z=100, m_n=3e-3), a_w=0.1725)
    >>> [problem.message for problem in pair_warnings(pair, "", ("p", "w"))]
    ['reaches below the root form circle of p (undercut)']
    """
    if pair.problems():
        return []
    slack = INTERFERENCE_TOLERANCE * pair.gear1.m_n
    found: list[Problem] = []
    ends = (
        (pair.T1A_form - pair.T1A, pair.gear1, pair.d_Nf1, names[1], names[0]),
        (pair.T1E - pair.T1E_form, pair.gear2, pair.d_Nf2, names[0], names[1]),
    )
    for missing, mate, d_Nf, tip, name in ends:
        if missing > slack:
            cause = "undercut" if mate.undercut else "root fillet"
            message = f"reaches below the root form circle of {name} ({cause})"
            limit = f"{_mm(mate.d_Ff)}, contact would start at {_mm(d_Nf)}"
            left = f"the transverse contact ratio left is {pair.eps_alpha_form:.4g}"
            remedy = f"{left}; shorten the tip or set the rack"
            found.append(Problem(at_key(where, "gears"), message, f"tip of {tip}", limit, remedy))
    if pair.eps_gamma < 1.0:
        message = "leaves moments without a tooth pair in contact"
        remedy = "bring the axes closer together or lengthen the teeth"
        value = f"total contact ratio {pair.eps_gamma:.4g}"
        found.append(Problem(at_key(where, "gears"), message, value, "1", remedy))
    return found


def tip_overlap_gap(pair: GearPair) -> float:
    """Angular gap between the tips of an internal pair where the tip circles cross, at the ring [rad].

    Parameters
    ----------
    pair
        Internal pair.

    Returns
    -------
    float
        Gap [rad]; negative when the pinion's tip runs through the ring's. Infinite if the tip circles do not
        cross.

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
    r_a1, r_a2 = 0.5 * g1.d_a, 0.5 * abs(g2.d_Fa)
    cos_1 = (r_a2 * r_a2 - r_a1 * r_a1 - a * a) / (2.0 * a * r_a1)
    cos_2 = (a * a + r_a2 * r_a2 - r_a1 * r_a1) / (2.0 * a * r_a2)
    if abs(cos_1) > 1.0 or abs(cos_2) > 1.0:
        return math.inf
    inv_w = inv(pair.alpha_wt)
    theta_1 = math.acos(cos_1) + inv(math.acos(g1.d_b / g1.d_a)) - inv_w
    return theta_1 * g1.z / abs(g2.z) + inv_w - inv(math.acos(g2.d_b / g2.d_Fa)) - math.acos(cos_2)
