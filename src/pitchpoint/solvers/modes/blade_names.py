# SPDX-License-Identifier: Apache-2.0
"""Names of modes of beams and of the blades of a rotor, in the words of wind turbines.

A mode has the name of the structure with the largest share of the strain energy, at least `MAIN` of it: a
beam, all blades of a rotor, or the drive train between a rotor and the other end. Its direction is that of
the largest kinetic energy of the structure in its own axes:

* beam between other bodies: along and across the axis of the rotor that it carries (fore-aft, side-to-side),
  or in its own axes, also of a main shaft; along and about the beam;
* blades: relative to the motion of their roots, along the flapwise and the edgewise axis of the root, and
  about the blade. All blades together: collective. Else at rest by the axis of the moment (flapwise: yaw,
  tilt) or of the force (edgewise: vertical, horizontal) on the hub; at speed forward (progressive) or
  backward (regressive) whirl.

B modes of B blades have one number: a collective one and those that whirl.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.frames import beam_frame
from pitchpoint.solvers.modes.structures import BLADES

if TYPE_CHECKING:
    from pitchpoint.solvers.modes.energies import Motions
    from pitchpoint.system.system import System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

MAIN = 0.35
"""Least share of a structure in the strain energy of a mode with its name."""
TAKES_PART = 0.25
"""Least share of the strain energy of drive train and of blades in a torsion that bends blades, too."""
MOVES = 0.05
"""Least share of the rotor in the kinetic energy of torsion of the drive train: that of a rigid rotor of 19
times the inertia of the other end. Modes inside of the gearbox of a 5 MW turbine have less than 0.01."""
INCLINED = math.sqrt(0.5)
"""Cosine of the least angle between a beam and the axis of a rotor that it lies across."""
DRIVE_TRAIN = "drive train"
COLLECTIVE = "collective"
FLAP, EDGE, TWIST = "flapwise", "edgewise", "torsion of the blades"
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class _Blades:
    """Blades of a rotor: part, hub, axis of the rotor; of each blade its bodies from the root, and in world
    axes the flapwise, edgewise and longitudinal direction, shape (3, 3)."""

    part: int
    hub: int
    axis: Array
    bodies: tuple[tuple[int, ...], ...]
    directions: tuple[Array, ...]


@dataclass(frozen=True)
class BeamName:
    """Words of a name, direction at rest, number of modes that share a number (1: none)."""

    words: str
    mark: str = ""
    family: int = 1


class StructureNames:
    """Names of the modes of beams and blades of one system.

    Parameters
    ----------
    system, motions
        The system and its motions at the operating point.
    """

    def __init__(self, system: System, motions: Motions) -> None:
        self.motions, groups = motions, motions.groups
        model = system.model
        self.blades: list[_Blades] = []
        self.beams: dict[int, tuple[tuple[int, ...], Array]] = {}
        self.labels: dict[str, int] = {}
        self.crossing: set[int] = set()
        """Beams across the axis of a rotor, such as towers."""
        if model is None:
            return
        names = list(system.layout.bodies)
        for rotor, own in model.wind_rotors.items():
            group = f"{BLADES} {rotor}"
            if own.beams and group in groups.parts:
                self.blades.append(_blades_of(system, motions, rotor, groups.parts.index(group)))
        axis = self.blades[0].axis if self.blades else None
        for name, beam in model.beams.items():
            nodes = tuple(b for b, label in enumerate(names) if label.startswith(f"{name}."))
            own_labels = [
                label
                for label, bodies in zip(groups.components, groups.bodies, strict=True)
                if label.endswith(f" {name}") and not bodies.isdisjoint(nodes)
            ]
            if not own_labels or name not in groups.parts:
                continue
            self.labels[own_labels[0]] = groups.parts.index(name)
            ends = [motions.place[_body(names, end)] for end in beam.ends]
            along = _unit(ends[1] - ends[0])
            crosses = axis is not None and abs(float(axis @ along)) < INCLINED
            across = axis if axis is not None and crosses else beam_frame(model, beam)[1][:, 0]
            first = _unit(across - (across @ along) * along)
            self.beams[groups.parts.index(name)] = (nodes, np.array([first, np.cross(along, first), along]))
            if crosses:
                self.crossing.add(groups.parts.index(name))

    def name(self, strain: Array, twist: Complex, wrench: Complex) -> BeamName | None:
        """Name of a mode from the shares of the components in its strain energy; None: no such mode.

        Parameters
        ----------
        strain
            Shares, shape (components,).
        twist, wrench
            Motions of the bodies and wrenches of their inertia, body axes, shape (nb, 6).
        """
        if not (self.beams or self.blades):
            return None
        groups = self.motions.groups
        sums: dict[str, float] = {}
        for e, label in enumerate(groups.components):
            key = label if label in self.labels or label.startswith(f"{BLADES} ") else ""
            key = key or (DRIVE_TRAIN if self._drives(e) else f"other {e}")
            sums[key] = sums.get(key, 0.0) + float(strain[e])
        most = max(sums, key=sums.__getitem__)
        if self._is_of_drive_train(sums, most, twist, wrench):
            return BeamName("drive-train torsion")
        if sums[most] < MAIN:
            return None
        moved, forces = (_in_world(self.motions.axes, x) for x in (twist, wrench))
        for own in self.blades:
            if most == f"{BLADES} {groups.parts[own.part].removeprefix(f'{BLADES} ')}":
                return self._of_blades(own, moved, forces)
        if most in self.labels:
            part = self.labels[most]
            return self._of_beam(part, *self.beams[part], moved, forces)
        return None

    def _drives(self, e: int) -> bool:
        """Whether a component is a spring or mesh between rotating parts, one of which is not a blade."""
        groups = self.motions.groups
        ends = groups.ends[e]
        bladed = {own.part for own in self.blades}
        return bool(
            self.blades
            and groups.springs[e]
            and ends
            and all(groups.rotates[part] and part not in bladed for part in ends)
            and not groups.components[e].startswith("actuator")
        )

    def _is_of_drive_train(
        self, sums: Mapping[str, float], most: str, twist: Complex, wrench: Complex
    ) -> bool:
        """Whether the rotor turns against the other end of the drive train.

        Most of the strain is in the drive train and the rotor moves with it; modes inside of a gearbox do not
        move it. Or the drive train shares the strain with blades that bend edgewise together, and the other
        end turns.
        """
        groups = self.motions.groups
        bladed = {own.part for own in self.blades}
        each = (twist.conj() * wrench).real
        whole = max(float(each.sum()), 1e-300)
        other = [b for b, p in enumerate(groups.carried) if p >= 0 and groups.rotates[p] and p not in bladed]
        blades = [b for b, p in enumerate(groups.carried) if p in bladed]
        turning, rotor = float(each[other, 5].sum()) / whole, float(each[blades].sum()) / whole
        bends = max((share for name, share in sums.items() if name.startswith(BLADES)), default=0.0)
        twists = sums.get(DRIVE_TRAIN, 0.0)
        mainly = most == DRIVE_TRAIN and twists >= MAIN and rotor >= MOVES
        return mainly or (twists >= TAKES_PART and bends >= TAKES_PART and turning >= MAIN)

    def _of_beam(
        self, part: int, nodes: Sequence[int], directions: Array, moved: Complex, forces: Complex
    ) -> BeamName:
        """Name of a mode of a beam between other bodies."""
        own = list(nodes)
        energy = [float(((moved[own, :3] @ e).conj() * (forces[own, :3] @ e)).real.sum()) for e in directions]
        about = moved[own, 3:] @ directions[2], forces[own, 3:] @ directions[2]
        energy.append(float((about[0].conj() * about[1]).real.sum()))
        name = self.motions.groups.parts[part]
        way = int(np.argmax(energy))
        if way == 3:
            return BeamName(f"torsion of {name}")
        if way == 2:
            return BeamName(f"axial mode of {name}")
        if part in self.crossing:
            return BeamName(f"{name} {('fore-aft', 'side-to-side')[way]}", family=-1)
        return BeamName(f"bending of {name}", f"axis {way + 1}", family=-1)

    def _of_blades(self, rotor: _Blades, moved: Complex, forces: Complex) -> BeamName:
        """Name of a mode of the blades of a rotor."""
        place = self.motions.place
        motion: list[list[Complex]] = [[], [], []]
        for bodies, directions in zip(rotor.bodies, rotor.directions, strict=True):
            own, root = list(bodies), bodies[0]
            arms = place[own] - place[root]
            relative = moved[own, :3] - moved[root, :3] - np.cross(moved[root, 3:], arms)
            sizes = [np.abs(x[own, :3]).sum(axis=1) for x in (forces, moved)]
            mass = np.divide(sizes[0], sizes[1], out=np.zeros(len(own)), where=sizes[1] > 0.0)
            for way in range(2):
                motion[way].append(np.sqrt(mass) * (relative @ directions[way]))
            about, moment = moved[own, 3:] @ directions[2], forces[own, 3:] @ directions[2]
            inertia = np.divide(np.abs(moment), np.abs(about), out=np.zeros(len(own)), where=about != 0.0)
            motion[2].append(np.sqrt(inertia) * about)
        energy = [float(np.linalg.norm(np.array(own)) ** 2) for own in motion]
        way = int(np.argmax(energy))
        words = (FLAP, EDGE, TWIST)[way]
        return BeamName(words, self._pattern(rotor, np.array(motion[way]), way), family=len(rotor.bodies))

    def _pattern(self, rotor: _Blades, motion: Complex, way: int) -> str:
        """Collective, or the direction at rest; `motion`: of the bodies of each blade, shape (B, n)."""
        up = UP - (UP @ rotor.axis) * rotor.axis
        if not np.linalg.norm(up) > 1e-6:
            up = self.motions.axes[rotor.hub][:, 0]
        up = _unit(up)
        left = np.cross(rotor.axis, up)
        along = np.array([directions[2] for directions in rotor.directions])
        shares = np.array([np.ones(len(along)), *(math.sqrt(2.0) * (along @ e) for e in (up, left))])
        sizes = np.linalg.norm(shares @ motion, axis=1)
        words = (COLLECTIVE, "tilt", "yaw") if way != 1 else (COLLECTIVE, "horizontal", "vertical")
        return words[int(np.argmax(sizes))]


def _blades_of(system: System, motions: Motions, rotor: str, part: int) -> _Blades:
    """Blades of a wind rotor, whose beams give their axes."""
    assert system.model is not None
    model, names = system.model, list(system.layout.bodies)
    own = model.wind_rotors[rotor]
    hub = names.index(own.hub.partition(".")[0])
    drawn = [np.asarray(body.axes, float) for body in system.bodies]
    bodies, directions = [], []
    for name in own.beams:
        beam = model.beams[name]
        root, tip = (_body(names, end) for end in beam.ends)
        nodes = [b for b, label in enumerate(names) if label.startswith(f"{name}.")]
        turned = motions.axes[root] @ drawn[root - 1].T  # from the drawing to the operating point
        along = _unit(motions.place[nodes[0] if nodes else tip] - motions.place[root])
        flat = turned @ beam_frame(model, beam)[1][:, 0]
        flap = _unit(flat - (flat @ along) * along)
        directions.append(np.array([flap, np.cross(along, flap), along]))
        bodies.append((root, *nodes, tip))
    return _Blades(part, hub, motions.axes[hub][:, 2].copy(), tuple(bodies), tuple(directions))


def _body(names: Sequence[str], end: str) -> int:
    """Body of an end of a beam; ground is 0."""
    base = end.partition(".")[0]
    return names.index(base) if base in names else 0


def _unit(vector: Array) -> Array:
    """Vector of length one."""
    return np.asarray(vector / max(float(np.linalg.norm(vector)), 1e-300))


def _in_world(axes: Array, x: Complex) -> Complex:
    """Twists or wrenches (nb, 6) from body axes in world axes."""
    return np.concatenate(
        [np.einsum("bij,bj->bi", axes, x[:, :3]), np.einsum("bij,bj->bi", axes, x[:, 3:])], axis=1
    )
