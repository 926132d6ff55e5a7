# SPDX-License-Identifier: Apache-2.0
"""Linear stiffness and damping in six directions: three displacements and three rotations."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from pitchpoint.model.component import Component
from pitchpoint.model.keys import key, quantity

Matrix6: TypeAlias = tuple[tuple[float, ...], ...]


@dataclass(frozen=True, kw_only=True)
class Stiffness6(Component):
    """Stiffness by direction, or a full symmetric 6x6 matrix (x, y, z, rx, ry, rz)."""

    radial: float | None = quantity("stiffness", "along x and y", None, minimum=0.0)
    x: float | None = quantity("stiffness", "along x (instead of radial)", None, minimum=0.0)
    y: float | None = quantity("stiffness", "along y (instead of radial)", None, minimum=0.0)
    axial: float = quantity("stiffness", "along the axis z", 0.0, minimum=0.0)
    tilt: float | None = quantity("torsional_stiffness", "about x and y", None, minimum=0.0)
    rx: float | None = quantity("torsional_stiffness", "about x (instead of tilt)", None, minimum=0.0)
    ry: float | None = quantity("torsional_stiffness", "about y (instead of tilt)", None, minimum=0.0)
    torsion: float = quantity("torsional_stiffness", "about the axis z", 0.0, minimum=0.0)
    matrix: Matrix6 | None = key("matrix", "full 6x6 matrix in SI units, instead of the other keys", None)

    def matrix6(self) -> Matrix6:
        """Full 6x6 matrix [N/m, N, N m/rad]."""
        return _six(self)


@dataclass(frozen=True, kw_only=True)
class Damping6(Component):
    """Damping by direction, a full symmetric 6x6 matrix, or a ratio of critical damping."""

    radial: float | None = quantity("damping", "along x and y", None, minimum=0.0)
    x: float | None = quantity("damping", "along x (instead of radial)", None, minimum=0.0)
    y: float | None = quantity("damping", "along y (instead of radial)", None, minimum=0.0)
    axial: float = quantity("damping", "along the axis z", 0.0, minimum=0.0)
    tilt: float | None = quantity("torsional_damping", "about x and y", None, minimum=0.0)
    rx: float | None = quantity("torsional_damping", "about x (instead of tilt)", None, minimum=0.0)
    ry: float | None = quantity("torsional_damping", "about y (instead of tilt)", None, minimum=0.0)
    torsion: float = quantity("torsional_damping", "about the axis z", 0.0, minimum=0.0)
    matrix: Matrix6 | None = key("matrix", "full 6x6 matrix in SI units, instead of the other keys", None)
    ratio: float | None = quantity(
        "dimensionless",
        "fraction of critical damping in each direction, with the inertia of the body, of couplings the "
        "reduced inertia of both bodies, without the bodies fixed or geared to them",
        None,
        minimum=0.0,
        maximum=10.0,
    )

    def matrix6(self) -> Matrix6:
        """Full 6x6 matrix [N s/m, N s, N m s/rad]; zero when a ratio is given."""
        return _six(self)


def _six(part: Stiffness6 | Damping6) -> Matrix6:
    if part.matrix is not None:
        return part.matrix
    radial, tilt = part.radial or 0.0, part.tilt or 0.0
    diagonal = (
        radial if part.x is None else part.x,
        radial if part.y is None else part.y,
        part.axial,
        tilt if part.rx is None else part.rx,
        tilt if part.ry is None else part.ry,
        part.torsion,
    )
    return tuple(tuple(diagonal[i] if i == j else 0.0 for j in range(6)) for i in range(6))
