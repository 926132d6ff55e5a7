# SPDX-License-Identifier: Apache-2.0
"""Speed ratios between bodies, and the initial speeds that follow from given speeds."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from pitchpoint.model.carried_trains import carried_speeds, has_carriers
from pitchpoint.model.frames import bodies_of, split
from pitchpoint.model.keys import Place
from pitchpoint.model.mechanism import coordinate, same_base
from pitchpoint.model.torsional_supports import bushed_pairs, supported_bodies

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

SPEED_TOLERANCE = 1e-6
"""Relative tolerance of given speeds from the gear ratio."""

Link = tuple[Place, str, str, float]
"""Path of a mesh or coupling, its two bodies, speed of the second over speed of the first."""


def links_of(parts: Parts) -> list[Link]:
    """All links with a speed ratio: meshes, torsional couplings, ratios of two spins."""
    found: list[Link] = []
    for name, mesh in parts.meshes.items():
        bodies = [parts.body_of(g) for g in mesh.gears]
        if None in bodies or bodies[0] == bodies[1] or not all(g in parts.gears for g in mesh.gears):
            continue
        z_1, z_2 = (parts.gears[g].sign * parts.gears[g].number_of_teeth for g in mesh.gears)
        found.append((("meshes", name), str(bodies[0]), str(bodies[1]), -z_1 / z_2))
    found += _bevel_links(parts)
    for group in ("couplings", *parts.others):
        for name, coupling in getattr(parts, group).items():
            if getattr(coupling, "carries_torque", False):
                one, two = (split(end)[0] for end in coupling.bodies)
                if one != two and one in parts.bodies and two in parts.bodies:
                    found.append(((group, name), one, two, 1.0))
    for name, spring in parts.torsion_springs.items():
        turning = bodies_of(spring.bodies)
        if len(set(turning) & set(parts.bodies)) == 2 and spring.stiffness > 0.0:
            found.append((("torsion_springs", name), turning[0], turning[1], 1.0))
    found += [(("bushings", name), *bodies, 1.0) for name, bodies in bushed_pairs(parts).items()]
    for name, ratio in parts.ratios.items():
        ends = [coordinate(parts.mechanism, parts, term) for term in ratio.terms]
        spins = [e[0] for e in ends if not isinstance(e, str) and _is_spin(parts, e)]
        if len(spins) == len(ends) == 2:
            c_1, c_2 = ratio.terms.values()
            found.append((("ratios", name), spins[0], spins[1], -c_1 / c_2))
    return found


def _bevel_links(parts: Parts) -> list[Link]:
    """Links of bevel meshes; the sign depends on the directions in which the pitch cones open."""
    found: list[Link] = []
    for name, mesh in parts.bevel_meshes.items():
        one, two = (parts.body_of(g) for g in mesh.gears)
        gears = [parts.bevel_gears.get(g) for g in mesh.gears]
        if one is not None and two is not None and one != two and None not in gears:
            z_1, z_2 = (g.direction * g.number_of_teeth for g in gears)  # type: ignore[union-attr]
            found.append((("bevel_meshes", name), one, two, -z_1 / z_2))
    return found


def _is_spin(parts: Parts, place: tuple[str, int, str]) -> bool:
    """Whether a coordinate is the spin of its body."""
    return parts.mechanism.seats[place[0]].coordinates[place[1]] == "spin"


def ratios(parts: Parts) -> dict[str, list[tuple[str, float]]]:
    """Speed ratios between neighbouring bodies: body -> [(neighbour, its speed over the speed of the
    body)]."""
    out: dict[str, list[tuple[str, float]]] = {}
    for place, one, two, ratio in links_of(parts):
        if place[0] != "ratios" and not same_base(parts, one, two):
            continue  # the spins refer to different frames: see `carried_trains`
        out.setdefault(one, []).append((two, ratio))
        out.setdefault(two, []).append((one, 1.0 / ratio))
    return out


def train_of(parts: Parts, body: str) -> set[str]:
    """Bodies driven by a body through meshes and couplings between bodies with the same parent, with
    itself."""
    links = ratios(parts)
    found, queue = {body}, deque([body])
    while queue:
        for there, _ in links.get(queue.popleft(), ()):
            if there not in found:
                found.add(there)
                queue.append(there)
    return found


def locked_links(parts: Parts, body: str) -> list[Link]:
    """Links that block the rotation of a body.

    They contradict the other ratios of a loop through the body, or are meshes with a fixed body.
    """
    turning = start_speeds(parts, {body: 1.0})[0]
    if has_carriers(parts, joined := links_of(parts)):
        return [] if turning[body] != 0.0 else [link for link in joined if body in link[1:3]]
    fixed = fixed_bodies(parts)
    return [
        link
        for link in joined
        for place, one, two, ratio in [link]
        if (turning[one] != 0.0 and turning[two] != 0.0)
        and abs(turning[two] - ratio * turning[one]) > SPEED_TOLERANCE * abs(turning[two])
        or place[0] in ("meshes", "bevel_meshes")
        and ((one in fixed and turning[two] != 0.0) or (two in fixed and turning[one] != 0.0))
    ]


def fixed_bodies(parts: Parts) -> set[str]:
    """Bodies with motion: fixed."""
    return {n for n, b in parts.bodies.items() if b.moves == "fixed"}


def start_speeds(
    parts: Parts, given: Mapping[str, float], held: Sequence[str] = ()
) -> tuple[dict[str, float], list[tuple[str, float]]]:
    """Initial speeds of all bodies, and given speeds that contradict others.

    Parameters
    ----------
    parts
        The parts of a model.
    given
        Speeds of some bodies [rad/s].
    held
        Bodies whose speed a scenario keeps constant.

    Returns
    -------
    tuple
        Speed by body [rad/s], 0 for bodies without drive and for bodies on a torsional support or in `held`
        whose speed does not follow from the given ones; and (body, consistent speed) for each given speed
        that contradicts an earlier one.
    """
    if has_carriers(parts, joined := links_of(parts)):
        return carried_speeds(parts, joined, given, [*supported_bodies(parts), *held], SPEED_TOLERANCE)
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
    fixed = fixed_bodies(parts)
    return {n: 0.0 if n in fixed else speeds.get(n, 0.0) for n in parts.bodies}, wrong


def sweep_meshes(parts: Parts, body: str) -> dict[str, int]:
    """Meshes of a body with its number of teeth in each of them."""
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


def trains(parts: Parts) -> list[set[str]]:
    """Gear trains: sets of bodies connected by meshes and torsional couplings."""
    return joined(parts.bodies, ({one, two} for _, one, two, _ in links_of(parts)))


def joined(names: Iterable[str], links: Iterable[set[str]]) -> list[set[str]]:
    """Sets of names connected by links.

    Examples
    --------
    >>> [sorted(group) for group in joined("abc", [{"a", "c"}])]
    [['b'], ['a', 'c']]
    """
    groups: list[set[str]] = [{name} for name in names]
    for link in links:
        touched = [g for g in groups if g & link]
        if len(touched) > 1:
            groups = [g for g in groups if not g & link] + [set().union(*touched)]
    return groups
