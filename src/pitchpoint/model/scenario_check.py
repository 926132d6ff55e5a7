# SPDX-License-Identifier: Apache-2.0
"""Checks of scenarios, and the start speeds that follow from the given ones through the ratios."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from typing import TYPE_CHECKING

from pitchpoint.model.components.law import Constant, PythonLaw
from pitchpoint.model.keys import Place
from pitchpoint.model.read import Reader

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.scenario import Scenario

SPEED_TOLERANCE = 1e-6
"""Relative difference up to which two given speeds fit a gear ratio."""
MOST_STEPS = 1e12
"""Steps of a run beyond which a time step or a sample rate can only be a slip: days of computing."""


Link = tuple[Place, str, str, float]
"""Mesh or coupling by its place, the two bodies it joins, speed of the second per speed of the first."""


def links_of(parts: Parts) -> list[Link]:
    """What gives two bodies a speed ratio: meshes, couplings that carry torque, ratios of two spins."""
    from pitchpoint.model.mechanism import coordinate

    found: list[Link] = []
    for name, mesh in parts.meshes.items():
        bodies = [parts.body_of(g) for g in mesh.gears]
        if None in bodies or bodies[0] == bodies[1] or not all(g in parts.gears for g in mesh.gears):
            continue
        z_1, z_2 = (parts.gears[g].sign * parts.gears[g].number_of_teeth for g in mesh.gears)
        found.append((("meshes", name), str(bodies[0]), str(bodies[1]), -z_1 / z_2))
    found += _bevel_links(parts)
    for name, coupling in parts.couplings.items():
        one, two = coupling.bodies
        if one != two and one in parts.bodies and two in parts.bodies and coupling.carries_torque:
            found.append((("couplings", name), one, two, 1.0))
    for name, spring in parts.torsion_springs.items():
        if len(set(spring.bodies) & set(parts.bodies)) == 2 and spring.stiffness > 0.0:
            found.append((("torsion_springs", name), *spring.bodies, 1.0))
    for name, ratio in parts.ratios.items():
        ends = [coordinate(parts.mechanism, parts, term) for term in ratio.terms]
        spins = [e[0] for e in ends if not isinstance(e, str) and _is_spin(parts, e)]
        if len(spins) == len(ends) == 2:
            c_1, c_2 = ratio.terms.values()
            found.append((("ratios", name), spins[0], spins[1], -c_1 / c_2))
    return found


def _bevel_links(parts: Parts) -> list[Link]:
    """Bevel meshes; spins count about the z axes of bodies, and cones open along these or against them."""
    found: list[Link] = []
    for name, mesh in parts.bevel_meshes.items():
        one, two = (parts.body_of(g) for g in mesh.gears)
        gears = [parts.bevel_gears.get(g) for g in mesh.gears]
        if one is not None and two is not None and one != two and None not in gears:
            z_1, z_2 = (g.direction * g.number_of_teeth for g in gears)  # type: ignore[union-attr]
            found.append((("bevel_meshes", name), one, two, -z_1 / z_2))
    return found


def same_base(parts: Parts, one: str, two: str) -> bool:
    """Whether two bodies hang on the same one, so that their spins count from the same frame."""
    seats = parts.mechanism.seats
    return one not in seats or two not in seats or seats[one].parent == seats[two].parent


def _is_spin(parts: Parts, place: tuple[str, int, str]) -> bool:
    """Whether a coordinate is the spin of its body."""
    return parts.mechanism.seats[place[0]].coordinates[place[1]] == "spin"


def ratios(parts: Parts) -> dict[str, list[tuple[str, float]]]:
    """Speed ratios between neighbouring bodies: body -> [(neighbour, speed of it per own speed)]."""
    out: dict[str, list[tuple[str, float]]] = {}
    for place, one, two, ratio in links_of(parts):
        if place[0] != "ratios" and not same_base(parts, one, two):
            continue  # the spins count from different frames: see `carried_trains`
        out.setdefault(one, []).append((two, ratio))
        out.setdefault(two, []).append((one, 1.0 / ratio))
    return out


def train_of(parts: Parts, body: str) -> set[str]:
    """Bodies that a body turns by meshes and couplings between bodies with one base; itself among them."""
    links = ratios(parts)
    found, queue = {body}, deque([body])
    while queue:
        for there, _ in links.get(queue.popleft(), ()):
            if there not in found:
                found.add(there)
                queue.append(there)
    return found


def locked_links(parts: Parts, body: str) -> list[Link]:
    """Links that close a loop with a body and contradict the ratios of the rest of it: nothing can turn."""
    from pitchpoint.model.carried_trains import has_carriers

    turning = start_speeds(parts, {body: 1.0})[0]
    if has_carriers(parts, joined := links_of(parts)):
        return [] if turning[body] != 0.0 else [link for link in joined if body in link[1:3]]
    return [
        link
        for link in links_of(parts)
        for one, two, ratio in [link[1:]]
        if turning[one] != 0.0
        and turning[two] != 0.0
        and abs(turning[two] - ratio * turning[one]) > SPEED_TOLERANCE * abs(turning[two])
    ]


def start_speeds(
    parts: Parts, given: Mapping[str, float]
) -> tuple[dict[str, float], list[tuple[str, float]]]:
    """Speeds of all bodies at the start, and the given ones that do not fit the others.

    Parameters
    ----------
    parts
        The parts of a model.
    given
        Speeds of some bodies [rad/s].

    Returns
    -------
    tuple
        Speed by body [rad/s], 0 for bodies that nothing sets in motion; and (body, fitting speed) for each
        given speed that contradicts an earlier one.
    """
    from pitchpoint.model.carried_trains import carried_speeds, has_carriers

    if has_carriers(parts, joined := links_of(parts)):
        return carried_speeds(parts, joined, given, SPEED_TOLERANCE)
    links = ratios(parts)
    speeds: dict[str, float] = {}
    wrong = []
    for name, value in given.items():
        if name in speeds:
            if abs(speeds[name] - value) > SPEED_TOLERANCE * max(abs(value), abs(speeds[name])):
                wrong.append((name, speeds[name]))
            continue
        speeds[name] = value
        queue = deque([name])
        while queue:
            here = queue.popleft()
            for there, ratio in links.get(here, ()):
                if there not in speeds:
                    speeds[there] = speeds[here] * ratio
                    queue.append(there)
    fixed = {n for n, b in parts.bodies.items() if b.moves == "fixed"}
    return {n: 0.0 if n in fixed else speeds.get(n, 0.0) for n in parts.bodies}, wrong


def check_scenarios(parts: Parts, report: Reader) -> None:
    """Check every scenario against the bodies and meshes it names."""
    for name, scenario in parts.scenarios.items():
        at: Place = ("scenarios", name)
        if not parts.bodies and ("bodies",) not in report.tainted and not parts.known("bodies"):
            report.problem(
                at, "needs bodies, and the file has none", remedy="add bodies that carry the gears"
            )
            continue
        _names(parts, scenario, at, report)
        _speeds(parts, scenario, at, report)
        if at in report.tainted:
            continue
        if scenario.kind == "time":
            _time(scenario, at, report)
        elif scenario.sweep is not None:
            _sweep(parts, scenario, (*at, "sweep"), report)
        if scenario.sweep is not None and scenario.quasi_static is not None:
            report.problem(at, "has sweep and quasi_static at once", remedy="make two scenarios of it")


def _names(parts: Parts, scenario: Scenario, at: Place, report: Reader) -> None:
    from pitchpoint.model.choices import exactly_one
    from pitchpoint.model.validate import known

    for key in ("speed", "drive", "hold"):
        for body in getattr(scenario, key):
            if key == "drive" and "." in body:
                continue  # a coordinate of a joint, see mechanism_check
            place = (*at, key, body) if key != "hold" else (*at, key)
            if known(parts, "bodies", body, place, report):
                _turns(parts, body, place, report)
    for body, drive in scenario.drive.items():
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


def _turns(parts: Parts, body: str, at: Place, report: Reader) -> None:
    """A body that a joint carries has a spin of its own only with some joints."""
    from pitchpoint.model.mechanism import coordinate

    if body not in parts.bodies or parts.bodies[body].moves != "joint":
        return
    found = coordinate(parts.mechanism, parts, body)
    if isinstance(found, str):
        report.problem(at, found, remedy="name a body that spins, or drive a coordinate of its joint")


def _speeds(parts: Parts, scenario: Scenario, at: Place, report: Reader) -> None:
    free = {b: s for b, s in scenario.speed.items() if b not in scenario.drive}
    _locked(parts, scenario, at, report)
    for body in scenario.speed:
        part = parts.bodies.get(body)
        if part is not None and part.moves == "fixed" and scenario.speed[body] != 0.0:
            report.problem((*at, "speed", body), "is the speed of a fixed body", remedy="remove it")
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
                    f"names {body}, which is fixed and cannot turn",
                    remedy="remove it, or give the body motion: torsion",
                )
    for body, drive in scenario.drive.items():
        if body in scenario.speed and isinstance(drive.speed, Constant):
            given, driven = scenario.speed[body], drive.speed.value
            if abs(given - driven) > SPEED_TOLERANCE * abs(driven):
                report.problem(
                    (*at, "speed", body),
                    "is not the speed at which the body is driven",
                    value=f"{given:.6g} rad/s",
                    limit=f"{driven:.6g} rad/s",
                    remedy="leave it out: what is driven starts at the speed of its drive",
                )
        if isinstance(drive.value, PythonLaw):
            key, rate = ("angle", "speed") if drive.angle is not None else ("position", "velocity")
            report.problem(
                (*at, "drive", body, key),
                f"is a Python function; only a {rate} can be one, its {key} follows without differencing",
                remedy=f"give {rate}: {{python: ...}}, or the {key} as a formula or table",
            )
    for body, fitting in start_speeds(parts, free)[1]:
        report.problem(
            (*at, "speed", body),
            "does not fit the ratio to the other given speeds",
            value=f"{free[body]:.6g} rad/s",
            limit=f"{fitting:.6g} rad/s",
            remedy="correct it or leave it out; the other speeds follow from the ratios (a drive may differ)",
        )


def _locked(parts: Parts, scenario: Scenario, at: Place, report: Reader) -> None:
    """Speeds inside a loop whose ratios contradict each other."""
    from pitchpoint.model.carried_trains import has_carriers

    turned: dict[str, Place] = {b: (*at, "speed", b) for b, speed in scenario.speed.items() if speed != 0.0}
    turned |= {b: (*at, "drive", b) for b in scenario.drive}
    if scenario.sweep is not None:
        turned[scenario.sweep.body] = (*at, "sweep", "body")
    told: set[Place] = set()
    links = links_of(parts)
    linked = {body for link in links for body in link[1:3]}
    plain = not has_carriers(parts, links)
    for body, place in turned.items():
        if body not in parts.bodies or body not in linked:
            continue
        locked = locked_links(parts, body)
        if plain and not locked:  # nor does any other body of its train find one
            linked -= train_of(parts, body)
        for link, one, two, _ in locked:
            if link not in told:
                told.add(link)
                report.problem(
                    place,
                    f"cannot turn {body}: {'.'.join(map(str, link))} locks {one} and {two}, which other "
                    "meshes and couplings turn at another ratio",
                    remedy="take one of the loop out, or leave the speed at zero",
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
            "is none that generalized_alpha has",
            value="SI1",
            limit="I3 or SI2",
            remedy="write form: SI2, or a stiff method such as gstiff",
        )
    if scenario.settle_time is not None and scenario.settle_time >= scenario.duration:
        report.problem(
            (*at, "settle_time"),
            "leaves nothing to measure",
            value=f"{scenario.settle_time:g} s",
            limit=f"< {scenario.duration:g} s",
            remedy="shorten it or lengthen duration",
        )
    window = scenario.duration - scenario.statistics_start
    if scenario.step is not None and scenario.step > 0.5 * window > 0.0:
        report.problem(
            (*at, "step"),
            "is longer than half the time that is measured, from settle_time to duration",
            value=f"{scenario.step:g} s",
            limit=f"<= {0.5 * window:g} s",
            remedy="write a shorter step, or leave it out",
        )
    for key, count in (
        ("step", scenario.duration / scenario.step if scenario.step else 0.0),
        ("sample_rate", scenario.duration * (scenario.sample_rate or 0.0)),
    ):
        if count > MOST_STEPS:
            report.problem(
                (*at, key),
                f"makes {count:.2g} steps out of the duration",
                limit=f"<= {MOST_STEPS:g} steps",
                remedy=f"correct {key} or duration, or leave {key} out",
            )


def _sweep(parts: Parts, scenario: Scenario, at: Place, report: Reader) -> None:
    from pitchpoint.model.choices import exactly_one

    sweep = scenario.sweep
    if sweep is None:
        return
    exactly_one(sweep, ("mesh_frequency", "speed"), at, report)
    if scenario.drive:
        report.problem(
            (*at[:-1], "drive"),
            "stands beside sweep, which prescribes the speed itself",
            remedy=f"write hold: [{', '.join(scenario.drive)}] for bodies that keep the speed of each point",
        )
    bounds = sweep.mesh_frequency or sweep.speed
    key = "mesh_frequency" if sweep.mesh_frequency is not None else "speed"
    if bounds is not None and bounds[0] >= bounds[1]:
        report.problem((*at, key), "does not rise", remedy="write [lowest, highest]; direction says the rest")
    if ("meshes",) in report.tainted or ("bodies",) in report.tainted:
        return
    own = parts.bodies[sweep.body].gears if sweep.body in parts.bodies else {}
    if not parts.gears.keys() >= set(own):
        return  # a gear that cannot be read may be the one in mesh
    teeth = sweep_meshes(parts, sweep.body)
    every = {**parts.meshes, **parts.bevel_meshes}
    if not teeth:
        report.problem(
            (*at, "body"),
            f"names {sweep.body}, which has no gear in mesh",
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
            f"names {sweep.mesh}, which is no mesh of {sweep.body}",
            remedy=f"name one of {', '.join(teeth)}",
        )


def sweep_meshes(parts: Parts, body: str) -> dict[str, int]:
    """Meshes of a body and the number of teeth it has in each of them."""
    return {
        name: gears[g].number_of_teeth
        for meshes, gears, own in (
            (parts.meshes, parts.gears, "gears"),
            (parts.bevel_meshes, parts.bevel_gears, "bevel_gears"),
        )
        for name, mesh in meshes.items()
        for g in mesh.gears
        if body in parts.bodies and g in getattr(parts.bodies[body], own) and g in gears
    }
