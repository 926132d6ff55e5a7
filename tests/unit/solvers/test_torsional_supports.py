# SPDX-License-Identifier: Apache-2.0
"""Planet sets whose ring a spring or brake holds: Willis's speeds, steady running from the first instant.

Sun 20, ring 76 teeth: the carrier turns at 20/96 of the sun, and a torque T on the sun takes -(1 + 76/20) T
on the carrier and 76/20 T on what holds the ring.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import Model
from pitchpoint.solvers.initial_state.start import UNBALANCED, prepare_start
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

RPM = np.pi / 30
SUPPORTS = {
    "torsion spring": "torsion_springs: {hold: {bodies: [ring], stiffness: 1e7 N m/rad}}",
    "bushing": "bushings: {hold: {ends: [ring, ground], stiffness: {torsion: 1e7 N m/rad}}}",
    "bearing": "bearings: {hold: {body: ring, stiffness: {torsion: 1e7 N m/rad}}}",
    "brake": "clutches: {hold: {bodies: [ring], capacity: 5 kN m}}",
    "brake that opens": "clutches: {hold: {bodies: [ring], capacity: {table: [[0 s, 5 kN m], [1 s, 0]]}}}",
    "spring with a lever": "springs: {hold: {ends: [ring.arm, post.side], stiffness: 1e9 N/m}}",
    "bushing on an arm": "bushings: {hold: {ends: [ring.arm, post.arm], stiffness: {radial: 1e9 N/m}}}",
    "bushing on a housing": "bushings: {hold: {ends: [ring, post.axis], stiffness: {torsion: 1e7 N m/rad}}}",
    "brake on a housing": "clutches: {hold: {bodies: [post, ring], capacity: 5 kN m}}",
    "coupling": "couplings: {hold: {bodies: [ring, case], stiffness: {torsion: 1e7 N m/rad}}}",
}
LOOSE = {
    "nothing": "",
    "a bushing without torsion": "bushings: {hold: {ends: [ring, ground], stiffness: {radial: 1e9 N/m}}}",
    "an open brake": 'clutches: {hold: {bodies: [ring], capacity: "5000*t"}}',
}


MARKERS = {
    "ring": {"arm": (200, 0)},
    "post": {"arm": (-100, 0), "side": (-100, 100), "axis": (-300, 0)},
}


def marked(body: str, support: str) -> str:
    """Markers of a body that a support names [mm]."""
    own = [
        f"{n}: {{position: [{x} mm, {y} mm, 0]}}"
        for n, (x, y) in MARKERS[body].items()
        if f"{body}.{n}" in support
    ]
    return f", markers: {{{', '.join(own)}}}" if own else ""


def planet_set(
    support: str, speed: str = "sun: 1000 rpm", balance: str = "carrier", more: str = "", ring: str = ""
) -> Model:
    gear = (
        "normal_module: 4 mm, face_width: 40 mm, profile_shift_coefficient: 0, normal_pressure_angle: 25 deg"
    )
    angles = 2.0 * np.pi * np.arange(3) / 3
    places = [(float(96.0 * np.cos(a)), float(96.0 * np.sin(a))) for a in angles]
    mesh = "stiffness: {law: constant, value: 5e8 N/m}, damper: {ratio: 0.05}"
    torques = {"sun": 300.0, "carrier": -1440.0}
    loads = {b: "balance" if b == balance else f"{t} N m" for b, t in torques.items()}
    loads |= {"ring": ring} if ring else {}
    lines = [
        "gears:",
        f"  sun: {{number_of_teeth: 20, {gear}}}",
        f"  ring: {{number_of_teeth: 76, {gear}, type: internal}}",
        *(f"  p{k}: {{number_of_teeth: 28, {gear}}}" for k in range(3)),
        "bodies:",
        "  sun: {gears: [sun], position: [0, 0, 0]}",
        "  carrier: {inertia: 0.5 kg m^2, mass: 10 kg, position: [0, 0, 0]}",
        f"  ring: {{gears: [ring], inertia: 0.3 kg m^2, position: [0, 0, 0]{marked('ring', support)}}}",
        *(f"  b{k}: {{gears: [p{k}], position: [{x!r} mm, {y!r} mm, 0]}}" for k, (x, y) in enumerate(places)),
        "  case: {motion: fixed, position: [0, 0, 0]}",
        *(
            [f"  post: {{motion: fixed, position: [300 mm, 0, 0]{marked('post', support)}}}"]
            if "post" in support
            else []
        ),
        "joints:",
        *(f"  pin{k}: {{type: revolute, bodies: [carrier, b{k}]}}" for k in range(3)),
        "meshes:",
        *(f"  s{k}: {{gears: [sun, p{k}], {mesh}}}" for k in range(3)),
        *(f"  r{k}: {{gears: [p{k}, ring], {mesh}}}" for k in range(3)),
        support,
        "loads:",
        *(f"  {b}: {{body: {b}, torque: {t}}}" for b, t in loads.items()),
        f"scenarios:\n  steady: {{speed: {{{speed}}}, duration: 10 ms{more}}}",
    ]
    return loads_model("\n".join(line for line in lines if line))


@pytest.mark.parametrize("support", SUPPORTS)
def test_a_ring_that_is_held_starts_at_rest_and_the_set_runs_steadily(support):
    model = planet_set(SUPPORTS[support])
    speeds = model.start_speeds("steady")
    assert speeds["ring"] == pytest.approx(0.0, abs=1e-9)
    assert speeds["carrier"] == pytest.approx(1000.0 * RPM * 20 / 96, rel=1e-9)
    found = solve_time(compile_model(model, "steady"))
    assert not found.attrs["notes"]
    assert float(found["torque[carrier]"][0]) == pytest.approx(-1440.0, rel=1e-6)
    r_b = 0.5 * 20 * 4e-3 * np.cos(np.radians(25.0))
    for k in range(3):
        np.testing.assert_allclose(found[f"mesh_force[s{k}]"].values, 300.0 / (3 * r_b), rtol=1e-4)
    if support != "brake that opens":
        np.testing.assert_allclose(found["speed[carrier]"].values, 1000.0 * RPM * 20 / 96, rtol=1e-6)


@pytest.mark.parametrize("support", LOOSE)
def test_what_holds_no_turn_decides_no_speed(support):
    """Both speeds that a set with three free members needs are those that are given."""
    speeds = planet_set(LOOSE[support], "sun: 1000 rpm, ring: 100 rpm").start_speeds("steady")
    assert speeds["carrier"] == pytest.approx((20 * 1000.0 + 76 * 100.0) / 96 * RPM, rel=1e-9)
    alone = planet_set(LOOSE[support]).start_speeds("steady")
    assert abs(alone["ring"]) > 1.0


def test_a_given_speed_comes_before_a_support():
    """A ring on a torsion spring may start with a speed, and swings."""
    speeds = planet_set(SUPPORTS["torsion spring"], "sun: 1000 rpm, ring: 10 rpm").start_speeds("steady")
    assert speeds["ring"] == pytest.approx(10.0 * RPM, rel=1e-9)
    assert speeds["carrier"] == pytest.approx((20 * 1000.0 + 76 * 10.0) / 96 * RPM, rel=1e-9)


def test_a_torque_balanced_on_the_sun_is_shared_with_the_brake():
    found = solve_time(compile_model(planet_set(SUPPORTS["brake"], balance="sun"), "steady"))
    assert float(found["torque[sun]"][0]) == pytest.approx(300.0, rel=1e-6)
    np.testing.assert_allclose(found["torque[hold]"].values, 1440.0 - 300.0, rtol=1e-4)


HELD = {
    "driven at no speed": ("sun: 1000 rpm", ", drive: {ring: {speed: 0 rpm}}", "", 0.0),
    "held": ("sun: 1000 rpm", ", hold: [ring]", "", 0.0),
    "driven backwards": ("sun: 1000 rpm", ", drive: {ring: {speed: -200 rpm}}", "", -200.0),
    "balanced too": ("sun: 1000 rpm, ring: 0 rpm", "", "balance", 0.0),
}


@pytest.mark.parametrize("case", HELD)
def test_a_ring_with_a_given_speed_takes_its_share_of_a_balanced_torque(case):
    """The drive of the ring stays while the torque of the carrier is found, and both are those of Willis."""
    speed, more, ring, rpm = HELD[case]
    found = solve_time(compile_model(planet_set("", speed, more=more, ring=ring), "steady"))
    assert not found.attrs["notes"]
    np.testing.assert_allclose(found["torque[carrier]"].values, -1440.0, rtol=1e-6)
    np.testing.assert_allclose(
        found["torque[ring]"].values, 1140.0, rtol=1e-5
    )  # rounding of angles, over h^2
    np.testing.assert_allclose(found["speed[carrier]"].values, (20e3 + 76 * rpm) / 96 * RPM, rtol=1e-6)
    np.testing.assert_allclose(found["speed[sun]"].values, 1000.0 * RPM, rtol=1e-6)


def test_rounding_of_stiffness_is_no_torque_left_over():
    """Without any load the spring of 1e7 N m/rad leaves 1.6e-9 N m on the sun."""
    model = planet_set(SUPPORTS["torsion spring"])
    bare = model.replace("loads.sun.torque", "0 N m").replace("loads.carrier.torque", "0 N m")
    found = prepare_start(compile_model(bare, "steady"), bare.scenarios["steady"])
    assert not [note for note in found.notes if note.startswith(UNBALANCED)]


def test_a_bushing_on_one_axis_turns_both_bodies():
    """As a coupling does: the second shaft starts with the first, bushings beside the axis join nothing."""
    text = (
        "gears: {spare: {number_of_teeth: 20, normal_module: 1 mm, face_width: 5 mm, "
        "profile_shift_coefficient: 0}}\n"
        "bodies:\n  one: {inertia: 1 kg m^2, position: [0, 0, 0]}\n"
        "  two: {inertia: 1 kg m^2, position: [PLACE, 0, 100 mm]}\n"
        "bushings:\n  k: {ends: [one, two], stiffness: {radial: 1e8 N/m, torsion: 1e4 N m/rad}}\n"
        "scenarios:\n  on: {speed: {one: 10 rad/s}, duration: 1 s}\n"
    )
    assert loads_model(text.replace("PLACE", "0")).start_speeds("on")["two"] == pytest.approx(10.0)
    assert loads_model(text.replace("PLACE", "50 mm")).start_speeds("on")["two"] == 0.0


def test_a_ring_on_tangential_supports_is_at_rest():
    """Bolts at the rim hold the ring with T z_r/z_s; the carrier rotates at 1/(1 + z_r/z_s) of the sun."""
    from pitchpoint.report.static_power import static_power
    from tests.support.planet_gearboxes import gear, ring, stage

    rim = ", rim_thickness: 12 mm, flexible_rim: {waves: 3, supports: {number: 12, tangential: 100 N/um}}"
    text = (
        f"gears:\n  sun: {gear(21)}\n  ring: {ring(99, more=rim)}\n"
        "bodies:\n  sun: {gears: [sun], position: [0, 0, 0]}\n"
        "  ring: {gears: [ring], motion: planar, position: [0, 0, 0]}\n  carrier: {inertia: 0.1 kg m^2}\n"
        "planetary_stages:\n" + stage("set", gear(39), 3, "carrier", "sun: sun", "ring: ring")
    )
    loads = "loads:\n  in: {body: sun, torque: 200 N m}\n  out: {body: carrier, torque: balance}\n"
    model = loads_model(text + loads + "scenarios: {run: {speed: {sun: 1000 rpm}, duration: 1 ms}}\n")
    speeds = model.start_speeds("run")
    assert speeds["ring"] == 0.0
    assert speeds["sun"] / speeds["carrier"] == pytest.approx(1.0 + 99 / 21, rel=1e-12)
    torques = {row["name"]: row["torque"] for row in static_power(model, model.scenarios["run"])["external"]}
    assert torques["support of ring"] == pytest.approx(200.0 * 99 / 21, rel=1e-9)
