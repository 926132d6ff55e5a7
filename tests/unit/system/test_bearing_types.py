# SPDX-License-Identifier: Apache-2.0
"""Self-aligning, double-row, thrust and needle bearings, and flanges of cylindrical rollers, in models."""

from __future__ import annotations

import math

import pytest
from scipy.special import beta

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
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
    ],
)
def test_messages(keys, where, message):
    with pytest.raises(ModelError) as caught:
        model(f"  a: {{body: rotor, {keys}}}\n")
    (problem,) = caught.value.problems
    assert problem.where == ".".join(filter(None, ("rolling_bearings.a", where)))
    assert message in str(problem)
    assert problem.remedy
