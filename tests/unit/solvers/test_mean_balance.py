# SPDX-License-Identifier: Apache-2.0
"""Balancing torques of pulsating loads: the work of a period decides, the speed stays near the scenario."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.mean_balance import CYCLES, IN_CYCLE, balanced_words, cycle_instants
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

RPM = np.pi / 30
FRICTION = ", friction: {mu: 0.1, v_eps: 0.01 mm/s}"
INERTIA = 0.01 + 0.2 / 9
"""Of both bodies of the gearbox, at the driver [kg m^2]."""


def gearbox(law, stiffness="{law: constant, value: 4e8 N/m}", friction="", more="", driver="balance"):
    """Gears 20 and 60; the driver balances the load of the driven gear."""
    gear = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    return (
        f"gears:\n  a: {{number_of_teeth: 20, {gear}}}\n  b: {{number_of_teeth: 60, {gear}}}\n"
        "bodies:\n  driver: {gears: [a], motion: torsion, inertia: 0.01 kg m^2}\n"
        "  driven: {gears: [b], motion: torsion, inertia: 0.2 kg m^2}\n"
        f"meshes:\n  stage: {{gears: [a, b], stiffness: {stiffness}, damper: {{ratio: 0.05}}{friction}}}\n"
        f"loads:\n  in: {{body: driver, torque: {driver}}}\n  out: {{body: driven, torque: {law}}}\n"
        f"scenarios:\n  run: {{speed: {{driver: 1500 rpm}}, duration: 0.24 s, step: 20 us{more}}}\n"
    )


def begun(text):
    model = loads_model(text)
    return prepare_start(compile_model(model, "run"), model.scenarios["run"])


def balance(text):
    return float(begun(text).system.records["torque"]["value"][0])


def mean_and_ripple(start):
    """Speed of the driver in the rigid train, without the vibration of the teeth."""
    spin = start.system.spin("driver")
    return start.mean.v[spin] + start.cycle.offset[spin]


TABLE = "{table: [[0 deg, 150 N m], [90 deg, 50 N m], [360 deg, 150 N m]], over: angle}"
LAWS = {
    "cosine": ('"100*(1 + 0.5*cos(angle))"', 100.0),
    "three waves": ('"100 + 40*sin(3*angle + 1) + 30*cos(angle)"', 100.0),
    "half a wave": ('"100*(1 + 0.5*cos(angle/2))"', 100.0),
    "squared": ('"120*cos(angle)^2"', 60.0),
    "table": (TABLE, 100.0),
}


@pytest.mark.parametrize("name", LAWS)
def test_the_mean_over_the_period_of_a_load_is_balanced(name):
    """A third of the mean torque of the load, whatever it is at the start."""
    law, mean = LAWS[name]
    assert balance(gearbox(law)) == pytest.approx(mean / 3.0, rel=1e-6)


def swinging(work):
    """Speeds of the driver over the angle of the driven gear, and the time of equal steps of it.

    Rigid bodies without losses: J w^2/2 + W(angle) is constant; the mean over time is 1500 rpm.
    """
    angle = np.arange(4096) * (2.0 * np.pi / 4096)

    def speeds(square):
        return np.sqrt(square - 2.0 * work(angle) / INERTIA)

    mean = 1500.0 * RPM
    middle = brentq(lambda x: 1.0 / np.mean(1.0 / speeds(x)) - mean, 0.8 * mean**2, 1.5 * mean**2, xtol=1e-9)
    return speeds(middle), 1.0 / speeds(middle)


def test_a_train_starts_where_its_mean_speed_is_that_of_the_scenario():
    """The driven gear turns backwards from its deflection: it is half way up the work of the cosine."""
    start = begun(gearbox('"100*(1 + 0.5*cos(angle))"'))
    deflected = start.mean.q[start.system.spin("driven")]
    speeds, _ = swinging(lambda angle: 50.0 * np.sin(angle - deflected))
    assert mean_and_ripple(start) == pytest.approx(speeds[0], rel=1e-6)
    assert start.state.v[start.system.spin("driven")] == pytest.approx(-speeds[0] / 3.0, rel=1e-6)
    assert "in balances the mean torque of out over its period of 120 ms" in start.notes[0]
    mean = start.cycle.means[1]
    assert mean == pytest.approx(100.0, rel=1e-9)  # over time as over the angle: both balance


def test_a_ripple_of_the_speed_raises_the_mean_of_a_damped_load():
    """The power 2 N m s times speed^2 counts with its mean: var(w)/mean(w) in addition to mean(w).

    First order of the ripple: 50 N m times cosine over the inertia at the driven gear; the next is 1 % of it.
    """
    mean, inertia = 500.0 * RPM, 9.0 * INERTIA
    swing = 50.0 / np.hypot(inertia * mean, 2.0)  # damping 2 N m s at the angular frequency `mean`
    found = balance(gearbox('"2*abs(speed) + 50*cos(angle)"'))
    assert 3.0 * found - 2.0 * mean == pytest.approx(swing**2 / mean, rel=0.02)


TIME = {
    "one wave": ('"100*(1 + 0.4*cos(2*pi*30 Hz*t))"', 100.0, 1.0 / 30.0),
    "squared": ('"120*sin(2*pi*t/0.05)^2"', 60.0, 0.05),
    "a pulse": ('"80*pulse(mod(t, 0.02), 0, 0.005)"', 20.0, 0.02),
}


@pytest.mark.parametrize("name", TIME)
def test_loads_that_repeat_over_time_are_balanced_with_their_mean(name):
    law, mean, period = TIME[name]
    start = begun(gearbox(law))
    assert float(start.system.records["torque"]["value"][0]) == pytest.approx(mean / 3.0, rel=3e-4)
    assert start.cycle.period == pytest.approx(period, rel=1e-9)


def test_a_wave_over_time_starts_at_the_speed_of_its_steady_motion():
    """J dw/dt = -40 N m cos(w t)/3 at the driver: no offset at a cosine, the whole amplitude at a sine."""
    inertia, rate = INERTIA, 2.0 * np.pi * 30.0
    for wave, offset in (("cos", 0.0), ("sin", 40.0 / 3.0 / (inertia * rate))):
        start = begun(gearbox(f'"100 + 40*{wave}(2*pi*30 Hz*t)"'))
        found = mean_and_ripple(start) - 1500.0 * RPM
        assert found == pytest.approx(offset, abs=2e-4 * 40.0 / 3.0 / (inertia * rate))


def test_loads_of_angle_and_time_share_a_common_period():
    """Twice per revolution at 500 rpm, 16.7 Hz, and 20 Hz: five and six waves in 0.3 s."""
    start = begun(gearbox('"100 + 20*sin(2*angle)*(1 + cos(2*pi*20 Hz*t))"'))
    assert start.cycle.period == pytest.approx(0.3, rel=1e-9)
    assert float(start.system.records["torque"]["value"][0]) == pytest.approx(100.0 / 3.0, rel=2e-3)


def test_without_a_common_period_the_error_of_the_mean_is_noted():
    """Orders 1 and the square root of 2 never meet; small waves, so that they do not act on each other."""
    start = begun(gearbox('"100 + sin(angle) + cos(sqrt(2)*angle)"'))
    assert start.cycle.period == 0.0
    assert start.cycle.error < 1e-6
    assert start.cycle.means[1] == pytest.approx(100.0, abs=1e-6)
    assert "no common period; estimated error" in start.notes[0]


def test_a_train_at_rest_keeps_its_rest():
    start = begun(gearbox('"100*(1 + 0.5*cos(angle))"').replace("1500 rpm", "0 rpm"))
    assert not start.state.v.any()
    assert float(start.system.records["torque"]["value"][0]) == pytest.approx(50.0, rel=1e-6)


def test_a_load_at_its_mean_value_at_the_start_pulsates_all_the_same():
    """Sine waves start at their mean; the instants of the mesh cycle are at other angles."""
    plain = balance(gearbox("100 N m", "{law: din3990}", FRICTION))
    wave = balance(gearbox('"100*(1 + 0.3*sin(2*angle))"', "{law: din3990}", FRICTION))
    assert wave == pytest.approx(plain, rel=1e-6)


def test_a_load_that_does_not_repeat_is_balanced_where_the_run_starts():
    """A spring on the output: 100 N m plus 50 N m/rad, at its angle in the loaded state of the start."""
    start = begun(gearbox('"100 + 50*angle"'))
    angle = start.state.q[start.system.spin("driven")]
    assert abs(angle) < 1e-3
    value = float(start.system.records["torque"]["value"][0])
    assert value == pytest.approx((100.0 + 50.0 * angle) / 3.0, rel=1e-9)


def test_the_speed_swings_about_that_of_the_scenario():
    """Two periods of 0.12 s. 1 rpm: what vibration of the mesh adds."""
    found = solve_time(compile_model(loads_model(gearbox('"100*(1 + 0.5*cos(angle))"')), "run"))
    speed = found["speed[driver]"].values
    expected, _ = swinging(lambda angle: 50.0 * np.sin(angle))
    np.testing.assert_allclose([speed.min(), speed.max()], [expected.min(), expected.max()], atol=1.0 * RPM)
    assert speed[:-1].mean() == pytest.approx(1500.0 * RPM, rel=1e-5)
    assert "of the scenario" not in found.attrs["notes"]


def test_a_run_says_when_its_mean_speed_leaves_the_scenario():
    """100 N m plus 50 N m/rad pulls the train away from where it was balanced."""
    found = solve_time(compile_model(loads_model(gearbox('"100 + 50*angle"')), "run"))
    assert found["speed[driver]"].values[-1] > 2 * 1500.0 * RPM
    assert "the mean speed of driver is" in found.attrs["notes"]
    assert "not the 1500 rpm of the scenario" in found.attrs["notes"]
    assert "out does not repeat with the angle" in found.attrs["notes"]


def test_friction_of_flanks_is_balanced_in_the_mean_of_a_mesh_cycle():
    """Mean loss of a spur mesh whose pairs share the load evenly, as those of din3990 do.

    The power lost is mu times force and sliding speed, (w1 + w2) |xi| at the place xi of the path. 2 % of it:
    deflection shifts contact by 1e-3 of a base pitch, and 16 instants stand for the cycle.
    """
    stiffness = "{law: din3990, tip_relief_factor: 0}"
    start = begun(gearbox("100 N m", stiffness, FRICTION))
    record = start.system.records["gear_mesh"][0]
    p, eps, begin = float(record["p_bt"]), float(record["now"]["eps"]), float(record["now"]["xi_A"])
    places = begin + (np.arange(2000) + 0.5) / 2000 * p
    sharing = [[x + k * p for k in range(3) if x + k * p < begin + eps * p] for x in places]
    sliding = np.mean([np.mean(np.abs(pairs)) for pairs in sharing])
    r_b = float(record["r_b1"])
    loss = 0.1 * (1.0 / r_b) * (1.0 + 1.0 / 3.0) * sliding
    wanted = 100.0 / 3.0 * (1.0 + loss)
    found = float(start.system.records["torque"]["value"][0])
    assert found == pytest.approx(wanted, rel=2e-4)
    assert found - 100.0 / 3.0 == pytest.approx(wanted - 100.0 / 3.0, rel=0.02)


def test_instants_cover_one_cycle_of_a_mesh_and_several_of_two():
    one = begun(gearbox("100 N m", "{law: din3990}", FRICTION))
    times, weights, cycles = cycle_instants(one.system, one.state)
    period = 2.0 * np.pi / (1500.0 * RPM) / 20
    np.testing.assert_allclose(times, np.arange(16) / 16 * period, rtol=1e-12)
    assert weights.sum() == pytest.approx(1.0)
    assert cycles == 1
    smooth = begun(gearbox("100 N m"))
    times, _, cycles = cycle_instants(smooth.system, smooth.state)
    assert (times.tolist(), cycles) == ([0.0], 0)


def test_the_number_of_cycles_does_not_depend_on_the_number_of_instants(monkeypatch):
    """Two stages of 20 and 25 teeth on one shaft: 3 cycles of the slower one."""
    gear = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    text = gearbox("100 N m", "{law: din3990}", FRICTION)
    last = "bodies:\n  last: {gears: [d], motion: torsion, inertia: 0.1 kg m^2}\n"
    pair = f"  c: {{number_of_teeth: 25, {gear}}}\n  d: {{number_of_teeth: 50, {gear}}}\n"
    text = text.replace("bodies:\n", pair + last)
    text = text.replace("gears: [b]", "gears: {b: 0, c: 50 mm}").replace(
        "meshes:\n",
        f"meshes:\n  more: {{gears: [c, d], stiffness: {{law: din3990}}{FRICTION}}}\n",
    )
    text = text.replace("body: driven, torque", "body: last, torque")
    start = begun(text)
    slowest = 60.0 / (500.0 * 25.0)
    for count in (64, IN_CYCLE * CYCLES):
        monkeypatch.setattr("pitchpoint.solvers.mean_balance.IN_SURFACE_CYCLE", count)
        times, _, cycles = cycle_instants(start.system, start.state)
        assert (cycles, times.size * times[1]) == (CYCLES, pytest.approx(CYCLES * slowest))
        words = balanced_words(start.system, start.state, start.cycle)
        assert words.endswith("flank friction over 3 cycles of the slowest mesh (14.4 ms)")


@pytest.mark.parametrize("name", LAWS)
def test_a_slow_roll_balances_the_mean_over_the_angle(name):
    """At rest, as at speed: a third of the mean torque. The driven body turns by a period of its load."""
    law, mean = LAWS[name]
    text = gearbox(law, more="").replace(
        "speed: {driver: 1500 rpm}, duration: 0.24 s, step: 20 us", "quasi_static: {points: 4}"
    )
    start = begun(text)
    assert float(start.system.records["torque"]["value"][0]) == pytest.approx(mean / 3.0, rel=1e-6)
    words = balanced_words(start.system, start.state, start.cycle)
    assert words.startswith("the mean torque of out over its period of ") and words.endswith(" of driver")


@pytest.mark.parametrize("speed", ["", "speed: {driver: 1500 rpm}, duration: 0.1 s"])
def test_pulsating_loads_that_are_balanced_are_no_remark_of_a_roll(speed):
    """The holding torques take the alternating part only; a load without balance remains a remark."""
    for driver, loads in (("balance", 0), ("30 N m", 1)):
        text = gearbox('"100*(1 + 0.2*sin(3*angle + 1))"', driver=driver)
        model = loads_model(
            text.replace(
                "speed: {driver: 1500 rpm}, duration: 0.24 s, step: 20 us", speed or "quasi_static: {}"
            )
        )
        notes = roll_through(compile_model(model, "run"), "run", 4, mesh="stage").notes
        assert sum("do not balance" in str(note) for note in notes) == loads, notes


def test_an_assembled_start_balances_too():
    """A gearbox that starts with its teeth in the middle of the backlash, as the README's first pair may."""
    text = gearbox("100 N m", more=", start: assembled")
    start = begun(text)
    assert float(start.system.records["torque"]["value"][0]) == pytest.approx(100.0 / 3.0, rel=1e-9)
    np.testing.assert_array_equal(start.state.q, 0.0)
    speed = solve_time(compile_model(loads_model(text), "run"))["speed[driver]"].values
    assert speed[-1000:].mean() == pytest.approx(1500.0 * RPM, rel=1e-4)


SURFACES = {
    "flexible": ("level: flexible", "", ""),
    "helical": ("level: flexible", "helix_angle: 15 deg, hand: {}, ", ""),
    "rigid, crowned": (
        "level: rigid, stiffness: 2e8 N/m",
        "",
        ", modifications: {both: {profile_crowning: 10 um}}",
    ),
}


@pytest.mark.parametrize("name", SURFACES)
def test_tooth_surfaces_are_balanced_over_the_mesh_cycle(name):
    """A constant torque and a conservative mesh: the work over a cycle is that of the mean gear ratio.

    At one position the torques differ from it by 1.6e-4, 6e-4 and 2e-4.
    """
    level, helix, flanks = SURFACES[name]
    text = gearbox("300 N m")
    text = text.replace(
        "stiffness: {law: constant, value: 4e8 N/m}, damper: {ratio: 0.05}", f"contact: {{{level}}}"
    )
    for teeth, hand in ((20, "right"), (60, "left")):
        text = text.replace(f"number_of_teeth: {teeth}", helix.format(hand) + f"number_of_teeth: {teeth}")
    text = text.replace("profile_shift_coefficient: 0}", f"profile_shift_coefficient: 0{flanks}}}")
    assert balance(text) == pytest.approx(100.0, rel=2e-5)


SPLIT = """
gears:
  sun: {number_of_teeth: 30, normal_module: 1.5 mm, face_width: 22 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 78, normal_module: 1.5 mm, face_width: 20 mm,
    profile_shift_coefficient: 0, tip_diameter: 114.6 mm, bore_diameter: 132 mm}
bodies:
  sun_shaft: {gears: [sun], inertia: 2e-2 kg m^2}
  carrier: {inertia: 2e-1 kg m^2, mass: 3 kg}
  ring_body: {gears: [ring], motion: torsion, inertia: 0.5 kg m^2}
planetary_stages:
  set:
    {sun: sun, ring: ring, carrier: carrier, planets: 4, planet: {number_of_teeth: 24, normal_module: 1.5 mm,
    face_width: 20 mm, profile_shift_coefficient: 0, bore_diameter: 16 mm},
    sun_mesh: {stiffness: {law: constant, value: 2e8}}, ring_mesh: {stiffness: {law: constant, value: 2e8}}}
loads:
  eng: {body: carrier, torque: "108 N m*(1+0.8*sin(2*angle+90 deg))"}
  gen: {body: sun_shaft, torque: SUN}
  veh: {body: ring_body, torque: RING}
scenarios:
  run: {speed: {carrier: 2000 rpm, sun_shaft: 4000 rpm}, duration: 0.12 s, step: 20 us}
"""


@pytest.mark.parametrize(
    "sun, ring, net",
    [("balance", "-78 N m", ""), ("-30 N m", "-78 N m", ""), ("balance", "-70 N m", "8 N m")],
)
def test_the_remark_on_loads_that_do_not_balance_judges_their_mean(sun, ring, net):
    """The carrier has 108 N m on average, 194.4 N m at the start: 30 N m at the sun, 78 N m at the ring."""
    notes = " ".join(begun(SPLIT.replace("SUN", sun).replace("RING", ring)).notes)
    assert ("the loads do not balance" in notes) == bool(net)
    assert net in notes
