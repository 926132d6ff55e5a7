# SPDX-License-Identifier: Apache-2.0
"""Planetary sets with equal planets, and the three types of their modes.

In the radial and tangential directions of the planets, at the angles psi_k, the rotation of sun, ring and
carrier acts on all planets alike, and their translation in proportion to cos psi_k and sin psi_k. With a
vanishing sum of e^(i psi_k), as of equal angles [1]_ or of opposite pairs of planets [2]_, there are

* rotational modes: all planets move alike, sun, ring and carrier only rotate and move axially; axial modes
  if most of the energy is axial, as in helical sets [3]_;
* translational modes: planets move in proportion to cos and sin psi_k; sun, ring and carrier only move
  laterally and tilt. At equal angles they are in pairs;
* planet modes, N - 3 of each: planets move across both; sun, ring and carrier are at rest. If these cannot
  move laterally, the modes in proportion to cos and sin psi_k are planet modes, too.

Compound sets have the same types [4]_: planets in series, stepped planets, and sets on common bodies are one
set, each of whose groups of planets has its own angles.

A mode is one of the set if the set has half of the energies: the kinetic energy of planets and central
bodies, and the strain energy of meshes, planet bearings and the supports of central bodies. Of an elastic
shaft only the stations with the gear or the carrier, and what is fixed to them, are central bodies. Where
meshes and planet bearings have less than a tenth of the strain energy, the central body moves on its own
supports.

References
----------
.. [1] J. Lin, R. G. Parker: Analytical characterization of the unique properties of planetary gear free
   vibration, Journal of Vibration and Acoustics 121 (1999) 316-321.
.. [2] J. Lin, R. G. Parker: Structured vibration characteristics of planetary gears with unequally spaced
   planets, Journal of Sound and Vibration 233 (2000) 921-928.
.. [3] T. Eritenel, R. G. Parker: Modal properties of three-dimensional helical planetary gears, Journal of
   Sound and Vibration 325 (2009) 397-420.
.. [4] D. R. Kiracofe, R. G. Parker: Structured vibration modes of general compound planetary gear systems,
   Journal of Vibration and Acoustics 129 (2007) 1-16.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.words import listed
from pitchpoint.system.meshes import mesh_records

if TYPE_CHECKING:
    from pitchpoint.solvers.modes.machine_groups import Groups
    from pitchpoint.system.system import System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

EVEN = 1e-3
"""Tolerance of the mean of e^(i psi), and of equal radii (relative)."""
STILL = 1e-6
"""Share of sun, ring and carrier in the energy of the set up to which they are at rest."""
PURE = 0.8
"""Share of one type in the energy of the set from which a mode has this type."""
OWN = 0.5
"""Share of the set in the kinetic and in the strain energy from which a mode is one of the set."""
COUPLED = 0.1
"""Share of meshes and planet bearings in the strain energy from which the set takes part in a mode: the
least of all modes of the sets of Lin and Parker with three to five planets is 0.11."""
ROTATIONAL, TRANSLATIONAL, PLANET = TYPES = ("rotational", "translational", "planet")
"""Types of modes of a planetary set by h."""
AXIAL = "axial"
"""Type of rotational modes whose energy is mostly axial."""


@dataclass(frozen=True)
class PlanetSet:
    """Planets on the circles of their pins and the bodies around them.

    Parameters
    ----------
    name
        Planetary stages of the model file, such as "planetary stage set"; without any, "planetary set" with
        the name of the carrier, else of the sun.
    planets
        Bodies with the gears of the planets, by group.
    angles
        Angles of these planets in the axes of the first one of the group [rad].
    parts
        Parts of the planets.
    central
        Parts of sun, ring and carrier.
    bodies
        Bodies with sun, ring and carrier, and all that are fixed to them.
    springs, supports
        Components of meshes and planet bearings, and of springs that connect bodies of the set to each other
        or to ground.
    """

    name: str
    planets: tuple[tuple[int, ...], ...]
    angles: tuple[tuple[float, ...], ...]
    parts: tuple[int, ...]
    central: tuple[int, ...]
    bodies: tuple[int, ...]
    springs: tuple[int, ...]
    supports: tuple[int, ...]


@dataclass
class _Group:
    """Planets on one circle, and the bodies around them."""

    planets: list[int]
    angles: Array
    central: list[int]
    carriers: list[int]


def planet_sets(system: System, groups: Groups, place: Array, axes: Array) -> tuple[PlanetSet, ...]:
    """Sets of three or more equal planets at balanced angles around a central gear.

    Planets have a carrier that rotates, are in mesh with two central gears, or are those of a planetary
    stage. Wheels on fixed axes around a crankshaft gear are none.

    Parameters
    ----------
    system, groups
        The system and its parts.
    place, axes
        Origins (nb, 3) [m] and axes (nb, 3, 3) of the bodies, world axes.
    """
    mates: dict[int, list[int]] = {}
    for record in mesh_records(system):
        i, j = int(record["i"]), int(record["j"])
        mates.setdefault(i, []).append(j)
        mates.setdefault(j, []).append(i)
    found: dict[frozenset[int], _Group] = {}
    for body, others in mates.items():
        planets = list(dict.fromkeys(others))
        for own in _circles(system, planets):
            angles = _angles(own, body, place, axes) if len(own) > 2 else None
            if angles is not None:
                group = found.setdefault(frozenset(own), _Group(own, angles, [], []))
                group.central.append(body)
    real = []
    for group in found.values():
        group.carriers = _carriers(system, group.planets, group.central)
        turning = any(groups.rotates[groups.carried[b]] for b in group.carriers)
        if turning or len(group.central) > 1 or _stage_of(system, group.planets[0]):
            real.append(group)
    return tuple(_set(system, groups, joined) for joined in _joined(real))


def _stage_of(system: System, planet: int) -> str:
    """Planetary stage of a planet; "" without one."""
    part = system.model.bodies.get(system.layout.bodies[planet]) if system.model is not None else None
    return "" if part is None else part.stage or ""


def _circles(system: System, planets: list[int]) -> list[list[int]]:
    """Planets in mesh with one central body, by planetary stage."""
    found: dict[str, list[int]] = {}
    for planet in planets:
        found.setdefault(_stage_of(system, planet), []).append(planet)
    return list(found.values())


def _joined(found: list[_Group]) -> list[list[_Group]]:
    """Groups of planets with common central bodies or carriers."""
    sets: list[list[_Group]] = []
    for group in found:
        own = {*group.central, *group.carriers} - {0}
        near = [s for s in sets if any(own & {*g.central, *g.carriers} for g in s)]
        sets = [s for s in sets if s not in near] + [[g for s in near for g in s] + [group]]
    return sets


def _carriers(system: System, planets: list[int], central: list[int]) -> list[int]:
    """Carrier of planets: the parent of all, or a body connected to each of them."""
    near = [{int(system.program["body"][p]["parent"])} for p in planets]
    for records in system.records.values():
        if {"i", "j"} <= set(records.dtype.names or ()):
            for i, j in zip(records["i"].tolist(), records["j"].tolist(), strict=True):
                for own, p in zip(near, planets, strict=True):
                    own |= {j} if i == p else {i} if j == p else set()
    return sorted(set.intersection(*near) - {0, *central})


def _angles(planets: list[int], body: int, place: Array, axes: Array) -> Array | None:
    """Angles of planets about a central body; None unless they are balanced on a circle."""
    way = (place[planets] - place[body]) @ axes[planets[0]]
    radii, angles = np.hypot(way[:, 0], way[:, 1]), np.arctan2(way[:, 1], way[:, 0])
    alike = radii.min() > 0.0 and np.ptp(radii) <= EVEN * radii.max()
    return angles if alike and abs(np.exp(1j * angles).mean()) <= EVEN else None


def _set(system: System, groups: Groups, joined: list[_Group]) -> PlanetSet:
    """Set with its central bodies and its name."""
    members = [b for group in joined for b in (*group.central, *group.carriers) if b]
    planets = [p for group in joined for p in group.planets]
    moved = _moved_by(system)
    around_planets = {moved[b] for b in members} - {0}
    parts = tuple(dict.fromkeys(groups.carried[p] for p in planets))
    springs = [e for e, ends in enumerate(groups.ends) if set(ends) & set(parts)]
    held = [
        e for e, own in enumerate(groups.bodies) if {moved[b] for b in own} - {0} <= around_planets and own
    ]
    orders = [np.argsort(group.angles) for group in joined]
    stages = list(dict.fromkeys(name for p in planets if (name := _stage_of(system, p))))
    around = groups.parts[groups.part[(joined[0].carriers or members)[0]]]
    several = "planetary stages" if len(stages) > 1 else "planetary stage"
    return PlanetSet(
        name=f"{several} {listed(stages)}" if stages else f"planetary set {around}",
        planets=tuple(tuple(g.planets[k] for k in o) for g, o in zip(joined, orders, strict=True)),
        angles=tuple(tuple(float(g.angles[k]) for k in o) for g, o in zip(joined, orders, strict=True)),
        parts=parts,
        central=tuple(dict.fromkeys(groups.carried[b] for b in members)),
        bodies=tuple(b for b, mover in enumerate(moved) if mover in around_planets),
        springs=tuple(springs),
        supports=tuple(e for e in held if e not in springs),
    )


def _moved_by(system: System) -> list[int]:
    """Body that moves each body: itself, or the one to which it is fixed; 0: none."""
    found = [0]
    for row in system.program["body"][1:]:
        parent = int(row["spinner"]) or int(row["parent"])
        follows = row["n"] == 0 and not row["shares"]
        found.append(found[parent] if follows else len(found))
    return found


def type_of_mode(planets: PlanetSet, twist: Complex, wrench: Complex, kinetic: Array, strain: Array) -> str:
    """Type of a mode of a set; "" if it is mixed, or no mode of the set.

    Parameters
    ----------
    planets
        The set.
    twist, wrench
        Motions and inertia wrenches of the bodies in body axes, shape (nb, 6).
    kinetic
        Shares of the kinetic energy by part that moves and direction, shape (parts, 4).
    strain
        Shares of the components in the strain energy, without signs.
    """
    coupled = strain[list(planets.springs)].sum()
    if coupled < COUPLED or coupled + strain[list(planets.supports)].sum() < OWN:
        return ""
    each = np.zeros(3)
    for own, angles in zip(planets.planets, planets.angles, strict=True):
        each += _shares(np.array(angles), *(v[list(own)] for v in (twist, wrench)))
    size = max(float(each.sum()), 1e-300)
    moving = float(kinetic[list(planets.parts)].sum())
    motion = (twist.conj() * wrench).real
    scale = float(kinetic[:, :3].sum()) / max(float(motion.sum()), 1e-300)
    motion = scale * motion[list(planets.bodies)].sum(axis=0)
    middle = np.array([motion[[0, 1, 3, 4]].sum(), motion[2], motion[5]])
    found = each / size * moving
    found += (middle[1] + middle[2], middle[0], 0.0)
    whole = float(found.sum())
    if whole < OWN:
        return ""
    if middle.sum() < STILL * whole:
        return PLANET
    best = int(np.argmax(found))
    if found[best] < PURE * whole:
        return ""
    axial = float(kinetic[list(planets.parts), 1].sum() + middle[1])
    return AXIAL if TYPES[best] == ROTATIONAL and axial > 0.5 * found[best] else TYPES[best]


def _shares(angles: Array, twist: Complex, wrench: Complex) -> Array:
    """Kinetic energy of a group of planets by type of motion.

    Parameters
    ----------
    angles
        Angles of the planets [rad], shape (N,).
    twist, wrench
        Their motions and inertia wrenches, shape (N, 6).
    """
    c, s = np.cos(angles), np.sin(angles)
    turn = np.zeros((len(angles), 3, 3))
    turn[:, 0, 0], turn[:, 0, 1], turn[:, 1, 0], turn[:, 1, 1], turn[:, 2, 2] = c, s, -s, c, 1.0
    alike = np.full((len(angles), 1), len(angles) ** -0.5)
    lateral = np.linalg.qr(np.stack([c - c.mean(), s - s.mean()], axis=1))[0]
    local = [
        np.einsum("pij,pkj->pki", turn, values.reshape(-1, 2, 3)).reshape(-1, 6) for values in (twist, wrench)
    ]
    whole = float((local[0].conj() * local[1]).real.sum())
    found = [
        float(((basis.T @ local[0]).conj() * (basis.T @ local[1])).real.sum()) for basis in (alike, lateral)
    ]
    return np.array([*found, whole - sum(found)])
