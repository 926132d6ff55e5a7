# SPDX-License-Identifier: Apache-2.0
"""Several bearings per planet, positions along the pin, and remarks on planets that tilt."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model

STAGE = """
gears:
  sun: {{number_of_teeth: 28, normal_module: 4 mm, {r}face_width: 60 mm, profile_shift_coefficient: 0}}
  ring: {{type: internal, number_of_teeth: 92, normal_module: 4 mm, {l}face_width: 60 mm,
    profile_shift_coefficient: 0}}
bodies:
  sun_shaft: {{gears: [sun], position: [0, 0, 0], axes: {{z: [1, 0, 0], x: [0, 1, 0]}}}}
  carrier: {{inertia: 2 kg m^2, mass: 80 kg, motion: torsion{markers}}}
  housing: {{gears: [ring], motion: fixed}}
rolling_bearings:
{bearings}
planetary_stages:
  st:
    sun: sun
    ring: ring
    carrier: carrier
    planets: 3
    planet: {{number_of_teeth: 32, normal_module: 4 mm, {l}face_width: 60 mm, profile_shift_coefficient: 0,
      bore_diameter: 90 mm}}
    motion: free
loads:
  motor: {{body: sun_shaft, torque: 3000 N m}}
  machine: {{body: carrier, torque: balance}}
"""


def stage(*rows: str, helical: bool = False, markers: str = "") -> str:
    """Model file; `K` in the rows of bearings is the number of the planet."""
    helix = "helix_angle: 12 deg, hand: {}, " if helical else "{}"
    lines = [f"  p{k}_{n}: {{{row.replace('K', str(k))}}}" for k in (1, 2, 3) for n, row in enumerate(rows)]
    hands = (helix.format("right"), helix.format("left")) if helical else ("", "")
    return STAGE.format(r=hands[0], l=hands[1], bearings="\n".join(lines), markers=markers)


ENDS = "ends: [carrier, planet_K], position: [0, 0, {} mm], designation: 22210"


def test_each_of_two_bearings_carries_half_of_the_load() -> None:
    """Spur planets: 3000 N m / r_s from the sun and from the ring, on all pins together."""
    model = loads_model(stage(ENDS.format(-15), ENDS.format(15)))
    system = compile_model(model)
    record = system.records["rolling_bearing"]
    np.testing.assert_allclose(record["p_j"][:, 2], 3 * [-0.015, 0.015], atol=1e-12)
    np.testing.assert_allclose(record["p_j"][:, :2], 0.0, atol=1e-12)
    found = solve_equilibrium(system)
    forces = np.array([[found[f"bearing_force[p{k}_{n}.radial]"].item() for n in (0, 1)] for k in (1, 2, 3)])
    # positions of the rollers differ, and so do the shares of the planets
    np.testing.assert_allclose(forces[:, 0], forces[:, 1], rtol=1e-4)
    assert forces.sum() == pytest.approx(2.0 * 3000.0 / 0.056, rel=1e-4)


def test_inner_rings_on_planets_are_at_their_positions_too() -> None:
    rows = (f"ends: [planet_K, carrier], position: [0, 0, {z} mm], designation: 22210" for z in (-15, 15))
    record = compile_model(loads_model(stage(*rows))).records["rolling_bearing"]
    np.testing.assert_allclose(record["p_i"][:, 2], 3 * [-0.015, 0.015], atol=1e-12)


def test_markers_of_the_carrier_are_told_the_position_on_the_pin() -> None:
    markers = ", markers: {a: {position: [120 mm, 0, -15 mm]}}"
    text = stage(ENDS.format(0), markers=markers) + "\n"
    text = text.replace(
        "planetary_stages:", "  a: {ends: [carrier.a, planet_1], designation: 22210}\nplanetary_stages:"
    )
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    (problem,) = caught.value.problems
    assert "are 15 mm apart" in problem.text
    assert "write ends: [carrier, planet_1], position: [0, 0, -15 mm]" in str(problem.remedy)


@pytest.mark.parametrize(
    ("row", "remedy"),
    [
        ("body: carrier, housing: planet_K, designation: 22210", "ends: [carrier, planet_1]"),
        ("ends: [carrier.a, planet_K], position: [0, 0, 5 mm], designation: 22210", "by markers"),
    ],
)
def test_other_places_are_refused(row: str, remedy: str) -> None:
    text = stage(row, markers=", markers: {a: {position: [120 mm, 0, 0]}}")
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    assert any(remedy in str(p.remedy) for p in caught.value.problems)


def tilts(text: str) -> list[str]:
    return [str(each) for each in remarks_of_file(loads_model(text)) if " tilt" in each.text]


def test_remark_on_helical_planets_whose_bearings_let_them_tilt() -> None:
    (said,) = tilts(stage(ENDS.format(0), helical=True))
    assert said.startswith("planetary_stages.st")
    assert (
        "tilt planet_1, planet_2 and planet_3; p1_0, p2_0 and p3_0, at one position each, support little"
        in said
    )
    assert not tilts(stage(ENDS.format(-15), ENDS.format(15), helical=True))
    assert not tilts(stage(ENDS.format(0)))
    assert tilts(stage("ends: [carrier, planet_K], designation: NUP 2210 E", helical=True))
    assert not tilts(stage("ends: [carrier, planet_K], designation: NA4910", helical=True))


def test_planets_of_a_floating_carrier_are_not_reported() -> None:
    """Markers make a carrier a part of the mechanism: it then requires a motion."""
    text = stage(ENDS.format(0), markers=", markers: {a: {position: [120 mm, 0, 0]}}")
    text += "scenarios:\n  s: {speed: {sun_shaft: 600 rpm}, duration: 1 ms}\n"
    with pytest.raises(ModelError) as caught:
        loads_model(text.replace("mass: 80 kg, motion: torsion", "mass: 80 kg"))
    (problem,) = caught.value.problems
    assert problem.where == "bodies.carrier"
    assert "give it motion: torsion" in str(problem.remedy)
