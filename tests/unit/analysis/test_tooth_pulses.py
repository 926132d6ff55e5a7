# SPDX-License-Identifier: Apache-2.0
"""Load pulses of teeth: which tooth, how large, on which flank, from forces of tooth pairs in rows."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.tooth_pulses import find_passages, find_pulses, tooth_loads

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


def places(begin=0.1, length=1.7):
    """Pair in the middle of its path, for front and back flanks."""
    middle = PLACE - begin - 0.5 * length
    return middle, middle


def loads(peaks):
    return tooth_loads([find_pulses(rows_of(peaks), places())], TEETH, 6.0)


def test_every_tooth_has_its_own_force():
    found = loads(lambda n: 100.0 + n % TEETH)["front"]
    assert found.largest == pytest.approx(100.0 + np.arange(TEETH), rel=1e-3)
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
    pulses = find_pulses(rows, places())
    assert pulses.force.size in (39, 40)


def test_flanks_that_alternate_in_one_passage_have_one_pulse_each():
    """Front, back, front, back, front in rattle."""
    rows = np.zeros((ROWS, PLACE.size))
    rows[1, 900:950] = [20.0] * 10 + [-5.0] * 10 + [30.0] * 10 + [-7.0] * 10 + [25.0] * 10
    pulses = find_pulses(rows, (PLACE - 8.2, PLACE - 8.2))
    assert pulses.force.tolist() == [30.0, -7.0] and pulses.tooth.tolist() == [1, 1]


def test_part_of_a_passage_belongs_to_its_pair():
    """Contact in the last tenth of the path only; rows tell pairs apart."""
    rows = rows_of(lambda n: 30.0)
    rows[:, (PLACE - 0.1) % 1.0 < 0.5] = 0.0
    found = find_pulses(rows, places())
    assert np.all(np.diff(np.sort(found.tooth)) <= 1) and found.tooth.min() == 0


@pytest.mark.parametrize("side", [1, -1])
def test_whole_force_of_a_mesh(side):
    """The pair nearest to the middle of its path, on the flank with the force."""
    found = find_passages(side * (100.0 + np.rint(PLACE)), (PLACE, PLACE))
    assert np.array_equal(np.abs(found.force), 100.0 + found.tooth) and np.all(found.force * side > 0.0)
