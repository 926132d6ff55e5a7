# SPDX-License-Identifier: Apache-2.0
"""Blocks on slides with friction: to break loose and to come to rest are one event each, to rest is none."""

from __future__ import annotations

import math

import pytest
from scipy.optimize import brentq

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


@pytest.mark.parametrize("method", METHODS)
def test_a_block_breaks_loose_and_turns_back(method: str) -> None:
    """A force F that swings: slip begins where it exceeds friction and turns round when the momentum is gone.

    Before F reaches friction the block creeps; from there on m a >= F' t, so it has its slip speed v within
    sqrt(2 m v/F'). The rate F' falls by less than 1 % meanwhile.
    """
    found = slips(method, "10 N*sin(pi*t/(1 s))", duration=1.6)
    assert [(name, way) for name, _, way in found] == [
        ("forward_slip", 1),
        ("forward_slip", -1),
        ("backward_slip", 1),
    ]
    loose = math.asin(FRICTION / 10.0) / math.pi
    rate = 0.99 * 10.0 * math.pi * math.cos(math.pi * loose)
    latest = math.sqrt(2.0 * MASS * SLIP_SPEED / rate)
    assert loose < found[0][1] < loose + latest

    def momentum(t: float) -> float:
        swing = 10.0 / math.pi * (math.cos(math.pi * loose) - math.cos(math.pi * t))
        return swing - FRICTION * (t - loose)

    # it may creep with the slip speed when the force reaches friction, which 12 N stop in 16 us
    for k, slip in ((1, SLIP_SPEED), (2, -SLIP_SPEED)):
        expected = brentq(lambda t, s=slip: momentum(t) - MASS * s, 1.0, 1.6)
        assert found[k][1] == pytest.approx(expected, abs=3e-5)
