# SPDX-License-Identifier: Apache-2.0
"""Checks of the clearance between planets, and between planets and the other gears around their carrier."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pitchpoint.core.units import format_quantity
from pitchpoint.model.frames import Array, body_frame
from pitchpoint.model.planet_places import nominal_distance
from pitchpoint.model.reading.bare_numbers import said_of
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.stage_members import SECTION

if TYPE_CHECKING:
    from pitchpoint.model.components.planetary_stage import PlanetaryStage
    from pitchpoint.model.parts import Parts

SAME = 1e-6
"""Angle up to which two planets are at one place [rad]."""
TOUCH = 1e-6
"""Overlap along the axis up to which two gears touch by rounding [m]."""


def check_planets(parts: Parts, report: Reader) -> None:
    """Check that neighbouring planets do not touch."""
    for name, stage in parts.planetary_stages.items():
        bare = said_of(report, (SECTION, name, "angles"))
        if bare and (SECTION, name, "angles") in report.tainted:
            continue  # the same unit has been reported
        for gap, (one, two) in planet_gaps(parts, stage):
            if gap > 0.0:
                continue
            first, second = (stage.places[stage.names.index(planet)] for planet in (one, two))
            if abs(math.remainder(second - first, math.tau)) < SAME:
                remedy = "give every planet its own angle; 360 deg is the place of 0 deg"
                what = f"puts {one} and {two} at the same place"
                report.problem((SECTION, name, "angles"), what, remedy=remedy, taint=False)
                break
            report.problem(
                (SECTION, name, "planets" if stage.angles is None else "angles"),
                f"makes {one} and {two} overlap by {format_quantity(-gap, 'length', 3)} at their tips",
                remedy=bare or f"{_most(parts, stage)}, or planets with a smaller tip diameter",
                taint=False,
            )
            break
    _others(parts, report)


def _most(parts: Parts, stage: PlanetaryStage) -> str:
    """Number of planets that fit on their circle at equal angles, in words."""
    distance = nominal_distance(parts, stage) or math.inf
    tips = max(parts.gears[wheel.of(stage.names[0])].geometry.d_a for wheel in stage.wheels)
    most = math.floor(math.pi / math.asin(min(0.5 * tips / distance, 1.0)))
    if stage.angles is not None or most >= len(stage.places):
        return "use fewer planets"
    return f"use fewer planets, {most} at most at equal angles"


class _Disc(NamedTuple):
    """Space of a gear: its name, its axis [m] across the carrier, the ends of its face [m], and its tip
    radius [m], negative for a ring, which is outside of it."""

    gear: str
    place: Array
    low: float
    high: float
    radius: float


def _others(parts: Parts, report: Reader) -> None:
    """Check that planets do not touch planets of other stages, or suns and rings that are not their mates."""
    stages = [(n, s) for n, s in parts.planetary_stages.items() if (SECTION, n) not in report.tainted]
    for k, (name, stage) in enumerate(stages):
        axes = body_frame(parts, stage.carrier)[1]
        near = [(n, other) for n, other in stages if other.carrier == stage.carrier]
        first = stage.names[:1]
        own = list(_discs(parts, axes, [wheel.of(p) for wheel in stage.wheels for p in first]))
        later = [other for n, other in stages[k + 1 :] if other.carrier == stage.carrier]
        found = [w.of(p) for other in later for w in other.wheels for p in other.names]
        found += [g.mate for _, other in near for g in other.groups if g.side != "planet"]
        meshing = {frozenset(mesh.gears) for mesh in parts.meshes.values()}
        others = list(_discs(parts, axes, list(dict.fromkeys(found))))
        for one in own:
            for two in others:
                gap = _gap(one, two)
                if gap > 0.0 or one.gear == two.gear or frozenset((one.gear, two.gear)) in meshing:
                    continue
                report.problem(
                    (SECTION, name),
                    f"makes {one.gear} and {two.gear} overlap by {format_quantity(-gap, 'length', 3)}",
                    remedy="move one of them along the axis, or change teeth or centre distances",
                    taint=False,
                )


def _discs(parts: Parts, axes: Array, gears: list[str]) -> Iterator[_Disc]:
    """Spaces of gears of known place and geometry."""
    for gear in gears:
        body = parts.body_of(gear)
        if body is None or body not in parts.bodies or gear not in parts.gears or gear in parts.misshapen:
            continue
        origin = parts.bodies[body].origin
        if origin is None or parts.gears[gear].x is None:
            continue
        place = axes.T @ np.array(origin)
        part = parts.gears[gear]
        middle, half = float(place[2]) + parts.bodies[body].gears[gear], 0.5 * part.face_width
        radius = part.sign * 0.5 * abs(part.geometry.d_a)
        yield _Disc(gear, place[:2], middle - half, middle + half, radius)


def _gap(one: _Disc, two: _Disc) -> float:
    """Distance between a planet and another gear across their axes [m]; infinite without common width."""
    if min(one.high, two.high) - max(one.low, two.low) <= TOUCH:
        return math.inf
    apart = float(np.linalg.norm(one.place - two.place))
    if two.radius < 0.0:
        return -two.radius - apart - one.radius
    return apart - one.radius - two.radius


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
        names = stage.names[one], stage.names[two]
        tips = [
            0.5 * sum(parts.gears[wheel.of(planet)].geometry.d_a for planet in names)
            for wheel in stage.wheels
        ]
        found.append((chord - max(tips), names))
    return found if len(order) > 2 else found[:1]
