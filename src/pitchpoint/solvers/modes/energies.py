# SPDX-License-Identifier: Apache-2.0
"""Energies of modes: strain by component, kinetic by part and direction, gyroscopic, and whirl of shafts.

For a mode x = Re(z e^(lambda t)) the means over a cycle, without the decay, are

    strain   V = 1/4 sum_e z^H K_e z
    kinetic  T = 1/4 |lambda|^2 sum_b z^H M_b z
    gyroscopic E = -1/4 |lambda|^2 z^H D_a z/(i omega), D_a = (D - D^T)/2

with T = V + E for symmetric K: the gyroscopic moments take over the part of the inertia forces that the
springs do not balance. E is positive in forward whirl, negative in backward whirl, and zero at rest. M_b is
not needed as a matrix: z^H M_b z is the product of the twist of body b and the wrench of its inertia forces.

The strain energy of a mesh is that of the mean deflection of its teeth, which a transmission error excites,
and that of flanks that tilt against each other.

The lateral motion of a shaft station in its complex amplitude X along the first, Y along the second
transverse axis is X + i Y = F e^(i omega t) + B e^(-i omega t): circles forwards and backwards with the radii
|X + i Y|/2 and |X - i Y|/2, seen along the axis in the sense of rotation. Tilt is treated alike.

References
----------
.. [1] M. I. Friswell, J. E. T. Penny, S. D. Garvey, A. W. Lees: Dynamics of Rotating Machines, Cambridge
   University Press 2010, sections 3.6 and 5.6.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.solvers.body_shapes import body_motions, inertia_wrenches
from pitchpoint.solvers.mesh_law import MeshLaw, mesh_law
from pitchpoint.solvers.modes.machine_groups import Groups, groups_of
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names

if TYPE_CHECKING:
    from pitchpoint.solvers.stiffness_parts import Parts
    from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

WAYS = ("lateral", "axial", "rotation", "elastic")
"""Directions of the kinetic energy of a part: across its axis with tilt, along it, about it, modal."""

TABULATED = 600
"""Largest number of coordinates for which the motions of the bodies are tabulated."""
STILL = 1e-9
"""Speed over the highest speed up to which a body is at rest."""
THIN = 0.2
"""Whirl index up to which an orbit counts as planar: minor over major axis of the ellipse 0.1."""
LATERAL = 0.05
"""Least share of the lateral motion of rotating parts in the kinetic energy of a mode that whirls."""
FORWARD, BACKWARD, PLANAR, MIXED = "forward", "backward", "planar", "mixed"


@dataclass(frozen=True)
class Motions:
    """Motions of the bodies for given changes of the coordinates at an operating point.

    Parameters
    ----------
    system, state
        The system and its operating point.
    groups
        Parts and components.
    parts
        Linearisation by element.
    laws
        Linear laws of the meshes by name.
    axes, place
        Axes of the bodies (nb, 3, 3), columns in world axes, the third along the spin, and their origins
        (nb, 3) [m].
    units
        Twists and inertia wrenches for unit changes of all coordinates, shape (2, nd, nb, 6), body axes;
        None for large systems, in which every shape is evaluated.
    """

    system: System
    state: State
    groups: Groups
    parts: Parts
    laws: Mapping[str, MeshLaw]
    axes: Array
    place: Array
    units: Array | None

    def of(self, z: Complex) -> tuple[Complex, Complex]:
        """Twists of the bodies and wrenches of their inertia, body axes, shape (n, nb, 6) each."""
        if self.units is not None:
            return np.tensordot(z, self.units[0], axes=1), np.tensordot(z, self.units[1], axes=1)
        real, imag = (_in_body_axes(self.system, self.state, x, self.axes) for x in (z.real, z.imag))
        return real[0] + 1j * imag[0], real[1] + 1j * imag[1]


@dataclass(frozen=True)
class Energies:
    """Energies of n modes.

    Parameters
    ----------
    strain
        Share of each component in the strain energy, shape (n, components); zero for rigid modes.
    whole_strain
        Sum of z^H K z over all components, shape (n,).
    teeth
        Share of the mean deflection of the teeth of each mesh in the strain energy, a part of that of the
        mesh, shape (n, meshes), in the order of `Motions.laws`.
    kinetic
        Share of each part in the kinetic energy by direction, shape (n, parts, 4), see `WAYS`.
    strain_ratio
        Strain energy over the kinetic energy, shape (n,).
    turning
        Gyroscopic energy of each part over the whole kinetic energy, shape (n, parts); Coriolis terms of a
        body on a carrier are those of the body.
    forward, backward
        Share of the lateral motion of each part that whirls forwards and backwards in the kinetic energy,
        shape (n, parts); both zero for parts that do not rotate.
    twist
        Motion of the bodies in body axes, complex, shape (n, nb, 6).
    """

    strain: Array
    whole_strain: Array
    teeth: Array
    kinetic: Array
    strain_ratio: Array
    turning: Array
    forward: Array
    backward: Array
    twist: Complex

    @property
    def gyroscopic(self) -> Array:
        """Gyroscopic energy over the kinetic energy, shape (n,)."""
        return np.asarray(self.turning.sum(axis=1))


def motions_of(system: System, state: State, parts: Parts) -> Motions:
    """Motions of the bodies at an operating point, for `energies_of`."""
    evaluate.residual(system, state)
    frames = system.workspace.fr
    axes, place = frames["R"].copy(), frames["r"].copy()
    nd = system.sizes["nd"]
    units = np.array(_in_body_axes(system, state, np.eye(nd), axes)) if nd <= TABULATED else None
    laws = {name: mesh_law(system, parts, k) for k, name in enumerate(mesh_names(system))}
    return Motions(system, state, groups_of(system, parts), parts, laws, axes, place, units)


def _in_body_axes(system: System, state: State, shapes: Array, axes: Array) -> tuple[Array, Array]:
    """Twists and inertia wrenches for real shapes (n, nd), shape (n, nb, 6) each."""
    shape = (len(shapes), len(axes), 2, 3)
    found = (
        body_motions(system, state, shapes).reshape(shape),
        inertia_wrenches(system, state, shapes).reshape(shape),
    )
    one, two = (np.einsum("bji,nbkj->nbki", axes, x).reshape(len(shapes), -1, 6) for x in found)
    return one, two


def energies_of(
    motions: Motions, shapes: NDArray[np.inexact], values: Complex, turning: Array, spins: Array
) -> Energies:
    """Energies of modes.

    Parameters
    ----------
    motions
        From `motions_of`.
    shapes, values
        Shapes (n, nd), real or complex, and eigenvalues (n,) [1/s].
    turning
        From `gyroscopic_terms`, shape (n, nd).
    spins
        Speed of each body about its axis [rad/s], shape (nb,) or (n, nb).
    """
    groups, parts = motions.groups, motions.parts
    z = np.asarray(shapes, dtype=np.complex128)
    moved = z.copy()
    moved[:, motions.system.states] = 0.0  # coordinates of element states have no mass
    twist, wrench = motions.of(moved)
    kinetic, whole = _kinetic(groups, moved, parts.M, twist, wrench)
    strain = np.zeros((len(z), len(groups.components)))
    for e, share in enumerate(parts.shares):
        strain[:, groups.component[e]] += share.energy(z.real) + share.energy(z.imag)
    teeth = np.zeros((len(z), len(motions.laws)))
    for m, law in enumerate(motions.laws.values()):
        teeth[:, m] = law.deflection_energy(z)
    size = np.abs(values)
    still = size == 0.0
    strain[still] = teeth[still] = 0.0
    total = strain.sum(axis=1)
    inertia = np.where(still, 1.0, size**2 * whole)
    omega = np.abs(values.imag)
    scale = np.divide(-(size**2), omega * inertia, out=np.zeros(len(z)), where=omega > 0.0)
    ahead, back = _whirls(groups, twist, wrench, np.sign(spins))
    return Energies(
        strain=np.divide(strain, total[:, None], out=np.zeros_like(strain), where=total[:, None] != 0.0),
        whole_strain=total,
        teeth=np.divide(teeth, total[:, None], out=np.zeros_like(teeth), where=total[:, None] != 0.0),
        kinetic=kinetic / whole[:, None, None],
        strain_ratio=total / inertia,
        turning=scale[:, None] * _by_part(motions.system, groups, turning, twist, spins),
        forward=ahead / whole[:, None],
        backward=back / whole[:, None],
        twist=twist,
    )


def _kinetic(groups: Groups, z: Complex, M: Array, twist: Complex, wrench: Complex) -> tuple[Array, Array]:
    """z^H M_b z by part and direction, shape (n, parts, 4), and their sum (n,)."""
    found = np.zeros((len(z), len(groups.parts), len(WAYS)))
    each = (twist.conj() * wrench).real
    for b, part in enumerate(groups.part):
        if part < 0 or b in groups.hidden:
            continue
        found[:, part, 0] += each[:, b, [0, 1, 3, 4]].sum(axis=1)
        found[:, part, 1] += each[:, b, 2]
        found[:, part, 2] += each[:, b, 5]
    by_coordinate = ((z.conj() @ M) * z).real
    whole = by_coordinate.sum(axis=1)
    rest = whole - found.sum(axis=(1, 2))
    deflects = np.array(groups.deflects, dtype=np.int64)
    elastic = sorted(set(groups.deflects) - {-1})
    own = np.array([by_coordinate[:, deflects == part].sum(axis=1) for part in elastic])
    every = own.sum(axis=0) if elastic else np.zeros(len(z))
    for part, energy in zip(elastic, own, strict=True):  # what the other bodies leave
        even = np.full(len(z), 1.0 / len(elastic))
        found[:, part, 3] += rest * np.divide(energy, every, out=even, where=every > 0.0)
    return found, np.maximum(whole, 1e-300)


def gyroscopic_terms(shapes: NDArray[np.inexact], D: Array) -> Array:
    """z^H (D - D^T)/2 z over i by coordinate, for the damping matrix at speed (nd, nd), shape (n, nd).

    Parameters
    ----------
    shapes
        Shapes z, shape (n, nd).
    D
        Damping matrix at speed (nd, nd).
    """
    return np.asarray((shapes.conj() * (shapes @ (0.5 * (D - D.T)).T)).imag)


def _by_part(system: System, groups: Groups, terms: Array, twist: Complex, spins: Array) -> Array:
    """Gyroscopic terms by part, shape (n, parts): sums over its coordinates.

    The terms of a body that is fixed to another one are in the coordinates of that one: they are those of a
    disc, 2 I_p Omega Im(rx^* ry).
    """
    found = np.zeros((len(terms), len(groups.parts)))
    body = system.program["body"]
    speeds = np.broadcast_to(spins, twist.shape[:2])
    for b, (part, carrier) in enumerate(zip(groups.part, groups.carried, strict=True)):
        if part < 0:
            continue
        first, count = int(body[b]["dof"]), int(body[b]["n"])
        found[:, part] += terms[:, first : first + count].sum(axis=1)
        if carrier != part and b not in groups.hidden:
            tilt = twist[:, b, 3].conj() * twist[:, b, 4]
            own = 2.0 * float(body[b]["i_p"]) * speeds[:, b] * tilt.imag
            found[:, part] += own
            found[:, carrier] -= own
    return found


def _whirls(groups: Groups, twist: Complex, wrench: Complex, senses: Array) -> tuple[Array, Array]:
    """Kinetic energy of forward and backward circles by part, shape (n, parts) each."""
    own = [
        b
        for b, part in enumerate(groups.carried)
        if part >= 0 and groups.rotates[part] and b not in groups.hidden
    ]
    left, right = (np.zeros((len(twist), len(own))) for _ in range(2))  # circles about +z and -z
    for one, two in ((0, 1), (3, 4)):
        for found, sign in ((left, 1j), (right, -1j)):
            circle, force = (x[:, own, one] + sign * x[:, own, two] for x in (twist, wrench))
            found += 0.5 * (circle.conj() * force).real
    share = 0.5 * (1.0 + np.broadcast_to(senses, twist.shape[:2])[:, own])
    to_part = np.zeros((len(own), len(groups.parts)))
    to_part[np.arange(len(own)), [groups.part[b] for b in own]] = 1.0
    ahead = share * left + (1.0 - share) * right
    return ahead @ to_part, (left + right - ahead) @ to_part


def whirl_index(energies: Energies) -> Array:
    """(forward - backward)/(forward + backward) of the lateral motion, shape (n,); NaN where there is none.

    +1 and -1 are circles, 0 is a planar motion.
    """
    ahead, back = energies.forward.sum(axis=1), energies.backward.sum(axis=1)
    both = ahead + back
    return np.asarray(np.divide(ahead - back, both, out=np.full(len(both), np.nan), where=both > LATERAL))


def whirl_words(energies: Energies) -> list[str]:
    """Whirl of each mode: forward, backward, planar, mixed, or empty without lateral motion.

    Mixed: some shafts whirl forwards, others backwards, by more than a quarter of the motion each.
    """
    words = []
    for k, index in enumerate(whirl_index(energies)):
        ahead, back = energies.forward[k], energies.backward[k]
        both = float((ahead + back).sum())
        net = ahead - back
        if not np.isfinite(index):
            words.append("")
        elif min(net[net > 0.0].sum(), -net[net < 0.0].sum()) > 0.25 * both:
            words.append(MIXED)
        else:
            words.append(FORWARD if index > THIN else BACKWARD if index < -THIN else PLANAR)
    return words


def spins_of(motions: Motions, rates: Array) -> Array:
    """Speed of each body about its axis for rates of the coordinates, 0 for rounding, shape (nb,)."""
    spin = motions.of(rates[None].astype(np.complex128))[0][0, :, 5].real
    return np.asarray(np.where(np.abs(spin) > STILL * np.abs(spin).max(initial=0.0), spin, 0.0))
