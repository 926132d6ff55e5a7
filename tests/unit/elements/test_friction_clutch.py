# SPDX-License-Identifier: Apache-2.0
"""Clutches and brakes: sticking without creep, slip, capacity over time, stick-slip against other
solutions."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pitchpoint.contact.bristle import bristle_rate, stribeck
from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements import coupling, drive, friction_clutch, torque
from pitchpoint.elements import signal as sig
from pitchpoint.elements.friction_clutch import BRISTLE, REGULARISED
from pitchpoint.elements.ratio import SPIN
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.forces import check_balance, check_matrices, moving, power, shafts

PAIRS = [(1, 0), (3, 0), (1, 2), (2, 3), (2, 4), (3, 4)]
FORMULA = ("t", "angle", "speed")


def clutch(i, j, k, sticking, **numbers):
    record = np.zeros(1, friction_clutch.RECORD)
    record["i"], record["j"], record["k"], record["sticking"] = i, j, k, sticking
    given = {"ratio": 1.4, "v_s": 0.8, "v_eps": 5.0, "stiffness": 20.0, "onset": 0.5, "sigma": 0.01}
    for name, value in (given | numbers).items():
        record[name] = value
    return record


@pytest.mark.nojit
@pytest.mark.parametrize("y", [0.2, 0.8, -0.8, 1.6])
@pytest.mark.parametrize("sticking", [REGULARISED, BRISTLE])
@pytest.mark.parametrize(("i", "j"), PAIRS)
def test_tangents_and_balance(i, j, sticking, y):
    rng = np.random.default_rng(5)
    record, pool = clutch(i, j, 5 if sticking == BRISTLE else 0, sticking), sig.Pool()
    sig.set_formula(record[0], pool, Formula.parse("9 + 2*sin(3*angle) + cos(speed) + t", FORMULA))
    bodies = shafts(rng, states=1)
    system = assemble(bodies, {"friction_clutch": record}, pools={"friction_clutch": pool.array()})
    state = moving(system, rng, 0.4, 0.05)
    state.v[system.spin("state0")] = y
    check_matrices(system, state, 2e-7)
    check_balance(system, state)
    slip = evaluate.observe(system, state)[system.layout.channel("slip_speed[friction_clutch0]")]
    lost = evaluate.observe(system, state)[system.layout.channel("friction_power[friction_clutch0]")]
    assert power(system, state) == pytest.approx(-lost, rel=1e-12)
    assert abs(slip) > 0.05


def brake(load, sticking, capacity=10.0, **numbers):
    """A disc that is loaded against a brake."""
    bodies = [Body(polar_inertia=0.5, name="disc"), Body(polar_inertia=1.0, name="state0")]
    loads, pool = np.zeros(1, torque.RECORD), sig.Pool()
    loads["i"] = 1
    sig.set_formula(loads[0], pool, Formula.parse(load, FORMULA))
    record, more = clutch(1, 0, 2 if sticking == BRISTLE else 0, sticking, **numbers), sig.Pool()
    if isinstance(capacity, str):
        sig.set_formula(record[0], more, Formula.parse(capacity, FORMULA))
    else:
        record["value"] = capacity
    return assemble(
        bodies,
        {"torque": loads, "friction_clutch": record},
        pools={"torque": pool.array(), "friction_clutch": more.array()},
    )


STIFF = {"stiffness": 1e4, "sigma": 2e-3, "v_s": 1e-2, "onset": 0.8, "v_eps": 1e-3}


def test_what_sticks_stays_where_it_is():
    """Half the capacity and a vibration below breakaway for 100 periods: no creep with bristles, a drift
    without."""
    load = "4*(1 - exp(-20*t)) + 2*sin(40*t)"
    moved = {}
    for sticking in (BRISTLE, REGULARISED):
        system = brake(load, sticking, **STIFF)
        period = 2.0 * np.pi / 40.0
        run = start(system, system.initial_state(), period / 200.0, rho_inf=0.6)
        run.advance(20 * 200)
        early = run.state().q[0]
        run.advance(100 * 200)  # whole periods, so the vibration drops out
        moved[sticking] = run.state().q[0] - early
    # the elastic deflection is 6e-5 rad; nothing but the tolerance of the iteration moves it
    assert abs(moved[BRISTLE]) < 1e-12
    assert moved[REGULARISED] > 1e-3


def test_breakaway_and_steady_slip():
    """A slowly growing torque breaks away at the static capacity and drives against the dynamic one."""
    system = brake("2*t", BRISTLE, 10.0, **STIFF | {"ratio": 1.5})
    run, seen = start(system, system.initial_state(), 1e-4, rho_inf=0.6), []
    for _ in range(160):
        run.advance(500)
        seen.append((run.t, *run.state().v[:1]))
    seen = np.array(seen)
    sliding = seen[np.abs(seen[:, 1]) > 0.05]
    # 2 t = 15: within one sample, after a slip of a bristle
    assert sliding[0, 0] == pytest.approx(7.5, abs=0.06)
    # J w' = 2 t - 10
    rate = (sliding[-1, 1] - sliding[-2, 1]) / 0.05
    assert 0.5 * rate == pytest.approx(2.0 * (sliding[-1, 0] - 0.025) - 10.0, rel=1e-3)


def test_a_clutch_engages_over_time_and_synchronises():
    """Two discs, a capacity that rises: speeds meet at the common momentum, the loss is the energy given
    up."""
    bodies = [
        Body(polar_inertia=0.5, name="a"),
        Body(polar_inertia=1.5, name="b"),
        Body(polar_inertia=1.0, name="state0"),
    ]
    record, pool = clutch(1, 2, 3, BRISTLE, **STIFF), sig.Pool()
    sig.set_table(record[0], pool, [0.0, 0.2, 1.0], [0.0, 0.0, 40.0])
    system = assemble(bodies, {"friction_clutch": record}, pools={"friction_clutch": pool.array()})
    state = system.initial_state()
    one, two = system.spin("a"), system.spin("b")
    state.v[one], state.v[two] = 20.0, 4.0
    run = start(system, state, 1e-4, rho_inf=0.6)
    run.advance(1900)
    assert run.state().v[one] == pytest.approx(20.0, abs=1e-12)  # open
    run.advance(12000)
    end = run.state()
    common = (0.5 * 20.0 + 1.5 * 4.0) / 2.0
    assert end.v[one] == pytest.approx(common, abs=1e-6)
    assert end.v[two] == pytest.approx(common, abs=1e-6)


def belt(v_belt, k, capacity, ratio, stiffness, sigma, v_s):
    """A disc on a torsion spring, dragged along by a driven body through friction."""
    bodies = [
        Body(polar_inertia=1.0, name="disc"),
        Body(polar_inertia=1.0, name="belt"),
        Body(polar_inertia=1.0, name="state0"),
    ]
    springs = np.zeros(1, coupling.RECORD)
    springs["i"], springs["k"] = 1, k
    drives = np.zeros(1, drive.RECORD)
    drives["i"], drives["q_i"], drives["speed"] = 2, SPIN, v_belt
    record = clutch(
        1, 2, 3, BRISTLE, value=capacity, ratio=ratio, stiffness=stiffness, sigma=sigma, v_s=v_s, onset=0.8
    )
    system = assemble(bodies, {"coupling": springs, "friction_clutch": record}, {"drive": drives})
    state = system.initial_state()
    state.v[system.spin("disc")] = state.v[system.spin("belt")] = v_belt
    return system, state


def test_stick_slip_of_a_mass_on_a_belt():
    """Limit cycle against SciPy on the same friction and against the closed form of dry friction.

    Closed form (static friction mu_s, dynamic mu_d, drop at once): stick over 2 (mu_s - mu_d) C/k at the
    speed of the belt, slip over the phase pi + 2 atan(v k/(w (mu_s - mu_d) C)) of the free oscillator w.
    """
    v, k, C, ratio, stiffness, sigma, v_s = 0.1, 100.0, 10.0, 1.5, 1e6, 6e-4, 2e-3
    system, state = belt(v, k, C, ratio, stiffness, sigma, v_s)
    disc = system.spin("disc")
    h, chunk = 1e-5, 50
    run, found = start(system, state, h, rho_inf=0.8), []
    for _ in range(8000):
        run.advance(chunk)
        end = run.state()
        found.append((run.t, end.q[disc], end.v[disc]))
    found = np.array(found)

    def rates(t, x):
        rel = x[1] - v
        steady, slope = stribeck(rel, ratio, v_s)
        rate = bristle_rate(x[2], rel, steady, slope, stiffness, 0.8)[0]
        return [x[1], -k * x[0] - C * (x[2] + sigma * rate), rate]

    other = solve_ivp(
        rates, (0.0, 4.0), [0.0, v, 0.0], method="Radau", rtol=1e-9, atol=1e-12, t_eval=found[:, 0]
    )
    # steps of 1e-5 s against a drop of friction within 4e-4 s: the moments of slip agree to microseconds
    np.testing.assert_allclose(found[:, 1], other.y[0], atol=2e-5)
    # sliding starts where the relative speed passes half of its largest value
    begin = [found[n, 0] for n in range(1, len(found)) if found[n, 2] < 0.0 <= found[n - 1, 2]]
    w, drop = np.sqrt(k), (ratio - 1.0) * C / k
    period = 2.0 * drop / v + (np.pi + 2.0 * np.arctan2(v / w, drop)) / w
    # bristles of 1.5e-6 rad and a drop over 2e-3 rad/s instead of none: 1 %
    assert begin[-1] - begin[-2] == pytest.approx(period, rel=0.01)
    steady = found[found[:, 0] > 2.0]
    assert steady[:, 1].max() - steady[:, 1].min() == pytest.approx(2.0 * np.hypot(drop, v / w), rel=0.01)


def test_a_stuck_brake_rings_on_its_bristles():
    """Linearised at rest: J x'' + C (y + s k x') = 0, y' = k x', the oscillator of stiffness C k."""
    J, C, k, s = 0.5, 10.0, 1e4, 1e-4
    system = brake("0", BRISTLE, C, **STIFF | {"stiffness": k, "sigma": s})
    M, D, K = evaluate.linearize(system, system.initial_state())
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])
    found = np.linalg.eigvals(A)
    wanted = np.roots([J, C * s * k, C * k])
    np.testing.assert_allclose(
        np.sort_complex(found[np.abs(found) > 1.0]), np.sort_complex(wanted), rtol=1e-9
    )
