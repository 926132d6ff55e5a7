# SPDX-License-Identifier: Apache-2.0
"""What turns in a machine, as far as its signals know: shafts with their gears, meshes, rolling bearings.

All speeds are orders: turns, or events, in one turn of the reference shaft.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from pitchpoint.analysis.sampled import SignalError, whole
from pitchpoint.analysis.synchronous_average import shaft_ratio


@dataclass(frozen=True)
class Shaft:
    """A shaft, or several that turn equally fast, which no signal distinguishes.

    Attributes
    ----------
    name
        What to call it.
    order
        Turns in one turn of the reference shaft [-].
    """

    name: str
    order: Fraction


@dataclass(frozen=True)
class Mesh:
    """Two gears in mesh.

    Attributes
    ----------
    name
        What to call it.
    gears
        Names of both gears.
    teeth
        Their tooth counts [-].
    shafts
        Names of their shafts.
    """

    name: str
    gears: tuple[str, str]
    teeth: tuple[int, int]
    shafts: tuple[str, str]


@dataclass(frozen=True)
class Bearing:
    """A rolling bearing by the orders at which its damages show.

    Attributes
    ----------
    name
        What to call it.
    orders
        Events in one turn of the reference shaft [-] by the part: `outer ring`, `inner ring`,
        `rolling element`, `cage`.
    shaft
        Name of the shaft it carries; empty if unknown.
    """

    name: str
    orders: dict[str, float]
    shaft: str = ""


@dataclass(frozen=True)
class TurningParts:
    """All that turns.

    Attributes
    ----------
    shafts, meshes, bearings
        The parts; shafts are named once each.
    """

    shafts: tuple[Shaft, ...]
    meshes: tuple[Mesh, ...] = ()
    bearings: tuple[Bearing, ...] = ()

    def shaft(self, name: str) -> Shaft:
        """The shaft of a name."""
        return next(shaft for shaft in self.shafts if shaft.name == name)

    def mesh_order(self, mesh: Mesh) -> float:
        """Tooth meshes in one turn of the reference shaft [-]."""
        return float(self.shaft(mesh.shafts[0]).order * mesh.teeth[0])

    def gears_of(self, shaft: str) -> dict[str, tuple[Mesh, int]]:
        """Gears of a shaft with one mesh and the tooth count of each."""
        found: dict[str, tuple[Mesh, int]] = {}
        for mesh in self.meshes:
            for gear, teeth, place in zip(mesh.gears, mesh.teeth, mesh.shafts, strict=True):
                if place == shaft:
                    found.setdefault(gear, (mesh, teeth))
        return found


def train_parts(stages: Sequence[tuple[int, int]], bearings: Sequence[Bearing] = ()) -> TurningParts:
    """Parts of a train of gears: gears Z1, Z2, ..., shafts 1, 2, ..., meshes 1, 2, ... from the input on.

    Parameters
    ----------
    stages
        For each mesh the tooth counts (driving, driven) [-].
    bearings
        Rolling bearings.

    Returns
    -------
    TurningParts
        The reference shaft is shaft 1.

    Raises
    ------
    SignalError
        If a tooth count is not a whole number from 4 on, or there is no stage.

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
