# SPDX-License-Identifier: Apache-2.0
"""Power flow: force times speed at the pitch point, Willis on a carrier, energy of rotation, what is left."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import xarray as xr

from pitchpoint.core.errors import PitchpointError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.power_flow import power_flow
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.power_flow import OUTSIDE, PowerFlow, PowerLink
from tests.unit.report.test_scene import CARRIER

PAIR = """\
gears:
  a: {number_of_teeth: 20, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 50, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
bodies:
  motor: {motion: torsion, inertia: 0.2 kg m^2, position: [-1, 0, 0]}
  first: {gears: [a], motion: torsion, inertia: 0.01 kg m^2}
  second: {gears: [b], motion: torsion, inertia: 0.5 kg m^2}
meshes:
  m: {gears: [a, b], stiffness: {law: constant, value: 3e8 N/m}}
couplings:
  c: {bodies: [motor, first], stiffness: {torsion: 1e4 N m/rad}}
loads:
  in: {body: motor, torque: 1 N m}
  out: {body: second, torque: balance}
scenarios:
  on: {speed: {first: 600 rpm}, duration: 0.2 s}
"""
RADII = 0.03, 0.075
TIME = np.linspace(0.0, 0.5, 2001)
COSINE = np.cos(np.radians(20.0))
FORCE, FRICTION, DAMPING, FED, SLIP = 1500.0, 12.0, 3.0, 0.5, 0.2


def record(speed: np.ndarray, force: np.ndarray) -> dict[str, np.ndarray]:
    """Channels of the pair, all torques such that every body is in balance at every instant."""
    rate = np.gradient(speed, TIME)
    first, second = RADII
    turned = force * first + FRICTION / speed + 0.01 * rate
    one = np.ones_like(TIME)
    return {
        "speed[motor]": speed * (1.0 + SLIP),
        "speed[first]": speed,
        "speed[second]": -speed * first / second,
        "torque[in]": turned + 0.2 * rate * (1.0 + SLIP),
        "coupling_force[c.mz]": -turned,
        "torque[out]": force * second - 0.5 * rate * first / second,
        "mesh_force[m]": force / COSINE * side(),
        "friction_power[m]": FRICTION * one,
        "damping_power[m]": 0.0 * one,
        "parametric_power[m]": 0.0 * one,
        "elastic_energy[m]": 0.0 * one,
    }


@cache
def side() -> float:
    """Sense of the mesh force: power goes from the first gear to the second."""
    model = loads_model(PAIR)
    result = solve_time(compile_model(model, "on"))
    return float(np.sign(result["mesh_force[m]"].values[-1]))


def flow_of(channels: dict[str, np.ndarray], settle: float = 0.0) -> PowerFlow:
    data = xr.Dataset({name: ("time", values) for name, values in channels.items()}, {"time": TIME})
    data.attrs["scenario"] = "on"
    found = power_flow(loads_model(PAIR), data, settle)
    assert found is not None
    return found


def link(flow: PowerFlow, name: str) -> PowerLink:
    return next(link for link in flow.links if link.name == name)


@pytest.fixture(scope="module")
def channels() -> dict[str, np.ndarray]:
    """An even speed and a force that swings with it: their means alone would not give the power."""
    wave = np.sin(2.0 * np.pi * 40.0 * TIME)
    return record(60.0 + 0.0 * wave, FORCE * (1.0 + 0.5 * wave))


def test_the_power_of_a_mesh_is_force_times_speed_at_the_pitch_point(channels: dict[str, np.ndarray]) -> None:
    flow = flow_of(channels)
    power = FORCE * RADII[0] * 60.0
    mesh = link(flow, "m")
    assert [block.name for block in flow.blocks] == ["motor", "first", "second"]
    assert (mesh.start, mesh.end) == (1, 2)
    assert mesh.taken == pytest.approx(power, rel=1e-9)
    assert mesh.given == pytest.approx(power + FRICTION, rel=1e-9)
    assert mesh.losses == {"friction": pytest.approx(FRICTION)}
    slipping = link(flow, "c")
    assert slipping.losses == {"damping": pytest.approx(SLIP * (power + FRICTION))}
    assert link(flow, "in").start == OUTSIDE
    assert link(flow, "out").end == OUTSIDE
    assert flow.put_in == pytest.approx((1.0 + SLIP) * (power + FRICTION), rel=1e-9)
    assert flow.taken_out == pytest.approx(power, rel=1e-9)
    assert abs(flow.remainder) < 1e-9 * power


def test_what_the_mesh_is_fed_and_what_is_missing_stay_apart(channels: dict[str, np.ndarray]) -> None:
    """What damping takes of the power that the stiffness feeds is not a remainder; a missing torque is."""
    one = np.ones_like(TIME)
    fed = channels | {"parametric_power[m]": FED * one, "damping_power[m]": FED * one}
    assert abs(flow_of(fed).remainder) < 1e-6
    lost = flow_of(channels | {"torque[out]": channels["torque[out]"] - DAMPING})
    assert lost.remainder == pytest.approx(DAMPING * 60.0 * RADII[0] / RADII[1], rel=1e-9)


def test_a_run_up_puts_power_into_rotation() -> None:
    """Speeds that grow linearly with the time: every energy over the span is known in closed form."""
    flow = flow_of(record(20.0 + 80.0 * TIME, FORCE + 0.0 * TIME), settle=0.1)
    ends = np.array([20.0 + 80.0 * 0.1, 60.0])
    for block, inertia, ratio in zip(flow.blocks, (0.2, 0.01, 0.5), (1.2, 1.0, -0.4), strict=True):
        energy = 0.5 * inertia * (ratio * ends) ** 2
        assert block.stored == pytest.approx((energy[1] - energy[0]) / 0.4, rel=1e-6)
        assert block.speed == pytest.approx(ratio * ends.mean(), rel=1e-6)
    assert abs(flow.remainder) < 1e-3 * flow.put_in


def test_means_of_all_steps_correct_samples_that_keep_step_with_the_teeth(
    channels: dict[str, np.ndarray],
) -> None:
    data = xr.Dataset({name: ("time", values) for name, values in channels.items()}, {"time": TIME})
    data.attrs["scenario"] = "on"
    data.attrs["steps"] = 10 * TIME.size
    off = 10.0 * side()
    data["mesh_force[m]"] = data["mesh_force[m]"] - off
    mean = FORCE / COSINE * side()
    data["mesh_force[m]"].attrs["statistics"] = (mean, 0.0, mean, mean)
    flow = power_flow(loads_model(PAIR), data)
    assert flow is not None
    assert link(flow, "m").taken == pytest.approx(FORCE * RADII[0] * 60.0, rel=1e-9)


def test_planets_hand_their_power_to_the_carrier() -> None:
    """Willis: 20 N m at 300 rpm go through the planet, which rolls in the fixed ring, to the carrier."""
    model = loads_model(CARRIER.replace("duration: 0.4 s", "duration: 0.05 s"))
    flow = power_flow(model, solve_time(compile_model(model, "on")), 0.01)
    assert flow is not None
    power = 20.0 * 300.0 * np.pi / 30.0
    ways = {link.name: link for link in flow.links}
    names = [block.name for block in flow.blocks]
    assert set(names) == {"sun", "carrier", "planet"}
    assert flow.blocks[names.index("carrier")].speed == pytest.approx(10.0 * np.pi * 24 / 84, rel=1e-6)
    for name, start, end in (("sp", "sun", "planet"), ("planet on carrier", "planet", "carrier")):
        assert (names[ways[name].start], names[ways[name].end]) == (start, end)
        assert ways[name].given == pytest.approx(power, rel=1e-3)
    assert max(ways["pr"].given, ways["pr"].taken) < 1e-6 * power
    assert flow.taken_out == pytest.approx(power, rel=1e-3)
    assert abs(flow.remainder) < 1e-3 * power


def test_a_result_without_the_channels_says_what_is_missing(channels: dict[str, np.ndarray]) -> None:
    del (few := dict(channels))["speed[second]"]
    with pytest.raises(PitchpointError, match=r"does not contain speed\[second\]"):
        flow_of(few)


def test_nothing_flows_where_nothing_joins_what_turns() -> None:
    alone = loads_model("bodies:\n  motor: {motion: torsion, inertia: 1 kg m^2, position: [0, 0, 0]}\n")
    data = xr.Dataset({"speed[motor]": ("time", TIME)}, {"time": TIME})
    assert power_flow(alone, data) is None
