# SPDX-License-Identifier: Apache-2.0
"""Profile shifts that follow from the centre distance: messages name what the file gives."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.distance_range import possible_distances
from pitchpoint.geometry.tooth_thickness import tip_thickness
from pitchpoint.io.yaml_model import loads_model
from tests.support.model_files import gear, pair

HELICAL = "helix_angle: 10 deg, hand: "


def problems_of(text: str) -> list[tuple[str, str]]:
    """Places and sentences of all problems of a file."""
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    return [(problem.where, str(problem)) for problem in caught.value.problems]


def test_gears_that_do_not_fit_are_not_a_missing_profile_shift():
    """Equal hands of an external pair, with the shift of one gear from the centre distance."""
    right = HELICAL + "right"
    ((where, text),) = problems_of(
        pair(gear("a", 20, None, right), gear("b", 40, 0.0, right), "center_distance: 92 mm")
    )
    assert where == "meshes.m.gears" and "opposite hands" in text


def test_all_problems_of_a_pair_at_once():
    """Equal hands, and no profile shift on either gear."""
    right = HELICAL + "right"
    gears = gear("a", 20, None, right), gear("b", 40, None, right)
    found = problems_of(pair(*gears, "center_distance: 92 mm"))
    assert {where for where, _ in found} == {"meshes.m.gears", "gears.a.profile_shift_coefficient"}


@pytest.mark.parametrize(
    ("other", "given"), [("", "200 mm"), ("type: internal, bore_diameter: 140 mm", "45 mm")]
)
def test_an_impossible_centre_distance_is_named_with_its_range(other: str, given: str):
    """The file does not contain the profile shift that the centre distance requires."""
    ((where, text),) = problems_of(
        pair(gear("a", 20, None), gear("b", 40, 0.0, other), f"center_distance: {given}")
    )
    assert where == "meshes.m.center_distance"
    assert text.startswith(f"meshes.m.center_distance (line 5): {given} requires a profile shift")
    low, high = (float(word) for word in text.partition("limit ")[2].partition(" mm")[0].split(" to "))
    for distance in (low, high):
        loads_model(pair(gear("a", 20, None), gear("b", 40, 0.0, other), f"center_distance: {distance} mm"))
    assert not low <= float(given.split()[0]) <= high


def test_the_largest_distance_has_a_pointed_tooth():
    """Independent of the search: at the largest distance the tip thickness is zero."""
    one, two = CylindricalGear(z=20, m_n=3e-3), CylindricalGear(z=50, m_n=3e-3)
    _, high = possible_distances(one, two, 0)
    alpha_t = math.radians(20.0)
    alpha_w = math.acos(0.105 * math.cos(alpha_t) / high)
    x = 70.0 * ((math.tan(alpha_w) - alpha_w) - (math.tan(alpha_t) - alpha_t)) / (2.0 * math.tan(alpha_t))
    assert tip_thickness(one.replace(x=x)) == pytest.approx(0.0, abs=1e-9)
