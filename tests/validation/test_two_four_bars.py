# SPDX-License-Identifier: Apache-2.0
"""IFToMM A02: two four-bars side by side, which pass a singular position twice in every swing.

Five bars of 1 m and 1 kg: uprights from (0, 0), (1, 0), (2, 0), couplers between their upper ends; gravity
9.81 m/s^2. The upper end of the first upright starts at (0, 1) with 1 m/s along x. When all bars lie in a
line the mechanism could leave its path on another branch, and its rows lose rank.

Source: IFToMM library of computational benchmark problems, problem A02, values at t = 10 s as listed in
cases.md. The frame is that of the source: x to the right, y upwards.

Near the singular position two rows say almost the same, and on its other side one of them has changed its
sign against the other: a Newton iteration with the matrix of the step before leads away there, to the other
branch in the end. It goes back to its prediction, then, and on with the matrix of that place. What rounding
and the tolerance of the iteration leave over in a row counts divided by what is left of the rank, so the
error of equal steps falls with their square down to 5e-4 s; steps so small that one of them comes closer
than 1e-4 rad to the position may stop there. Variable steps pass down to a tolerance of 1e-9; SI1 stops at
tolerances below 1e-5: its eta are integrals of multipliers that grow beyond all bounds. What does not pass
says so.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.elements.closure_rows import cut_joint
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.multibody.bodies import TORSION
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.multistep import bdf
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.mechanisms import bar

PUBLISHED = np.array([0.3284581115, 0.9445185382, 1.4230514702, -0.4948688455])


def mechanism(planar: bool):
    """Uprights and couplers in a tree, two loops cut; in the plane, or with all rows of both joints."""
    bodies = [
        bar((0, 0), (0, 1), name="first"),
        bar((0, 1), (1, 1), name="left", parent=1),
        bar((1, 0), (1, 1), name="second"),
        bar((1, 1), (2, 1), name="right", parent=3),
        bar((2, 0), (2, 1), name="third"),
    ]
    joints = [((2, 3), (1.0, 1.0, 0.0)), ((4, 5), (2.0, 1.0, 0.0))]
    rows = [cut_joint(TORSION, bodies, *ends, place, np.eye(3))[0] for ends, place in joints]
    rows = np.concatenate([r[:2] if planar else r for r in rows])
    weights = gravity_records(bodies, (0.0, -9.81, 0.0))
    return assemble(bodies, {"gravity": weights}, {"closure": rows})


def start(system):
    """The upper end of the first upright moves at 1 m/s along x."""
    state = system.initial_state()
    spin = system.layout.coordinate("first.spin")
    state.v[spin] = -1.0
    return assemble_state(system, state, keep_rates=[spin])


def run(planar: bool, kind: str, rtol: float):
    """Place and velocity of the upper end of the first upright at 10 s, and the drift of the energy."""
    system = mechanism(planar)
    begun = start(system).state
    before = energy(system, begun)
    moving = bdf.start(system, begun, kind, form="SI2", rtol=rtol)
    assert moving.advance_to(10.0).status == OK
    state = moving.state()
    drift = energy(system, state) - before
    evaluate.residual(system, state)
    pin = system.workspace.fr[2]
    return np.array([*pin["r"][:2], *pin["tw"][:2]]), drift


def energy(system, state):
    M = evaluate.matrix(system, state, 1.0, 0.0, 0.0)
    evaluate.residual(system, state)
    fr = system.workspace.fr
    heights = [
        (fr["r"][k] + fr["S"][k] @ body.center_of_mass())[1] for k, body in enumerate(system.bodies, start=1)
    ]
    return 0.5 * state.v @ M @ state.v + 9.81 * sum(heights)


def test_five_bars_have_one_degree_of_freedom():
    found = start(mechanism(False))
    assert found.freedoms == 1
    assert len(found.redundant) == 6


@pytest.mark.parametrize("kind", ["wstiff", "gstiff", "dassl"])
@pytest.mark.parametrize("planar", [True, False])
def test_two_four_bars_after_ten_seconds(planar, kind):
    """Where the rows lose rank they touch: an error of a row counts as its root in the place.

    So the error falls at least with the root of the tolerance, and that of one passage is carried on by those
    after it. 7e-4, 3e-5 and 2e-6 when this was written. The interpolated history of gstiff is too inaccurate
    for 1e-9: 7 of 42 runs with tolerances about it ended in such a place (docs/solvers.md).
    """
    for rtol in (1e-5, 1e-7) if kind == "gstiff" else (1e-5, 1e-7, 1e-9):
        found, drift = run(planar, kind, rtol)
        for value, published in zip(found, PUBLISHED, strict=True):
            assert value == pytest.approx(published, abs=0.4 * np.sqrt(rtol))
        assert abs(drift) < 0.4 * np.sqrt(rtol) * 9.81


def place_after(planar, h, **options):
    """Status, time and place and velocity of the upper end at 10 s, with equal steps of generalised-alpha."""
    system = mechanism(planar)
    moving = generalized_alpha.start(system, start(system).state, h, **options)
    status = moving.advance(round(10.0 / h)).status
    evaluate.residual(system, moving.state())
    pin = system.workspace.fr[2]
    return status, moving.t, np.array([*pin["r"][:2], *pin["tw"][:2]])


@pytest.mark.each_value
@pytest.mark.parametrize("rho_inf", [0.8, 1.0])
@pytest.mark.parametrize("form", ["I3", "SI2"])
@pytest.mark.parametrize("planar", [True, False])
def test_equal_steps_pass_with_the_error_of_their_order(planar, form, rho_inf):
    """Fourteen passages. At 5 ms, which comes near none of them, the error is 1e-4, 4 h^2.

    1e-5: what the nearest passage disturbs, which does not fade with rho_inf = 1.
    """
    for h in (1e-2, 5e-3, 2e-3, 1e-3):
        status, _, found = place_after(planar, h, form=form, rho_inf=rho_inf, tolerance=1e-13)
        assert status == OK
        np.testing.assert_allclose(found, PUBLISHED, rtol=0.0, atol=6.0 * h * h + 1e-5)


@pytest.mark.parametrize("form", ["I3", "SI2"])
@pytest.mark.parametrize("h", [2e-3, 1e-3])
def test_equal_steps_pass_at_the_default_tolerance(h, form):
    """1e-11 m over a rank of 1e-3 are 1e-8 m, and 0.04 m/s^2 in the acceleration of a step of 1 ms."""
    status, _, found = place_after(True, h, form=form)
    assert status == OK
    np.testing.assert_allclose(found, PUBLISHED, rtol=0.0, atol=1e-4)


@pytest.mark.parametrize("form", ["I3", "SI2"])
def test_steps_that_are_too_short_pass_or_say_that_they_do_not(form):
    """Nothing may go on along another branch unnoticed: another branch is off by 4 and more.

    On the right one, five steps between 0.19 and 0.21 ms are off by 0.0056 to 0.0105, because without
    numerical damping what round-off adds at a singular position stays; 0.1 lies far from both.
    """
    status, reached, found = place_after(True, 2e-4, form=form, rho_inf=1.0)
    if status == OK:
        np.testing.assert_allclose(found, PUBLISHED, atol=0.1)
    else:
        assert reached < 10.0


@pytest.mark.parametrize("rtol", [1e-5, 1e-7])
def test_multipliers_as_rates_pass_or_say_that_they_do_not(rtol):
    system = mechanism(True)
    moving = bdf.start(system, start(system).state, "gstiff", form="SI1", rtol=rtol)
    status = moving.advance_to(10.0).status
    if status == OK:
        evaluate.residual(system, moving.state())
        pin = system.workspace.fr[2]
        np.testing.assert_allclose([*pin["r"][:2], *pin["tw"][:2]], PUBLISHED, atol=0.4 * np.sqrt(rtol))
    else:
        assert moving.t < 10.0
    assert rtol < 1e-5 or status == OK
