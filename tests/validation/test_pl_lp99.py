# SPDX-License-Identifier: Apache-2.0
"""PL-LP99: planar planetary sets with three to five planets, and four at unequal angles, as planetary stages.

J. Lin, R. G. Parker, Analytical characterization of the unique properties of planetary gear free vibration,
J. Vib. Acoust. 121 (1999) 316, numbers of cases.md. Coordinates there are x, y and u = base radius times
angle in axes that go with the carrier; ours are those of the joints, planets on the carrier, which changes
no frequency at rest. Inertias are drawn out as I/r^2 with the base radii of the gears, so that any teeth do
that fit for three, four and five planets: 52 + 188 = 240. The small torque of modes without load presses a
planet on the front of one mesh and the back of the other.

Planet modes do not depend on the number of planets. For pairs of opposite planets at unequal angles (J. Lin,
R. G. Parker, Structured vibration characteristics of planetary gears with unequally spaced planets, J. Sound
Vib. 233 (2000) 921), rotational and planet modes are those of equal angles: their planets move alike, or
against each other, in radial and tangential directions. The frequencies of translational modes differ.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model

ROTATIONAL = {
    3: [1475.7, 1930.3, 2658.3, 7462.8, 11775.3],
    4: [1536.6, 1970.6, 2625.7, 7773.6, 13071.1],
}
TRANSLATIONAL = {
    3: [743.2, 1102.4, 1896.0, 2276.4, 6986.3, 9647.9],
    4: [727.0, 1091.0, 1892.8, 2342.5, 7189.9, 10437.6],
}
PLANET = [1808.2, 5963.8, 6981.7]
TEETH = (
    "normal_module: 1.5 mm, face_width: 20 mm, normal_pressure_angle: 24.6 deg, profile_shift_coefficient: 0"
)
MESH = "{stiffness: {law: constant, value: 5e8 N/m}}"


def machine(places: str) -> str:
    """Model file of the published set; `places` is the number of planets, or their angles."""
    arm = 90e-3
    cosine = math.cos(math.radians(24.6))
    sun, ring, planet = (0.5 * 1.5e-3 * z * cosine for z in (52, 188, 68))
    return f"""
gears:
  sun: {{number_of_teeth: 52, {TEETH}}}
  ring: {{number_of_teeth: 188, {TEETH}, type: internal}}
bodies:
  sun: {{gears: [sun], motion: planar, mass: 0.4 kg, inertia: {0.39 * sun**2!r}, position: [0, 0, 0]}}
  ring: {{gears: [ring], motion: planar, mass: 2.35 kg, inertia: {3.00 * ring**2!r}}}
  carrier: {{motion: planar, mass: 5.43 kg, inertia: {6.29 * arm**2!r}}}
bearings:
  sun: {{body: sun, stiffness: {{radial: 1e8 N/m}}}}
  carrier: {{body: carrier, stiffness: {{radial: 1e8 N/m}}}}
  ring: {{body: ring, stiffness: {{radial: 1e8 N/m, torsion: {1e9 * ring**2!r}}}}}
planetary_stages:
  set:
    sun: sun
    ring: ring
    carrier: carrier
    {places}
    planet: {{number_of_teeth: 68, {TEETH}}}
    planet_mass: 0.66 kg
    planet_inertia: {0.61 * planet**2!r}
    motion: planar
    bearing: {{stiffness: {{radial: 1e8 N/m}}}}
    sun_mesh: {MESH}
    ring_mesh: {MESH}
"""


def by_kind(places):
    """Frequencies [Hz] of the modes of each kind, and their total number; without the rigid one."""
    found = find_modes(compile_model(loads_model(machine(places))))
    assert found.frequency[0] == 0.0
    kinds = {kind: [] for kind in ("rotational", "translational", "planet")}
    for frequency, name in zip(found.frequency[1:], found.names[1:], strict=True):
        # a mode of the carrier on its own bearing has its name from there
        words = name.replace("translation of carrier", "translational mode of planetary stage set")
        (kind,) = [kind for kind in kinds if f"{kind} mode of planetary stage set" in words]
        kinds[kind].append(float(frequency))
    return kinds


@pytest.mark.parametrize("n", [3, 4])
def test_all_frequencies_and_kinds(n):
    """Once, twice and n - 3 times; 5e-4: published digits are rounded and some data to three of them."""
    found = by_kind(f"planets: {n}")
    assert found["rotational"] == pytest.approx(ROTATIONAL[n], rel=5e-4)
    assert found["translational"] == pytest.approx(np.repeat(TRANSLATIONAL[n], 2), rel=5e-4)
    assert found["translational"][::2] == pytest.approx(found["translational"][1::2], rel=1e-8)
    assert found["planet"] == pytest.approx(PLANET * (n - 3), rel=5e-4)


def test_planet_modes_of_five_planets():
    """Twice each, at the frequencies of four planets."""
    found = by_kind("planets: 5")
    assert {kind: len(values) for kind, values in found.items()} == {
        "rotational": 5,
        "translational": 12,
        "planet": 6,
    }
    assert found["planet"] == pytest.approx(np.repeat(PLANET, 2), rel=5e-4)


def test_opposite_pairs_at_unequal_angles():
    """Planets at 0, 81, 180 and 261 deg: every translational frequency is split."""
    found = by_kind("angles: [0 deg, 81 deg, 180 deg, 261 deg]")
    assert found["rotational"] == pytest.approx(ROTATIONAL[4], rel=5e-4)
    assert found["planet"] == pytest.approx(PLANET, rel=5e-4)
    pairs = np.reshape(found["translational"], (6, 2))
    assert np.all(pairs[:, 1] / pairs[:, 0] > 1.005)
    # both are near the double frequency of equal angles
    assert pairs.mean(axis=1) == pytest.approx(TRANSLATIONAL[4], rel=5e-3)
