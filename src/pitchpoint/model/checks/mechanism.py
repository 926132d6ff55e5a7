# SPDX-License-Identifier: Apache-2.0
"""Checks of the whole mechanism: what hangs where, whether places meet, what gears and bearings need."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.assembly import all_linked_known
from pitchpoint.model.checks.forces import TURNING
from pitchpoint.model.checks.mobility import check_inertia
from pitchpoint.model.components.joint import FUNCTIONS
from pitchpoint.model.components.ratio import Arm
from pitchpoint.model.frames import (
    GROUND,
    Array,
    axes_of,
    body_frame,
    joint_axes,
    joint_place,
    marker_of,
    place_of,
    split,
)
from pitchpoint.model.keys import Place
from pitchpoint.model.mechanism import (
    COUNTED,
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
"""Distance of two markers over the size of the machine, and angle [rad], up to which they count as one."""


def check_mechanism(parts: Parts, report: Reader) -> None:
    """Everything about tree and loops, once bodies are placed."""
    if any(set(getattr(parts, g)) != parts.known(g) or (g,) in report.tainted for g in ("bodies", "joints")):
        return  # what is missing or wrong may be what the rest hangs on
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
        joints = [n for n, j in parts.joints.items() if name in {split(e)[0] for e in j.bodies}]
        if joints and all(parts.joints[n].cut for n in joints):
            message = f"floats: {' and '.join(joints)} have cut: true and carry nothing"
            remedy = f"remove cut: true from {joints[0]}, or give the body motion: torsion"
        elif joints:
            verb = "join" if joints[1:] else "joins"
            message = f"floats: {' and '.join(joints)} {verb} it to bodies that hang on nothing"
            remedy = "join one of them to ground, or give it motion: torsion"
        else:
            message = "floats: no joint carries it, and it gives no motion"
            remedy = "add a joint, such as {type: revolute, bodies: [ground, BODY]}, or give motion: torsion"
        report.problem(("bodies", name), message, remedy=remedy.replace("BODY", name))


def _seats(parts: Parts, report: Reader) -> None:
    """Joints that the tree could not take as they are written."""
    for name, joint in parts.joints.items():
        first, second = (split(e)[0] for e in joint.bodies)
        moved = [b for b in (first, second) if b != GROUND and parts.bodies[b].motion is not None]
        moved = [b for b in moved if not parts.bodies[b].stands_in]  # joints add to the motion of those
        if GROUND in (first, second) and moved:
            report.problem(
                ("bodies", moved[0], "motion"),
                f"defines how {moved[0]} moves against ground, and so does the joint {name}",
                value=str(parts.bodies[moved[0]].motion),
                remedy="leave motion out, or the joint",
            )
            continue
        if joint.type in FUNCTIONS and name in parts.mechanism.cut:
            report.problem(
                ("joints", name, "bodies"),
                f"cannot close a loop with a joint of type {joint.type}: something carries {second} already",
                remedy="write cut: true at another joint of the loop; it moves the second of its bodies",
            )
        seat = parts.mechanism.carrier(name)
        if seat is not None and seat.turned and joint.type in ONE_WAY and (joint.start or joint.speed):
            key = "start" if joint.start else "speed"
            report.problem(
                ("joints", name, key),
                f"counts the other way round: the joint carries {seat.body}, not {seat.parent}",
                remedy=f"write bodies: [{', '.join(reversed(joint.bodies))}] and turn the values round",
            )


def _rigid(parts: Parts) -> dict[str, str]:
    """For every body the first one that it cannot move against, by fixed joints of the tree."""
    group = {GROUND: GROUND}
    for name, seat in parts.mechanism.seats.items():
        group[name] = group.get(seat.parent, seat.parent) if seat.kind == "fixed" else name
    return group


def _cuts(parts: Parts, report: Reader) -> None:
    """Joints that close loops between bodies that cannot move, and values that they have no room for."""
    group = _rigid(parts)
    for name in parts.mechanism.cut:
        joint = parts.joints[name]
        first, second = (split(e)[0] for e in joint.bodies)
        if group[first] == group[second] and rows_of(joint) > 0 and joint.type not in FUNCTIONS:
            report.problem(
                ("joints", name, "bodies"),
                f"join {first} and {second}, which fixed joints hold together already",
                value=" and ".join(joint.bodies),
                remedy="leave it out, or one of the fixed joints",
            )
        for key in ("start", "speed"):
            if getattr(joint, key):
                report.problem(
                    ("joints", name, key),
                    "belongs to a joint that closes a loop and has no coordinates of its own",
                    remedy="give it to the other joints of the loop, or write cut: true at one of them",
                )


def _placed(parts: Parts, report: Reader) -> None:
    """Every joint has a place; reported for those from which the others would follow."""
    if not all_linked_known(parts, report):
        return  # what broke before would have given it
    lost = {n: j for n, j in parts.joints.items() if joint_place(parts, j) is None}
    near = [n for n, j in lost.items() if any(place_of(parts, e) is not None for e in j.bodies)]
    for name in near or list(lost)[:1]:
        report.problem(
            ("joints", name, "position"),
            "is missing: neither a marker nor a body defines where the joint is",
            remedy="give position: [x, y, z], or a marker of a body with a place",
        )


def _size(parts: Parts) -> float:
    """Extent of the machine [m]."""
    places = [p for j in parts.joints.values() if (p := joint_place(parts, j)) is not None]
    places += [np.array(b.origin) for b in parts.bodies.values() if b.origin is not None]
    return max(1e-3, float(np.ptp(np.array(places), axis=0).max())) if places else 1e-3


def _meet(parts: Parts, report: Reader) -> None:
    """The markers of a joint meet where the joint is, and their frames agree."""
    size = _size(parts)
    for name, joint in parts.joints.items():
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
                    f"do not meet: {end} lies {apart * 1e3:.6g} mm from the joint"
                    if where == "bodies"
                    else f"lies {apart * 1e3:.6g} mm from {end}",
                    value=_shown(place) if where == "position" else " and ".join(joint.bodies),
                    remedy=f"correct a place, or leave the position of {split(end)[0]} out: it follows",
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
                remedy="correct the axes of a marker, or turn the body by its axes; start turns the joint",
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
                "lie at one place, so the rod has no direction",
                value=" and ".join(rod.ends),
                remedy="correct the markers, or join the bodies by a spherical joint",
            )


# --- what needs an axis -------------------------------------------------------------------------------------
def _axes(parts: Parts, report: Reader) -> None:
    """Gears, bearings, couplings and loads act about the z axis of a body: it must be that of its joint."""
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
                    f"needs the z axis of {name}, which is not that of its joint {seat.joint}",
                    remedy=f"put the origin of {name} on the axis of {seat.joint} and its z axis along it",
                )
        turning = [("loads", n, "body") for n, p in parts.loads.items() if p.body == name and p.torque]
        turning += [
            (g, n, "bodies") for g in TURNING for n, p in getattr(parts, g).items() if name in p.bodies
        ]
        for at in turning:
            if not _parallel(parts, seat):
                report.problem(
                    at,
                    f"turns about the z axis of {name}, which is not that of the joint {seat.joint}",
                    remedy=f"give {name} axes whose z lies along the axis of {seat.joint}",
                )


def _polar(parts: Parts, report: Reader) -> None:
    """A polar inertia alone is enough for bodies that turn about their own axis, and for no others."""
    for name, seat in parts.mechanism.seats.items():
        body = parts.bodies[name]
        if seat.joint is None or not body.is_round or body.inertia is None or body.gears or body.bevel_gears:
            continue
        if body.solid is not None:
            continue
        if body.transverse_inertia is None and axial_offset(parts, seat) is None:
            report.problem(
                ("bodies", name, "inertia"),
                f"does not define the inertia about the axis of {seat.joint}, not the z axis of {name}",
                remedy="give inertia_tensor about the centre of mass, or also transverse_inertia",
            )


def _parallel(parts: Parts, seat: Seat) -> bool:
    own = body_frame(parts, seat.body)[1]
    return bool(own[:, 2] @ seat_frame(parts, seat)[1][:, 2] > 1.0 - 1e-12)


def _gear_axis(parts: Parts, name: str, seat: Seat, report: Reader) -> None:
    """Gears turn about the z axis of their body: the joint that carries it lies there and counts turns."""
    body = parts.bodies[name]
    at: Place = ("bodies", name, "gears" if body.gears else "bevel_gears")
    carried = ", ".join((*body.gears, *body.bevel_gears))
    if seat.kind == "fixed" and seat.joint is not None and spinner_of(parts, parts.mechanism, name) is None:
        _standing_gear(parts, name, seat, report)
    if seat.kind in ("spherical", "free", "universal", *FUNCTIONS):
        report.problem(
            at,
            f"cannot turn with a joint of type {seat.kind}, which counts no turns",
            value=carried,
            remedy="carry the body by a revolute, cylindrical, screw, planar or shaft joint",
        )
    elif seat.joint is not None and axial_offset(parts, seat) is None:
        more = f"; write its bodies as [{seat.parent}, {name}]" if seat.turned else ""
        report.problem(
            at,
            f"turn about the z axis of {name}, which is not that of the joint {seat.joint}",
            value=carried,
            remedy=f"give {name} an origin on the axis of {seat.joint}, and axes whose z lies along it{more}",
        )


def _standing_gear(parts: Parts, name: str, seat: Seat, report: Reader) -> None:
    """A gear that is fixed to something does not turn, or turns with a body about the same axis."""
    root = seat
    while root.kind == "fixed" and root.parent in parts.mechanism.seats:
        root = parts.mechanism.seats[root.parent]
    if root.kind in ("fixed", "prismatic"):
        return
    remedy = f"give {name} and {root.body} the same z axis"
    if root.kind not in COUNTED:
        remedy = f"carry {root.body} by a revolute, cylindrical, screw, planar or shaft joint"
        if root.body in parts.elastic_bodies:
            remedy = (
                f"write rotor: true at the elastic body {root.body}, whose z axis is the axis of the gears"
            )
    report.problem(
        ("bodies", name, "gears"),
        f"are fixed to {root.body}, which counts no turns about their axis",
        value=", ".join((*parts.bodies[name].gears, *parts.bodies[name].bevel_gears)),
        remedy=remedy,
    )


# --- coordinates --------------------------------------------------------------------------------------------
def _coordinates(parts: Parts, report: Reader) -> None:
    """Coordinates that scenarios drive by name; those named by a body are checked with the scenario."""
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
                    f"drives a coordinate that is {'a turn' if found[2] == 'angle' else 'a travel'}",
                    remedy=f"give {' or '.join(wanted)}",
                )


def coordinates_listed(parts: Parts) -> str:
    """All coordinates that can be named."""
    found = [
        f"{seat.joint}.{word}"
        for seat in parts.mechanism.seats.values()
        if seat.joint is not None
        for word in seat.coordinates
        if not isinstance(coordinate(parts.mechanism, parts, f"{seat.joint}.{word}"), str)
    ]
    return f"there are {', '.join(found)}" if found else "there is none; a body is named for its spin"


def _ratios(parts: Parts, report: Reader) -> None:
    """Terms are coordinates, and all of them have one dimension."""
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
                "add up angles and lengths",
                value=shown,
                remedy="give turns a radius, such as 30 mm, and travels a plain number, such as -1",
            )
