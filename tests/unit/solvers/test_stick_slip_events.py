# SPDX-License-Identifier: Apache-2.0
"""Blocks on slides with friction: to break loose and to come to rest are one event each, to rest is none."""

from __future__ import annotations

import math

import pytest
from scipy.integrate import solve_ivp

from pitchpoint.core.status import OK
from pitchpoint.solvers.time import run_time
from tests.support.machines import compiled

MASS, MU, SLIP_SPEED = 2.0, 0.2, 1e-4
FRICTION = MU * MASS * 9.81
BLOCK = """\
gravity: [0, 0, -9.81]
bodies: {{block: {{mass: 2, markers: {{c: {{position: [0, 0, 0]}}}}}}}}
joints:
  slide:
    type: prismatic
    bodies: [ground, block]
    position: [0, 0, 0]
    axes: {{z: [1, 0, 0]}}
    speed: {{z: {speed}}}
    friction: {{coefficient: 0.2, slip_speed: 0.1 mm/s}}
loads: {{push: {{body: block, marker: c, force: ["{force}", 0, 0]}}}}
scenarios:
  go: {{start: assembled, duration: {duration} s, method: {method}, events: [stick_slip], sample_rate: 1 kHz}}
"""
# friction grows up within m v/(1.5 mu m g) = 34 us: equal steps have to be shorter
METHODS = (
    "generalized_alpha, step: 10 us",
    "rk4, step: 20 us",
    "adams, step: 20 us",
    "runge_kutta, tolerance: 1e-7",
    "gstiff, tolerance: 1e-6",
    "wstiff, tolerance: 1e-6",
    "dassl, tolerance: 1e-6",
)


def slips(method: str, force: str = "0 N", *, speed: float = 0.0, duration: float = 0.5):
    """Event functions, times [s] and directions of a run, in the order of time."""
    text = BLOCK.format(method=method, force=force, speed=speed, duration=duration)
    done = run_time(compiled(text, "go")[1])
    assert done.status == OK, done.sentence
    return [
        (done.event_names[int(k)].partition("[")[0], t, way) for t, k, way in sorted(map(tuple, done.events))
    ]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("speed", [1.0, -1.0])
def test_a_block_that_comes_to_rest_has_one_event(method: str, speed: float) -> None:
    """v = v_0 - mu g t falls to the slip speed; what is left dies away there, whatever rounding makes of it.

    Equal steps go over the event, which a straight line places within theirs.
    """
    ((name, when, way),) = slips(method, speed=speed, duration=1.5)
    assert (name, way) == ("forward_slip" if speed > 0.0 else "backward_slip", -1)
    assert when == pytest.approx((1.0 - SLIP_SPEED) / (MU * 9.81), abs=2e-5)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("force", ["0 N", "2 N", "-2 N", "3.9 N", "3.5 N*sin(2*pi*t/(0.1 s))"])
def test_a_block_that_is_held_has_no_events(method: str, force: str) -> None:
    """Friction carries 3.924 N, at rest and creeping."""
    assert slips(method, force) == []


@pytest.fixture(scope="module")
def swinging():
    """Instants at which the slip speed is passed under a force that swings: SciPy on m v' = F - mu m g S."""

    def rate(t, v):
        x = min(max(v[0] / SLIP_SPEED, -1.0), 1.0)
        return [(10.0 * math.sin(math.pi * t) - FRICTION * 0.5 * x * (3.0 - x * x)) / MASS]

    done = solve_ivp(
        rate,
        (0.0, 1.6),
        [0.0],
        method="Radau",
        rtol=1e-10,
        atol=1e-13,
        max_step=2e-3,
        events=[lambda t, v: v[0] - SLIP_SPEED, lambda t, v: v[0] + SLIP_SPEED],
    )
    forward, backward = done.t_events
    assert (len(forward), len(backward)) == (2, 1)
    return [*forward, *backward]


@pytest.mark.parametrize("method", METHODS)
def test_a_block_breaks_loose_and_turns_back(method: str, swinging) -> None:
    """Slip begins a little after the force exceeds friction, and turns round when the momentum is gone.

    Rates are good to some 1e-6 m/s. Where slip begins they grow by 1e-2 m/s^2, where it turns by 4 m/s^2 and
    more; a straight line over 20 us bends by less than that.
    """
    found = slips(method, "10 N*sin(pi*t/(1 s))", duration=1.6)
    assert [(name, way) for name, _, way in found] == [
        ("forward_slip", 1),
        ("forward_slip", -1),
        ("backward_slip", 1),
    ]
    assert math.asin(FRICTION / 10.0) / math.pi < found[0][1]
    assert found[0][1] == pytest.approx(swinging[0], abs=1e-4)
    for k in (1, 2):
        assert found[k][1] == pytest.approx(swinging[k], abs=5e-6)
