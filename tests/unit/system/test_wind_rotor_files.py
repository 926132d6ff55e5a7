# SPDX-License-Identifier: Apache-2.0
"""Rotors of wind turbines in model files: loads on rigid blades are those of `solve_rotor_performance`."""

from __future__ import annotations

import pickle
import shutil
from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError, SolverError
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.io.wind.turbsim import write_turbsim
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.openfast.aerodyn import read_aerodyn
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.turbsim import read_turbsim
from pitchpoint.solvers.rotor_performance import along_blade, solve_rotor_performance
from pitchpoint.solvers.rotor_transient import solve_rotor_transient
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.wind import WindField
from tests.support.rotors import AERODYN, FOLDER

SPEED, TURNS = 8.0, 9.156 * np.pi / 30.0
HUB = """\
bodies:
  hub: {inertia: 4.37e7 kg m^2, position: [X m, 0, 90 m], axes: {z: [AXIS], x: [UP]}}
winds:
  steady: {speed: 8 m/s, height: HEIGHT m, profile: power, exponent: SHEAR, direction: DIRECTION deg}
wind_rotors:
  rotor: {hub: hub, aerodyn: onshore/AeroDyn.dat, hub_radius: 1.5 m, precone: CONE deg}
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Files of the turbine, without the flow around the tower."""
    path = tmp_path_factory.mktemp("turbine")
    shutil.copytree(FOLDER, path, dirs_exist_ok=True)
    text = AERODYN.read_text(encoding="utf-8")
    lines = ["0 TwrPotent" if "TwrPotent" in line else line for line in text.splitlines()]
    (path / "onshore" / "AeroDyn.dat").write_text("\n".join(lines), encoding="utf-8")
    return path


def model_of(folder, tilt=0.0, cone=0.0, shear=0.0, yaw=0.0, overhang=5.0, text=HUB):
    """Hub of a rotor 90 m above ground."""
    s, c = float(np.sin(tilt)), float(np.cos(tilt))
    changes = {
        "AXIS": f"{c!r}, 0, {-s!r}",
        "UP": f"{s!r}, 0, {c!r}",
        "X": repr(-overhang * c),
        "HEIGHT": repr(90.0),
        "SHEAR": repr(shear),
        "DIRECTION": repr(float(np.degrees(-yaw))),
        "CONE": repr(float(np.degrees(cone))),
    }
    for word, value in changes.items():
        text = text.replace(word, value)
    file = folder / "model.yaml"
    file.write_text(text, encoding="utf-8")
    return load_model(file)


def observed(system, angle, speed=TURNS):
    state = system.initial_state()
    spin = system.spin("hub")
    state.q[spin], state.v[spin] = angle, speed
    return dict(zip((c.name for c in system.layout.channels), evaluate.observe(system, state), strict=True))


@pytest.mark.parametrize(
    ("cone", "tilt", "shear", "yaw"),
    [(0.0, 0.0, 0.0, 0.0), (0.05, 0.0, 0.0, 0.0), (0.05, 0.1, 0.0, 0.0), (0.05, 0.1, 0.2, 0.3)],
)
def test_rigid_blades_have_the_loads_of_the_steady_rotor(folder, cone, tilt, shear, yaw):
    """Mean over one revolution to 1e-9: the same law. The torque of the solver is that of the forces alone;
    the pitching moment of an inclined blade has a component about the rotor axis. With tilt and yaw the
    sweep of the blade is a difference of azimuth, which the mean over 36 azimuths does not resolve."""
    system = compile_model(model_of(folder, tilt, cone, shear, yaw))
    rows = [observed(system, a) for a in 2.0 * np.pi * np.arange(12) / 36.0]
    given = read_aerodyn(folder / "onshore" / "AeroDyn.dat")
    rotor = Rotor(
        blade=given.blade,
        hub_radius=1.5,
        precone=cone,
        tilt=tilt,
        hub_height=90.0,
    )
    flow = replace(given.flow, sectors=36, shear_exponent=shear, yaw=yaw)
    found = solve_rotor_performance(rotor, SPEED, TURNS, flow=flow)
    moment = 3.0 * along_blade(rotor, found.pitching_moment.values[0] * np.sin(rotor.inclination))
    close = 1e-9 if tilt == shear == yaw == 0.0 else 1e-5
    thrust, torque, power = (
        np.mean([row[f"{word}[rotor]"] for row in rows])
        for word in ("rotor_thrust", "rotor_torque", "aerodynamic_power")
    )
    assert thrust == pytest.approx(float(found.rotor_thrust[0]), rel=close)
    assert torque == pytest.approx(float(found.rotor_torque[0]) - moment, rel=close)
    assert power == pytest.approx(torque * TURNS, rel=1e-9)
    assert rows[0]["hub_wind_speed[rotor]"] == pytest.approx(SPEED * np.cos(tilt) * np.cos(yaw))


@pytest.mark.parametrize("turn", [40.0, -150.0])
def test_the_compass_does_not_matter(folder, turn):
    """Turbine and wind turned about the vertical by one angle: the same loads, to round-off."""
    still = observed(compile_model(model_of(folder, 0.1, 0.05, 0.2, 0.0)), 0.4)
    c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    text = HUB.replace("DIRECTION", repr(turn))
    for word, (x, z) in {
        "AXIS": (np.cos(0.1), -np.sin(0.1)),
        "UP": (np.sin(0.1), np.cos(0.1)),
    }.items():
        text = text.replace(word, f"{x * c:.17g}, {x * s:.17g}, {z:.17g}")
    text = text.replace("X m, 0, 90 m", f"{-5 * np.cos(0.1) * c:.17g} m, {-5 * np.cos(0.1) * s:.17g} m, 90 m")
    turned = observed(compile_model(model_of(folder, 0.1, 0.05, 0.2, text=text)), 0.4)
    for name in ("rotor_thrust[rotor]", "rotor_torque[rotor]", "hub_wind_speed[rotor]"):
        assert turned[name] == pytest.approx(still[name], rel=1e-9)


TRAIN = """\
bodies:
  hub: {inertia: 4.37e7 kg m^2, position: [-5 m, 0, 90 m], axes: {z: [1, 0, 0], x: [0, 0, 1]}}
  generator: {inertia: 5.0255e6 kg m^2, position: [1 m, 0, 90 m], axes: {z: [1, 0, 0], x: [0, 0, 1]}}
torsion_springs:
  shaft: {bodies: [hub, generator], stiffness: 8.67637e8 N m/rad, damping: 6.215e6 N m s/rad}
winds:
  steady: {speed: 8 m/s, height: 90 m}
  rising: {speed: 8 m/s, height: 90 m, profile: uniform,
    gust: {shape: rise, start: 2 s, duration: 1 s, amplitude: 2 m/s}}
wind_rotors:
  rotor: {hub: hub, aerodyn: onshore/AeroDyn.dat, hub_radius: 1.5 m, precone: 2.5 deg, wind: steady}
loads:
  torque: {body: generator, torque: "-2.13e6*speed^2"}
scenarios:
  free: {speed: {hub: 8 rpm}, duration: 10 s, step: 10 ms, settle_time: 0 s}
  driven: {wind: rising, drive: {generator: {speed: 9.156 rpm}}, duration: 10 s, step: 20 ms,
    settle_time: 0 s}
"""


def run(model, scenario):
    """Times, and a function that returns channels."""
    system, memory = compile_model(model, scenario), Memory()
    done = run_time(system, sink=memory)
    assert done.status == 1, done.sentence
    rows = np.concatenate(memory.rows)
    return np.concatenate(memory.times), lambda name: rows[:, system.layout.channel(name)]


def test_the_energy_of_the_wind_goes_to_inertia_spring_damper_and_generator(folder):
    """Two inertias run up in sheared wind; the balance closes to the error of the trapezoidal rule."""
    t, channel = run(model_of(folder, text=TRAIN), "free")
    hub, generator = channel("speed[hub]"), channel("speed[generator]")
    stored = 0.5 * 4.37e7 * hub**2 + 0.5 * 5.0255e6 * generator**2
    stored += 0.5 * 8.67637e8 * (channel("angle[hub]") - channel("angle[generator]")) ** 2
    supplied = channel("aerodynamic_power[rotor]") + channel("torque[torque]") * generator
    supplied -= 6.215e6 * (hub - generator) ** 2
    np.testing.assert_allclose(
        channel("aerodynamic_power[rotor]"), channel("rotor_torque[rotor]") * hub, rtol=1e-12
    )
    balance = np.diff(stored) - 0.5 * np.diff(t) * (supplied[1:] + supplied[:-1])
    assert abs(balance.sum()) < 1e-6 * abs(np.diff(stored)).sum()
    assert hub[-1] > hub[0] * 1.01


def test_dynamic_inflow_and_stall_are_those_of_the_transient_rotor(folder):
    """The wind rises from 8 to 10 m/s in 1 s; the thrust overshoots by 2 %. Both codes
    integrate the states differently: steps of 20 ms make 1e-3."""
    dynamic = TRAIN.replace("wind: steady}", "wind: steady, inflow: dynamic, stall: dynamic}")
    t, channel = run(model_of(folder, text=dynamic), "driven")
    given = read_aerodyn(folder / "onshore" / "AeroDyn.dat")
    rotor = Rotor(blade=given.blade, hub_radius=1.5, precone=np.radians(2.5))
    wind = 8.0 + np.where(t < 2.0, 0.0, np.where(t < 3.0, 1.0 - np.cos(np.pi * (t - 2.0)), 2.0))
    found = solve_rotor_transient(rotor, t, wind, channel("speed[hub]"), flow=given.flow)
    thrust = channel("rotor_thrust[rotor]")
    np.testing.assert_allclose(thrust, found.rotor_thrust.values, rtol=1e-3)
    assert thrust.max() > 1.02 * thrust[-1]
    steady, still = run(model_of(folder, text=TRAIN), "driven")
    assert still("rotor_thrust[rotor]").max() < 1.005 * still("rotor_thrust[rotor]")[-1]


def test_blades_on_beams_and_bodies_have_the_loads_of_rigid_blades(folder):
    """In the initial position of the example, at standstill and at speed, to round-off."""
    model = load_model(FOLDER.parent / "model.yaml")
    roots = model.replace_all(
        {"wind_rotors.rotor.beams": (), "wind_rotors.rotor.bodies": ("root_1", "root_2", "root_3")}
    )
    rigid = model.replace("wind_rotors.rotor.beams", ())
    for speed in (0.0, TURNS):
        rows = []
        for each in (model, roots, rigid):
            system = compile_model(each, "parked")
            state = system.initial_state()
            state.v[system.spin("hub")] = speed
            rows.append(
                evaluate.observe(system, state)[[system.layout.channel(f"{w}[rotor]") for w in TOTALS]]
            )
        np.testing.assert_allclose(rows[1], rows[0], rtol=1e-9, atol=1e-6)
        np.testing.assert_allclose(rows[2], rows[0], rtol=1e-9, atol=1e-6)


TOTALS = ("rotor_thrust", "rotor_torque", "aerodynamic_power")


WRONG = {
    "aerodyn: onshore/AeroDyn.dat": ("aerodyn: nowhere.dat", "nowhere.dat"),
    "hub_radius: 1.5 m": ("hub_radius: -1.5 m", "hub_radius"),
    "hub: hub": ("hub: nub", "did you mean hub"),
    "precone: 2.5 deg": ("precone: 2.5 deg, beams: [shaft]", "names the beam 'shaft', which does not exist"),
    "precone: 2.5 deg,": ("precone: 2.5 deg, stall: dynamic,", "requires dynamic inflow"),
    "hub_radius: 1.5 m,": ("hub_radius: 1.5 m, bodies: [hub, generator],", "limit 3, one for each blade"),
    "wind: steady}": ("wind: storm}", "storm"),
    ", wind: steady}": ("}", "names no wind (limit rising, steady)"),
    "steady: {speed: 8 m/s": (
        "steady: {profile: logarithmic, roughness_length: 60 m, speed: 8 m/s",
        "roughness_length",
    ),
    "scenarios:": ("scenarios:\n  calm: {wind: none, duration: 1 s}", "none"),
}


@pytest.mark.parametrize("word", WRONG)
def test_wrong_rotors_are_told(folder, word):
    new, words = WRONG[word]
    assert word in TRAIN
    with pytest.raises(ModelError) as error:
        compile_model(model_of(folder, text=TRAIN.replace(word, new)), "free")
    told = [str(p) for p in error.value.problems]
    assert any(words in each for each in told), told
    assert all(p.line for p in error.value.problems)


def test_turbulence_of_a_file_is_the_wind_at_the_stations(folder):
    """A box without fluctuations is the uniform wind; one with them is that of `WindField` at the hub.
    Outside the box a run ends with the place."""
    still = WindBox(
        velocity=np.full((40, 3, 3, 3), (8.0, 0.0, 0.0), np.float32),
        time_step=0.5,
        spacing=(80.0, 80.0),
        bottom=10.0,
        hub_height=90.0,
        mean_speed=8.0,
        with_mean=True,
    )
    write_turbsim(folder / "still.bts", still)
    more = np.random.default_rng(2).normal(size=still.velocity.shape).astype(np.float32)
    rough = replace(still, velocity=still.velocity + more)
    write_turbsim(folder / "rough.bts", rough)
    text = TRAIN.replace("steady: {speed: 8 m/s, height: 90 m}", "steady: {box: BOX}")
    uniform = text.replace("{box: BOX}", "{speed: 8 m/s, height: 90 m, profile: uniform}")
    rows = [
        observed(compile_model(model_of(folder, text=each)), 0.3)
        for each in (text.replace("BOX", "still.bts"), uniform)
    ]
    assert rows[0]["rotor_torque[rotor]"] == pytest.approx(rows[1]["rotor_torque[rotor]"], rel=1e-4)
    system = compile_model(model_of(folder, text=text.replace("BOX", "rough.bts")))
    wind = WindField(box=read_turbsim(folder / "rough.bts")).velocity([[-5.0, 0.0, 90.0]], 0.0)[0]
    assert observed(system, 0.3)["hub_wind_speed[rotor]"] == pytest.approx(wind[0], rel=1e-6)
    again = pickle.loads(pickle.dumps(system))
    assert observed(again, 0.3) == observed(system, 0.3)
    model = model_of(folder, text=text.replace("BOX", "still.bts"))
    (folder / "still.bts").unlink()
    write_turbsim(folder / "still.bts", replace(still, spacing=(20.0, 20.0), bottom=70.0))
    compiled = compile_model(model, "free")
    words = r"wind_rotors.rotor.1.8 \(line 11\): a blade left the box of turbulence"
    with pytest.raises(SolverError, match=words):
        run_time(compiled)
