# SPDX-License-Identifier: Apache-2.0
"""A two-stage industrial gearbox from REXS against the same gearbox written by hand, equal to rounding.

Source: `FVA-Industriegetriebe_2stufig_1-4.rexs` of `fva-net/rexs-api-cpp` (Apache-2.0), exported by Bearinx,
here `benchmarks/two_stage.rexs`.
Input and output shaft are on one axis, the input shaft has a needle bearing in the output shaft, and the
middle shaft is 190 mm away. The model below is written from the numbers of that file as an engineer reads
them: lengths from the start of each shaft, z along the shafts, hands by the signs of the helix angles. Both
models must have the same natural frequencies, bearing forces and geometry; the tolerance is that of the
eigenvalue solver.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.io.rexs.importing import import_rexs
from pitchpoint.io.yaml_model import loads_model

FILE = Path(__file__).parents[2] / "benchmarks" / "two_stage.rexs"
BY_HAND = """
gears:
  pinion_1: {number_of_teeth: 27, normal_module: 4.5 mm, helix_angle: 21 deg, hand: right, face_width: 50 mm,
    profile_shift_coefficient: 0.231415,
    material: &steel {youngs_modulus: 210 GPa, poisson_ratio: 0.3, density: 7850 kg/m^3}}
  wheel_1: {number_of_teeth: 51, normal_module: 4.5 mm, helix_angle: 21 deg, hand: left, face_width: 50 mm,
    profile_shift_coefficient: 0.231415, material: *steel}
  pinion_2: {number_of_teeth: 23, normal_module: 6.5 mm, helix_angle: 10 deg, hand: left, face_width: 74 mm,
    profile_shift_coefficient: 0.15074, material: *steel}
  wheel_2: {number_of_teeth: 34, normal_module: 6.5 mm, helix_angle: 10 deg, hand: right, face_width: 74 mm,
    material: *steel}
shafts:
  input:
    sections: [{length: 80 mm, diameter: 50 mm}, {length: 80 mm, diameter: 60 mm},
      {length: 30 mm, diameter: 50 mm}]
    material: *steel
    gears: {pinion_1: 117 mm}
    position: [0, 0, -70 mm]
  middle:
    sections: [{length: 45 mm, diameter: 80 mm}, {length: 60 mm, diameter: 90 mm},
      {length: 165 mm, diameter: 80 mm}]
    material: *steel
    gears: {wheel_1: 72 mm, pinion_2: 180 mm}
    position: [-190 mm, 0, -25 mm]
  output:
    sections: [{length: 20 mm, diameter: 70 mm, bore: 58 mm}, {length: 8 mm, diameter: 70 mm, bore: 58 mm},
      {length: 3 mm, diameter: 70 mm, bore: 58 mm}, {length: 82 mm, diameter: 70 mm},
      {length: 10 mm, diameter: 80 mm}, {length: 100 mm, diameter: 60 mm}]
    material: *steel
    gears: {wheel_2: 65 mm}
    position: [0, 0, 90 mm]
    markers: {seat: {position: [0, 0, 15 mm]}}
rolling_bearings:
  ball: {body: input, position: [0, 0, 65 mm], designation: 6210-2Z,
    axial_force_absorption: both_directions, damping: 2}
  left: {body: output, position: [0, 0, 13 mm], designation: "33014",
    axial_force_absorption: negative, damping: 2}
  right: {body: output, position: [0, 0, 140 mm], designation: "33012",
    axial_force_absorption: positive, damping: 2}
bearings:
  needles: {body: input, position: [0, 0, 175 mm], housing: output.seat, damping: {ratio: 0.03},
    stiffness: {radial: 1e11 N/m, tilt: 1e7 N m/rad}}
  first: {body: middle, position: [0, 0, 20 mm], damping: {ratio: 0.03},
    stiffness: &rigid {radial: 1e11 N/m, axial: 1e11 N/m, tilt: 1e7 N m/rad}}
  second: {body: middle, position: [0, 0, 250 mm], damping: {ratio: 0.03}, stiffness: *rigid}
meshes:
  stage_1: {gears: [pinion_1, wheel_1], center_distance: 190 mm,
    backlash: {factor: 0.04}, damping: {ratio: 0.05}}
  stage_2: {gears: [pinion_2, wheel_2], center_distance: 190 mm,
    backlash: {factor: 0.04}, damping: {ratio: 0.05}}
loads:
  drive: {body: input, torque: 567 N m}
  belt: {body: input, force: [0, -456 N, 0]}
  side: {body: output, force: [0, -123 N, 0], position: [0, 0, 170 mm]}
  machine: {body: output, torque: balance, position: [0, 0, 170 mm]}
scenarios:
  slow: {quasi_static: {mesh: stage_1, points: 2}}
  steady: {speed: {input: 543 rpm}, duration: 0.18 s, step: 82 us}
"""
SAME = {
    "bearing_force": {
        "ball": "6210_2z_rolling_bearing_33",
        "left": "33014_rolling_bearing_90",
        "right": "33012_rolling_bearing_49",
        "first": "not_a_catalogue_bearing_33016_rolling_bearing_35",
    },
    "mesh_force": {"stage_1": "cylindrical_stage_24", "stage_2": "cylindrical_stage_41"},
}
"""Names of the import by those of the model by hand."""


@pytest.fixture(scope="module")
def imported():
    return import_rexs(FILE).model


@pytest.fixture(scope="module")
def by_hand():
    return loads_model(BY_HAND)


def test_geometry_and_scenario_are_equal(imported, by_hand):
    for one, two in zip(imported.pairs.values(), by_hand.pairs.values(), strict=True):
        assert vars(one.gear1) == vars(two.gear1)
        assert (one.gear2.x, one.a_w, one.eps_alpha) == (two.gear2.x, two.a_w, two.eps_alpha)
    assert [s.dimensions for s in imported.shafts.values()] == [
        pytest.approx(np.array(s.dimensions), rel=1e-15) for s in by_hand.shafts.values()
    ]
    mine, other = imported.scenarios["steady"], by_hand.scenarios["steady"]
    assert (mine.duration, mine.step) == (other.duration, other.step)
    assert list(mine.speed.values()) == list(other.speed.values())


def test_natural_frequencies_and_forces_are_equal(imported, by_hand):
    """At the static solution under the loads: 100 modes, and the forces that hold the shafts."""
    systems = [pp.compile_model(model, "steady") for model in (imported, by_hand)]
    modes = [pp.solve_modal(system)["frequency"].values[:100] for system in systems]
    assert len(modes[0]) == 100
    np.testing.assert_allclose(modes[0], modes[1], rtol=1e-9, atol=1e-6)
    rests = [pp.solve_equilibrium(system) for system in systems]
    for channel, names in SAME.items():
        for hand, name in names.items():
            for part in (".fx", ".fy", ".fz") if channel == "bearing_force" else ("",):
                values = [float(r[f"{channel}[{n}{part}]"]) for r, n in zip(rests, (name, hand), strict=True)]
                assert values[0] == pytest.approx(values[1], rel=1e-9, abs=1e-5), (name, part)
