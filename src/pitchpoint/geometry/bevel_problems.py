# SPDX-License-Identifier: Apache-2.0
"""What makes a bevel gear or a pair of them impossible, listed completely: where, value, limit, remedy."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError, Problem
from pitchpoint.geometry.problems import at_key

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel_gear import BevelGear
    from pitchpoint.geometry.bevel_pair import BevelPair

ANGLE_TOLERANCE = 1e-5
"""By how much angles of both gears may differ [rad]: what four digits behind the point of a degree leave."""
TIP_THICKNESS_LIMIT = 0.2
"""Thinnest tip in mean normal modules, as for cylindrical gears."""
INTERFERENCE_TOLERANCE = 0.01
"""Mean normal modules along the path of contact that tips may reach too far, as for cylindrical gears."""


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.6g} deg"


def bevel_gear_problems(gear: BevelGear, where: str = "") -> list[Problem]:
    """Everything that makes one bevel gear impossible.

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
    >>> from pitchpoint.geometry.bevel_gear import BevelGear
    >>> gear = BevelGear(z=20, m_mn=2e-3, delta=0.5, b=5e-3, x_hm=1.3)
    >>> [problem.where for problem in bevel_gear_problems(gear, "gears.pinion")]
    ['gears.pinion.profile_shift_coefficient']
    """
    found: list[Problem] = []

    def add(key: str, message: str, value: str, limit: str, remedy: str) -> list[Problem]:
        """Note a problem at a key of the gear; all problems so far."""
        found.append(Problem(at_key(where, key), message, value, limit, remedy))
        return found

    shift = f"{gear.x_hm:g}"
    heights = "change the profile shift or the rack"
    if not gear.h_am > -gear.h_fm or not gear.h_fm > 0.0:
        return add("profile_shift_coefficient", "leaves no dedendum", shift, "below the dedendum", heights)
    if not gear.delta_f > 0.0:
        remedy = "use more teeth or a smaller dedendum"
        return add("rack.dedendum", "leaves no gear body", f"{gear.rack.h_fP_star:g}", "above 0", remedy)
    if not gear.delta_a > gear.delta_b:
        limit = f"a tip cone above {_degrees(gear.delta_b)}"
        return add("profile_shift_coefficient", "leaves no flank above the base cone", shift, limit, heights)
    try:
        form = gear.sigma_Ff
    except GeometryError as error:
        p = error.problem
        return [Problem(at_key(where, p.where), p.message, p.value, p.limit, p.remedy)]
    if not gear.sigma_a > form:
        remedy = "use a larger profile shift, more teeth or a smaller dedendum"
        message = "leaves no involute between root fillet and tip"
        return add("number_of_teeth", message, f"{gear.z}", "a tip cone above the fillet", remedy)
    half = gear.half_angle_at(gear.delta_a)
    tip = 2.0 * half * gear.R_m * math.sin(gear.delta_a) * math.cos(gear.beta_at(gear.delta_a)) / gear.m_mn
    if tip < TIP_THICKNESS_LIMIT:
        message = f"leaves a mean tip thickness of {tip:.2g} m_mn"
        limit = f"{TIP_THICKNESS_LIMIT:g} m_mn"
        # teeth that are thin all over are so by their thickness, others by their height
        thin = gear.s_mt < 0.8 * 0.5 * math.pi * gear.m_mt
        key, value = gear.thickness_cause() if thin else ("profile_shift_coefficient", shift)
        remedy = "take a smaller magnitude" if thin else "reduce it, or the addendum of the rack"
        add(key, message, value, limit, remedy)
    return found


def bevel_pair_problems(
    pair: BevelPair, where: str, names: tuple[str, str], gears: bool = True
) -> list[Problem]:
    """Everything that makes a pair of bevel gears impossible.

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
    >>> from pitchpoint.geometry.bevel_gear import BevelGear
    >>> from pitchpoint.geometry.bevel_pair import BevelPair
    >>> gear = BevelGear(z=20, m_mn=2e-3, delta=math.pi / 4, b=5e-3)
    >>> print(bevel_pair_problems(BevelPair(gear, gear, 1.4), "stage", ("a", "b"))[0])
    stage.gears: a 45 deg, b 45 deg are not the pitch cone angles of this shaft angle (limit 40.107 deg, \
40.107 deg); correct pitch_cone_angle or shaft_angle
    """
    alone = [p for g, n in zip((pair.gear1, pair.gear2), names, strict=True) for p in g.problems(n)]
    found = (alone if gears else []) + _mismatches(pair, at_key(where, "gears"), names)
    # the rest would only repeat that in other words
    return found if found or alone else _contact(pair, at_key(where, "gears"), names)


def _mismatches(pair: BevelPair, place: str, names: tuple[str, str]) -> list[Problem]:
    """Two gears that cannot belong together."""
    from pitchpoint.geometry.bevel_pair import pitch_angles

    one, two = pair.gear1, pair.gear2
    try:
        right = pitch_angles(one.z, two.z, pair.Sigma)
    except GeometryError as error:
        return [error.problem]
    found = []

    def both(of_one: str, of_two: str) -> str:
        """Values of both gears."""
        return f"{names[0]} {of_one}, {names[1]} {of_two}"

    off = max(abs(one.delta - right[0]), abs(two.delta - right[1]))
    if off > ANGLE_TOLERANCE:
        message = "are not the pitch cone angles of this shaft angle"
        limit = f"{_degrees(right[0])}, {_degrees(right[1])}"
        remedy = "correct pitch_cone_angle or shaft_angle"
        found.append(Problem(place, message, both(_degrees(one.delta), _degrees(two.delta)), limit, remedy))
    if abs(one.alpha_n - two.alpha_n) > ANGLE_TOLERANCE:
        message, remedy = "have unequal pressure angles", "give both gears the same normal_pressure_angle"
        value = both(_degrees(one.alpha_n), _degrees(two.alpha_n))
        found.append(Problem(place, message, value, "equal", remedy))
    if abs(one.beta_m + two.beta_m) > ANGLE_TOLERANCE:
        message = "have spirals that do not fit"
        value = both(f"{one.hand} {_degrees(abs(one.beta_m))}", f"{two.hand} {_degrees(abs(two.beta_m))}")
        limit, remedy = "equal spiral angles and opposite hands", "correct spiral_angle or hand"
        found.append(Problem(place, message, value, limit, remedy))
    if not pair.b > 0.0:
        message, remedy = "have no face in common", "check modules and face widths"
        value = both(f"{1e3 * one.R_i:.6g} mm to {1e3 * one.R_e:.6g} mm", "beyond")
        limit = f"{1e3 * two.R_i:.6g} mm to {1e3 * two.R_e:.6g} mm from the apex"
        found.append(Problem(place, message, value, limit, remedy))
    return found


def _contact(pair: BevelPair, place: str, names: tuple[str, str]) -> list[Problem]:
    """No contact, tips in roots."""
    from pitchpoint.geometry.bevel_tooth import bevel_tooth

    one, two = pair.gear1, pair.gear2
    found = []
    module = min(one.m_mn / one.R_m, two.m_mn / two.R_m)
    for tip, root, a, b in ((one, two, *names), (two, one, *names[::-1])):
        clearance = root.theta_f - tip.theta_a
        if clearance < 0.0:
            message = f"is the tip clearance of {a} in the root of {b}"
            remedy = "change addendum, dedendum or profile shift"
            found.append(Problem(place, message, _degrees(clearance), "above 0", remedy))
    if pair.eps_alpha <= 0.0:
        message, remedy = "leave no path of contact", "lengthen the teeth"
        found.append(Problem(place, message, " and ".join(names), "tips that overlap", remedy))
    slack = INTERFERENCE_TOLERANCE * module
    ends = (
        (-pair.sigma_A, one, names[1], names[0]),
        (pair.sigma_E - pair.sigma_T, two, names[0], names[1]),
    )
    for beyond, mate, tip_name, name in ends:
        if beyond > slack and not (bevel_tooth(mate).undercut and mate_gives_way(pair)):
            message = f"interferes with the root of {name}: it would touch beyond the base cone"
            limit = f"the base cone, it is {_degrees(beyond)} beyond in the plane of action"
            remedy = f"increase the profile shift of {name}, use more teeth or a smaller addendum"
            found.append(Problem(place, message, f"tip of {tip_name}", limit, remedy))
    return found


def mate_gives_way(pair: BevelPair) -> bool:
    """Whether undercut roots have room for the mate's tips and leave enough involute to carry the motion.

    Parameters
    ----------
    pair
        The pair.

    Notes
    -----
    The crown gear reaches deeper than any mate's tip: where it has undercut a gear nothing is left to collide
    with, as in `pitchpoint.geometry.problems`.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel_gear import BevelGear
    >>> from pitchpoint.geometry.bevel_pair import BevelPair
    >>> gear = BevelGear(z=20, m_mn=2e-3, delta=math.pi / 4, b=5e-3)
    >>> mate_gives_way(BevelPair(gear, gear, math.pi / 2))
    True
    """
    from pitchpoint.geometry.problems import USABLE_CONTACT_RATIO

    low = max(pair.sigma_A, pair.gear1.sigma_Ff)
    high = min(pair.sigma_E, pair.sigma_T - pair.gear2.sigma_Ff)
    return (high - low) / pair.sigma_p + pair.eps_beta >= USABLE_CONTACT_RATIO


def bevel_pair_warnings(pair: BevelPair, where: str, names: tuple[str, str]) -> list[Problem]:
    """What is odd about a pair that can be built, as of cylindrical gears in `pitchpoint.geometry.problems`.

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
    >>> from pitchpoint.geometry.bevel_gear import BevelGear
    >>> from pitchpoint.geometry.bevel_pair import BevelPair, pitch_angles
    >>> gears = [
    ...     BevelGear.of_outer_module(z=z, m_et=3e-3, delta=delta, b=9e-3)
    ...     for z, delta in zip((13, 40), pitch_angles(13, 40, math.pi / 2))]
    >>> [p.message for p in bevel_pair_warnings(BevelPair(*gears, math.pi / 2), "", ("p", "w"))]
    ['reaches below the root form cone of p (undercut)']
    """
    from pitchpoint.geometry.bevel_tooth import bevel_tooth

    if pair.problems():
        return []
    one, two, place = pair.gear1, pair.gear2, at_key(where, "gears")
    slack = INTERFERENCE_TOLERANCE * min(one.m_mn / one.R_m, two.m_mn / two.R_m)
    found = []
    ends = (
        (one.sigma_Ff - pair.sigma_A, one, names[1], names[0]),
        (two.sigma_Ff - pair.sigma_T + pair.sigma_E, two, names[0], names[1]),
    )
    for missing, mate, tip, name in ends:
        if missing > slack:
            cause = "undercut" if bevel_tooth(mate).undercut else "root fillet"
            message = f"reaches below the root form cone of {name} ({cause})"
            limit = f"the involute lacks {_degrees(missing)} in the plane of action"
            remedy = "shorten the tip, use another profile shift or set the rack"
            found.append(Problem(place, message, f"tip of {tip}", limit, remedy))
    if pair.eps_gamma < 1.0:
        message, remedy = "leaves moments without a tooth pair in contact", "lengthen the teeth"
        value = f"total contact ratio {pair.eps_gamma:.4g}"
        found.append(Problem(place, message, value, "1", remedy))
    return found
