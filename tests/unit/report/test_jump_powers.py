# SPDX-License-Identifier: Apache-2.0
"""The work of stiffness jumps closes the power balance of gears without tip relief."""

from __future__ import annotations

import pytest

import pitchpoint as pp
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.power_flow import power_flow
from pitchpoint.viz.power_flow import PowerFlow
from pitchpoint.viz.report.power import balance

RIG = """\
gears:
  a: {{number_of_teeth: 16, normal_module: 4.5 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
  b: {{number_of_teeth: 24, normal_module: 4.5 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
  c: {{number_of_teeth: 16, normal_module: 4.5 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
  d: {{number_of_teeth: 24, normal_module: 4.5 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
bodies:
  p1: {{gears: [a], motion: torsion}}
  w1: {{gears: [b], motion: torsion, position: [90 mm, 0, 0]}}
  p2: {{gears: [c], motion: torsion, position: [0, 0, 300 mm]}}
  w2: {{gears: [d], motion: torsion, position: [90 mm, 0, 300 mm]}}
torsion_springs:
  clutch: {{bodies: [p1, p2], stiffness: 2e4 N m/rad, angle: 1.4 deg, damping: 5 N m s/rad}}
couplings:
  shaft: {{bodies: [w1, w2], stiffness: {{torsion: 1e5 N m/rad}}, damping: {{torsion: 5 N m s/rad}}}}
meshes:
  test: {{gears: [a, b], center_distance: 90 mm, friction: {{mu: 0.05}},
    damping: {{ratio: 0.05}}, stiffness: {{law: din3990}}}}
  slave: {{gears: [c, d], center_distance: 90 mm, friction: {{mu: 0.05}},
    damping: {{ratio: 0.05}}, stiffness: {{law: din3990}}}}
scenarios:
  run: {{drive: {{w2: {{speed: 1450 rpm}}}}, duration: 0.05 s, step: 5 us{rate}}}
"""


def flow_of(rate: str = "") -> PowerFlow:
    model = loads_model(RIG.format(rate=rate))
    result = pp.solve_time(pp.compile_model(model, "run")).assign_attrs(scenario="run")
    flow = power_flow(model, result, 0.01)
    assert flow is not None
    return flow


@pytest.fixture(scope="module")
def flow() -> PowerFlow:
    return flow_of()


def test_jumps_of_the_front_and_the_back_flank_close_the_balance(flow: PowerFlow) -> None:
    jumps = {link.name: link.jumps for link in flow.links if link.kind == "mesh"}
    # both meshes carry the same circulating power, one on each flank
    assert min(jumps.values()) > 20.0
    assert abs(flow.remainder) < 0.03 * flow.jumps
    assert "stiffness jumps where tooth pairs without relief enter and leave" in balance(flow)


def test_a_remainder_is_given_relative_to_the_input_of_a_closed_loop(flow: PowerFlow) -> None:
    share = 100.0 * abs(flow.remainder) / flow.put_in
    assert f"{share:.2g} % of the input" in balance(flow)


def test_samples_that_do_not_separate_the_jumps_are_named() -> None:
    flow = flow_of(", sample_rate: 2 kHz")
    assert flow.jumps == 0.0
    assert flow.unseparated == ["test", "slave"]
    assert "stiffness jumps of test, slave, which the samples do not separate" in balance(flow)
