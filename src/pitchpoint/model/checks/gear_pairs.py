# SPDX-License-Identifier: Apache-2.0
"""Checks of the geometry of gears and gear pairs, reported at the keys of the file."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError, Message, PitchpointError
from pitchpoint.geometry.tooth_problems import TIP_THICKNESS_LIMIT, at_key
from pitchpoint.model.checks.tooth_faults import check_faults
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader

DEFLECTION = 0.1
"""Interference of the flanks without load, over the normal module, that no pair of teeth takes by its
deflection: teeth of steel deflect by about 0.01 m_n under their rated load, of plastics by 0.1 m_n."""

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.mesh import Backlash, Mesh
    from pitchpoint.model.parts import Parts


def check_gear(parts: Parts, name: str, report: Reader) -> None:
    """Check the geometry, modifications, deviations, faults and blank of one gear."""
    gear = parts.gears[name]

    def problems() -> list[Message]:
        """Problems of the geometry, at the keys of the file."""
        return [at_tip_diameter(gear, problem) for problem in gear.geometry.problems()]

    if not impossible_shape(parts, ("gears", name), problems, report):
        _check_modifications(gear, ("gears", name, "modifications"), report)
        _check_deviations(gear, ("gears", name, "deviations"), report)
        check_faults(gear, ("gears", name, "faults"), report)
        _check_wheel_body(gear, ("gears", name), report)


def impossible_shape(parts: Parts, at: Place, find: Callable[[], list[Message]], report: Reader) -> bool:
    """Whether the geometry of a gear is impossible; reports the problems and adds the gear to `misshapen`.

    Parameters
    ----------
    parts
        The parts of the model.
    at
        Section and name of the gear.
    find
        Returns the problems, or raises one.
    report
        Collects the problems.
    """
    try:
        problems = find()
    except GeometryError as error:
        problems = [error.problem]
    for problem in problems:
        report.hand_on(at, problem, taint=False)
        parts.misshapen.add(str(at[1]))
    return bool(problems)


def at_tip_diameter(gear: Gear, problem: Message, where: str = "") -> Message:
    """Problem of a thin or pointed tooth, moved to the tip diameter if the file gives one.

    Parameters
    ----------
    gear
        The gear, as in the model.
    problem
        Problem reported by its geometry.
    where
        Path of the gear in the problem.
    """
    if gear.tip_diameter is None or problem.where != at_key(where, "profile_shift_coefficient"):
        return problem
    from pitchpoint.geometry.bisection import bisect
    from pitchpoint.geometry.tip_edge import sharp
    from pitchpoint.geometry.tooth_thickness import tip_thickness

    shape = sharp(gear.geometry)

    def spare(d_a: float) -> float:
        """Tip tooth thickness less the limit, at a tip diameter [m]."""
        return tip_thickness(shape.replace(tip_diameter=d_a)) - TIP_THICKNESS_LIMIT * shape.m_n

    try:
        # signed diameters: they decrease towards the root, also for internal gears
        ends = (max(shape.d_Ff, shape.d_b), shape.sign * gear.tip_diameter)
        if not spare(ends[0]) > 0.0 > spare(ends[1]):
            return problem
        last = bisect(spare, *ends)
    except GeometryError:
        return problem
    edge = abs(math.floor(last * 1e5)) * 1e-2
    return problem.changed(
        where=at_key(where, "tip_diameter"),
        value=f"{gear.tip_diameter * 1e3:.6g} mm",
        limit=f"{problem.limit}, at {edge:.2f} mm",
        remedy=f"use at {'least' if shape.is_internal else 'most'} {edge:.2f} mm",
    )


def _check_wheel_body(gear: Gear, at: Place, report: Reader) -> None:
    """Report a rim or web that is larger than the gear."""
    shape = gear.geometry
    room = 0.5 * (shape.d_f - gear.bore_diameter)  # external gear: from root to bore
    rim = gear.rim_thickness
    if not shape.is_internal and rim is not None and 0.0 < room < rim * (1.0 - 1e-9):
        report.problem(
            (*at, "rim_thickness"),
            "exceeds the distance between root and bore",
            value=f"{rim * 1e3:.6g} mm",
            limit=f"<= {room * 1e3:.6g} mm",
            remedy="reduce it, or remove it for a solid gear",
            taint=False,
        )
    if gear.web_thickness is not None and gear.web_thickness > gear.face_width:
        report.problem(
            (*at, "web_thickness"),
            "exceeds the face width",
            value=f"{gear.web_thickness * 1e3:.6g} mm",
            limit=f"<= {gear.face_width * 1e3:.6g} mm",
            remedy="reduce it, or remove it for a web of the face width",
            taint=False,
        )


def _check_modifications(gear: Gear, at: Place, report: Reader) -> None:
    """Report modifications that do not fit the flanks."""
    from pitchpoint.geometry.modifications import modification_problems

    for side in ("left", "right", "both") if gear.modifications is not None else ():
        flank = getattr(gear.modifications, side)
        if flank is None:
            continue
        try:
            problems = modification_problems(flank.of_geometry(), gear.geometry)
        except GeometryError as error:
            problems = [error.problem]
        for problem in problems:
            report.hand_on((*at, side), problem, taint=False)


def _check_deviations(gear: Gear, at: Place, report: Reader) -> None:
    """Report impossible deviations."""
    from pitchpoint.geometry.deviations import deviation_problems

    if gear.deviations is not None:
        for problem in deviation_problems(gear.deviations.of_geometry(), gear.geometry):
            report.hand_on(at, problem, taint=False)


def check_pair(parts: Parts, name: str, mesh: Mesh, report: Reader) -> None:
    """Create the gear pair of a mesh, determine its centre distance and report problems of its geometry."""
    _check_misalignment(mesh, ("meshes", name, "misalignment"), report)
    one, two = (parts.gears[g] for g in mesh.gears)
    if (
        one.x is None
        or two.x is None
        or not {"center_distance", "gears"}.isdisjoint(
            p[2] for p in report.tainted if p[:2] == ("meshes", name) and len(p) > 2
        )
    ):
        return
    before = len(report.problems)
    try:
        pair = pair_of(one.geometry, two.geometry, mesh.center_distance)
        for problem in pair.problems("", mesh.gears, gears=False):
            report.hand_on(("meshes", name), problem)
        if len(report.problems) > before or not parts.misshapen.isdisjoint(mesh.gears):
            return
        _ = pair.eps_alpha, pair.j_bt
    except GeometryError as error:
        if parts.misshapen.isdisjoint(mesh.gears):
            report.hand_on(("meshes", name), error.problem)
    else:
        parts.pairs[name] = pair
        parts.meshes[name] = replace(mesh, a_w=pair.a_w)
        if ("meshes", name, "backlash") not in report.tainted:
            _check_backlash(name, mesh, pair, report)


def _check_backlash(name: str, mesh: Mesh, pair: GearPair, report: Reader) -> None:
    """Report teeth that interfere by more than they can deflect, and a backlash larger than the pitch."""
    found = gap(pair, mesh)
    least, most = -DEFLECTION * pair.gear1.m_n, pair.p_et
    if least <= found <= most:
        return
    low, high, size = (f"{1e3 * value:.4g} mm" for value in (least, most, found))
    given = mesh.backlash is not None
    cure = (
        "correct backlash or its unit"
        if given
        else "correct center_distance, or profile shifts and allowances"
    )
    report.problem(
        ("meshes", name, "backlash" if given else "center_distance"),
        "is the backlash along the base tangent: "
        + (
            "the teeth interfere by more than they can deflect" if found < least else "no teeth would be left"
        ),
        value=size,
        limit=f">= {low}, {DEFLECTION:g} m_n" if found < least else f"<= {high}, the base pitch",
        remedy=f"{cure}; usual is a backlash of 0.02 to 0.1 m_n",
        taint=False,
    )


def pair_at_distance(parts: Parts, name: str, distance: float, report: Reader) -> None:
    """Set the centre distance of a mesh to the distance of its bodies [m] and report problems there."""
    pair, mesh = parts.pairs[name], parts.meshes[name]
    try:
        moved = pair_of(pair.gear1, pair.gear2, distance)
        for problem in moved.problems("", mesh.gears, gears=False):
            report.hand_on(("meshes", name), problem)
        _ = moved.eps_alpha, moved.j_bt
    except GeometryError as error:
        report.hand_on(("meshes", name), error.problem)
    else:
        parts.pairs[name] = moved
        parts.meshes[name] = replace(mesh, a_w=moved.a_w)


def _check_misalignment(mesh: Mesh, at: Place, report: Reader) -> None:
    """Report a housing whose tilts together exceed the limit of each: flanks are misaligned by less."""
    from pitchpoint.model.components.mesh import STEEPEST

    tilt = mesh.misalignment
    angle = 0.0 if tilt is None else math.hypot(tilt.in_plane, tilt.out_of_plane)
    if angle > STEEPEST * (1.0 + 1e-9):
        report.problem(
            at,
            "is too large an angle between the axes",
            value=f"{angle:.4g} rad",
            limit=f"{STEEPEST:g} rad",
            remedy="reduce in_plane or out_of_plane",
            taint=False,
        )


def pair_of(one: CylindricalGear, two: CylindricalGear, distance: float | None) -> GearPair:
    """Pair of two gears at a centre distance [m], or at that without backlash."""
    from pitchpoint.geometry.gear_pair import GearPair

    if distance is not None:
        return GearPair.at_distance(one, two, distance)
    try:
        return GearPair.from_profile_shifts(one, two)
    except GeometryError:
        # For gears that cannot mesh, report the mismatch rather than a missing centre distance.
        guess = GearPair.at_distance(one, two, 0.5 * (abs(one.d) + abs(two.d)))
        if guess.problems("", ("", ""), gears=False) and _mismatched(one, two):
            return guess
        raise


def _mismatched(one: CylindricalGear, two: CylindricalGear) -> bool:
    return one.is_internal or (two.is_internal and -two.z <= one.z) or one.m_n != two.m_n


def gap(pair: GearPair, mesh: Mesh) -> float:
    """Backlash along the base tangent at the centre distance of the mesh [m]: as given, or from geometry."""
    if mesh.backlash is None:
        return pair.j_bt
    return along_base_tangent(mesh.backlash, pair.alpha_wt, pair.gear1.beta_b, pair.gear1.m_n)


def along_base_tangent(given: Backlash, alpha: float, beta_b: float, module: float) -> float:
    """Convert a backlash, given in one of its directions or by its factor, to the base tangent [m].

    `alpha` and `beta_b` are the transverse working pressure angle and the base helix or spiral angle [rad],
    `module` is the normal module, of bevel gears in the middle of the face width [m].
    """
    if given.base_tangent is not None:
        return given.base_tangent
    if given.circumferential is not None:
        return given.circumferential * math.cos(alpha)
    if given.factor is not None:
        return given.factor * module * math.cos(alpha)
    if given.normal is None:
        raise PitchpointError("a backlash without any of its directions")
    return given.normal / math.cos(beta_b)
