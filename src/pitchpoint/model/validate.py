# SPDX-License-Identifier: Apache-2.0
"""Checks that need more than one key: references, motions, inertias, choices of which one is allowed."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import Any

from pitchpoint.core.errors import GeometryError
from pitchpoint.model.choices import exactly_one
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.modifications import FlankPitch
from pitchpoint.model.fault_check import hand_on
from pitchpoint.model.frames import GROUND
from pitchpoint.model.inertia import (
    BodyInertia,
    asks_gears,
    bevel_gear_inertia,
    body_inertia,
    gear_inertia,
)
from pitchpoint.model.keys import Place
from pitchpoint.model.mesh_check import check_meshes
from pitchpoint.model.parts import Parts
from pitchpoint.model.read import Reader
from pitchpoint.model.scenario_check import check_scenarios
from pitchpoint.model.speed_ratios import links_of

INERTIAS = {
    "torsion": ("inertia",),
    "planar": ("inertia", "mass"),
    "free": ("inertia", "mass", "transverse_inertia"),
    "fixed": (),
}
_SUM = {"inertia": "polar", "mass": "mass", "transverse_inertia": "transverse"}


def check_references(parts: Parts, report: Reader) -> None:
    """Everything that names something else names something that exists, once."""
    for name, body in list(parts.bodies.items()):
        for gear in body.gears:
            known(parts, "gears", gear, ("bodies", name, "gears"), report)
        for gear in body.bevel_gears:
            known(parts, "bevel_gears", gear, ("bodies", name, "bevel_gears"), report)
    for name, mesh in list(parts.meshes.items()):
        at: Place = ("meshes", name, "gears")
        for gear in mesh.gears:
            known(parts, "gears", gear, at, report)
        if mesh.gears[0] == mesh.gears[1]:
            report.problem(at, f"names {mesh.gears[0]} twice", remedy="name two gears")
    _same_pairs(parts, report)
    for group in ("bearings", "loads"):
        for name, part in getattr(parts, group).items():
            known(parts, "bodies", part.body, (group, name, "body"), report)
    for name, coupling in parts.couplings.items():
        at = ("couplings", name, "bodies")
        for body_name in coupling.bodies:
            known(parts, "bodies", body_name, at, report)
        if coupling.bodies[0] == coupling.bodies[1]:
            report.problem(at, f"names {coupling.bodies[0]} twice", remedy="name two bodies")


def _same_pairs(parts: Parts, report: Reader) -> None:
    """Two gears mesh once; a second mesh between them would carry the load a second time."""
    seen: dict[frozenset[str], str] = {}
    for name, mesh in parts.meshes.items():
        first = seen.setdefault(frozenset(mesh.gears), name)
        if first != name:
            report.problem(
                ("meshes", name, "gears"),
                f"are the gears of {first} already",
                value=" and ".join(mesh.gears),
                remedy="leave one of the two meshes out",
            )


def known(parts: Parts, group: str, name: str, at: Place, report: Reader) -> bool:
    """Whether a name exists; reports it with the nearest one if not."""
    if parts.has(group, name):
        return True
    names = parts.known(group)
    guess = nearest(name, names)
    single = {"gears": "gear", "bevel_gears": "bevel gear", "bodies": "body", "meshes": "mesh"}[group]
    have = f"there are {', '.join(sorted(names))}" if names else f"the file has no {group.replace('_', ' ')}"
    report.problem(at, f"names the {single} {name[:40]!r}, which does not exist", remedy=guess + have)
    return False


def nearest(name: str, names: Iterable[str]) -> str:
    """Question for the name that was probably meant, '' if none is near."""
    near = difflib.get_close_matches(name, sorted(names), 1, 0.6)
    return f"did you mean {near[0]}? " if near else ""


def check_carriers(parts: Parts, report: Reader) -> None:
    """Every gear sits on one body; no mesh joins gears of one body."""
    carriers: dict[str, str] = {}
    for name, body in parts.bodies.items():
        for gear in body.gears:
            if gear in carriers:
                report.problem(
                    ("bodies", name, "gears"),
                    f"carries {gear}, which sits on {carriers[gear]} already",
                    remedy="leave it on one of the two bodies",
                )
            carriers.setdefault(gear, name)
    complete = set(parts.bodies) == parts.known("bodies") and ("bodies",) not in report.tainted
    for name, mesh in parts.meshes.items():
        bodies = [carriers.get(g) for g in mesh.gears]
        if bodies[0] is not None and bodies[0] == bodies[1] and mesh.gears[0] != mesh.gears[1]:
            report.problem(
                ("meshes", name, "gears"),
                f"joins two gears of the body {bodies[0]}",
                value=" and ".join(mesh.gears),
                remedy="put them on two bodies",
            )
        elif parts.bodies and complete:
            for gear in mesh.gears:
                if gear not in carriers and gear in parts.gears:
                    report.problem(
                        ("gears", gear),
                        f"is in the mesh {name}, but no body carries it",
                        remedy=f"add {gear} to gears of a body",
                    )


def check_choices(parts: Parts, report: Reader) -> None:
    """Keys of which exactly one or at most one is allowed."""
    check_meshes(parts, report)
    for group in ("bearings", "couplings", "bushings"):
        for name, part in getattr(parts, group).items():
            for key in ("stiffness", "damping"):
                if getattr(part, key) is not None:
                    _six(getattr(part, key), (group, name, key), report)
    for name, gear in parts.gears.items():
        _gear_choices(name, gear, report)


def _six(part: Any, at: Place, report: Reader) -> None:
    if part.matrix is not None:
        others = [k for k in ("radial", "x", "y", "tilt", "rx", "ry") if getattr(part, k) is not None]
        others += [k for k in ("axial", "torsion") if getattr(part, k) != 0.0]
        if others:
            report.problem(
                (*at, "matrix"), f"stands beside {', '.join(others)}", remedy="give the matrix alone"
            )
    for both, single in (("radial", "xy"), ("tilt", ("rx", "ry"))):
        if getattr(part, both) is not None:
            for key in single:
                if getattr(part, key) is not None:
                    report.problem(
                        (*at, key), f"stands beside {both}", remedy=f"give {both}, or x and y apart"
                    )


def _gear_choices(name: str, gear: Any, report: Reader) -> None:
    at: Place = ("gears", name)
    if gear.cutter is not None and gear.type == "external":
        report.problem(
            (*at, "cutter"), "is for internal gears only", remedy="remove it, or set type: internal"
        )
    sides = gear.modifications
    for side in ("left", "right", "both") if sides is not None else ():
        flank = getattr(sides, side)
        for key in ("tip_relief", "root_relief") if flank is not None else ():
            relief = getattr(flank, key)
            if relief is not None:
                exactly_one(relief, ("start_diameter", "length"), (*at, "modifications", side, key), report)
    given = gear.deviations.pitch if gear.deviations is not None else ()
    by_flank = isinstance(given, FlankPitch)
    for side in ("left", "right") if by_flank else ("both",):
        pitch = getattr(given, side) if by_flank else given
        if pitch and len(pitch) != gear.number_of_teeth:
            report.problem(
                (*at, "deviations", "pitch", *((side,) if by_flank else ())),
                f"has {len(pitch)} entries for {gear.number_of_teeth} teeth",
                remedy="give one deviation per tooth",
            )
    maps = gear.deviations.flank_maps if gear.deviations is not None else ()
    for i, flank_map in enumerate(maps):
        if flank_map.tooth >= gear.number_of_teeth:
            report.problem(
                (*at, "deviations", "flank_maps", i, "tooth"),
                "is no tooth of this gear",
                value=str(flank_map.tooth),
                limit=f"<= {gear.number_of_teeth - 1}",
            )

    profile = gear.tooth_profile
    if (
        profile is not None
        and (*at, "tooth_profile") not in report.tainted
        and profile.given
        not in (
            ("tooth",),
            ("both",),
            ("left",),
            ("right",),
            ("left", "right"),
        )
    ):
        report.problem(
            (*at, "tooth_profile"),
            f"gives {' and '.join(profile.given)} at once" if profile.given else "gives no points",
            remedy="give tooth, or both, or left and right",
        )


def check_motions(parts: Parts, report: Reader) -> None:
    """Bodies that move have inertia; fixed bodies carry no loads and bearings."""
    for name in parts.bodies:
        _inertia(parts, name, report)
    fixed = {n for n, b in parts.bodies.items() if b.moves == "fixed"}
    for group in ("loads", "bearings"):
        for name, part in getattr(parts, group).items():
            if part.body in fixed and getattr(part, "housing", None) in (None, GROUND):
                report.problem(
                    (group, name, "body"),
                    f"names {part.body}, which is fixed and feels nothing",
                    remedy="remove it, or give the body a motion",
                )


def _inertia(parts: Parts, name: str, report: Reader) -> None:
    """Mass and inertia of one body, as far as its motion needs them."""
    body = parts.bodies[name]
    if body.moves == "joint" or not body.is_round or body.elastic is not None:
        return  # checked with the mechanism: what hangs on it counts; of an elastic one the file decides
    needed = [k for k in INERTIAS[body.moves] if ("bodies", name, k) not in report.tainted]
    given = {k: getattr(body, k) for k in needed if getattr(body, k) is not None}
    total = None
    if _readable(parts, body, report):
        # whatever is computed with the body asks for all that its gears have to give
        carried = (*body.gears, *body.bevel_gears)
        if asks_gears(body) and not all(_has_inertia(parts, g, report) for g in carried):
            return
        total = body_inertia(body, parts.gears, parts.bevel_gears)
        given = {k: getattr(total, _SUM[k]) for k in needed}
    zero = [key for key, amount in given.items() if not amount > 0.0]
    for key in zero:
        report.problem(
            ("bodies", name, key),
            f"is zero, but the body moves ({body.moves})",
            limit="> 0",
            remedy=f"give {key}" + ("" if body.gears or body.bevel_gears else " (the body carries no gears)"),
        )
    whole = not any(("bodies", name, k) in report.tainted for k in ("gears", "mass", "center_of_mass"))
    if total is not None and whole and "transverse_inertia" in given and not zero and not total.central > 0.0:
        _transverse(name, body, total, report)


def _readable(parts: Parts, body: Body, report: Reader) -> bool:
    """Whether every gear of a body could be read and has a possible shape."""
    return all(
        g in getattr(parts, group) and (group, g) not in report.tainted and g not in parts.misshapen
        for group in ("gears", "bevel_gears")
        for g in getattr(body, group)
    )


def _transverse(name: str, body: Body, total: BodyInertia, report: Reader) -> None:
    """A body that tilts needs inertia about its centre of mass too, not only about the origin."""
    least = total.mass * total.center * total.center
    place = f"the centre of mass at {total.center * 1e3:.6g} mm from the origin"
    if body.transverse_inertia is None:
        report.problem(
            ("bodies", name, "transverse_inertia"),
            f"of the gears is zero about {place}, but the body tilts (motion: free)",
            limit=f"> {least:.6g} kg m^2 about the origin",
            remedy="give transverse_inertia, counted about the origin",
        )
        return
    report.problem(
        ("bodies", name, "transverse_inertia"),
        f"counts about the origin and leaves nothing about {place}",
        value=f"{body.transverse_inertia:.6g} kg m^2",
        limit=f"> {least:.6g} kg m^2, mass * center_of_mass^2",
        remedy=f"add {least:.6g} kg m^2 if it was meant about the centre of mass, or "
        f"{'give' if body.center_of_mass is None else 'correct'} center_of_mass",
    )


def _has_inertia(parts: Parts, gear: str, report: Reader) -> bool:
    """Whether mass and inertia of a gear can be had; a bore that is too large, say, is reported."""
    group = "gears" if gear in parts.gears else "bevel_gears"
    try:
        if group == "gears":
            gear_inertia(parts.gears[gear])
        else:
            bevel_gear_inertia(parts.bevel_gears[gear])
    except GeometryError as error:
        hand_on(report, (group, gear), error.problem)
        return False
    return True


def trains(parts: Parts) -> list[set[str]]:
    """Bodies that turn together, by meshes and by couplings that carry torque."""
    groups: list[set[str]] = [{name} for name in parts.bodies]
    for link in ({one, two} for _, one, two, _ in links_of(parts)):
        touched = [g for g in groups if g & link]
        if len(touched) > 1:
            groups = [g for g in groups if not g & link] + [set().union(*touched)]
    return groups


def check(parts: Parts, report: Reader) -> None:
    """All checks, in the order in which a later one may rely on an earlier one."""
    from pitchpoint.model.assembly import resolve
    from pitchpoint.model.beam_check import check_beams
    from pitchpoint.model.bevel_check import check_bevel_gears
    from pitchpoint.model.bevel_mesh_check import check_bevel_names, check_bevel_pairs
    from pitchpoint.model.contact_check import check_contacts
    from pitchpoint.model.elastic_check import add_elastic_bodies, check_elastic_bodies
    from pitchpoint.model.fault_check import check_fault_laws
    from pitchpoint.model.force_check import check_forces, check_loads, check_unbalances
    from pitchpoint.model.joint_check import check_directions, check_joints, check_masses, check_places
    from pitchpoint.model.mechanism_check import check_mechanism
    from pitchpoint.model.pair_check import check_phasing
    from pitchpoint.model.shafts import add_shafts, check_shaft_places
    from pitchpoint.model.signal_check import check_signals
    from pitchpoint.model.signal_places import check_signal_places
    from pitchpoint.model.solids import check_solids
    from pitchpoint.model.support_check import (
        check_couplings,
        check_housings,
        check_positions,
        check_rings,
        check_turning,
    )

    check_solids(parts, report)
    add_shafts(parts, report)
    add_elastic_bodies(parts, report)
    check_references(parts, report)
    check_bevel_gears(parts, report)
    check_bevel_names(parts, report)
    check_places(parts, report)
    check_carriers(parts, report)
    check_choices(parts, report)
    check_directions(parts, report)
    check_masses(parts, report)
    check_joints(parts, report)
    check_forces(parts, report)
    check_contacts(parts, report)
    check_elastic_bodies(parts, report)
    check_signals(parts, report)
    check_positions(parts, report)
    resolve(parts, report)
    check_fault_laws(parts, report)
    check_shaft_places(parts, report)
    check_mechanism(parts, report)
    check_signal_places(parts, report)
    check_beams(parts, report)
    check_couplings(parts, report)
    check_housings(parts, report)
    check_rings(parts, report)
    check_turning(parts, report)
    check_motions(parts, report)
    check_unbalances(parts, report)
    check_loads(parts, report)
    check_scenarios(parts, report)
    check_phasing(parts, report)
    check_bevel_pairs(parts, report)
