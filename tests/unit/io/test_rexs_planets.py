# SPDX-License-Identifier: Apache-2.0
"""Planetary stages from REXS: stepped planets, planets in series, pins at unequal places.

The files are written from models and read as those of another program, so that names, zeros and directions
have no meaning of their own.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import pitchpoint as pp
from pitchpoint.core.errors import ModelError
from pitchpoint.io.rexs.exporting.exporting import export_rexs
from pitchpoint.io.rexs.importing import import_rexs
from pitchpoint.io.rexs.writing.text import rexs_bytes
from pitchpoint.io.yaml_model import load_model, loads_model

EXAMPLES = Path(__file__).parents[3] / "examples"
STEPPED = """
gears:
  sun: {number_of_teeth: 21, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 78, normal_module: 3 mm, face_width: 20 mm,
         profile_shift_coefficient: 0, bore_diameter: 270 mm, tip_diameter: 231 mm}
bodies:
  sun: {gears: [sun], position: [0, 0, 0]}
  ring: {gears: [ring], position: [0, 0, 30 mm], motion: fixed}
  carrier: {mass: 4 kg, inertia: 0.02 kg m^2, transverse_inertia: 0.015 kg m^2, position: [0, 0, 0],
            motion: free}
planetary_stages:
  set:
    sun: sun
    carrier: carrier
    angles: ANGLES
    center_distance: 90 mm
    planet: {number_of_teeth: 39, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0,
             bore_diameter: 30 mm}
    steps:
      small: {position: 30 mm, ring: ring,
              gear: {number_of_teeth: 18, normal_module: 3 mm, face_width: 20 mm,
                     profile_shift_coefficient: 0}}
    PINS
    sun_mesh: {backlash: {factor: 0.04}}
    ring_mesh: {backlash: {factor: 0.04}}
    motion: free
    bearing: {stiffness: {radial: 4e8, axial: 1e8, tilt: 1e5}}
bearings:
  right: {body: carrier, position: [0, 0, 0], stiffness: {radial: 1e8, axial: 1e8, tilt: 1e5}}
loads:
  motor: {body: sun, torque: 100 N m}
  output: {body: carrier, torque: balance}
scenarios:
  steady: {speed: {sun: 1000 rpm}, duration: 10 ms}
"""


def foreign(model, folder, name="gear_unit.rexs"):
    """Import of the file of a model as that of another program."""
    path = folder / name
    text = rexs_bytes(export_rexs(model).rexs, "xml").decode()
    path.write_text(text.replace('applicationId="pitchpoint"', 'applicationId="a program"'), encoding="utf-8")
    return import_rexs(path)


def stepped(angles, pins=""):
    return loads_model(STEPPED.replace("ANGLES", str(angles)).replace("    PINS\n", pins))


def test_stepped_planets_at_unequal_angles(tmp_path):
    """i = 1 + z_1 z_r/(z_s z_2) = 1 + 39 * 78/(21 * 18); planets fit at whole multiples of 360/1140 deg.

    1140 = (z_s z_2 + z_r z_1)/gcd(z_1, z_2).
    """
    angles = [360.0 * k / 1140 for k in (0, 380, 715)]
    model = stepped([f"{angle!r} deg" for angle in angles])
    again = foreign(model, tmp_path).model
    (stage,) = again.planetary_stages.values()
    (step,) = stage.steps.values()
    assert stage.angles == pytest.approx([math.radians(angle) for angle in angles])
    assert (step.gear.number_of_teeth, step.position) == (18, pytest.approx(0.030))
    assert again.gears[step.ring].type == "internal" and not step.fitted
    speeds = again.start_speeds("steady")
    ratio = speeds["sun"] / speeds[stage.carrier]
    assert ratio == pytest.approx(1.0 + 39 * 78 / (21 * 18))


def test_planets_keep_their_linear_and_rolling_bearings(tmp_path):
    """A linear bearing at the middle of each planet, and a needle bearing 15 mm from it."""
    pins = "".join(
        f"  pin_{k}: {{ends: [carrier, planet_{k}], position: [0, 0, 15 mm], designation: NA4906}}\n"
        for k in (1, 2, 3)
    )
    text = STEPPED.replace("ANGLES", "[0 deg, 120 deg, 240 deg]").replace("    PINS\n", "")
    found = foreign(loads_model(text.replace("loads:\n", f"rolling_bearings:\n{pins}loads:\n")), tmp_path)
    (stage,) = found.model.planetary_stages.values()
    matrix = stage.bearing.stiffness.matrix6()
    assert [matrix[i][i] for i in (0, 2, 3)] == pytest.approx([4e8, 1e8, 1e5])
    places = [b.position[2] for b in found.model.rolling_bearings.values()]
    assert places == pytest.approx([0.015] * 3)


def test_steps_that_do_not_fit_are_oriented_at_their_assembly(tmp_path):
    """Planets at 0, 100.1 and 230 deg fit only with their own orientation of the steps."""
    text = STEPPED.replace("position: 30 mm, ring: ring,", "position: 30 mm, ring: ring, fitted: true,")
    model = loads_model(text.replace("ANGLES", "[0 deg, 100.1 deg, 230 deg]").replace("    PINS\n", ""))
    found = foreign(model, tmp_path)
    (stage,) = found.model.planetary_stages.values()
    assert stage.steps["step_2"].fitted
    assert any("oriented at its assembly" in item.reason for item in found.of("changed"))


def test_a_planet_in_mesh_with_a_gear_outside_its_stage_is_refused(tmp_path):
    """The file of another program has lost the relation of the planets to their stage."""
    path = tmp_path / "gear_unit.rexs"
    text = rexs_bytes(export_rexs(stepped(["0 deg", "120 deg", "240 deg"])).rexs, "xml").decode()
    path.write_text(text.replace('type="planet_shaft"', 'type="central_shaft"'), encoding="utf-8")
    with pytest.raises(ModelError, match="has no planets"):
        import_rexs(path)


def test_pins_beside_their_places_have_errors(tmp_path):
    """30 um along the circle and 20 um outwards at one pin each."""
    pins = "    pin_errors: {planet_2: {tangential: 30 um}, planet_3: {radial: 20 um}}\n"
    model = stepped(["0 deg", "120 deg", "240 deg"], pins)
    found = foreign(model, tmp_path).model
    (stage,) = found.planetary_stages.values()
    errors = list(stage.pin_errors.values())
    assert errors[0].tangential == pytest.approx(30e-6, rel=1e-6)
    assert errors[1].radial == pytest.approx(20e-6, rel=1e-3)
    assert stage.angles == pytest.approx([0.0, math.tau / 3, 2 * math.tau / 3], abs=1e-9)
    for k in (1, 2, 3):
        one = model.bodies[f"planet_{k}"].origin
        two = found.bodies[stage.names[k - 1]].origin
        assert two == pytest.approx(one, abs=1e-8)  # 30 um along the circle move the pin 5 nm outwards


def test_planets_in_series_of_a_ravigneaux_set(tmp_path):
    """Both circles of planets return with their order and side; speeds follow from Willis' equation."""
    model = load_model(EXAMPLES / "ravigneaux" / "model.yaml")
    found = foreign(model, tmp_path).model
    stages = list(found.planetary_stages.values())
    assert [stage.inner_planets for stage in stages] == [None, stages[0].planet_name]
    assert stages[1].planet_side == "counter_clockwise"
    assert stages[1].position == pytest.approx(0.0125)
    for mine, theirs in zip(model.planetary_stages.values(), stages, strict=True):
        for a, b in zip(mine.names, theirs.names, strict=True):
            assert found.bodies[b].origin == pytest.approx(model.bodies[a].origin, abs=1e-9)
    # with the carrier at rest small sun 27 and ring 72 turn in the same sense, through two planets
    scenario = pp.Scenario(speed={"small_sun": 100.0, stages[0].carrier: 0.0}, duration=1.0)
    speeds = found.start_speeds(scenario)
    assert speeds["ring"] == pytest.approx(100.0 * 27 / 72)
    assert speeds["large_sun"] == pytest.approx(-100.0 * 27 / 36)
