# SPDX-License-Identifier: Apache-2.0
"""Energy in deflected couplings, shafts and bearings is stored, not lost."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.power_flow import UNKNOWN, power_flow
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.power_flow import PowerFlow
from pitchpoint.viz.report.power import balance, power_section

STIFFNESS = 4000.0

WOUND = """\
gears:
  p: {{number_of_teeth: 24, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
  w: {{number_of_teeth: 48, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
bodies:
  pin: {{gears: [p], inertia: 0.04 kg m^2}}
  whl: {{gears: [w], inertia: 0.05 kg m^2}}
  gen: {{motion: torsion, inertia: 1 kg m^2}}
{coupling}
meshes:
  st: {{gears: [p, w], stiffness: {{law: constant, value: 3e8 N/m}}, damper: {{ratio: 0.05}}}}
loads:
  e: {{body: pin, torque: "50 N m*(1 + min(t/(10 ms), 1))"}}
  l: {{body: gen, torque: 100 N m}}
scenarios:
  s: {{speed: {{pin: 3000 rpm}}, duration: 0.0125 s, step: 5 us}}
"""
SPRING = "couplings:\n  g: {{bodies: [whl, gen], stiffness: {{torsion: 4000}}, damping: {{torsion: {}}}}}"
MAXWELL = SPRING.format(0) + (
    "\ntorsion_maxwells:\n  x: {bodies: [whl, gen], stiffness: 2000 N m/rad, damping: 20 N m s/rad}"
)

SHAFTS = """\
gears:
  a: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, helix_angle: 15 deg, hand: left,
    profile_shift_coefficient: 0}
  b: {number_of_teeth: 60, normal_module: 3 mm, face_width: 20 mm, helix_angle: 15 deg, hand: right,
    profile_shift_coefficient: 0}
shafts:
  one: {sections: [{length: 200 mm, diameter: 25 mm}], gears: {a: 100 mm}}
  two: {sections: [{length: 300 mm, diameter: 40 mm}], gears: {b: 100 mm}}
bodies:
  machine: {motion: torsion, inertia: 1 kg m^2}
bearings:
  l: {body: one, position: [0, 0, 10 mm], stiffness: {radial: 2e7 N/m, axial: 1e8 N/m},
    damping: {ratio: 0.05}}
  r: {body: one, position: [0, 0, 190 mm], stiffness: {radial: 2e7 N/m}, damping: {ratio: 0.05}}
  l2: {body: two, position: [0, 0, 10 mm], stiffness: {radial: 3e7 N/m, axial: 1e8 N/m},
    damping: {ratio: 0.05}}
  r2: {body: two, position: [0, 0, 290 mm], stiffness: {radial: 3e7 N/m}, damping: {ratio: 0.05}}
couplings:
  c: {bodies: [two, machine], position: [0, 0, 300 mm], stiffness: {torsion: 2e4}, damping: {torsion: 20}}
meshes:
  m: {gears: [a, b], center_distance: 125 mm,
    stiffness: {law: constant, value: 3e8 N/m}, damper: {ratio: 0.05}}
loads:
  in: {body: one, position: [0, 0, 0], torque: "60*(0.2 + 0.8*min(t/0.02, 1))"}
  out: {body: machine, torque: "180*(0.2 + 0.8*min(t/0.02, 1))"}
scenarios:
  s: {speed: {one: 1000 rpm}, duration: 0.05 s, step: 5 us}
"""


def flow_of(text: str) -> tuple[PowerFlow, xr.Dataset]:
    model = loads_model(text)
    data = solve_time(compile_model(model, "s"))
    flow = power_flow(model, data)
    assert flow is not None
    return flow, data


def test_an_undamped_coupling_that_winds_up_loses_nothing() -> None:
    """Stored are T^2/(2 k): the torque of an undamped coupling is that of its spring."""
    flow, data = flow_of(WOUND.format(coupling=SPRING.format(0)))
    coupling = next(link for link in flow.links if link.name == "g")
    torque = data["coupling_force[g.mz]"].values[[0, -1]]
    wound = np.diff(torque**2)[0] / (2.0 * STIFFNESS) / (flow.span[1] - flow.span[0])
    assert abs(wound) > 50.0
    assert coupling.stored == pytest.approx(wound, rel=1e-6)
    assert not coupling.losses
    assert abs(flow.remainder) < 1e-6 * flow.put_in
    assert "stored in rotation and deflection" in balance(flow)
    assert "stored [W]" in "".join(power_section({"s": flow}).parts)


def test_a_damped_coupling_loses_what_its_damper_takes() -> None:
    flow, data = flow_of(WOUND.format(coupling=SPRING.format(3)))
    coupling = next(link for link in flow.links if link.name == "g")
    slip = data["speed[whl]"].values - data["speed[gen]"].values
    time = data["time"].values
    lost = np.trapezoid(3.0 * slip**2, time) / (time[-1] - time[0])
    assert coupling.losses == {"damping": pytest.approx(lost, rel=1e-3)}
    assert abs(flow.remainder) < 1e-6 * flow.put_in


def test_the_spring_of_a_maxwell_element_stores_energy() -> None:
    """Its damper has the torque of the spring: T^2/d is lost."""
    flow, data = flow_of(WOUND.format(coupling=MAXWELL))
    element = next(link for link in flow.links if link.name == "x")
    time, torque = data["time"].values, data["torque[x]"].values
    lost = np.trapezoid(torque**2 / 20.0, time) / (time[-1] - time[0])
    assert element.losses == {"damping": pytest.approx(lost, rel=1e-3)}


def test_shafts_and_bearings_store_what_does_not_come_out() -> None:
    """Torsion of the shafts and the deflected bearings take 8 W; only bearing damping is left, 1e-6."""
    flow, _ = flow_of(SHAFTS)
    assert flow.elastic > 0.5
    assert min(block.stored for block in flow.blocks if block.name != "machine") > 1.0
    assert abs(flow.remainder) < 3e-6 * flow.put_in


def test_without_displacements_the_report_says_what_is_missing() -> None:
    model = loads_model(WOUND.format(coupling=SPRING.format(0)))
    data = solve_time(compile_model(model, "s")).drop_vars(["angle[whl]"])
    flow = power_flow(model, data)
    assert flow is not None
    assert UNKNOWN in balance(flow)


ON_BEARINGS = """\
gears:
  a: {number_of_teeth: 25, normal_module: 3 mm, helix_angle: 12 deg, hand: right, face_width: 30 mm,
    profile_shift_coefficient: 0}
  b: {number_of_teeth: 50, normal_module: 3 mm, helix_angle: 12 deg, hand: left, face_width: 30 mm,
    profile_shift_coefficient: 0}
bodies:
  in: {gears: [a], motion: free, position: [0, 0, 0], mass: 3 kg, inertia: 0.003 kg m^2,
    transverse_inertia: 0.01 kg m^2}
  out: {gears: [b], motion: free, mass: 8 kg, inertia: 0.03 kg m^2, transverse_inertia: 0.04 kg m^2}
bearings:
  in_1: {body: in, position: [0, 0, -60 mm], stiffness: {radial: 2e8 N/m, axial: 1e8 N/m},
    damping: {radial: 3000 N s/m, axial: 1000 N s/m}}
  in_2: {body: in, position: [0, 0, 60 mm], stiffness: {radial: 2e8 N/m}, damping: {radial: 3000 N s/m}}
  out_1: {body: out, position: [0, 0, -60 mm], stiffness: {radial: 2e8 N/m, axial: 1e8 N/m},
    damping: {radial: 3000 N s/m, axial: 1000 N s/m}}
  out_2: {body: out, position: [0, 0, 60 mm], stiffness: {radial: 2e8 N/m}, damping: {radial: 3000 N s/m}}
meshes:
  m: {gears: [a, b], stiffness: {law: din3990}, damping: {ratio: 0.05}}
loads:
  drive: {body: in, torque: 200 N m}
  brake: {body: out, torque: balance}
scenarios:
  s: {speed: {in: 2300 rpm}, duration: 0.05 s, step: 10 us}
"""


def test_bearings_dissipate_what_their_dampers_take() -> None:
    """Sum of d v^2 at the bearings; it is ten times the damping of the teeth, and closes the balance."""
    flow, data = flow_of(ON_BEARINGS)
    time = data["time"].values
    expected = 0.0
    for body in ("in", "out"):
        x, y, z, rx, ry = (
            np.gradient(data[f"displacement[{body}.{c}]"].values, time) for c in ("x", "y", "z", "rx", "ry")
        )
        for place in (-0.06, 0.06):
            expected += np.trapezoid(3000.0 * ((x + place * ry) ** 2 + (y - place * rx) ** 2), time)
        expected += np.trapezoid(1000.0 * z**2, time)
    expected /= time[-1] - time[0]
    assert flow.damped == pytest.approx(expected, rel=2e-3)
    assert flow.lost == pytest.approx(flow.damped + sum(link.lost for link in flow.links))
    assert flow.damped > 5.0 * sum(link.lost for link in flow.links)
    assert abs(flow.remainder) < 0.1 * flow.damped
    assert not flow.unfollowed
    assert "by damping outside meshes and couplings)" in balance(flow)


def test_a_record_of_some_steps_leaves_bearings_in_the_remainder() -> None:
    flow, _ = flow_of(ON_BEARINGS.replace("step: 10 us", "step: 10 us, sample_rate: 5 kHz"))
    assert flow.damped == 0.0
    assert flow.unfollowed == ["bearings"]


def test_rayleigh_damping_is_a_loss() -> None:
    """The balance of a machine that vibrates about its rotation closes with the power of D v."""
    text = WOUND.format(coupling=SPRING.format(0)) + "damping: {rayleigh: {mass: 20 1/s, stiffness: 0 s}}\n"
    flow, _ = flow_of(text)
    assert flow.damped > 1e-4 * flow.put_in
    assert abs(flow.remainder) < 1e-6 * flow.put_in
    assert not flow.unfollowed
