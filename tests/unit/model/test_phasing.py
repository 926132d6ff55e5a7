# SPDX-License-Identifier: Apache-2.0
"""Assembly of gears: after rolling, teeth of one gear and spaces of the other meet on the line of centres."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import Model
from tests.support.model_files import gear, pair

BODIES = "bodies:\n  one: {gears: {a: %s}, position: [0, 0, 0]}\n  two: {gears: {b: %s}}\n"


def on_line(model: Model, mesh_name: str) -> float:
    """Share of a pitch by which gear 2 misses a centred space when gear 1 is rolled to a centred tooth.

    Built from positions of the axes and rolling only: the pitch point divides the axes in the ratio of the
    teeth, outside them for internal pairs, and the speeds follow from equal velocities there.
    """
    mesh = model.meshes[mesh_name]
    one, two = (model.gears[n] for n in mesh.gears)
    z_1, z_2 = one.sign * one.number_of_teeth, two.sign * two.number_of_teeth
    axis_1 = model.bodies[str(model.body_of(mesh.gears[0]))].origin
    axis_2 = model.bodies[str(model.body_of(mesh.gears[1]))].origin
    assert axis_1 is not None
    assert axis_2 is not None
    a_x, a_y = axis_2[0] - axis_1[0], axis_2[1] - axis_1[1]
    share = z_1 / (z_1 + z_2)
    pitch = (axis_1[0] + share * a_x, axis_1[1] + share * a_y)
    plane = axis_1[2] + model.bodies[str(model.body_of(mesh.gears[0]))].gears[mesh.gears[0]] + mesh.offset1

    def phase(name: str, axis: tuple[float, float, float], z: int) -> float:
        """Angle of tooth 0 in the plane of the mesh, measured from the pitch point."""
        part = model.gears[name]
        body = model.bodies[str(model.body_of(name))]
        lead = plane - axis[2] - body.gears[name]
        # a right-hand helix (r cos s, r sin s, p s) rises with the angle
        radius = part.normal_module * abs(z) / math.cos(part.helix_angle) / 2.0
        hand = {"right": 1.0, "left": -1.0, None: 0.0}[part.hand]
        twist = hand * lead * math.tan(part.helix_angle) / radius
        direction = math.atan2(pitch[1] - axis[1], pitch[0] - axis[0])
        return model.phasing.tooth_angle[name] + twist - direction

    angle_1 = phase(mesh.gears[0], axis_1, z_1)
    # roll until tooth 0 of gear 1 is on the line; gear 2 turns against it (or with it, in a ring)
    angle_2 = phase(mesh.gears[1], axis_2, z_2) + angle_1 * z_1 / z_2
    return math.remainder(angle_2 * abs(z_2) / math.tau - 0.5, 1.0)


@pytest.mark.parametrize("direction", ["0 deg", "33 deg", "90 deg", "200 deg", "-71.3 deg"])
@pytest.mark.parametrize("start", ["0", "3.7 deg", "-2"])
@pytest.mark.parametrize("kind", ["external", "internal", "helical", "helical ring"])
def test_a_space_meets_the_tooth(direction: str, start: str, kind: str) -> None:
    helix = "" if "helical" not in kind else ", helix_angle: 17 deg, hand: "
    ring = kind.endswith(("ring", "internal"))
    hand_1, hand_2 = ("left", "left" if ring else "right") if helix else ("", "")
    first = gear("a", 23, 0.1, f"initial_angle: {start}{helix}{hand_1}")
    second = gear(
        "b",
        61 if ring else 40,
        -0.1 if ring else 0.2,
        ("type: internal" if ring else "type: external") + helix + hand_2,
    )
    text = pair(first, second, f"direction: {direction}", BODIES % ("7 mm", "-3 mm"))
    model = loads_model(text)
    assert on_line(model, "m") == pytest.approx(0.0, abs=1e-9)
    assert model.phasing.offset["m"] == pytest.approx(0.0, abs=1e-15)
    kept = math.remainder(model.phasing.tooth_angle["a"] - (model.gears["a"].initial_angle or 0.0), math.tau)
    assert kept == pytest.approx(0.0, abs=1e-12)


def test_wide_and_narrow_helical_gears_meet_in_the_common_width() -> None:
    helix = "helix_angle: 20 deg, hand: "
    text = pair(
        gear("a", 23, 0.0, helix + "right"),
        gear("b", 40, 0.0, helix + "left"),
        "direction: 10 deg",
        BODIES % ("0", "0"),
    )
    shifted = text.replace("two: {gears: {b: 0}}", "two: {gears: {b: 0}, position: [x, y, 8 mm]}")
    a_w = abs(loads_model(text).pairs["m"].a_w)
    x, y = (repr(a_w * f(math.radians(10.0))) for f in (math.cos, math.sin))
    model = loads_model(shifted.replace("x, y", f"{x}, {y}"))
    mesh = model.meshes["m"]
    assert mesh.b_w == pytest.approx(0.012)
    assert (mesh.offset1, mesh.offset2) == pytest.approx((0.004, -0.004))
    assert model.pairs["m"].b_w == pytest.approx(0.012)
    assert on_line(model, "m") == pytest.approx(0.0, abs=1e-9)


TRAIN = (
    "gears:\n" + gear("crank", 59) + gear("big", 68) + gear("small", 34) + gear("cam", 59) + "bodies:\n"
    "  k: {gears: [crank]}\n  i: {gears: {big: 0, small: 30 mm}}\n  n: {gears: [cam]}\n"
    "meshes:\n  s1: {gears: [crank, big], direction: 20 deg}\n"
    "  s2: {gears: [small, cam], direction: 110 deg}\n"
)


def test_trains_propagate() -> None:
    model = loads_model(TRAIN)
    assert on_line(model, "s1") == pytest.approx(0.0, abs=1e-9)
    assert on_line(model, "s2") == pytest.approx(0.0, abs=1e-9)
    assert model.bodies["n"].origin is not None
    assert model.bodies["n"].origin[2] == pytest.approx(0.03)


def test_a_planet_between_sun_and_ring_fits_when_the_teeth_allow() -> None:
    planets = "".join(gear(f"p{i}", 18) for i in range(3))
    text = (
        "gears:\n"
        + gear("sun", 24)
        + gear("ring", 60, 0, "type: internal, tip_diameter: 177 mm")
        + planets
        + "meshes:\n"
    )
    for i in range(3):
        text += f"  s{i}: {{gears: [sun, p{i}], direction: {120 * i} deg}}\n"
        text += f"  r{i}: {{gears: [p{i}, ring], direction: {120 * i + 180} deg}}\n"
    phasing = loads_model(text).phasing
    # (24 + 60) / 3 is whole, so three planets at equal angles can be assembled
    assert max(abs(v) for v in phasing.offset.values()) < 1e-12
    with pytest.raises(ModelError, match="loop of meshes"):
        loads_model(
            text.replace("r1: {gears: [p1, ring], direction: 300", "r1: {gears: [p1, ring], direction: 301")
        )


def test_two_given_angles_leave_an_offset_inside_the_backlash() -> None:
    text = pair(
        gear("a", 30, 0.0, "initial_angle: 0"),
        gear("b", 30, 0.0, "initial_angle: 174.05 deg, tooth_thickness_allowance: -0.3 mm"),
    )
    model = loads_model(text)
    # gear b stands 0.05 deg from the centred 174 deg; r_b = 45 mm cos 20 deg
    expected = math.radians(0.05) * 0.045 * math.cos(math.radians(20.0))
    assert model.phasing.offset["m"] == pytest.approx(expected, rel=1e-9)


def test_travel_is_zero_with_a_tooth_on_the_line() -> None:
    model = loads_model(pair(gear("a", 30, 0.0, "initial_angle: 0.01"), gear("b")))
    assert model.phasing.travel["m"] == pytest.approx(0.01 * 0.045 * math.cos(math.radians(20.0)), rel=1e-12)
