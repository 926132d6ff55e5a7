# SPDX-License-Identifier: Apache-2.0
"""The example `misaligned-helical`: face load factor, pressure and pattern, with and without crowning."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.analysis.flank_contact.load_factors import load_over_width
from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.contact_analysis.levels import compare_levels
from pitchpoint.solvers.contact_analysis.solve import solve_contact

FOLDER = Path(__file__).parents[2] / "examples" / "misaligned-helical"
NUMBERS = {
    ("plain", 0.0): (1.01, 1.33, 1005e6, 0.99e-6),
    ("plain", 40e-6): (3.07, 2.41, 1393e6, 1.72e-6),
    ("crowned", 0.0): (1.58, 1.65, 1165e6, 0.21e-6),
    ("crowned", 40e-6): (1.88, 1.57, 1319e6, 1.03e-6),
}
LEVELS = {
    "rigid": (24.81e-6, 0.8587e-6, 1.396, 1066e6, 0.030),
    "flexible": (25.63e-6, 0.9510e-6, 1.493, 1224e6, 0.0),
    "precomputed": (25.63e-6, 0.9534e-6, 1.493, 1224e6, 0.00021),
    "law": (25.18e-6, 0.7268e-6, None, None, 0.014),
}
KEYS = ("face_load_factor", "line_load_ratio", "flank_pressure", "transmission_error_pp")
B = 40e-3


@pytest.fixture(scope="module")
def analyses():
    models = {name: load_model(FOLDER / f"{name}.yaml") for name in ("plain", "crowned")}
    return {
        (name, gap): solve_contact(models[name], torque=400.0, positions=32, misalignment=gap / B)
        for name, gap in NUMBERS
    }


@pytest.mark.parametrize("case", NUMBERS)
def test_numbers_of_the_page(analyses, case):
    found = contact_numbers(analyses[case])
    # the last digit of the page
    for key, expected, digit in zip(KEYS, NUMBERS[case], (5.1e-3, 5.1e-3, 0.51e6, 5.1e-9), strict=True):
        assert found[key][0] == pytest.approx(expected, abs=digit), key


@pytest.mark.parametrize("case", NUMBERS)
def test_loads_are_in_equilibrium_with_the_torque(analyses, case):
    """Sum of the plane forces times the base radius, at every phase."""
    data = analyses[case]
    r_b = float(data["base_radius"][0])
    assert r_b * data["plane_force"].sum(("tooth_pair", "plane")).values == pytest.approx(400.0, rel=1e-9)


def test_crowning_moves_the_pattern_back(analyses):
    """Centre of load over the face width, half of the width = 1: the gap increases towards +z."""
    centre = {}
    for case, data in analyses.items():
        load = load_over_width(data)[0]
        centre[case] = float(np.sum(load * data["plane"].values) / np.sum(load)) / (0.5 * B)
    assert abs(centre["plain", 0.0]) < 0.01
    assert centre["plain", 40e-6] < -0.4
    assert centre["plain", 40e-6] < centre["crowned", 40e-6] < -0.1


@pytest.mark.study
def test_levels_side_by_side():
    """The second table of the page, to its last digit."""
    found = compare_levels(load_model(FOLDER / "relieved.yaml"), torque=400.0, misalignment=20e-6 / B)
    for level, (mean, pp, factor, pressure, rms) in LEVELS.items():
        one = found.numbers[level]
        assert one.te_mean == pytest.approx(mean, abs=5.1e-9)
        assert one.te_pp == pytest.approx(pp, abs=0.051e-9)
        assert one.force_rms == pytest.approx(rms, rel=0.05)
        if level in found.analyses:
            main = contact_numbers(found.analyses[level])
            assert main["face_load_factor"][0] == pytest.approx(factor, abs=5.1e-4)
            assert main["flank_pressure"][0] == pytest.approx(pressure, abs=0.51e6)
