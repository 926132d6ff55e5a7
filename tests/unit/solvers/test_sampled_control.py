# SPDX-License-Identifier: Apache-2.0
"""Sampled controllers in runs of all methods, against exact discrete solutions; controllers that fail."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import expm

from pitchpoint.core.errors import CompileError, SolverError
from pitchpoint.core.status import CONTROLLER, OK
from pitchpoint.elements.signals import record as sr
from pitchpoint.elements.signals.net import SignalNet
from pitchpoint.model.scenario import Scenario
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.initial_state.start import Start
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.controller import SampledController, sampled_pid
from pitchpoint.system.signals import assemble_controlled

PERIOD = 0.02
METHODS = ["generalized_alpha", "rk4", "adams", "runge_kutta", "gstiff", "wstiff", "dassl", "constant_bdf"]


def rotor(function, *, delay=0.0, state=None, parameters=None, period=PERIOD):
    """Rotor of 0.5 kg m^2 in a bath of 2 N m s whose torque is a held signal; it shall turn at 3 rad/s."""
    net = SignalNet([Body(polar_inertia=0.5, name="rotor")])
    net.sensor("speed", sr.ANGULAR_VELOCITY, 1)
    net.linear("error", {"speed": -1.0}, 3.0)
    net.held("u", unit="N m")
    net.linear("all", {"u": 1.0, "speed": -2.0})
    net.torque("motor", "all", 1)
    controller = SampledController("loop", function, ("error",), ("u",), period, delay, state, parameters)
    return assemble_controlled(net, {}, controllers=[controller])


def pi(delay=0.0):
    parameters = {"kp": 4.0, "ki": 25.0, "period": PERIOD}
    return rotor(sampled_pid, delay=delay, state={"integral": 0.0, "error": 0.0}, parameters=parameters)


def go(system, method="generalized_alpha", duration=0.5, **more):
    memory = Memory()
    more.setdefault("step", 5e-4)
    if method not in ("generalized_alpha", "rk4", "adams", "constant_bdf"):
        more.setdefault("tolerance", 1e-10)
    scenario = Scenario(duration=duration, method=method, settle_time=0.0, **more)
    done = run_time(system, scenario, sink=memory, start=Start(system, system.initial_state()))
    return done, np.concatenate(memory.times), np.concatenate(memory.rows)


def exact(n, late):
    """Speeds at the instants: the rotor over one period with the torque before and after the change."""

    def over(time):
        step = expm(np.array([[-4.0, 2.0], [0.0, 0.0]]) * time)
        return step[0, 0], step[0, 1]

    speed, integral, held = 0.0, 0.0, 0.0
    found = [speed]
    for _ in range(n):
        e = 3.0 - speed
        integral += 25.0 * PERIOD * e
        u = 4.0 * e + integral
        for time, torque in ((late, held), (PERIOD - late, u)):
            a, b = over(time)
            speed = a * speed + b * torque
        held = u
        found.append(speed)
    return np.array(found)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("delay", [0.0, 0.005])
def test_a_sampled_pi_controller_against_the_exact_discrete_solution(method, delay):
    done, times, rows = go(pi(delay), method, sample_rate=1.0 / PERIOD)
    assert done.status == OK, done.sentence
    system = pi(delay)
    found = rows[:, system.layout.channel("signal[speed]")]
    # alpha and the constant formula are of second order: (4 h)^2/12 of 3 rad/s, and for the former h^2/4 of
    # the damping 4/s times the first jump of 27 rad/s^2, for the latter that over each of 25 starts at order
    # 1; the others keep their tolerance per step
    most = {"generalized_alpha": 8e-6, "constant_bdf": 2e-5}.get(method, 2e-7)
    np.testing.assert_allclose(times, PERIOD * np.arange(26), atol=1e-12)
    np.testing.assert_allclose(found, exact(25, delay), atol=most)


def test_many_short_chunks():
    """Six hundred calls: chunks that controllers cut short say nothing about how long the next may be."""
    done, times, rows = go(pi(), duration=12.0, sample_rate=1.0 / PERIOD)
    assert done.status == OK, done.sentence
    found = rows[:, pi().layout.channel("signal[speed]")]
    np.testing.assert_allclose(found, exact(600, 0.0), atol=5e-6)


def test_a_delay_of_several_periods_keeps_outputs_in_order():
    """With u = t and a delay of 2.5 periods the output at any time is that of the call before t - delay."""
    system = rotor(lambda t, inputs, state, p: t, delay=2.5 * PERIOD)
    _, times, rows = go(system, sample_rate=1.0 / (0.5 * PERIOD))
    held = rows[:, system.layout.channel("signal[u]")]
    # the row at an instant is taken before the outputs change
    wanted = [max([0.0] + [k * PERIOD for k in range(100) if (k + 2.5) * PERIOD < t - 1e-9]) for t in times]
    np.testing.assert_allclose(held, wanted, atol=1e-12)


@pytest.mark.parametrize("method", METHODS)
def test_the_same_input_gives_the_same_bits(method):
    one, two, same = pi(), pi(), go(pi(), method)[2]
    np.testing.assert_array_equal(go(one, method)[2], same)
    np.testing.assert_array_equal(go(two, method)[2], go(two, method)[2])  # a second run of one system


def test_controllers_of_different_periods_read_before_any_writes():
    net = SignalNet([Body(polar_inertia=1.0, name="rotor")])
    for name in ("a", "b"):
        net.held(name, 1.0)
    net.torque("motor", "a", 1)
    swap = [
        SampledController("first", lambda t, x, s, p: x, ("b",), ("a",), 0.01),
        SampledController("second", lambda t, x, s, p: x + 1.0, ("a",), ("b",), 0.03),
    ]
    system = assemble_controlled(net, {}, controllers=swap)
    _, times, rows = go(system, duration=0.06, sample_rate=100.0)
    a, b = 1.0, 1.0
    seen = [(a, b)]
    for k in range(6):
        a, b = b, (a + 1.0 if k % 3 == 0 else b)
        seen.append((a, b))
    first = [system.layout.channel(f"signal[{n}]") for n in "ab"]
    np.testing.assert_array_equal(rows[1:, first], np.array(seen[1:]))


def failing(t, inputs, state, parameters):
    if t > 0.1:
        if parameters == "raise":
            raise RuntimeError("sensor lost")
        return {"nan": float("nan"), "two": [1.0, 2.0], "text": "fast"}[parameters]
    return 1.0


RAISED = f"{Path(__file__).name}, line {failing.__code__.co_firstlineno + 3}"


@pytest.mark.parametrize("method", ["generalized_alpha", "runge_kutta", "wstiff"])
@pytest.mark.parametrize(
    ("how", "said"),
    [
        ("raise", f"the controller 'loop' raised RuntimeError: sensor lost (t = 0.12 s, {RAISED})"),
        ("nan", "the controller 'loop' returned nan for 'u' (t = 0.12 s)"),
        ("two", "the controller 'loop' returned 2 numbers for 1 outputs (t = 0.12 s)"),
        ("text", "the controller 'loop' returned 'fast', which is not a list of numbers (t = 0.12 s)"),
    ],
)
def test_a_controller_that_fails_is_named_and_the_result_kept(how, said, method):
    done, times, rows = go(rotor(failing, parameters=how), method, sample_rate=1.0 / PERIOD)
    assert (done.status, done.sentence) == (CONTROLLER, said)
    assert done.t_end == pytest.approx(0.12)
    np.testing.assert_allclose(times, PERIOD * np.arange(7), atol=1e-12)
    assert np.all(np.isfinite(rows))


def test_a_controller_that_fails_at_once():
    def bad(t, inputs, state, parameters):
        raise ValueError("no")

    done, times, _ = go(rotor(bad))
    assert done.status == CONTROLLER
    assert "raised ValueError: no (t = 0 s, test_sampled_control.py, line" in done.sentence
    assert times.size == 1


def test_the_step_leads_onto_the_instants():
    done, _, _ = go(rotor(lambda t, x, s, p: 0.0, period=0.003), step=8e-4, duration=0.03)
    assert done.step == pytest.approx(7.5e-4)
    with pytest.raises(SolverError, match="no common step"):
        go(rotor(lambda t, x, s, p: 0.0, period=0.001 * np.pi), sample_rate=1000.0)


def test_clamping_keeps_the_integral_small():
    """Held at its limit for a second, the controller leaves it as soon as the error changes its sign."""
    parameters = {"kp": 1.0, "ki": 10.0, "period": PERIOD, "low": -2.0, "high": 2.0}
    state = {"integral": 0.0, "error": 0.0}
    for _ in range(50):
        assert sampled_pid(0.0, [5.0], state, parameters) == 2.0
    assert state["integral"] <= 2.0
    assert sampled_pid(0.0, [-1.0], state, parameters) < 2.0


def test_controllers_name_what_exists():
    def pair(**more):
        net = SignalNet([Body(polar_inertia=1.0, name="rotor")])
        net.held("u")
        net.linear("x", {"u": 1.0})
        given = {"inputs": ("x",), "outputs": ("u",), **more}
        loop = SampledController("loop", sampled_pid, period=0.1, **given)
        return assemble_controlled(
            net, {}, controllers=[loop, loop] if "twice" in more.get("name", "") else [loop]
        )

    with pytest.raises(CompileError, match="no signal is called 'y'"):
        pair(inputs=("y",))
    with pytest.raises(CompileError, match="'x' is not a held signal"):
        pair(outputs=("x",))
    with pytest.raises(CompileError, match="period must be positive"):
        SampledController("loop", sampled_pid, (), (), 0.0)
