# SPDX-License-Identifier: Apache-2.0
"""Stations of beams as ends: against beam equations, and against beams divided by a body at the station."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.cli.check import summary
from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.materials import material
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.report.scene.rest import rest_scene
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from pitchpoint.system.evaluate import linearize, observe
from tests.support.cli_files import json_of, written

LIGHT = "{youngs_modulus: 206 GPa, poisson_ratio: 0.3, density: 0.1 kg/m^3}"
DUST = "mass: 0.1 mg, inertia_tensor: [1e-10, 1e-10, 1e-10, 0, 0, 0]"
DIAMETER = 0.03
LENGTH = 0.8


def cantilever(direction, more, *, material="steel", pieces=4):
    """A round bar from ground in a direction."""
    x, y, z = LENGTH * np.asarray(direction)
    return f"""\
bodies:
  tip: {{motion: free, {DUST}, position: [{x}, {y}, {z}]}}
beams:
  arm: {{ends: [ground, tip], section: {{diameter: {DIAMETER} m}}, material: {material}, pieces: {pieces}}}
{more}"""


def compliance(a, x):
    """Displacement at x of a cantilever per force at a: across, by Timoshenko, and along it [m/N].

    S. Timoshenko, J. Gere, Mechanics of Materials: P s^2 (3 l - s)/(6 E I) with s the smaller and l the
    larger of the two, and P s/(kappa A G) of shear; Cowper's factor of a round bar, 6 (1 + nu)/(7 + 6 nu).
    """
    steel = material("steel")
    area, second = math.pi * DIAMETER**2 / 4.0, math.pi * DIAMETER**4 / 64.0
    kappa = 6.0 * (1.0 + steel.poisson_ratio) / (7.0 + 6.0 * steel.poisson_ratio)
    s, far = min(a, x), max(a, x)
    bending = s**2 * (3.0 * far - s) / (6.0 * steel.youngs_modulus * second)
    shear = s / (kappa * area * steel.shear_modulus)
    return bending + shear, s / (area * steel.youngs_modulus)


@pytest.mark.parametrize("direction", [(1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (1 / 3, -2 / 3, 2 / 3)])
@pytest.mark.parametrize("station", [2, 3, 4])
def test_a_force_at_a_station_deflects_a_cantilever_as_timoshenko_has_it(direction, station):
    force = np.array([0.3, -0.2, 0.5])
    sensors = "".join(
        f"  {axis}{k}: {{type: frames, quantity: position, ends: [arm.{k}, ground], axis: {axis}}}\n"
        for k in (2, 3, 4)
        for axis in "xyz"
    )
    more = (
        f"loads:\n  push: {{body: arm, marker: {station}, force: {[f'{f} N' for f in force]}}}\n"
        f"sensors:\n{sensors}"
    ).replace("'", "")
    model = loads_model(cantilever(direction, more))
    assert loads_model(dump_model(model)) == model
    system = compile_model(model)
    rest = find_equilibrium(system).state
    row = observe(system, rest)
    e = np.array(direction)
    for k in (2, 3, 4):
        start = e * LENGTH * (k - 1) / 4
        moved = [row[system.layout.channel(f"signal[{axis}{k}]")] for axis in "xyz"] - start
        across, along = compliance(LENGTH * (station - 1) / 4, LENGTH * (k - 1) / 4)
        expected = across * (force - e * (force @ e)) + along * e * (force @ e)
        # deflections of 1e-5 of the length: the second order is 1e-10 of it
        assert moved == pytest.approx(expected, abs=3e-5 * np.linalg.norm(expected))


def test_a_spring_at_a_station_shares_its_way_with_the_beam():
    # a spring shortened by 1 mm between a fixed point and the station: force = way/(1/k + compliance)
    stiffness, way, reach = 2e4, 1e-3, 0.3
    more = f"springs:\n  s: {{ends: [arm.3, ground], stiffness: {stiffness}, free_length: {reach - way} m}}\n"
    text = cantilever((0.0, 0.0, 1.0), more.replace("ground", "post.at"))
    post = f"  post: {{motion: fixed, mass: 1 kg, markers: {{at: {{position: [{reach} m, 0, 0.4 m]}}}}}}\n"
    system = compile_model(loads_model(text.replace("beams:", post + "beams:")))
    tension = observe(system, find_equilibrium(system).state)[system.layout.channel("tension[s]")]
    across, _ = compliance(LENGTH / 2, LENGTH / 2)
    # foreshortening of the beam and inclination of the spring: squares of 1e-3
    assert tension == pytest.approx(way / (1.0 / stiffness + across), rel=1e-5)


def test_a_mass_on_a_spring_at_a_station_vibrates_on_both_springs():
    # a beam of 0.06 g under 3 kg: f = sqrt(1/(m (1/k + compliance)))/(2 pi)
    stiffness, mass, reach = 2e5, 3.0, 0.3
    body = f"  load: {{mass: {mass}, inertia_tensor: [1, 1, 1, 0, 0, 0]}}\n"
    more = (
        f"joints:\n  way: {{type: prismatic, bodies: [ground, load], position: [{reach}, 0, 0.6], "
        "axes: {z: [1, 0, 0]}}\n"
        f"springs:\n  s: {{ends: [arm.4, load], stiffness: {stiffness}}}\n"
    )
    text = cantilever((0.0, 0.0, 1.0), more, material=LIGHT).replace("beams:", body + "beams:")
    found = np.sort(find_modes(compile_model(loads_model(text))).frequency)[0]
    across, _ = compliance(0.6, 0.6)
    assert found == pytest.approx(1.0 / (math.tau * math.sqrt(mass * (1.0 / stiffness + across))), rel=1e-5)


def test_rounding_errors_of_beams_without_mass_are_told():
    """At 1e-5 kg/m^3 the frequency of the mass on its spring is 2.4 % wrong: the highest one is 4e8 Hz."""
    body = "  load: {mass: 3, inertia_tensor: [1, 1, 1, 0, 0, 0]}\n"
    more = (
        "joints:\n  way: {type: prismatic, bodies: [ground, load], position: [0.3, 0, 0.6], "
        "axes: {z: [1, 0, 0]}}\nsprings:\n  s: {ends: [arm.4, load], stiffness: 2e5}\n"
    )
    across, _ = compliance(0.6, 0.6)
    exact = 1.0 / (math.tau * math.sqrt(3.0 * (1.0 / 2e5 + across)))
    told = {}
    for density in ("0.1", "1e-5"):
        text = cantilever((0.0, 0.0, 1.0), more, material=LIGHT.replace("0.1 kg", f"{density} kg"))
        if density != "0.1":
            text = text.replace("0.1 mg", "1e-11 kg").replace("1e-10", "1e-14")
        modes = find_modes(compile_model(loads_model(text.replace("beams:", body + "beams:"))))
        wrong = abs(np.sort(modes.frequency)[0] / exact - 1.0)
        told[density] = wrong, [note for note in modes.notes if "rounding errors of more than" in note]
    assert told["0.1"][0] < 1e-5
    assert not told["0.1"][1]
    assert told["1e-5"][0] > 1e-3
    (note,) = told["1e-5"][1]
    assert "give it more mass or density" in note


ELEMENTS = {
    "springs": "{ends: [arm.3, mass.side], stiffness: 1e5, damping: 10}",
    "maxwells": "{ends: [mass.side, arm.3], stiffness: 1e5, damping: 1e3}",
    "bushings": "{ends: [arm.3, mass], stiffness: {radial: 1e5, axial: 2e5, tilt: 10, torsion: 20}}",
    "rods": "{ends: [arm.3, mass.side]}",
    "bearings": "{body: mass, housing: arm.3, stiffness: {radial: 1e5, axial: 1e5, tilt: 100}}",
    "rolling_bearings": "{ends: [mass, arm.3], elements: 9, element_diameter: 8 mm, pitch_diameter: 40 mm, "
    "grooves: [0.52, 0.52], clearance: -5 um}",
    "rolling_bearings ": "{body: mass, housing: arm.3, elements: 9, element_diameter: 8 mm, "
    "pitch_diameter: 40 mm, grooves: [0.52, 0.52], clearance: -5 um}",
    "plain_bearings": "{ends: [mass, arm.3], clearance: 0.02 mm, stiffness: 1e7}",
    "surface_contacts": "{ends: [mass.side, arm.3], first: {shape: sphere, radius: 50 mm}, "
    "second: {shape: plane}, law: {force: 1 kN, depth: 0.1 mm}}",
    "loads": "{body: arm, marker: 3, force: [80 N, 20 N, -30 N], along: marker}",
    "actuators": "{type: force, quantity: moment, signal: one, ends: [arm.3, ground], axis: y}",
    "beams": "{ends: [mass.side, arm.3], section: {diameter: 10 mm}, pieces: 2}",
}
UNDRAWN = ("loads", "actuators")
BUILT = """\
bodies:
  tip: {{motion: free, {dust}, position: [0, 0, 0.8 m]}}
{knot}  mass:
    motion: free
    mass: 2 kg
    inertia_tensor: [0.01, 0.01, 0.02, 0, 0, 0]
    position: [0, 0, 0.4 m]
    markers: {{side: {{position: [0.1 m, 0, 0.05 m]}}}}
bushings:
  held: {{ends: [mass, ground], stiffness: {{radial: 1e4, axial: 1e4, tilt: 200, torsion: 300}}}}
blocks:
  one: {{type: formula, formula: 5 + 0 * t, inputs: [t], unit: N m}}
loads:
  push: {{body: mass, force: [100 N, 30 N, -20 N]}}
beams:
{beams}
"""


@pytest.mark.parametrize("section", ELEMENTS)
def test_a_station_is_an_end_like_a_body_between_two_beams(section):
    bar = "section: {diameter: 30 mm}, internal_damping: 1 us"
    one = f"  arm: {{ends: [ground, tip], {bar}, pieces: 4}}"
    two = (
        f"  arm: {{ends: [ground, knot], {bar}, pieces: 2}}\n  rest: {{ends: [knot, tip], {bar}, pieces: 2}}"
    )
    knot = f"  knot: {{motion: free, {DUST}, position: [0, 0, 0.4 m], markers: {{at: {{}}}}}}\n"
    found = []
    for beams, bodies, end, load in (
        (one, "", "arm.3", "body: arm, marker: 3"),
        (two, knot, "knot.at", "body: knot, marker: at"),
    ):
        element = ELEMENTS[section].replace("arm.3", end).replace("body: arm, marker: 3", load)
        text = BUILT.format(dust=DUST, knot=bodies, beams=beams)
        if "side" not in element:
            text = text.replace("    markers: {side: {position: [0.1 m, 0, 0.05 m]}}\n", "")
        section = section.strip()
        head, line = f"\n{section}:\n", f"  other: {element}\n"
        text = text.replace(head, head + line) if head in text else f"{text}{section}:\n{line}"
        model = loads_model(text)
        assert any("other" in solid.name for solid in rest_scene(model).solids) or section in UNDRAWN
        assert summary(model)["ok"]
        system = compile_model(model)
        rest = find_equilibrium(system).state
        at = [system.layout.coordinates.index(f"{body}.{c}") for body in ("mass", "tip") for c in "xyz"]
        found.append((rest.q[at], np.sort(find_modes(system).frequency)[:6]))
    (ways, frequencies), (same, others) = found
    assert np.abs(ways).max() > 1e-4
    assert ways == pytest.approx(same, rel=1e-6, abs=1e-9)
    assert frequencies == pytest.approx(others, rel=1e-5)


MASS = """\
  mass: {mass: 2 kg, inertia_tensor: [0.01, 0.01, 0.02, 0, 0, 0], markers: {side: {position: [0.1 m, 0, 0]}}}
"""
JOINED = {
    "fixed": (MASS, "joints: {j: {type: fixed, bodies: [arm.3, mass.side]}}"),
    "universal": (MASS, "joints: {j: {type: universal, bodies: [arm.3, mass.side], axes: {z: [1, 0, 0]}}}"),
    "reversed": (MASS, "joints: {j: {type: revolute, bodies: [mass.side, arm.3], axes: {z: [0, 1, 0]}}}"),
    "cut": (
        MASS,
        "joints: {way: {type: free, bodies: [ground, mass], position: [-0.1 m, 0, 0.4 m]}, "
        "j: {type: spherical, bodies: [arm.3, mass.side]}}",
    ),
    "stations": (
        MASS.replace("mass: {", "mass: {motion: free, position: [0.8 m, 0, 0.4 m], ", 1),
        "joints: {j: {type: spherical, bodies: [arm.3, side.2]}}",
    ),
}


@pytest.mark.parametrize("how", JOINED)
def test_a_joint_at_a_station_is_one_at_a_body_between_two_beams(how):
    mass, joints = JOINED[how]
    bar = "section: {diameter: 30 mm}, internal_damping: 1 us"
    side = "  side: {ends: [ground.far, mass], section: {diameter: 10 mm}, pieces: 2}\n"
    found = []
    for beams, knot, end in (
        (f"  arm: {{ends: [ground, tip], {bar}, pieces: 4}}", "", "arm.3"),
        (
            f"  arm: {{ends: [ground, knot], {bar}, pieces: 2}}\n"
            f"  rest: {{ends: [knot, tip], {bar}, pieces: 2}}",
            f"  knot: {{motion: free, {DUST}, position: [0, 0, 0.4 m], markers: {{at: {{}}}}}}\n",
            "knot.at",
        ),
    ):
        posts, more = "", joints.replace("arm.3", end)
        if how == "stations":
            posts = "  post: {motion: fixed, mass: 1 kg, position: [-0.8 m, 0, 0.4 m]}\n"
            beams += "\n" + side.replace("ground.far", "post")
        text = (
            f"bodies:\n  tip: {{motion: free, {DUST}, position: [0, 0, 0.8 m]}}\n{posts}{knot}{mass}"
            f"beams:\n{beams}\n{more}\nbushings:\n"
            "  held: {ends: [mass, ground], stiffness: {radial: 1e4, axial: 1e4, tilt: 200, torsion: 300}}\n"
            "loads: {push: {body: mass, marker: side, force: [100 N, 30 N, -20 N]}}\ngravity: [0, 1, -9.81]\n"
        )
        model = loads_model(text)
        assert loads_model(dump_model(model)) == model
        assert summary(model)["ok"]
        assert rest_scene(model).bodies
        system = compile_model(model)
        rest = find_equilibrium(system).state
        sensed = [observe(system, rest)[system.layout.channel(f"displacement[tip.{c}]")] for c in "xyz"]
        found.append((sensed, np.sort(find_modes(system).frequency)[:6]))
    (ways, frequencies), (same, others) = found
    assert np.abs(ways).max() > 1e-5
    assert ways == pytest.approx(same, rel=1e-6, abs=1e-9)
    assert frequencies == pytest.approx(others, rel=1e-5)


def test_a_gear_on_a_pin_gives_way_with_it():
    gear = "profile_shift_coefficient: 0, number_of_teeth: 30, normal_module: 4 mm, face_width: 20 mm"
    text = f"""\
bodies:
  tip: {{motion: free, {DUST}, position: [0, 0, 0.8 m]}}
  pinion: {{gears: [pinion], position: [120 mm, 0, 0.4 m]}}
  wheel: {{gears: [wheel]}}
gears:
  pinion: {{{gear}}}
  wheel: {{{gear}}}
beams:
  pin: {{ends: [ground, tip], section: {{diameter: {DIAMETER} m}}, pieces: 4}}
joints:
  on: {{type: revolute, bodies: [pin.3, wheel], axes: {{z: [0, 0, 1]}}}}
meshes:
  m: {{gears: [pinion, wheel], stiffness: {{law: constant, value: 1e9}}}}
torsion_springs:
  s: {{bodies: [wheel], stiffness: 1e7}}
loads:
  turn: {{body: pinion, torque: 60 N m}}
sensors:
  x: {{type: frames, quantity: position, ends: [pin.3, ground], axis: x}}
  y: {{type: frames, quantity: position, ends: [pin.3, ground], axis: y}}
"""
    system = compile_model(loads_model(text))
    row = observe(system, find_equilibrium(system).state)
    way = np.array([row[system.layout.channel(f"signal[{axis}]")] for axis in "xy"])
    force = abs(row[system.layout.channel("mesh_force[m]")])
    assert force == pytest.approx(60.0 / (0.06 * math.cos(math.radians(20.0))), rel=1e-3)
    across, _ = compliance(0.4, 0.4)
    # along the line of action, which turns with the centre distance by 1 deg; the width of the teeth resists
    # the inclination of the pin
    direction = [-math.sin(math.radians(20.0)), -math.cos(math.radians(20.0))]
    assert abs(way @ direction) == pytest.approx(np.hypot(*way), rel=1e-3)
    assert 0.9 < np.hypot(*way) / (force * across) < 1.0
    # the inclined wheel touches at one end of the face: its modes are those of the tangents at this position
    M, _, K = linearize(system, find_equilibrium(system).state)
    lowest = math.sqrt(np.linalg.eigvals(np.linalg.solve(M, K)).real.min()) / math.tau
    found = find_modes(system)
    assert np.sort(found.frequency)[0] == pytest.approx(lowest, rel=1e-3)
    assert not [note for note in found.notes if "no load" in note]


REVERSED = f"""\
bodies:
  tip: {{motion: free, {DUST}, position: [0.8 m, 0, 0]}}
  load: {{mass: 1 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0], position: [0.4 m, 0, 0.1 m]}}
beams:
  pin: {{ends: [ground, tip], section: {{diameter: 30 mm}}, pieces: 4}}
joints:
  j: {{type: planar, bodies: [load, pin.3]}}
sensors:
  turn: {{type: joint, coordinate: j.spin}}
"""
BALL = REVERSED.replace(
    "type: planar, bodies: [load, pin.3]", "type: universal, bodies: [pin.3, load]"
).replace("j.spin", "j.beta")


def test_the_remedy_of_a_reversed_joint_keeps_its_station():
    with pytest.raises(ModelError) as caught:
        loads_model(REVERSED)
    (problem,) = caught.value.problems
    assert "reversed because pin.3 carries load; write its bodies as [pin.3, load]" in str(problem)
    model = loads_model(REVERSED.replace("[load, pin.3]", "[pin.3, load]"))
    assert (model.mechanism.seats["load"].beam, model.mechanism.seats["load"].turned) == ("pin", False)
    with pytest.raises(ModelError) as caught:
        loads_model(REVERSED.replace("load, pin.3]", "load, pin.3], start: {x: 1 mm}"))
    assert "the joint carries load, not pin.3" in str(caught.value)


def test_the_remedy_of_a_sensor_measures_from_the_station():
    with pytest.raises(ModelError) as caught:
        loads_model(BALL)
    remedy = "{type: frames, quantity: angle, ends: [load, pin.3]"
    assert remedy in str(caught.value)
    measured = BALL.replace("{type: joint, coordinate: j.beta}", remedy + ", axis: z}")
    assert loads_model(measured).sensors["turn"].ends == ("load", "pin.3")


def test_a_gear_across_a_reversed_joint_keeps_its_station():
    gear = "{number_of_teeth: 30, normal_module: 4 mm, face_width: 20 mm, profile_shift_coefficient: 0}"
    text = REVERSED[: REVERSED.index("sensors:")].replace("planar, bodies: [load, pin.3]", "revolute, "
        "bodies: [load, pin.3], axes: {z: [1, 0, 0]}")  # fmt: skip
    with pytest.raises(ModelError) as caught:
        loads_model(text.replace("load: {", "load: {gears: [g], ") + f"gears: {{g: {gear}}}\n")
    assert "write its bodies as [pin.3, load]" in str(caught.value)


def test_check_shows_the_station_that_carries_a_body(tmp_path, capsys):
    model = REVERSED[: REVERSED.index("sensors:")]
    found = json_of(["check", written(tmp_path, model)], capsys)["joints"]["j"]
    assert (found["carries"], found["on"]) == ("load", "pin.3")


FRAME = """\
bodies:
  tip: {motion: free, mass: 1 g, inertia_tensor: [1e-6, 1e-6, 1e-6, 0, 0, 0], position: [1 m, 0, 0]}
  twig: {motion: free, mass: 1 g, inertia_tensor: [1e-6, 1e-6, 1e-6, 0, 0, 0], position: [500 mm, 0.2 m, 0]}
beams:
  branch: {ends: [arm.3, twig], section: {diameter: 5 mm}, pieces: 2}
  arm: {ends: [ground, tip], section: {diameter: 20 mm}, pieces: 4}
springs:
  s: {ends: [arm.2, tip], stiffness: 10 N/m}
loads:
  push: {body: arm, marker: 3, force: [0, 0, -1 N]}
sensors:
  w: {type: frames, quantity: position, ends: [branch.2, arm.4], axis: z}
"""


def test_check_shows_the_stations_with_their_positions(tmp_path, capsys):
    found = json_of(["check", written(tmp_path, FRAME)], capsys)["beam_stations"]
    assert found["branch"] == {"branch.2": {"place": 0.1, "world": [0.5, 0.1, 0.0], "there": ["w"]}}
    assert found["arm"]["arm.2"] == {"place": 0.25, "world": [0.25, 0.0, 0.0], "there": ["s"]}
    assert found["arm"]["arm.3"]["there"] == ["branch", "push"]


def test_the_scene_at_rest_has_a_spring_between_its_stations():
    scene = rest_scene(loads_model(FRAME))
    [spring] = [solid for solid in scene.solids if "s" in solid.name.split()]
    between = spring.between
    assert between.bodies == (-1, 0)
    assert between.ends[0] == pytest.approx([0.25, 0.0, 0.0])


@pytest.mark.parametrize(
    ("change", "where", "words"),
    [
        (
            ("[arm.2, tip]", "[arm.9, tip]"),
            "springs.s.ends[0] (line 8)",
            "did you mean arm.4? there are arm.2 at 250 mm",
        ),
        (
            ("[arm.2, tip]", "[arm, tip]"),
            "springs.s.ends[0] (line 8)",
            "names the beam arm without a station; there",
        ),
        (("[arm.2, tip]", "[arm.1, tip]"), "springs.s.ends[0] (line 8)", "write ground"),
        (("[arm.2, tip]", "[amr.2, tip]"), "springs.s.ends[0] (line 8)", "did you mean arm?"),
        (("[arm.2, tip]", "[arm.2, arm.2]"), "springs.s.ends (line 8)", "on the same body, arm.2"),
        (
            ("marker: 3", "marker: 7"),
            "loads.push.marker (line 10)",
            "names the station '7', which arm does not have",
        ),
        (
            ("marker: 3, force: [0, 0, -1 N]", "torque: 1 N m, marker: 3, force: [0, 0, 1]"),
            "loads.push.torque (line 10)",
            "no spin axis",
        ),
        (("[ground, tip]", "[branch.2, tip]"), "beams.branch.ends (line 5)", "lead back to branch"),
        (
            ("{type: frames, quantity: position, ends: [branch.2, arm.4]", "{type: load, at: arm.3"),
            "sensors.w.at (line 12)",
            "no joint carries",
        ),
        (
            ("sensors:", "joints:\n  j: {type: fixed, bodies: [arm.9, tip]}\nsensors:"),
            "joints.j.bodies[0] (line 12)",
            "did you mean arm.4?",
        ),
        (
            ("diameter: 5 mm}, pieces: 2", "diameter: 5 mm}, pieces: 1"),
            "sensors.w.ends[0] (line 12)",
            "write twig",
        ),
        (
            ("branch.2, arm.4", "branch, arm.4"),
            "sensors.w.ends[0] (line 12)",
            "there are branch.2 at 100 mm from arm.3",
        ),
    ],
)
def test_wrong_stations_are_told_with_their_line(change, where, words):
    assert change[0] in FRAME
    with pytest.raises(ModelError) as error:
        loads_model(FRAME.replace(*change))
    assert where in str(error.value)
    assert words in str(error.value)
    assert len(error.value.problems) == 1
