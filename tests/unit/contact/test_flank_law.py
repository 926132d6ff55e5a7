# SPDX-License-Identifier: Apache-2.0
"""The flank law: tangents against differences, energy against work, friction against Coulomb's law."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.flank_law import FLANK_LAW, flank_energy, flank_force, flank_friction

K, SOFT, LIMIT = 3e8, 2e-9, 900.0
X = 4e-6
"""Penetration [m]: inside the ramp of the damping and, with LIMIT, above and below the low-load limit."""


def law_of(**values: float) -> np.void:
    """Record of a law with every loss switched on, changed by `values`."""
    law = np.zeros(1, FLANK_LAW)[0]
    given = {"power": 1.0, "k_ref": 4e8, "d_in": 2e3, "d_out": 1e3, "s_0": 1e-5, "smooth": 1}
    friction = {"mu": 0.08, "v_eps": 0.02, "mu_s": 0.1, "v_s": 0.01, "normal": 1.0 / math.cos(0.3)}
    for name, value in (given | friction | values).items():
        law[name] = value
    return law


LAWS = {
    "smooth ramp": (law_of(), 0.0),
    "linear ramp": (law_of(smooth=0), 0.0),
    "restitution": (law_of(chi=5.0), 0.0),
    "Hertz": (law_of(power=1.5, k_ref=1e11), 0.0),
    "low load": (law_of(), 2000.0),
    "undamped": (law_of(d_in=0.0, d_out=0.0), LIMIT),
}


def stiffness_of(law: np.void) -> float:
    """Stiffness that gives forces around 1 kN at X."""
    return K if law["power"] == 1.0 else K / math.sqrt(X)


@pytest.mark.parametrize("soft", [None, SOFT])
@pytest.mark.parametrize("w", [0.05, -0.05])
@pytest.mark.parametrize("name", LAWS)
def test_tangents_are_the_derivatives_of_the_force(name: str, w: float, soft: float | None) -> None:
    law, limit = LAWS[name]
    k = stiffness_of(law)

    def force(x: float, rate: float) -> tuple[float, ...]:
        return flank_force(law, x, k, limit, rate, soft)

    f, by_x, by_w, elastic, stiffness, _, reach = force(X, w)
    h = 1e-4 * X
    assert f > 0.0
    above, below = force(X + h, w), force(X - h, w)
    assert by_x == pytest.approx((above[0] - below[0]) / (2.0 * h), rel=1e-7)
    assert stiffness == pytest.approx((above[3] - below[3]) / (2.0 * h), rel=1e-7)
    step = 1e-3 * abs(w)
    slope = (force(X, w + step)[0] - force(X, w - step)[0]) / (2.0 * step)
    assert by_w == pytest.approx(slope, rel=1e-7, abs=1e-9)
    if limit == 0.0:
        assert reach == pytest.approx(X * f / elastic, rel=1e-12)


@pytest.mark.parametrize("soft", [None, SOFT])
@pytest.mark.parametrize("name", LAWS)
def test_energy_is_the_work_of_the_elastic_force(name: str, soft: float | None) -> None:
    law, limit = LAWS[name]
    k = stiffness_of(law)
    q = 0.0 if soft is None else soft

    def energy(x: float, k: float, q: float) -> float:
        compliance = None if soft is None else q
        u = flank_force(law, x, k, limit, 0.0, compliance)[5]
        return flank_energy(law, x, u, k, limit, compliance)[0]

    _, _, _, elastic, _, u, _ = flank_force(law, X, k, limit, 0.0, soft)
    _, by_k, by_soft = flank_energy(law, X, u, k, limit, soft)
    for derivative, at, step in ((elastic, 0, X), (by_k, 1, k), (by_soft, 2, q)):
        if step == 0.0:
            assert derivative == 0.0
            continue
        ends = []
        for side in (1.0, -1.0):
            place = [X, k, q]
            place[at] += 1e-4 * side * step
            ends.append(energy(*place))
        assert derivative == pytest.approx((ends[0] - ends[1]) / (2e-4 * step), rel=1e-6)


@pytest.mark.parametrize("power", [1.0, 1.5])
def test_contact_and_added_compliance_are_in_series(power: float) -> None:
    law = law_of(power=power)
    k = stiffness_of(law)
    _, _, _, elastic, _, u, _ = flank_force(law, X, k, 0.0, 0.0, SOFT)
    assert elastic == pytest.approx(k * u**power, rel=1e-13)
    assert u + SOFT * elastic == pytest.approx(X, rel=1e-13)


def test_flanks_never_pull() -> None:
    law = law_of(s_0=0.0)
    # the damper of 1e3 * K/k_ref N s/m outweighs the spring from this speed on
    fast = K * X / (1e3 * K / 4e8)
    assert flank_force(law, X, K, 0.0, -1.001 * fast, None)[0] == 0.0
    assert flank_force(law, X, K, 0.0, -0.999 * fast, None)[0] == pytest.approx(1e-3 * K * X, rel=1e-6)
    assert flank_force(law, X, K, 0.0, -1.001 * fast, None)[6] == pytest.approx(-1e-3 * X, rel=1e-6)


def test_friction_is_that_of_coulomb_beyond_its_smoothing() -> None:
    law = law_of()
    for v in (0.02, 0.5):
        force, by_f, by_v = flank_friction(law, 1000.0, v)
        assert force == pytest.approx(0.08 * 1000.0 / math.cos(0.3), rel=1e-12)
        assert by_f == pytest.approx(force / 1000.0, rel=1e-12)
        assert by_v == 0.0
        assert flank_friction(law, 1000.0, -v)[0] == -force
    assert flank_friction(law, 1000.0, 0.01)[0] == pytest.approx(100.0 / math.cos(0.3), rel=1e-12)
    h = 1e-6
    slope = (flank_friction(law, 1000.0, 0.004 + h)[0] - flank_friction(law, 1000.0, 0.004 - h)[0]) / (2 * h)
    assert flank_friction(law, 1000.0, 0.004)[2] == pytest.approx(slope, rel=1e-6)
