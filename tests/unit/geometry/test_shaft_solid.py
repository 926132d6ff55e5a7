# SPDX-License-Identifier: Apache-2.0
"""Stepped, hollow shafts: closed form, outline and triangles against integrals of their own."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.shaft_solid import shaft_mass_properties, shaft_outline, shaft_solid
from pitchpoint.geometry.solid_mass import round_inertia, solid_of_triangles

STEPPED = [(0.1, 0.04, 0.0), (0.05, 0.06, 0.01), (0.05, 0.06, 0.02), (0.1, 0.04, 0.02)]
CLOSED_CAVITY = [(0.05, 0.04, 0.0), (0.05, 0.04, 0.01), (0.05, 0.04, 0.0)]
SHAFTS = {"stepped": STEPPED, "cavity": CLOSED_CAVITY, "rod": [(0.3, 0.02, 0.0)], "tube": [(0.3, 0.02, 0.01)]}


@pytest.mark.parametrize("sections", SHAFTS.values(), ids=SHAFTS)
def test_mass_is_the_integral_over_thin_discs(sections):
    """Discs of thickness dz: dm, z dm and the two moments, integrated with Gauss points."""
    nodes, weights = np.polynomial.legendre.leggauss(4)
    total, start = np.zeros(4), 0.0
    for length, outer, bore in sections:
        z = start + 0.5 * length * (1.0 + nodes)
        w = 0.5 * length * weights * 7800.0 * math.pi / 4.0 * (outer**2 - bore**2)
        second = (outer**2 + bore**2) / 16.0
        total += [w.sum(), (w * z).sum(), (w * 2.0 * second).sum(), (w * (second + z * z)).sum()]
        start += length
    found = shaft_mass_properties(sections, 7800.0)
    mass, moment, polar, across = total
    assert found.mass == pytest.approx(mass, rel=1e-12)
    assert found.center == pytest.approx(moment / mass, rel=1e-12)
    assert found.polar_inertia == pytest.approx(polar, rel=1e-12)
    # the difference of two numbers of the size of `across`
    assert found.transverse_inertia == pytest.approx(across - moment**2 / mass, rel=1e-11)


@pytest.mark.parametrize("sections", SHAFTS.values(), ids=SHAFTS)
def test_triangles_lack_what_the_polygon_lacks(sections):
    n = 48
    exact = shaft_mass_properties(sections, 1.0)
    solid = solid_of_triangles(shaft_solid(sections, n))
    found = round_inertia(solid, (0.0, 0.0, 1.0))
    area = 0.5 * n / math.pi * math.sin(2.0 * math.pi / n)
    polar = area * (2.0 + math.cos(2.0 * math.pi / n)) / 3.0
    assert solid.volume == pytest.approx(area * exact.mass, rel=1e-12)
    assert solid.center == pytest.approx((0.0, 0.0, exact.center), abs=1e-15)
    assert found.polar == pytest.approx(polar * exact.polar_inertia, rel=1e-12)
    along = exact.transverse_inertia - 0.5 * exact.polar_inertia
    assert found.transverse == pytest.approx(0.5 * polar * exact.polar_inertia + area * along, rel=1e-11)


def test_outline_goes_once_round_without_needless_corners():
    joined = [(0.1, 0.04, 0.0), (0.1, 0.04, 0.0), (0.1, 0.06, 0.0)]
    assert shaft_outline(joined) == shaft_outline([(0.2, 0.04, 0.0), (0.1, 0.06, 0.0)])


@pytest.mark.parametrize(
    "sections, said",
    [
        ([], "has no sections"),
        ([(0.1, 0.04, 0.04)], "sections.0: length 0.1 m, diameter 0.04 m, bore 0.04 m is not a piece"),
        ([(0.1, 0.04, 0.0), (0.1, 0.08, 0.05)], "does not touch the preceding section"),
        ([(math.nan, 0.04, 0.0)], "is not a piece of a shaft"),
    ],
)
def test_what_is_no_shaft_is_refused(sections, said):
    with pytest.raises(GeometryError, match=said):
        shaft_mass_properties(sections, 1.0)


def test_a_circle_has_three_corners_at_least():
    with pytest.raises(GeometryError, match="n_round: 2 corners are too few"):
        shaft_solid(STEPPED, 2)
