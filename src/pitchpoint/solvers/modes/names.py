# SPDX-License-Identifier: Apache-2.0
"""Names of modes, by what they do: from their energies and shapes.

The name is that of the first rule that applies; shares are those of the kinetic or strain energy:

1. rigid modes, without strain: rigid rotation, rigid motion;
2. modes of beams and of blades (`blade_names`);
3. half of the kinetic energy in the modal coordinates of an elastic body: elastic mode of the body; of a
   flexible rim: ring mode with the number of waves that has most of it;
4. half of both in a planetary set (`planet_modes`), in one of its three types: rotational, translational,
   planet mode; but tilting of the central body that has half of the energy is named as such;
5. half of the strain energy in the mean deflection of the teeth: mesh mode. The energy of flanks that tilt
   against each other does not count: what moves there is the tilting body;
6. otherwise the largest motion. Rotation about the axes is torsion, of parts that rotate against each other
   relative to the gear ratios. Lateral motion of a shaft is bending if its beams have 30 % of the strain
   energy of beams and supports, otherwise translation or tilting of the shaft on its bearings.

Modes of one kind are numbered by frequency. The two modes of a lateral pair have one number; they differ by
the whirl at speed, or by the direction at rest.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.kind import MESH
from pitchpoint.multibody.ring_modes import waves_of
from pitchpoint.solvers.gear_trains import rotations, turning_spins
from pitchpoint.solvers.modes.blade_names import COLLECTIVE, StructureNames
from pitchpoint.solvers.modes.energies import PLANAR, Energies, Motions
from pitchpoint.solvers.modes.machine_groups import SHAFT
from pitchpoint.solvers.modes.planets import PLANET, TRANSLATIONAL, PlanetSet, planet_sets, type_of_mode

if TYPE_CHECKING:
    from pitchpoint.system.system import System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

MAIN = 0.5
"""Share of the energy from which a mesh or an elastic body names a mode."""
BENDS = 0.3
"""Share of its beams in the strain energy of a shaft and its supports from which it bends."""
TURNS = 1e-9
"""Speed over the highest speed of a train from which a body belongs to it."""
AGAINST = 0.05
"""Least share of a part in the rotational energy that is named."""
SAME_PLANE = 0.7
"""Cosine from which two lateral motions are in the same plane."""
MULTIPLE = 1e-4
"""Relative distance of frequencies up to which modes of a planetary set are copies of one."""
OBLIQUE = 0.4
"""Component of a direction from which its axis is named."""
NO_WHIRL = ("", PLANAR)
"""Words for the whirl of a mode that does not."""
TILTING = "tilting"
"""First word of the names of tilting modes."""
FEW = 2
"""Maximum number of parts or meshes listed in a name."""


@dataclass(eq=False)
class _Named:
    """Name without number and direction.

    `ordinal`: the number is written also if it is 1; `plane`: direction of the lateral motion in body axes,
    for modes that occur in pairs, of which unequal planets or supports split the frequency; `mark`: this
    direction in words; `multiple`: copies of one frequency share a number; `omega` [rad/s]; `blades`: number
    of blades, whose modes in one direction share a number.
    """

    words: str
    ordinal: bool = False
    plane: Array | None = None
    mark: str = ""
    multiple: bool = False
    number: int = 1
    omega: float = 0.0
    blades: int = 0

    @property
    def whirls(self) -> bool:
        """Whether the mode can whirl."""
        return self.plane is not None or self.multiple


def base_names(
    system: System, motions: Motions, omega: Array, shapes: NDArray[np.inexact], energies: Energies
) -> list[_Named]:
    """Names of undamped modes at rest in ascending order, without the direction of whirl.

    Parameters
    ----------
    system, motions
        The system, and its motions at the operating point.
    omega, shapes
        Circular frequencies (n,), zero for rigid modes, and shapes (n, nd).
    energies
        Energies of these modes.
    """
    namer = _Namer(system, motions, energies, int(np.sum(omega == 0.0)) > 1)
    twist, wrench = motions.of(np.asarray(shapes, dtype=np.complex128))
    M = motions.parts.M
    inertia = ((np.conj(shapes) @ M) * shapes).real
    found = [namer.name(k, bool(omega[k] == 0.0), twist[k], wrench[k], inertia[k]) for k in range(len(omega))]
    for one, frequency in zip(found, omega, strict=True):
        one.omega = float(frequency)
    _number(found)
    return found


def full_names(
    named: Sequence[_Named], whirls: Sequence[str] | None = None, blades: Sequence[str] | None = None
) -> tuple[str, ...]:
    """Names with number and direction: the whirl, or the direction at rest.

    Parameters
    ----------
    named
        Result of `base_names`.
    whirls
        Whirl of each mode at speed; "" or "planar" for none.
    blades
        Motion of the blades in multi-blade coordinates, for modes of blades.

    Examples
    --------
    >>> x, y = np.eye(3)[:2]
    >>> pair = [_Named("bending of rotor", True, x, "x"), _Named("bending of rotor", True, y, "y")]
    >>> full_names(pair)
    ('1st bending of rotor (x)', '1st bending of rotor (y)')
    >>> full_names(pair, ["backward", "forward"])
    ('1st bending of rotor (backward)', '1st bending of rotor (forward)')
    """
    marks = [
        blades[k]
        if blades and one.blades
        else whirls[k]
        if whirls and whirls[k] not in NO_WHIRL and one.whirls
        else one.mark
        for k, one in enumerate(named)
    ]
    plain = [_numbered(one) for one in named]
    pairs = list(zip(plain, marks, strict=True))
    for k, pair in enumerate(pairs):
        if pairs.count(pair) > 1:
            letter = "abcdefgh"[min(pairs[:k].count(pair), 7)]
            marks[k] = f"{pair[1]} {letter}" if pair[1] else letter
    return tuple(f"{name} ({mark})" if mark else name for name, mark in zip(plain, marks, strict=True))


def _numbered(one: _Named) -> str:
    """Name with its number: bending always, others from the second."""
    if one.number == 1 and not one.ordinal:
        return one.words
    return f"{ordinal(one.number)} {one.words}"


def ordinal(number: int) -> str:
    """Ordinal number.

    Examples
    --------
    >>> [ordinal(k) for k in (1, 2, 3, 4, 11, 22)]
    ['1st', '2nd', '3rd', '4th', '11th', '22nd']
    """
    ending = "th" if number % 100 in (11, 12, 13) else {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
    return f"{number}{ending}"


def _number(found: Sequence[_Named]) -> None:
    """Number the modes of each kind, of a beam those along each axis.

    Two modes with different planes of motion share a number, as do translational modes of a planetary set,
    and all copies of a multiple frequency of its planet modes.
    """
    kinds: dict[tuple[str, str], list[list[_Named]]] = {}
    for one in found:
        taken = kinds.setdefault((one.words, one.mark * (one.plane is None and not one.blades)), [])
        for number, members in enumerate(taken, start=1):
            if _same(one, members):
                members.append(one)
                one.number = number
                break
        else:
            taken.append([one])
            one.number = len(taken)


def _same(one: _Named, members: Sequence[_Named]) -> bool:
    """Whether a mode has the number of some others of its kind."""
    first = members[0]
    if one.blades:
        together = [other.mark == COLLECTIVE for other in (*members, one)]
        return together.count(True) <= 1 and together.count(False) <= one.blades - 1
    if one.plane is not None and first.plane is not None:
        return len(members) == 1 and abs(float(one.plane @ first.plane)) < SAME_PLANE
    return one.multiple and one.omega - first.omega <= MULTIPLE * one.omega


class _Namer:
    """Names of the modes of one system."""

    def __init__(self, system: System, motions: Motions, energies: Energies, several: bool) -> None:
        self.system, self.motions, self.energies, self.several = system, motions, energies, several
        self.groups = motions.groups
        self.sets = planet_sets(system, self.groups, motions.place, motions.axes)
        self.structures = StructureNames(system, motions)
        self.trains: dict[int, Array] = {}
        count = len(self.groups.parts)
        self.moved_by = np.zeros((count, count))  # energies of fixed bodies go to the part that carries them
        for part, carried in zip(self.groups.part, self.groups.carried, strict=True):
            if part >= 0:
                self.moved_by[carried, part] = 1.0

    def name(self, k: int, rigid: bool, twist: Complex, wrench: Complex, inertia: Array) -> _Named:
        """Name of mode k with the kinetic energies `inertia` of the coordinates."""
        kinetic = np.einsum("ab,bw->aw", self.moved_by, self.energies.kinetic[k])
        strain = np.abs(self.energies.strain[k])
        strain = strain / max(float(strain.sum()), 1e-300)
        if rigid:
            return _Named(self._rigid(kinetic))
        elastic = int(np.argmax(kinetic[:, 3]))
        if kinetic[elastic, 3] >= MAIN:
            return self._elastic(elastic, inertia)
        structure = self.structures.name(strain, twist, wrench)
        if structure is not None:
            blades = max(structure.family, 0)
            blades = blades if blades > 1 else 0
            return _Named(structure.words, structure.family != 1, mark=structure.mark, blades=blades)
        for planets in self.sets:
            kind = type_of_mode(planets, twist, wrench, kinetic, strain)
            if kind:
                tilts = self._tilts(planets, kinetic, strain, twist, wrench)
                if kind == TRANSLATIONAL and tilts is not None:
                    return tilts
                words = f"{kind} mode of {planets.name}"
                plane = self._plane_of(planets.bodies, twist, wrench) if kind == TRANSLATIONAL else None
                return _Named(words, True, plane=plane, multiple=kind == PLANET)
        teeth = self.energies.teeth[k]
        if teeth.sum() >= MAIN:
            return _Named(f"mesh mode of {self._meshes(teeth)}")
        return self._motion(kinetic, strain, twist, wrench)

    def _elastic(self, part: int, inertia: Array) -> _Named:
        """Name of a mode of an elastic body, or of a flexible rim."""
        waves: dict[int, float] = {}
        for d, own in enumerate(self.groups.deflects):
            if own == part:
                n = waves_of(self.system.layout.coordinates[d])
                waves[n] = waves.get(n, 0.0) + float(inertia[d])
        most = max(waves, key=waves.__getitem__)
        name = self.groups.parts[part]
        return _Named(f"ring mode of {name}, n = {most}") if most else _Named(f"elastic mode of {name}", True)

    def _rigid(self, kinetic: Array) -> str:
        """Name of a mode without strain."""
        turning = kinetic[:, 2]
        if turning.sum() < 0.7 * kinetic.sum():
            return f"rigid motion of {self._listed(kinetic.sum(axis=1), 0.01)}"
        return f"rigid rotation of {self._listed(turning, 0.01)}" if self.several else "rigid rotation"

    def _listed(self, shares: Array, least: float) -> str:
        """Names of the parts with the largest shares."""
        order = [k for k in np.argsort(-shares, kind="stable") if shares[k] > least * shares.sum()]
        names = [self.groups.parts[k] for k in order]
        return ", ".join(names) if len(names) <= 3 else f"{', '.join(names[:2])} and {len(names) - 2} more"

    def _tilts(
        self, planets: PlanetSet, kinetic: Array, strain: Array, twist: Complex, wrench: Complex
    ) -> _Named | None:
        """Tilting of the central body of a set that has most of the energy; None if it does not tilt."""
        part = max(planets.central, key=lambda p: kinetic[p].sum(), default=-1)
        if part < 0 or kinetic[part].sum() < MAIN:
            return None
        found = self._lateral(part, strain, twist, wrench)
        return found if found.words.startswith(TILTING) else None

    def _meshes(self, teeth: Array) -> str:
        """Names of the meshes with the largest energy of tooth deflection."""
        names = [name for name, own in zip(self.motions.laws, teeth, strict=True) if own > 0.5 * teeth.max()]
        return " and ".join(names) if len(names) <= FEW else f"{names[0]} and {len(names) - 1} more"

    def _motion(self, kinetic: Array, strain: Array, twist: Complex, wrench: Complex) -> _Named:
        """Name from the largest motion."""
        rotating = np.array(self.groups.rotates)
        torsion = float(kinetic[rotating, 2].sum())
        others = kinetic[:, :2].copy()
        others[~rotating] = 0.0
        still = np.where(rotating, 0.0, kinetic[:, :3].sum(axis=1))
        part, way = (
            (int(k) for k in np.unravel_index(np.argmax(others), others.shape)) if others.size else (0, 0)
        )
        lateral = float(others[part, way]) if others.size else 0.0
        fixed = int(np.argmax(still)) if still.size else 0
        if torsion >= max(lateral, float(still.max(initial=0.0))):
            return _Named(self._torsion(kinetic[:, 2] * rotating, strain, twist, wrench))
        if still.size and still[fixed] >= lateral:
            return _Named(self._of_housing(fixed, twist, wrench))
        name = self.groups.parts[part]
        if way == 1:
            return _Named(f"axial mode of {name}")
        return self._lateral(part, strain, twist, wrench)

    def _bodies(self, *parts: int) -> list[int]:
        """Bodies that move with some parts, without their modal coordinates if there are others."""
        own = [b for b, part in enumerate(self.groups.carried) if part in parts]
        return [b for b in own if b not in self.groups.hidden] or own

    def _plane_of(self, bodies: Sequence[int], twist: Complex, wrench: Complex) -> Array:
        """Direction of the largest lateral motion of some bodies."""
        own = list(bodies)
        return _main_direction(twist[own], (twist[own].conj() * wrench[own]).real)

    def _lateral(self, part: int, strain: Array, twist: Complex, wrench: Complex) -> _Named:
        """Bending of a shaft, or its translation or tilting."""
        name, bodies = self.groups.parts[part], self._bodies(part)
        each = (twist[bodies].conj() * wrench[bodies]).real
        force = wrench[bodies][:, :2]
        size = np.linalg.norm(twist[bodies][:, :2], axis=1)
        masses = np.divide(np.linalg.norm(force, axis=1), size, out=np.zeros(len(size)), where=size > 0.0)
        pull = force.sum(axis=0)
        mean = float(np.vdot(pull, pull).real) / max(float(masses.sum()), 1e-300)
        own = each[:, [0, 1, 3, 4]].sum()
        beams = held = 0.0
        for e, word in enumerate(self.groups.kinds):
            if word == SHAFT and self.groups.ends[e] == (part,):
                beams += strain[e]
            elif word != MESH and part in self.groups.ends[e]:
                held += strain[e]
        plane = _main_direction(twist[bodies], each)
        mark = "".join(letter for letter, size in zip("xyz", np.abs(plane), strict=True) if size > OBLIQUE)
        if beams > 0.0 and beams >= BENDS * (beams + held):
            return _Named(f"bending of {name}", True, plane, mark=mark)
        word = "translation" if mean >= MAIN * own else TILTING
        return _Named(f"{word} of {name}", False, plane, mark=mark)

    def _torsion(self, kinetic: Array, strain: Array, twist: Complex, wrench: Complex) -> str:
        """Parts that rotate against each other, relative to the ratios of their train."""
        groups = self.groups
        each = (twist[:, 5].conj() * wrench[:, 5]).real
        body = self.system.program["body"]
        lead = int(np.argmax(np.where(body["spin"] >= 0, each, -np.inf)))
        spin = int(body[lead]["spin"])
        rates = np.ones(len(body))
        if spin >= 0:
            rates = self._rates(spin)
        swing = (twist[:, 5] * np.conj(twist[lead, 5])).real * rates * rates[lead]
        sides: dict[int, list[float]] = {}
        for b, part in enumerate(groups.carried):
            if part >= 0 and kinetic[part] > 0.0 and abs(rates[b]) > TURNS * np.abs(rates).max():
                sides.setdefault(part, [0.0, 0.0])[int(swing[b] < 0.0)] += float(each[b])
        whole = max(sum(map(sum, sides.values())), 1e-300)
        with_lead = {p: s[0] for p, s in sides.items() if s[0] >= max(s[1], AGAINST * whole)}
        against = {p: s[1] for p, s in sides.items() if s[1] > s[0] and s[1] >= AGAINST * whole}
        if with_lead and against:
            pair = sorted((max(with_lead, key=with_lead.__getitem__), max(against, key=against.__getitem__)))
            return f"torsion of {groups.parts[pair[0]]} against {groups.parts[pair[1]]}"
        part = groups.carried[lead]
        e = int(np.argmax(strain)) if strain.size else -1
        if e < 0 or not groups.springs[e]:
            return f"rotation of {groups.parts[part]}"
        held = groups.kinds[e] != SHAFT and len(groups.ends[e]) < 2
        if held and spin in turning_spins(self.system):  # its bearings do not resist the rotation
            return f"rotation of {groups.parts[part]}"
        return f"torsion of {groups.parts[part]}" + (" against ground" if held else "")

    def _rates(self, spin: int) -> Array:
        """Rotation of all bodies about their axes for one spin at 1 rad/s, through its train."""
        if spin not in self.trains:
            train = rotations(self.system, (spin,))[:, 0].astype(np.complex128)
            self.trains[spin] = self.motions.of(train[None])[0][0, :, 5].real
        return self.trains[spin]

    def _of_housing(self, part: int, twist: Complex, wrench: Complex) -> str:
        """Motion of a body that does not rotate: the axis of its largest motion."""
        bodies = self._bodies(part)
        energy = (twist[bodies].conj() * wrench[bodies]).real.sum(axis=0)
        way = int(np.argmax(energy))
        word = "translation" if way < 3 else "rotation"
        return f"{word} {'xyz'[way % 3]} of {self.groups.parts[part]}"


def _main_direction(twist: Complex, each: Array) -> Array:
    """Direction of the largest lateral motion of bodies, unit vector in their axes, shape (3,).

    Tilt counts as the lateral motion that it causes: a rotation about x moves the shaft along y.
    """
    tensor = np.zeros((2, 2))
    for t, energy in zip(twist, each, strict=True):
        for vector, weight in ((t[:2], energy[:2].sum()), (np.array([t[4], -t[3]]), energy[3:5].sum())):
            size = float(np.vdot(vector, vector).real)
            if size > 0.0:
                tensor += max(float(weight), 0.0) / size * np.outer(vector, vector.conj()).real
    return np.append(np.linalg.eigh(tensor)[1][:, -1], 0.0)
