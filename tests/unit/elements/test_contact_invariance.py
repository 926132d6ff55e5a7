# SPDX-License-Identifier: Apache-2.0
"""Contacts wherever they are: the world moved and turned, whole turns, what they report."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.system import evaluate
from tests.support.contacts import contact, pair, shaken
from tests.unit.elements import test_planar_contact as planar
from tests.unit.elements import test_surface_contact as surface

SHAPES = {**planar.SHAPES, **surface.SHAPES}


def build(name, where, seed):
    kind, setup, apart, *law = SHAPES[name]
    return pair(kind, contact(kind, setup, *law), apart, np.random.default_rng(seed), where)


@pytest.mark.parametrize("where", ["free", "ground"])
@pytest.mark.parametrize("name", SHAPES)
def test_the_world_may_be_moved_and_turned(name, where):
    """Coordinates count in the axes of the bodies, so the same state has the same residual anywhere."""
    found = []
    for seed in (1, 2):
        system = build(name, where, seed)
        state = shaken(system, np.random.default_rng(5))
        found.append(evaluate.residual(system, state))
    assert np.abs(found[0]).max() > 1e-3
    # places of about 1 m are known to 1e-16 m, and the stiffness is about 1e5 N/m
    np.testing.assert_allclose(found[1], found[0], atol=1e-9 * np.abs(found[0]).max())


@pytest.mark.parametrize("where", ["free", "tree"])
@pytest.mark.parametrize("name", SHAPES)
def test_whole_turns_change_nothing(name, where):
    system = build(name, where, 1)
    state = shaken(system, np.random.default_rng(5))
    before = evaluate.residual(system, state)
    state.turns[1:] += (5, -3, 2)[: state.turns.size - 1]
    np.testing.assert_array_equal(evaluate.residual(system, state), before)


@pytest.mark.parametrize("name", SHAPES)
def test_observations_and_events_are_declared_and_finite(name):
    system = build(name, "free", 1)
    for scale in (0.0, 1.0):  # in touch, and anywhere
        state = shaken(system, np.random.default_rng(5))
        state.q[:3] += scale * np.array([0.3, -0.2, 0.4])
        row = evaluate.observe(system, state)
        assert row.size == len(system.layout.channels)
        assert np.all(np.isfinite(row))
        names = [c.name for c in system.layout.channels]
        assert len(set(names)) == row.size
        kind = SHAPES[name][0]
        gap = row[names.index(f"gap[{kind}0]")]
        assert evaluate.event_values(system, state) == [gap]
        assert (row[names.index(f"contact_force[{kind}0]")] > 0.0) <= (gap < 0.0)
