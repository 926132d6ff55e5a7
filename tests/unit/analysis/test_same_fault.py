# SPDX-License-Identifier: Apache-2.0
"""One bearing fault in two channels: lines that a distant sensor shows are not a fault of another bearing."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from pitchpoint.analysis.diagnosis import Diagnosis, diagnose
from pitchpoint.analysis.turning_parts import Bearing, Shaft, TurningParts

RATE, TURNS = 200.0, 300.0
SHAFT = (Shaft("rotor", Fraction(1)),)
LEFT = Bearing("left", {"inner ring": 5.42}, "rotor")
RIGHT = Bearing("right", {"inner ring": 4.42}, "rotor")
"""The inner ring of the right bearing has the lower sidebands k (5.42 - 1) of that of the left one."""


def _modulated(order: float, seed: int, *, load: float = 0.0, floor: float = 0.05) -> np.ndarray:
    """Noise whose power rises from a floor at each impact, and with the load zone once per turn."""
    turned = np.arange(int(RATE * TURNS)) / RATE
    strikes = np.exp(-8.0 * (order * turned % 1.0)) * (1.0 + load * np.cos(2.0 * np.pi * turned))
    noise = np.random.default_rng(seed)
    return np.sqrt(floor + strikes) * noise.standard_normal(turned.size)


def _found(*bearings: Bearing) -> Diagnosis:
    """The left bearing is damaged; the distant channel transmits the lower sidebands of its lines alone."""
    channels = {"near": _modulated(5.42, 1, load=0.5), "distant": _modulated(4.42, 2, floor=0.5)}
    return diagnose(channels, RATE, TurningParts(SHAFT, (), bearings))


def test_sidebands_in_a_distant_channel_are_not_a_fault_of_another_bearing() -> None:
    found = _found(LEFT, RIGHT)
    assert [(finding.gears, finding.channel) for finding in found.findings] == [(("left",), "near")]
    (row,) = (e for e in found.evidence if (e.channel, e.gear) == ("distant", "right"))
    assert not row.found
    assert row.explained == "inner ring of left in near"


def test_without_the_damaged_bearing_its_lines_are_those_of_the_other_one() -> None:
    """The same channels, so that the first test cannot pass for want of evidence."""
    assert [finding.gears for finding in _found(RIGHT).findings] == [("right",)]


def test_two_faults_in_their_own_channels_are_both_named() -> None:
    apart = Bearing("right", {"inner ring": 4.57}, "rotor")
    channels = {"near": _modulated(5.42, 1, load=0.5), "distant": _modulated(4.57, 2)}
    found = diagnose(channels, RATE, TurningParts(SHAFT, (), (LEFT, apart)))
    assert sorted(finding.gears for finding in found.findings) == [("left",), ("right",)]
