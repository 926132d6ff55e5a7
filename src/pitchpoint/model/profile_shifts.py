# SPDX-License-Identifier: Apache-2.0
"""Profile shifts of the gears of a model: as given, or from the centre distance of a mesh and the mate."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError
from pitchpoint.model.checks.gear_pairs import at_tip_diameter

if TYPE_CHECKING:
    from pitchpoint.model.components.mesh import Mesh
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.reading.reader import Reader

SHIFT = "profile_shift_coefficient"


def usable(parts: Parts, mesh: Mesh, report: Reader) -> bool:
    """Whether both gears of a mesh could be read without problems."""
    return len(set(mesh.gears)) == 2 and all(
        g in parts.gears and ("gears", g) not in report.tainted for g in mesh.gears
    )


def determine_shifts(parts: Parts, report: Reader) -> None:
    """Determine x of every gear: as given, or from a mesh with known centre distance and mating gear."""
    for name, gear in parts.gears.items():
        parts.gears[name] = replace(gear, x=gear.profile_shift_coefficient)
    meshes = {
        name: mesh
        for name, mesh in parts.meshes.items()
        if usable(parts, mesh, report) and ("meshes", name) not in report.tainted
    }
    unfit = [name for name, mesh in meshes.items() if _mismatched(parts, name, mesh, report)]
    found = True
    while found:
        found = False
        for name, mesh in meshes.items():
            found = (name not in unfit and _shift_from(parts, name, mesh, report)) or found
    for name, gear in parts.gears.items():
        if gear.x is None and ("gears", name) not in report.tainted:
            _undetermined(parts, name, unfit, report)


def _mismatched(parts: Parts, name: str, mesh: Mesh, report: Reader) -> bool:
    """Whether the gears of a mesh with a missing profile shift do not fit each other; reported."""
    gears = [parts.gears[g] for g in mesh.gears]
    if all(gear.x is not None for gear in gears):
        return False  # reported with the pair
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.geometry.problems import mismatches

    one, two = (gear.geometry for gear in gears)
    sign = -1.0 if one.is_internal or two.is_internal else 1.0
    try:
        problems = mismatches(GearPair(one, two, sign * 0.5 * abs(one.d + two.d)), "", mesh.gears)
    except GeometryError:
        return False
    for problem in problems:
        report.hand_on(("meshes", name), problem)
    return bool(problems)


def _shift_from(parts: Parts, name: str, mesh: Mesh, report: Reader) -> bool:
    """Determine the profile shift of one gear of a mesh, if its mate has one; whether it was found."""
    one, two = (parts.gears[g] for g in mesh.gears)
    if (one.x is None) == (two.x is None) or mesh.center_distance is None:
        return False
    open_name, fixed = (mesh.gears[0], two) if one.x is None else (mesh.gears[1], one)
    if ("gears", open_name) in report.tainted or fixed.x is None:
        return False
    from pitchpoint.geometry.profile_shift import profile_shift_for_center_distance

    z_sum = one.sign * one.number_of_teeth + two.sign * two.number_of_teeth
    try:
        x_sum = profile_shift_for_center_distance(
            z_sum=z_sum,
            m_n=one.normal_module,
            alpha_n=one.normal_pressure_angle,
            beta=one.beta,
            a_w=math.copysign(mesh.center_distance, z_sum),
        )
    except GeometryError as error:
        report.hand_on(("meshes", name), error.problem)
        report.tainted.add(("gears", open_name))
        return False
    parts.gears[open_name] = replace(parts.gears[open_name], x=x_sum - fixed.x)
    _check_distance(parts, name, open_name, report)
    return True


def _check_distance(parts: Parts, name: str, follows: str, report: Reader) -> None:
    """Report a centre distance at which the gear whose profile shift follows from it is impossible.

    Problems that other centre distances do not solve are left to the check of the gear.
    """
    gear, mesh = parts.gears[follows], parts.meshes[name]
    try:
        problems = gear.geometry.problems()
    except GeometryError as error:
        problems = [error.problem]
    problems = [at_tip_diameter(gear, problem) for problem in problems]
    if gear.tip_diameter is not None:
        problems = [problem for problem in problems if problem.where == SHIFT]
    if not problems or mesh.center_distance is None:
        return
    from pitchpoint.geometry.distance_range import possible_distances

    one, two = (parts.gears[g].geometry for g in mesh.gears)
    limits = possible_distances(one, two, mesh.gears.index(follows))
    if limits is None:
        return
    first = problems[0]
    place = "it" if first.where == SHIFT else f"{first.where.replace('_', ' ')} {first.value}"
    low, high = math.ceil(limits[0] * 1e5) * 1e-2, math.floor(limits[1] * 1e5) * 1e-2
    report.problem(
        ("meshes", name, "center_distance"),
        f"requires a profile shift coefficient of {gear.x:.4g} of {follows}: {place} {first.text}",
        value=f"{mesh.center_distance * 1e3:.6g} mm",
        limit=f"{low:.2f} to {high:.2f} mm",
        remedy="change the centre distance, the numbers of teeth or the module",
    )
    parts.misshapen.add(follows)


def _undetermined(parts: Parts, name: str, unfit: list[str], report: Reader) -> None:
    """Report a missing profile shift, unless it is the consequence of another problem.

    Meshes in `unfit` have gears that do not fit; they would determine the shift only with that of the mate.
    """
    meshes = [(n, m) for n, m in parts.meshes.items() if name in m.gears]
    if any(
        not usable(parts, m, report)
        or (("meshes", n) in report.tainted and not (n in unfit and _both_open(parts, m)))
        for n, m in meshes
    ):
        return
    where = ("gears", name, SHIFT)
    if not meshes:
        report.problem(
            where, "is missing, and no mesh determines it", remedy="give it; 0 for a gear without shift"
        )
    elif all(m.center_distance is None for _, m in meshes):
        report.problem(
            where,
            "is missing, and its mesh has no centre distance to determine it",
            remedy=f"give it, or meshes.{meshes[0][0]}.center_distance",
        )
    else:
        report.problem(
            where,
            "is missing on both gears of a mesh; the centre distance determines only their sum",
            remedy="give it on one of the two gears",
        )


def _both_open(parts: Parts, mesh: Mesh) -> bool:
    """Whether the profile shifts of both gears are missing."""
    return all(parts.gears[g].x is None for g in mesh.gears)
