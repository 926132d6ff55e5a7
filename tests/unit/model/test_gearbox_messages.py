# SPDX-License-Identifier: Apache-2.0
"""Messages on mistakes in whole gearboxes: the mistake alone, without problems that follow from it."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.solvers.sweep_speeds import sweep_orders
from pitchpoint.system.compile import compile_model
from pitchpoint.system.housing_matrices import housing_matrices

GEARBOX = """\
materials: {cast: {youngs_modulus: 170 GPa, poisson_ratio: 0.28, density: 7100 kg/m^3}}
gears:
  pinion: {number_of_teeth: 20, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
shafts:
  input: {sections: [{length: 200 mm, diameter: 40 mm}], gears: {pinion: 100 mm}, position: [0, 0, 0]}
  output: {sections: [{length: 200 mm, diameter: 40 mm}], gears: {wheel: 100 mm}}
bodies:
  motor: {motion: torsion, inertia: 0.02 kg m^2, position: [0, 0, 0]}
  machine: {motion: torsion, inertia: 0.2 kg m^2, position: [90 mm, 0, 200 mm]}
couplings:
  flange: {bodies: [motor, input], stiffness: {torsion: 5e3 N m/rad}}
  drive: {bodies: [output, machine], position: [0, 0, 200 mm], stiffness: {torsion: 5e3 N m/rad}}
rolling_bearings:
  in_1: {body: input, position: [0, 0, 20 mm], designation: 6208}
  in_2: {body: input, position: [0, 0, 180 mm], designation: 6208}
  out_1: {body: output, position: [0, 0, 20 mm], designation: 6208}
  out_2: {body: output, position: [0, 0, 180 mm], designation: 6208}
meshes:
  stage: {gears: [pinion, wheel], center_distance: 90 mm}
loads:
  drive: {body: motor, torque: 100 N m}
  brake: {body: machine, torque: balance}
load_cases:
  rated: {speed: {motor: 1500 rpm}, loads: {drive: {power: 10 kW}}, load_duration_fraction: 60 %}
  peak: {speed: {motor: 1500 rpm}, loads: {drive: {torque: 90 N m}}, load_duration_fraction: 40 %}
scenarios:
  up: {sweep: {body: motor, speed: [600 rpm, 1800 rpm], points: 3}}
"""
HOUSING = """\
housing:
  type: stiffness_matrix
  stiffness_file: housing.csv
  nodes: [in_1, in_2, out_1, out_2]
"""


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("center_distance: 90 mm", "center_distance: '90'", ["meshes.stage.center_distance"]),
        ("direction: 0 deg", "", []),
        ("torque: 100 N m", "power: 100 W", ["loads.drive.power"]),
        ("{body: motor, torque: 100", "{body: motr, torque: 100", ["loads.drive.body"]),
        ("fraction: 60 %", "fraction: 70 %", ["load_cases"]),
        ("peak: {speed: {motor: 1500 rpm}", "peak: {speed: {motor: 1500 rpm, machine: 900 rpm}", None),
    ],
)
def test_a_mistake_has_one_message(old, new, expected):
    with_direction = GEARBOX.replace("center_distance: 90 mm}", "center_distance: 90 mm, direction: 0 deg}")
    text = with_direction.replace(old, new)
    if expected == []:
        loads_model(text)
        return
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    places = [problem.where for problem in caught.value.problems]
    assert places == (expected or ["load_cases.peak.speed.machine"])


def test_messages_have_the_words_of_the_file():
    """Speeds in rpm as written, the sum of the shares, the key that was meant, no seats among the bodies."""

    def message(old: str, new: str, more: str = "") -> str:
        """Messages on the gearbox with one change."""
        with pytest.raises(ModelError) as caught:
            loads_model(GEARBOX.replace(old, new) + more)
        return str(caught.value)

    two = "peak: {speed: {motor: 1500 rpm}", "peak: {speed: {motor: 1500 rpm, machine: 900 rpm}"
    assert "900 rpm contradicts" in message(*two)
    assert "110 % is the sum of the shares of the time" in message("fraction: 60 %", "fraction: 70 %")
    assert "did you mean torque?" in message("torque: 100 N m", "power: 100 W")
    bodies = "there are input, machine, motor, output"
    assert bodies in message("body: motor, torque", "body: motr, torque", HOUSING)
    apart = "[0, 0, 0]}\n  machine", "[0, 0, -40 mm]}\n  machine"
    assert "a coupling without position is at the origin of motor" in message(*apart)
    commas = "parameters: {gear: {value: 1, text: selected gear, 0 neutral}}\nmaterials:"
    assert "within {...} a text with commas needs quotes" in message("materials:", commas)


def test_nodes_of_a_housing_that_do_not_exist_are_named_once(tmp_path):
    np.savetxt(tmp_path / "housing.csv", 1e8 * np.eye(24), delimiter=",")
    (tmp_path / "model.yaml").write_text(GEARBOX + HOUSING.replace("in_2", "in_3"))
    with pytest.raises(ModelError) as caught:
        load_model(tmp_path / "model.yaml")
    words = str(caught.value)
    assert "has no position" not in words and "'in_3'" in words


def test_a_mass_matrix_without_mass_is_refused(tmp_path):
    """A stiffness matrix as mass: the masses of its rows cancel, and are not those of a body."""
    K = np.kron(np.diag([2.0, 3.0, 4.0, 5.0]), np.eye(6)) * 1e8
    np.savetxt(tmp_path / "housing.csv", K, delimiter=",")
    M = np.kron(np.array([[2, -1, 0, -1], [-1, 2, -1, 0], [0, -1, 2, -1], [-1, 0, -1, 2]]), np.eye(6)) * 1e8
    np.savetxt(tmp_path / "mass.csv", M, delimiter=",")
    text = GEARBOX + HOUSING + "  mass_file: mass.csv\n"
    (tmp_path / "model.yaml").write_text(text)
    with pytest.raises(ModelError, match="has a mass of"):
        housing_matrices(load_model(tmp_path / "model.yaml"))
    np.savetxt(tmp_path / "mass.csv", np.kron(np.eye(4), np.diag([3, 3, 3, 0.1, 0.1, 0.1])), delimiter=",")
    assert housing_matrices(load_model(tmp_path / "model.yaml")).weighed


def test_a_modulus_of_another_unit_is_named():
    text = GEARBOX.replace("170 GPa", "170 MPa")
    (found,) = [m for m in remarks_of_file(loads_model(text)) if "materials" in m.where]
    assert found.where == "materials.cast.youngs_modulus"
    assert "170 MPa is below that of plastics" in found.text


def test_a_sweep_of_a_motor_has_the_mesh_of_its_shaft():
    """20 mesh periods per revolution of the motor, which has no gear."""
    model = loads_model(GEARBOX)
    system = compile_model(model, "up")
    assert sweep_orders(system, model.scenarios["up"])[1]["stage"] == pytest.approx(20.0)
    with pytest.raises(ModelError, match="is not coupled to a body with one"):
        loads_model(
            GEARBOX.replace("  flange: {bodies: [motor, input], stiffness: {torsion: 5e3 N m/rad}}\n", "")
        )


def test_an_idler_off_its_shaft_gets_the_angle_of_its_mesh():
    """Its mesh places it at 0 deg of the layshaft; the remedy is the direction of the mesh."""
    teeth = "normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0"
    text = GEARBOX
    for old, new in (
        ("  machine:", "  idler: {gears: [third], motion: free}\n  machine:"),
        (
            "shafts:",
            f"  third: {{number_of_teeth: 20, {teeth}}}\n  lay: {{number_of_teeth: 40, {teeth}}}\nshafts:",
        ),
        ("gears: {pinion: 100 mm}", "gears: {pinion: 100 mm}, markers: {seat: {position: [0, 0, 150 mm]}}"),
        ("gears: {wheel: 100 mm}", "gears: {wheel: 100 mm, lay: 150 mm}"),
        ("  stage:", "  idle: {gears: [lay, third], center_distance: 90 mm}\n  stage:"),
    ):
        text = text.replace(old, new)
    text += "bearings: {needle: {body: idler, housing: input.seat, stiffness: {radial: 1e8}}}\n"
    with pytest.raises(ModelError, match="give meshes.idle.direction"):
        loads_model(text)
    loads_model(text.replace("[lay, third],", "[lay, third], direction: 180 deg,"))
