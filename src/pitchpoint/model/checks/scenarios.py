# SPDX-License-Identifier: Apache-2.0
"""Checks of scenarios."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.units import format_quantity
from pitchpoint.core.words import listed
from pitchpoint.model.carried_trains import has_carriers
from pitchpoint.model.checks.choices import exactly_one
from pitchpoint.model.checks.inputs import check_inputs
from pitchpoint.model.checks.references import known, speed_as_written
from pitchpoint.model.components.law import Constant, PythonLaw
from pitchpoint.model.keys import Place
from pitchpoint.model.locked_loops import locked_loops, loop_with
from pitchpoint.model.mechanism import coordinate
from pitchpoint.model.planet_places import axis_bodies
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.speed_ratios import (
    SPEED_TOLERANCE,
    fixed_bodies,
    geared_body,
    links_of,
    locked_links,
    start_speeds,
    sweep_meshes,
    train_of,
)
from pitchpoint.model.torsional_supports import closed_at_start

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.scenario import Drive, Scenario, Sweep

MAX_STEPS = 1e12
"""Maximum number of steps of a run; more indicate a wrong time step or sampling rate."""


def check_scenarios(parts: Parts, report: Reader) -> None:
    """Check all scenarios."""
    for name, scenario in parts.scenarios.items():
        at: Place = ("scenarios", name)
        if not parts.bodies and ("bodies",) not in report.tainted and not parts.known("bodies"):
            report.problem(at, "requires bodies, and the file has none", remedy="add bodies with the gears")
            continue
        _names(parts, scenario, at, report)
        _engaged(parts, scenario, (*at, "engaged"), report)
        check_inputs(parts, scenario, (*at, "inputs"), report)
        _speeds(parts, scenario, at, report)
        if at in report.tainted:
            continue
        if scenario.long_step is not None:
            _long_step(scenario, (*at, "long_step"), report)
        if scenario.kind == "time":
            _time(scenario, at, report)
        elif scenario.sweep is not None:
            _sweep(parts, scenario, (*at, "sweep"), report)
        if scenario.sweep is not None and scenario.quasi_static is not None:
            report.problem(at, "has both sweep and quasi_static", remedy="split it into two scenarios")


def _names(parts: Parts, scenario: Scenario, at: Place, report: Reader) -> None:
    for key in ("speed", "drive", "hold"):
        for body in getattr(scenario, key):
            if key == "drive" and "." in body:
                continue  # a coordinate of a joint, see `checks.mechanism`
            place = (*at, key, body) if key != "hold" else (*at, key)
            if known(parts, "bodies", body, place, report):
                _turns(parts, body, place, report)
    for body, drive in scenario.drive.items():
        _ripple(drive, (*at, "drive", body), report)
        if scenario.sweep is not None and drive.ripple:
            continue  # see `_sweep`
        keys = ("speed", "angle", "velocity", "position") if "." in body else ("speed", "angle")
        exactly_one(drive, keys, (*at, "drive", body), report)
    if scenario.sweep is not None and known(
        parts, "bodies", scenario.sweep.body, (*at, "sweep", "body"), report
    ):
        _turns(parts, scenario.sweep.body, (*at, "sweep", "body"), report)
    for key in ("sweep", "quasi_static"):
        part = getattr(scenario, key)
        if part is not None and part.mesh is not None and part.mesh not in parts.known("bevel_meshes"):
            known(parts, "meshes", part.mesh, (*at, key, "mesh"), report)
    count = len(parts.meshes) + len(parts.bevel_meshes)
    if scenario.quasi_static is not None and scenario.quasi_static.mesh is None and count != 1:
        names = sorted(parts.known("meshes") | parts.known("bevel_meshes"))
        report.problem(
            (*at, "quasi_static", "mesh"),
            f"is missing, and there are {count} meshes",
            remedy=f"name one of {', '.join(names) or 'them'}",
        )


def _engaged(parts: Parts, scenario: Scenario, at: Place, report: Reader) -> None:
    """Check the engaged clutches: their names, and that their capacity is not zero at the start."""
    names = scenario.engaged or ()
    for k, name in enumerate(names):
        if not known(parts, "clutches", name, at, report) or name not in parts.clutches:
            continue
        if name in names[:k]:
            report.problem(at, f"names {name} twice", remedy="name each clutch once")
        elif not closed_at_start(parts.clutches[name].capacity):
            report.problem(
                at,
                f"names {name}, whose capacity is zero at the start",
                limit="> 0 N m",
                remedy=f"give clutches.{name}.capacity its value of the engaged clutch",
            )


def _ripple(drive: Drive, at: Place, report: Reader) -> None:
    """Check the waves of a ripple: a rotation that does not reverse."""
    at = (*at, "ripple")
    if drive.ripple and (drive.velocity is not None or drive.position is not None):
        report.problem(at, "applies to rotations only", remedy="add the waves to the velocity or position")
    share = sum(wave.order * wave.amplitude for wave in drive.ripple.values())
    if share >= 1.0 and at not in report.tainted:
        report.problem(
            at,
            "reverses the rotation: the amplitudes of the speed add up to more than the mean speed",
            value=f"{100.0 * share:.4g} %",
            limit="< 100 %",
            remedy="reduce fluctuation or angle; a wave of the angle changes the speed by order times angle",
        )


def _turns(parts: Parts, body: str, at: Place, report: Reader) -> None:
    """Check that a body on a joint has a spin coordinate."""
    if body not in parts.bodies or parts.bodies[body].moves != "joint":
        return
    found = coordinate(parts.mechanism, parts, body)
    if isinstance(found, str):
        report.problem(at, found, remedy="name a body with a spin, or drive a coordinate of its joint")


def _speeds(parts: Parts, scenario: Scenario, at: Place, report: Reader) -> None:
    free = {b: s for b, s in scenario.speed.items() if b not in scenario.drive}
    _locked(parts, scenario, at, report)
    for body in scenario.speed:
        part = parts.bodies.get(body)
        if part is not None and part.moves == "fixed" and scenario.speed[body] != 0.0:
            report.problem((*at, "speed", body), "is not zero, but the body is fixed", remedy="remove it")
    for k, body in enumerate(scenario.hold):
        if body in scenario.drive:
            report.problem(
                (*at, "hold"), f"names {body}, which is driven", remedy="hold or drive it, not both"
            )
        if body in scenario.hold[:k]:
            report.problem((*at, "hold"), f"names {body} twice", remedy="name each body once")
    for key, bodies in (("drive", tuple(scenario.drive)), ("hold", scenario.hold)):
        for body in bodies:
            if body in parts.bodies and parts.bodies[body].moves == "fixed":
                report.problem(
                    (*at, key, body) if key == "drive" else (*at, key),
                    f"names {body}, which is fixed and cannot rotate",
                    remedy="remove it, or give the body motion: torsion",
                )
    for body, drive in scenario.drive.items():
        if body in scenario.speed and isinstance(drive.speed, Constant):
            given, driven = scenario.speed[body], drive.speed.value
            if abs(given - driven) > SPEED_TOLERANCE * abs(driven):
                report.problem(
                    (*at, "speed", body),
                    "differs from the speed of the drive",
                    value=speed_as_written(given, (*at, "speed", body), report),
                    limit=speed_as_written(driven, (*at, "speed", body), report),
                    remedy="remove it: a driven body starts at the speed of its drive",
                )
        if isinstance(drive.value, PythonLaw):
            key, rate = ("angle", "speed") if drive.angle is not None else ("position", "velocity")
            report.problem(
                (*at, "drive", body, key),
                f"is a Python function; only a {rate} can be one, its {key} follows without differencing",
                remedy=f"give {rate}: {{python: ...}}, or the {key} as a formula or table",
            )
    constant = {b: d.speed.value for b, d in scenario.drive.items() if isinstance(d.speed, Constant)}
    if scenario.engaged:  # without engaged clutches, drives may differ
        free |= {b: speed for b, speed in constant.items() if b in parts.bodies}
    for body, fitting in start_speeds(parts, free, (), scenario.engaged)[1]:
        place: Place = (*at, "drive", body, "speed") if body in constant else (*at, "speed", body)
        if place in report.tainted:
            continue  # locked
        with_clutches = f" with {listed(scenario.engaged)} engaged" if scenario.engaged else ""
        report.problem(
            place,
            f"does not match the gear ratio to the other given speeds{with_clutches}"
            if len(free) > 1 or not with_clutches
            else f"cannot be: the train is locked{with_clutches}",
            value=speed_as_written(free[body], place, report),
            limit=speed_as_written(fitting, place, report),
            remedy="correct or remove it; the other speeds follow from the gear ratios (a drive may differ)"
            if not with_clutches
            else "correct it, or the clutches of engaged",
        )


def _locked(parts: Parts, scenario: Scenario, at: Place, report: Reader) -> None:
    """Report non-zero speeds in gear trains that are locked by contradicting ratios or fixed bodies."""
    if parts.mechanism.floating:  # reported already: their speeds are unknown
        return
    turned: dict[str, Place] = {b: (*at, "speed", b) for b, speed in scenario.speed.items() if speed != 0.0}
    turned |= {b: (*at, "drive", b) for b in scenario.drive}
    if scenario.sweep is not None:
        turned[scenario.sweep.body] = (*at, "sweep", "body")
    reported: set[Place] = set()
    fixed = fixed_bodies(parts)
    links = links_of(parts)
    linked = {body for link in links for body in link[1:3]}
    plain = not has_carriers(parts, links)
    for body, place in turned.items():
        if body not in parts.bodies or body not in linked or body in fixed:
            continue
        locked = locked_links(parts, body)
        if plain and not locked:  # the other bodies of its train are not locked either
            linked -= train_of(parts, body)
        for link, one, two, _ in locked:
            if link in reported:
                continue
            reported.add(link)
            still = {one, two} & fixed
            where = ".".join(map(str, link))
            loop = None if still else loop_with(locked_loops(parts), link)
            if still:
                what = f"{where} connects its gear train to {still.pop()}, which is fixed"
                remedy = "set the speed to zero, or give the fixed body another motion"
            elif held := _held_members(parts, link, fixed):
                what = f"{listed(held)} of its planetary stage are fixed"
                remedy = f"give {' or '.join(held)} another motion, or set the speed to zero"
            else:
                what = f"{where} locks {one} and {two}: other meshes and couplings give a different ratio"
                if loop is not None:  # one message for the whole loop
                    reported |= {loop.link, *loop.through}
                    (one, two), (own, others) = loop.bodies, loop.words
                    where = ".".join(map(str, loop.link))
                    what = f"{where} locks {one} and {two}: {own}, but {others}"
                remedy = "correct a number of teeth, remove one link of the loop, or set the speed to zero"
            report.problem(place, f"cannot rotate {body}: {what}", remedy=remedy)


def _held_members(parts: Parts, link: Place, fixed: set[str]) -> list[str]:
    """Fixed members of the planetary stage of a mesh, if they leave no member free to rotate."""
    mesh = parts.meshes.get(str(link[1])) if link[0] == "meshes" else None
    stage = None if mesh is None else parts.planetary_stages.get(str(mesh.stage))
    held = [] if stage is None else [body for body in axis_bodies(parts, stage) if body in fixed]
    return held if len(held) > 1 else []


def _long_step(scenario: Scenario, at: Place, report: Reader) -> None:
    """Check the step of the bodies outside of gear trains."""
    if scenario.kind != "time" or scenario.method != "generalized_alpha":
        kind = scenario.method if scenario.kind == "time" else f"a scenario with {scenario.kind}"
        report.problem(at, f"is not available with {kind}", remedy="remove it, or use generalized_alpha")
    elif scenario.step is None:
        report.problem(at, "requires step, the time step of the gear trains", remedy="add step: 0.1 ms")
    elif scenario.long_step is not None and scenario.long_step < scenario.step * (1.0 - SPEED_TOLERANCE):
        report.problem(
            at,
            "is shorter than step, the time step of the gear trains",
            value=f"{scenario.long_step:g} s",
            limit=f">= {scenario.step:g} s",
        )


def _time(scenario: Scenario, at: Place, report: Reader) -> None:
    if scenario.duration is None:
        report.problem(
            (*at, "duration"), "is missing", remedy="add duration: 0.5 s (or sweep, or quasi_static)"
        )
        return
    if scenario.form == "SI1" and scenario.method == "generalized_alpha":
        report.problem(
            (*at, "form"),
            "is not available with generalized_alpha",
            value="SI1",
            limit="I3 or SI2",
            remedy="write form: SI2, or a stiff method such as gstiff",
        )
    if scenario.settle_time is not None and scenario.settle_time >= scenario.duration:
        report.problem(
            (*at, "settle_time"),
            "leaves no time for the statistics",
            value=f"{scenario.settle_time:g} s",
            limit=f"< {scenario.duration:g} s",
            remedy="shorten it or lengthen duration",
        )
    window = scenario.duration - scenario.statistics_start
    if scenario.step is not None and scenario.step > 0.5 * window > 0.0:
        report.problem(
            (*at, "step"),
            "is longer than half the evaluated time, from settle_time to duration",
            value=f"{scenario.step:g} s",
            limit=f"<= {0.5 * window:g} s",
            remedy="reduce it, or remove it",
        )
    for key, count in (
        ("step", scenario.duration / scenario.step if scenario.step else 0.0),
        ("sample_rate", scenario.duration * (scenario.sample_rate or 0.0)),
    ):
        if count > MAX_STEPS:
            report.problem(
                (*at, key),
                f"gives {count:.2g} steps for the duration",
                limit=f"<= {MAX_STEPS:g} steps",
                remedy=f"correct {key} or duration, or remove {key}",
            )


def _range(sweep: Sweep, at: Place, report: Reader) -> None:
    """Check the range of a sweep: rotation in one direction, from the lowest to the highest magnitude."""
    if sweep.mesh_frequency is not None and sweep.mesh_frequency[0] >= sweep.mesh_frequency[1]:
        report.problem(
            (*at, "mesh_frequency"),
            "is not increasing",
            remedy="write [lowest, highest]; direction gives the order",
        )
    if sweep.speed is None:
        return
    first, last = sweep.speed
    if first * last <= 0.0:
        what = "contains zero" if first == 0.0 or last == 0.0 else "reverses the rotation"
        report.problem(
            (*at, "speed"),
            f"{what}, and a sweep has one direction of rotation",
            value=" to ".join(format_quantity(one, "angular_speed", 5) for one in sweep.speed),
            limit="both > 0 or both < 0",
            remedy="write one sweep for each direction of rotation, from a speed other than zero",
        )
    elif abs(first) >= abs(last):
        report.problem(
            (*at, "speed"),
            "does not increase in magnitude",
            remedy="write the lowest magnitude first, such as [600 rpm, 1800 rpm] or [-600 rpm, -1800 rpm]; "
            "direction gives the order",
        )


def _sweep(parts: Parts, scenario: Scenario, at: Place, report: Reader) -> None:
    sweep = scenario.sweep
    if sweep is None:
        return
    timed = [b for b, d in scenario.drive.items() if not (d.ripple and d.rate is None and d.value is None)]
    if timed:
        report.problem(
            (*at[:-1], "drive"),
            "cannot be combined with sweep, which prescribes the speed itself",
            remedy=f"write hold: [{', '.join(timed)}] for bodies that keep the speed of each point, or give "
            "a drive with ripple only",
        )
    _range(sweep, at, report)
    if ("meshes",) in report.tainted or ("bodies",) in report.tainted:
        return
    geared = geared_body(parts, sweep.body) or sweep.body
    own = parts.bodies[geared].gears if geared in parts.bodies else {}
    if not parts.gears.keys() >= set(own):
        return  # an unreadable gear may be the one in mesh
    teeth = sweep_meshes(parts, sweep.body)
    every = {**parts.meshes, **parts.bevel_meshes}
    if not teeth:
        report.problem(
            (*at, "body"),
            f"names {sweep.body}, which has no gear in mesh and is not coupled to a body with one",
            remedy="name a body with a gear in mesh",
        )
    elif sweep.mesh is None and len(set(teeth.values())) > 1:
        report.problem(
            (*at, "mesh"),
            f"is missing, and {sweep.body} has several meshes with different frequencies",
            remedy=f"name one of {', '.join(teeth)}",
        )
    elif sweep.mesh is not None and sweep.mesh not in teeth and sweep.mesh in every:
        report.problem(
            (*at, "mesh"),
            f"names {sweep.mesh}, which is not a mesh of {sweep.body}",
            remedy=f"name one of {', '.join(teeth)}",
        )
