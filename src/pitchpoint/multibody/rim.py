# SPDX-License-Identifier: Apache-2.0
"""Flexible rim of a gear in a body frame: modal coordinates, and motion of the sections of the rim.

The section at the angle theta moves like a rigid body. Its motion is that of the frame of a gear attached to
it, at the axis: displacement a and rotation c with components along radius, tangent and axis at theta, as
Fourier series in theta times the coordinates. A point of the section at the radius r moves by a + c x r e_r.

The coordinates are the modes of a ring in closed form (`ring_modes`), or those of finite elements with some
nodes fixed to the body. Of finite elements, each series is fitted to the displacements u of the nodes near
the teeth by least squares, u = a + c x (x - z-axis point), which averages over face width and height.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.multibody.craig_bampton import Modes, fixed_modes
from pitchpoint.multibody.mass_invariants import MassInvariants, mass_invariants
from pitchpoint.multibody.ring_modes import (
    RingMode,
    coordinate_names,
    ring_invariants,
    ring_terms,
)
from pitchpoint.multibody.structure import Structure

Array = NDArray[np.float64]

SAME_ANGLE = 1e-4
"""Angle up to which nodes are in one section [rad]."""
ROUND = 1e-6
"""Relative tolerance of the positions of nodes."""
CANDIDATES = 3
"""Modes of finite elements of which those for the teeth are chosen, per mode."""
FEWEST = 1e-6
"""Smallest singular value of a fit, relative to the largest."""


@dataclass(frozen=True)
class Rim:
    """Flexible rim with n modal coordinates.

    Parameters
    ----------
    words
        Names of the coordinates.
    integrals
        Mass integrals without those of the rigid rim, in the axes of the body.
    stiffness, stretch
        Modal stiffness [N/m], and its increase by a spin about the axis per (rad/s)^2 [kg], shape (n,).
    terms
        Motion of the sections: rows of coordinate, number of waves, component (0 to 2 displacement, 3 to 5
        rotation, along radius, tangent and axis), factors of cosine and sine.
    """

    words: tuple[str, ...]
    integrals: MassInvariants
    stiffness: Array
    stretch: Array
    terms: Array

    @property
    def frequency(self) -> Array:
        """Natural frequencies on a body at rest [Hz]."""
        return np.sqrt(self.stiffness / np.diag(self.integrals.modal)) / math.tau


def ring_rim(modes: Sequence[RingMode], centroid: float) -> Rim:
    """Rim from the modes of a ring with this radius of the line of centroids [m]."""
    return Rim(
        tuple(coordinate_names(modes)),
        ring_invariants(modes),
        np.repeat([m.stiffness for m in modes], 2),
        np.repeat([m.stretch for m in modes], 2),
        ring_terms(modes, centroid, 0.0),
    )


def element_rim(
    structure: Structure,
    held: Sequence[int],
    count: int,
    weights: tuple[float, float, float],
    *,
    waves: int,
    near: tuple[float, float, float],
) -> Rim:
    """Rim from finite elements whose z axis is that of the gear, and whose origin is its middle.

    Parameters
    ----------
    structure
        Matrices of the rim.
    held
        Nodes fixed to the body.
    count
        Number of modes: those with the largest compliance at the teeth, of three times as many lowest ones.
    weights
        Squares of the radial, tangential and axial force of the teeth, for the compliance.
    waves
        Largest number of waves of the series.
    near
        Range of radii, and largest distance from the middle along the axis, of the nodes of the fit [m].

    Raises
    ------
    CompileError
        If the held nodes do not fix the rim, or the nodes near the teeth do not determine the series.
    """
    lowest = fixed_modes(structure, held, CANDIDATES * count)
    terms = _fit(structure, lowest.shape, waves, near)
    compliance = _compliance(terms, near[0], weights, lowest.frequency)
    chosen = np.sort(np.argsort(-compliance, kind="stable")[:count])
    modes = Modes(lowest.frequency[chosen], lowest.shape[:, chosen], 0.0)
    terms = terms[np.isin(terms[:, 0], chosen)]
    terms[:, 0] = np.searchsorted(chosen, terms[:, 0])
    integrals = mass_invariants(structure, modes.shape)
    n = modes.frequency.size
    return Rim(
        tuple(f"eta{k + 1}" for k in range(n)),
        replace(integrals, mass=0.0, first=np.zeros(3), inertia=np.zeros((3, 3))),
        (math.tau * modes.frequency) ** 2,
        np.zeros(n),
        terms,
    )


def _compliance(terms: Array, radius: float, weights: tuple[float, float, float], frequency: Array) -> Array:
    """Mean compliance of each mode over the circumference, modal mass 1."""
    found = np.zeros(frequency.size)
    for k, n, component, c, s in np.concatenate([terms_at(terms, radius), terms[terms[:, 2] == 2]]):
        found[int(k)] += weights[int(component)] * (c * c + s * s) * (0.5 if n > 0 else 1.0)
    return found / (math.tau * frequency) ** 2


def _fit(structure: Structure, shape: Array, waves: int, near: tuple[float, float, float]) -> Array:
    """Rows of terms by least squares over the nodes near the teeth."""
    x, y, z = structure.places.T
    radius = np.hypot(x, y)
    inner, outer, width = near
    slack = 1.0 + ROUND
    chosen = np.flatnonzero(
        (radius >= inner / slack) & (radius <= outer * slack) & (np.abs(z) <= width * slack)
    )
    theta = np.sort(np.arctan2(y[chosen], x[chosen]))
    count = 1 + int(np.sum(np.diff(theta) > SAME_ANGLE)) if theta.size else 0
    if count < 2 * waves + 1:
        raise CompileError(
            f"{count} sections with nodes at radii of {1e3 * inner:.6g} to {1e3 * outer:.6g} mm and within "
            f"{1e3 * width:.6g} mm of the middle (limit at least {2 * waves + 1} for {waves} waves)"
        )
    rows = np.flatnonzero(np.isin(structure.node, chosen))
    at, way = structure.node[rows], structure.direction[rows]
    c, s = x[at] / radius[at], y[at] / radius[at]
    out = np.stack([c, s, 0.0 * c], axis=1)
    along = np.stack([-s, c, 0.0 * c], axis=1)
    axis = np.tile([0.0, 0.0, 1.0], (len(at), 1))
    arm = radius[at][:, None] * out + z[at][:, None] * axis
    # rotations of nodes count as displacements at the radius
    size = np.where(way < 3, 1.0, radius[at])
    pick, moves = (np.arange(len(at)), way % 3), way < 3
    motions = [np.where(moves, e[pick], 0.0) for e in (out, along, axis)]
    motions += [np.where(moves, np.cross(e, arm)[pick], size * e[pick]) for e in (out, along, axis)]
    turned = np.arctan2(s, c)
    keys, columns = [], []
    for n in range(waves + 1):
        for component, motion in enumerate(motions):
            for wave in (np.cos, np.sin)[: 1 if n == 0 else 2]:
                keys.append((n, component, wave is np.cos))
                columns.append(motion * wave(n * turned))
    A = np.stack(columns, axis=1)
    per = np.linalg.norm(A, axis=0)
    # motions that the nodes do not show, such as the rotation of sections with one node, remain zero
    seen = per > FEWEST * per.max()
    factors = np.zeros((A.shape[1], shape.shape[1]))
    own = np.linalg.lstsq(A[:, seen] / per[seen], size[:, None] * shape[rows], rcond=FEWEST)[0]
    factors[seen] = own / per[seen, None]
    found = []
    for (n, component, even), values in zip(keys, factors, strict=True):
        for k, value in enumerate(values):
            if value != 0.0:
                found.append((k, n, component, value * even, value * (not even)))
    return np.array(found)


def moved_integrals(integrals: MassInvariants, at: float) -> MassInvariants:
    """Integrals of a rim about an origin from which the old one is at `at` along the axis [m]."""
    P = integrals.momentum
    arm = np.array([0.0, 0.0, at])
    more = np.array([2.0 * (arm @ p) * np.eye(3) - np.outer(arm, p) - np.outer(p, arm) for p in P.T])
    return replace(
        integrals,
        angular=integrals.angular + np.cross(arm, P.T).T,
        inertia_1=integrals.inertia_1 + more.reshape(integrals.inertia_1.shape),
    )


def terms_at(terms: Array, radius: float) -> Array:
    """Radial and tangential displacement at a radius, as rows of the components 0 and 1.

    The rotation c about the axis moves a point at the radius r by r c along the tangent.
    """
    lateral = terms[terms[:, 2] < 2]
    turning = terms[terms[:, 2] == 5].copy()
    turning[:, 2] = 1
    turning[:, 3:] *= radius
    return np.concatenate([lateral, turning])


def turned_terms(terms: Array, angle: float) -> Array:
    """The same terms over an angle that is measured from an axis behind the old one by `angle` [rad]."""
    found = terms.copy()
    c, s = np.cos(terms[:, 1] * angle), np.sin(terms[:, 1] * angle)
    found[:, 3] = terms[:, 3] * c - terms[:, 4] * s
    found[:, 4] = terms[:, 3] * s + terms[:, 4] * c
    return found
