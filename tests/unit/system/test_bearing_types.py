# SPDX-License-Identifier: Apache-2.0
"""Self-aligning, double-row, thrust and needle bearings, and flanges of cylindrical rollers, in models."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import beta

from pitchpoint.contact.rolling import POINT, Raceways
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.report.bearing_data import bearing_lines
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

ROTOR = """\
bodies:
  rotor: {motion: free, mass: 2 kg, inertia: 2e-3, transverse_inertia: 2e-3, position: [0.1, 0, 0],
    axes: {z: AXIS}}
loads: {weight: {body: rotor, force: FORCE, along: world, position: [0, 0, ABOVE]}}
bearings: {turning: {body: rotor, stiffness: HELD}}
rolling_bearings:
"""


def model(bearings, force="[0, 0, 0]", axis="[0, 0, 1]", held="{torsion: 100}", above="0 mm"):
    text = ROTOR.replace("FORCE", force).replace("AXIS", axis).replace("HELD", held).replace("ABOVE", above)
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
    """3208 against two rows of its balls at the distance of its rows, in O arrangement.

    The force is 40 mm above the centre: it displaces and tilts the shaft. An X arrangement tilts several
    times as much.
    """
    load = {"force": "[800 N, 300 N, 500 N]", "axis": axis, "above": "40 mm"}
    whole, (record,) = rest("  a: {body: rotor, designation: 3208, clearance: -20 um}\n", **load)
    e = float(record["offset"])
    found = model("  a: {body: rotor, designation: 3208}\n").rolling_bearings["a"].geometry
    assert found.row_distance == pytest.approx(2.0 * e)
    row = (
        f"{{body: rotor, type: ball, elements: {found.elements}, element_diameter: {found.element_diameter}, "
        f"pitch_diameter: {found.pitch_diameter}, grooves: [0.52, 0.53], clearance: -20 um, "
    )
    parts, crossed = (
        rest(
            f"  low: {row}position: [0, 0, {-e}], contact_angle: {angle} deg}}\n"
            f"  high: {row}position: [0, 0, {e}], contact_angle: {-angle} deg}}\n",
            **load,
        )[0]
        for angle in (25, -25)
    )
    for name in "xyz":
        # the balls of the second row are half a spacing further in the double-row bearing
        assert whole[f"displacement[rotor.{name}]"] == pytest.approx(
            parts[f"displacement[rotor.{name}]"], rel=0.03, abs=2e-8
        )
    tilts = [
        math.hypot(*(seen[f"displacement[rotor.r{way}]"] for way in "xy")) for seen in (whole, parts, crossed)
    ]
    assert tilts[0] == pytest.approx(tilts[1], rel=0.03)
    assert tilts[2] > 2.0 * tilts[0]
    # moments of the two rows about the centre, with those of their forces, whose points move by up to 7 um
    for name, across, arm in (("mx", "fy", -e), ("my", "fx", e)):
        both = sum(
            parts[f"bearing_force[{part}.{name}]"] + side * arm * parts[f"bearing_force[{part}.{across}]"]
            for part, side in (("low", -1.0), ("high", 1.0))
        )
        assert whole[f"bearing_force[a.{name}]"] == pytest.approx(both, abs=1e3 * 7e-6)


ONE_BEARING = {
    "designation: 7208B, axial_force_absorption: SIDE": "angular contact",
    "type: ball, grooves: [0.52, 0.53], contact_angle: SIGN40 deg": "given elements",
    "type: ball, grooves: [0.52, 0.53], contact_angle: 40 deg, axial_force_absorption: SIDE": "with side",
}


@pytest.mark.parametrize("side", ["positive", "negative"])
@pytest.mark.parametrize("keys", ONE_BEARING, ids=ONE_BEARING.values())
def test_an_angular_contact_bearing_has_one_shoulder_in_any_spelling(keys, side):
    """500 N on the side that it supports, all carried; against it, the rings come apart: no force."""
    sign = 1.0 if side == "positive" else -1.0
    found = (
        model("  a: {body: rotor, designation: 7208B, axial_force_absorption: positive}\n")
        .rolling_bearings["a"]
        .geometry
    )
    text = "  a: {body: rotor, " + keys.replace("SIDE", side).replace("SIGN", "" if sign > 0.0 else "-")
    if "type: ball" in keys:
        text += (
            f", elements: {found.elements}, element_diameter: {found.element_diameter}, "
            f"pitch_diameter: {found.pitch_diameter}"
        )
    held = "{torsion: 100, radial: 1e7, tilt: 1e4, axial: 1e3}"
    seen, (record,) = rest(text + "}\n", force=f"[0, 0, {sign * 500} N]", held=held)
    z = sign * seen["displacement[rotor.z]"]
    row = Raceways(
        found.elements, float(record["stiffness"]), POINT, found.contact_angle, 0.0, found.groove_distance
    )
    assert z == pytest.approx(row.shift_for(500.0 - 1e3 * z), rel=1e-5)
    seen, _ = rest(text + "}\n", force=f"[0, 0, {-sign * 20} N]", held=held)
    assert seen["bearing_force[a.axial]"] == 0.0
    assert seen["displacement[rotor.z]"] == pytest.approx(-sign * 0.02, rel=1e-6)


def test_a_ball_bearing_with_two_shoulders_holds_both_ways():
    """both_directions, with given elements or a designation: a deep groove ball bearing."""
    for keys in (
        "type: ball, grooves: [0.52, 0.53], elements: 9, element_diameter: 15 mm, pitch_diameter: 65 mm",
        "designation: 6308, clearance: 10 um",
    ):
        for side in (1.0, -1.0):
            seen, _ = rest(
                f"  a: {{body: rotor, {keys}}}\n",
                force=f"[0, 0, {side * 500} N]",
                held="{torsion: 100, radial: 1e7, tilt: 1e4}",
            )
            assert seen["bearing_force[a.axial]"] == pytest.approx(-side * 500.0, rel=1e-6)


def test_check_says_whose_contact_angle_a_double_row_bearing_has():
    """Without a suffix it is that of the table; a suffix or contact_angle decides otherwise."""
    for keys, said in (("3208-2RS", True), ("3208 A", False), ("3208, contact_angle: 32 deg", False)):
        notes = bearing_lines(model(f"  a: {{body: rotor, designation: {keys}}}\n"))[1]
        found = [note for note in notes if "contact angle" in note]
        assert len(found) == said
        assert not said or "a: contact angle of 25 deg, that of NSK; it differs between makers" in found[0]


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
        (
            "designation: 51106, axial_force_absorption: positive, contact_angle: 60 deg",
            "contact_angle",
            "60 deg does not apply to thrust ball bearings; remove it: it is 90 deg",
        ),
        (
            "designation: NU208E, contact_angle: 10 deg",
            "contact_angle",
            "10 deg does not apply to cylindrical",
        ),
        (
            "designation: NJ208E, axial_force_absorption: positive, contact_angle: 10 deg",
            "contact_angle",
            "does not apply to cylindrical roller bearings; remove it: it is 0",
        ),
        ("designation: NA4905, contact_angle: 10 deg", "contact_angle", "does not apply to needle roller"),
        (
            "designation: 6208, contact_angle: 10 deg",
            "contact_angle",
            "does not apply to deep groove ball bearings; remove it: it follows from the clearance",
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
    """Closed form Z (k (e cos(a) +- d_m/2 sin(a))^2 + c) of both bearings, with k and c of one roller.

    k is the sum of the slopes P K/n_s d_s^(P-1) of its slices and c that of slope x xi^2, the tilting of the
    roller about its middle, 0 for one slice. d_s is the approach less both profiles (ISO/TS 16281), and the
    preload is the sum of K/n_s d_s^P. The profile is even, so that there is no mixed term. The load of each
    roller has no line of its own to turn with, so that there is no further term.
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
        geometry = system.model.rolling_bearings["low"].geometry
        angle, P = abs(geometry.contact_angle), 10.0 / 9.0
        half = ((np.arange(slices) + 0.5) / slices - 0.5) * 2.0  # 2 xi/L_we
        profile = 2.0 * 0.00045 * geometry.element_diameter * np.log(1.0 / (1.0 - half**2))
        one = float(record["stiffness"]) / slices

        def excess(depth, one=one, profile=profile, angle=angle, P=P, n=int(record["n"])):
            return n * math.sin(angle) * one * np.sum(np.maximum(depth - profile, 0.0) ** P) - 800.0

        left = brentq(excess, 0.0, 1e-3, xtol=1e-16) - profile
        slopes = np.where(left > 0.0, P * one * np.abs(left) ** (P - 1.0), 0.0)
        about_middle = np.sum(slopes * (0.5 * half * geometry.effective_length) ** 2)
        side = 1.0 if first == "positive" else -1.0
        lever = 0.03 * math.cos(angle) + side * 0.5 * geometry.pitch_diameter * math.sin(angle)
        expected = geometry.elements * (np.sum(slopes) * lever**2 + about_middle)
        assert found[first] == pytest.approx(expected, rel=1e-3)
    assert found["positive"] > 2.0 * found["negative"]
