# SPDX-License-Identifier: Apache-2.0
"""Newton iteration of the implicit steps: forces that jump with the position, reuse of the matrix."""

from __future__ import annotations

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.status import OK
from pitchpoint.elements.signal import OVER_ANGLE, Pool, set_constant, set_table
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.implicit.newton import MANY, WORTH
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system.system import assemble
from pitchpoint.system.workspace import FACTORISATIONS, ITERATIONS
from tests.support.engine import couplings, torques
from tests.support.machines import compiled, pair

JUMP, AT, PUSH, DAMPING, STIFFNESS = 5.0, 0.01, 2.0, 40.0, 300.0
INERTIA = np.array([1.0, 0.3])


def machine(half=1e-15):
    """Two discs on a spring; on the first a torque that pushes to one angle and falls within +-half of it."""
    records = torques([(1, 0.0), (1, 0.0)])
    pool = Pool()
    places, values = [-10.0, AT - half, AT + half, 10.0], [JUMP, JUMP, -JUMP, -JUMP]
    set_table(records[0], pool, places, values, OVER_ANGLE)
    set_constant(records[1], PUSH)
    bodies = [Body(polar_inertia=i, name=n) for i, n in zip(INERTIA, "ab", strict=True)]
    links = couplings([(1, 0, 0.0, DAMPING, 0.0), (1, 2, STIFFNESS, 0.5, 0.0)])
    return assemble(bodies, {"torque": records, "coupling": links}, pools={"torque": pool.array()})


@pytest.mark.parametrize("h", [1e-2, 1e-3])
def test_a_step_that_ends_at_a_jump_has_a_force_between_both_sides(h):
    """Euler's equation gives the torque a step used: that of its side, or at the jump one between."""
    system = machine()
    a, b = (system.layout.coordinate(f"{n}.spin") for n in "ab")
    run = generalized_alpha.start(system, system.initial_state(), h)
    allowed = 1e-9 / h**2  # what the tolerance of the iteration, 2e-10 rad, leaves over in the torques
    at_jump = 0
    for _ in range(round(0.5 / h)):
        assert run.advance(1).status == OK
        s = run.state()
        twist = STIFFNESS * (s.q[a] - s.q[b]) + 0.5 * (s.v[a] - s.v[b])
        used = INERTIA[0] * s.a[a] + DAMPING * s.v[a] + twist - PUSH
        if abs(s.q[a] - AT) < 1e-9:
            at_jump += 1
            assert abs(used) <= JUMP + allowed
        else:
            assert used == pytest.approx(JUMP if s.q[a] < AT else -JUMP, abs=allowed)
        assert INERTIA[1] * s.a[b] - twist == pytest.approx(0.0, abs=allowed)
    assert at_jump > 3


def test_a_steep_slope_is_no_jump():
    """Where the torque only falls steeply the accepted state lies on the slope."""
    h, half = 1e-2, 1e-6
    system = machine(half=half)
    a, b = (system.layout.coordinate(f"{n}.spin") for n in "ab")
    run = generalized_alpha.start(system, system.initial_state(), h)
    on_slope = 0
    for _ in range(50):
        assert run.advance(1).status == OK
        s = run.state()
        used = INERTIA[0] * s.a[a] + DAMPING * s.v[a] - PUSH
        used += STIFFNESS * (s.q[a] - s.q[b]) + 0.5 * (s.v[a] - s.v[b])
        expected = -JUMP * float(np.clip((s.q[a] - AT) / half, -1.0, 1.0))
        assert used == pytest.approx(expected, abs=2e-10 * JUMP / half + 1e-9 / h**2)
        on_slope += abs(s.q[a] - AT) < half
    assert on_slope > 3


@pytest.mark.parametrize("law", ["rectangular, high: 3e8 N/m, low: 1e8 N/m, duty: 0.3", "din3990"])
@pytest.mark.parametrize(("rpm", "h", "torque"), [(300, 1e-3, 500), (300, 2e-4, 500), (3000, 1e-3, 5)])
def test_steps_far_longer_than_the_period_of_the_mesh_do_not_fail(law, rpm, h, torque):
    """The flanks take up and let go within a step; the matrix of no one place serves them all."""
    scenario = f"scenarios:\n  run: {{speed: {{driver: {rpm} rpm}}, duration: 1 s}}\n"
    text = pair(f"{{law: {law}}}, damper: {{ratio: 0.1}}", torque=f"{torque} N m", rest=scenario)
    model, system = compiled(text, "run")
    begin = prepare_start(system, model.scenarios["run"])
    run = generalized_alpha.start(begin.system, begin.state, h)
    assert run.advance(300).status == OK


def test_a_matrix_is_kept_until_further_corrections_have_cost_as_much():
    """A pendulum with a hardening spring: a new one after six further corrections and a step with many."""
    text = """
bodies: {arm: {motion: torsion, inertia: 1 kg m^2}}
loads: {spring: {body: arm, torque: "-40*angle - 1000*angle^3"}}
scenarios: {run: {start: assembled, speed: {arm: 4 rad/s}, duration: 20 s, step: 20 ms}}
"""
    system = pp.compile_model(pp.load_model(text=text), "run")
    run = generalized_alpha.start(system, prepare_start(system, system.scenario).state, 0.02)
    clock, fewest, extra, renewed, corrections = system.workspace.clock, 0, WORTH, 0, MANY + 1
    for _ in range(1000):
        wanted = extra >= WORTH and corrections > MANY
        before, matrices = int(clock[ITERATIONS]), int(clock[FACTORISATIONS])
        assert run.advance(1).status == OK
        corrections, new = int(clock[ITERATIONS]) - before, int(clock[FACTORISATIONS]) - matrices
        assert new == wanted
        if new:
            fewest, extra, renewed = corrections, 0, renewed + 1
        extra += max(corrections - fewest, 0)
    assert 10 < renewed < 400
