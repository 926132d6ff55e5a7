# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings of a catalogue in model files: forms, positions, preload, floating bearings, messages."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.contact.rolling import LINE, Raceways, roller_slices
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.report.bearing_data import bearing_data, bearing_lines
from pitchpoint.report.defaults import defaults
from pitchpoint.report.frequencies import frequencies_of, turning_speeds
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model

DOCS = Path(__file__).parents[3] / "docs"
PAIR = """\
gears:
  pinion: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 40, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
shafts:
  input:
    sections: [{length: 100 mm, diameter: 30 mm}]
    gears: {pinion: 50 mm}
    markers: {front: {position: [0, 0, 10 mm]}, rear: {position: [0, 0, 90 mm]}}
  output:
    sections: [{length: 100 mm, diameter: 40 mm}]
    gears: {wheel: 50 mm}
    markers: {front: {position: [0, 0, 10 mm]}, rear: {position: [0, 0, 90 mm]}}
meshes:
  stage: {gears: [pinion, wheel], center_distance: 90 mm}
loads:
  motor: {body: input, torque: 10 N m}
  brake: {body: output, torque: balance}
rolling_bearings:
"""
MARKED = (
    PAIR
    + """\
  a: {ends: [input.front, ground], designation: 6306}
  b: {ends: [input.rear, ground], designation: NU 206 E}
  c: {ends: [output.front, ground], designation: 22208}
  d: {ends: [output.rear, ground], designation: 6308, axial_force_absorption: no_direction}
"""
)
MOUNTED = (
    PAIR.replace("    markers: {front: {position: [0, 0, 10 mm]}, rear: {position: [0, 0, 90 mm]}}\n", "")
    + """\
  a: {body: input, position: [0, 0, 10 mm], designation: 6306}
  b: {body: input, position: [0, 0, 90 mm], designation: NU 206 E}
  c: {body: output, position: [0, 0, 10 mm], designation: 22208}
  d: {body: output, position: [0, 0, 90 mm], designation: 6308, axial_force_absorption: no_direction}
"""
)


def test_mounted_and_marked_bearings_of_shafts_placed_by_their_mesh():
    """Both forms give the same records, at the shafts: the output shaft is 90 mm from the origin."""
    marked, mounted = (
        compile_model(loads_model(text)).records["rolling_bearing"] for text in (MARKED, MOUNTED)
    )
    for name in ("i", "j", "p_i", "p_j", "A_i", "A_j", "n", "rows", "angle", "gap", "stiffness", "n_slices"):
        np.testing.assert_array_equal(marked[name], mounted[name])
    np.testing.assert_allclose(mounted["p_j"], [[0, 0, 0.01], [0, 0, 0.09], [0.09, 0, 0.01], [0.09, 0, 0.09]])
    np.testing.assert_array_equal(mounted["p_i"], 0.0)  # each bearing has a station of its shaft
    model = loads_model(MOUNTED)
    assert loads_model(dump_model(model)) == model


HOUSED = """\
bodies:
  frame: {motion: free, mass: 9 kg, inertia: 0.1, transverse_inertia: 0.1, position: [0.1, 0.2, 0.3],
    axes: {z: [1, 0, 0]}, markers: {bore: {position: [0, 0, 50 mm]}}}
  rotor: {motion: free, mass: 2 kg, inertia: 2e-3, transverse_inertia: 2e-3, position: [0.1, 0.2, 0.3],
    axes: {z: [1, 0, 0]}, markers: {seat: {position: [0, 0, 50 mm]}}}
bearings: {feet: {body: frame, stiffness: {radial: 1e7, axial: 1e7, tilt: 1e4, torsion: 1e4}}}
SECTION:
"""


@pytest.mark.filterwarnings("ignore:.*is not used")
@pytest.mark.parametrize(
    ("section", "keys"),
    [
        ("rolling_bearings", "designation: 6308"),
        ("plain_bearings", "clearance: 20 um, stiffness: 1e8"),
    ],
)
def test_a_housing_that_moves(section, keys):
    """On a moving body along another axis: the same records as with markers on both bodies."""
    text = HOUSED.replace("SECTION", section)
    records = [
        next(
            record
            for kind, record in compile_model(
                loads_model(text + f"  b: {{{where}, {keys}}}\n")
            ).records.items()
            if kind in ("rolling_bearing", "clearance_bearing")
        )
        for where in (
            "ends: [rotor.seat, frame.bore]",
            "body: rotor, position: [0, 0, 50 mm], housing: frame",
            "body: rotor, position: [0, 0, 50 mm], housing: frame.bore",
        )
    ]
    for name in ("i", "j", "p_i", "p_j", "A_i", "A_j", "gap"):
        for other in records[1:]:
            np.testing.assert_allclose(other[name], records[0][name], atol=1e-15)
    with pytest.raises(ModelError, match=r"frame\.bore is 20 mm away from the bearing"):
        loads_model(text + f"  b: {{body: rotor, position: [0, 0, 30 mm], housing: frame.bore, {keys}}}\n")


ROTOR = """\
bodies:
  rotor: {motion: free, mass: 2 kg, inertia: 2e-3, transverse_inertia: 2e-3, position: PLACE, axes: {z: AXIS}}
loads: {weight: {body: rotor, force: FORCE, along: world}}
bearings: {turning: {body: rotor, stiffness: {torsion: 100}}}
rolling_bearings:
"""


def rest(bearings, force="[100 N, 0, 0]", place="[0, 0, 0]", axis="[0, 0, 1]"):
    """Equilibrium of a rotor: values by channel."""
    text = ROTOR.replace("FORCE", force).replace("PLACE", place).replace("AXIS", axis) + bearings
    found = solve_equilibrium(compile_model(loads_model(text)))
    return {name: found[name].item() for name in found if "[" in name}


TAPERED = """\
  a: {body: rotor, position: [0, 0, -0.05], designation: 30208, axial_force_absorption: FIRST, preload: 800 N}
  b: {body: rotor, position: [0, 0, 0.05], designation: 30208, axial_force_absorption: SECOND, preload: 800 N}
"""


@pytest.mark.parametrize("first", ["negative", "positive"])
def test_preload_of_a_pair(first):
    """O and X arrangement: both bearings carry the preload, opposite, and the shaft stays where it is."""
    second = "positive" if first == "negative" else "negative"
    seen = rest(TAPERED.replace("FIRST", first).replace("SECOND", second), force="[0, 0, 0]")
    side = 1.0 if first == "negative" else -1.0
    assert seen["bearing_force[a.axial]"] == pytest.approx(side * 800.0, rel=1e-6)
    assert seen["bearing_force[b.axial]"] == pytest.approx(-side * 800.0, rel=1e-6)
    assert abs(seen["displacement[rotor.z]"]) < 1e-12


def test_an_axial_load_on_a_preloaded_pair():
    """Closed form: shaft displacement z with F(s + z) - F(s - z) = load, F the thrust of one row."""
    text = TAPERED.replace("FIRST", "negative").replace("SECOND", "positive")
    seen = rest(text, force="[0, 0, 300 N]")
    model = loads_model(
        ROTOR.replace("FORCE", "[0, 0, 0]").replace("PLACE", "[0,0,0]").replace("AXIS", "[0,0,1]") + text
    )
    geometry = model.rolling_bearings["a"].geometry
    record = compile_model(model).records["rolling_bearing"][1]
    slices = roller_slices(geometry.effective_length, geometry.element_diameter, 21, tapered=True)
    row = Raceways(
        geometry.elements, float(record["stiffness"]), LINE, abs(geometry.contact_angle), 0.0, 0.0, slices
    )
    s, z = float(record["shift"]), seen["displacement[rotor.z]"]
    assert row.thrust(s) == pytest.approx(800.0, rel=1e-9)
    assert row.thrust(s + z) - row.thrust(s - z) == pytest.approx(300.0, rel=1e-6)
    assert seen["bearing_force[b.axial]"] == pytest.approx(-row.thrust(s + z), rel=1e-6)


@pytest.mark.parametrize("first", ["negative", "positive"])
def test_preload_of_an_elastic_shaft(first):
    """The shaft yields by F L/(E A), half of it at either bearing; docs/bearings.md prints the result."""
    second = "positive" if first == "negative" else "negative"
    text = "shafts: {s: {sections: [{length: 210 mm, diameter: 60 mm}], position: [0, 0, 0]}}\n"
    text += "rolling_bearings:\n"
    for name, place, side in (("a", 20, first), ("b", 190, second)):
        text += (
            f"  {name}: {{body: s, position: [0, 0, {place} mm], designation: 32212, axial_force_absorption: "
            f"{side}, preload: 500 N}}\n"
        )
    model = loads_model(text)
    system = compile_model(model)
    found, record = solve_equilibrium(system), system.records["rolling_bearing"][0]
    geometry = model.rolling_bearings["a"].geometry
    slices = roller_slices(geometry.effective_length, geometry.element_diameter, 21, tapered=True)
    row = Raceways(
        geometry.elements, float(record["stiffness"]), LINE, abs(geometry.contact_angle), 0.0, 0.0, slices
    )
    force = abs(found["bearing_force[a.axial]"].item())
    shortened = force * 0.17 / (206e9 * math.pi / 4.0 * 0.06**2)
    assert row.thrust(abs(float(record["shift"])) - 0.5 * shortened) == pytest.approx(force, rel=2e-4)
    assert f"have {force:.1f} N" in (DOCS / "bearings.md").read_text("utf-8")


def test_resultants_have_the_direction_of_the_load():
    """A rotor along world x, away from the origin: radial and axial resultants of a load in space."""
    bearings = "  a: {body: rotor, designation: 22208, clearance: 0}\n"
    seen = rest(bearings, force="[50 N, 300 N, 400 N]", place="[0.3, 0.2, 0.1]", axis="[1, 0, 0]")
    fx, fy, fz = (seen[f"bearing_force[a.{c}]"] for c in ("fx", "fy", "fz"))
    assert seen["bearing_force[a.radial]"] == pytest.approx(500.0, rel=1e-6)
    assert seen["bearing_force[a.axial]"] == fz == pytest.approx(-50.0, rel=1e-6)
    assert seen["bearing_force[a.direction]"] == pytest.approx(math.atan2(fy, fx), abs=1e-12)
    assert math.tan(seen["bearing_force[a.direction]"]) == pytest.approx(400.0 / 300.0, rel=1e-6)


def test_resultants_of_linear_and_plain_bearings():
    text = (
        ROTOR.replace("FORCE", "[300 N, 400 N, 50 N]")
        .replace("PLACE", "[0.3, 0, 0]")
        .replace("AXIS", "[0, 0, 1]")
    )
    text = text.replace("{torsion: 100}", "{axial: 1e6, tilt: 1e3, torsion: 100}").replace(
        "rolling_bearings:\n", ""
    )
    text += "plain_bearings: {p: {body: rotor, clearance: 20 um, stiffness: 1e8}}\n"
    found = solve_equilibrium(compile_model(loads_model(text)))
    assert found["bearing_force[p.radial]"].item() == pytest.approx(500.0, rel=1e-6)
    assert found["bearing_force[turning.axial]"].item() == pytest.approx(-50.0, rel=1e-6)
    assert found["bearing_force[turning.radial]"].item() == pytest.approx(0.0, abs=1e-6)


def test_a_floating_bearing_leaves_the_axial_load_to_the_fixed_one():
    bearings = (
        "  fixed: {body: rotor, position: [0, 0, -50 mm], designation: 6308}\n"
        "  floating: {body: rotor, position: [0, 0, 50 mm], designation: 6308, "
        "axial_force_absorption: no_direction}\n"
    )
    seen = rest(bearings, force="[400 N, 0, 200 N]")
    assert seen["bearing_force[floating.axial]"] == 0.0
    assert seen["bearing_force[fixed.axial]"] == pytest.approx(-200.0, rel=1e-6)
    # moments about the fixed bearing, which resists tilting; the axial load on the tilted shaft adds 5e-5
    moment = 0.1 * seen["bearing_force[floating.fx]"] + seen["bearing_force[fixed.my]"]
    assert moment == pytest.approx(-20.0, rel=1e-4)


def test_catalogue_data_are_those_of_the_designation():
    """The same bearing by designation and by its data; given elements replace the estimate."""
    data = (
        "type: tapered_roller, inner_diameter: 40 mm, outer_diameter: 80 mm, width: 19.75 mm, contact_angle: "
        "13.86 deg, radial_dynamic_load_rating: 63.5 kN, radial_static_load_rating: 70 kN"
    )
    models = [
        loads_model(
            ROTOR.replace("FORCE", "[1, 0, 0]").replace("PLACE", "[0, 0, 0]").replace("AXIS", "[0, 0, 1]")
            + f"  a: {{body: rotor, axial_force_absorption: negative, {keys}}}\n"
        )
        for keys in ("designation: 30208", data, f"{data}, elements: 18")
    ]
    one, two, three = (model.rolling_bearings["a"].geometry for model in models)
    assert two.contact_angle == pytest.approx(one.contact_angle, rel=1e-4)
    assert two.contact_angle < 0.0
    assert two.elements == one.elements
    assert two.effective_length == pytest.approx(one.effective_length, rel=1e-4)
    assert three.elements == 18
    assert bearing_data(models[2])["a"]["estimated"] == [
        "element_diameter",
        "pitch_diameter",
        "effective_length",
    ]
    rows, notes = bearing_lines(models[0])
    assert rows[0][:2] == ["a: 30208", "40 x 80 x 19.75"]
    assert "C0 = 70 kN (reproduced) and C = 63.5 kN (ISO 281 with these elements: 63" in notes[0]


def test_check_prints_the_defaults_that_apply():
    """Slices of rollers, grooves of balls, clearance classes of bearings that have one."""
    found = defaults(loads_model(MOUNTED))
    named = {
        key.rpartition(".")[2]: key.split(".")[1] for key, _ in found if key.startswith("rolling_bearings.")
    }
    assert (named["slices"], named["grooves"], named["damping"]) == ("b,c", "a,d", "*")
    assert named["clearance_class"] == "*"
    assert dict(found)["rolling_bearings.*.damping"] == "0"


def test_clearance_by_class():
    text = ROTOR.replace("FORCE", "[1, 0, 0]").replace("PLACE", "[0, 0, 0]").replace("AXIS", "[0, 0, 1]")
    for keys, wanted in (
        ("designation: 6308", 13e-6),  # CN of bores over 30 up to 40 mm: 6 to 20 um
        ("designation: 6308/C3", 24e-6),
        ("designation: 6308, clearance_class: C4", 37e-6),
        ("designation: 6308, clearance: 5 um", 5e-6),
        ("designation: 6308, preload: 100 N", 0.0),
    ):
        found = loads_model(text + f"  a: {{body: rotor, {keys}}}\n").rolling_bearings["a"].geometry
        assert found.clearance == pytest.approx(wanted, abs=1e-12)


def test_frequencies_of_a_catalogue_bearing():
    """6205 at 1797 rpm: 3.5848 orders of the outer race (CWRU), by the estimate within 1 %."""
    text = ROTOR.replace("FORCE", "[1, 0, 0]").replace("PLACE", "[0, 0, 0]").replace("AXIS", "[0, 0, 1]")
    model = loads_model(text.replace("torsion: 100", "axial: 1") + "  a: {body: rotor, designation: 6205}\n")
    speed = 1797.0 / 60.0
    rows = frequencies_of(model, turning_speeds(model, {"rotor": speed * math.tau}))["rolling_bearings"]["a"]
    assert rows["bpfo"] / speed == pytest.approx(3.5848, rel=0.01)
    assert rows["bpfi"] / speed == pytest.approx(5.4152, rel=0.01)
    assert rows["bsf_double"] / speed == pytest.approx(4.7135, rel=0.02)


@pytest.mark.parametrize(
    ("keys", "where", "message"),
    [
        ("body: rotor, designation: 6399", "designation", "is not in the table of bearings; did you mean"),
        ("body: rotor, designation: 7208B", "axial_force_absorption", "is required for angular contact ball"),
        (
            "body: rotor, type: deep_groove_ball, width: 1 mm",
            "",
            "has no inner_diameter, outer_diameter, radial_d",
        ),
        (
            "body: rotor, elements: 9",
            "",
            "has no element_diameter, pitch_diameter; give designation, or type",
        ),
        ("body: rotor, designation: 6308, type: ball", "type", "is not the type of 6308"),
        ("body: rotor, designation: 6308, width: 20 mm", "width", "is given in addition to designation"),
        (
            "body: rotor, designation: NU208E, preload: 1 kN",
            "preload",
            "does not apply to a floating bearing",
        ),
        (
            "body: rotor, designation: NU208E, axial_force_absorption: positive",
            "axial_force_absorption",
            "does not apply to NU208E, which has no flanges; use NJ (one direction) or NUP (both)",
        ),
        (
            "body: rotor, designation: 30208, axial_force_absorption: no_direction",
            "axial_force_absorption",
            "does",
        ),
        (
            "body: rotor, designation: 6308, clearance: 1 um, clearance_class: C3",
            "clearance_class",
            "in addition",
        ),
        (
            "body: rotor, designation: 6308, effective_length: 9 mm",
            "effective_length",
            "does not apply to a bear",
        ),
        ("designation: 6308", "", "gives none of body, ends; give exactly one of them"),
        ("body: rotor, ends: [rotor, ground], designation: 6308", "", "gives body and ends together"),
        ("ends: [rotor, ground], housing: ground, designation: 6308", "housing", "requires body"),
        ("body: shaft, designation: 6308", "body", "names the body 'shaft', which does not exist"),
        ("body: rotor, position: [1 mm, 0, 0], designation: 6308", "position", "is off the axis of rotor"),
        ("body: rotor, housing: rotor, designation: 6308", "housing", "is the body that runs in the bearing"),
    ],
)
def test_messages(keys, where, message):
    text = ROTOR.replace("FORCE", "[1, 0, 0]").replace("PLACE", "[0, 0, 0]").replace("AXIS", "[0, 0, 1]")
    with pytest.raises(ModelError) as caught:
        loads_model(text + f"  a: {{{keys}}}\n")
    (problem,) = caught.value.problems
    assert problem.where == ".".join(filter(None, ("rolling_bearings.a", where)))
    assert message in str(problem)
    assert problem.remedy
