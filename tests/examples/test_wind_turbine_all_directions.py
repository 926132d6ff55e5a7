# SPDX-License-Identifier: Apache-2.0
"""The example `wind-turbine` with the gearbox in all directions, and with long steps outside of gears.

Frames: z of the gearbox from the rotor to the generator, x upward; the generator turns against the rotor.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.speed_ratios import start_speeds
from pitchpoint.solvers.contact_counts import new_counts
from pitchpoint.solvers.implicit import gear_part, generalized_alpha
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.sampling import new_statistics, read_statistics
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

pytestmark = pytest.mark.filterwarnings("ignore:profile shifts:pitchpoint.ValidityWarning")
FOLDER = Path(__file__).parents[2] / "examples" / "wind-turbine"
RATIO = (1 + 56 / 19) * (1 + 93 / 18) * 95 / 24
PLANETS = (1, 2, 3)


def started(include: str, **changes):
    """System and state of the rotating equilibrium at 8 m/s."""
    model = load_model(FOLDER / "model.yaml", changes={"include": include, **changes})
    system = compile_model(model, "production")
    begin = prepare_start(system, system.scenario)
    row = evaluate.observe(begin.system, begin.state)
    return model, begin, lambda name: float(row[begin.system.layout.channel(name)])


@pytest.fixture(scope="module")
def turbine():
    return started("gearbox_all_directions.yaml")


def test_parts_have_the_mass_of_the_nacelle(turbine):
    """240 t, centre of mass 1.9 m behind the yaw axis and 1.75 m above the tower top (NREL/TP-500-38060)."""
    from pitchpoint.model.frames import body_frame

    model = turbine[0]
    mass, moment = 0.0, np.zeros(3)
    for name in model.bodies:
        if not name.startswith(("tip", "root", "hub", "tower")):
            inertia, (origin, axes) = model.body_inertia(name), body_frame(model, name)
            mass += inertia.mass
            moment += inertia.mass * (origin + axes @ np.array(inertia.place))
    assert mass == pytest.approx(240e3, rel=1e-4)
    np.testing.assert_allclose(moment / mass, [1.9, 0.0, 87.6 + 1.75], atol=1e-3)


def test_the_housing_on_torque_arms_is_at_rest_at_the_start(turbine):
    """The nacelle, which only yaws, does not let it rotate with the gears: ratio of the planetary stages."""
    speeds, wrong = start_speeds(turbine[0], {"generator": -RATIO})
    assert not wrong and speeds["housing"] == 0.0
    assert speeds["main_shaft"] == pytest.approx(1.0, rel=1e-12)


def test_a_locked_generator_on_the_slow_side_rolls_with_97_squared_times_its_inertia():
    """Inertia of the nacelle about a horizontal axis: two masses less rigid ratio, both locked."""
    roll = []
    for train in ("two_mass.yaml", "rigid_ratio.yaml"):
        model = load_model(FOLDER / "model.yaml", changes={"include": train})
        system = compile_model(model, "parked")
        M = evaluate.matrix(system, system.initial_state(), 1.0, 0.0, 0.0)
        axis = system.layout.coordinate("tower_top.alpha")
        roll.append(M[axis, axis])
    more = (534.116 * (97**2 - 1) - 1.0) * 0.996195**2  # 1 kg m^2 of the low-speed shaft
    assert roll[0] - roll[1] == pytest.approx(more, rel=1e-5)


def test_torque_arms_carry_both_torques(turbine):
    """Housing: the torque of the rotor less the excess of the wind, and that of the generator, T (1 + i)."""
    value = turbine[2]
    arms = 2.0 * (value("bushing_force[torque_arm_right.fx]") - value("bushing_force[torque_arm_left.fx]"))
    assert arms == pytest.approx(value("signal[generator_torque]") * (1.0 + RATIO), rel=1e-4)


def test_mean_tooth_forces_are_those_of_the_torque(turbine):
    """KISSsoft reports: 829.5 and 255.9 kN for 3946 kN m. In the mean of the planets: loads of weight cancel
    in the balance of the sun; the lines of action turn by the displacements of the shafts, 1e-3."""
    value = turbine[2]
    share = value("signal[generator_torque]") * RATIO / 3945.99e3
    sun = np.mean([abs(value(f"mesh_force[sun_1-planet_{k}]")) for k in PLANETS])
    assert sun == pytest.approx(829.5e3 * share, rel=2e-3)
    assert abs(value("mesh_force[stage_3]")) == pytest.approx(255.9e3 * share, rel=2e-3)


def test_axial_bearings_carry_thrust_and_weight(turbine):
    """Rotor, main shaft, carrier and planets: spur gears have no axial force; tilt of the shaft included."""
    model, _, value = turbine
    bodies = ["hub", "main_shaft", "carrier_1", *(f"planet_{k}" for k in PLANETS)]
    mass = sum(model.body_inertia(name).mass for name in bodies) + 3 * 17609.0 + 3.3
    tilt = math.radians(5.0) - value("displacement[main_shaft.ry]")
    force = sum(value(f"bearing_force[{name}.axial]") for name in ("INP_B", "PLC_A", "PLC_B"))
    thrust = value("rotor_thrust[rotor]")
    assert -force == pytest.approx(thrust + mass * 9.80665 * math.sin(tilt), rel=3e-3)


def test_main_bearings_and_planet_carrier_bearings_carry_the_weight(turbine):
    """The same bodies across the axis, with the forces of sun and ring along the lines of action."""
    model, begin, value = turbine
    bodies = ["hub", "main_shaft", "carrier_1", *(f"planet_{k}" for k in PLANETS)]
    mass = sum(model.body_inertia(name).mass for name in bodies) + 3 * 17609.0 + 3.3
    total = sum(
        value(f"bearing_force[{name}.fx]") + 1j * value(f"bearing_force[{name}.fy]")
        for name in ("INP_A", "INP_B", "PLC_A", "PLC_B")
    )
    sun, ring = (abs(model.pairs[name].alpha_wt) for name in ("sun_1-planet_1", "planet_1-ring_1"))
    spin = float(begin.state.q[begin.system.spin("main_shaft")])
    for k in PLANETS:
        on_sun, on_ring = (
            abs(value(f"mesh_force[{name}]")) for name in (f"sun_1-planet_{k}", f"planet_{k}-ring_1")
        )
        place = np.exp(1j * (spin + (k - 1) * math.tau / 3.0))
        outward = on_sun * math.sin(sun) - on_ring * math.sin(ring)
        along = on_sun * math.cos(sun) + on_ring * math.cos(ring)
        total += (outward - 1j * along) * place
    weight = mass * 9.80665 * math.cos(math.radians(5.0) - value("displacement[main_shaft.ry]"))
    assert total.real == pytest.approx(weight, rel=0.02)  # and the vertical force of the wind on the blades
    assert abs(total.imag) < 0.02 * weight


def test_a_bending_moment_of_the_hub_reaches_the_planets(turbine):
    """The loads of the planets change with it, their sum does not."""
    bent = started("gearbox_all_directions.yaml", **{"parameters.hub_moment": "2 MN m"})[2]
    one, two = (
        np.array([abs(value(f"mesh_force[sun_1-planet_{k}]")) for k in PLANETS])
        for value in (turbine[2], bent)
    )
    assert two.sum() == pytest.approx(one.sum(), rel=5e-3)
    assert np.abs(two / two.mean() - one / one.mean()).max() > 0.02


def test_a_stiffly_connected_gear_train_takes_no_long_steps(turbine):
    """The main shaft with its carrier is a part of the gear train, and the hub is fixed to it."""
    begin = turbine[1]
    with pytest.raises(SolverError, match=r"long_step: 0.001 s is too long for .*connected stiffly"):
        gear_part.start(begin.system, begin.state, 1e-4, 10)


def statistics(run, seconds: float):
    """Statistics of a run that continues for a time."""
    no = run.system.sizes["no"]
    sums = new_statistics(no, new_counts(run.system))
    assert run.advance(round(seconds / run.h), statistics=sums).status == 1
    return read_statistics(sums)


@pytest.fixture(scope="module")
def torsional():
    return started("gearbox.yaml")[1]


def test_long_steps_outside_of_the_gear_train(torsional):
    """Torsional gearbox, 0.1 s against all bodies at 0.1 ms; alternating forces see below."""
    system, state = torsional.system, torsional.state
    whole = statistics(generalized_alpha.start(system, state, 1e-4), 0.1)
    parts = statistics(gear_part.start(system, state, 1e-4, 10), 0.1)
    for name, close in (
        ("rotor_thrust[rotor]", 1e-6),
        ("speed[hub]", 2e-5),
        ("displacement[tower_top.x]", 1e-6),
        ("beam_force[tower.1.i.my]", 1e-6),
        ("coupling_force[main_shaft.mz]", 2e-4),
        ("speed[generator]", 1e-5),
        ("mesh_force[sun_1-planet_1]", 3e-4),
        ("mesh_force[sun_2-small_planet_2]", 3e-4),
        ("mesh_force[stage_3]", 3e-4),
    ):
        c = system.layout.channel(name)
        assert parts.mean[c] == pytest.approx(whole.mean[c], rel=close), name
        if name.startswith("mesh"):
            assert parts.rms[c] == pytest.approx(whole.rms[c], rel=0.03), name


def test_chunks_do_not_change_the_steps(torsional):
    """A run in pieces of whole long steps has the same bits; a rest of three short steps is a long step."""
    rows = []
    for pieces in ((103,), (50, 53)):
        run = gear_part.start(torsional.system, torsional.state, 1e-4, 10)
        rows.append(np.concatenate([run.advance(n, every=1).rows for n in pieces]))
        assert run.t == pytest.approx(0.0103) and run.last == 3
    np.testing.assert_array_equal(*rows)


@pytest.mark.study
def test_alternating_forces_of_all_stages_are_converged(torsional):
    """0.1 ms in long steps of 1 ms against 0.025 ms everywhere, one second: 2 % of the alternating force.

    -1.4 % at sun 2 are impacts of spur pairs within 0.1 ms; +0.8 % at ring 2 and 0.4 % at others are due to
    the long steps.
    """
    system, state = torsional.system, torsional.state
    found = []
    for begin, *steps in ((generalized_alpha.start, 2.5e-5), (gear_part.start, 1e-4, 10)):
        run = begin(system, state, *steps)
        assert run.advance(round(1.0 / run.h)).status == 1
        found.append(statistics(run, 1.0))
    meshes = [k for k, c in enumerate(system.layout.channels) if c.name.startswith("mesh_force[")]
    np.testing.assert_allclose(found[1].rms[meshes], found[0].rms[meshes], rtol=0.02)
    np.testing.assert_allclose(found[1].mean[meshes], found[0].mean[meshes], rtol=2e-4)
