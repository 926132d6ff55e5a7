# SPDX-License-Identifier: Apache-2.0
"""Rotating parts of a machine for the diagnosis: shafts with their gears, meshes, rolling bearings.

All speeds are orders: revolutions, or events, per revolution of the reference shaft.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from pitchpoint.analysis.sampled import SignalError, whole
from pitchpoint.analysis.synchronous_average import shaft_ratio


@dataclass(frozen=True)
class Shaft:
    """A shaft, or several of equal speed, which no signal distinguishes.

    Attributes
    ----------
    name
        Name of the shaft.
    order
        Revolutions per revolution of the reference shaft [-].
    """

    name: str
    order: Fraction


@dataclass(frozen=True)
class Mesh:
    """Two gears in mesh.

    Attributes
    ----------
    name
        Name of the mesh.
    gears
        Names of both gears.
    teeth
        Numbers of teeth [-].
    shafts
        Names of their shafts.
    """

    name: str
    gears: tuple[str, str]
    teeth: tuple[int, int]
    shafts: tuple[str, str]


@dataclass(frozen=True)
class Bearing:
    """A rolling bearing with its characteristic orders.

    Attributes
    ----------
    name
        Name of the bearing.
    orders
        Events per revolution of the reference shaft [-] by part: `outer ring`, `inner ring`,
        `rolling element`, `cage`.
    shaft
        Name of the supported shaft; empty if unknown.
    """

    name: str
    orders: dict[str, float]
    shaft: str = ""


@dataclass(frozen=True)
class TurningParts:
    """Rotating parts of a machine.

    Attributes
    ----------
    shafts, meshes, bearings
        The parts; the names of the shafts are unique.
    """

    shafts: tuple[Shaft, ...]
    meshes: tuple[Mesh, ...] = ()
    bearings: tuple[Bearing, ...] = ()

    def shaft(self, name: str) -> Shaft:
        """Shaft of a name."""
        return next(shaft for shaft in self.shafts if shaft.name == name)

    def mesh_order(self, mesh: Mesh) -> float:
        """Mesh order: tooth meshes per revolution of the reference shaft [-]."""
        return float(self.shaft(mesh.shafts[0]).order * mesh.teeth[0])

    def gears_of(self, shaft: str) -> dict[str, tuple[Mesh, int]]:
        """Gears of a shaft, each with one of its meshes and its number of teeth."""
        found: dict[str, tuple[Mesh, int]] = {}
        for mesh in self.meshes:
            for gear, teeth, place in zip(mesh.gears, mesh.teeth, mesh.shafts, strict=True):
                if place == shaft:
                    found.setdefault(gear, (mesh, teeth))
        return found


def train_parts(stages: Sequence[tuple[int, int]], bearings: Sequence[Bearing] = ()) -> TurningParts:
    """Parts of a gear train: gears Z1, Z2, ..., shafts 1, 2, ..., meshes 1, 2, ... from the input.

    Parameters
    ----------
    stages
        Numbers of teeth (driving, driven) of each mesh [-].
    bearings
        Rolling bearings.

    Returns
    -------
    TurningParts
        Parts with shaft 1 as the reference shaft.

    Raises
    ------
    SignalError
        If a number of teeth is not a whole number of at least 4, or there is no stage.

    Notes
    -----
    Ratios by `shaft_ratio` [1]_. Valid for trains with fixed axes.

    References
    ----------
    .. [1] ISO 21771-1:2024, gear ratio.

    Examples
    --------
    >>> parts = train_parts([(32, 96), (48, 80)])
    >>> [str(shaft.order) for shaft in parts.shafts], [parts.mesh_order(mesh) for mesh in parts.meshes]
    (['1', '1/3', '1/5'], [32.0, 16.0])
    """
    if not stages:
        raise SignalError("train: has no stage; write the tooth counts of each mesh, as in 32/96-48/80")
    counted = [(whole(a, "tooth count", 4), whole(b, "tooth count", 4)) for a, b in stages]
    shafts = [
        Shaft(f"shaft {k + 1}", shaft_ratio(*counted[:k]) if k else Fraction(1))
        for k in range(len(counted) + 1)
    ]
    meshes = [
        Mesh(
            f"mesh {k + 1}",
            (f"Z{2 * k + 1}", f"Z{2 * k + 2}"),
            counted[k],
            (shafts[k].name, shafts[k + 1].name),
        )
        for k in range(len(counted))
    ]
    return TurningParts(tuple(shafts), tuple(meshes), tuple(bearings))
