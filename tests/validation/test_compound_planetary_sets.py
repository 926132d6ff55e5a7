# SPDX-License-Identifier: Apache-2.0
"""Compound planetary gearboxes from model files: ratios of every gear in closed form, torques, power.

Willis's relation of each stage, with z_r/z_s positive for single planets and negative for planets in series,
gives the ratios of the Ravigneaux, Simpson, Lepelletier, stepped and Wolfrom sets below (H. W. Müller,
Epicyclic Drive Trains, 1982). The torques of members on fixed axes are in proportion to these ratios.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint import planet_loads
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.planet_gearboxes import lepelletier, ravigneaux, simpson, stepped

I_1, I_2 = 72 / 27, 72 / 36
RAVIGNEAUX = {
    "first": ("small_sun", "carrier", I_1),
    "second": ("small_sun", "large_sun", (I_1 + I_2) / (1 + I_2)),
    "overdrive": ("carrier", "large_sun", I_2 / (1 + I_2)),
    "reverse": ("large_sun", "carrier", -I_2),
    "on_small": ("carrier", "small_sun", I_1 / (I_1 - 1)),
}
"""Driven member, held member, speed of the driven member over that of the ring."""


@pytest.mark.parametrize("name", RAVIGNEAUX)
def test_ratios_of_a_ravigneaux_set(name):
    """Speeds at the start of a run, torques in equilibrium, and the torque of the held member: the sum."""
    driven, held, ratio = RAVIGNEAUX[name]
    model = loads_model(
        ravigneaux(
            f"loads:\n  in: {{body: {driven}, torque: 100 N m}}\n  out: {{body: ring, torque: balance}}\n",
            f"scenarios:\n  run: {{hold: [{held}], speed: {{{driven}: 1000 rpm}}, duration: 1 ms}}\n",
        )
    )
    speeds = model.start_speeds("run")
    assert speeds[driven] / speeds["ring"] == pytest.approx(ratio, rel=1e-12)
    found = solve_equilibrium(compile_model(model, "run"))
    # of constant mesh stiffness and rigid pins: only the pressure of contact moves the lines of action
    assert float(found["torque[out]"]) == pytest.approx(-100.0 * ratio, rel=1e-6)
    holding = float(found["holding_torque"].sel(held=f"{held}.spin"))
    assert holding == pytest.approx(100.0 * (ratio - 1.0), rel=1e-6)
    # power: the held member is at rest
    power = 100.0 * speeds[driven] + float(found["torque[out]"]) * speeds["ring"]
    assert power == pytest.approx(0.0, abs=1e-6 * 100.0 * abs(speeds[driven]))


def test_forces_of_a_ravigneaux_set_in_first_gear():
    """The large sun is idle; every planet passes on F = T/(N r_b) of the small sun."""
    text = ravigneaux(
        "loads:\n  in: {body: small_sun, torque: 100 N m}\n  out: {body: ring, torque: balance}\n",
        "scenarios:\n  run: {hold: [carrier], speed: {small_sun: 1000 rpm}, duration: 1 ms}\n",
    )
    found = solve_equilibrium(compile_model(loads_model(text), "run"))
    force = 100.0 / (3 * 27e-3 * math.cos(math.radians(20.0)))
    for k in (1, 2, 3):
        assert abs(float(found[f"mesh_force[small_sun-short_{k}]"])) == pytest.approx(force, rel=1e-6)
        assert abs(float(found[f"mesh_force[short_{k}-long_{k}]"])) == pytest.approx(force, rel=1e-6)
        assert abs(float(found[f"mesh_force[long_{k}-ring]"])) == pytest.approx(force, rel=1e-6)
        assert float(found[f"mesh_force[large_sun-long_{k}]"]) == pytest.approx(0.0, abs=1e-3)


def test_two_stages_on_one_carrier():
    """Both rings are at rest, so that both suns have the ratio 1 + z_r/z_s of their sets; the torques of both
    sets add on the carrier."""
    text = simpson(
        "scenarios:\n  run: {speed: {output: 100 rpm}, duration: 1 ms}\n"
        "loads:\n  in: {body: sun, torque: 50 N m}\n  rear: {body: rear, torque: 80 N m}\n"
        "  out: {body: output, torque: balance}\n"
    )
    text = text.replace("carrier: rear_carrier", "carrier: output")
    text = text.replace("  rear_carrier: {inertia: 0.01 kg m^2, position: [0, 0, 60 mm]}\n", "")
    text = text.replace("{front_sun: 0, rear_sun: 60 mm}", "[front_sun]")
    text = text.replace("{gears: {rear_ring: 60 mm}, inertia", "{inertia")
    rear = "  rear: {gears: [rear_sun], position: [0, 0, 60 mm]}\n"
    rear += "  rear_ring: {gears: [rear_ring], motion: fixed, position: [0, 0, 60 mm]}\n"
    text = text.replace("bodies:\n", "bodies:\n" + rear).replace(
        "gears: [front_ring],", "gears: [front_ring], motion: fixed,"
    )
    model = loads_model(text)
    speeds = model.start_speeds("run")
    ratio = 1 + 72 / 30
    assert [speeds[sun] / speeds["output"] for sun in ("sun", "rear")] == pytest.approx(
        [ratio] * 2, rel=1e-12
    )
    found = solve_equilibrium(compile_model(model, "run"))
    assert float(found["torque[out]"]) == pytest.approx(-130.0 * ratio, rel=1e-6)


RHO = 30 / 72


@pytest.mark.parametrize(
    ("driven", "held", "ratio"),
    [("input", "rear_carrier", 2 + RHO), ("input", "sun", 1 + RHO), ("sun", "rear_carrier", -1 / RHO)],
)
def test_ratios_of_a_simpson_set(driven, held, ratio):
    model = loads_model(
        simpson(
            f"scenarios:\n  run: {{hold: [{held}], speed: {{{driven}: 1000 rpm}}, duration: 1 ms}}\n"
            f"loads:\n  in: {{body: {driven}, torque: 50 N m}}\n  out: {{body: output, torque: balance}}\n"
        )
    )
    speeds = model.start_speeds("run")
    assert speeds[driven] / speeds["output"] == pytest.approx(ratio, rel=1e-12)
    found = solve_equilibrium(compile_model(model, "run"))
    assert float(found["torque[out]"]) == pytest.approx(-50.0 * ratio, rel=1e-6)


FRONT = 1 + 40 / 80
CLUTCHES = {
    "A": ("front_carrier", "small_sun"),
    "B": ("front_carrier", "large_sun"),
    "E": ("input", "carrier"),
}
LEPELLETIER = {
    "1": ("A", "carrier", FRONT * I_1),
    "2": ("A", "large_sun", FRONT * (I_1 + I_2) / (1 + I_2)),
    "3": ("AB", "", FRONT),
    "4": ("AE", "", I_1 * FRONT / (1 + (I_1 - 1) * FRONT)),
    "5": ("BE", "", I_2 * FRONT / ((1 + I_2) * FRONT - 1)),
    "6": ("E", "large_sun", I_2 / (1 + I_2)),
    "R": ("B", "carrier", -FRONT * I_2),
}


@pytest.mark.parametrize("name", LEPELLETIER)
def test_ratios_of_a_lepelletier_gearbox(name):
    """Six gears and reverse of a simple set in front of a Ravigneaux set."""
    clutches, held, ratio = LEPELLETIER[name]
    model = loads_model(
        lepelletier(
            tuple(CLUTCHES[word] for word in clutches),
            f"scenarios:\n  run: {{hold: [{held}], speed: {{input: 1000 rpm}}, duration: 1 ms}}\n",
        )
    )
    speeds = model.start_speeds("run")
    assert speeds["input"] / speeds["ring"] == pytest.approx(ratio, rel=1e-12)


@pytest.mark.parametrize(
    ("how", "out", "ratio"),
    [
        ({}, "carrier", 1 + 78 * 39 / (21 * 18)),
        (
            {"step": 36, "output": 96, "first_ring": 99, "fixed": "first_ring"},
            "output_ring",
            (1 + 99 / 21) / (1 - 99 * 36 / (39 * 96)),
        ),
    ],
)
def test_ratios_of_stepped_planets(how, out, ratio):
    """A stepped planet between sun and ring, and a Wolfrom set of 118.9."""
    loads = f"loads:\n  in: {{body: sun, torque: 20 N m}}\n  out: {{body: {out}, torque: balance}}\n"
    loads += "scenarios:\n  run: {speed: {sun: 1000 rpm}, duration: 1 ms}\n"
    model = loads_model(stepped(loads=loads, **how))
    speeds = model.start_speeds("run")
    assert speeds["sun"] / speeds[out] == pytest.approx(ratio, rel=1e-9)
    found = solve_equilibrium(compile_model(model, "run"))
    assert float(found["torque[out]"]) == pytest.approx(-20.0 * ratio, rel=1e-6)


@pytest.mark.parametrize("equal_leads", [True, False])
def test_axial_forces_on_stepped_planets(equal_leads):
    """Of one hand and lead they cancel on the planet; the bearing has the rest.

    F_t r is the same at both gears, and F_a = F_t tan(beta): T_p (tan(beta_1)/r_1 - tan(beta_2)/r_2) remains.
    """
    z_1, z_2, module = 39, 18, 3e-3
    first = math.tan(math.radians(15.0))
    slope = {z_1: first, z_2: first * (z_2 / z_1 if equal_leads else 1.0)}
    text = stepped(
        more="motion: free\nbearing: {stiffness: {radial: 1e9 N/m, axial: 1e8 N/m, tilt: 1e7 N m/rad}}",
        loads="loads:\n  in: {body: sun, torque: 200 N m}\n  out: {body: carrier, torque: balance}\n",
    )
    for z, mate, hand in ((z_1, 21, "left"), (z_2, 78, "right")):  # of the transverse module 3 mm
        angle = math.degrees(math.atan(slope[z]))
        for teeth, own in ((z, "right"), (mate, hand)):
            text = text.replace(
                f"{{number_of_teeth: {teeth}, normal_module: 3.0 mm",
                f"{{number_of_teeth: {teeth}, helix_angle: {angle!r} deg, hand: {own}, "
                f"normal_module: {module * math.cos(math.radians(angle))!r} m",
            )
    found = solve_equilibrium(compile_model(loads_model(text)))
    torque = 200.0 / 3 * z_1 / 21
    leads = [slope[z] / (0.5 * module * z) for z in (z_1, z_2)]
    axial = [float(found[f"bearing_force[planet_{k}-bearing.fz]"]) for k in (1, 2, 3)]
    # a planet that tilts by the moment of its axial forces turns its lines of action
    assert np.abs(axial) == pytest.approx(abs(torque * (leads[0] - leads[1])), abs=2e-3 * torque * leads[0])


@pytest.mark.parametrize(("stage", "pin"), [("short", "short_1"), ("long", "long_1")])
@pytest.mark.parametrize("error", [8e-6, -8e-6])
def test_load_sharing_of_planets_in_series(stage, pin, error):
    """In first gear each pair of planets is a chain of three meshes of stiffness k: K = k/3 at the sun.

    A pin that moves by e changes the travel by e P/F, by virtual work, with the tangential force P on it at
    the mesh force F; P is that of bearings in a set without errors. Then F_n = T/(N r_b) + K (mean - s_n).
    """
    loads = "loads:\n  in: {body: small_sun, torque: 300 N m}\n  out: {body: ring, torque: balance}\n"
    held = "scenarios:\n  run: {hold: [carrier], speed: {small_sun: 1000 rpm}, duration: 1 ms}\n"
    on_bearings = ravigneaux(loads, held, motion="planar", more="bearing: {stiffness: {radial: 1e10 N/m}}")
    found = solve_equilibrium(compile_model(loads_model(on_bearings), "run"))
    model = loads_model(ravigneaux(loads, held))
    place = np.arctan2(*model.bodies[pin].origin[1::-1])
    across = np.array([-np.sin(place), np.cos(place)])
    pushed = across @ [float(found[f"bearing_force[{pin}-bearing.f{axis}]"]) for axis in "xy"]
    mean = 300.0 / (3 * 27e-3 * math.cos(math.radians(20.0)))
    # force of the bearing on the planet: a pin that moves along it shortens the chain and takes load
    taken = 4e8 / 3 * error * pushed / mean
    wanted = mean + taken * np.array([2, -1, -1]) / 3
    moved = model.replace(f"planetary_stages.{stage}.pin_errors.{pin}.tangential", error)
    result = solve_equilibrium(compile_model(moved, "run"))
    forces = [abs(float(result[f"mesh_force[small_sun-short_{k}]"])) for k in (1, 2, 3)]
    assert forces == pytest.approx(wanted, abs=2e-3 * mean)
    loads_of = planet_loads(moved, result)
    factor = wanted.max() / mean
    for group in ("short", "long.ring", "long.short"):
        assert loads_of[group].factor == pytest.approx(factor, rel=2e-3)
    assert loads_of["long.large_sun"].factor is None


def test_a_gear_shift_by_two_brakes():
    """From first to second gear: the brake of the carrier opens while that of the large sun closes.

    Before and after, the speeds of small sun and ring have the ratio of the gear.
    """
    shift = """loads:
  engine: {body: small_sun, torque: 50 N m}
  road: {body: ring, torque: -100 N m}
clutches:
  low: {bodies: [carrier], capacity: {table: [[0, 200], [5 ms, 200], [20 ms, 0], [1, 0]]}}
  high: {bodies: [large_sun], capacity: {table: [[0, 0], [5 ms, 0], [20 ms, 200], [1, 200]]}}
scenarios:
  shift: {speed: {small_sun: 1500 rpm, carrier: 0 rpm}, duration: 50 ms, step: 5 us, sample_rate: 1 kHz}
"""
    text = ravigneaux(shift)
    for body, inertia in (("ring", 0.5), ("small_sun", 0.02)):
        text = text.replace(f"{body}: {{gears: [{body}],", f"{body}: {{gears: [{body}], inertia: {inertia},")
    found = solve_time(compile_model(loads_model(text), "shift"))
    ratio = found["speed[small_sun]"].values / found["speed[ring]"].values
    assert ratio[:4] == pytest.approx(np.full(4, I_1), rel=2e-3)
    assert ratio[-5:] == pytest.approx(np.full(5, (I_1 + I_2) / (1 + I_2)), rel=2e-3)
    assert found["speed[large_sun]"].values[-1] == pytest.approx(0.0, abs=0.1)
    # torque of the brake: that of the large sun in second gear, less that of its inertia
    assert abs(found["torque[high]"].values[-1]) == pytest.approx(28.4, rel=0.1)
