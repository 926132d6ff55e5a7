# SPDX-License-Identifier: Apache-2.0
"""Positions of bevel gears: apexes, axis directions, contact rays of the pitch cones, tooth angles."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.model.checks.gear_pairs import along_base_tangent
from pitchpoint.model.frames import Array, body_frame

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel.pair import BevelPair
    from pitchpoint.model.components.bevel_mesh import BevelMesh
    from pitchpoint.model.model import Model
    from pitchpoint.model.parts import Parts


def bevel_pair(machine: Model | Parts, mesh: BevelMesh) -> BevelPair:
    """Geometry of a bevel gear pair; default shaft angle: the sum of the pitch cone angles."""
    from pitchpoint.geometry.bevel.pair import BevelPair

    one, two = (machine.bevel_gears[g].geometry for g in mesh.gears)
    return BevelPair(one, two, one.delta + two.delta if mesh.shaft_angle is None else mesh.shaft_angle)


def bevel_gap(pair: BevelPair, mesh: BevelMesh) -> float:
    """Backlash along the base tangent at the mean cone distance [m]: as given, or from geometry."""
    if mesh.backlash is None:
        return pair.R_m * pair.sigma_j
    return along_base_tangent(mesh.backlash, pair.alpha_t, pair.beta_b, pair.gear1.m_mn)


def apex_of(machine: Model | Parts, gear: str) -> tuple[Array, Array] | None:
    """Apex of a bevel gear in the world [m] and the unit vector from the apex into the gear.

    None if the gear has no body, only one that has it as a cylindrical gear (an error reported elsewhere), or
    one of unknown position.
    """
    body = machine.body_of(gear)
    if body is None or gear not in machine.bodies[body].bevel_gears:
        return None
    origin, axes = body_frame(machine, body)
    if origin is None:
        return None
    z = axes[:, 2]
    return origin + machine.bodies[body].bevel_gears[gear] * z, machine.bevel_gears[gear].direction * z


def pitch_ray(axes: Array, own: Array, other: Array) -> float:
    """Angle of the pitch ray of two gears about the z axis of a body, from its x axis [rad].

    Parameters
    ----------
    axes
        Frame of the body, columns, shape (3, 3).
    own, other
        Unit vectors from the apex into the gear on that body and into the mating gear, shape (3,).
    """
    x, y, _ = axes.T @ (other - (other @ own) * own)
    return math.atan2(y, x)


def turned_to(machine: Model | Parts, gear: str, R: float) -> float:
    """Angle about the z axis by which a spiral tooth advances from the middle of its face to R [rad].

    Relevant only for gears of unequal face width, whose middles differ.
    """
    shape = machine.bevel_gears[gear].geometry
    return float(machine.bevel_gears[gear].direction * shape.spiral_rate * math.log(R / shape.R_m))


def tooth_phases(machine: Model | Parts, mesh: BevelMesh, angles: dict[str, float]) -> list[float]:
    """Signed phases z (gamma - ray) of the teeth 0 of both gears at the pitch ray, at R_m of gear 1 [rad].

    The teeth are centred in the tooth spaces of the mating gear if both add up to an odd multiple of pi.
    """
    ways = [apex_of(machine, g) for g in mesh.gears]
    assert ways[0] is not None and ways[1] is not None  # both gears have a body
    found = []
    R_m = machine.bevel_gears[mesh.gears[0]].geometry.R_m
    for k, name in enumerate(mesh.gears):
        gear = machine.bevel_gears[name]
        axes = body_frame(machine, str(machine.body_of(name)))[1]
        ray = pitch_ray(axes, ways[k][1], ways[1 - k][1])  # type: ignore[index]
        angle = angles[name] + turned_to(machine, name, R_m)
        found.append(gear.direction * gear.number_of_teeth * (angle - ray))
    return found


def assemble_bevels(machine: Model | Parts) -> dict[str, float]:
    """Rotate all bevel gears so that all meshes are centred in their backlash; tooth angles by gear [rad].

    Gears with an `initial_angle` keep it; in a train without any, gear 1 of the first mesh is at 0.
    """
    gears = machine.bevel_gears
    angles = {n: g.initial_angle for n, g in gears.items() if g.initial_angle is not None}
    loose = [m for m in machine.bevel_meshes.values() if all(apex_of(machine, g) for g in m.gears)]
    while loose:
        ready = next((m for m in loose if not angles.keys().isdisjoint(m.gears)), None)
        if ready is None:
            angles[loose[0].gears[0]] = 0.0
            continue
        loose.remove(ready)
        for name in ready.gears:
            if name not in angles:
                angles[name] = 0.0
                off = math.remainder(math.pi - sum(tooth_phases(machine, ready, angles)), math.tau)
                angles[name] = gears[name].direction * off / gears[name].number_of_teeth
    return {name: math.remainder(angles.get(name, 0.0), math.tau) for name in gears}
