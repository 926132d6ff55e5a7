# SPDX-License-Identifier: Apache-2.0
"""A body that is fixed to one that spins: elements see it as if it spun itself."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements import guide
from pitchpoint.multibody.bodies import FREE, TORSION, Body
from pitchpoint.multibody.joints import FIXED, GUIDED
from pitchpoint.system import evaluate
from pitchpoint.system.residual import EXACT
from pitchpoint.system.system import assemble
from tests.support.engine import bearings, differences, frame, positive


def seated(rng, carried, seat):
    """A shaft, on ground or on a carrier; a body fixed to it where it stands, a bearing on one of them."""
    axes = frame(rng)
    bodies = [Body(motion=TORSION, axes=axes, mass=1.0, inertia=np.eye(3), name="carrier")] if carried else []
    first = len(bodies) + 1
    bodies.append(
        Body(
            motion=FREE,
            parent=first - 1,
            axes=axes,
            position=rng.normal(size=3),
            mass=2.0,
            inertia=np.diag([0.3, 0.4, 0.5]),
            name="shaft",
        )
    )
    bodies.append(
        Body(
            motion=FIXED,
            parent=first,
            axes=axes,
            position=bodies[-1].position,
            spinner=first if seat else 0,
            name="seat",
        )
    )
    rows = bearings([(first + 1 if seat else first, 0, 1e3 * positive(rng), positive(rng))])
    return assemble(bodies, {"bearing": rows})


def stirred(system, rng, turns=3):
    state = system.initial_state()
    n = system.sizes["nd"]
    state.q[:] = rng.uniform(-0.4, 0.4, n)
    state.v[:], state.a[:] = rng.normal(size=n), rng.normal(size=n)
    b = system.layout.bodies.index("shaft")
    state.q[system.program["body"][b]["spin"]] = 2.6
    state.turns[b] = turns
    return state


@pytest.mark.nojit
@pytest.mark.parametrize("carried", [False, True])
def test_the_seat_is_the_shaft(carried):
    """The same frame, spin and whole turns; wrenches and exact tangents of a bearing on it, too."""
    pair = []
    for seat in (False, True):
        rng = np.random.default_rng(5)
        system = seated(rng, carried, seat)
        state = stirred(system, rng)
        found = evaluate.residual(system, state).copy()
        exact = evaluate.matrix(system, state, 0.3, 0.7, 1.0, EXACT)
        pair.append((found, exact, system.workspace.fr.copy()))
    for one, two in zip(pair[0][:2], pair[1][:2], strict=True):
        np.testing.assert_allclose(two, one, rtol=1e-10, atol=1e-9 * np.abs(one).max())
    shaft, seat = pair[1][2][-2:]
    for name in ("r", "R", "S", "tw", "ac", "phi", "spin", "turns", "base", "base_turns", "axle"):
        np.testing.assert_allclose(seat[name], shaft[name], atol=1e-12, err_msg=name)


def test_whole_turns_change_nothing_but_the_count():
    rng = np.random.default_rng(6)
    system = seated(rng, True, True)
    state = stirred(system, rng, 0)
    evaluate.residual(system, state)
    frames = system.workspace.fr.copy()
    for turns in (-4, 7, 10**12):
        state.turns[system.layout.bodies.index("shaft")] = turns
        evaluate.residual(system, state)
        seat = system.workspace.fr[-1]
        assert seat["turns"] == frames[-1]["turns"] + turns
        assert seat["phi"] == frames[-1]["phi"]
        np.testing.assert_array_equal(seat["R"], frames[-1]["R"])


def bent(rng, K):
    """A seat at the end of a twig that bends by three coordinates and twists, on a shaft that spins."""
    axes = frame(rng)
    bodies = [
        Body(motion=FREE, axes=axes, mass=2.0, inertia=np.diag([0.3, 0.4, 0.5]), name="shaft"),
        Body(
            motion=GUIDED,
            parent=1,
            axes=axes,
            position=axes @ [0.0, 0.0, 0.7],
            mass=0.4,
            inertia=np.diag([0.1, 0.1, 0.1]),
            guided_by=(("bend", "rad"), ("twist", "rad")),
            name="twig",
        ),
        Body(motion=FIXED, parent=2, axes=axes, position=axes @ [0.0, 0.0, 0.9], spinner=1, name="seat"),
    ]
    rows = np.zeros(3, guide.RECORD)
    rows["i"] = 2
    for row, (m, k, slope) in zip(rows, ((3, 0, 1.0), (0, 0, 0.2), (5, 1, 1.0)), strict=True):
        row["m"], row["k"], row["slope"] = m, k, slope
    rows["first"] = [True, False, False]
    return assemble(bodies, {"guide": rows, "bearing": bearings([(3, 0, K, 0.01 * K)])})


@pytest.mark.parametrize(
    ("key", "factors", "step"), [("q", (0.0, 0.0, 1.0), 1e-6), ("v", (0.0, 1.0, 0.0), 1e-2)]
)
def test_tangents_of_a_seat_that_bends(key, factors, step):
    """Stiff in all directions, the twist among them; differences of 1e-6 leave 1e-7 of the largest entry.

    Over the rates residuals are quadratic and central differences exact.
    """
    rng = np.random.default_rng(7)
    system = bent(rng, 1e3 * positive(rng))
    state = stirred(system, rng)
    exact = evaluate.matrix(system, state, *factors, EXACT)
    found = differences(system, state, key, step)
    np.testing.assert_allclose(exact, found, atol=1e-7 * np.abs(found).max())


def test_the_spin_of_a_bent_seat_is_counted_with_the_shaft():
    """Turned steadily through many turns in steps of any size, its spin grows by as much: no turn is lost."""
    rng = np.random.default_rng(8)
    system = bent(rng, np.zeros((6, 6)))
    state = stirred(system, rng, 0)
    spin = int(system.program["body"][1]["spin"])
    counted = []
    for total in np.arange(0.0, 40.0, 0.37):
        state.turns[1] = round(total / (2 * np.pi))
        state.q[spin] = total - 2 * np.pi * state.turns[1]
        evaluate.residual(system, state)
        seat = system.workspace.fr[-1]
        counted.append(seat["phi"] + 2 * np.pi * seat["turns"] - total)
    assert np.ptp(counted) < 0.2  # what the tilt of 0.4 rad makes of an even turn, twice per turn
    state.v[:] = 0.0
    state.v[spin] = 1.0
    evaluate.residual(system, state)
    here = system.workspace.fr[-1]["spin"]
    step = 1e-6
    sides = []
    for sign in (1.0, -1.0):
        moved = state.copy()
        moved.q[spin] += sign * step
        evaluate.residual(system, moved)
        sides.append(system.workspace.fr[-1]["phi"])
    assert here == pytest.approx((sides[0] - sides[1]) / (2 * step), rel=1e-8)
