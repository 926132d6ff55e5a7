# SPDX-License-Identifier: Apache-2.0
"""Modifications as rows of numbers: equal to their definitions, with their exact minimum."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.modification_terms import cell_minima, lead_gap, modification_terms, profile_gap
from pitchpoint.geometry.modifications import (
    EndRelief,
    FlankModifications,
    Relief,
    base_tangent,
    deviation,
    flank_range,
)

GEARS = {
    "spur": CylindricalGear(z=50, m_n=3e-3, b=0.02),
    "helical": CylindricalGear(z=23, m_n=2e-3, beta=0.3, b=0.03),
    "internal": CylindricalGear(z=-80, m_n=3e-3, beta=-0.2, b=0.02),
}
MICRO = 1e-6


def some(seed: int, gear: CylindricalGear) -> FlankModifications:
    """Modifications of any sign and shape that fit the flank."""
    rng = np.random.default_rng(seed)
    flank = abs(np.subtract(*flank_range(gear)))
    shapes = ("linear", "parabolic")
    crown, lead, slope, helix = rng.uniform(-20.0, 20.0, 4) * MICRO
    low, high = sorted((abs(gear.d_Ff), abs(gear.d_Fa)))
    return FlankModifications(
        tip_relief=Relief(
            amount=rng.uniform(0.0, 40.0) * MICRO,
            start_diameter=low + rng.uniform(0.3, 0.9) * (high - low),
            shape=shapes[seed % 2],
        ),
        root_relief=Relief(
            amount=rng.uniform(0.0, 40.0) * MICRO,
            length=rng.uniform(0.1, 1.0) * flank,
            shape=shapes[seed // 2 % 2],
        ),
        end_relief=EndRelief(
            amount=rng.uniform(0.0, 20.0) * MICRO,
            length=rng.uniform(0.05, 0.5) * gear.b,
            shape=shapes[seed // 4 % 2],
        ),
        profile_crowning=crown,
        lead_crowning=lead,
        profile_slope=slope,
        helix_slope=helix,
    )


@pytest.mark.parametrize("name", GEARS)
@pytest.mark.parametrize("seed", range(8))
def test_sum_of_profile_and_lead_is_the_removed_material(name: str, seed: int) -> None:
    """Tolerance: rounding of amounts below 0.1 mm, 1e-15 of which is 1e-19 m; starts differ by 1e-15."""
    gear = GEARS[name]
    modifications = some(seed, gear)
    row = modification_terms(modifications, gear)
    t, zeta = np.linspace(0.0, 1.0, 301), np.linspace(-1.0, 1.0, 31)
    root, tip = flank_range(gear)
    removed = deviation(modifications, gear, root + t * (tip - root), 0.5 * gear.b * zeta[:, None])
    found = lead_gap(row, zeta)[:, None] + profile_gap(row, t)
    assert found == pytest.approx(base_tangent(removed, gear), abs=1e-18)


@pytest.mark.parametrize("name", GEARS)
@pytest.mark.parametrize("seed", range(8))
def test_minima_between_stations(name: str, seed: int) -> None:
    """Never above samples of the cell; a kink is at most half a step of 1/2000 from a sample."""
    gear = GEARS[name]
    row = modification_terms(some(seed, gear), gear)
    t, zeta = np.linspace(0.0, 1.0, 5), np.linspace(-1.0, 1.0, 4)
    profile, lead = cell_minima(row, t, zeta)
    for stations, found, gap in ((t, profile, profile_gap), (zeta, lead, lead_gap)):
        for a, b, least in zip(stations[:-1], stations[1:], found, strict=True):
            samples = gap(row, np.linspace(a, b, 2001))
            assert samples.min() >= least - 1e-18
            assert samples.min() == pytest.approx(least, abs=1e-3 * np.ptp(samples))


def test_no_modification_is_a_row_without_amounts() -> None:
    row = modification_terms(FlankModifications(), GEARS["spur"])
    assert not profile_gap(row, np.linspace(0.0, 1.0, 5)).any()
    assert not lead_gap(row, np.linspace(-1.0, 1.0, 5)).any()
