# SPDX-License-Identifier: Apache-2.0
"""Tolerance studies of models with closed forms of their variance and of their Sobol' indices.

Frequency of two inertias on a shaft, f = sqrt(k (1/J1 + 1/J2)) / 2 pi; twist of shafts in series, which is
linear in the torques; transmission error of a loaded pair, whose part j_bt / 2 follows the centre distance.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from tests.support.study_files import INERTIAS, SERIES, written

PRODUCT = """\
model: model.yaml
evaluate: modes
sampling: sobol
samples: {samples}
sensitivity: sobol_indices
factors:
  stiffness: {{type: lognormal, path: torsion_springs.shaft.stiffness, deviation: 0.6}}
  inertias:
    {{type: lognormal, paths: [bodies.one.inertia, bodies.two.inertia], deviation: 0.8, apply: multiply}}
results:
  frequency: {{channel: "undamped_frequency[2]"}}
"""
TWIST = """\
model: model.yaml
evaluate: equilibrium
sampling: {sampling}
samples: {samples}
{more}
factors:
  inner: {{type: normal, path: loads.inner.torque, deviation: 3 N m}}
  outer: {{type: tolerance, path: loads.outer.torque, limits: [-6 N m, 6 N m], capability: 1}}
results:
  twist: {{channel: "angle[two]"}}
"""


def frequency_study(folder: Path, samples: int) -> None:
    """Indices of f = C k^0.5 c^-0.5, both lognormal: of a product of independent factors X_i with mean 1,
    V = prod(1 + v_i) - 1, S_i = v_i / V, S_Ti = v_i prod(1 + v_j) / V, with v_i = exp(s_i^2) - 1 and
    s = 0.5 times the deviation of the logarithm.
    """
    data = pp.run_study(written(folder, PRODUCT.format(samples=samples), INERTIAS))
    v = np.exp(np.array([0.3, 0.4]) ** 2) - 1.0
    V = np.prod(1.0 + v) - 1.0
    first, total = v / V, v * (1.0 + v[::-1]) / V
    for name, exact in (("first_order_index", first), ("total_index", total)):
        found, low, high = (data[f"{name}{end}"].values[0] for end in ("", "_low", "_high"))
        assert np.all(np.abs(found - exact) <= high - low)  # four standard errors
    logarithm = np.log(data["result[frequency]"].values[data["group"].values < 2])
    assert logarithm.var() == pytest.approx(0.3**2 + 0.4**2, rel=6.0 / samples**0.75)
    exact = np.log(np.sqrt(5000.0 * (1.0 / 0.02 + 1.0 / 0.05)) / (2.0 * np.pi))
    assert float(np.log(data["nominal"].values[0])) == pytest.approx(exact, rel=1e-9)
    assert logarithm.mean() == pytest.approx(exact, abs=1.0 / samples**0.75)


def test_sobol_indices_of_a_natural_frequency(tmp_path: Path) -> None:
    frequency_study(tmp_path, 32)


@pytest.mark.study
def test_sobol_indices_of_a_natural_frequency_with_many_samples(tmp_path: Path) -> None:
    frequency_study(tmp_path, 256)


@pytest.mark.parametrize("sampling", ["latin_hypercube", "sobol"])
def test_variance_of_a_linear_model(tmp_path: Path, sampling: str) -> None:
    """Twist of the outer end (T1 + T2)/k1 + T2/k2: variance (s1/k1)^2 + (s2 (1/k1 + 1/k2))^2."""
    plan = TWIST.format(sampling=sampling, samples=64, more="")
    data = pp.run_study(written(tmp_path, plan, SERIES))
    parts = np.array([3.0 / 5000.0, 2.0 * (1.0 / 5000.0 + 1.0 / 2000.0)])
    deviation = float(np.hypot(*parts))
    assert float(data["nominal"][0]) == pytest.approx(50.0 / 5000.0 + 20.0 / 2000.0, rel=1e-9)
    assert float(data["mean"][0]) == pytest.approx(0.02, abs=0.02 * deviation)
    # the sample covariance of the two factors, which the sampling leaves, is of the order of 1/sqrt(64)
    assert float(data["standard_deviation"][0]) == pytest.approx(deviation, rel=0.05)
    assert float(data["standard_deviation_low"][0]) < deviation < float(data["standard_deviation_high"][0])
    assert float(data["determination"][0]) == pytest.approx(1.0, abs=1e-9)
    assert data["regression_coefficient"].values[0] == pytest.approx(parts / deviation, abs=0.08)
    assert data["variance_share"].values[0] == pytest.approx((parts / deviation) ** 2, abs=0.1)


def test_correlated_loads_add_their_deviations(tmp_path: Path) -> None:
    """With the correlation r: variance s1^2 + s2^2 + 2 r s1 s2 of the two parts."""
    more = "correlations: [{factors: [inner, outer], coefficient: 0.8}]"
    data = pp.run_study(written(tmp_path, TWIST.format(sampling="sobol", samples=64, more=more), SERIES))
    parts = np.array([3.0 / 5000.0, 2.0 * (1.0 / 5000.0 + 1.0 / 2000.0)])
    exact = np.sqrt(parts @ np.array([[1.0, 0.8], [0.8, 1.0]]) @ parts)
    assert float(data["standard_deviation"][0]) == pytest.approx(exact, rel=0.05)
    found = np.corrcoef(data["factor[inner]"], data["factor[outer]"])[0, 1]
    assert found == pytest.approx(0.8, abs=0.05)


PAIR = """\
gears:
  one: {{number_of_teeth: 25, normal_module: 4 mm, face_width: 20 mm, helix_angle: {beta}, hand: left,
    profile_shift_coefficient: 0.1, tooth_thickness_allowance: -60 um}}
  two: {{number_of_teeth: 40, normal_module: 4 mm, face_width: 20 mm, helix_angle: {beta}, hand: right,
    profile_shift_coefficient: 0.1, tooth_thickness_allowance: -60 um}}
bodies:
  first: {{gears: [one], motion: torsion, inertia: 0.01 kg m^2}}
  second: {{gears: [two], motion: torsion, inertia: 0.05 kg m^2}}
meshes:
  stage: {{gears: [one, two], center_distance: {distance}, stiffness: {{law: constant, value: 1e8 N/m}}}}
loads:
  drive: {{body: first, torque: 50 N m}}
  brake: {{body: second, torque: balance}}
"""
DISTANCE = """\
model: model.yaml
evaluate: equilibrium
sampling: sobol
samples: 16
factors:
  distance: {type: tolerance, path: meshes.stage.center_distance, limits: [-36 um, 36 um], capability: 1}
results:
  error: {channel: "transmission_error[stage]"}
"""


@pytest.mark.parametrize(("beta", "distance"), [("0 deg", "130.9 mm"), ("20 deg", "139.3 mm")])
def test_backlash_follows_the_centre_distance(tmp_path: Path, beta: str, distance: str) -> None:
    """A loaded flank is j_bt / 2 from the middle of the gap: with constant stiffness and torque the
    transmission error changes by d(j_bt / 2) = sin(alpha_wt) da. The curvature of the involute function adds
    the share da / (2 a tan(alpha_wt)^2), below 1e-3.
    """
    plan = written(tmp_path, DISTANCE, PAIR.format(beta=beta, distance=distance))
    data = pp.run_study(plan)
    pair = pp.load_model(tmp_path / "model.yaml").pairs["stage"]
    sample = float(data["factor[distance]"].std(ddof=1))
    assert float(data["standard_deviation"][0]) == pytest.approx(np.sin(pair.alpha_wt) * sample, rel=1e-3)
    assert float(data["determination"][0]) == pytest.approx(1.0, abs=1e-5)
