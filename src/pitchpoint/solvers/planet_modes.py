# SPDX-License-Identifier: Apache-2.0
"""Planetary sets with equally spaced planets, and the three types of their modes.

With N equal planets at equal angles the motion of a mode repeats from planet to planet, up to a factor
e^(2 pi i h/N) in the radial and tangential directions of each planet [1]_:

* h = 0, rotational modes: all planets move alike, sun, ring and carrier only rotate and move axially; axial
  modes if most of the energy is axial, as in helical sets [2]_;
* h = 1 or -1, translational modes, in pairs: sun, ring and carrier only move laterally and tilt;
* other h, planet modes, N - 3 of each: sun, ring and carrier are at rest. If these cannot move laterally, the
  modes with h = 1 or -1 are planet modes, too.

The energies by h follow from the discrete Fourier transform of the planets' motions and inertia forces.

A mode is one of the set if the set has half of the energies: the kinetic energy of planets and central
bodies, and the strain energy of meshes, planet bearings and the supports of central bodies. Of an elastic
shaft only the stations with the gear or the carrier, and what is fixed to them, are central bodies. Where
meshes and planet bearings have less than a tenth of the strain energy, the central body moves on its own
supports.

References
----------
.. [1] J. Lin, R. G. Parker: Analytical characterization of the unique properties of planetary gear free
   vibration, Journal of Vibration and Acoustics 121 (1999) 316-321.
.. [2] T. Eritenel, R. G. Parker: Modal properties of three-dimensional helical planetary gears, Journal of
   Sound and Vibration 325 (2009) 397-420.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.system.meshes import mesh_records

if TYPE_CHECKING:
    from pitchpoint.solvers.machine_groups import Groups
    from pitchpoint.system.system import System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

EVEN = 1e-3
"""Tolerance of equal angles [rad] and radii (relative)."""
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
    """Equally spaced planets and the bodies around them.

    Parameters
    ----------
    name
        Planetary stage of the model file, "planetary stage set"; without one, "planetary set" with the name
        of the carrier, else of the sun.
    planets
        Bodies with the gears of the planets, in order of the angle.
    angles
        Angles of the planets in the axes of the first one [rad].
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
    planets: tuple[int, ...]
    angles: tuple[float, ...]
    parts: tuple[int, ...]
    central: tuple[int, ...]
    bodies: tuple[int, ...]
    springs: tuple[int, ...]
    supports: tuple[int, ...]


def planet_sets(system: System, groups: Groups, place: Array, axes: Array) -> tuple[PlanetSet, ...]:
    """Sets of three or more equal planets at equal angles around a central gear.

    Planets have a carrier that rotates, or are in mesh with two central gears. Wheels on fixed axes around a
    crankshaft gear are none.

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
    found: dict[frozenset[int], tuple[list[int], Array, list[int]]] = {}
    for body, others in mates.items():
        planets = list(dict.fromkeys(others))
        angles = _angles(planets, body, place, axes) if len(planets) > 2 else None
        if angles is not None:
            found.setdefault(frozenset(planets), (planets, angles, []))[2].append(body)
    sets = []
    for planets, angles, central in found.values():
        carriers = _carriers(system, planets, central)
        turning = any(groups.rotates[groups.carried[b]] for b in carriers)
        if turning or len(central) > 1:
            sets.append(_set(system, groups, planets, angles, central, carriers))
    return tuple(sets)


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
    """Angles of planets about a central body; None unless they are equally spaced on a circle."""
    way = (place[planets] - place[body]) @ axes[planets[0]]
    radii, angles = np.hypot(way[:, 0], way[:, 1]), np.arctan2(way[:, 1], way[:, 0])
    steps = np.diff(np.sort(angles))
    alike = radii.min() > 0.0 and np.ptp(radii) <= EVEN * radii.max()
    even = np.abs(steps - 2.0 * np.pi / len(planets)).max() <= EVEN
    return angles if alike and even else None


def _set(
    system: System, groups: Groups, planets: list[int], angles: Array, central: list[int], carriers: list[int]
) -> PlanetSet:
    """Set with its central bodies and its name."""
    members = [*(b for b in central if b), *carriers]
    moved = _moved_by(system)
    around_planets = {moved[b] for b in members} - {0}
    parts = tuple(dict.fromkeys(groups.carried[p] for p in planets))
    springs = [e for e, ends in enumerate(groups.ends) if set(ends) & set(parts)]
    held = [
        e for e, own in enumerate(groups.bodies) if {moved[b] for b in own} - {0} <= around_planets and own
    ]
    order = np.argsort(angles)
    around = groups.parts[groups.part[(carriers or members)[0]]]
    stages = system.model.planetary_stages.items() if system.model is not None else ()
    return PlanetSet(
        name=next(
            (f"planetary stage {stage}" for stage, part in stages if part.carrier == around),
            f"planetary set {around}",
        ),
        planets=tuple(planets[k] for k in order),
        angles=tuple(float(angles[k]) for k in order),
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
    own = list(planets.planets)
    angles = np.array(planets.angles)
    c, s = np.cos(angles), np.sin(angles)
    turn = np.zeros((len(own), 3, 3))
    turn[:, 0, 0], turn[:, 0, 1], turn[:, 1, 0], turn[:, 1, 1], turn[:, 2, 2] = c, s, -s, c, 1.0
    waves = []
    for values in (twist, wrench):  # radial and tangential directions, then by cycles around the set
        local = np.einsum("pij,pkj->pki", turn, values[own].reshape(-1, 2, 3)).reshape(-1, 6)
        waves.append(np.fft.fft(local, axis=0, norm="ortho"))
    each = (waves[0].conj() * waves[1]).real.sum(axis=1)
    size = max(float(each.sum()), 1e-300)
    moving = float(kinetic[list(planets.parts)].sum())
    motion = (twist.conj() * wrench).real
    scale = float(kinetic[:, :3].sum()) / max(float(motion.sum()), 1e-300)
    motion = scale * motion[list(planets.bodies)].sum(axis=0)
    middle = np.array([motion[[0, 1, 3, 4]].sum(), motion[2], motion[5]])
    found = np.array([each[0], each[1] + each[-1], each[2:-1].sum()]) / size * moving
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
