# SPDX-License-Identifier: Apache-2.0
"""Checks of loads, springs, bushings and clutches."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.model.components.law import Balance, Constant, TableLaw
from pitchpoint.model.frames import GROUND, split
from pitchpoint.model.keys import Place
from pitchpoint.model.read import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.body import Body
    from pitchpoint.model.components.load import Load
    from pitchpoint.model.parts import Parts


def check_forces(parts: Parts, report: Reader) -> None:
    """Everything about one of them that more than one key decides."""
    for name, load in parts.loads.items():
        _load(parts, name, load, report)
    for name, bushing in parts.bushings.items():
        if bushing.damping is not None and bushing.damping.ratio is not None:
            report.problem(
                ("bushings", name, "damping", "ratio"),
                "has no meaning: a bushing has no inertia of its own",
                remedy="give radial, axial, tilt and torsion, or a matrix",
            )
    for name, clutch in parts.clutches.items():
        at: Place = ("clutches", name)
        for i, end in enumerate(clutch.bodies):
            if split(end)[1]:
                remedy = f"write {split(end)[0]}: it acts about its axis"
                report.problem((*at, "bodies", i), f"names a marker, {end}", remedy=remedy)
        if clutch.bodies[0] == GROUND:
            report.problem(
                (*at, "bodies"), "names ground first", remedy=f"write [{clutch.bodies[1]}, ground]"
            )
        if isinstance(clutch.capacity, Balance):
            report.problem((*at, "capacity"), "cannot be balanced", remedy="give a torque")
        values = [clutch.capacity.value] if isinstance(clutch.capacity, Constant) else []
        values += clutch.capacity.values if isinstance(clutch.capacity, TableLaw) else []
        if any(v < 0.0 for v in values):
            report.problem(
                (*at, "capacity"), "is negative", limit=">= 0", remedy="leave the sign out: friction brakes"
            )


def check_loads(parts: Parts, report: Reader) -> None:
    """Loads do something, and balance has one meaning."""
    balanced = [n for n, load in parts.loads.items() if isinstance(load.torque, Balance)]
    for name, load in parts.loads.items():
        at: Place = ("loads", name)
        if load.torque is None and load.force is None and at not in report.tainted:
            report.problem(at, "has neither torque nor force", remedy="give torque or force")
        body = parts.bodies.get(load.body)
        if load.force is None or body is None:
            continue
        if any(isinstance(f, Balance) for f in load.force):
            report.problem((*at, "force"), "cannot be balanced", remedy="balance a torque")
        sideways = any(not (isinstance(f, Constant) and f.value == 0.0) for f in load.force)
        if body.moves == "torsion" and sideways and _on_axis(load, body):
            report.problem(
                (*at, "force"),
                f"acts on the axis of {load.body}, which only turns",
                remedy="give the body motion: planar or free, or the load a position off the axis",
            )
    from pitchpoint.model.validate import trains

    for train in trains(parts):
        names = [n for n in balanced if parts.loads[n].body in train]
        for name in names[1:]:
            report.problem(
                ("loads", name, "torque"),
                f"is balance, like that of {names[0]} on the same train; their split is open",
                remedy="give all but one torque as a value",
            )


def _on_axis(load: Load, body: Body) -> bool:
    """Whether a force acts on the axis of its body."""
    if load.marker is None:
        return load.position[:2] == (0.0, 0.0)
    return load.marker in body.markers and body.markers[load.marker].position[:2] == (0.0, 0.0)


def _load(parts: Parts, name: str, load: Load, report: Reader) -> None:
    from pitchpoint.model.validate import known, nearest

    at: Place = ("loads", name)
    if load.reaction is not None:
        if load.reaction == load.body:
            report.problem((*at, "reaction"), f"acts on {load.body} itself", remedy="name another body")
        elif load.reaction != GROUND:
            known(parts, "bodies", load.reaction, (*at, "reaction"), report)
    body = parts.bodies.get(load.body)
    if load.marker is None:
        if load.along == "marker":
            report.problem((*at, "along"), "is marker, and no marker is given", remedy="add marker: NAME")
        return
    if any(load.position):
        report.problem((*at, "position"), "stands beside marker", remedy="give one of the two")
    if load.force is None:
        report.problem((*at, "marker"), "has no effect on a torque", remedy="remove it, or give a force")
    if body is not None and load.marker not in body.markers:
        have = f"there are {', '.join(body.markers)}" if body.markers else f"{load.body} has no markers"
        report.problem(
            (*at, "marker"),
            f"names the marker {load.marker[:40]!r}, which {load.body} does not have",
            remedy=nearest(load.marker, body.markers) + have,
        )
