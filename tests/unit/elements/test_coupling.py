# SPDX-License-Identifier: Apache-2.0
"""Torsion between bodies in a tree: angles with the spins of parents, senses, laws, exact tangents."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements import coupling, torque, torsion_maxwell
from pitchpoint.elements import signal as sig
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.forces import check_balance, check_matrices, mechanism, moving, power, shafts

TWO_PI = 2.0 * np.pi
PAIRS = [(1, 0), (3, 0), (1, 2), (2, 3), (2, 4), (3, 4), (1, 4)]


def drag(t, x, p):
    return -p[0] * x * abs(x)


def one(i, j, form="linear", kind=coupling):
    """One coupling, or one torque, with a law of some form."""
    record, pool = np.zeros(1, kind.RECORD), sig.Pool()
    record["i"], record["j"] = i, j
    laws = [None]
    if kind is coupling:
        record["k"], record["d"], record["u0"] = 30.0, 2.0, 0.1
    if form == "table":
        sig.set_table(record[0], pool, [-60.0, 0.0, 60.0], [500.0, 0.0, -900.0], sig.OVER_ANGLE)
    elif form == "formula":
        sig.set_formula(
            record[0], pool, Formula.parse("-0.2*angle^3 - 0.3*speed*angle^2", ("t", "angle", "speed"))
        )
    elif form == "rate":
        sig.set_law(record[0], pool, (4.0,), sig.OVER_SPEED)
        laws = [drag]
    return {
        "banks": {kind.__name__.rsplit(".", 1)[1]: record},
        "pools": {kind.__name__.rsplit(".", 1)[1]: pool.array()},
        "laws": {kind.__name__.rsplit(".", 1)[1]: laws},
    }


def made(bodies, parts):
    return assemble(bodies, parts["banks"], pools=parts["pools"], laws=parts["laws"])


@pytest.mark.nojit
@pytest.mark.parametrize("form", ["linear", "table", "formula", "rate"])
@pytest.mark.parametrize("kind", [coupling, torque])
@pytest.mark.parametrize(("i", "j"), PAIRS)
def test_tangents_and_balance_in_a_train_on_a_carrier(i, j, kind, form):
    rng = np.random.default_rng(5)
    system = made(shafts(rng), one(i, j, form, kind))
    state = moving(system, rng, 0.4, 0.05)
    state.turns[1:] = 1, -2, 3, 0
    if form == "table":  # away from the knees
        state.turns[:] = 0
    check_matrices(system, state, 1e-7)
    check_balance(system, state)


@pytest.mark.parametrize("kind", [coupling, torque])
def test_a_torque_between_crossed_axes_turns_about_the_first(kind):
    """A housing whose own axis lies across takes the reaction and gives no angle."""
    rng = np.random.default_rng(8)
    bodies = mechanism(rng)
    found = 0
    for i, j in ((1, 2), (1, 3), (2, 3), (4, 3)):
        system = made(bodies, one(i, j, "rate", kind))
        state = moving(system, rng)
        evaluate.residual(system, state)
        axes = system.workspace.fr["R"][:, :, 2]
        if abs(axes[i] @ axes[j]) < 0.7:
            found += 1
            check_balance(system, state)
            if kind is torque:  # no angle in its law: the whole derivative
                check_matrices(system, state, 1e-7)
    assert found >= 2


def test_angles_count_the_spins_of_the_parents():
    rng = np.random.default_rng(2)
    bodies = shafts(rng)
    state = None
    for i, j, angle in (
        (3, 0, 0.3 + 0.5 + TWO_PI * (3 - 2)),
        (2, 3, -0.5 - 3 * TWO_PI),
        (4, 0, -0.3 + 0.7 + TWO_PI * 2),  # upside down: the carrier turns it backwards about its own axis
        (3, 4, 0.5 + 0.7 + TWO_PI * 3),
        (2, 4, 0.7),
    ):
        system = made(bodies, one(i, j))
        state = system.initial_state()
        state.q[[system.spin(n) for n in ("carrier", "planet", "other")]] = 0.3, 0.5, 0.7
        state.turns[1:] = 5, -2, 3, 0
        twist = evaluate.observe(system, state)[system.layout.channel("twist[coupling0]")]
        assert twist == pytest.approx(angle - 0.1, abs=1e-14)


def test_whole_turns_cost_no_digit():
    """A periodic table over the relative angle gives the same bits after a million turns of both bodies."""
    rng = np.random.default_rng(3)
    record, pool = np.zeros(1, coupling.RECORD), sig.Pool()
    record["i"], record["j"] = 3, 4
    sig.set_table(record[0], pool, [0.0, 1.0, TWO_PI], [0.0, 3.0, 0.0], sig.OVER_ANGLE, TWO_PI)
    system = assemble(shafts(rng), {"coupling": record}, pools={"coupling": pool.array()})
    state = moving(system, rng, 0.3, 0.0)
    before = evaluate.residual(system, state)
    state.turns[3] += 1_000_003
    state.turns[2] -= 20
    np.testing.assert_array_equal(evaluate.residual(system, state), before)


def test_a_torque_does_work_with_the_relative_speed():
    rng = np.random.default_rng(4)
    system = made(shafts(rng), one(2, 3, "rate", torque))
    state = moving(system, rng, 0.4, 0.05)
    speed = -state.v[system.spin("planet")]
    assert power(system, state) == pytest.approx(-4.0 * abs(speed) ** 3, rel=1e-12)


@pytest.mark.nojit
def test_a_law_may_use_angle_and_rate_together():
    """What a law of two arguments needs lies behind its parameters."""
    record, pool = np.zeros(1, coupling.RECORD), sig.Pool()
    record["i"] = 1
    sig.set_law(record[0], pool, (7.0,), sig.OVER_BOTH)
    law = lambda t, x, p: -p[0] * x - 0.5 * p[1] * x * x  # noqa: E731
    system = assemble(
        [Body(polar_inertia=1.0)],
        {"coupling": record},
        pools={"coupling": pool.array()},
        laws={"coupling": [law]},
    )
    state = system.initial_state()
    state.q[0], state.v[0] = 0.3, 2.0
    state.turns[1] = 1
    x = 0.3 + TWO_PI
    assert evaluate.residual(system, state)[0] == pytest.approx(7.0 * x + 0.5 * 2.0 * x * x)
    check_matrices(system, state, 1e-7)


def relaxing(i, j, k, stiffness, damping):
    record = np.zeros(1, torsion_maxwell.RECORD)
    record["i"], record["j"], record["k"] = i, j, k
    record["stiffness"], record["damping"] = stiffness, damping
    return {"torsion_maxwell": record}


@pytest.mark.nojit
@pytest.mark.parametrize(("i", "j"), PAIRS)
def test_maxwell_elements_in_torsion(i, j):
    rng = np.random.default_rng(5)
    system = assemble(shafts(rng, states=1), relaxing(i, j, 5, 40.0, 3.0))
    state = moving(system, rng, 0.4, 0.05)
    check_matrices(system, state)
    check_balance(system, state)
    moment = state.v[system.spin("state0")]
    change = system.workspace.fr[5]["F"][5] + state.a[system.spin("state0")]
    # power = -d(T^2/2k)/dt - T^2/d
    assert power(system, state) == pytest.approx(-moment * change / 40.0 - moment**2 / 3.0, rel=1e-10)


def test_relaxation_in_torsion_against_the_closed_form():
    """Two discs through a Maxwell element: exact modal sum of the three first-order equations."""
    bodies = [
        Body(polar_inertia=0.5, name="a"),
        Body(polar_inertia=2.0, name="b"),
        Body(polar_inertia=1.0, name="state0"),
    ]
    system = assemble(bodies, relaxing(1, 2, 3, 600.0, 20.0))
    state = system.initial_state()
    state.v[system.spin("a")] = 3.0
    h, n = 1e-4, 4000
    run = start(system, state, h, rho_inf=1.0)
    run.advance(n)
    A = np.array([[0.0, 0.0, 2.0], [0.0, 0.0, -0.5], [-600.0, 600.0, -30.0]])
    values, modes = np.linalg.eig(A)
    wanted = ((modes * np.exp(values * n * h)) @ np.linalg.solve(modes, [3.0, 0.0, 0.0])).real
    found = [run.state().v[system.spin(name)] for name in ("a", "b", "state0")]
    # second order: (omega h)^2/12 times the number of radians is below 1e-5
    np.testing.assert_allclose(found, wanted, rtol=2e-5, atol=1e-5)
