# SPDX-License-Identifier: Apache-2.0
"""Self-aligning, double-row, thrust and needle bearings, and flanges of cylindrical rollers, in models."""

from __future__ import annotations

import math

import pytest
from scipy.special import beta

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

ROTOR = """\
bodies:
  rotor: {motion: free, mass: 2 kg, inertia: 2e-3, transverse_inertia: 2e-3, position: [0.1, 0, 0],
    axes: {z: AXIS}}
loads: {weight: {body: rotor, force: FORCE, along: world}}
bearings: {turning: {body: rotor, stiffness: HELD}}
rolling_bearings:
"""


def model(bearings, force="[0, 0, 0]", axis="[0, 0, 1]", held="{torsion: 100}"):
    text = ROTOR.replace("FORCE", force).replace("AXIS", axis).replace("HELD", held)
    return loads_model(text + bearings)


def rest(bearings, **more):
    """Equilibrium of a rotor: values by channel, and the record of its bearings."""
    system = compile_model(model(bearings, **more))
    found = solve_equilibrium(system)
    return {name: found[name].item() for name in found if "[" in name}, system.records["rolling_bearing"]


def test_radial_stiffness_of_a_self_aligning_ball_bearing():
    """F = i Z K cos(a) (x cos(a))^1.5 J with J = the mean of cos^2.5 over the loaded half, 0.2288 (Sjovall).

    The rotor is held against tilting by a linear bearing, which carries no moment.
    """
    seen, (record,) = rest(
        "  a: {body: rotor, designation: 1308, clearance: 0}\n",
        force="[900 N, 0, 0]",
        held="{torsion: 100, tilt: 1e4, axial: 1e6}",
    )
    share = beta(1.75, 0.5) / math.tau
    assert share == pytest.approx(0.2288, abs=1e-4)
    flat = math.cos(float(record["angle"]))
    x = seen["displacement[rotor.x]"]
    force = 2 * record["n"] * record["stiffness"] * flat * (x * flat) ** 1.5 * share
    assert force == pytest.approx(900.0, rel=3e-3)
    assert seen["bearing_force[a.radial]"] == pytest.approx(900.0, rel=1e-6)


@pytest.mark.parametrize("designation", ["1308", "22208"])
def test_self_aligning_bearings_do_not_resist_tilting(designation):
    """Two of them hold a shaft as hinges: forces by the lever rule, no moments."""
    text = (
        f"  low: {{body: rotor, position: [0, 0, -60 mm], designation: {designation}}}\n"
        f"  high: {{body: rotor, position: [0, 0, 30 mm], designation: {designation}, "
        "axial_force_absorption: no_direction}\n"
    )
    seen, _ = rest(text, force="[900 N, 0, 100 N]")
    assert seen["bearing_force[low.fx]"] == pytest.approx(-300.0, rel=2e-3)
    assert seen["bearing_force[high.fx]"] == pytest.approx(-600.0, rel=2e-3)
    assert seen["bearing_force[low.axial]"] == pytest.approx(-100.0, rel=1e-4)
    for name in ("low", "high"):
        for moment in ("mx", "my"):
            assert abs(seen[f"bearing_force[{name}.{moment}]"]) < 1e-3


@pytest.mark.parametrize("axis", ["[0, 0, 1]", "[0, 1, 0]", "[0, 0, -1]"])
def test_a_double_row_bearing_is_two_single_ones(axis):
    """3208 against two rows of its balls at the distance of its rows, in O arrangement, under forces."""
    whole, (record,) = rest(
        "  a: {body: rotor, designation: 3208, clearance: -20 um}\n", force="[800 N, 300 N, 500 N]", axis=axis
    )
    e = float(record["offset"])
    found = model("  a: {body: rotor, designation: 3208}\n").rolling_bearings["a"].geometry
    assert found.row_distance == pytest.approx(2.0 * e)
    row = (
        f"{{body: rotor, type: ball, elements: {found.elements}, element_diameter: {found.element_diameter}, "
        f"pitch_diameter: {found.pitch_diameter}, grooves: [0.52, 0.53], clearance: -20 um, "
    )
    parts, _ = rest(
        f"  low: {row}position: [0, 0, {-e}], contact_angle: 25 deg}}\n"
        f"  high: {row}position: [0, 0, {e}], contact_angle: -25 deg}}\n",
        force="[800 N, 300 N, 500 N]",
        axis=axis,
    )
    for name in ("fx", "fy", "fz"):
        both = sum(parts[f"bearing_force[{part}.{name}]"] for part in ("low", "high"))
        assert whole[f"bearing_force[a.{name}]"] == pytest.approx(both, abs=1e-3)
    for name in "xyz":
        # the balls of the second row are half a spacing further in the double-row bearing
        assert whole[f"displacement[rotor.{name}]"] == pytest.approx(
            parts[f"displacement[rotor.{name}]"], rel=0.03, abs=2e-8
        )


def test_tilting_of_a_double_row_bearing():
    """Linear tilt stiffness about the centre, i Z/2 k (e cos(a) + d_m/2 sin(a))^2, k of one preloaded ball.

    The lever is half the distance of the pressure centres times cos(a). With preload all balls carry; k is
    the slope of K d^1.5, and the turning of the contact angle adds the load over the distance of the grooves.
    """
    preload = 40e-6
    system = compile_model(model(f"  a: {{body: rotor, designation: 3208, clearance: {-preload}}}\n"))
    (record,) = system.records["rolling_bearing"]
    ca, sa = math.cos(record["angle"]), math.sin(record["angle"])
    A = record["grooves"]
    p, q = A * ca + 0.5 * preload, A * sa
    reach = math.hypot(p, q)
    one = record["stiffness"] * (reach - A) ** 1.5
    ca, sa = p / reach, q / reach
    e, half = record["offset"], 0.5 * record["pitch"]
    along = 1.5 * one / (reach - A) * (e * ca + half * sa) ** 2
    across = one / reach * (half * ca - e * sa) ** 2
    expected = record["n"] * (along + across)  # two rows, mean of cos^2 = 1/2
    stiffness = evaluate.linearize(system, system.initial_state())[2]
    assert stiffness[3, 3] == pytest.approx(expected, rel=1e-6)
    assert stiffness[4, 4] == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(("designation", "balls"), [("51106", 17), ("51310", 13)])
def test_a_thrust_bearing(designation, balls):
    """F = Z K x^1.5 towards its side; nothing the other way, where the shaft lifts off."""
    held = "{torsion: 100, radial: 1e7, tilt: 1e4, axial: 1e3}"  # lifts off by 20 mm
    text = f"  a: {{body: rotor, designation: {designation}, axial_force_absorption: positive}}\n"
    seen, (record,) = rest(text, force="[0, 0, 2 kN]", held=held)
    z = seen["displacement[rotor.z]"]
    assert record["n"] == balls
    assert balls * record["stiffness"] * z**1.5 == pytest.approx(2000.0 - 1e3 * z, rel=1e-5)
    assert seen["bearing_force[a.axial]"] == pytest.approx(-2000.0, rel=1e-4)
    seen, _ = rest(text, force="[0, 0, -20 N]", held=held)
    assert seen["bearing_force[a.axial]"] == 0.0


def test_flanges_of_nj_and_nup():
    """NJ holds the shaft in one direction, NUP in both after half of its play; the shaft moves by F/k."""
    held = "{torsion: 100, radial: 1e7, tilt: 1e4, axial: 1}"
    common = "body: rotor, flange_stiffness: 2e8 N/m"
    for side, word in ((1.0, "positive"), (-1.0, "negative")):
        text = f"  a: {{{common}, designation: NJ 308 ECP, axial_force_absorption: {word}}}\n"
        seen, _ = rest(text, force=f"[0, 0, {side * 400} N]", held=held)
        assert seen["displacement[rotor.z]"] == pytest.approx(side * 2e-6, rel=1e-6)
        assert seen["bearing_force[a.axial]"] == pytest.approx(-side * 400.0, rel=1e-6)
        seen, _ = rest(text, force=f"[0, 0, {-side * 1e-3} N]", held=held)
        assert seen["bearing_force[a.axial]"] == 0.0
        text = f"  a: {{{common}, designation: NUP 308 ECP, axial_clearance: 100 um}}\n"
        seen, _ = rest(text, force=f"[0, 0, {side * 400} N]", held=held)
        assert seen["displacement[rotor.z]"] == pytest.approx(side * 52e-6, rel=1e-6)
    found = model("  a: {body: rotor, designation: NUP 308}\n").rolling_bearings["a"].geometry
    assert found.axial_clearance == pytest.approx(101e-6)  # middle of 47 to 155 um


def test_a_needle_bearing_floats():
    """Radial load: F = Z K x^(10/9) J of a line contact without profile (one slice); no axial force."""
    seen, (record,) = rest(
        "  a: {body: rotor, designation: NA4905, clearance: 0, slices: 1}\n",
        force="[1 kN, 0, 300 N]",
        held="{torsion: 100, axial: 1e7}",
    )
    assert seen["bearing_force[a.axial]"] == 0.0
    assert seen["bearing_force[a.radial]"] == pytest.approx(1000.0, rel=1e-6)
    share = beta(0.5 * (19.0 / 9.0 + 1.0), 0.5) / math.tau  # mean of cos^(19/9) over the loaded half
    uniform = record["n"] * record["stiffness"] * seen["displacement[rotor.x]"] ** (10.0 / 9.0) * share
    assert uniform == pytest.approx(1000.0, rel=3e-3)


@pytest.mark.parametrize(
    ("keys", "where", "message"),
    [
        (
            "designation: NJ 208",
            "axial_force_absorption",
            "is required for NJ 208; write positive or negative",
        ),
        (
            "designation: NUP 208, axial_force_absorption: positive",
            "axial_force_absorption",
            "NUP 208; write both",
        ),
        (
            "designation: NU 208, axial_clearance: 1 mm",
            "axial_clearance",
            "only to cylindrical roller bearings",
        ),
        (
            "designation: NA4905, axial_force_absorption: positive",
            "axial_force_absorption",
            "no flanges; remove",
        ),
        ("designation: 51106", "axial_force_absorption", "is required for thrust ball bearings"),
        (
            "designation: 51106, axial_force_absorption: positive, clearance: 1 um",
            "clearance",
            "does not apply to a thrust bearing",
        ),
        ("designation: 3206, preload: 100 N", "preload", "takes no axial preload"),
        ("type: self_aligning_ball, inner_diameter: 40 mm", "", "has no outer_diameter"),
        (
            "inner_diameter: 30 mm, width: 16 mm",
            "",
            "gives inner_diameter, width without type; add type (deep_gr",
        ),
    ],
)
def test_messages(keys, where, message):
    with pytest.raises(ModelError) as caught:
        model(f"  a: {{body: rotor, {keys}}}\n")
    (problem,) = caught.value.problems
    assert problem.where == ".".join(filter(None, ("rolling_bearings.a", where)))
    assert message in str(problem)
    assert problem.remedy


def test_a_bore_that_does_not_fit_the_shaft():
    """A 6308 on 30 mm (6306 meant), beside a shoulder where it fits; runs do not repeat the remark."""
    text = (
        "shafts: {s: {sections: [{length: 50 mm, diameter: 30 mm}, {length: 50 mm, diameter: 40 mm}], "
        "position: [0.1, 0, 0], axes: {z: [1, 0, 0]}}}\n"
        "rolling_bearings:\n"
        "  a: {body: s, position: [0, 0, 20 mm], designation: 6308}\n"
        "  b: {body: s, position: [0, 0, 80 mm], designation: 6308}\n"
        "  c: {body: s, position: [0, 0, 45 mm], designation: 6306, axial_force_absorption: no_direction}\n"
    )
    (found,) = remarks_of_file(loads_model(text))
    assert found.where == "rolling_bearings.a"
    assert "has a bore of 40 mm on a shaft of 30 mm diameter; correct the designation" in str(found)


@pytest.mark.parametrize("slices", [1, 21])
def test_an_o_arrangement_is_stiffer_in_tilting_than_an_x_arrangement(slices):
    """Closed form of one slice, Z k (e cos(a) +- d_m/2 sin(a))^2 for both bearings, k = P K d^(P-1).

    The load of each roller has no line of its own to turn with, so that there is no further term.
    """
    found = {}
    for first, second in (("positive", "negative"), ("negative", "positive")):
        keys = f"body: rotor, designation: 30208, preload: 800 N, slices: {slices}, axial_force_absorption"
        system = compile_model(
            model(
                f"  low: {{position: [0, 0, -30 mm], {keys}: {first}}}\n"
                f"  high: {{position: [0, 0, 30 mm], {keys}: {second}}}\n"
            )
        )
        record = system.records["rolling_bearing"][1]
        found[first] = evaluate.linearize(system, system.initial_state())[2][3, 3]
        if slices == 1:
            angle, P = abs(float(record["angle"])), float(record["exponent"])
            depth = 800.0 / record["n"] / math.sin(angle) / record["stiffness"]
            slope = P * record["stiffness"] * (depth ** (1.0 / P)) ** (P - 1.0)
            side = 1.0 if first == "positive" else -1.0
            lever = 0.03 * math.cos(angle) + side * 0.5 * record["pitch"] * math.sin(angle)
            assert found[first] == pytest.approx(record["n"] * slope * lever**2, rel=1e-3)
    assert found["positive"] > 2.0 * found["negative"]


PAIR = """\
gears:
  pinion: {number_of_teeth: 23, normal_module: 3 mm, face_width: 30 mm, helix_angle: 15 deg, hand: right,
    profile_shift_coefficient: 0.2}
  wheel: {number_of_teeth: 47, normal_module: 3 mm, face_width: 30 mm, helix_angle: 15 deg, hand: left,
    profile_shift_coefficient: 0.1}
shafts:
  input: {sections: [{length: 140 mm, diameter: 30 mm}], gears: {pinion: 70 mm}AXES}
  output: {sections: [{length: 140 mm, diameter: 40 mm}], gears: {wheel: 70 mm}}
meshes: {stage: {gears: [pinion, wheel]}}
gravity: [0, 0, -9.81]
loads: {motor: {body: input, torque: 200 N m}, brake: {body: output, torque: balance}}
rolling_bearings:
"""
WEIGHTS = {"input": 17.04, "output": 52.3}
"""Weights of the shafts with their gears as of `pitchpoint check` [N]."""


@pytest.mark.parametrize("axes", ["", ", position: [0, 0, 0], axes: {z: [1, 0, 0]}"])
@pytest.mark.parametrize(
    ("fixed", "floating"),
    [
        ("63{}", "NU 2{} E"),
        ("NUP 2{} E", "NU 2{} E"),
        ("32{}", "NA49{}"),
        ("12{}", "12{}, axial_force_absorption: no_direction"),
        ("222{}", "222{}, axial_force_absorption: no_direction"),
    ],
)
def test_bearing_forces_of_a_helical_pair(fixed, floating, axes):
    """Vertical and horizontal shafts: the axial force of the mesh and the weight are on the fixed bearing.

    Sums over both bearings of a shaft: T/r_b in the transverse plane of action, F_a = T/r_b tan(beta_b), and
    the weights.
    """
    text = PAIR.replace("AXES", axes)
    for shaft, size in (("input", "06"), ("output", "08")):
        for name, place, kind in (("fixed", 20, fixed), ("floating", 120, floating)):
            text += f"  {shaft}_{name}: {{body: {shaft}, position: [0, 0, {place} mm], "
            text += f"designation: {kind.format(size)}}}\n"
    seen = solve_equilibrium(compile_model(loads_model(text)))
    alpha_t = math.atan(math.tan(math.radians(20.0)) / math.cos(math.radians(15.0)))
    base_radius = 0.5 * 23 * 3e-3 / math.cos(math.radians(15.0)) * math.cos(alpha_t)
    normal = 200.0 / base_radius  # in the transverse plane of action
    axial = normal * math.tan(math.radians(15.0)) * math.cos(alpha_t)
    for shaft, sign in (("input", 1.0), ("output", -1.0)):
        weight = WEIGHTS[shaft]
        held = seen[f"bearing_force[{shaft}_fixed.axial]"].item()
        assert seen[f"bearing_force[{shaft}_floating.axial]"].item() == 0.0
        assert held == pytest.approx(-sign * axial + (0.0 if axes else weight), rel=2e-3)
        x, y = (
            sum(seen[f"bearing_force[{shaft}_{name}.{way}]"].item() for name in ("fixed", "floating"))
            for way in ("fx", "fy")
        )
        assert math.hypot(x, y) == pytest.approx(normal, abs=1e-3 * normal + (weight if axes else 0.0))
