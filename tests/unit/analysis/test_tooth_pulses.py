# SPDX-License-Identifier: Apache-2.0
"""Load pulses of teeth: which tooth, how large, on which flank, from forces of tooth pairs in rows."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.tooth_pulses import find_pulses, tooth_loads

TEETH, ROWS, PASSED, FINE = 7, 3, 40, 100
PLACE = np.linspace(0.0, PASSED, PASSED * FINE + 1)
"""Rotation [teeth]."""


def rows_of(peaks, begin=0.1, length=1.7):
    """Pair N carries half a sine of its peak from N + begin over `length` teeth, in row N mod ROWS."""
    found = np.zeros((ROWS, PLACE.size))
    for n in range(PASSED):
        x = (PLACE - n - begin) / length
        inside = (x > 0.0) & (x < 1.0)
        found[n % ROWS, inside] = peaks(n) * np.sin(np.pi * x[inside])
    return found


def loads(peaks, turn=0.0, **how):
    rotation = 2.0 * np.pi * PLACE / TEETH
    pulses = find_pulses(rows_of(peaks, **how), rotation - turn, TEETH)
    return tooth_loads([pulses], TEETH, 6.0)


def test_every_tooth_has_its_own_force():
    found = loads(lambda n: 100.0 + n % TEETH)["front"]
    assert sorted(found.largest.round(1)) == [100.0, 101.0, 102.0, 103.0, 104.0, 105.0, 106.0]
    assert np.array_equal(np.argsort(found.largest), np.argsort(found.equivalent / found.pulses ** (1 / 6)))
    assert 38 <= found.pulses.sum() <= 40 and np.ptp(found.pulses) <= 1


def test_equal_pulses_have_their_force_as_equivalent():
    found = loads(lambda n: 50.0)["front"]
    factor = (found.pulses / found.pulses.mean()) ** (1 / 6)
    assert found.equivalent == pytest.approx(50.0 * factor, rel=1e-3)


def test_back_flanks_are_counted_apart():
    found = loads(lambda n: -80.0 if n < 20 else 60.0)
    assert found["back"].largest.max() == pytest.approx(80.0, rel=1e-3)
    assert found["front"].largest.max() == pytest.approx(60.0, rel=1e-3)
    assert found["back"].pulses.sum() == 20


def test_a_pair_that_separates_within_its_contact_has_one_pulse():
    rows = rows_of(lambda n: 30.0)
    gap = (PLACE % 1.0 > 0.55) & (PLACE % 1.0 < 0.65)
    rows[:, gap] = 0.0
    pulses = find_pulses(rows, 2.0 * np.pi * PLACE / TEETH, TEETH)
    assert pulses.force.size in (39, 40)


def test_planets_load_the_same_teeth_of_a_sun():
    """The overloaded tooth passes the second mesh 7/3 teeth later: the same tooth, whatever the fraction."""
    rotation = 2.0 * np.pi * PLACE / TEETH
    shift = TEETH / 3.0
    first = find_pulses(rows_of(lambda n: 90.0 if n % TEETH == 3 else 40.0), rotation, TEETH)
    rows = rows_of(lambda n: 90.0 if n % TEETH == 3 else 40.0, begin=0.1 + shift)
    second = find_pulses(rows, rotation - 2.0 * np.pi / 3.0, TEETH)
    found = tooth_loads([first, second], TEETH, 6.0)["front"]
    assert np.sort(found.largest) == pytest.approx([40.0] * 6 + [90.0], rel=1e-3)
