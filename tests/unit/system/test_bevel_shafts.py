# SPDX-License-Identifier: Apache-2.0
"""Bevel gears on elastic shafts: they sit where their teeth are, though their apex lies beyond the end."""

import math

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model

FILE = """
title: bevel gears on shafts
bevel_gears:
  a: {number_of_teeth: 20, mate_teeth: 40, outer_transverse_module: 3 mm, face_width: 20 mm}
  b: {number_of_teeth: 40, mate_teeth: 20, outer_transverse_module: 3 mm, face_width: 20 mm}
shafts:
  first: {sections: [{length: 200 mm, diameter: DIAMETER}], bevel_gears: {a: -40 mm}, position: [0, 0, 40 mm],
    material: {youngs_modulus: YOUNG, poisson_ratio: 0.3, density: 7850 kg/m^3}}
  second: {sections: [{length: 200 mm, diameter: DIAMETER}], bevel_gears: {b: 60 mm},
    position: [-60 mm, 0, 0], axes: {z: [1, 0, 0], x: [0, 1, 0]},
    material: {youngs_modulus: YOUNG, poisson_ratio: 0.3, density: 7850 kg/m^3}}
bevel_meshes:
  m: {gears: [a, b], stiffness: {law: constant, value: 3e8}, backlash: {normal: 0.05 mm}}
bearings:
  one: {body: first, position: [0, 0, 60 mm], stiffness: {radial: 3e8, axial: 2e8}}
  two: {body: first, position: [0, 0, 190 mm], stiffness: {radial: 3e8}}
  three: {body: second, position: [0, 0, 10 mm], stiffness: {radial: 3e8, axial: 2e8}}
  four: {body: second, position: [0, 0, 190 mm], stiffness: {radial: 3e8}}
loads:
  in: {body: first, torque: 80 N m, position: [0, 0, 200 mm]}
  out: {body: second, torque: balance}
"""


def model_of(diameter="30 mm", youngs_modulus="206 GPa"):
    return loads_model(FILE.replace("DIAMETER", diameter).replace("YOUNG", youngs_modulus))


def test_a_station_stands_in_the_middle_of_the_face():
    model = model_of()
    pair = model.bevel_pairs["m"]
    middle = -40e-3 + pair.R_m * math.cos(pair.gear1.delta)
    assert any(z == pytest.approx(middle, abs=1e-12) for z in model.stations["first"])
    system = compile_model(model)
    record = system.records["bevel_mesh"][0]
    assert record["apex"][0] == pytest.approx(-pair.R_m * math.cos(pair.gear1.delta), rel=1e-12)
    assert loads_model(dump_model(model)).shafts["first"].bevel_gears == {"a": -40e-3}


def test_forces_are_those_of_the_textbook_and_stiff_shafts_tend_to_rigid_bodies():
    """The torque goes through teeth and shafts; softer shafts lean more, and the frequencies fall. Some
    1e-3 rad of lean turn 3 kN across the shaft along it."""
    stiff, soft = (compile_model(model_of(youngs_modulus=E)) for E in ("206000 GPa", "206 GPa"))
    pair = model_of().bevel_pairs["m"]
    r_b = pair.R_m * math.sin(pair.gear1.delta_b)
    for system, lean in ((stiff, 1e-3), (soft, 1e-2)):
        found = solve_equilibrium(system)
        assert float(found["mesh_force[m]"]) == pytest.approx(80.0 / r_b, rel=1e-6)
        assert float(found["torque[out]"]) == pytest.approx(160.0, rel=1e-6)
        held = sum(float(found[f"bearing_force[{b}.fz]"]) for b in ("one", "two"))
        assert held == pytest.approx(-float(found["axial_force_1[m]"]), rel=lean)
    lowest = [find_modes(s).frequency[1] for s in (stiff, soft)]
    assert lowest[1] < lowest[0]


def test_a_gear_beyond_the_ends_of_its_shaft_is_told():
    with pytest.raises(
        ModelError, match=r"shafts.second.bevel_gears.b.*is not a position on the shaft second"
    ):
        loads_model(
            FILE.replace("DIAMETER", "30 mm").replace("YOUNG", "206 GPa").replace("{b: 60 mm}", "{b: 260 mm}")
        )
