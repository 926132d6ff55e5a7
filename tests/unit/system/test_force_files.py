# SPDX-License-Identifier: Apache-2.0
"""Force elements and loads at markers from files: against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.mechanism_files import accelerations

pytestmark = pytest.mark.filterwarnings("ignore:.*is not used")  # each test needs some of the markers

ARM = """\
bodies:
  arm:
    mass: 2 kg
    center_of_mass: [0.2, 0, 0]
    inertia_tensor: [0, 0.05, 0.05, 0, 0, 0]
    axes: {x: [0, 1, 0]}
    markers: {tip: {position: [0.4, 0, 0], axes: {z: [1, 0, 0]}}}
  post: {motion: fixed, position: [0.5, 0.1, 0], markers: {top: {position: [0, 0.2, 0]}}}
  wheel: {motion: torsion, inertia: 0.3, position: [0, 0, 0]}
  disc: {motion: torsion, inertia: 0.3, position: [0, 0, 0]}
joints:
  pivot:
    type: revolute
    bodies: [ground, arm]
    position: [0, 0, 0]
    start: {spin: 20 deg}
    speed: {spin: 3 rad/s}
"""
INERTIA = 0.05 + 2.0 * 0.04


def motion(text):
    """Accelerations by coordinate and observations at the start of a file, which survives a round trip."""
    model = loads_model(text)
    assert loads_model(dump_model(model)) == model
    system = compile_model(model)
    state = system.initial_state()
    a, _ = accelerations(system, state)
    state.a = a
    seen = dict(zip((c.name for c in system.layout.channels), evaluate.observe(system, state), strict=True))
    return dict(zip(system.layout.coordinates, a, strict=True)), seen


def tip(angle, rate):
    """Place and velocity of the tip; the arm stands along y where the file places it."""
    x = 0.4 * np.array([-math.sin(angle), math.cos(angle)])
    return x, rate * 0.4 * np.array([-math.cos(angle), -math.sin(angle)])


@pytest.mark.parametrize(
    ("keys", "tension"),
    [
        ("stiffness: 2 kN/m, damping: 30 N s/m", lambda x, w: 2000.0 * x + 30.0 * w),
        ("stiffness: 2 kN/m, free_length: 0.1 m", lambda x, w: 2000.0 * (x + 0.5099019513592785 - 0.1)),
        (
            "force: 40 N/mm^3 * elongation^3 + 3 N s/m * rate",
            lambda x, w: 4e10 * x**3 + 3.0 * w,
        ),
        (
            "stiffness: 1 kN/m, force: {table: [[-1 m, -400 N], [0, 0], [1 m, 90 N]], over: elongation}",
            lambda x, w: 1000.0 * x + (90.0 * x if x > 0.0 else 400.0 * x),
        ),
        (
            "force: {table: [[-10 m/s, -200 N], [0, 0], [10 m/s, 500 N]], over: rate}",
            lambda x, w: 50.0 * w if w > 0.0 else 20.0 * w,
        ),
    ],
)
def test_springs_pull_along_their_line(keys, tension):
    text = f"{ARM}springs:\n  s: {{ends: [arm.tip, post.top], {keys}}}\n"
    a, seen = motion(text)
    x, v = tip(math.radians(20.0), 3.0)
    line = np.array([0.5, 0.3]) - x
    length = math.sqrt(line @ line)
    e = line / length
    free = math.hypot(0.5, 0.1)  # tip at (0, 0.4), top at (0.5, 0.3)
    pull = tension(length - free, -e @ v)
    assert seen["tension[s]"] == pytest.approx(pull, rel=1e-12)
    moment = x[0] * pull * e[1] - x[1] * pull * e[0]
    assert a["arm.spin"] == pytest.approx(moment / INERTIA, rel=1e-12)


def test_a_spring_may_follow_python(tmp_path):
    (tmp_path / "own.py").write_text("def law(t, x, p):\n    return p[0] * x + 7.0 * p[1]\n")
    law = "{python: 'own.py:law', parameters: [300]}"
    text = f"{ARM}springs:\n  s: {{ends: [arm.tip, post.top], force: {law}}}\n"
    model = loads_model(text, allow_code=True, file=str(tmp_path / "m.yaml"))
    system = compile_model(model)
    seen = dict(
        zip(
            (c.name for c in system.layout.channels),
            evaluate.observe(system, system.initial_state()),
            strict=True,
        )
    )
    x, v = tip(math.radians(20.0), 3.0)
    line = np.array([0.5, 0.3]) - x
    length = math.sqrt(line @ line)
    pull = 300.0 * (length - math.hypot(0.5, 0.1)) - 7.0 * (line @ v) / length
    assert seen["tension[s]"] == pytest.approx(pull, rel=1e-12)


def test_a_bushing_is_without_force_as_placed():
    keys = "ends: [arm.hub, ground], stiffness: {x: 1e5, y: 2e5, torsion: 40}, damping: {torsion: 2}"
    text = f"{ARM}bushings:\n  b: {{{keys}}}\n".replace("{tip:", "{hub: {axes: {x: [0, -1, 0]}}, tip:")
    a, seen = motion(text)
    torque = -40.0 * math.radians(20.0) - 2.0 * 3.0
    assert seen["bushing_force[b.mz]"] == pytest.approx(torque, rel=1e-12)
    assert a["arm.spin"] == pytest.approx(torque / INERTIA, rel=1e-12)
    still, _ = motion(text.replace("start: {spin: 20 deg}", "").replace("speed: {spin: 3 rad/s}", ""))
    assert still["arm.spin"] == pytest.approx(0.0, abs=1e-12)


def test_clutch_and_brake():
    smooth = "law: smooth, slip_speed: 0.1 rad/s"
    a, seen = motion(
        f"{ARM}clutches:\n  c: {{bodies: [arm, wheel], capacity: 5 N m * (1 + t/1 s), {smooth}}}\n"
    )
    # the smooth sign of 30 times the slip speed is 1 to the last digits
    assert seen["slip_speed[c]"] == pytest.approx(3.0)
    assert a["arm.spin"] == pytest.approx(-5.0 / INERTIA, rel=1e-9)
    assert a["wheel.spin"] == pytest.approx(5.0 / 0.3, rel=1e-9)
    a, _ = motion(f"{ARM}clutches:\n  c: {{bodies: [arm], capacity: 5 N m, {smooth}}}\n")
    assert a["arm.spin"] == pytest.approx(-5.0 / INERTIA, rel=1e-9)


def test_elements_with_a_state_start_without_force():
    text = f"""{ARM}clutches:
  c: {{bodies: [arm, wheel], capacity: 5 N m, wind_up: 0.01 rad, damping_time: 0 s}}
maxwells:
  m: {{ends: [arm.tip, post.top], stiffness: 1 kN/m, damping: 20 N s/m}}
torsion_maxwells:
  t: {{bodies: [arm], stiffness: 10 N m/rad, damping: 1 N m s/rad}}
"""
    a, _ = motion(text)
    assert a["arm.spin"] == 0.0
    rates = {name: a[f"{name}.state.spin"] for name in "cmt"}
    x, v = tip(math.radians(20.0), 3.0)
    line = np.array([0.5, 0.3]) - x
    assert rates["m"] == pytest.approx(-1000.0 * (line @ v) / np.sqrt(line @ line), rel=1e-12)
    assert abs(rates["t"]) == pytest.approx(10.0 * 3.0, rel=1e-12)
    assert rates["c"] == pytest.approx(3.0 / 0.01, rel=1e-12)


def test_torsion_springs_and_unbalances():
    text = f"""{ARM}torsion_springs:
  s: {{bodies: [arm, wheel], stiffness: 10 N m/rad, damping: 2 N m s/rad, angle: 5 deg}}
unbalances:
  u: {{body: wheel, mass: 0.1 kg, position: [0.5, 0, 0.2]}}
"""
    a, _ = motion(text)
    torque = 10.0 * math.radians(15.0) + 2.0 * 3.0
    assert a["arm.spin"] == pytest.approx(-torque / INERTIA, rel=1e-12)
    assert a["wheel.spin"] == pytest.approx(torque / (0.3 + 0.1 * 0.25), rel=1e-12)


def test_bearings_of_the_file_are_those_of_the_rules():
    text = """\
bodies:
  rotor:
    {motion: free, mass: 2, inertia: 0.3, transverse_inertia: 0.2, markers: {seat: {position: [0, 0, 0.1]}}}
  house: {motion: fixed, position: [0, 0, 0], markers: {bore: {position: [0, 0, 0.1]}}}
"""
    rolling = (
        "rolling_bearings:\n  r: {ends: [rotor.seat, house.bore], elements: 9, element_diameter: 12.7 mm, "
    )
    rolling += "pitch_diameter: 65 mm, grooves: [0.52, 0.52]}\n"
    plain = "plain_bearings:\n  p: {ends: [rotor.seat, house.bore], clearance: 0.1 mm, stiffness: 1e8}\n"
    for more, kind in ((rolling, "rolling_bearing"), (plain, "clearance_bearing")):
        model = loads_model(text + more)
        assert loads_model(dump_model(model)) == model
        system = compile_model(model)
        state = system.initial_state()
        state.q[system.layout.coordinate("rotor.x")] = 0.2e-3
        names = [c.name for c in system.layout.channels]
        seen = dict(zip(names, evaluate.observe(system, state), strict=True))
        assert system.records[kind].size == 1
        name = "r" if kind == "rolling_bearing" else "p"
        push = -seen[f"bearing_force[{name}.fx]"]
        if name == "p":
            assert push == pytest.approx(1e8 * 0.15e-3, rel=1e-9)
        else:  # Q = K d^1.5 of the balls ahead; K = 11.71e9 at 207 GPa (Harris)
            psi = 2.0 * np.pi * np.arange(9) / 9
            d = np.maximum(0.2e-3 * np.cos(psi), 0.0)
            assert push == pytest.approx(206.0 / 207.0 * (11.71e9 * d**1.5 * np.cos(psi)).sum(), rel=1e-3)


def test_loads_at_markers_move_with_the_body():
    x, _ = tip(math.radians(20.0), 3.0)
    a, _ = motion(f"{ARM}loads:\n  f: {{body: arm, marker: tip, force: [10 N, 0, 0]}}\n")
    assert a["arm.spin"] == pytest.approx(-x[1] * 10.0 / INERTIA, rel=1e-12)
    # z of the marker lies along the arm, x across it: about z x nearest to the x axis of the arm is y
    a, _ = motion(f"{ARM}loads:\n  f: {{body: arm, marker: tip, force: [10 N, 0, 6 N], along: marker}}\n")
    assert a["arm.spin"] == pytest.approx(0.4 * 10.0 / INERTIA, rel=1e-12)
    a, _ = motion(f"{ARM}loads:\n  f: {{body: arm, torque: 10 N m, reaction: wheel}}\n")
    assert a["arm.spin"] == pytest.approx(10.0 / INERTIA, rel=1e-12)
    assert a["wheel.spin"] == pytest.approx(-10.0 / 0.3, rel=1e-12)


BALLS = "rolling_bearings:\n  r: {ends: [wheel, ground], element_diameter: 1, pitch_diameter: 9"
CASES = {
    "negative capacity": (
        "clutches:\n  c: {bodies: [arm, wheel], capacity: -3 N m}",
        "clutches.c.capacity",
        "negative",
    ),
    "capacity of a table": (
        "clutches:\n  c: {bodies: [arm, wheel], capacity: {table: [[0 s, 1 N m], [1 s, -1 N m]]}}",
        "clutches.c.capacity",
        "negative",
    ),
    "clutch on ground": (
        "clutches:\n  c: {bodies: [ground, wheel], capacity: 3 N m}",
        "clutches.c.bodies",
        "give one body only",
    ),
    "clutch of nobody": (
        "clutches:\n  c: {bodies: [arm, wheal], capacity: 3 N m}",
        "clutches.c.bodies",
        "did you mean wheel?",
    ),
    "torsion spring on itself": (
        "torsion_springs:\n  c: {bodies: [arm, arm], stiffness: 3}",
        "torsion_springs.c.bodies",
        "names arm twice",
    ),
    "two states of one name": (
        "maxwells:\n  c: {ends: [arm, post], stiffness: 1, damping: 1}\n"
        "clutches:\n  c: {bodies: [arm], capacity: 1}",
        "clutches.c",
        "has the name of an element of maxwells",
    ),
    "a ratio of a bushing": (
        "bushings:\n  b: {ends: [arm, ground], stiffness: {radial: 1}, damping: {ratio: 0.1}}",
        "bushings.b.damping.ratio",
        "is not defined",
    ),
    "radial and x": (
        "bushings:\n  b: {ends: [arm, ground], stiffness: {radial: 1, x: 2}}",
        "bushings.b.stiffness.x",
        "cannot be combined with radial",
    ),
    "a spring on one body": (
        "springs:\n  s: {ends: [arm, arm.tip], stiffness: 1}",
        "springs.s.ends",
        "are on the same body",
    ),
    "too many balls": (
        f"{BALLS}, elements: 90, stiffness: 1}}",
        "rolling_bearings.r.elements",
        "do not fit on a pitch circle",
    ),
    "balls without grooves": (
        f"{BALLS}, elements: 9}}",
        "rolling_bearings.r",
        "gives neither grooves nor stiffness",
    ),
    "rollers in grooves": (
        f"{BALLS}, elements: 9, type: roller, grooves: [0.52, 0.52]}}",
        "rolling_bearings.r.grooves",
        "does not apply to a bearing of type roller",
    ),
    "an unbalance of what is fixed": (
        "unbalances:\n  u: {body: post, mass: 1, position: [0, 0, 0]}",
        "unbalances.u.body",
        "names post, which is fixed",
    ),
    "an unbalance of a polar inertia": (
        "  slide: {type: cylindrical, bodies: [ground, disc], position: [0, 0, 0]}\n"
        "unbalances:\n  u: {body: disc, mass: 1, position: [0, 0, 0]}",
        "unbalances.u.body",
        "only a polar moment of inertia",
    ),
    "an unknown marker": (
        "loads:\n  f: {body: arm, marker: tap, force: [1, 0, 0]}",
        "loads.f.marker",
        "did you mean tip?",
    ),
    "marker and position": (
        "loads:\n  f: {body: arm, marker: tip, position: [0, 0, 1], force: [1, 0, 0]}",
        "loads.f.position",
        "cannot be combined with marker",
    ),
    "marker of a torque": (
        "loads:\n  f: {body: arm, marker: tip, torque: 1}",
        "loads.f.marker",
        "no effect on a torque",
    ),
    "along no marker": (
        "loads:\n  f: {body: wheel, along: marker, torque: 1}",
        "loads.f.along",
        "no marker is given",
    ),
    "a reaction on itself": (
        "loads:\n  f: {body: arm, reaction: arm, torque: 1}",
        "loads.f.reaction",
        "acts on arm itself",
    ),
    "an unknown reaction": (
        "loads:\n  f: {body: arm, reaction: wheal, torque: 1}",
        "loads.f.reaction",
        "did you mean wheel?",
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_wrong_forces_are_told_with_their_line(case):
    text, where, words = CASES[case]
    base = ARM.replace("disc: {motion: torsion,", "disc: {mass: 1,") if "disc" in text else ARM
    with pytest.raises(ModelError) as caught:
        loads_model(f"{base}{text}\n")
    assert [p.where for p in caught.value.problems] == [where], caught.value
    assert words in str(caught.value)
    assert caught.value.problems[0].line is not None
