# SPDX-License-Identifier: Apache-2.0
"""CONV: plane of the stiffness and backlash at the actual centre distance, asked of the compiled mesh.

Source: closed form, with the gears of ISO/TR 6336-30 example 1. c_gamma_alpha (ISO 6336-1) acts in the
transverse plane along the base tangent: k_bt = c_gamma_alpha b = 17.464850e9 N/m^2 * 0.1 m.
j_bt = 2 (r_b1 + r_b2) (inv alpha_wt - inv alpha_w0). Tolerances: half a unit of the last printed digit.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.model_files import ISO_EXAMPLE

BODIES = "bodies:\n  one: {gears: [pinion], motion: planar}\n  two: {gears: [wheel], motion: planar}\n"


def machine(stiffness_ratio=0.8):
    """The gears on bodies that may move in the plane, as a system."""
    text = ISO_EXAMPLE.replace("stiffness_ratio: 0.8", f"stiffness_ratio: {stiffness_ratio!r}")
    model = loads_model(text + BODIES)
    return model, compile_model(model)


def pressed(system, model, depth, phase=0.0, widening=0.0):
    """State with the wheel moved out by `widening`, `depth` past the middle of the gap, at a mesh phase."""
    state = system.initial_state()
    pair = model.pairs["stage"]
    state.q[system.layout.coordinates.index("two.x")] = widening
    roll = phase * pair.gear1.p_et
    state.q[system.spin("one")] = (0.5 * depth + roll) / (0.5 * pair.gear1.d_b)
    state.q[system.spin("two")] = (0.5 * depth - roll) / (0.5 * pair.gear2.d_b)
    return state


def seen(system, state):
    row = evaluate.observe(system, state)
    return {c.name: row[k] for k, c in enumerate(system.layout.channels)}


def gap(system, state):
    """Backlash along the base tangent: what is open on both flanks together."""
    events = [e.name for e in system.layout.events]
    values = evaluate.event_values(system, state)
    return -values[events.index("front_gap[stage]")] - values[events.index("back_gap[stage]")]


def test_mean_stiffness_along_the_base_tangent():
    """S_R that makes the mean of the parabola that of the standard, 0.75 eps_alpha + 0.25."""
    eps = loads_model(ISO_EXAMPLE).pairs["stage"].eps_alpha
    model, system = machine(1.0 - 0.75 * (1.0 - 1.0 / eps))
    n = 2000
    k = [seen(system, pressed(system, model, 2e-5, phase=i / n))["mesh_stiffness[stage]"] for i in range(n)]
    assert eps == pytest.approx(1.549090, abs=5e-7)
    assert np.mean(k) == pytest.approx(1.746485e9, abs=500.0)
    state = pressed(system, model, 2e-5)
    depth = 1e-5 - 0.5 * gap(system, state) + 1e-5
    ratio = seen(system, state)["mesh_force[stage]"] / seen(system, state)["mesh_stiffness[stage]"]
    assert ratio == pytest.approx(depth, rel=1e-9)


@pytest.mark.parametrize(
    ("widening", "j_bt", "tolerance"), [(0.0, 1.25722e-6, 0.5e-11), (1e-4, 73.1946e-6, 0.5e-10)]
)
def test_backlash_at_the_actual_centre_distance(widening, j_bt, tolerance):
    model, system = machine()
    assert gap(system, pressed(system, model, 0.0, widening=widening)) == pytest.approx(j_bt, abs=tolerance)


def test_backlash_in_the_other_directions():
    """Circumferential at the working circle and normal to the flanks, from the gap of the compiled mesh."""
    model, system = machine()
    pair = model.pairs["stage"]
    found = gap(system, pressed(system, model, 0.0, widening=1e-4))
    cos_wt = 0.5 * (pair.gear1.d_b + pair.gear2.d_b) / 0.5001
    assert found / cos_wt == pytest.approx(78.4525e-6, abs=0.5e-10)
    assert found * math.cos(pair.gear1.beta_b) == pytest.approx(70.7582e-6, abs=0.5e-10)
    wide = pair.at_center_distance(0.5001)
    assert wide.j_wt == pytest.approx(78.4525e-6, abs=0.5e-10)
    assert wide.j_bn == pytest.approx(70.7582e-6, abs=0.5e-10)


def test_slope_of_the_backlash():
    """d j_bt / d a = 2 sin alpha_wt."""
    model, system = machine()
    h = 1e-7
    gaps = [gap(system, pressed(system, model, 0.0, widening=w)) for w in (-h, h)]
    slope = 2.0 * math.sin(model.pairs["stage"].alpha_wt)
    assert (gaps[1] - gaps[0]) / (2.0 * h) == pytest.approx(slope, rel=1e-7)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_both_flanks_carry_where_the_backlash_is_negative(side):
    model, system = machine()
    state = pressed(system, model, 0.0, widening=-1e-4)
    lack = -gap(system, state)
    assert lack == pytest.approx(2.0 * 1e-4 * math.sin(model.pairs["stage"].alpha_wt) - 1.25722e-6, rel=1e-3)
    found = seen(system, state)
    assert found["contact_state[stage]"] == 2.0
    # in the middle each flank is pressed by half of what is missing; the gears are forced apart
    assert found["radial_force[stage]"] > 1e4
    assert found["normal_force[stage]"] > 10.0 * abs(found["mesh_force[stage]"])
    # gears turned by more than half of it against each other: one flank is free again
    found = seen(system, pressed(system, model, side * 0.5 * lack * 1.01, widening=-1e-4))
    assert found["contact_state[stage]"] == side
    found = seen(system, pressed(system, model, side * 0.5 * lack * 0.99, widening=-1e-4))
    assert found["contact_state[stage]"] == 2.0
