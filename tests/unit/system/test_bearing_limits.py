# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings with data of a wrong unit, size or place: limits, contradictions and remedies."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.rolling_bearing import RollingBearing
from pitchpoint.model.remarks.collect import remarks_of, remarks_of_file
from pitchpoint.report.bearing_data import bearing_lines
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model

ROTOR = """\
bodies:
  rotor: {motion: free, mass: 2 kg, inertia: 2e-3, transverse_inertia: 2e-3, position: [0, 0, 0]}
loads: {push: {body: rotor, force: [500 N, 0, 0]}}
bearings: {turning: {body: rotor, stiffness: {axial: 1e6, tilt: 1e3, torsion: 100}}}
rolling_bearings:
"""
BALL = (
    "type: deep_groove_ball, inner_diameter: 40 mm, outer_diameter: 90 mm, width: 23 mm, "
    "radial_dynamic_load_rating: {}, radial_static_load_rating: {}"
)


@pytest.mark.parametrize("clearance", [20e-6, 1e-3, 1.4e-3, 1.6e-3, 2e-3, 20e-3])
def test_a_rotor_falls_through_its_clearance(clearance):
    """Closed form: half the clearance, and the approach (F/K)^(2/3) of the one ball below the load.

    6308 has its groove centres 0.755 mm apart; beyond it a ball must not press on their other side.
    """
    system = compile_model(loads_model(ROTOR + "  a: {body: rotor, designation: 6308}\n"))
    records = system.records["rolling_bearing"].copy()
    records["gap"] = 0.5 * clearance
    found = solve_equilibrium(system.with_params({"rolling_bearing": records}))
    approach = (500.0 / records["stiffness"][0]) ** (2.0 / 3.0)
    sideways = math.cos(math.tau / records["n"][0]) * (0.5 * clearance + approach)
    assert sideways < 0.5 * clearance or clearance < 1e-4  # the neighbouring balls are free
    if clearance > 1e-4:
        assert found["displacement[rotor.x]"].item() == pytest.approx(0.5 * clearance + approach, rel=1e-8)
    else:
        assert found["displacement[rotor.x]"].item() < 0.5 * clearance + approach


@pytest.mark.parametrize(
    ("keys", "where", "message"),
    [
        (
            "designation: 6308, clearance: 0.02",
            "clearance",
            "20 mm is too large for a rolling bearing (limit 0.7551 mm, 5 % of the element diameter); a bare "
            "number is in metres; write 0.02 mm",
        ),
        ("designation: 6308, clearance: 2 mm", "clearance", "correct the value or its unit"),
        ("designation: NU 308, clearance: -2 mm", "clearance", "-2 mm is too large"),
        (
            "type: ball, elements: 9, element_diameter: 8 mm, pitch_diameter: 40 mm, grooves: [0.51, 0.51], "
            "clearance: 0.2 mm",
            "clearance",
            "0.2 mm is too large for a rolling bearing (limit 0.16 mm, the distance of the groove centres)",
        ),
        (
            "designation: NJ 308, axial_force_absorption: positive, axial_clearance: 0.1",
            "axial_clearance",
            "half the effective length of a roller); a bare number is in metres; write 0.1 mm",
        ),
        (
            "designation: 32208, axial_force_absorption: positive, preload_distance: 0.005",
            "preload_distance",
            "5 mm is too large",
        ),
        (
            BALL.format("40.5", "24"),
            "radial_static_load_rating",
            "24 N leads to elements of 0.136 mm in a section (D - d)/2 = 25 mm (limit elements of 7.5 to 25 "
            "mm); load ratings without unit are in N; write kN",
        ),
        (BALL.format("40.5 kN", "24"), "radial_static_load_rating", "leads to elements of 0.6"),
        (BALL.format("40.5 MN", "24 MN"), "radial_static_load_rating", "check the units"),
        (
            "designation: 6308 C3, clearance_class: C4",
            "clearance_class",
            "C4 contradicts the suffix C3 of designation: 6308 C3; remove one of them",
        ),
        (
            BALL.format("40.5 kN", "24 kN").replace("deep_groove_ball", "spherical_roller"),
            "",
            "has no contact_angle of a spherical roller bearing; add contact_angle: arctan(e/1.5) with e of",
        ),
    ],
)
def test_messages(keys, where, message):
    with pytest.raises(ModelError) as caught:
        loads_model(ROTOR + f"  a: {{body: rotor, {keys}}}\n")
    (problem,) = caught.value.problems
    assert problem.where == ".".join(filter(None, ("rolling_bearings.a", where)))
    assert message in str(problem)


def test_the_largest_clearance_is_accepted():
    for keys in ("6308, clearance: 0.75 mm", "NU 308, clearance: -0.5 mm", "6308 C3, clearance_class: C3"):
        loads_model(ROTOR + f"  a: {{body: rotor, designation: {keys}}}\n")


@pytest.mark.parametrize(
    ("symbol", "key"),
    [
        ("d", "inner_diameter"),
        ("D", "outer_diameter"),
        ("B", "width"),
        ("C", "radial_dynamic_load_rating"),
        ("C0", "radial_static_load_rating"),
    ],
)
def test_symbols_of_catalogues(symbol, key):
    with pytest.raises(ModelError) as caught:
        loads_model(ROTOR + f"  a: {{body: rotor, type: deep_groove_ball, {symbol}: 40 mm}}\n")
    found = {problem.where: str(problem) for problem in caught.value.problems}
    assert f"is an unknown key; did you mean {key}? " in found[f"rolling_bearings.a.{symbol}"]


def test_a_flange_on_the_negative_side_has_no_negative_contact_angle():
    model = loads_model(ROTOR + "  a: {body: rotor, designation: NJ 308, axial_force_absorption: negative}\n")
    assert math.copysign(1.0, model.rolling_bearings["a"].geometry.contact_angle) == 1.0
    assert "-0" not in str(bearing_lines(model)[0])


@pytest.mark.parametrize(
    ("designation", "bore"), [("6305", 25), ("6307", 35), ("6308", 0), ("6309", 45), ("NU 1009", 45)]
)
def test_a_bore_next_to_the_shaft_diameter(designation, bore):
    """40 mm: the next size of a series is as wrong as any other."""
    text = (
        "shafts: {s: {sections: [{length: 200 mm, diameter: 40 mm}], position: [0, 0, 0]}}\n"
        f"rolling_bearings: {{a: {{body: s, position: [0, 0, 20 mm], designation: {designation}}}}}\n"
    )
    found = [str(each) for each in remarks_of_file(loads_model(text))]
    wanted = f"has a bore of {bore} mm on a shaft of 40 mm diameter"
    assert [wanted in each for each in found] == [True] * bool(bore)


@pytest.mark.parametrize(("place", "bores"), [(50, (30, 40)), (46, (30, 40)), (30, (30,)), (75, (40,))])
def test_a_bearing_at_a_shoulder_has_either_diameter(place, bores):
    text = (
        "shafts: {s: {sections: [{length: 50 mm, diameter: 30 mm}, {length: 50 mm, diameter: 40 mm}], "
        "position: [0, 0, 0]}}\n"
        "rolling_bearings: {a: {body: s, position: [0, 0, PLACE mm], designation: NAME}}\n"
    ).replace("PLACE", str(place))
    for bore, name in ((30, "6206"), (40, "6208"), (35, "6207")):
        assert bool(remarks_of_file(loads_model(text.replace("NAME", name)))) == (bore not in bores)


PAIR = """\
gears:
  p: {number_of_teeth: 21, normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0}
  w: {number_of_teeth: 67, normal_module: 3 mm, face_width: 38 mm, profile_shift_coefficient: 0}
shafts:
  s1: {sections: [{length: 200 mm, diameter: 40 mm}], gears: {p: 120 mm}, position: [0, 0, 0]}
  s2: {sections: [{length: 200 mm, diameter: 40 mm}], gears: {w: 120 mm}}
bodies:
  frame: {mass: 400 kg, inertia: 30, transverse_inertia: 30, motion: free, position: [0.3, 0, 0.1]}
bearings: {feet: {body: frame, stiffness: {radial: 1e9, axial: 1e9, tilt: 1e8, torsion: 1e8}}}
meshes: {m: {gears: [p, w]}}
rolling_bearings:
  a: {body: s1, position: [0, 0, 20 mm], designation: 6308, housing: HOUSE}
"""


def test_a_housing_far_from_the_bearing():
    """The other shaft of a pair is no housing; a casing, whose origin is anywhere, is one."""
    (found,) = [e for e in remarks_of(loads_model(PAIR.replace("HOUSE", "s2"))) if "away" in e.text]
    assert found.where == "rolling_bearings.a.housing"
    assert "the axis of s2 is 132 mm away from the bearing, outside its diameter of 207 mm" in str(found)
    assert not [e for e in remarks_of(loads_model(PAIR.replace("HOUSE", "frame"))) if "away" in e.text]


def test_a_shaft_in_a_hollow_shaft():
    text = (
        "shafts:\n"
        "  inner: {sections: [{length: 200 mm, diameter: 40 mm}], position: [0, 0, 0]}\n"
        "  outer: {sections: [{length: 200 mm, diameter: 110 mm, bore: 90 mm}], position: [0, 0, 0]}\n"
        "rolling_bearings: {a: {body: inner, position: [0, 0, 20 mm], designation: 6308, housing: outer}}\n"
    )
    assert not [e for e in remarks_of(loads_model(text)) if "away" in e.text]


PLANETS = """\
gears:
  sun: {number_of_teeth: 21, normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 99, normal_module: 3 mm, face_width: 40 mm,
    profile_shift_coefficient: 0, bore_diameter: 340 mm, tip_diameter: 292.5 mm}
bodies:
  sun: {gears: [sun], motion: planar, axes: {z: AXIS}}
  ring: {gears: [ring], motion: fixed, axes: {z: AXIS}}
  carrier: {mass: 12 kg, inertia: 0.12, axes: {z: AXIS}}
planetary_stages:
  set:
    {sun: sun, ring: ring, carrier: carrier, planets: 3, motion: MOTION,
    planet: {number_of_teeth: 39, normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0}}
bearings: {spline: {body: sun, stiffness: {radial: 1e6 N/m}}}
rolling_bearings:
  pin_1: {KEYS1, designation: NA4906}
  pin_2: {KEYS2, designation: NA4906}
  pin_3: {KEYS3, designation: NA4906}
loads: {motor: {body: sun, torque: 600 N m}, output: {body: carrier, torque: balance}}
"""


@pytest.mark.parametrize(
    ("keys", "motion", "axis"),
    [
        ("ends: [carrier, PLANET]", "planar", "[0, 0, 1]"),
        ("ends: [PLANET, carrier]", "planar", "[0, 0, 1]"),
        ("ends: [carrier, PLANET]", "free", "[1, 0, 0]"),
        ("body: PLANET, housing: carrier", "planar", "[0, 0, 1]"),
    ],
)
def test_planets_on_needle_bearings(keys, motion, axis):
    """Each pin carries twice the tangential force 600 N m/3/31.5 mm; radial forces of sun and ring cancel."""
    text = PLANETS.replace("MOTION", motion).replace("AXIS", axis)
    for k in (1, 2, 3):
        text = text.replace(f"KEYS{k}", keys.replace("PLANET", f"planet_{k}"))
    model = loads_model(text)
    assert not [e for e in remarks_of(model) if "away" in e.text]
    found = solve_equilibrium(compile_model(model))
    loads = np.array([found[f"bearing_force[pin_{k}.radial]"].item() for k in (1, 2, 3)])
    np.testing.assert_allclose(loads, 2.0 * 200.0 / 31.5e-3, rtol=1e-4)


def test_a_ring_on_a_body_elsewhere_names_the_other_form():
    text = ROTOR.replace("loads:", "  frame: {motion: fixed, position: [0.1, 0, 0]}\nloads:")
    with pytest.raises(ModelError) as caught:
        loads_model(text + "  a: {ends: [rotor, frame], designation: 6308}\n")
    assert "are 100 mm apart in the initial position" in str(caught.value)
    assert "or write body: rotor, position: [0, 0, 0 mm], housing: frame instead of ends" in str(caught.value)


def test_symbols_of_catalogues_in_python():
    with pytest.raises(ModelError, match="is an unknown key; did you mean outer_diameter"):
        RollingBearing(body="rotor", D=0.09)
