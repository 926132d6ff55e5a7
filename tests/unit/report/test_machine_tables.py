# SPDX-License-Identifier: Apache-2.0
"""Tables of the machine in a report: scissor gears, load cases, planets, further scenarios."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.progress import silent
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.collect import collect
from pitchpoint.report.describe import describe
from pitchpoint.report.scissor_gears import scissors_of_model
from pitchpoint.viz.report.gearbox import gearbox_section
from pitchpoint.viz.report.planets import planet_table

TORQUE, SUN, PLANET, RING, MODULE = 30.0, 21, 24, 69, 2e-3
GEAR = (
    "normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0, tooth_thickness_allowance: -20 um"
)
EPICYCLIC = f"""
gears:
  sun: {{number_of_teeth: {SUN}, {GEAR}}}
  ring: {{type: internal, number_of_teeth: {RING}, {GEAR}}}
bodies:
  input: {{gears: [sun], motion: torsion, inertia: 1e-3 kg m^2, position: [0, 0, 0]}}
  case: {{gears: [ring], motion: fixed, position: [0, 0, 0]}}
  output: {{motion: torsion, inertia: 1e-2 kg m^2}}
planetary_stages:
  set:
    {{sun: sun, ring: ring, carrier: output, planets: 3, motion: torsion,
     planet: {{number_of_teeth: {PLANET}, {GEAR}}}}}
loads:
  motor: {{body: input, torque: {TORQUE} N m}}
  road: {{body: output, torque: balance}}
load_cases:
  climb: {{loads: {{motor: {{torque: 60 N m}}}}, speed: {{input: 500 rpm}}, load_duration_fraction: 10 %}}
  cruise: {{loads: {{motor: {{power: 2 kW}}}}, speed: {{input: 900 rpm}}, load_duration_fraction: 90 %}}
scenarios:
  roll: {{quasi_static: {{mesh: sun-planet_1, points: 8}}}}
  one: {{speed: {{input: 100 rpm}}, duration: 1 ms}}
  two: {{speed: {{input: 200 rpm}}, duration: 1 ms}}
  three: {{speed: {{input: 300 rpm}}, duration: 1 ms}}
  four: {{speed: {{input: 400 rpm}}, duration: 1 ms}}
"""
SCISSORS = """
gears:
  idler: {number_of_teeth: 46, normal_module: 1.75 mm, face_width: 24 mm, profile_shift_coefficient: 0}
  cam: {number_of_teeth: 69, normal_module: 1.75 mm, face_width: 12 mm, profile_shift_coefficient: 0,
        bore_diameter: 30 mm}
bodies:
  idler: {gears: [idler], motion: torsion, position: [0, 0, 0]}
  camshaft: {gears: [cam], motion: torsion, inertia: 2.8e-3 kg m^2}
meshes:
  stage: {gears: [idler, cam], backlash: {circumferential: 0.09 mm}}
scissor_gears:
  free: {gear: cam, face_width: 6 mm, torque: -15 N m, stiffness: 40 N m/rad, friction: 0.5 N m}
"""


def test_the_planets_of_a_stage_share_the_torque_of_the_sun_in_the_rolls_of_a_report() -> None:
    """F = T/(3 r_b) at each of three planets, K_gamma = 1."""
    found, _ = collect(loads_model(EPICYCLIC), [], silent)
    radius = 0.5 * SUN * MODULE * math.cos(math.radians(20.0))
    loads = found.planets["set"]
    assert loads["load_sharing_factor"] == pytest.approx(1.0, abs=1e-6)
    assert [abs(f) for f in loads["mean_force"]] == pytest.approx([TORQUE / 3.0 / radius] * 3, rel=1e-6)
    assert "equal mean forces in sun-planet_1 … sun-planet_3, 506.8 N" in planet_table(found.planets)


def test_the_page_has_load_cases_planets_and_the_power_flow_of_all_scenarios() -> None:
    about = describe(loads_model(EPICYCLIC))
    tables = {table.title: table for table in about.gearbox.tables}
    assert [*tables] == [
        "Power flow in further scenarios",
        "Load cases",
        "Planetary stage set: planets on output",
    ]
    further = tables["Power flow in further scenarios"].rows
    power = TORQUE * 400.0 * math.pi / 30.0
    ratio = 1.0 + RING / SUN
    words = f"{power:.5g} W from motor (30 N m), to road (-{TORQUE * ratio:.5g} N m)"
    held = f"held by case ({TORQUE * RING / SUN:.5g} N m)"
    assert further == [["four", f"{words}, {held}; no losses"]]
    page = "".join(str(part) for part in gearbox_section(about.gearbox).parts)
    assert "to road (−128.57 N m)" in page and "motor 60 N m" in page and "10 %" in page


def test_a_report_lists_the_backlash_that_a_scissor_gear_takes_up() -> None:
    """Its base tangent backlash j_t cos(20 deg) twists both halves, which relieves the spring."""
    model = loads_model(SCISSORS)
    row = scissors_of_model(model)["free"]
    backlash = 0.09e-3 * math.cos(math.radians(20.0))
    radius = 0.5 * 69 * 1.75e-3 * math.cos(math.radians(20.0))
    assert row["backlash"] == pytest.approx(backlash, rel=1e-6)
    assert row["spring_torque"] == pytest.approx(-(15.0 - 40.0 * backlash / radius), rel=1e-6)
    about = describe(model)
    table = next(table for table in about.gearbox.tables if table.title == "Scissor gears")
    assert table.rows[0][3] == "84.57 µm"
    assert [words for words, _ in about.counts if words.startswith(("torsion", "clutches"))] == []
