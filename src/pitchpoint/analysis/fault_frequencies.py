# SPDX-License-Identifier: Apache-2.0
"""Characteristic frequencies of gear pairs and gear trains from numbers of teeth and speeds.

Speeds are signed, in rad/s, counter-clockwise positive; frequencies are nonnegative, in Hz. A damaged tooth
is in mesh once per revolution relative to the line of centres, which is fixed to ground for ordinary gears
and to the carrier for planets. Purely kinematic, without slip. See `planet_frequencies` for planetary gear
sets and `bearing_frequencies` for rolling bearings.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pitchpoint.analysis.planet_frequencies import PlanetaryFrequencies, planetary_frequencies
from pitchpoint.analysis.sampled import Array, SignalError, finite, whole

MEMBERS = ("sun", "carrier", "ring")
"""Central members of a planetary gear set."""


@dataclass(frozen=True)
class PairFrequencies:
    """Frequencies of two gears in mesh.

    Attributes
    ----------
    speed_1, speed_2
        Speeds of both gears relative to the line of centres [rad/s].
    rotation_1, rotation_2
        Rotation frequencies of both gears, at which a damaged tooth is in mesh [Hz].
    mesh
        Mesh frequency [Hz].
    assembly_phase
        Assembly phase frequency, mesh frequency over the common factor [Hz].
    hunting_tooth
        Hunting tooth frequency, at which the same two teeth meet [Hz].
    common_factor
        Greatest common divisor of the numbers of teeth [-].
    """

    speed_1: float
    speed_2: float
    rotation_1: float
    rotation_2: float
    mesh: float
    assembly_phase: float
    hunting_tooth: float
    common_factor: int


@dataclass(frozen=True)
class PlanetStage:
    """Planetary gear set as a stage of a train: numbers of teeth [-], driving member and fixed member."""

    z_sun: int
    z_planet: int
    z_ring: int
    planets: int = 3
    input: str = "carrier"
    fixed: str = "ring"


@dataclass(frozen=True)
class TrainFrequencies:
    """Frequencies of a train of stages.

    Attributes
    ----------
    speed
        Shape (n_stage + 1,). Speeds of the shafts, the input first [rad/s].
    shaft
        Shape (n_stage + 1,). Rotation frequencies of the shafts [Hz].
    mesh
        Shape (n_stage,). Mesh frequencies [Hz].
    stages
        Frequencies of each stage.
    """

    speed: Array
    shaft: Array
    mesh: Array
    stages: tuple[PairFrequencies | PlanetaryFrequencies, ...]


def gear_pair_frequencies(z_1: int, z_2: int, speed: float) -> PairFrequencies:
    """Shaft, mesh, assembly phase and hunting tooth frequency of two gears.

    Parameters
    ----------
    z_1, z_2
        Numbers of teeth, negative for an internal gear [-].
    speed
        Speed of gear 1 relative to the line of centres [rad/s].

    Returns
    -------
    PairFrequencies
        Frequencies [Hz], speeds [rad/s].

    Raises
    ------
    SignalError
        If a number of teeth is not a whole number, both gears are internal, or the speed is not finite.

    Notes
    -----
    f_m = |z_1| n_1, assembly phase f_m/g with g = gcd(z_1, z_2), hunting tooth f_m g/(z_1 z_2) [1]_. Valid
    for gears on fixed axes, and for planets with speeds relative to their carrier.

    References
    ----------
    .. [1] R. B. Randall, Vibration-based Condition Monitoring, Wiley, 2011, section on gears.

    Examples
    --------
    8 and 42 teeth, 20 revolutions per second:

    >>> f = gear_pair_frequencies(8, 42, 20 * 2 * math.pi)
    >>> [round(x, 5) for x in (f.rotation_1, f.rotation_2, f.mesh, f.assembly_phase, f.hunting_tooth)]
    [20.0, 3.80952, 160.0, 80.0, 0.95238]
    """
    n_1, n_2 = whole(abs(z_1), "z_1"), whole(abs(z_2), "z_2")
    if z_1 < 0 and z_2 < 0:
        raise SignalError("z_1, z_2: both are internal (limit 1); give an external gear a positive number")
    turning = finite(speed, "speed")
    other = -turning * z_1 / z_2
    mesh = abs(turning) / math.tau * n_1
    common = math.gcd(n_1, n_2)
    return PairFrequencies(
        speed_1=turning,
        speed_2=other,
        rotation_1=abs(turning) / math.tau,
        rotation_2=abs(other) / math.tau,
        mesh=mesh,
        assembly_phase=mesh / common,
        hunting_tooth=mesh * common / (n_1 * n_2),
        common_factor=common,
    )


def train_frequencies(stages: Sequence[tuple[int, int] | PlanetStage], speed: float) -> TrainFrequencies:
    """Frequencies of a gear train of any number of stages in series.

    Parameters
    ----------
    stages
        For every stage the numbers of teeth (driving, driven), negative for an internal gear [-], or a
        `PlanetStage`.
    speed
        Speed of the first shaft [rad/s].

    Returns
    -------
    TrainFrequencies
        Speeds [rad/s] and frequencies [Hz] of shafts and stages.

    Raises
    ------
    SignalError
        If there is no stage, or a stage is not possible; the message states which.

    Notes
    -----
    `gear_pair_frequencies` and `planetary_frequencies`, each with the output speed of the preceding stage
    [1]_. Valid without slip.

    References
    ----------
    .. [1] R. B. Randall, Vibration-based Condition Monitoring, Wiley, 2011, section on gears.

    Examples
    --------
    Travel drive of a mining shovel at 740 rpm:

    >>> f = train_frequencies([(11, 81), (12, 68), (11, 36)], 740 * math.pi / 30)
    >>> f.mesh.round(6).tolist()
    [135.666667, 20.098765, 3.251271]
    >>> round(1 / float(f.shaft[2]), 6)
    3.383292
    """
    if not stages:
        raise SignalError("stages: there are none (limit 1)")
    speeds = [finite(speed, "speed")]
    found: list[PairFrequencies | PlanetaryFrequencies] = []
    for number, stage in enumerate(stages, start=1):
        try:
            if isinstance(stage, PlanetStage):
                planetary, turning = _planet_stage(stage, speeds[-1])
                found.append(planetary)
            else:
                pair = gear_pair_frequencies(*stage, speeds[-1])
                found.append(pair)
                turning = pair.speed_2
        except SignalError as error:
            raise SignalError(f"stages: stage {number}: {error}") from None
        speeds.append(turning)
    speed_of = np.array(speeds)
    return TrainFrequencies(
        speed=speed_of,
        shaft=np.abs(speed_of) / math.tau,
        mesh=np.array([f.mesh for f in found]),
        stages=tuple(found),
    )


def _planet_stage(stage: PlanetStage, speed: float) -> tuple[PlanetaryFrequencies, float]:
    """Frequencies of a planetary gear set in a train, and the speed of its output member."""
    rest = [m for m in MEMBERS if m not in (stage.input, stage.fixed)]
    if len(rest) != 1:
        raise SignalError(
            f"input, fixed: {stage.input!r} and {stage.fixed!r}; name two of {', '.join(MEMBERS)}"
        )
    found = planetary_frequencies(
        z_sun=stage.z_sun,
        z_planet=stage.z_planet,
        z_ring=stage.z_ring,
        planets=stage.planets,
        **{f"speed_{stage.input}": speed, f"speed_{stage.fixed}": 0.0},
    )
    turning: float = getattr(found, f"speed_{rest[0]}")
    return found, turning
