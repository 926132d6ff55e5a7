# SPDX-License-Identifier: Apache-2.0
"""Wrong references, places and sizes are refused in a sentence; none ends in an exception of a library."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.rolling import curvature, ellipse
from pitchpoint.core.errors import Message, ModelError, ValidityWarning
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import Model
from pitchpoint.model.remarks.collect import remarks_of
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from tests.support.model_files import TORSIONAL_PAIR, gear, pair

ROTOR = (
    "bodies:\n  r: {mass: 1 kg, inertia: 1e-3, transverse_inertia: 1e-2, motion: free, "
    "markers: {m: {position: [0, 0, %s]}}}\n"
)
BALLS = "elements: 9, element_diameter: 8 mm, pitch_diameter: 40 mm, grooves: %s"


def problems(text: str) -> list[Message]:
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    return list(caught.value.problems)


def only(text: str) -> Message:
    (problem,) = problems(text)
    return problem


# --- references ---------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    "part",
    [
        "rolling_bearings:\n  p: {ends: [r.m, nobody], elements: 9, element_diameter: 8 mm, "
        "pitch_diameter: 40 mm, grooves: [0.52, 0.52]}",
        "rolling_bearings:\n  p: {ends: [nobody.m, ground], elements: 9, element_diameter: 8 mm, "
        "pitch_diameter: 40 mm, grooves: [0.52, 0.52]}",
        "plain_bearings:\n  p: {ends: [r.m, nobody], clearance: 0.1 mm, stiffness: 1e8}",
        "rods:\n  p: {ends: [r.m, nobody]}",
        "springs:\n  p: {ends: [r.m, nobody], stiffness: 1 N/m}",
        "maxwells:\n  p: {ends: [r.m, nobody], stiffness: 1 N/m, damping: 1 N s/m}",
        "bushings:\n  p: {ends: [r.m, nobody], stiffness: {radial: 1 N/m}}",
        "beams:\n  p: {ends: [r.m, nobody], section: {width: 20 mm, height: 4 mm}}",
        "joints:\n  p: {type: revolute, bodies: [r, nobody]}",
        "sensors:\n  p: {type: frames, quantity: distance, ends: [r.m, nobody]}",
        "bearings:\n  p: {body: r, housing: nobody, stiffness: {radial: 1e8 N/m}}",
        "bearings:\n  p: {body: nobody, stiffness: {radial: 1e8 N/m}}",
        "couplings:\n  p: {bodies: [r, nobody], stiffness: {radial: 1e8 N/m}}",
        "unbalances:\n  p: {body: nobody, mass: 1 g, position: [1 mm, 0, 0]}",
        "loads:\n  p: {body: nobody, force: [1 N, 0, 0]}",
    ],
)
def test_a_body_that_does_not_exist(part: str) -> None:
    problem = only(ROTOR % "0" + part + "\n")
    assert problem.where.startswith(part.partition(":")[0] + ".p.")
    assert "names the body 'nobody', which does not exist" in problem.text
    assert str(problem.remedy).startswith("there are r")


# --- places -------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("section", "keys"),
    [
        ("rolling_bearings", BALLS % "[0.52, 0.52]"),
        ("plain_bearings", "clearance: 0.1 mm, stiffness: 1e8"),
    ],
)
def test_rings_lie_at_one_place(section: str, keys: str) -> None:
    """A journal at 200 mm and a ring at the origin of another body made a spring of 200 mm."""
    frame = "  frame: {motion: fixed, position: [0, 0, 0]}\n"
    text = ROTOR + frame + f"{section}:\n  b: {{ends: [r.m, frame], {keys}}}\n"
    problem = only(text % "200 mm")
    assert (problem.where, problem.value, problem.limit) == (f"{section}.b.ends", "r.m and frame", "1 mm")
    assert "are 200 mm apart in the initial position" in problem.text
    assert loads_model(text % "0.9 mm")


def test_rings_at_a_place_that_cannot_be_read_are_not_compared():
    frame = "  frame: {motion: fixed, position: [0, 0, 200 mm]}\n"
    text = ROTOR + f"{frame}rolling_bearings:\n  b: {{ends: [r.m, frame], {BALLS % '[0.52, 0.52]'}}}\n"
    assert loads_model(text % "200 mm")
    problem = only(text % "200 kg")
    assert problem.where.startswith("bodies.r.markers.m")


# --- speeds against a fixed mate ----------------------------------------------------------------------------
FIXED_MATE = TORSIONAL_PAIR.replace(
    "driven: {gears: [g2], motion: torsion", "driven: {gears: [g2], motion: fixed"
)
FIXED_MATE = FIXED_MATE.replace("  output: {body: driven, torque: 150 N m}", "")


@pytest.mark.parametrize("scenario", ["speed: {driver: 1500 rpm}", "drive: {driver: {speed: 1500 rpm}}"])
def test_nothing_turns_against_a_fixed_mate(scenario: str) -> None:
    head = FIXED_MATE.partition("scenarios:")[0]
    problem = only(head + f"scenarios:\n  s: {{{scenario}, duration: 1 s}}\n")
    assert problem.where.endswith(".driver")
    assert "cannot rotate driver: meshes.stage connects its gear train" in problem.text
    assert "driven, which is fixed" in problem.text


def test_a_gear_at_rest_may_mesh_with_a_fixed_one() -> None:
    head = FIXED_MATE.partition("scenarios:")[0]
    assert loads_model(head + "scenarios:\n  s: {speed: {driver: 0}, duration: 1 s}\n")


# --- sizes --------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("old", "new", "where"),
    [
        ("1500 rpm", "1e300 rpm", "scenarios.steady.speed.driver"),
        ("1500 rpm", "3e12 rad/s", "scenarios.steady.speed.driver"),
        ("4.0e8 N/m", "1e100 N/m", "meshes.stage.stiffness.mean"),
        ("0.0115 kg m^2", "1e-90 kg m^2", "bodies.driver.inertia"),
    ],
)
def test_numbers_that_overflow(old: str, new: str, where: str) -> None:
    problem = problems(TORSIONAL_PAIR.replace(old, new))[0]
    assert problem.where == where
    assert "out of the range of computation" in problem.text
    assert problem.limit is not None
    assert problem.remedy is not None


def test_gravity_has_three_components() -> None:
    problem = only("gravity: [0, -9.81 m/s^2]\n" + ROTOR % "0")
    assert (problem.where, problem.limit) == ("gravity", "3 entries")
    with pytest.raises(ModelError, match=r"gravity.*3 entries"):
        Model(bodies=loads_model(ROTOR % "0").bodies, gravity=(0.0, -9.81))  # type: ignore[arg-type]


@pytest.mark.parametrize("keys", ["diameter: 20 mm}]", "diameter: 20 mm}], largest_piece: 1 m"])
def test_a_shaft_of_too_many_pieces(keys: str) -> None:
    text = f"shafts:\n  s: {{sections: [{{length: 100 km, {keys}}}\n"
    problem = only(text)
    assert problem.where == f"shafts.s.{'largest_piece' if 'largest' in keys else 'sections'}"
    assert "beam elements" in str(problem.limit)
    assert "check the units" in str(problem.remedy)


def test_a_ball_larger_than_the_inner_ring_leaves() -> None:
    balls = "elements: 2, element_diameter: 45 mm, pitch_diameter: 40 mm, grooves: [0.52, 0.52]"
    problem = only(ROTOR % "0" + f"rolling_bearings:\n  b: {{ends: [r, ground], {balls}}}\n")
    assert problem.where == "rolling_bearings.b.element_diameter"
    assert problem.limit == "below 40 mm, the pitch diameter"


# --- inertia ------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("product", [0.9, 1.0, 1.5, -1.5, 1e3])
@pytest.mark.parametrize("place", [3, 4, 5])
def test_a_tensor_that_is_not_positive(product: float, place: int) -> None:
    tensor = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]
    tensor[place] = product
    problem = only(f"bodies:\n  a: {{mass: 1 kg, inertia_tensor: {tensor}, motion: free}}\n")
    assert problem.where == "bodies.a.inertia_tensor"
    assert f"{1.0 - abs(product):.6g}, 1, {1.0 + abs(product):.6g} kg m^2" in str(problem.value)
    assert problem.limit == "none negative, none above the sum of the other two"


# --- rolling bearings without grooves -----------------------------------------------------------------------
def test_the_sign_of_the_curvature_difference_turns_the_ellipse() -> None:
    """A ball in a cylindrical outer ring: the principal curvatures change places, the approach does not."""
    total, difference = curvature(8e-3, -40e-3, 52.0, 0.0)
    assert difference < 0.0
    assert ellipse(difference) == ellipse(-difference)
    # curvatures of the ball 2/D twice, across the groove -1/(f D), along the track -2 g/((1 + g) D)
    g = 0.2
    across, along = 2.0 - 1.0 / 52.0, 2.0 - 2.0 * g / (1.0 + g)
    assert total == pytest.approx((across + along) / 8e-3, rel=1e-12)
    assert difference == pytest.approx((along - across) / (along + across), rel=1e-9)


@pytest.mark.parametrize("difference", [1e-9, 1e-7, 9.9e-5, 1.01e-4, 1e-3])
def test_ellipses_near_the_circle(difference: float) -> None:
    """ln(a/b) = 4/3 F(rho) to third order, and the approach of a circle to second."""
    a, b, approach = ellipse(difference)
    assert math.log(a / b) == pytest.approx(4.0 / 3.0 * difference, rel=1e-6, abs=1e-12)
    assert approach == pytest.approx(1.0, abs=difference**2)


def test_a_bearing_without_grooves_has_modes() -> None:
    text = (
        ROTOR % "0"
        + "rolling_bearings:\n  b: {ends: [r.m, ground], clearance: -5 um, "
        + BALLS % "[0.52, 52]"
    )
    model = loads_model(text + "}\n")
    (found,) = remarks_of(model)
    assert found.where == "rolling_bearings.b.grooves"
    assert "the outer ring has a radius of 416 mm, more than its raceway with 24 mm" in found
    with pytest.warns(ValidityWarning, match="groove"):
        modes = find_modes(compile_model(model))
    assert np.isfinite(modes.frequency).all()
    assert modes.frequency[-1] > 100.0


# --- formulas between braces --------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("load", "where", "quoted"),
    [
        ("torque: min(100*t, 5)", "loads.l.torque", 'write torque: "min(100*t, 5)"'),
        ("torque: max(min(t, 1), pulse(t, 0, 1))", "loads.l.torque", '"max(min(t, 1), pulse(t, 0, 1))"'),
        ("force: [0, min(t, 1), 0]", "loads.l.force[1]", 'write "min(t, 1)"'),
    ],
)
def test_a_formula_that_yaml_cuts_at_its_commas(load: str, where: str, quoted: str) -> None:
    problem = only(ROTOR % "0" + f"loads:\n  l: {{body: r, {load}}}\n")
    assert problem.where == where
    assert "requires quotes" in problem.text
    assert quoted in str(problem.remedy)


def test_formulas_that_yaml_does_not_cut() -> None:
    text = (
        ROTOR % "0"
        + "loads:\n  l: {body: r, torque: 'min(t, 1)'}\n  k:\n    body: r\n    torque: min(t, 1)\n"
    )
    assert loads_model(text).loads["k"].torque == loads_model(text).loads["l"].torque


def test_an_open_bracket_is_not_taken_for_a_comma() -> None:
    (problem,) = problems(pair(gear("a"), gear("b"), "backlash: min(t")[:-2] + "}\n")
    assert "quotes" not in problem.text


def test_numbers_of_rolling_elements_without_bound():
    """A cage fault of 1e9 elements took 7 GB for their angles before anything was refused."""
    balls = (BALLS % "[0.52, 0.52]").replace("elements: 9", "elements: 1000000000")
    worn = "faults: {worn: {type: cage, element: 1, widening: 1 deg}}"
    problem = only(ROTOR % 0 + f"rolling_bearings:\n  p: {{ends: [r.m, ground], {balls}, {worn}}}\n")
    assert problem.where == "rolling_bearings.p.elements"
    assert problem.limit == ">= 2 and <= 10000"


# --- housings -----------------------------------------------------------------------------------------------
def test_both_tilts_of_a_housing_have_the_limit_of_one():
    """Flanks of any pressure angle are then misaligned by at most that: the limit of all contact analyses."""
    text = pair(gear("a", 20), gear("b", 30), "misalignment: {in_plane: %r, out_of_plane: %r}")
    problem = only(text % (0.1, 0.1))
    assert str(problem).startswith("meshes.m.misalignment (line 5): ")
    assert "0.1414 rad is too large an angle between the axes (limit 0.1 rad)" in problem
    for angle in np.linspace(0.0, 2.0 * math.pi, 13):
        mesh = loads_model(text % (0.1 * math.cos(angle), 0.1 * math.sin(angle))).meshes["m"]
        for flank in (1, -1):
            assert abs(mesh.misalignment.of_flanks(math.radians(20.0), flank)) <= 0.1 * (1.0 + 1e-12)
