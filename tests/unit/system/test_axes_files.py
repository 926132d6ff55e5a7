# SPDX-License-Identifier: Apache-2.0
"""Gears, shafts and loads along any axis in model files: inherited axes, trains that cross, refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.model.frames import body_frame
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.gear_trains import free_spins, mesh_rates
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.turned_world import about

TEETH = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
GEARS = "gears:\n" + "".join(
    f"  {name}: {{number_of_teeth: {z}, {TEETH}}}\n"
    for name, z in (("a", 20), ("b", 40), ("c", 30), ("d", 45))
)
SPUR = """\
bodies:
  one: {gears: [a], position: [1, 2, 3], axes: {z: [3, 0, 0]}}
  two: {gears: [b], markers: {tip: {position: [0, 10 mm, 0]}}}
meshes: {stage: {gears: [a, b], direction: 90 deg, stiffness: {law: constant, value: 4e8}}}
"""
CROSSED = """\
bodies:
  one: {gears: [a], position: [0, 0, 0], axes: {z: [1, 0, 0], x: [0, 1, 0]}}
  two: {gears: [b], position: [0, 90 mm, 0]}
  three: {gears: [c], position: [0, 90 mm, 0], axes: {z: [COS, SIN, 0]}}
  four: {gears: [d]}
meshes:
  first: {gears: [a, b], stiffness: {law: constant, value: 4e8}}
  second: {gears: [c, d], direction: 90 deg, stiffness: {law: constant, value: 4e8}}
loads:
  motor: {body: one, torque: 30 N m}
  brake: {body: four, torque: balance}
"""
"""Gear 1 turns about x, gears 3 and 4 about an axis in the plane of x and y."""
ANGLE = math.radians(10.0)


def crossed(angle, rest):
    """Two trains whose axes stand at an angle, and what joins them."""
    text = GEARS + CROSSED.replace("COS", repr(math.cos(angle))).replace("SIN", repr(math.sin(angle)))
    return loads_model(text + rest)


def test_bodies_in_mesh_share_the_axes_that_one_of_them_gives():
    model = loads_model(GEARS.replace("  c", "  #").replace("  d", "  #") + SPUR)
    frame = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])  # x as near to y as z allows
    for body in ("one", "two"):
        np.testing.assert_array_equal(body_frame(model, body)[1], frame)
    # 90 degrees from the x axis of the body, which is y of the world, towards z of the world
    assert model.bodies["two"].origin == pytest.approx((1.0, 2.0, 3.09), abs=1e-15)
    assert model.bodies["two"].axes is None  # nothing is written that was not given
    again = loads_model(dump_model(model))
    assert again.bodies["two"].origin == model.bodies["two"].origin
    upright = model.replace("bodies.one.axes", None)
    assert upright.bodies["two"].orientation is None
    assert upright.bodies["two"].origin == pytest.approx((1.0, 2.09, 3.0), abs=1e-15)


def test_a_twist_of_the_body_turns_what_counts_from_its_x_axis():
    model = loads_model(GEARS + SPUR)
    turned = model.replace("bodies.two.axes", {"z": [1, 0, 0], "x": [0, 0, 1]})
    assert turned.meshes["stage"].twist == pytest.approx(0.5 * math.pi)
    moved = turned.phasing.tooth_angle["b"] - model.phasing.tooth_angle["b"]
    # the teeth stay where they are: to a pitch the angle is a quarter turn less
    assert math.remainder(moved + 0.5 * math.pi, math.tau / 40) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(
    ("axes", "words"),
    [
        ("{z: [-1, 0, 0]}", "have opposite z axes"),
        ("{z: [1, 0.1, 0]}", "5.71059 deg apart"),
        ("{z: [0, 0, 1]}", "90 deg apart"),
    ],
)
def test_axes_in_mesh_must_be_parallel(axes, words):
    with pytest.raises(ModelError) as caught:
        loads_model(GEARS + SPUR.replace("gears: [b],", f"gears: [b], axes: {axes},"))
    (problem,) = caught.value.problems
    assert (problem.where, problem.line, problem.value) == ("meshes.stage.gears", 9, "a and b")
    assert words in problem.text
    assert "one" in problem.remedy and "two" in problem.remedy


def test_the_axis_of_the_joint_is_asked_of_the_body():
    text = GEARS + (
        "bodies:\n  one: {gears: [a], position: [0, 0, 0]}\n  two: {gears: [b]}\n"
        "joints: {pin: {type: revolute, bodies: [ground, one], axes: {z: [1, 0, 0]}}}\n"
        "meshes: {stage: {gears: [a, b]}}\n"
    )
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    (problem,) = caught.value.problems
    assert (problem.where, problem.line) == ("bodies.one.gears", 7)
    assert "axes with z along it" in problem.remedy
    fine = loads_model(text.replace("position: [0, 0, 0]}", "position: [0, 0, 0], axes: {z: [1, 0, 0]}}"))
    assert fine.bodies["two"].orientation == fine.bodies["one"].axes


def test_places_on_a_shaft_count_along_its_axis():
    text = GEARS + (
        "shafts:\n"
        "  s: {sections: [{length: 100 mm, diameter: 30 mm}], gears: {a: 40 mm}, position: [10 mm, 0, 0],\n"
        "    axes: {z: [0, -1, 0]}}\n"
        "bodies: {two: {gears: [b]}}\n"
        "meshes: {stage: {gears: [a, b], stiffness: {law: constant, value: 4e8}}}\n"
        "loads: {pull: {body: s, force: [1 N, 2 N, 3 N], position: [0, 0, 70 mm]}}\n"
        "bearings: {one: {body: s, position: [0, 0, 20 mm], stiffness: {radial: 1e8}}}\n"
    )
    model = loads_model(text)
    assert model.stations["s"] == pytest.approx((0.0, 0.02, 0.04, 0.07, 0.1))
    assert model.bodies["two"].origin == pytest.approx((0.1, -0.04, 0.0))
    system = compile_model(model)
    last = system.bodies[system.layout.bodies.index("s.5") - 1]
    assert last.position == pytest.approx((0.01, -0.1, 0.0))
    assert system.layout.bodies[system.records["force"]["i"][0]] == "s.4"
    with pytest.raises(ModelError) as caught:
        loads_model(text.replace("70 mm", "170 mm"))
    (problem,) = caught.value.problems
    assert (problem.where, problem.value, problem.line) == ("loads.pull.position", "170 mm", 11)


UNIVERSAL = f"""\
joints:
  shaft: {{type: revolute, bodies: [ground, three],
    axes: {{z: [{math.cos(ANGLE)!r}, {math.sin(ANGLE)!r}, 0]}}}}
  cross: {{type: universal, bodies: [two, three], position: [0, 90 mm, 0], cut: true,
    axes: {{z: [{-math.cos(ANGLE)!r}, {-math.sin(ANGLE)!r}, 0], x: [0, 0, 1]}}}}
scenarios:
  run: {{drive: {{one: {{speed: 100 rad/s}}}}, duration: 0.15 s, step: 20 us, settle_time: 0 s,
    start: assembled}}
"""


def test_two_trains_joined_by_a_universal_joint():
    """Cardan: the driving pin stands across the plane of the shafts: tan phi2 = cos(a) tan phi1."""
    model = crossed(ANGLE, UNIVERSAL)
    run = solve_time(compile_model(model, "run"))
    first, second = run["angle[two]"].values, run["angle[three]"].values
    assert abs(first).max() > 2.0 * math.pi
    ideal = np.arctan2(math.cos(ANGLE) * np.sin(first), np.cos(first))
    # within the closure of the loop at each step
    np.testing.assert_allclose(np.unwrap(ideal), second, atol=1e-8)


@pytest.mark.parametrize("begin", ["start: assembled", "start: equilibrium"])
def test_trains_beyond_a_universal_joint_start_at_their_speed(begin):
    model = crossed(ANGLE, UNIVERSAL.replace("start: assembled", begin).replace("0.15 s", "5 ms"))
    run = solve_time(compile_model(model, "run"))
    start = {body: run[f"speed[{body}]"].values[0] for body in ("one", "two", "three", "four")}
    behind = -50.0 * math.cos(ANGLE)
    assert start == pytest.approx(
        {"one": 100.0, "two": -50.0, "three": behind, "four": -behind / 1.5}, rel=1e-6
    )
    # no blow of teeth: the mesh swings about its load, 60 N m / cos(angle), by no more than that once more
    force = abs(run["mesh_force[second]"].values) * 0.045 * math.cos(math.radians(20.0))
    assert force.max() < 2.1 * 60.0 / math.cos(ANGLE)


def test_torques_of_two_trains_joined_by_a_universal_joint():
    """In that position the second shaft takes 1/cos(a) of the torque of the first: the power is the same."""
    model = crossed(ANGLE, UNIVERSAL.replace("drive: {one: {speed: 100 rad/s}}", "hold: [one]"))
    rest = solve_equilibrium(compile_model(model))
    # 30 N m on a are 60 N m on b; c passes on three halves, and d turns as a does
    assert rest["torque[brake]"].item() == pytest.approx(-30.0 * 2.0 / math.cos(ANGLE) * 1.5, rel=1e-6)
    for mesh, radius, torque in (("first", 0.03, 30.0), ("second", 0.045, 60.0 / math.cos(ANGLE))):
        force = abs(rest[f"mesh_force[{mesh}]"].item())
        assert force * radius * math.cos(math.radians(20.0)) == pytest.approx(torque, rel=1e-6)


BEVEL = """\
ratios: {bevel: {terms: {two: 17, three: 34}}}
scenarios:
  run: {speed: {one: 100 rad/s}, duration: 10 ms, step: 2 us, settle_time: 0 s}
"""


def test_two_trains_at_a_right_angle_joined_by_a_ratio():
    model = crossed(0.5 * math.pi, BEVEL)
    system = compile_model(model, "run")
    speeds = model.start_speeds("run")
    assert speeds == pytest.approx({"one": 100.0, "two": -50.0, "three": 25.0, "four": -50.0 / 3.0})
    assert len(free_spins(system)) == 1
    assert mesh_rates(system, speeds) == pytest.approx([2000.0, 750.0])
    run = solve_time(system)
    brake = run["torque[brake]"].values
    np.testing.assert_allclose(brake, 30.0 * 6.0, rtol=1e-7)  # as near as the equilibrium
    power = 30.0 * run["speed[one]"].values + brake * run["speed[four]"].values
    # what the loads bring in goes out again; the teeth swing in by less than a thousandth
    assert abs(power.mean()) < 1e-3 * 3000.0
    np.testing.assert_allclose(run["speed[three]"], -0.5 * run["speed[two]"], rtol=1e-8)


HOUSING = """\
bodies:
  housing: {mass: 20 kg, inertia_tensor: [1, 1, 1, 0, 0, 0], position: [0, 0, 0], axes: {z: [0, 1, 0]}}
  one: {gears: [a], position: [0, 0, 0], axes: {z: [1, 0, 0]}}
  two: {gears: [b]}
joints:
  pivot: {type: revolute, bodies: [ground, housing], position: [0, 0, 0], axes: {z: [0, 1, 0]}}
  in: {type: revolute, bodies: [housing, one], axes: {z: [1, 0, 0]}}
  out: {type: revolute, bodies: [housing, two], axes: {z: [1, 0, 0]}}
meshes: {stage: {gears: [a, b], stiffness: {law: constant, value: 4e8}, damping: {ratio: 0.05}}}
loads:
  motor: {body: one, torque: 20 N m, reaction: housing}
  brake: {body: two, torque: balance, reaction: housing}
torsion_springs: {mount: {bodies: [housing], stiffness: 2e4 N m/rad, damping: 20 N m s/rad}}
scenarios:
  run: {speed: {one: 100 rad/s}, duration: 60 ms, step: 5 us, settle_time: 0 s}
  rock: {speed: {one: 100 rad/s}, drive: {housing: {speed: 40 rad/s}}, duration: 200 ms, step: 5 us,
    settle_time: 0 s}
"""


def test_a_train_on_a_housing_that_turns_about_another_axis():
    """The housing takes both gears along: teeth, ratio and mesh phase know nothing of its turn."""
    model = loads_model(GEARS + HOUSING)
    assert model.start_speeds("rock")["two"] == pytest.approx(-50.0)
    system = compile_model(model, "rock")
    assert mesh_rates(system, model.start_speeds("rock")) == pytest.approx([2000.0])
    still, rocking = (solve_time(compile_model(model, name)) for name in ("run", "rock"))
    assert abs(rocking["angle[housing]"].values).max() == pytest.approx(8.0)  # more than a turn
    n = still.sizes["time"]
    for name in ("mesh_phase[stage]", "contact_state[stage]", "torque[brake]"):
        np.testing.assert_allclose(rocking[name].values[:n], still[name].values, atol=1e-6)
    assert rocking["torque[brake]"].values[0] == pytest.approx(40.0)
    # revolute joints take the gyroscopic moments, and none of them acts about the axes of the gears
    np.testing.assert_allclose(rocking["mesh_force[stage]"].values[:n], still["mesh_force[stage]"], rtol=1e-4)
    # without the drive the moment of both rotors turns the housing about no axis but its own
    assert abs(still["angle[housing]"].values).max() < 1e-9


RINGS = """\
bodies:
  housing: {motion: fixed, position: [0, 0, 0], markers: {seat: {HERE}}}
  rotor: {motion: free, mass: 2 kg, inertia: 2e-3, transverse_inertia: 2e-3, position: [0, 0, 0],
    axes: {z: [1, 0, 0]}}
rolling_bearings:
  groove: {ends: [rotor, OUTER], type: ball, elements: 9, element_diameter: 10 mm, pitch_diameter: 60 mm,
    stiffness: 1e10}
plain_bearings: {bush: {ends: [rotor, OUTER], clearance: 20 um, stiffness: 1e8}}
bearings: {soft: {body: rotor, stiffness: {radial: 1e6, axial: 1e6, tilt: 1e4, torsion: 100}}}
loads: {weight: {body: rotor, force: [0, 0, -1000]}}
"""


def test_rings_stand_about_one_axis():
    with pytest.raises(ModelError) as caught:
        loads_model(RINGS.replace("OUTER", "housing.seat").replace("HERE", ""))
    assert [p.where for p in caught.value.problems] == [
        "rolling_bearings.groove.ends",
        "plain_bearings.bush.ends",
    ]
    assert [p.line for p in caught.value.problems] == [6, 8]
    assert "90 deg apart" in caught.value.problems[0].text


def test_bearings_along_another_axis_carry_the_same():
    """The rotor and its bearings along x against the same along z, the load turned with them."""
    there = RINGS.replace("OUTER", "housing.seat").replace("HERE", "axes: {z: [1, 0, 0], x: [0, 1, 0]}")
    here = (
        RINGS.replace("OUTER", "housing.seat").replace("HERE", "").replace("axes: {z: [1, 0, 0]}", "axes: {}")
    )
    here = here.replace("[0, 0, -1000]", "[0, -1000, 0]")
    ground = RINGS.replace("OUTER", "ground").replace("HERE", "axes: {z: [1, 0, 0], x: [0, 1, 0]}")
    rests = [solve_equilibrium(compile_model(loads_model(text))) for text in (there, here)]
    for name in rests[0]:
        if "[" in name:
            np.testing.assert_allclose(rests[0][name].item(), rests[1][name].item(), rtol=1e-9, atol=1e-9)
    with pytest.warns(match="is not used"):  # on ground the rings have the axes of the rotor
        grounded = solve_equilibrium(compile_model(loads_model(ground)))
    for name in ("groove", "bush"):
        radial = f"bearing_force[{name}.radial]"
        assert grounded[radial].item() == pytest.approx(rests[0][radial].item(), rel=1e-9)


def test_turned_frames_agree_with_turned_places():
    """Axes tilted by 5 degrees, as of a wind turbine: the wheel lies where the tilted plane has it."""
    R = about([0.0, 1.0, 0.0], math.radians(5.0))
    z, x = R[:, 2].tolist(), R[:, 0].tolist()
    model = loads_model(GEARS + SPUR.replace("{z: [3, 0, 0]}", f"{{z: {z}, x: {x}}}"))
    expected = np.array([1.0, 2.0, 3.0]) + R @ [0.0, 0.09, 0.0]
    np.testing.assert_allclose(model.bodies["two"].origin, expected, atol=1e-15)


TURNING = """\
bodies:
  one: {motion: torsion, inertia: 0.1, position: [0, 0, 0]}
  two: {motion: torsion, inertia: 0.1, position: [0, 0, 0], axes: {z: AXIS}}
torsion_springs: {spring: {bodies: [one, two], stiffness: 10}}
torsion_maxwells: {oil: {bodies: [one, two], stiffness: 10, damping: 1}}
clutches: {disc: {bodies: [one, two], capacity: 5}}
"""


@pytest.mark.parametrize(("axis", "angle"), [("[1, 0, 1]", "45"), ("[0, 0, -1]", "180")])
def test_turning_elements_act_about_one_axis(axis, angle):
    """The angle between two bodies about crossed axes is no function of where they are."""
    with pytest.raises(ModelError) as caught:
        loads_model(TURNING.replace("AXIS", axis))
    assert [(p.where, p.line) for p in caught.value.problems] == [
        ("torsion_springs.spring.bodies", 4),
        ("torsion_maxwells.oil.bodies", 5),
        ("clutches.disc.bodies", 6),
    ]
    assert all(f"{angle} deg apart" in p.text for p in caught.value.problems)
    loads_model(TURNING.replace("AXIS", "[0, 0, 1]"))
