# SPDX-License-Identifier: Apache-2.0
"""Statistics by time weight: shares, separations and impacts of hand-made contact histories."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.statistics import contact_statistics, signal_statistics


def test_uneven_samples_give_the_numbers_of_even_ones() -> None:
    """A solver that samples one half ten times denser must not shift the mean."""
    t = np.concatenate([np.linspace(0.0, 0.5, 20001), np.linspace(0.5, 1.0, 2001)[1:]])
    x = 1.0 + 2.0 * np.sin(2 * np.pi * t)
    s = signal_statistics(x, t)
    assert s.mean == pytest.approx(1.0, abs=1e-6)
    assert s.rms == pytest.approx(np.sqrt(2.0), rel=1e-6)
    assert abs(float(np.mean(x)) - 1.0) > 0.5


def test_shares_by_duration_not_by_count() -> None:
    t = np.array([0.0, 1.0, 2.0, 2.01, 2.02, 2.03, 3.0])
    c = contact_statistics(t, [1, 1, 0, 0, 0, 0, 1])
    assert c.loss_time == pytest.approx(0.5 + 0.03 + 0.485)
    assert c.loss_share + c.front_contact_share == pytest.approx(1.0)


def test_back_contact_both_flanks_and_impacts() -> None:
    t = np.arange(10.0)
    c = contact_statistics(t, [1, 0, -1, -1, 0, 0, 1, 2, 2, 1], [5, 0, -7, -9, 0, 0, 4, 6, 3, 2])
    assert c.back_contact_share == pytest.approx(4 / 9)
    assert c.loss_share == pytest.approx(3 / 9)
    assert [(i.flank, i.time, i.flight, i.peak) for i in c.impacts] == [
        (-1, 1.5, 1.0, 9.0),
        (1, 5.5, 2.0, 6.0),
    ]
    assert [(s.flank_before, s.flank_after) for s in c.separations] == [(1, -1), (-1, 1)]
    assert c.longest_loss == 2.0


def test_record_that_begins_and_ends_separated() -> None:
    c = contact_statistics([0.0, 1.0, 2.0, 3.0], [0, 1, 0, 0])
    assert [(s.start, s.end, s.flank_before, s.flank_after) for s in c.separations] == [
        (0.0, 0.5, None, 1),
        (1.5, 3.0, 1, None),
    ]
    assert len(c.impacts) == 1
    assert c.impacts[0].peak is None


def test_never_in_contact_and_always_in_contact() -> None:
    away = contact_statistics([0.0, 1.0], [0, 0])
    assert (away.loss_share, away.longest_loss, away.impacts) == (1.0, 1.0, ())
    there = contact_statistics([0.0, 1.0], [1, 1])
    assert (there.loss_share, there.separations) == (0.0, ())


@given(st.lists(st.tuples(st.sampled_from([1, 0, -1, 2]), st.floats(1e-3, 1.0)), min_size=2, max_size=40))
def test_separations_add_up_to_the_loss_time(record: list[tuple[int, float]]) -> None:
    state = [s for s, _ in record]
    t = np.cumsum([dt for _, dt in record])
    c = contact_statistics(t, state)
    assert sum(s.duration for s in c.separations) == pytest.approx(c.loss_time, abs=1e-9)
    assert sum(s.flank_after is not None for s in c.separations) == len(c.impacts)


@pytest.mark.parametrize("state", [[1, 3, 1], [1, 0.5, 1]])
def test_unknown_states_are_refused(state: list[float]) -> None:
    with pytest.raises(SignalError, match="contact_state: sample 1"):
        contact_statistics([0.0, 1.0, 2.0], state)


def test_lengths_and_times_are_checked() -> None:
    with pytest.raises(SignalError, match="both must come from one record"):
        contact_statistics([0.0, 1.0], [1, 1, 1])
    with pytest.raises(SignalError, match="does not increase"):
        signal_statistics([1.0, 2.0, 3.0], [0.0, 0.0, 1.0])
