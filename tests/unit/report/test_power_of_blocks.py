# SPDX-License-Identifier: Apache-2.0
"""What comes to every block and does not stay in it leaves it again, with all that loses power in a mesh.

Bodies only turn, and the record has every step, so nothing is lost but the trapezoidal rule: with steps of
5 µs and friction that reverses over a few samples it is 2e-9 to 2e-7 of the power.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.power_flow import power_flow
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.power_flow import PowerFlow
from tests.support.scene_models import CARRIER

LAWS = (
    "stiffness: {law: din3990, tip_relief_factor: 0.5}, damping: {ratio: 0.1}, damper: {ratio: 0.02}, "
    "friction: {mu: 0.06, v_eps: 0.05 m/s}"
)
WHEEL = "number_of_teeth: {}, face_width: 20 mm, profile_shift_coefficient: 0, normal_module: 2 mm"
TIMES = "duration: 0.01 s, step: 5 us"
CLOSES = 1e-6

TWO = """\
gears:
  a: {{{one}}}
  b: {{{two}}}
bodies:
  first: {{gears: [a], motion: torsion, inertia: 0.01 kg m^2}}
  second: {{gears: [b], motion: torsion, inertia: 0.1 kg m^2}}
meshes:
  m: {{gears: [a, b], {laws}}}
loads:
  in: {{body: first, torque: balance}}
  out: {{body: second, torque: {torque} N m}}
scenarios:
  on: {{speed: {{first: 600 rpm}}, {times}}}
"""
PAIRS = {
    "spur": (20, "", "50", 100),
    "back flanks": (20, "", "50", -100),
    "helical": (20, ", helix_angle: 20 deg, hand: left", "50, helix_angle: 20 deg, hand: right", 100),
    "internal": (20, "", "70, type: internal", -100),
}

TWO_PLANETS = f"""\
gears:
  sun: {{{WHEEL.format(24)}}}
  p1: {{{WHEEL.format(18)}}}
  p2: {{{WHEEL.format(18)}}}
  far: {{{WHEEL.format(18)}}}
  other: {{{WHEEL.format(24)}}}
bodies:
  one: {{gears: [sun], motion: torsion, position: [0, 0, 0], inertia: 0.01 kg m^2}}
  two: {{gears: {{other: 30 mm}}, motion: torsion, position: [0, 0, 0], inertia: 0.01 kg m^2}}
  carrier: {{motion: torsion, position: [0, 0, 0], inertia: 0.05 kg m^2, mass: 2 kg}}
  near: {{gears: [p1], inertia: 0.001 kg m^2, mass: 0.5 kg}}
  long: {{gears: {{p2: 0 mm, far: 30 mm}}, inertia: 0.001 kg m^2, mass: 0.5 kg}}
joints:
  pin: {{type: revolute, bodies: [carrier, near], position: [42 mm, 0, 0]}}
  peg: {{type: revolute, bodies: [carrier, long],
    position: [{42 - 648 / 42} mm, {36 * math.sqrt(1 - (18 / 42) ** 2)} mm, 0]}}
meshes:
  s1: {{gears: [sun, p1], backlash: {{base_tangent: 0.05 mm}}, {LAWS}}}
  pp: {{gears: [p1, p2], backlash: {{base_tangent: 0.05 mm}}, {LAWS}}}
  s2: {{gears: [far, other], backlash: {{base_tangent: 0.05 mm}}, {LAWS}}}
loads:
  in: {{body: carrier, torque: balance}}
  left: {{body: one, torque: -60 N m}}
  right: {{body: two, torque: -60 N m}}
scenarios:
  on: {{speed: {{carrier: 300 rpm, one: 350 rpm}}, {TIMES}}}
"""


def flow_of(text: str, scenario: str = "on") -> PowerFlow:
    model = loads_model(text)
    flow = power_flow(model, solve_time(compile_model(model, scenario)))
    assert flow is not None
    return flow


def check(flow: PowerFlow, blocks: int) -> None:
    """Every block closes by itself, though meshes lose and feed far more than that."""
    most = max(link.given for link in flow.links)
    assert len(flow.blocks) == blocks
    assert max(abs(flow.left(k)) for k in range(blocks)) < CLOSES * most
    meshes = [link for link in flow.links if link.kind == "mesh"]
    assert sum(link.losses["friction"] for link in meshes) > 100.0 * CLOSES * most
    assert sum(link.losses["damping"] for link in meshes) > 0.0
    assert abs(flow.remainder) < 5.0 * CLOSES * most  # bends of the stiffness between two samples
    assert not flow.booked


@pytest.mark.parametrize("pair", PAIRS)
def test_pairs(pair: str) -> None:
    teeth, more, other, torque = PAIRS[pair]
    one, two = WHEEL.format(teeth) + more, WHEEL.format(other)
    flow = flow_of(TWO.format(one=one, two=two, laws=LAWS, torque=torque, times=TIMES))
    check(flow, 2)
    mesh = next(link for link in flow.links if link.kind == "mesh")
    assert (mesh.start, mesh.end) == ((0, 1) if pair in ("spur", "helical", "internal") else (1, 0))


def test_a_damper_is_part_of_what_both_gears_feel() -> None:
    """Teeth that swing with their stiffness; circumferential forces of the flanks do not hold the damper."""
    law = "stiffness: {law: fourier, mean: 3e8, cosine: [0.3]}, damper: {ratio: 0.1}"
    one, two = (WHEEL.format(z) for z in (20, 50))
    text = TWO.format(one=one, two=two, laws=law, torque=100, times=TIMES).replace("600 rpm", "2000 rpm")
    flow = flow_of(text)
    most = max(link.given for link in flow.links)
    assert sum(link.lost for link in flow.links) > 1e-3 * most
    assert max(abs(flow.left(k)) for k in range(2)) < CLOSES * most


def test_a_planet_in_a_ring_that_stands() -> None:
    text = CARRIER.replace("stiffness: {law: constant, value: 3e8 N/m}", LAWS)
    text = text.replace(", damping: {ratio: 0.05}}", "}").replace(
        "duration: 0.4 s, sample_rate: 1 kHz", TIMES
    )
    check(flow_of(text), 3)


def test_planets_that_mesh_with_each_other_aside_from_the_axis_of_their_carrier() -> None:
    """The line of both planets misses the axis by 38 mm: there their radial force has an arm as well."""
    check(flow_of(TWO_PLANETS), 5)


BEVELS = """\
bevel_gears:
  a: {{number_of_teeth: 17, mate_teeth: 43, opens: +z, {shape}}}
  b: {{number_of_teeth: 43, mate_teeth: 17, opens: +z, {shape2}}}
bodies:
  first: {{motion: torsion, bevel_gears: [a], position: [0, 0, 0], axes: {{z: [1, 0, 0], x: [0, 0, 1]}}, inertia: 0.01}}
  second: {{motion: torsion, bevel_gears: [b], position: [0, 0, 0], axes: {{z: [0, 0, 1], x: [1, 0, 0]}}, inertia: 0.1}}
bevel_meshes:
  m: {{gears: [a, b], {laws}}}
loads:
  in: {{body: first, torque: balance}}
  out: {{body: second, torque: 100 N m}}
scenarios:
  on: {{speed: {{first: 600 rpm}}, {times}}}
"""  # noqa: E501
CONE = (
    "outer_transverse_module: 4 mm, face_width: 26 mm, profile_shift_coefficient: {}, "
    "tooth_thickness_allowance: -0.03 mm"
)


@pytest.mark.parametrize("spiral", [0, 35])
def test_bevel_gears(spiral: int) -> None:
    hands = (f", spiral_angle: {spiral} deg, hand: {hand}" if spiral else "" for hand in ("right", "left"))
    one, two = (CONE.format(x) + hand for x, hand in zip((0.3, -0.3), hands, strict=True))
    check(flow_of(BEVELS.format(shape=one, shape2=two, laws=LAWS, times=TIMES)), 2)


def test_bevel_planets_on_a_cage() -> None:
    """Both planets rub on both wheels, which turn at different speeds, and hand their power to the cage."""
    from pathlib import Path

    text = (Path(__file__).parents[3] / "examples/bevel-drive/differential.yaml").read_text("utf-8")
    text = text.replace("stiffness: {law: constant, value: 2e8}, damping: {ratio: 0.1}", LAWS)
    text = text.replace("duration: 0.3 s, step: 40 us, settle_time: 0.1 s", TIMES)
    check(flow_of(text, "bend"), 5)
