# SPDX-License-Identifier: Apache-2.0
"""Problems and warnings of bevel gears and bevel pairs, each with key, value, limit and remedy.

Derivation: docs/theory/bevel_gears.md, "A pair".
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message
from pitchpoint.geometry.bevel.tooth import crown_tool
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
from pitchpoint.geometry.tooth_problems import Found, at_key, full_rounding, problems_of_gear, thin_tip

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel.gear import BevelGear
    from pitchpoint.geometry.bevel.pair import BevelPair

ANGLE_TOLERANCE = 1e-5
"""Tolerated difference between angles of both gears [rad]: rounding of degrees to four decimals."""
SHARED_FACE = 0.95
"""Smallest usual common face width as a share of the narrower face; allows for rounded drawing sizes."""
WIDE_CONE, WIDE_MODULES = 1.0 / 3.0, 10.0
"""Widest usual face in outer cone distances and in outer modules."""


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.6g} deg"


def _mm(length: float) -> str:
    return f"{1e3 * length:.6g} mm"


def bevel_gear_problems(gear: BevelGear, where: str = "") -> list[Message]:
    """Everything that makes one bevel gear impossible.

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
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> gear = BevelGear(z=20, m_mn=2e-3, delta=0.5, b=5e-3, x_hm=1.3)
    >>> [problem.where for problem in bevel_gear_problems(gear, "gears.pinion")]
    ['gears.pinion.profile_shift_coefficient']
    """
    return problems_of_gear(
        where, lambda: _no_tooth(gear), lambda: _thin_tip(gear) if tip_thickness(gear) <= 0.0 else None
    )


def _no_tooth(gear: BevelGear) -> Found | None:
    """First reason why a gear has no tooth or no flank; None if it has both."""
    shift, heights = f"{gear.x_hm:g}", "change the profile shift or the rack"
    if not gear.h_am > -gear.h_fm or not gear.h_fm > 0.0:
        return "profile_shift_coefficient", "leaves no dedendum", shift, "below the dedendum", heights
    if not gear.delta_f > 0.0:
        remedy = "use more teeth or a smaller dedendum"
        return "rack.dedendum", "leaves no gear body", f"{gear.rack.h_fP_star:g}", "above 0", remedy
    if not gear.delta_a > gear.delta_b:
        limit = f"a tip cone above {_degrees(gear.delta_b)}"
        return "profile_shift_coefficient", "leaves no flank above the base cone", shift, limit, heights
    if not gear.sigma_a > gear.sigma_Ff:
        message = "leaves no involute between root fillet and tip"
        remedy = "use a larger profile shift, more teeth or a smaller dedendum"
        return "number_of_teeth", message, f"{gear.z}", "a tip cone above the fillet", remedy
    return None


def tip_thickness(gear: BevelGear) -> float:
    """Normal tip thickness at mid-face [m]; elsewhere it is proportional to the cone distance.

    Parameters
    ----------
    gear
        The gear.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> round(tip_thickness(BevelGear(z=20, m_mn=2e-3, delta=0.5, b=5e-3)) / 2e-3, 3)
    0.711
    """
    half = gear.half_angle_at(gear.delta_a)
    return 2.0 * half * gear.R_m * math.sin(gear.delta_a) * math.cos(gear.beta_at(gear.delta_a))


def _thin_tip(gear: BevelGear) -> Found | None:
    """A thin or pointed tip."""
    # a tooth that is thin at the pitch cone is reported by its thickness, any other by its height
    thin = gear.s_mt < 0.8 * 0.5 * math.pi * gear.m_mt
    key, value = gear.thickness_cause() if thin else ("profile_shift_coefficient", f"{gear.x_hm:g}")
    remedy = "take a smaller magnitude" if thin else "reduce it, or the addendum of the rack"
    return thin_tip(tip_thickness(gear) / gear.m_mn, "m_mn", key, value, remedy)


def bevel_gear_warnings(gear: BevelGear, where: str = "") -> list[Message]:
    """Unusual properties of a possible bevel gear: wide face, thin tip, root radius too large.

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

    Notes
    -----
    The face width is usually at most a third of the outer cone distance and ten outer modules (KHK, *Gear
    technical reference*, calculation of bevel gears): closer to the apex the teeth are small, carry little
    load and leave no room for the tool.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> gear = BevelGear.of_outer_module(z=20, m_et=3e-3, delta=math.atan(0.5), b=23e-3)
    >>> print(*bevel_gear_warnings(gear, "pinion"))
    pinion.face_width: 23 mm is a wide face for a bevel gear (limit 22.3607 mm, a third of the outer cone \
distance); reduce it, or use more teeth or a larger module
    """
    if gear.problems():
        return []
    limits = (
        (WIDE_CONE * gear.R_e, "a third of the outer cone distance"),
        (WIDE_MODULES * gear.m_et, "ten outer modules"),
    )
    found, (most, which) = problems_of_gear(where, lambda: _thin_tip(gear)), min(limits)
    if gear.b > most * (1.0 + 1e-9):
        message, limit = "is a wide face for a bevel gear", f"{_mm(most)}, {which}"
        remedy = "reduce it, or use more teeth or a larger module"
        found.append(Message(at_key(where, "face_width"), message, _mm(gear.b), limit, remedy))
    # `crown_tool` may reduce a radius that fits by 1e-6 of its value
    room = crown_tool(gear).rho * gear.R_m / gear.m_mn * (1.0 + 1e-5)
    return found + full_rounding(where, gear.rack.rho_fP_star, room)


def bevel_pair_problems(
    pair: BevelPair, where: str, names: tuple[str, str], gears: bool = True
) -> list[Message]:
    """Everything that makes a pair of bevel gears impossible.

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
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> from pitchpoint.geometry.bevel.pair import BevelPair
    >>> gear = BevelGear(z=20, m_mn=2e-3, delta=math.pi / 4, b=5e-3)
    >>> print(bevel_pair_problems(BevelPair(gear, gear, 1.4), "stage", ("a", "b"))[0])
    stage.gears: a 45 deg, b 45 deg are not the pitch cone angles of this shaft angle (limit a 40.107 deg, \
b 40.107 deg); correct pitch_cone_angle or shaft_angle
    """
    place = at_key(where, "gears")
    return problems_of_pair(
        pair,
        where,
        names if gears else None,
        lambda: _mismatches(pair, place, names),
        lambda: _contact(pair, place, names),
    )


def _mismatches(pair: BevelPair, place: str, names: tuple[str, str]) -> list[Message]:
    """Differences between the gears that prevent meshing."""
    from pitchpoint.geometry.bevel.cones import pitch_angles

    one, two = pair.gear1, pair.gear2
    right = pitch_angles(one.z, two.z, pair.Sigma)
    found = []
    if max(abs(one.delta - right[0]), abs(two.delta - right[1])) > ANGLE_TOLERANCE:
        value, limit = (
            ", ".join(f"{name} {_degrees(delta)}" for name, delta in zip(names, cones, strict=True))
            for cones in ((one.delta, two.delta), right)
        )
        message = "are not the pitch cone angles of this shaft angle"
        found.append(Message(place, message, value, limit, "correct pitch_cone_angle or shaft_angle"))
    alpha, beta = (one.alpha_n, two.alpha_n), (abs(one.beta_m), abs(two.beta_m))
    if abs(alpha[0] - alpha[1]) > ANGLE_TOLERANCE:
        what = "normal pressure angles"
        found.append(unequal(place, what, alpha, _degrees, names, "normal_pressure_angle"))
    if abs(beta[0] - beta[1]) > ANGLE_TOLERANCE:
        found.append(unequal(place, "spiral angles", beta, _degrees, names, "spiral_angle"))
    elif one.hand == two.hand != "straight":
        found.append(wrong_hands(place, (one.hand, two.hand), names))
    if not pair.b > 0.0:
        message, remedy = "have no face in common", f"{_modules(pair)}, or correct the face widths"
        limit = "cone distances that overlap"
        found.append(Message(place, message, _faces(pair, names), limit, remedy))
    return found


def _faces(pair: BevelPair, names: tuple[str, str]) -> str:
    """Cone distances of both faces as text."""
    gears = zip(names, (pair.gear1, pair.gear2), strict=True)
    return ", ".join(f"{name} {_mm(g.R_i)} to {_mm(g.R_e)}" for name, g in gears) + " from the apex"


def _modules(pair: BevelPair) -> str:
    """Remedy for faces at different cone distances."""
    m_et = f"{_mm(pair.gear1.m_et)} and {_mm(pair.gear2.m_et)}"
    return f"give both the same outer_transverse_module ({m_et} now)"


def _contact(pair: BevelPair, place: str, names: tuple[str, str]) -> list[Message]:
    """Missing path of contact, tips in roots, interference."""
    one, two, words = pair.gear1, pair.gear2, _words()
    found = tips_in_roots(place, (two.theta_f - one.theta_a, one.theta_f - two.theta_a), names, words)
    if pair.eps_alpha <= 0.0:
        message, remedy = "leave no path of contact", words.lengths
        return [*found, Message(place, message, " and ".join(names), "tips that overlap", remedy)]
    beyond = (-pair.sigma_A, pair.sigma_E - pair.sigma_T)
    return found + interferences(pair, place, beyond, _slack(pair), names, words)


def _slack(pair: BevelPair) -> float:
    """Angle by which tips may exceed base cones and involutes [rad]."""
    return INTERFERENCE_TOLERANCE * min(gear.m_mn / gear.R_m for gear in (pair.gear1, pair.gear2))


def _words() -> Words:
    """Terms of messages about bevel pairs."""
    return Words(
        surface="cone",
        tangent="tangent ray",
        path=_degrees,
        heights="give gear and mate opposite profile shifts, or change addendum or dedendum",
        shifts="increase the mate's profile shift and reduce its own, use more teeth or a smaller addendum",
        lengths="lengthen the teeth",
    )


def bevel_pair_warnings(pair: BevelPair, where: str, names: tuple[str, str]) -> list[Message]:
    """Unusual properties of a possible bevel pair, like `pitchpoint.geometry.problems.pair_warnings`.

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
        Empty if the involutes cover the whole path of contact, at least one tooth pair is always in contact
        and the faces coincide; empty for impossible pairs.

    Examples
    --------
    >>> from pitchpoint.geometry.bevel.gear import BevelGear
    >>> from pitchpoint.geometry.bevel.cones import pitch_angles
    >>> from pitchpoint.geometry.bevel.pair import BevelPair
    >>> gears = [
    ...     BevelGear.of_outer_module(z=z, m_et=3e-3, delta=delta, b=9e-3)
    ...     for z, delta in zip((13, 40), pitch_angles(13, 40, math.pi / 2))]
    >>> [p.text for p in bevel_pair_warnings(BevelPair(*gears, math.pi / 2), "", ("p", "w"))]
    ['reaches below the root form cone of p (undercut)']
    """
    if pair.problems():
        return []
    place, found = at_key(where, "gears"), []
    share = pair.b / min(pair.gear1.b, pair.gear2.b)
    if share < SHARED_FACE:
        message = f"share {100.0 * share:.3g} % of the narrower face"
        limit = f"{100.0 * SHARED_FACE:g} %"
        found.append(Message(place, message, _faces(pair, names), limit, _modules(pair)))
    one, two = pair.gear1, pair.gear2
    starts = (
        (one, one.sigma_Ff - pair.sigma_A, pair.sigma_A),
        (two, two.sigma_Ff - (pair.sigma_T - pair.sigma_E), pair.sigma_T - pair.sigma_E),
    )
    first, second = (
        (
            missing,
            f"{_degrees(g.cone_at(g.sigma_Ff))}, contact would start at {_degrees(g.cone_at(max(0.0, at)))}",
        )
        for g, missing, at in starts
    )
    return found + odd_contact(pair, place, (first, second), _slack(pair), names, _words())
