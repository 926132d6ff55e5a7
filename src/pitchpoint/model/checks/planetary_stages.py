# SPDX-License-Identifier: Apache-2.0
"""Checks of planetary stages: pin errors, spacing of the planets, equal centre distances.

With sun and ring, all planets can be assembled if the angles between them are whole multiples of
2 pi/(z_s + z_r); for N planets at equal angles (z_s + z_r)/N is then a whole number. Other sets:
`model.planet_spacing`.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import GeometryError
from pitchpoint.core.units import format_quantity
from pitchpoint.model.checks.carried_meshes import LARGEST
from pitchpoint.model.checks.gear_pairs import pair_of
from pitchpoint.model.frames import Array, body_frame
from pitchpoint.model.keys import Place
from pitchpoint.model.planet_places import central_bodies, inner_stage
from pitchpoint.model.planet_spacing import connected, spacing_teeth, stage_meshes
from pitchpoint.model.reading.bare_numbers import said_of
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.stage_members import SECTION

if TYPE_CHECKING:
    from pitchpoint.model.components.planetary_stage import PlanetaryStage
    from pitchpoint.model.parts import Parts

SAME = 1e-6
"""Length up to which two distances, or two places on the circle of the pins, agree [m]."""
RACK = ("normal_module", "normal_pressure_angle", "helix_angle")
"""Keys in which gears in mesh agree."""
CLEARANCE = 0.25
"""Bottom clearance of the standard basic rack over the module (ISO 53): a pin that is moved by more presses
the tips of its planet into the roots of sun or ring."""


def check_pin_errors(parts: Parts, report: Reader) -> None:
    """Check the sizes of the pin errors; later checks place the pins without those that are refused."""
    for name, stage in list(parts.planetary_stages.items()):
        most = CLEARANCE * stage.planet.normal_module
        kept = dict(stage.pin_errors)
        for planet, error in stage.pin_errors.items():
            for key in ("tangential", "radial"):
                size = getattr(error, key)
                if abs(size) <= most:
                    continue
                at: Place = (SECTION, name, "pin_errors", planet, key)
                bare = "a bare number is in metres; " if at not in report.sources else ""
                report.problem(
                    at,
                    "is more than the bottom clearance of the teeth",
                    value=format_quantity(size, "length"),
                    limit=f"{format_quantity(most, 'length', 4)} = {CLEARANCE:g} m_n, either sign",
                    remedy=f"{bare}write 20 um, for instance",
                    taint=False,
                )
                kept.pop(planet, None)
        if len(kept) < len(stage.pin_errors):
            parts.planetary_stages[name] = replace(stage, pin_errors=kept)


def check_spacing(parts: Parts, report: Reader) -> None:
    """Check the assembly condition of all stages, and the common centre distance of their meshes."""
    _coaxial(parts, report)
    for chain in connected(parts):
        stages = {name: parts.planetary_stages[name] for name in chain}
        gears = [g.mate for s in stages.values() for g in s.groups if g.side != "planet"]
        ready = not any((SECTION, name) in report.tainted for name in chain) and all(
            gear in parts.gears and ("gears", gear) not in report.tainted for gear in gears
        )
        if not ready:
            continue
        teeth = spacing_teeth(stage_meshes(parts, tuple(stages.values())))
        for name, stage in stages.items():
            own = stage.angles is not None or inner_stage(parts, stage) is None
            if teeth and own and not _spacing(parts, (SECTION, name), stage, teeth, report):
                report.tainted.update(("meshes", mesh) for s in stages.values() for mesh in s.meshes)
            if stage.center_distance is None and not _distances(parts, (SECTION, name), stage, report):
                for mesh in stage.meshes:  # their geometry is that of either distance
                    report.taint(("meshes", mesh, "gears"))


def _coaxial(parts: Parts, report: Reader) -> None:
    """Check that suns and rings with a position around one carrier are on one axis; later checks put them
    there."""
    given: dict[str, dict[str, tuple[Array, str, float]]] = {}
    for name, stage in parts.planetary_stages.items():
        for body, _ in central_bodies(parts, stage):
            if (position := parts.bodies[body].position) is not None:
                module = stage.planet.normal_module
                given.setdefault(stage.carrier, {}).setdefault(body, (np.array(position), name, module))
    for bodies in given.values():
        axis = body_frame(parts, next(iter(bodies)))[1][:, 2]
        across = {body: place - (place @ axis) * axis for body, (place, _, _) in bodies.items()}
        # the axis that most of them have, the first of several
        first = max(
            across, key=lambda one: sum(np.allclose(at, across[one], atol=SAME) for at in across.values())
        )
        for body, (place, name, module) in bodies.items():
            off = across[body] - across[first]
            apart, limit = float(np.linalg.norm(off)), LARGEST * module
            if apart <= limit:
                continue
            report.problem(
                ("shafts" if body in parts.shafts else "bodies", body, "position"),
                f"is off the axis of {first}, which is that of {SECTION}.{name}",
                value=format_quantity(apart, "length", 4),
                limit=f"{format_quantity(limit, 'length', 3)}, a tenth of a module",
                remedy=f"put {body} on the axis of {first}",
                taint=False,
            )
            x, y, z = (float(v) for v in place - off)
            parts.bodies[body] = replace(parts.bodies[body], position=(x, y, z))


def possible_angles(angles: tuple[float, ...], teeth: int) -> tuple[float, ...]:
    """Nearest angles at which planets can be assembled [rad]; the first angle is kept.

    Parameters
    ----------
    angles
        Angles of the planets [rad].
    teeth
        Number of places on a turn at which a planet fits: the sum of the teeth of sun and ring.

    Examples
    --------
    Four planets between 20 and 62 teeth:

    >>> [round(math.degrees(a), 3) for a in possible_angles(tuple(math.tau * k / 4 for k in range(4)), 82)]
    [0.0, 87.805, 180.0, 267.805]
    """
    step = math.tau / teeth
    return tuple(angles[0] + round((angle - angles[0]) / step) * step for angle in angles)


def _spacing(parts: Parts, at: Place, stage: PlanetaryStage, teeth: int, report: Reader) -> bool:
    """Check the angles of planets, which fit at a number of places on a turn; False if they do not."""
    nearest = possible_angles(stage.places, teeth)
    largest = max(wheel.gear.normal_module * wheel.gear.number_of_teeth for wheel in stage.wheels)
    central = [parts.gears[g.mate] for g in stage.groups if g.side != "planet"]
    radius = 0.5 * max(largest, *(gear.normal_module * gear.number_of_teeth for gear in central))
    missed = [(abs(a - b), b) for a, b in zip(stage.places, nearest, strict=True)]
    worst = max(missed)[0]
    if worst * radius <= SAME:
        return True
    listed = ", ".join(f"{round(math.degrees(b), 9):.9g} deg" for b in nearest)
    count = len(stage.places)
    simple = len(stage.wheels) == 1 and set(stage.wheels[0].mates) == {"sun", "ring"}
    simple = simple and teeth == sum(gear.number_of_teeth for gear in central)
    words = " + ".join(str(gear.number_of_teeth) for gear in central)
    fitted = ", or fitted: true at a step" if any(not s.fitted for s in stage.steps.values()) else ""
    if stage.angles is None:
        whole = [n for n in range(count - 1, 1, -1) if teeth % n == 0][:1]
        fewer = f", or {whole[0]} planets" if whole else ""
        report.problem(
            (*at, "planets"),
            f"cannot be assembled at equal angles: {f'({words})' if simple else teeth}/{count} "
            f"= {teeth / count:.6g} is not a whole number",
            value=str(count),
            limit="whole multiples of 360 deg/(z_s + z_r) between the planets"
            if simple
            else f"whole multiples of 360 deg/{teeth} between the planets",
            remedy=f"give angles: [{listed}], the nearest possible spacing{fewer}{fitted}, or other tooth "
            "numbers",
        )
    else:
        report.problem(
            (*at, "angles"),
            f"cannot be assembled: a planet is {math.degrees(worst):.4g} deg off the nearest possible angle",
            limit=f"whole multiples of 360/{teeth} = {360.0 / teeth:.6g} deg between the planets",
            remedy=said_of(report, (*at, "angles"))
            or f"give angles: [{listed}], and errors of the pins as pin_errors{fitted}",
        )
    return False


def _distances(parts: Parts, at: Place, stage: PlanetaryStage, report: Reader) -> bool:
    """Check that all pairs have the same centre distance if it follows from the profile shifts; False if
    not."""
    found: list[tuple[float, str]] = []
    for group in stage.groups:
        if group.side == "planet":
            continue
        gear, planet = parts.gears[group.mate], group.wheel.gear
        if gear.profile_shift_coefficient is None or planet.profile_shift_coefficient is None:
            return True
        if any(getattr(gear, key) != getattr(planet, key) for key in RACK):
            return True  # reported for the pair
        pair = (gear.geometry, planet.geometry) if group.side == "sun" else (planet.geometry, gear.geometry)
        try:
            found.append((abs(pair_of(*pair, None).a_w), group.mate))
        except GeometryError:
            return True  # reported for the pair
    (first, one), *others = found
    for other, two in others:
        if abs(other - first) > SAME:
            what = "more" if other > first else "less"
            size = format_quantity(abs(other - first), "length", 3)
            report.problem(
                (*at, "center_distance"),
                f"is missing: the planets would be {other * 1e3:.7g} mm from the axis of {two}, {size} "
                f"{what} than {first * 1e3:.7g} mm from that of {one}, both without backlash",
                limit="a difference of 1 µm",
                remedy=_concentric(parts, stage)
                or f"give center_distance: {min(first, other) * 1e3:.7g} mm, or change a profile shift",
            )
            return False
    return True


def _concentric(parts: Parts, stage: PlanetaryStage) -> str:
    """Remedy for tooth numbers of a simple set with which gears without profile shift are not concentric."""
    (wheel, *steps), gears = stage.wheels, [parts.gears[g.mate] for g in stage.groups if g.side != "planet"]
    shifts = [g.profile_shift_coefficient for g in (*gears, wheel.gear)]
    if steps or len(gears) < 2 or any(shifts):
        return ""
    sun, ring = (gear.number_of_teeth for gear in gears)
    fits = sun + 2 * wheel.gear.number_of_teeth
    if ring == fits:
        return ""
    return (
        f"correct a number of teeth: without profile shifts a ring has z_sun + 2 z_planet = {fits} teeth, "
        f"not {ring}; or give profile shifts and center_distance"
    )
