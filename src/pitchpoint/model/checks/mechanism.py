# SPDX-License-Identifier: Apache-2.0
"""Checks of the mechanism: kinematic tree, joint positions and axes, axes of gears and bearings."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.assembly import all_linked_known
from pitchpoint.model.checks.fixed_gears import check_standing_gear
from pitchpoint.model.checks.forces import TURNING
from pitchpoint.model.checks.mobility import check_inertia
from pitchpoint.model.components.joint import FUNCTIONS
from pitchpoint.model.components.ratio import Arm
from pitchpoint.model.frames import (
    GROUND,
    Array,
    axes_of,
    bodies_of,
    body_frame,
    joint_axes,
    joint_place,
    marker_of,
    place_of,
    split,
)
from pitchpoint.model.keys import Place
from pitchpoint.model.mechanism import (
    ONE_WAY,
    Seat,
    axial_offset,
    coordinate,
    rows_of,
    seat_frame,
    spinner_of,
)
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

CLOSE = 1e-6
"""Tolerance of the distance of two markers, relative to the size of the model, and of angles [rad]."""


def check_mechanism(parts: Parts, report: Reader) -> None:
    """Check tree and loops after the bodies have been located."""
    if any(set(getattr(parts, g)) != parts.known(g) or (g,) in report.tainted for g in ("bodies", "joints")):
        return  # other parts may depend on what is missing or wrong
    before = len(report.problems)
    _floating(parts, report)
    _seats(parts, report)
    _cuts(parts, report)
    _placed(parts, report)
    if len(report.problems) > before or any(b.origin is None for b in parts.bodies.values()):
        return
    _meet(parts, report)
    _rods(parts, report)
    _axes(parts, report)
    _polar(parts, report)
    _coordinates(parts, report)
    _ratios(parts, report)
    if not report.problems:
        check_inertia(parts, report)


def _floating(parts: Parts, report: Reader) -> None:
    for name in parts.mechanism.floating:
        stage = parts.planetary_stages.get(parts.bodies[name].stage or "")
        if stage is not None and stage.carrier in parts.mechanism.floating:
            continue  # planets float with their carrier
        joints = [n for n, j in parts.joints.items() if name in {split(e)[0] for e in j.bodies}]
        if joints and all(parts.joints[n].cut for n in joints):
            message = f"floats: {' and '.join(joints)} have cut: true and carry no body"
            remedy = f"remove cut: true from {joints[0]}, or give the body motion: torsion"
        elif joints:
            verb = "connect" if joints[1:] else "connects"
            message = f"floats: {' and '.join(joints)} {verb} it only to other floating bodies"
            remedy = "connect one of them to ground, or give it motion: torsion"
        else:
            message = "floats: it has neither a joint nor a motion"
            remedy = "add a joint, such as {type: revolute, bodies: [ground, BODY]}, or give motion: torsion"
        report.problem(("bodies", name), message, remedy=remedy.replace("BODY", name))


def _seats(parts: Parts, report: Reader) -> None:
    """Report joints that do not fit into the tree."""
    for name, joint in parts.joints.items():
        first, second = (split(e)[0] for e in joint.bodies)
        moved = [b for b in (first, second) if b in parts.bodies and parts.bodies[b].motion is not None]
        moved = [b for b in moved if not parts.bodies[b].stands_in]  # joints add to their motion
        if GROUND in (first, second) and moved:
            report.problem(
                ("bodies", moved[0], "motion"),
                f"defines the motion of {moved[0]} against ground, as does the joint {name}",
                value=str(parts.bodies[moved[0]].motion),
                remedy="remove motion or the joint",
            )
            continue
        if joint.type in FUNCTIONS and name in parts.mechanism.cut:
            report.problem(
                ("joints", name, "bodies"),
                f"cannot close a loop with a joint of type {joint.type}: another joint carries {second}",
                remedy="write cut: true at another joint of the loop; it moves the second of its bodies",
            )
        seat = parts.mechanism.carrier(name)
        if seat is not None and seat.turned and joint.type in ONE_WAY and (joint.start or joint.speed):
            key = "start" if joint.start else "speed"
            report.problem(
                ("joints", name, key),
                f"has the opposite sense: the joint carries {seat.body}, not {seat.end}",
                remedy=f"write bodies: [{', '.join(reversed(joint.bodies))}] and reverse the values",
            )


def _rigid(parts: Parts) -> dict[str, str]:
    """For every body the first body that it is rigidly connected to by fixed joints of the tree."""
    group = {GROUND: GROUND}
    for name, seat in parts.mechanism.seats.items():
        rigid = seat.kind == "fixed" and seat.beam is None
        group[name] = group.get(seat.parent, seat.parent) if rigid else name
    return group


def _cuts(parts: Parts, report: Reader) -> None:
    """Report cut joints between rigidly connected bodies, and initial values of cut joints."""
    group = _rigid(parts)
    for name in parts.mechanism.cut:
        joint = parts.joints[name]
        first, second = (split(e)[0] for e in joint.bodies)
        rigid = first != second and group.get(first, first) == group.get(second, second)
        if rigid and rows_of(joint) > 0 and joint.type not in FUNCTIONS:
            report.problem(
                ("joints", name, "bodies"),
                f"connect {first} and {second}, which are already connected by fixed joints",
                value=" and ".join(joint.bodies),
                remedy="remove it, or one of the fixed joints",
            )
        for key in ("start", "speed"):
            if getattr(joint, key):
                report.problem(
                    ("joints", name, key),
                    "is not possible for a joint that closes a loop: it has no independent coordinates",
                    remedy="give it to the other joints of the loop, or write cut: true at one of them",
                )


def _placed(parts: Parts, report: Reader) -> None:
    """Check that every joint has a position; reported for joints that would locate the others."""
    if not all_linked_known(parts, report):
        return  # a consequence of problems reported before
    lost = {n: j for n, j in parts.joints.items() if joint_place(parts, j) is None}
    near = [n for n, j in lost.items() if any(place_of(parts, e) is not None for e in j.bodies)]
    for name in near or list(lost)[:1]:
        report.problem(
            ("joints", name, "position"),
            "is missing: neither a marker nor a body defines the position of the joint",
            remedy="give position: [x, y, z], or a marker of a body of known position",
        )


def _size(parts: Parts) -> float:
    """Size of the model [m]."""
    places = [p for j in parts.joints.values() if (p := joint_place(parts, j)) is not None]
    places += [np.array(b.origin) for b in parts.bodies.values() if b.origin is not None]
    return max(1e-3, float(np.ptp(np.array(places), axis=0).max())) if places else 1e-3


def _meet(parts: Parts, report: Reader) -> None:
    """Check that the markers of a joint coincide with it and that their axes agree."""
    size = _size(parts)
    for name, joint in parts.joints.items():
        if joint.stage is not None:
            continue  # `check_pins` of the stage
        at: Place = ("joints", name)
        place = joint_place(parts, joint)
        for end in joint.bodies:
            there = place_of(parts, end)
            if place is None or there is None or not split(end)[1]:
                continue
            apart = float(np.linalg.norm(there - place))
            if apart > CLOSE * size:
                where = "position" if joint.position is not None else "bodies"
                report.problem(
                    (*at, where),
                    f"do not coincide: {end} is {apart * 1e3:.6g} mm from the joint"
                    if where == "bodies"
                    else f"is {apart * 1e3:.6g} mm from {end}",
                    value=_shown(place) if where == "position" else " and ".join(joint.bodies),
                    remedy=f"correct a position, or remove that of {split(end)[0]}: it follows",
                )
        _frames_agree(parts, name, report)


def _frames_agree(parts: Parts, name: str, report: Reader) -> None:
    joint = parts.joints[name]
    reference = joint_axes(parts, joint)
    for end in joint.bodies:
        marker = marker_of(parts, end)
        if marker is None or marker.axes is None:
            continue
        own = axes_of(parts, end)
        both_x = marker.axes.x is not None and (joint.axes is None or joint.axes.x is not None)
        columns = (2, 0) if both_x else (2,)
        angle = max(
            math.atan2(np.linalg.norm(np.cross(a, b)), a @ b)
            for a, b in ((own[:, c], reference[:, c]) for c in columns)
        )
        if angle > CLOSE:
            report.problem(
                ("joints", name, "bodies" if joint.axes is None else "axes"),
                f"do not agree with the axes of {end}, which are tilted by {math.degrees(angle):.6g} deg",
                limit="0 deg where all coordinates are zero",
                remedy="correct the axes of a marker, or rotate the body by `axes`; start rotates the joint",
            )
            return


def _shown(place: Array) -> str:
    return f"[{', '.join(f'{v * 1e3:.6g}' for v in place)}] mm"


def _rods(parts: Parts, report: Reader) -> None:
    for name, rod in parts.rods.items():
        ends = [place_of(parts, e) for e in rod.ends]
        if ends[0] is None or ends[1] is None or ("rods", name) in report.tainted:
            continue
        if rod.length is None and float(np.linalg.norm(ends[0] - ends[1])) <= CLOSE * _size(parts):
            report.problem(
                ("rods", name, "ends"),
                "coincide, so the rod has no direction",
                value=" and ".join(rod.ends),
                remedy="correct the markers, or connect the bodies by a spherical joint",
            )


# --- elements on axes -------------------------------------------------------------------------------------
def _axes(parts: Parts, report: Reader) -> None:
    """Check that the z axis of bodies with gears, bearings, couplings or loads is the axis of their joint."""
    for name, seat in parts.mechanism.seats.items():
        body = parts.bodies[name]
        if body.gears or body.bevel_gears:
            _gear_axis(parts, name, seat, report)
        if seat.joint is None or axial_offset(parts, seat) is not None:
            continue
        for group, key, users in (
            ("bearings", "body", [n for n, b in parts.bearings.items() if b.body == name]),
            ("couplings", "bodies", [n for n, c in parts.couplings.items() if name in c.bodies]),
            (
                "loads",
                "body",
                [n for n, p in parts.loads.items() if p.body == name and p.force and not p.marker],
            ),
        ):
            for user in users:
                report.problem(
                    (group, user, key),
                    f"acts on the z axis of {name}, which is not the axis of its joint {seat.joint}",
                    remedy=f"put the origin of {name} on the axis of {seat.joint} and its z axis along it",
                )
        turning = [("loads", n, "body") for n, p in parts.loads.items() if p.body == name and p.torque]
        for group in TURNING:
            elements = getattr(parts, group).items()
            turning += [(group, n, "bodies") for n, p in elements if name in bodies_of(p.bodies)]
        for at in turning:
            if not _parallel(parts, seat):
                report.problem(
                    at,
                    f"acts about the z axis of {name}, which is not the axis of the joint {seat.joint}",
                    remedy=f"give {name} axes with z along the axis of {seat.joint}",
                )


def _polar(parts: Parts, report: Reader) -> None:
    """Check that bodies with only a polar inertia rotate about their own axis."""
    for name, seat in parts.mechanism.seats.items():
        body = parts.bodies[name]
        if seat.joint is None or not body.is_round or body.inertia is None or body.gears or body.bevel_gears:
            continue
        if body.solid is not None:
            continue
        if body.transverse_inertia is None and axial_offset(parts, seat) is None:
            report.problem(
                ("bodies", name, "inertia"),
                f"does not define the inertia about the axis of {seat.joint}, which is not "
                f"the z axis of {name}",
                remedy="give inertia_tensor about the centre of mass, or also transverse_inertia",
            )


def _parallel(parts: Parts, seat: Seat) -> bool:
    own = body_frame(parts, seat.body)[1]
    return bool(own[:, 2] @ seat_frame(parts, seat)[1][:, 2] > 1.0 - 1e-12)


def _gear_axis(parts: Parts, name: str, seat: Seat, report: Reader) -> None:
    """Check that gears rotate about the axis of their joint and that the joint counts revolutions."""
    body = parts.bodies[name]
    at: Place = ("bodies", name, "gears" if body.gears else "bevel_gears")
    carried = ", ".join((*body.gears, *body.bevel_gears))
    if seat.kind == "fixed" and seat.joint is not None and spinner_of(parts, parts.mechanism, name) is None:
        check_standing_gear(parts, name, seat, report)
    if seat.kind in ("spherical", "free", "universal", *FUNCTIONS):
        report.problem(
            at,
            f"cannot rotate with a joint of type {seat.kind}, which does not count revolutions",
            value=carried,
            remedy="use a revolute, cylindrical, screw, planar or shaft joint for the body",
        )
    elif seat.joint is not None and axial_offset(parts, seat) is None:
        ends = reversed(parts.joints[seat.joint].bodies)
        more = f"; write its bodies as [{', '.join(ends)}]" if seat.turned else ""
        report.problem(
            at,
            f"rotate about the z axis of {name}, which is not the axis of the joint {seat.joint}",
            value=carried,
            remedy=f"give {name} an origin on the axis of {seat.joint}, and axes with z along it{more}",
        )


# --- coordinates --------------------------------------------------------------------------------------------
def _coordinates(parts: Parts, report: Reader) -> None:
    """Check the joint coordinates driven by scenarios; spins of bodies are checked with the scenarios."""
    for name, scenario in parts.scenarios.items():
        for word, drive in scenario.drive.items():
            if "." not in word:
                continue
            at: Place = ("scenarios", name, "drive", word)
            found = coordinate(parts.mechanism, parts, word)
            if isinstance(found, str):
                report.problem(at, found, remedy=coordinates_listed(parts))
                continue
            wanted = ("speed", "angle") if found[2] == "angle" else ("velocity", "position")
            given = [k for k in ("speed", "angle", "velocity", "position") if getattr(drive, k) is not None]
            wrong = [k for k in given if k not in wanted]
            if wrong:
                report.problem(
                    (*at, wrong[0]),
                    f"drives a {'rotational' if found[2] == 'angle' else 'translational'} coordinate",
                    remedy=f"give {' or '.join(wanted)}",
                )


def coordinates_listed(parts: Parts) -> str:
    """List of all joint coordinates, for messages."""
    found = [
        f"{seat.joint}.{word}"
        for seat in parts.mechanism.seats.values()
        if seat.joint is not None
        for word in seat.coordinates
        if not isinstance(coordinate(parts.mechanism, parts, f"{seat.joint}.{word}"), str)
    ]
    return f"there are {', '.join(found)}" if found else "there is none; name a body for its spin"


def _ratios(parts: Parts, report: Reader) -> None:
    """Check that the terms of ratios are coordinates and have the same dimension."""
    for name, ratio in parts.ratios.items():
        at: Place = ("ratios", name, "terms")
        if at in report.tainted:
            continue
        lengths = {}
        for word, value in ratio.terms.items():
            found = coordinate(parts.mechanism, parts, word)
            if isinstance(found, str):
                report.problem((*at, word), found, remedy=coordinates_listed(parts))
                continue
            lengths[word] = (found[2] == "length") + isinstance(value, Arm)
        if len(lengths) == len(ratio.terms) and len(set(lengths.values())) > 1:
            shown = ", ".join(f"{w}: {('angle', 'length', 'length^2')[k]}" for w, k in lengths.items())
            report.problem(
                at,
                "combine angles and lengths",
                value=shown,
                remedy="give rotations a radius, such as 30 mm, and translations a plain number, such as -1",
            )
