# SPDX-License-Identifier: Apache-2.0
"""The example `tip-relief`: tip relief of least transmission error from 80 to 200 N m.

Constant stiffness: closed forms of the Harris map, |F/k - C|/2. Flexible teeth: the figures of the README; a
design is the drawing values of `relieved.yaml`, so that they do not depend on the way of the search.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.contact_analysis.relief.design import design_relief
from pitchpoint.solvers.contact_analysis.relief.plan import ReliefPlan
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from tests.support.relief_models import TIP, reliefs

FOLDER = Path(__file__).parents[2] / "examples" / "tip-relief"
TORQUES = (80.0, 120.0, 160.0, 200.0)
K = 3e8
LENGTH = (1e-3, 8e-3)


def forces(model):
    return np.array(TORQUES) / model.pairs["stage"].gear1.r_b


@pytest.mark.study  # tests/unit/solvers/test_relief_design.py has the same closed form for two variables
def test_constant_stiffness():
    model = load_model(FOLDER / "rigid.yaml")
    load = forces(model)
    assert load == pytest.approx([2270.2, 3405.4, 4540.5, 5675.6], abs=0.1)
    given = ReliefPlan(vary=reliefs(length=LENGTH), torques=TORQUES)
    data = design_relief(model, None, given)
    peaks = data["peak_to_peak"].isel(misalignment=0)
    assert peaks.sel(design="start").values == pytest.approx(0.5 * load / K, rel=1e-9)
    left = (load[-1] - load[0]) / (4.0 * K)
    assert left == pytest.approx(2.838e-6, rel=2e-4)
    assert float(data["objective"].sel(design="optimum")) == pytest.approx(left, rel=1e-6)
    best = 0.5 * (load[0] + load[-1]) / K
    assert best == pytest.approx(13.243e-6, rel=1e-4)
    found = peaks.sel(design="optimum").values
    assert found == pytest.approx(0.5 * np.abs(load / K - best), rel=1e-5)


@pytest.mark.parametrize(
    ("name", "printed"),
    [("pair", (2.712, 3.952, 5.157, 6.337)), ("relieved", (2.133, 0.917, 1.243, 2.284))],
)
def test_flexible_teeth(name, printed):
    data = solve_contact(load_model(FOLDER / f"{name}.yaml"), None, torque=TORQUES, positions=512)
    peaks = np.ptp(data["transmission_error"].values, axis=1)
    assert 1e6 * peaks == pytest.approx(printed, rel=5e-3)


def test_tolerances():
    """The worst of the drawing values: a plan whose bounds are these, and their start."""
    model = load_model(FOLDER / "relieved.yaml")
    vary = {
        TIP.format(gear, key): (value, value + 1e-9)
        for gear, values in (("pinion", (13.5e-6, 4.5e-3)), ("wheel", (13.5e-6, 4.2e-3)))
        for key, value in zip(("amount", "length"), values, strict=True)
    }
    tolerances = {TIP.format(gear, "amount"): 2e-6 for gear in ("pinion", "wheel")}
    given = ReliefPlan(vary=vary, torques=TORQUES, tolerances=tolerances, analyses=100)
    data = design_relief(model, None, given)
    worst = data["peak_to_peak_max"].sel(design="start").values
    assert 1e6 * worst == pytest.approx((2.84, 1.62, 1.94, 2.85), rel=5e-3)
