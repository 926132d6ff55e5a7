# SPDX-License-Identifier: Apache-2.0
"""Linear law of a mesh, for its flank error as input and its forces as outputs alike.

A gear that rotates about its own axis at fixed mesh phase changes nothing but the travel u of its mesh. Let
the coordinates s be such a rotation with u = 1. A flank error e acts like the travel e in the opposite
direction, so the generalised forces of a mesh with the matrices K and D are

    Q = -K (q - s e) - D (q' - s e')

and by virtual work its force along the base tangent is F = -s^T Q: the torque on the gear over its base
radius. Since input and output are the same law, F vanishes with the acceleration of the gear.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.bodies import spin_of
from pitchpoint.solvers.element_tangents import Share, tangents
from pitchpoint.solvers.torque_paths import torque_paths
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names, mesh_places, mesh_record, one_mesh

if TYPE_CHECKING:
    from pitchpoint.solvers.stiffness_parts import Parts
    from pitchpoint.solvers.tooth_wave import ToothWave
    from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class MeshLaw:
    """Mesh in a linear system, with the stiffness and damping of the analysis, such as the mean over a cycle.

    Parameters
    ----------
    travel
        Travel along the base tangent by rotation, at the spin coordinates, shape (nd,) [m/rad].
    turn
        Rotation s of one gear that changes the travel by 1 m, shape (nd,).
    stiffness, damping
        K s and D s [N/m, N s/m]; zero without a gear that can rotate.
    force, force_by_rate
        Force along the base tangent by coordinates and rates: rows s^T K and s^T D.
    spins
        Coordinates of the rotation of its gears.
    wave
        Excitation over the mesh cycle; None if the mesh is unloaded or evaluated at one phase.
    """

    travel: Array
    turn: Array
    stiffness: Array
    damping: Array
    force: Array
    force_by_rate: Array
    spins: tuple[int, ...] = ()
    wave: ToothWave | None = None

    @property
    def mean(self) -> float:
        """Stiffness k = s^T K s against the mean deflection of the teeth over the face [N/m]."""
        return float(self.force @ self.turn)

    def excitation(self, count: int, phase: float = 0.0, forward: bool = True) -> tuple[Complex, Complex]:
        """Transmission error e and shuttling forces c of the harmonics 1 to `count` over the cycle.

        Complex amplitudes over the time in which the mesh moves from a phase of the loaded flank, `forward`
        if this phase grows; K s e + c are the forces of `tooth_wave`. Zero for unloaded meshes.

        Returns
        -------
        e
            [m], shape (count,).
        c
            Shape (count, nd).
        """
        forces = np.zeros((count, self.turn.size), complex)
        if self.wave is None or not self.mean > 0.0:
            return np.zeros(count, complex), forces
        turned = np.exp(2j * np.pi * phase * np.arange(1, count + 1))[:, None]
        forces[:, self.wave.places] = self.wave.harmonics(count) * turned
        forces = forces if forward else forces.conj()
        e = np.asarray(forces @ self.turn / self.mean, np.complex128)
        shuttling = forces - np.outer(e, self.stiffness)
        shuttling[:, list(self.spins)] = 0.0  # r_b F is the torque on both gears
        return e, shuttling

    def deflection_energy(self, shapes: Complex) -> Array:
        """Twice the strain energy k |u|^2 of the mean deflection u = F/k of the teeth, shape (n,).

        A uniform flank error excites and causes this deflection. Flanks that tilt against each other have
        strain energy in z^H K z without a mean deflection.

        Parameters
        ----------
        shapes
            Shapes z (n, nd).
        """
        k = self.mean
        return np.asarray(np.abs(shapes @ self.force) ** 2 / k if k > 0.0 else np.zeros(len(shapes)))


def mesh_law(system: System, parts: Parts, k: int) -> MeshLaw:
    """Linear law of mesh number k in a linearisation by element."""
    travel, turn, spins = _rotation(system, k)
    name = f"mesh {mesh_names(system)[k]}"
    K = parts.shares[parts.elements.index(name)]
    D = parts.damping[name]
    return MeshLaw(
        travel,
        turn,
        _times(K, turn),
        _times(D, turn),
        _times(Share(K.places, K.matrix.T), turn),
        _times(Share(D.places, D.matrix.T), turn),
        spins,
        parts.waves.get(name),
    )


def stiffness_now(system: System, state: State, k: int, law: MeshLaw) -> float:
    """Stiffness s^T K s of a mesh at its phase in a state [N/m]."""
    stopped = state.copy()
    stopped.v[:] = 0.0
    now = evaluate.dense(system, tangents(system, stopped, one_mesh(system, k))[1])
    return float(law.turn @ now @ law.turn)


def _rotation(system: System, k: int) -> tuple[Array, Array, tuple[int, ...]]:
    """Travel by rotation, the rotation of one gear that changes the travel by 1 m, spins of both gears."""
    record = mesh_record(system, k)
    travel, turn = np.zeros(system.sizes["nd"]), np.zeros(system.sizes["nd"])
    for path in torque_paths(system):
        if (path.kind, path.number) == mesh_places(system)[k]:
            for spin, teeth in path.row.items():
                travel[spin] = teeth * float(record["p_bt"]) / (2.0 * np.pi)
    own = [spin for spin in (spin_of(system.program["body"], int(record[end])) for end in "ij") if spin >= 0]
    chosen = max(own, key=lambda spin: abs(travel[spin]), default=-1)
    if chosen >= 0 and travel[chosen] != 0.0:
        turn[chosen] = 1.0 / travel[chosen]
    return travel, turn, tuple(own)


def _times(share: Share, vector: Array) -> Array:
    """A share times a vector, shape (nd,)."""
    found = np.zeros_like(vector)
    found[share.places] = share.matrix @ vector[share.places]
    return found
