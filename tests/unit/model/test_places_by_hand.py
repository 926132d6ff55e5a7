# SPDX-License-Identifier: Apache-2.0
"""Places given by hand: they are the centre distance, a contradiction is a difference, and 1 µm is none."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from tests.support.model_files import gear

RING = "type: internal, tip_diameter: 177 mm"


def pair(place, more=""):
    """Gears of 24 and 18 teeth of module 3, at 63 mm without backlash."""
    return (
        "gears:\n"
        + gear("a", 24, 0.0)
        + gear("b", 18, 0.0)
        + "bodies:\n  one: {gears: [a], position: [0, 0, 0]}\n"
        + f"  two: {{gears: [b]{place}}}\nmeshes:\n  m: {{gears: [a, b]{more}}}\n"
    )


@pytest.mark.parametrize("distance", [63.0, 63.00022, 63.4])
def test_places_are_the_centre_distance(distance):
    """Backlash by d_b (inv alpha_w - inv alpha) of both gears: 0.280 mm along the base tangent at 63.4 mm."""
    model = loads_model(pair(f", position: [0, {distance} mm, 0]"))
    assert model.meshes["m"].a_w == pytest.approx(distance * 1e-3, rel=1e-15)
    assert model.meshes["m"].theta == pytest.approx(0.5 * math.pi)
    base = 42 * 3e-3 * math.cos(math.radians(20.0))
    alpha = math.acos(math.cos(math.radians(20.0)) * 63.0 / distance)
    wanted = base * (math.tan(alpha) - alpha - math.tan(math.radians(20.0)) + math.radians(20.0))
    assert model.backlash("m") == pytest.approx(wanted, abs=1e-12)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("63.4 mm", "63.4 mm is 0.4 mm more than the distance between the positions of its bodies, 63 mm"),
        ("62.998 mm", "62.998 mm is 2 µm less than the distance between the positions of its bodies, 63 mm"),
        ("63.0009 mm", None),
        ("62.9991 mm", None),
    ],
)
def test_a_distance_that_is_given_twice(given, said):
    text = pair(", position: [63 mm, 0, 0]", f", center_distance: {given}")
    if said is None:
        loads_model(text)
        return
    with pytest.raises(ModelError, match=said):
        loads_model(text)


def test_a_place_that_another_mesh_gives_is_none_by_hand():
    """The ring fits at 63.4 mm only, the planet stands at 63 mm from its sun."""
    text = (
        pair("", ", direction: 20 deg")
        .replace(
            "bodies:", gear("ring", 60, -0.14, RING) + "bodies:\n  hoop: {gears: [ring], position: [0, 0, 0]}"
        )
        .replace("bodies:\n  hoop", "bodies:\n  hoop", 1)
        + "  r: {gears: [b, ring]}\n"
    )
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    (problem,) = caught.value.problems
    assert "without backlash, from the profile shifts" in str(problem)
    assert "than the distance between the positions of its bodies, 63 mm" in str(problem)
    assert "give center_distance: 63 mm" in str(problem)


def test_a_ring_around_a_planet_needs_a_direction():
    """Without it, the ring would be 126 mm beside the sun, in the direction 0."""
    text = pair("", ", direction: 20 deg").replace(
        "bodies:", gear("ring", 60, 0.0, RING) + "bodies:\n  hoop: {gears: [ring]}"
    )
    text += "  r: {gears: [b, ring]}\n"
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    (problem,) = caught.value.problems
    assert str(problem).startswith("meshes.r.direction")
    assert "is missing: b is also in m, so that the direction is not arbitrary" in str(problem)
    assert "give direction: -160 deg, with ring on the axis of a" in str(problem)
    given = loads_model(text.replace("[b, ring]", "[b, ring], direction: -160 deg"))
    assert given.bodies["hoop"].origin == pytest.approx((0.0, 0.0, 0.0), abs=1e-15)
    placed = loads_model(text.replace("{gears: [ring]}", "{gears: [ring], position: [0, 0, 0]}"))
    assert placed.meshes["r"].theta == pytest.approx(math.radians(-160.0))
