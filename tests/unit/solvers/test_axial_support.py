# SPDX-License-Identifier: Apache-2.0
"""Shafts that their bearings do not hold along the axis: remark of `check`, and message of the statics."""

from __future__ import annotations

import re

import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import SINGULAR
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.axial_supports import without_axial_support
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model

PAIR = """\
gears:
  p: {number_of_teeth: 21, normal_module: 3 mm, helix_angle: 18 deg, hand: left, face_width: 40 mm}
  w: {number_of_teeth: 67, normal_module: 3 mm, helix_angle: 18 deg, hand: right, face_width: 38 mm,
    profile_shift_coefficient: 0}
shafts:
  s1: {sections: [{length: 200 mm, diameter: 40 mm}], gears: {p: 120 mm}, position: [0, 0, 0]}
  s2: {sections: [{length: 210 mm, diameter: 60 mm}], gears: {w: 110 mm}}
rolling_bearings:
  a1: {body: s1, position: [0, 0, 20 mm], FIRST}
  a2: {body: s1, position: [0, 0, 180 mm], SECOND}
  b1: {body: s2, position: [0, 0, 20 mm], designation: 6212}
  b2: {body: s2, position: [0, 0, 190 mm], designation: NU 212}
meshes: {m: {gears: [p, w], center_distance: 140 mm}}
loads: {d: {body: s1, torque: 250 N m}, b: {body: s2, torque: balance}}
"""
FLOATING, FIXED = "designation: NU 308", "designation: 6308"
PLUS, MINUS = (
    f"designation: 32208, axial_force_absorption: {side}, preload_distance: 0"
    for side in ("positive", "negative")
)


def pair(first: str, second: str, text: str = PAIR) -> str:
    return text.replace("FIRST", first).replace("SECOND", second)


@pytest.mark.parametrize(
    ("first", "second", "message"),
    [
        (FLOATING, FLOATING, "nothing holds s1 along its axis: add a bearing with axial stiffness (line 6)"),
        (
            PLUS,
            PLUS,
            "nothing holds s1 along its axis in its -z direction: a1 and a2 support +z only; turn one of its "
            "bearings around (axial_force_absorption), or add one (line 6)",
        ),
    ],
)
def test_statics_name_the_shaft_and_the_direction(first, second, message):
    """The axial force on the left-handed pinion is 250 N m tan(18 deg)/33.1 mm = 2.45 kN along -z.

    All bearings have clearance, so that no shaft has any stiffness as assembled.
    """
    system = compile_model(loads_model(pair(first, second)))
    with pytest.raises(SolverError) as failure:
        solve_equilibrium(system)
    assert str(failure.value) == f"no equilibrium: {message}"
    assert failure.value.status == SINGULAR


def test_bearings_that_support_the_force_of_the_mesh():
    """Both on its side: they carry it, and the remark is only about the other direction."""
    model = loads_model(pair(MINUS, MINUS))
    found = solve_equilibrium(compile_model(model))
    axial = found["bearing_force[a1.axial]"].item() + found["bearing_force[a2.axial]"].item()
    assert axial == pytest.approx(found["bearing_force[b1.axial]"].item() * -1.0, rel=1e-6)
    assert axial == pytest.approx(2452.0, rel=1e-3)


@pytest.mark.parametrize(
    ("first", "second", "side"),
    [
        (FLOATING, FLOATING, 0),
        (PLUS, FLOATING, 1),
        (MINUS, MINUS, -1),
        (PLUS, MINUS, None),
        (FIXED, FLOATING, None),
        (FIXED, PLUS, None),
    ],
)
def test_remark_on_the_bearings_of_a_shaft(first, second, side):
    model = loads_model(pair(first, second))
    found = [each for each in remarks_of_file(model) if each.where == "shafts.s1"]
    assert [(e.body, e.side) for e in without_axial_support(model)] == (
        [] if side is None else [("s1", side)]
    )
    words = {
        0: "has axial loads, but nothing holds it along its axis: a1 and a2 support no axial force",
        1: "is held along its axis in one direction only: a1 and a2 support axial forces on it in its +z",
        -1: "is held along its axis in one direction only: a1 and a2 support axial forces on it in its -z",
    }
    assert len(found) == (side is not None)
    assert all(words[side] in str(each) and each.line == 6 for each in found)


BODIES = """\
bodies:
  s1: {motion: free, gears: [p], mass: 4 kg, inertia: 1e-2 kg m^2, transverse_inertia: 1e-2 kg m^2,
    position: [0, 0, 0]}
  s2: {motion: free, gears: [w]}
"""


def test_spur_gears_need_no_axial_support_unless_something_pushes():
    spur = re.sub(r"helix_angle: 18 deg, hand: \w+, ", "", pair(FLOATING, FLOATING))
    spur = spur.replace("center_distance: 140 mm", "center_distance: 134 mm")
    spur = re.sub("shafts:.*(?=rolling_bearings)", BODIES, spur, flags=re.DOTALL)
    assert not [*without_axial_support(loads_model(spur))]
    for more in ("gravity: [0, 0, -9.81 m/s^2]\n", ""):
        pushed = spur if more else spur.replace("loads: {", "loads: {f: {body: s1, force: [0, 0, 9 N]}, ")
        assert [e.body for e in without_axial_support(loads_model(more + pushed))] == ["s1"]
    across = spur.replace("loads: {", "loads: {f: {body: s1, force: [0, 9 N, 0]}, ")
    assert not [*without_axial_support(loads_model("gravity: [0, -9.81 m/s^2, 0]\n" + across))]


def test_spur_gears_push_a_shaft_that_bends():
    """The tooth force is normal to the flank, which tilts with the shaft: it has an axial component."""
    spur = re.sub(r"helix_angle: 18 deg, hand: \w+, ", "", pair(FLOATING, FLOATING))
    model = loads_model(spur.replace("center_distance: 140 mm", "center_distance: 134 mm"))
    assert [(e.body, e.side) for e in without_axial_support(model)] == [("s1", 0)]
    with pytest.raises(SolverError) as failure:
        solve_equilibrium(compile_model(model))
    assert str(failure.value) == (
        "no equilibrium: nothing holds s1 along its axis: a1 and a2 support no axial force; use a bearing "
        "that supports axial forces (line 6)"
    )
    assert failure.value.status == SINGULAR


def test_double_helical_gears_hold_their_shaft():
    """The statics agree: both halves carry half the torque, their axial forces cancel."""
    gears = (
        "  q: {number_of_teeth: 21, normal_module: 3 mm, helix_angle: 18 deg, hand: right,\n"
        "    face_width: 40 mm}\n"
        "  v: {number_of_teeth: 67, normal_module: 3 mm, helix_angle: 18 deg, hand: left,\n"
        "    face_width: 38 mm, profile_shift_coefficient: 0}\n"
    )
    text = pair(FLOATING, FLOATING).replace("shafts:\n", gears + "shafts:\n")
    text = text.replace("{p: 120 mm}", "{p: 80 mm, q: 130 mm}").replace(
        "{w: 110 mm}", "{w: 80 mm, v: 130 mm}"
    )
    text = text.replace(
        "center_distance: 140 mm}", "center_distance: 140 mm}, n: {gears: [q, v], center_distance: 140 mm}"
    )
    model = loads_model(text)
    assert not [*without_axial_support(model)]
    found = solve_equilibrium(compile_model(model))
    assert found["bearing_force[b1.axial]"].item() == pytest.approx(0.0, abs=1.0)
    assert found["bearing_force[a1.radial]"].item() > 100.0


def test_directions_of_bearings_with_their_own_axes():
    """A marker whose z axis is opposite to that of the shaft turns the supported direction around."""
    text = pair(PLUS, PLUS).replace(
        "gears: {p: 120 mm}",
        "gears: {p: 120 mm}, markers: {low: {position: [0, 0, 20 mm], axes: {z: [0, 0, -1]}}}",
    )
    text = text.replace("a1: {body: s1, position: [0, 0, 20 mm]", "a1: {ends: [s1.low, ground]")
    assert not [*without_axial_support(loads_model(text))]


PLANETS = """\
gears:
  sun: {number_of_teeth: 21, normal_module: 3 mm, helix_angle: 15 deg, hand: left, face_width: 40 mm,
    profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 99, normal_module: 3 mm, helix_angle: 15 deg, hand: right,
    face_width: 40 mm, profile_shift_coefficient: 0, bore_diameter: 360 mm, tip_diameter: 302 mm}
bodies:
  sun: {gears: [sun], motion: planar}
  ring: {gears: [ring], motion: fixed}
  carrier: {mass: 12 kg, inertia: 0.12}
planetary_stages:
  set:
    {sun: sun, ring: ring, carrier: carrier, planets: 3, motion: free,
    planet: {number_of_teeth: 39, normal_module: 3 mm, helix_angle: 15 deg, hand: right, face_width: 40 mm,
      profile_shift_coefficient: 0}}
bearings: {spline: {body: sun, stiffness: {radial: 1e6 N/m}}}
rolling_bearings:
"""
LOADS = "loads: {motor: {body: sun, torque: 600 N m}, output: {body: carrier, torque: balance}}\n"


def planets(designation: str, text: str = PLANETS) -> str:
    pins = (
        f"  {end}_{k}: {{body: planet_{k}, housing: carrier, position: [0, 0, {place} mm], {designation}}}\n"
        for k in (1, 2, 3)
        for end, place in (("low", -10), ("high", 10))
    )
    return text + "".join(pins) + LOADS


def test_planets_on_floating_bearings():
    """The forces of sun and ring on a helical planet cancel; nothing resists a screw motion along it."""
    model = loads_model(planets("designation: NU 208"))
    names = [f"planet_{k}" for k in (1, 2, 3)]
    assert [(each.body, each.side) for each in without_axial_support(model)] == [(n, 0) for n in names]
    found = [str(each) for each in remarks_of_file(model) if "along its axis" in each.text]
    assert len(found) == 3
    assert "nothing holds it along its axis: low_1 and high_1 support no axial force" in found[0]
    with pytest.raises(
        SolverError, match=r"nothing holds planet_1 along its axis: low_1 and high_1 support no"
    ):
        solve_equilibrium(compile_model(model))


@pytest.mark.parametrize(
    ("bearing", "sides"),
    [
        ("designation: NA4906", [0, 0, 0]),
        ("designation: 32206, axial_force_absorption: positive", [-1, -1, -1]),
        ("designation: 6206", []),
    ],
)
def test_outer_rings_in_the_planets(bearing, sides):
    """The bearing supports the planet with its outer ring: against the force on the pin."""
    pins = (f"  pin_{k}: {{ends: [carrier, planet_{k}], {bearing}}}\n" for k in (1, 2, 3))
    model = loads_model(PLANETS + "".join(pins) + LOADS)
    assert [each.side for each in without_axial_support(model)] == sides


def test_planets_on_fixed_bearings_and_spur_planets():
    fixed = loads_model(planets("designation: 6208"))
    assert not [*without_axial_support(fixed)]
    found = solve_equilibrium(compile_model(fixed))
    axial = [found[f"bearing_force[{name}.axial]"].item() for name in ("low_1", "high_1")]
    # the torques of sun and ring on a planet cancel, and so do the axial forces; its tilt is 2.9 mrad
    assert sum(axial) == pytest.approx(0.0, abs=1e-3 * found["axial_force[sun-planet_1]"].item())
    spur = re.sub(r"helix_angle: 15 deg, hand: \w+,", "", planets("designation: NU 208"))
    spur = spur.replace(
        "bore_diameter: 360 mm, tip_diameter: 302", "bore_diameter: 340 mm, tip_diameter: 292.5"
    )
    assert not [*without_axial_support(loads_model(spur))]
    upright = loads_model("gravity: [0, 0, -9.81 m/s^2]\n" + spur)
    assert [each.body for each in without_axial_support(upright)] == ["planet_1", "planet_2", "planet_3"]
