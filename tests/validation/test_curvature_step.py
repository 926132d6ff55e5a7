# SPDX-License-Identifier: Apache-2.0
"""FC-13: step of curvature at the contact centre, and the pressure of any piecewise parabolic gap.

Published by an open gear contact program: the sum of curvatures 2.08 per mm rises by 10 per mm at the contact
centre (tip rounding of 0.1 mm), 100 N/mm, steel: p_max 4855 MPa, Hertz with the larger curvature 6597 MPa.
Tolerance 0.2 %.

Independent: the integral equation of the half-plane in closed form (K. L. Johnson, Contact Mechanics (1985),
2.7), contact from m - l to m + l: ∫ h' /√ = 0, ∫ t h'/√ dt = 2 q/E*, p(x) = E*/(2π) √ ∫ h'(t)/(√ (t - x)) dt,
by Gauss-Chebyshev quadrature. It needs one interval of contact; strips do not.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import fsolve

from pitchpoint.contact.hertz import half_width, peak_pressure, plane_strain_compliance
from pitchpoint.contact.strip_pressure import stepped_pressure, strip_pressure
from pitchpoint.core.errors import GeometryError, SolverError

STEEL = 2.0 * plane_strain_compliance(206e9, 0.3)
Q = 1e5
POINTS = 4000


def slope(t, curvature, steps):
    found = curvature * t
    for place, more in steps:
        found = found + more * (
            np.maximum(t - place, 0.0) if math.copysign(1.0, place) > 0.0 else np.minimum(t - place, 0.0)
        )
    return found


def closed_form(x, curvature, steps):
    """Pressure at x, and the ends of contact."""
    cosine = np.cos((np.arange(POINTS) + 0.5) * math.pi / POINTS)

    def unbalanced(v):
        t = v[0] + v[1] * cosine
        h = slope(t, curvature, steps)
        return [h.mean() / abs(h).mean(), (h * t).mean() * math.pi / (2.0 * Q * STEEL) - 1.0]

    b = math.sqrt(4.0 * Q * STEEL / (math.pi * curvature))
    middle, half = fsolve(unbalanced, [-0.1 * b, 0.8 * b], xtol=1e-12)
    t = middle + half * cosine
    h = slope(t, curvature, steps)
    inside = np.abs(x - middle) < half
    p = np.zeros(x.size)
    for k in np.flatnonzero(inside):
        root = math.sqrt(half**2 - (x[k] - middle) ** 2)
        # the principal value of 1/(√ (t - x)) is zero
        p[k] = root / (2.0 * STEEL) * np.mean((h - slope(x[k], curvature, steps)) / (t - x[k]))
    return p, middle - half, middle + half


def test_step_at_the_contact_centre():
    found = stepped_pressure(2080.0, [(0.0, 1e4)], Q, STEEL)
    assert found.maximum * 1e-6 == pytest.approx(4855.0, rel=2e-3)
    one = plane_strain_compliance(206e9, 0.3)
    hertz = peak_pressure(Q, half_width(Q, 1.0 / 12080.0, one, one)) * 1e-6
    assert float(hertz) == pytest.approx(6597.0, rel=2e-3)


@pytest.mark.parametrize(
    "steps",
    [
        [(0.0, 1e4)],
        [(-0.0, 1e4)],
        [(4e-6, 1e4)],
        [(-10e-6, 3e3)],
        [(0.0, 600.0)],
        [(5e-6, 2e3), (-8e-6, 4e3)],
        [(2e-6, -800.0)],
    ],
)
def test_closed_form_of_the_half_plane(steps):
    """Strips follow it to a strip near the ends, where the pressure has a root."""
    found = stepped_pressure(2080.0, steps, Q, STEEL)
    p, low, high = closed_form(found.x, 2080.0, steps)
    width = found.x[1] - found.x[0]
    assert np.sum(found.pressure) * width == pytest.approx(Q, rel=1e-12)
    inner = (found.x > low + 2.0 * width) & (found.x < high - 2.0 * width)
    assert found.pressure[inner] == pytest.approx(p[inner], abs=0.01 * p.max())
    assert found.maximum == pytest.approx(p.max(), rel=2e-3)
    touching = found.x[found.pressure > 0.0]
    assert (touching.min(), touching.max()) == pytest.approx((low, high), abs=1.5 * width)


def test_without_steps_it_is_hertz():
    b = math.sqrt(4.0 * Q * STEEL / (math.pi * 2080.0))
    found = stepped_pressure(2080.0, [], Q, STEEL)
    assert found.maximum == pytest.approx(2.0 * Q / (math.pi * b), rel=1e-4)


def test_two_intervals_of_contact():
    """Two equal ridges 0.2 mm apart carry half of the load each, nearly as alone."""
    x = (np.arange(600) - 299.5) * 1e-6
    gap = np.minimum((x - 1e-4) ** 2, (x + 1e-4) ** 2) * 0.5 * 12000.0
    found = strip_pressure(x, gap, Q, STEEL)
    left = found.x < 0.0
    assert np.sum(found.pressure[left]) * 1e-6 == pytest.approx(0.5 * Q, rel=1e-9)
    assert not found.pressure[np.abs(x) < 5e-5].any()
    alone = stepped_pressure(12000.0, [], 0.5 * Q, STEEL).maximum
    assert found.maximum == pytest.approx(alone, rel=0.02)


def test_what_it_refuses():
    with pytest.raises(GeometryError, match="is not convex"):
        stepped_pressure(2080.0, [(1e-6, -3e3)], Q, STEEL)
    x = np.linspace(-1e-5, 1e-5, 21)
    reason = r"0.021 mm is too small for the contact \(limit wider than the contact\); extend it"
    with pytest.raises(GeometryError, match=reason):
        strip_pressure(x, 0.5 * 2080.0 * x**2, Q, STEEL)


def test_steps_on_one_side_add_up():
    """Two reliefs that end at the same place, as tip relief of one flank and root relief of its mate: their
    sum is one step. The range is that of the curvature beyond both."""
    together = stepped_pressure(42000.0, [(5e-6, -40000.0)], Q, STEEL)
    apart = stepped_pressure(42000.0, [(5e-6, -20000.0)] * 2, Q, STEEL)
    assert apart.x == pytest.approx(together.x, rel=1e-12)
    assert apart.pressure == pytest.approx(together.pressure, rel=1e-9, abs=1e-9 * Q)


def test_strips_that_do_not_settle_are_reported(monkeypatch):
    monkeypatch.setattr("pitchpoint.contact.strip_pressure._STEPS", 1)
    with pytest.raises(SolverError, match="still change after 1 steps"):
        stepped_pressure(2080.0, [(0.0, 1e4)], Q, STEEL)
