# SPDX-License-Identifier: Apache-2.0
"""Wrong mechanisms: every fault is told with its line, what is wrong and what to do, and nothing else is."""

from __future__ import annotations

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from tests.support.mechanism_files import SLIDER_CRANK
from tests.support.model_files import gear

CRANK = "markers: {pin: {position: [100 mm, 0, 0]}}"
MAIN = "  main: {type: revolute, bodies: [ground, crank], position: [0, 0, 0]}\n"
PISTON = "  piston: {mass: 0.5 kg}\n"
BLOCK = "{mass: 1 kg, inertia_tensor: [1, 1, 1, 0, 0, 0]}"
PIN = "  piston_pin: {type: revolute, bodies: [rod.small, piston]}\n"
CYLINDER = "  cylinder: {type: prismatic, bodies: [ground, piston], axes: {z: [1, 0, 0]}}\n"
GEAR = "gears:\n" + gear("g")
RUN = "scenarios:\n  run: {duration: 1 s, %s}\n"


def joint(line: str) -> tuple[str, str]:
    """One more joint at the end."""
    return PIN, f"{PIN}  more: {{{line}}}\n"


# (changes of the slider-crank, place, words that the sentence must hold)
CASES: dict[str, tuple[list[tuple[str, str]], str, str]] = {
    "unknown body": ([("[ground, crank]", "[ground, crnk]")], "joints.main.bodies[1]", "did you mean crank?"),
    "unknown marker": ([("[crank.pin,", "[crank.pni,")], "joints.crank_pin.bodies[0]", "did you mean pin?"),
    "marker of ground": (
        [("[ground, crank]", "[ground.a, crank]")],
        "joints.main.bodies[0]",
        "names a marker of ground",
    ),
    "two dots": (
        [("[crank.pin,", "[crank.pin.x,")],
        "joints.crank_pin.bodies[0]",
        "is not a point on a body",
    ),
    "one body": ([("[ground, crank]", "[ground]")], "joints.main.bodies", "has 1 entries"),
    "a body on itself": (
        [("[crank.pin, rod.big]", "[rod.small, rod.big]")],
        "joints.crank_pin.bodies",
        "are on the same body",
    ),
    "a body called ground": (
        [(PISTON, PISTON + "  ground: {inertia: 1 kg m^2}\n")],
        "bodies.ground",
        "is a reserved name",
    ),
    "unknown type": ([("type: prismatic", "type: prisma")], "joints.cylinder.type", "did you mean prismatic"),
    "no type": (
        [("{type: revolute, bodies: [ground, crank],", "{bodies: [ground, crank],")],
        "joints.main.type",
        "is missing",
    ),
    "no direction": (
        [("axes: {z: [1, 0, 0]}", "axes: {z: [0, 0, 0]}")],
        "joints.cylinder.axes.z",
        "is not a direction",
    ),
    "askew axes": (
        [("axes: {z: [1, 0, 0]}", "axes: {z: [1, 0, 0], x: [1, 1, 0]}")],
        "joints.cylinder.axes.x",
        "45 deg is not perpendicular to z",
    ),
    "screw without lead": (
        [("type: prismatic", "type: screw")],
        "joints.cylinder.lead",
        "is missing: a screw",
    ),
    "screw of lead zero": (
        [("type: prismatic,", "type: screw, lead: 0 mm,")],
        "joints.cylinder.lead",
        "is zero",
    ),
    "start of what is not there": (
        [("axes: {z: [1, 0, 0]}", "axes: {z: [1, 0, 0]}, start: {spin: 3 deg}")],
        "joints.cylinder.start.spin",
        "is not a coordinate of a joint of type prismatic",
    ),
    "start of what is nothing": (
        [("axes: {z: [1, 0, 0]}", "axes: {z: [1, 0, 0]}, start: {q: 3 deg}")],
        "joints.cylinder.start.q",
        "unknown key",
    ),
    "start in a wrong unit": (
        [("axes: {z: [1, 0, 0]}", "axes: {z: [1, 0, 0]}, start: {z: 3 deg}")],
        "joints.cylinder.start.z",
        "not the unit of a length",
    ),
    "speed of a loop": (
        [("[rod.small, piston]", "[rod.small, piston], speed: {spin: 3 rpm}")],
        "joints.piston_pin.speed",
        "closes a loop",
    ),
    "motion and joint": (
        [("  crank:\n", "  crank:\n    motion: torsion\n")],
        "bodies.crank.motion",
        "as does the joint main",
    ),
    "floating with a joint": ([(MAIN, ""), (CYLINDER, "")], "bodies.crank", "floats: crank_pin connects it"),
    "floating without a joint": (
        [(PISTON, PISTON + "  block: {mass: 1 kg, inertia_tensor: [1, 1, 1, 0, 0, 0]}\n")],
        "bodies.block",
        "floats: it has neither a joint nor a motion",
    ),
    "fixed both ways": (
        [
            (PISTON, PISTON + "  lid: {mass: 1 kg}\n"),
            joint("type: fixed, bodies: [piston, lid]}\n  again: {type: fixed, bodies: [lid, piston]"),
        ],
        "joints.again.bodies",
        "which are already connected by fixed joints",
    ),
    "a loop of fixed joints": (
        [
            (PISTON, PISTON + "  lid: {mass: 1 kg}\n  bolt: {mass: 1 kg}\n"),
            joint(
                "type: fixed, bodies: [piston, lid]}\n  b: {type: fixed, bodies: [lid, bolt]}\n"
                "  c: {type: revolute, bodies: [bolt, piston]"
            ),
        ],
        "joints.c.bodies",
        "which are already connected by fixed joints",
    ),
    "markers apart": (
        [("  rod:\n", "  rod:\n    position: [101 mm, 0, 0]\n")],
        "joints.crank_pin.bodies",
        "rod.big is 1 mm from the joint",
    ),
    "marker beside the joint": (
        [("[crank.pin, rod.big]}", "[crank.pin, rod.big], position: [100 mm, 2 mm, 0]}")],
        "joints.crank_pin.position",
        "is 2 mm from crank.pin",
    ),
    "markers askew": (
        [
            ("{pin: {position: [100 mm, 0, 0]}}", "{pin: {position: [100 mm, 0, 0], axes: {z: [0, 0, 1]}}}"),
            ("{big: {}", "{big: {axes: {z: [0, 1, 1]}}"),
        ],
        "joints.crank_pin.bodies",
        "rod.big, which are tilted by 45 deg",
    ),
    "a joint without a place": (
        [(", position: [0, 0, 0]}", "}"), ("rod.big", "rod"), (CYLINDER, "")],
        "joints.main.position",
        "is missing",
    ),
    "no mass on a slide": (
        [("{mass: 0.5 kg}", "{}")],
        "joints.cylinder",
        "moves no mass by its coordinate z",
    ),
    "no inertia about a pin": (
        [(CYLINDER, ""), (PIN, PIN + CYLINDER)],
        "joints.piston_pin",
        "moves no inertia by its coordinate spin (limit > 0); give piston inertia_tensor, or write cut",
    ),
    "two joints on one axis": (
        [
            (PISTON, PISTON + "  ring: {}\n"),
            joint(
                "type: revolute, bodies: [ground, ring], position: [0, 1, 0]}\n  wheel_pin: {type: revolute, "
                "bodies: [ring, wheel], position: [0, 1, 0]"
            ),
            (PISTON, PISTON + "  wheel: {mass: 1 kg, inertia: 0.1 kg m^2}\n"),
        ],
        "joints.more",
        "has no inertia in a combined motion of more.spin and wheel_pin.spin",
    ),
    "a tensor of no mass": (
        [("[2e-4, 1.1e-3, 1.2e-3,", "[2e-4, 1.1e-3, 2e-3,")],
        "bodies.crank.inertia_tensor",
        "are not physically possible",
    ),
    "a tensor of five": (
        [("1.2e-3, 0, 0, 0]", "1.2e-3, 0, 0]")],
        "bodies.crank.inertia_tensor",
        "has 5 entries",
    ),
    "a tensor and an inertia": (
        [("    inertia_tensor: [2e-4", "    inertia: 1 kg m^2\n    inertia_tensor: [2e-4")],
        "bodies.crank.inertia_tensor",
        "cannot be combined with inertia",
    ),
    "inertia off the axis": (
        [("inertia_tensor: [2e-4, 1.1e-3, 1.2e-3, 0, 0, 0]", "inertia: 1e-3 kg m^2")],
        "bodies.crank.center_of_mass",
        "is off the axis",
    ),
    "a polar inertia about another axis": (
        [("{mass: 0.5 kg}", "{mass: 0.5 kg, inertia: 0.1 kg m^2}")],
        "bodies.piston.inertia",
        "does not define the inertia about the axis of cylinder",
    ),
    "a rod of no length": (
        [(PIN, f"{PIN}rods:\n  r: {{ends: [crank.pin, rod.big]}}\n")],
        "rods.r.ends",
        "coincide",
    ),
    "a rod on one body": (
        [(PIN, f"{PIN}rods:\n  r: {{ends: [rod.small, rod.big]}}\n")],
        "rods.r.ends",
        "are on the same body, rod",
    ),
    "motion that is missing": (
        [joint("type: moved, bodies: [ground, b]"), (PISTON, PISTON + "  b: {mass: 1 kg}\n")],
        "joints.more.motion",
        "is missing",
    ),
    "motion in a wrong unit": (
        [
            joint("type: moved, bodies: [ground, b], motion: {x: 3 deg}"),
            (PISTON, PISTON + "  b: {mass: 1 kg}\n"),
        ],
        "joints.more.motion.x",
        "not the unit of a length",
    ),
    "motion of what is not there": (
        [
            joint("type: moved, bodies: [ground, b], position: [0, 0, 0], motion: {u: 3 mm}"),
            (PISTON, PISTON + "  b: {mass: 1 kg}\n"),
        ],
        "joints.more.motion.u",
        "is an unknown key",
    ),
    "a moved joint in a loop": (
        [joint("type: moved, bodies: [ground, piston], motion: {x: 3 mm}")],
        "joints.more.bodies",
        "cannot close a loop",
    ),
    "a coordinate that moves nothing": (
        [
            joint("type: user, bodies: [ground, b], coordinates: {s: length, p: angle}, motion: {x: 2*s}"),
            (PISTON, PISTON + "  b: {mass: 1 kg}\n"),
        ],
        "joints.more.coordinates.p",
        "has no effect",
    ),
    "two coordinates in one function": (
        [
            joint(
                "type: user, bodies: [ground, b], coordinates: {s: length, p: length}, motion: {x: s*p/1 m}"
            ),
            (PISTON, PISTON + "  b: {mass: 1 kg}\n"),
        ],
        "joints.more.motion.x",
        "depends on p and s",
    ),
    "a reserved coordinate": (
        [
            joint("type: user, bodies: [ground, b], coordinates: {t: length}, motion: {x: 2 mm}"),
            (PISTON, PISTON + "  b: {mass: 1 kg}\n"),
        ],
        "joints.more.coordinates.t",
        "is not a name for a coordinate",
    ),
    "start of a plane turned round": (
        [
            joint("type: planar, bodies: [b, ground], position: [0, 0, 0], start: {x: 1 mm}"),
            (PISTON, PISTON + "  b: {mass: 1 kg, inertia: 1 kg m^2}\n"),
        ],
        "joints.more.start",
        "has the opposite sense",
    ),
    "friction of a ball": (
        [("type: prismatic,", "type: spherical, friction: {coefficient: 0.1},")],
        "joints.cylinder.friction.radius",
        "is missing: the radius of the ball",
    ),
    "friction of a pin without radius": (
        [("[crank.pin, rod.big]", "[crank.pin, rod.big], friction: {coefficient: 0.1}")],
        "joints.crank_pin.friction.radius",
        "is missing",
    ),
    "a slide with a radius": (
        [("type: prismatic,", "type: prismatic, friction: {coefficient: 0.1, radius: 1 mm},")],
        "joints.cylinder.friction.radius",
        "has no effect on a joint of type prismatic",
    ),
    "a start that is upside down": (
        [("type: prismatic,", "type: spherical, start: {beta: 100 deg},"), ("{mass: 0.5 kg}", BLOCK)],
        "joints.cylinder.start.beta",
        "is close to a right angle or above",
    ),
    "floating on what is cut": (
        [
            (PISTON, PISTON + f"  block: {BLOCK}\n"),
            joint("type: revolute, bodies: [ground, block], position: [0, 0, 0], cut: true"),
        ],
        "bodies.block",
        "have cut: true and carry no body",
    ),
    "a ratio of one": (
        [(PIN, f"{PIN}ratios:\n  r: {{terms: {{crank: 1}}}}\n")],
        "ratios.r.terms",
        "has 1 terms",
    ),
    "a ratio of nothing": (
        [(PIN, f"{PIN}ratios:\n  r: {{terms: {{crank: 1, rad: 2}}}}\n")],
        "ratios.r.terms.rad",
        "names the body 'rad', which does not exist",
    ),
    "a ratio of a loop": (
        [(PIN, f"{PIN}ratios:\n  r: {{terms: {{crank: 1, piston_pin.spin: 2}}}}\n")],
        "ratios.r.terms.piston_pin.spin",
        "closes a loop and has no independent coordinates; there are main.spin, crank_pin.spin, cylinder.z",
    ),
    "a ratio of angle and length": (
        [(PIN, f"{PIN}ratios:\n  r: {{terms: {{crank: 1, cylinder.z: 2}}}}\n")],
        "ratios.r.terms",
        "crank: angle, cylinder.z: length combine angles and lengths",
    ),
    "a driven coordinate that is not there": (
        [(PIN, PIN + RUN % "drive: {cylinder.spin: {speed: 3 rpm}}")],
        "scenarios.run.drive.cylinder.spin",
        "not a coordinate of cylinder (prismatic); it has z",
    ),
    "a travel at a speed of turns": (
        [(PIN, PIN + RUN % "drive: {cylinder.z: {speed: 3 rpm}}")],
        "scenarios.run.drive.cylinder.z.speed",
        "give velocity or position",
    ),
    "a driven body that does not spin": (
        [(PIN, PIN + RUN % "drive: {piston: {speed: 3 rpm}}")],
        "scenarios.run.drive.piston",
        "has no spin",
    ),
    "two dots in a drive": (
        [(PIN, PIN + RUN % "drive: {a.b.c: {speed: 3 rpm}}")],
        "scenarios.run.drive.a.b.c",
        "is not a usable name",
    ),
    "gears on a swinging body": (
        [("gears: {}", "gears: {}"), ("  piston: {mass: 0.5 kg}", "  piston: {mass: 0.5 kg, gears: [g]}")],
        "bodies.piston.gears",
        "is not the axis of the joint cylinder",
    ),
    "gears on a tumbling body": (
        [
            ("type: prismatic", "type: spherical"),
            ("  piston: {mass: 0.5 kg}", "  piston: {mass: 0.5 kg, gears: [g]}"),
        ],
        "bodies.piston.gears",
        "does not count revolutions",
    ),
    "a bearing beside the axis": (
        [(PIN, f"{PIN}bearings:\n  b: {{body: piston, stiffness: {{radial: 1e6}}}}\n")],
        "bearings.b.body",
        "acts on the z axis of piston",
    ),
    "a torque about another axis": (
        [(PIN, f"{PIN}loads:\n  b: {{body: piston, torque: 3 N m}}\n")],
        "loads.b.body",
        "acts about the z axis of piston",
    ),
}


def changed(case: str) -> tuple[str, str, str]:
    """Text of the wrong file, place and words."""
    changes, where, words = CASES[case]
    text = (GEAR if "gears" in case else "") + SLIDER_CRANK
    for old, new in changes:
        if old == "gears: {}":
            continue
        assert old in text, old
        text = text.replace(old, new)
    return text, where, words


@pytest.mark.parametrize("case", CASES)
def test_a_wrong_mechanism_is_told_once_with_its_line(case: str) -> None:
    text, where, words = changed(case)
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    told = [p for p in caught.value.problems if p.where == where]
    assert len(told) == 1, caught.value
    assert words in str(told[0])
    assert told[0].line is not None
    assert told[0].remedy
    if not case.startswith("floating with"):
        assert len(caught.value.problems) == 1, caught.value


def test_the_line_is_that_of_the_key() -> None:
    text, _, _ = changed("askew axes")
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    line = text.splitlines()[(caught.value.problems[0].line or 0) - 1]
    assert line.startswith("  cylinder:")


def test_a_wrong_mechanism_ends_with_exit_code_2(tmp_path, capsys) -> None:
    file = tmp_path / "wrong.yaml"
    file.write_text(changed("markers apart")[0])
    assert run_command(["check", str(file)]) == 2
    assert "is 1 mm from the joint" in capsys.readouterr().err


def test_all_faults_of_joints_are_told_at_once() -> None:
    text = SLIDER_CRANK.replace("[ground, crank]", "[ground, crnk]").replace("type: prismatic", "type: screw")
    text = text.replace("[2e-4, 1.1e-3, 1.2e-3,", "[2e-4, 1.1e-3, 2e-3,")
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    assert [p.where for p in caught.value.problems] == [
        "bodies.crank.inertia_tensor",
        "joints.main.bodies[1]",
        "joints.cylinder.lead",
    ]
