# SPDX-License-Identifier: Apache-2.0
"""Checks of planetary stages: spacing of the planets, equal centre distances, room between the planets.

With sun and ring, all planets can be assembled if the angles between them are whole multiples of
2 pi/(z_s + z_r); for N planets at equal angles (z_s + z_r)/N is then a whole number. Derivation:
docs/theory/planetary_stages.md, "Assembly".
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import GeometryError
from pitchpoint.core.units import format_quantity
from pitchpoint.model.checks.gear_pairs import pair_of
from pitchpoint.model.keys import Place
from pitchpoint.model.planetary_stages import SECTION, nominal_distance
from pitchpoint.model.reading.bare_numbers import said_of
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.planetary_stage import PlanetaryStage
    from pitchpoint.model.parts import Parts

SAME = 1e-6
"""Length up to which two distances, or two places on the circle of the pins, agree [m]."""
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
    """Check the assembly condition and the common centre distance of all stages."""
    for name, stage in parts.planetary_stages.items():
        at: Place = (SECTION, name)
        ready = at not in report.tainted and all(
            gear is None or (gear in parts.gears and ("gears", gear) not in report.tainted)
            for gear in (stage.sun, stage.ring)
        )
        if ready and stage.sun is not None and stage.ring is not None:
            _spacing(parts, at, stage, report)
            if stage.center_distance is None:
                _distances(parts, at, stage, report)


def possible_angles(angles: tuple[float, ...], teeth: int) -> tuple[float, ...]:
    """Nearest angles at which planets can be assembled [rad]; the first angle is kept.

    Parameters
    ----------
    angles
        Angles of the planets [rad].
    teeth
        Sum of the tooth numbers of sun and ring.

    Examples
    --------
    Four planets between 20 and 62 teeth:

    >>> [round(math.degrees(a), 3) for a in possible_angles(tuple(math.tau * k / 4 for k in range(4)), 82)]
    [0.0, 87.805, 180.0, 267.805]
    """
    step = math.tau / teeth
    return tuple(angles[0] + round((angle - angles[0]) / step) * step for angle in angles)


def _spacing(parts: Parts, at: Place, stage: PlanetaryStage, report: Reader) -> None:
    sun, ring = (parts.gears[str(gear)] for gear in (stage.sun, stage.ring))
    teeth = sun.number_of_teeth + ring.number_of_teeth
    nearest = possible_angles(stage.places, teeth)
    radius = 0.5 * sun.normal_module * (sun.number_of_teeth + stage.planet.number_of_teeth)
    missed = [(abs(a - b), b) for a, b in zip(stage.places, nearest, strict=True)]
    worst = max(missed)[0]
    if worst * radius <= SAME:
        return
    report.tainted.update(("meshes", mesh) for mesh in (*stage.sun_meshes(), *stage.ring_meshes()))
    listed = ", ".join(f"{round(math.degrees(b), 9):.9g} deg" for b in nearest)
    count = len(stage.places)
    if stage.angles is None:
        whole = [n for n in range(count - 1, 1, -1) if teeth % n == 0][:1]
        fewer = f", or {whole[0]} planets" if whole else ""
        report.problem(
            (*at, "planets"),
            f"cannot be assembled at equal angles: ({sun.number_of_teeth} + {ring.number_of_teeth})/{count} "
            f"= {teeth / count:.6g} is not a whole number",
            value=str(count),
            limit="whole multiples of 360 deg/(z_s + z_r) between the planets",
            remedy=f"give angles: [{listed}], the nearest possible spacing{fewer}, or other tooth numbers",
        )
    else:
        report.problem(
            (*at, "angles"),
            f"cannot be assembled: a planet is {math.degrees(worst):.4g} deg off the nearest possible angle",
            limit=f"whole multiples of 360/{teeth} = {360.0 / teeth:.6g} deg between the planets",
            remedy=said_of(report, (*at, "angles"))
            or f"give angles: [{listed}], and errors of the pins as pin_errors",
        )


def _distances(parts: Parts, at: Place, stage: PlanetaryStage, report: Reader) -> None:
    """Check that both pairs have the same centre distance if it follows from the profile shifts."""
    gears = [parts.gears[str(g)] for g in (stage.sun, stage.ring)]
    if stage.planet.profile_shift_coefficient is None or any(
        gear.profile_shift_coefficient is None for gear in gears
    ):
        return
    try:
        planet = stage.planet.geometry
        sun, ring = (
            abs(pair_of(one, two, None).a_w)
            for one, two in ((gears[0].geometry, planet), (planet, gears[1].geometry))
        )
    except GeometryError:
        return  # reported for the pair
    if abs(ring - sun) > SAME:
        what = "more" if ring > sun else "less"
        size = format_quantity(abs(ring - sun), "length", 3)
        report.problem(
            (*at, "center_distance"),
            f"is missing: the planets would be {ring * 1e3:.7g} mm from the axis of the ring, {size} {what} "
            f"than {sun * 1e3:.7g} mm from that of the sun, both without backlash",
            limit="a difference of 1 µm",
            remedy=f"give center_distance: {min(sun, ring) * 1e3:.7g} mm, or change a profile shift",
        )


def check_planets(parts: Parts, report: Reader) -> None:
    """Check that neighbouring planets do not touch."""
    for name, stage in parts.planetary_stages.items():
        bare = said_of(report, (SECTION, name, "angles"))
        if bare and (SECTION, name, "angles") in report.tainted:
            continue  # the same unit has been reported
        for gap, (one, two) in planet_gaps(parts, stage):
            if gap > 0.0:
                continue
            report.problem(
                (SECTION, name, "planets" if stage.angles is None else "angles"),
                f"makes {one} and {two} overlap by {format_quantity(-gap, 'length', 3)} at their tips",
                remedy=bare or "use fewer planets, or planets with a smaller tip diameter",
                taint=False,
            )
            break


def planet_gaps(parts: Any, stage: PlanetaryStage) -> list[tuple[float, tuple[str, str]]]:
    """Distances between the tip circles of neighbouring planets, without pin errors [m], and their names."""
    distance = nominal_distance(parts, stage)
    order = sorted(range(len(stage.places)), key=lambda k: stage.places[k] % math.tau)
    if distance is None or len(order) < 2 or not all(name in parts.gears for name in stage.names):
        return []
    found = []
    for k, one in enumerate(order):
        two = order[(k + 1) % len(order)]
        chord = 2.0 * distance * abs(math.sin(0.5 * (stage.places[two] - stage.places[one])))
        tips = 0.5 * sum(parts.gears[stage.names[n]].geometry.d_a for n in (one, two))
        found.append((chord - tips, (stage.names[one], stage.names[two])))
    return found if len(order) > 2 else found[:1]
