# SPDX-License-Identifier: Apache-2.0
"""Checks of loads and force elements."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.checks.beam_ends import is_beam
from pitchpoint.model.checks.bearing_faults import check_seat
from pitchpoint.model.checks.references import known, known_end
from pitchpoint.model.checks.rolling_bearings import check_rolling_bearings
from pitchpoint.model.components.law import Balance, Constant, TableLaw
from pitchpoint.model.frames import GROUND, bodies_of, split
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.speed_ratios import trains

if TYPE_CHECKING:
    from pitchpoint.model.components.body import Body
    from pitchpoint.model.components.clutch import Clutch
    from pitchpoint.model.components.load import Load
    from pitchpoint.model.parts import Parts


TURNING = ("torsion_springs", "torsion_maxwells", "clutches")
"""Sections whose elements act about the spin axes of one or two bodies."""


def check_forces(parts: Parts, report: Reader) -> None:
    """Check loads and force elements for contradicting keys."""
    for name, load in parts.loads.items():
        _load(parts, name, load, report)
    for name, bushing in parts.bushings.items():
        if bushing.damping is not None and bushing.damping.ratio is not None:
            report.problem(
                ("bushings", name, "damping", "ratio"),
                "is not defined: a bushing has no inertia",
                remedy="give radial, axial, tilt and torsion, or a matrix",
            )
    _turning(parts, report)
    for name, clutch in parts.clutches.items():
        _capacity(name, clutch, report)
    check_rolling_bearings(parts, report)
    for name, support in parts.bearings.items():
        check_seat(name, support, report)
    _states(parts, report)


def check_unbalances(parts: Parts, report: Reader) -> None:
    """Check that unbalances are on moving bodies with sufficient mass properties."""
    for name, unbalance in parts.unbalances.items():
        at: Place = ("unbalances", name, "body")
        body = parts.bodies.get(unbalance.body)
        if body is not None and body.motion == "fixed":
            report.problem(at, f"names {unbalance.body}, which is fixed", remedy="remove it")
        elif body is not None and _is_polar(body):
            report.problem(
                at,
                f"names {unbalance.body}, which has only a polar moment of inertia",
                remedy=f"also give transverse_inertia of {unbalance.body}",
            )


def _is_polar(body: Body) -> bool:
    """Whether a body has only a polar inertia, but more motion than a spin about its axis on ground."""
    alone = body.is_round and body.inertia is not None and body.transverse_inertia is None
    alone = alone and body.solid is None
    return alone and not body.gears and not body.bevel_gears and body.moves != "torsion"


def _turning(parts: Parts, report: Reader) -> None:
    """Check the bodies of torsional elements."""
    for group in TURNING:
        for name, part in getattr(parts, group).items():
            at: Place = (group, name, "bodies")
            for body in part.bodies:
                if body == GROUND:
                    report.problem(at, "names ground", remedy="give one body only: the other end is ground")
                elif is_beam(parts, split(body)[0]):
                    what = f"names {body}, a place on a beam"
                    report.problem(at, what, remedy="name a body that a joint of type fixed carries there")
                else:
                    known_end(parts, body, at, report)
            bodies = bodies_of(part.bodies)
            if len(set(bodies)) < len(bodies):
                report.problem(at, f"names {bodies[0]} twice", remedy="name two bodies, or only one")


def _capacity(name: str, clutch: Clutch, report: Reader) -> None:
    at: Place = ("clutches", name, "capacity")
    if isinstance(clutch.capacity, Balance):
        report.problem(at, "cannot be balanced", remedy="give a torque")
    values = [clutch.capacity.value] if isinstance(clutch.capacity, Constant) else []
    values += clutch.capacity.values if isinstance(clutch.capacity, TableLaw) else []
    if any(v < 0.0 for v in values):
        report.problem(at, "is negative", limit=">= 0", remedy="give the magnitude: friction always brakes")


def _states(parts: Parts, report: Reader) -> None:
    """Check that elements with internal states have unique names."""
    seen: dict[str, str] = {}
    for group, names in states_of(parts).items():
        for name in names:
            first = seen.setdefault(name, group)
            if first != group:
                report.problem(
                    (group, name), f"has the name of an element of {first}", remedy="choose a unique name"
                )


def states_of(machine: Any) -> dict[str, list[str]]:
    """Names of the elements with internal states, by section."""
    return {
        "maxwells": list(machine.maxwells),
        "torsion_maxwells": list(machine.torsion_maxwells),
        "clutches": [n for n, c in machine.clutches.items() if c.law == "bristles"],
    }


def check_loads(parts: Parts, report: Reader) -> None:
    """Check that loads have an effect and that every gear train has at most one `balance`."""
    balanced = [n for n, load in parts.loads.items() if isinstance(load.torque, Balance)]
    for name, load in parts.loads.items():
        at: Place = ("loads", name)
        given = [key for key in ("torque", "force", "moment") if getattr(load, key) is not None]
        if not given and at not in report.tainted:
            report.problem(at, "has no torque, force or moment", remedy="give one of them")
        for key in ("force", "moment"):
            if any(isinstance(part, Balance) for part in getattr(load, key) or ()):
                report.problem((*at, key), "cannot be balanced", remedy="balance a torque")
        body = parts.bodies.get(load.body)
        if load.force is None or body is None:
            continue
        sideways = any(not (isinstance(f, Constant) and f.value == 0.0) for f in load.force)
        if body.moves == "torsion" and sideways and _on_axis(load, body):
            report.problem(
                (*at, "force"),
                f"acts on the axis of {load.body}, which only rotates",
                remedy="give the body motion: planar or free, or the load a position off the axis",
            )
    for train in trains(parts):
        names = [n for n in balanced if parts.loads[n].body in train]
        for name in names[1:]:
            report.problem(
                ("loads", name, "torque"),
                f"is balance, like that of {names[0]} in the same gear train; their split is undetermined",
                remedy="give all but one torque as a value",
            )


def _on_axis(load: Load, body: Body) -> bool:
    """Whether a force acts on the axis of its body."""
    if load.marker is None:
        return load.position[:2] == (0.0, 0.0)
    return load.marker in body.markers and body.markers[load.marker].position[:2] == (0.0, 0.0)


def _load(parts: Parts, name: str, load: Load, report: Reader) -> None:
    at: Place = ("loads", name)
    if load.reaction is not None:
        if load.reaction == load.body:
            report.problem((*at, "reaction"), f"acts on {load.body} itself", remedy="name another body")
        elif load.reaction != GROUND:
            known(parts, "bodies", load.reaction, (*at, "reaction"), report)
    if is_beam(parts, load.body):
        if load.torque is not None:
            report.problem(
                (*at, "torque"),
                f"acts on the beam {load.body}, which has no spin axis",
                remedy="give a force or a moment",
            )
    else:
        known(parts, "bodies", load.body, (*at, "body"), report, "beams")
    body = parts.bodies.get(load.body)
    if load.marker is None:
        if load.along == "marker":
            report.problem((*at, "along"), "is marker, and no marker is given", remedy="add marker: NAME")
        return
    if any(load.position):
        report.problem((*at, "position"), "cannot be combined with marker", remedy="give one of the two")
    if load.force is None and load.moment is None:
        report.problem(
            (*at, "marker"), "has no effect on a torque", remedy="remove it, or give a force or a moment"
        )
    if body is not None and load.marker not in body.markers:
        have = f"there are {', '.join(body.markers)}" if body.markers else f"{load.body} has no markers"
        report.problem(
            (*at, "marker"),
            f"names the marker {load.marker[:40]!r}, which {load.body} does not have",
            remedy=did_you_mean(load.marker, body.markers) + have,
        )
