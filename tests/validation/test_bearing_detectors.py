# SPDX-License-Identifier: Apache-2.0
"""Limits of the detectors of bearing damage, counted on records of several machines, and left out in turn.

Sources: the motor and the gearbox of test_measured_records.py, the latter as a machine whose gears are not
given, with bearings that it does not have, so that every part is sound; and simulated machines of random
geometry, speed, structure and disturbances (tests/support/simulated_bearings.py). Frames do not matter: one
channel, one number of revolutions. Tolerance of levels: of the last digit stated, 0.1 dB. Counts are exact.
"""

from __future__ import annotations

import pytest

from pitchpoint.analysis.bearing_detectors import LIMITS, TONES
from tests.support.detector_levels import (
    Levels,
    above,
    highest_sound,
    limits_of,
    of_gearbox,
    of_motor,
    of_simulations,
)
from tests.support.measured_sets import needs_measured

HIGHEST = {
    "motor": [10.4, 14.1, 14.7, 25.3, 23.2],
    "gearbox": [13.6, 15.6, 17.4, 25.7, 17.5],
    "simulated": [9.5, 11.6, 17.9, 21.5, 24.1],
}
"""Highest level of a sound part by machine and detector [dB], as in docs/diagnosis.md."""


def test_simulated_machines_name_no_sound_part() -> None:
    """Of 18 damaged parts of 2 machines, impacts 20 to 2 dB below noise and tones: two thirds are named."""
    table = list(of_simulations(range(2, 4)))
    assert [row for row in table if row.named and row.sound] == []
    assert sum(row.named and row.part == row.damaged for row in table) == 12


@pytest.fixture(scope="module")
def counted() -> dict[str, list[Levels]]:
    """Levels by machine."""
    return {
        "motor": list(of_motor()),
        "gearbox": list(of_gearbox()),
        "simulated": list(of_simulations(range(24))),
    }


@needs_measured
@pytest.mark.study
def test_limits_are_those_of_the_counted_records(counted: dict[str, list[Levels]]) -> None:
    """The limit of the kurtogram is 3 dB higher, by two records of another sound rig with 21.4 dB.

    That of the squared envelope is 4 dB higher, by bearings that the motor does not have, with 28.8 dB.
    """
    for name, rows in counted.items():
        assert list(highest_sound(rows).values()) == pytest.approx(HIGHEST[name], abs=0.06)
    limits = limits_of([row for rows in counted.values() for row in rows])
    higher = {"kurtogram band": 3, TONES: 4}
    assert limits == {name: int(limit) - higher.get(name, 0) for name, limit in LIMITS.items()}


@needs_measured
@pytest.mark.study
def test_limits_hold_on_machines_that_were_not_counted(counted: dict[str, list[Levels]]) -> None:
    """Each machine with the limits of the other two: damaged and sound parts above a limit.

    The gearbox without its gears is the machine with the most lines: without it the limits are too low.
    """
    found = {}
    for name in counted:
        others = [row for other, rows in counted.items() if other != name for row in rows]
        found[name] = above(counted[name], limits_of(others))
    assert found == {"motor": (10, 0), "gearbox": (0, 5), "simulated": (107, 0)}


@needs_measured
@pytest.mark.study
def test_named_parts(counted: dict[str, list[Levels]]) -> None:
    named = {
        name: (
            sum(row.named and row.part == row.damaged for row in rows),
            sum(row.named and row.sound for row in rows),
        )
        for name, rows in counted.items()
    }
    assert named == {"motor": (10, 0), "gearbox": (0, 0), "simulated": (106, 0)}
