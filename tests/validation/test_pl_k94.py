# SPDX-License-Identifier: Apache-2.0
"""PL-K94: torsional planetary set with a fixed ring, as a planetary stage, in closed form.

A. Kahraman, Natural modes of planetary gear trains, J. Sound Vib. 173 (1994), numbers of cases.md: three
planets, base radii of sun and planet 0.5 m, carrier arm 1 m, inertias 4 (carrier), 0.5 (sun), 0.75 kg m^2
(planet), meshes 7 (sun) and 11 N/m (ring). His angles are absolute, ours are those of the planets on the
carrier; frequencies do not care. Springs act along base tangents, along which the arm a of the carrier is
a cos(alpha), the sum of the base radii for any pressure angle. The published four digits are those of the
closed form, here written out with all digits.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from tests.support.engine import frequencies

K_SUN, K_RING, ARM, BASE = 7.0, 11.0, 1.0, 0.5
CARRIER, SUN, PLANET = 4.0, 0.5, 0.75
PUBLISHED = [0.0, 0.38984840, 0.38984840, 0.50872897, 0.70788679]


def closed_form():
    """Own matrices: absolute angles of carrier, sun, planets; deflections of all six springs."""
    M = np.diag([CARRIER, SUN, PLANET, PLANET, PLANET])
    K = np.zeros((5, 5))
    for n in range(3):
        sun, ring = np.zeros(5), np.zeros(5)
        sun[[0, 1, 2 + n]] = -ARM, BASE, BASE
        ring[[0, 2 + n]] = -ARM, -BASE
        K += K_SUN * np.outer(sun, sun) + K_RING * np.outer(ring, ring)
    return frequencies(M, K)


def test_the_closed_form_has_the_published_numbers():
    np.testing.assert_allclose(closed_form(), PUBLISHED, atol=1e-8)


@pytest.mark.parametrize("alpha", [14.5, 24.6])
def test_frequencies_of_the_stage(alpha):
    """Published digits."""
    module = 2.0 * BASE / (42 * math.cos(math.radians(alpha)))
    teeth = (
        f"normal_module: {module!r} m, normal_pressure_angle: {alpha} deg, face_width: 100 mm, "
        "profile_shift_coefficient: 0"
    )
    text = f"""
gears:
  sun: {{number_of_teeth: 42, {teeth}}}
  ring: {{number_of_teeth: 126, {teeth}, type: internal, tip_diameter: {module * 125!r} m}}
bodies:
  sun: {{gears: [sun], inertia: {SUN}, position: [0, 0, 0]}}
  ring: {{gears: [ring], motion: fixed}}
  carrier: {{inertia: {CARRIER}}}
planetary_stages:
  set:
    sun: sun
    ring: ring
    carrier: carrier
    planets: 3
    planet: {{number_of_teeth: 42, {teeth}}}
    planet_mass: 0
    planet_inertia: {PLANET}
    sun_mesh: {{stiffness: {{law: constant, value: {K_SUN} N/m}}}}
    ring_mesh: {{stiffness: {{law: constant, value: {K_RING} N/m}}}}
"""
    found = find_modes(compile_model(loads_model(text)))
    assert found.frequency == pytest.approx(PUBLISHED, abs=2e-8)
    assert [name.partition(" mode")[0].split(" ")[-1] for name in found.names[1:]] == [
        "planet",
        "planet",
        "rotational",
        "rotational",
    ]
