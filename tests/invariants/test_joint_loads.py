# SPDX-License-Identifier: Apache-2.0
"""What the joint of a gear carries: friction of the joint and load sensors against the statics of one gear.

A gear on a pin of radius r with the torque T is held by the base-tangent force F at its base radius r_b and
by the friction mu r F of its pin, which the force across the axis loads: T = F (r_b + mu r). The pin puts on
the gear what the flanks take: F sin(alpha_t) along the line of centres, F cos(alpha_t) across it.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model

TORQUE, MU, RADIUS = 171.43, 0.05, 0.02
PIN = "friction: {coefficient: 0.05, radius: 20 mm, slip_speed: 0.01 mm/s}"
SENSORS = "".join(f"  f{k}: {{type: load, at: driver, axis: {k}}}\n" for k in "xyz")
CASES = {
    "spur": (0.0, 45, "", 112.5),
    "helical": (20.0, 45, "", 112.5 / math.cos(math.radians(20.0))),
    "internal": (0.0, 75, ", type: internal", -67.5),
}


def text(beta, z, kind, offset, mesh=""):
    gear = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    hands = ("right", "left") if beta else ("", "")
    helix = [f", helix_angle: {beta} deg, hand: {hand}" if hand else "" for hand in hands]
    return (
        f"gears:\n  a: {{number_of_teeth: 30, {gear}{helix[0]}}}\n"
        f"  b: {{number_of_teeth: {z}, {gear}{helix[1]}{kind}}}\n"
        "bodies:\n  driver: {gears: [a], inertia: 0.002 kg m^2, position: [0, 0, 0]}\n"
        f"  driven: {{gears: [b], motion: torsion, inertia: 0.01 kg m^2, position: [{offset!r} mm, 0, 0]}}\n"
        f"joints:\n  pin: {{type: revolute, bodies: [ground, driver], {PIN}}}\n"
        f"meshes:\n  stage: {{gears: [a, b], stiffness: {{law: constant, value: 4e8 N/m}}{mesh}}}\n"
        f"sensors:\n{SENSORS}"
        f"loads:\n  in: {{body: driver, torque: {TORQUE} N m}}\n  out: {{body: driven, torque: balance}}\n"
    )


@pytest.mark.parametrize("case", CASES)
def test_friction_and_sensors_see_the_whole_mesh_force(case):
    beta, z, _, offset = CASES[case]
    system = compile_model(loads_model(text(*CASES[case])))
    ratio = -30.0 / z if offset > 0.0 else 30.0 / z
    found = solve_equilibrium(system, speeds={"driver": 50.0, "driven": 50.0 * ratio})
    alpha = math.atan(math.tan(math.radians(20.0)) / math.cos(math.radians(beta)))
    beta_b = math.asin(math.sin(math.radians(beta)) * math.cos(math.radians(20.0)))
    r_b = 0.5 * 30 * 3e-3 / math.cos(math.radians(beta)) * math.cos(alpha)
    force = TORQUE / (r_b + MU * RADIUS)
    assert float(found["mesh_force[stage]"]) == pytest.approx(force, rel=1e-9)
    assert float(found["friction_torque[pin]"]) == pytest.approx(-MU * RADIUS * force, rel=1e-9)
    assert float(found["signal[fx]"]) == pytest.approx(force * math.sin(alpha), rel=1e-6)
    assert abs(float(found["signal[fy]"])) == pytest.approx(force * math.cos(alpha), rel=1e-6)
    assert abs(float(found["signal[fz]"])) == pytest.approx(force * math.tan(beta_b), rel=1e-6, abs=1e-9)


def test_the_short_cut_is_taken_where_no_joint_is_read():
    """Gears that only spin need one torque each, unless friction of a joint or a sensor reads its load."""
    plain = text(*CASES["spur"]).replace(f", {PIN}", "").replace(f"sensors:\n{SENSORS}", "")
    marked = plain.replace("motion: torsion,", "motion: torsion, markers: {rim: {position: [1 mm, 0, 0]}},")
    sensed = f"{marked}sensors:\n  f: {{type: load, at: driven.rim, axis: x}}\n"
    for given, fixed in ((plain, 1), (sensed, 0)):
        system = compile_model(loads_model(given))
        assert system.records["gear_mesh"]["fixed"].tolist() == [fixed]


def test_a_bevel_gear_loads_its_joint():
    """Straight teeth: F_r = F_t tan(alpha) cos(delta), F_a = F_t tan(alpha) sin(delta) at the mean cone.

    2 %: contact lines and their centroid move about the mean pitch cone.
    """
    gear = "outer_transverse_module: 4 mm, face_width: 12 mm, normal_pressure_angle: 20 deg"
    text = (
        f"bevel_gears:\n  a: {{number_of_teeth: 17, mate_teeth: 43, {gear}}}\n"
        f"  b: {{number_of_teeth: 43, mate_teeth: 17, {gear}}}\n"
        "bodies:\n  driver: {bevel_gears: [a], position: [0, 0, 0], axes: {z: [1, 0, 0], x: [0, 0, 1]},\n"
        "    mass: 1 kg, inertia: 0.002 kg m^2, transverse_inertia: 0.002 kg m^2}\n"
        "  driven: {bevel_gears: [b], motion: torsion, inertia: 0.01 kg m^2, position: [0, 0, 0]}\n"
        "joints:\n  pin: {type: revolute, bodies: [ground, driver], axes: {z: [1, 0, 0], x: [0, 0, 1]},\n"
        f"    {PIN}}}\n"
        "bevel_meshes:\n  stage: {gears: [a, b], stiffness: {law: constant, value: 4e8 N/m}}\n"
        f"sensors:\n{SENSORS.replace('axis', 'seen_from: driver, axis')}"
        f"loads:\n  in: {{body: driver, torque: {TORQUE} N m}}\n  out: {{body: driven, torque: balance}}\n"
    )
    speeds = {"driver": 50.0, "driven": -50.0 * 17 / 43}
    found = solve_equilibrium(compile_model(loads_model(text)), speeds=speeds)
    radial, axial = (
        math.hypot(float(found["signal[fx]"]), float(found["signal[fy]"])),
        abs(float(found["signal[fz]"])),
    )
    friction = float(found["friction_torque[pin]"])
    assert friction == pytest.approx(-MU * RADIUS * radial, rel=1e-9)
    delta, alpha = math.atan2(17, 43), math.radians(20.0)
    tangential = (TORQUE + friction) / (0.5 * 17 * 4e-3 - 6e-3 * math.sin(delta))
    assert radial == pytest.approx(tangential * math.hypot(1.0, math.tan(alpha) * math.cos(delta)), rel=0.02)
    assert axial == pytest.approx(tangential * math.tan(alpha) * math.sin(delta), rel=0.02)
