# SPDX-License-Identifier: Apache-2.0
"""Laws of the normal force and friction: numbers of SEED-SHOVEL, restitution over its range, tangents."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from pitchpoint.contact.friction import friction_per_speed, static_dynamic
from pitchpoint.contact.impact import (
    CONTACT_LAW,
    elastic_energy,
    elastic_force,
    normal_force,
    restitution_factor,
    set_friction,
    set_impact,
    set_restitution,
)

pytestmark = pytest.mark.nojit

LAW = np.dtype(CONTACT_LAW)


def shovel(stage=0):
    """Stage of the crawler gearbox of SEED-SHOVEL: Table 4, exponent 1.5, C = 1000 N s/mm, d = 0.1 mm."""
    record = np.zeros((), LAW)
    set_impact(record, (6.824e5, 8.102e5, 10.941e5)[stage] * 1e3**1.5, 1.5, 1e6, 1e-4)
    return record[()]


def test_penetration_at_rated_torque():
    """22.888, 115.869 and 382.017 kN press the flanks 0.1040, 0.2735 and 0.4959 mm into each other."""
    for stage, (force, depth) in enumerate(((22.888e3, 0.1040), (115.869e3, 0.2735), (382.017e3, 0.4959))):
        record = shovel(stage)
        delta = (force / float(record["k"])) ** (1.0 / 1.5)
        assert delta == pytest.approx(depth * 1e-3, abs=5e-8)  # printed to 4 digits
        assert elastic_force(record, delta)[0] == pytest.approx(force, rel=1e-12)


def test_the_step_is_normalised():
    """Half of the damping at d/2, all of it from d on (not 0.028 just before a jump at d = 0.1 mm)."""
    record = shovel()
    for delta, share in ((0.5e-4, 0.5), (0.9999e-4, 1.0), (1e-4, 1.0), (3e-4, 1.0)):
        found = normal_force(record, delta, 1e-3)[0] - elastic_force(record, delta)[0]
        assert found == pytest.approx(share * 1e3, rel=1e-6)


def test_damping_opposes_the_motion_and_never_pulls():
    record = shovel()
    still = normal_force(record, 2e-4, 0.0)[0]
    assert normal_force(record, 2e-4, 0.01)[0] > still > normal_force(record, 2e-4, -0.01)[0] > 0.0
    assert normal_force(record, 2e-4, -10.0)[:3] == (0.0, 0.0, 0.0)
    assert normal_force(record, -1e-9, 10.0) == (0.0, 0.0, 0.0, 0.0)


def test_friction_of_the_crawler_gearbox():
    """0.1 at 1 mm/s, 0.08 at 10 mm/s; half way 0.09 by the cubic step; 0.6875 of 0.1 at half the slip."""
    for v, mu in ((0.0, 0.0), (0.5e-3, 0.06875), (1e-3, 0.1), (5.5e-3, 0.09), (10e-3, 0.08), (1.0, 0.08)):
        assert static_dynamic(v, 0.1, 0.08, 1e-3, 10e-3)[0] == pytest.approx(mu, rel=1e-12)
        assert static_dynamic(-v, 0.1, 0.08, 1e-3, 10e-3)[0] == pytest.approx(-mu, rel=1e-12)
        c, _ = friction_per_speed(v, 0.1, 0.08, 1e-3, 10e-3)
        assert c * v == pytest.approx(mu, rel=1e-12)


@pytest.mark.parametrize("v", [1e-5, 0.4e-3, 0.999e-3, 3e-3, 9e-3, 0.5])
def test_friction_slopes(v):
    law = (0.1, 0.08, 1e-3, 10e-3)
    h = 1e-9
    slope = (static_dynamic(v + h, *law)[0] - static_dynamic(v - h, *law)[0]) / (2 * h)
    assert static_dynamic(v, *law)[1] == pytest.approx(slope, rel=1e-5, abs=1e-6)
    over = (friction_per_speed(v + h, *law)[0] - friction_per_speed(v - h, *law)[0]) / (2 * h)
    assert friction_per_speed(v, *law)[1] * v == pytest.approx(over, rel=2e-4, abs=1e-3)


def laws():
    found = {}
    for name in ("impact", "hunt_crossley", "hysteresis"):
        record = np.zeros((), LAW)
        if name == "impact":
            set_impact(record, 1e9, 1.5, 2e5, 1e-4)
        else:
            set_restitution(record, 1e9, 0.6, 0.5, 1.5, name == "hysteresis")
        found[name] = record[()]
    return found


@pytest.mark.parametrize("name", ["impact", "hunt_crossley", "hysteresis"])
@pytest.mark.parametrize("rate", [-0.2, -0.05, 0.1])
def test_slopes_and_energy_of_the_laws(name, rate):
    record = laws()[name]
    delta, h = 0.7e-4, 1e-9
    force, by_delta, by_rate, loss = normal_force(record, delta, rate)
    ends = [normal_force(record, delta + s * h, rate)[0] for s in (1, -1)]
    assert by_delta == pytest.approx((ends[0] - ends[1]) / (2 * h), rel=1e-6)
    ends = [normal_force(record, delta, rate + s * h)[0] for s in (1, -1)]
    assert by_rate == pytest.approx((ends[0] - ends[1]) / (2 * h), rel=1e-5, abs=1e-3)
    energy = (elastic_energy(record, delta + h) - elastic_energy(record, delta - h)) / (2 * h)
    assert force * rate == pytest.approx(energy * rate + loss, abs=1e-6 * abs(energy * rate))
    assert loss >= 0.0


def rebound(record, speed, mass=0.3):
    """Speed at which a body leaves over the one at which it comes, by another integrator."""

    def slope(t, y):
        return [y[1], -normal_force(record, y[0], y[1])[0] / mass]

    def apart(t, y):
        return y[0]

    apart.terminal, apart.direction = True, -1
    depth = (1.25 * mass * speed**2 / float(record["k"])) ** 0.4
    done = solve_ivp(
        slope,
        (0.0, 1.0),
        [1e-12, speed],
        "LSODA",
        rtol=1e-10,
        atol=1e-14,
        events=apart,
        max_step=depth / speed / 10,
    )
    return -done.y[1, -1] / speed


@pytest.mark.parametrize("e", [0.05, 0.2, 0.5, 0.8, 0.95, 1.0])
def test_a_ball_bounces_with_the_asked_coefficient(e):
    """Hunt-Crossley with the exact factor: what is left is the error of the integration, 1e-8."""
    record = np.zeros((), LAW)
    set_restitution(record, 1e9, e, 0.5)
    assert rebound(record[()], 0.5) == pytest.approx(e, abs=1e-6)
    set_restitution(record, 1e7, e, 2.0, power=1.0)  # any mass, stiffness and exponent
    record["k"] = 1e6
    assert rebound(record[()], 2.0, 5.0) == pytest.approx(e, abs=1e-6)


def restitution_at(x, speed_ratio):
    """Coefficient e of a Hunt-Crossley contact at another speed than that of its factor.

    With y = x speed_ratio the law integrates to y (1 + e) = ln((1 + y)/(1 - y e)).
    """
    y = x * speed_ratio
    return brentq(
        lambda e: y * (1.0 + e) - np.log1p(y) + np.log1p(-y * e), 0.0, min(1.0, (1.0 - 1e-15) / y), xtol=1e-14
    )


@pytest.mark.parametrize("speed", [0.02, 0.1, 2.0])
def test_restitution_at_other_speeds(speed):
    record = np.zeros((), LAW)
    set_restitution(record, 1e9, 0.6, 0.5)
    assert rebound(record[()], speed) == pytest.approx(
        restitution_at(restitution_factor(0.6), speed / 0.5), abs=1e-6
    )


@pytest.mark.parametrize("e", [0.1, 0.5, 0.9])
@pytest.mark.parametrize("speed", [0.1, 1.0, 5.0])
def test_hysteresis_keeps_its_coefficient_at_every_speed(e, speed):
    """The transition lasts until the way out has the speed v; its work is of the order of (v/speed)^2."""
    record = np.zeros((), LAW)
    set_restitution(record, 1e9, e, 1e-3, every_speed=True)
    assert rebound(record[()], speed) == pytest.approx(e, abs=1e-6 + 2.0 * (1e-3 / speed) ** 2 / e)


def test_factors_of_the_literature_are_approximations():
    """At e = 0.5 Lankarani-Nikravesh gives back 0.725 and Flores 0.470; at 0.99 both are close."""
    for e, lankarani, flores in ((0.5, 0.725, 0.470), (0.99, 0.990, 0.989)):
        assert restitution_at(0.75 * (1 - e * e), 1.0) == pytest.approx(lankarani, abs=6e-4)
        assert restitution_at(1.6 * (1 - e) / e, 1.0) == pytest.approx(flores, abs=6e-4)
    assert restitution_factor(1.0 - 1e-6) == pytest.approx(1.5e-6, rel=1e-5)


def test_numbers_that_no_contact_has():
    record = np.zeros((), LAW)
    for e in (0.0, -0.1, 1.1, float("nan")):
        with pytest.raises(ValueError, match="restitution"):
            set_restitution(record, 1e9, e, 1.0)
    with pytest.raises(ValueError, match="speed"):
        set_restitution(record, 1e9, 0.5, 0.0)
    with pytest.raises(ValueError, match="friction"):
        set_friction(record, 0.1, 0.08, 1e-2, 1e-3)
