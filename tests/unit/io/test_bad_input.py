# SPDX-License-Identifier: Apache-2.0
"""Every kind of bad input: the place, the line and the remedy that a user is told."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.yaml_model import loads_model
from tests.support.model_files import TORSIONAL_PAIR, gear, pair

BODIES = "bodies:\n  one: {gears: [a]%s}\n  two: {gears: [b]%s}\n"


def problems(text: str) -> list[Message]:
    with pytest.raises(ModelError) as caught:
        loads_model(text, file="bad.yaml")
    assert str(caught.value).startswith("bad.yaml: ")
    return list(caught.value.problems)


HELIX = "helix_angle: 20 deg"
RING = "type: internal"

# (file, place, line, words that the message or remedy must hold)
CASES: dict[str, tuple[str, str, int, str]] = {
    "wrong unit": (
        "gears:\n" + gear("a", more="tip_diameter: 3 kg"),
        "gears.a.tip_diameter",
        2,
        "such as 3 mm",
    ),
    "unknown unit": ("gears:\n" + gear("a", more="tip_diameter: 96 mmm"), "gears.a.tip_diameter", 2, "mmm"),
    "unknown key": (
        "gears:\n" + gear("a", more="tip_diametre: 96 mm"),
        "gears.a.tip_diametre",
        2,
        "did you mean tip_diameter?",
    ),
    "unknown section": ("gear:\n" + gear("a") + "gears:\n" + gear("a"), "gear", 1, "did you mean gears?"),
    "missing key": (
        "gears:\n  a: {number_of_teeth: 20, face_width: 9 mm, profile_shift_coefficient: 0}\n",
        "gears.a.normal_module",
        2,
        "add normal_module: 3 mm",
    ),
    "missing gear": (
        pair(gear("a"), gear("c")),
        "meshes.m.gears",
        5,
        "names the gear 'b', which does not exist",
    ),
    "no gears": ("title: nothing\n", "gears", 1, "add gears"),
    "no contact": (
        pair(gear("a"), gear("b"), "center_distance: 100 mm"),
        "meshes.m.center_distance",
        5,
        "reduce",
    ),
    "interference": (
        pair(
            gear("a", 8, more="rack: {dedendum: 1.0, root_radius: 0.1}"),
            gear("b", 120),
            "center_distance: 192 mm",
        ),
        "meshes.m.gears",
        5,
        "shorten the tip",
    ),
    "negative tip clearance": (
        pair(gear("a"), gear("b", more="rack: {dedendum: 0.9, root_radius: 0.1}")),
        "meshes.m.center_distance",
        5,
        "tip clearance of a in the root of b",
    ),
    "pointed tooth": ("gears:\n" + gear("a", 20, 1.4), "gears.a.profile_shift_coefficient", 2, "use at most"),
    "equal hands": (
        pair(gear("a", more=f"{HELIX}, hand: left"), gear("b", more=f"{HELIX}, hand: left")),
        "meshes.m.gears",
        5,
        "change the hand",
    ),
    "opposite hands inside": (
        pair(gear("a", more=f"{HELIX}, hand: left"), gear("b", 80, more=f"{HELIX}, hand: right, {RING}")),
        "meshes.m.gears",
        5,
        "equal hands",
    ),
    "no hand": ("gears:\n" + gear("a", more=HELIX), "gears.a.hand", 2, "add hand: left or hand: right"),
    "small ring": (
        pair(gear("a", 60), gear("b", 50, more=RING), "center_distance: 15 mm"),
        "meshes.m.gears",
        5,
        "more teeth",
    ),
    "two rings": (
        pair(gear("a", 80, more=RING), gear("b", 60, more=RING), "center_distance: 30 mm"),
        "meshes.m.gears",
        5,
        "both internal",
    ),
    "ring first": (pair(gear("a", 80, more=RING), gear("b", 20)), "meshes.m.gears", 5, "[b, a]"),
    "other module": (
        pair(gear("a"), gear("b").replace("3 mm", "4 mm"), "center_distance: 100 mm"),
        "meshes.m.gears",
        5,
        "same normal_module",
    ),
    "zero inertia": (
        pair(gear("a"), gear("b"), "", BODIES % (", inertia: 0", "")),
        "bodies.one.inertia",
        7,
        "give inertia",
    ),
    "negative inertia": (
        pair(gear("a"), gear("b"), "", BODIES % (", inertia: -1 kg m^2", "")),
        "bodies.one.inertia",
        7,
        "> 0 for a body that moves, else >= 0",
    ),
    "zero mass": (
        pair(gear("a"), gear("b"), "", BODIES % ("", ", motion: planar, mass: 0 kg")),
        "bodies.two.mass",
        8,
        "moves (planar)",
    ),
    "bore larger than the root": (
        pair(gear("a", more="bore_diameter: 90 mm"), gear("b"), "", BODIES % ("", "")),
        "gears.a.bore_diameter",
        2,
        "",
    ),
    "no inertia at all": (
        pair(gear("a"), gear("b"), "", BODIES % ("", "") + "  three: {position: [0, 0, 0]}\n"),
        "bodies.three.inertia",
        9,
        "carries no gears",
    ),
    "NaN": (
        "gears:\n" + gear("a", more="tip_diameter: .nan"),
        "gears.a.tip_diameter",
        2,
        "not a finite number",
    ),
    "NaN as text": ("gears:\n" + gear("a", more="tip_diameter: nan"), "gears.a.tip_diameter", 2, "3 mm"),
    "infinite": ("gears:\n" + gear("a", more="tip_diameter: -.inf"), "gears.a.tip_diameter", 2, "finite"),
    "boolean": ("gears:\n" + gear("a", more="tip_diameter: true"), "gears.a.tip_diameter", 2, "not a number"),
    "boolean teeth": (
        "gears:\n" + gear("a").replace("30", "true"),
        "gears.a.number_of_teeth",
        2,
        "whole number",
    ),
    "half a tooth": (
        "gears:\n" + gear("a").replace("30", "30.5"),
        "gears.a.number_of_teeth",
        2,
        "whole number",
    ),
    "bare millimetres": (
        "gears:\n" + gear("a").replace("3 mm", "3"),
        "gears.a.normal_module",
        2,
        "in metres",
    ),
    "bare degrees": (
        "gears:\n" + gear("a", more="normal_pressure_angle: 20"),
        "gears.a.normal_pressure_angle",
        2,
        "in radians",
    ),
    "double name": ("gears:\n" + gear("a") + gear("b") + gear("a"), "gears.a", 4, "in line 2 and line 4"),
    "double key": ("title: a\ngears:\n" + gear("a") + "title: b\n", "title", 4, "line 1 and line 4"),
    "bracket": ("gears:\n  a: {number_of_teeth: 20\nmeshes: {}\n", "YAML syntax", 3, "brackets"),
    "tab": ("gears:\n\ta: 1\n", "YAML syntax", 2, "indentation"),
    "open shift": ("gears:\n" + gear("a", x=None), "gears.a.profile_shift_coefficient", 2, "give it"),
    "open shift without distance": (
        pair(gear("a", x=None), gear("b")),
        "gears.a.profile_shift_coefficient",
        2,
        "meshes.m.center_distance",
    ),
    "gear on two bodies": (
        "gears:\n"
        + gear("a")
        + gear("b")
        + "bodies:\n  one: {gears: [a, b]}\n  two: {gears: [b], position: [1, 0, 0]}\n",
        "bodies.two.gears",
        6,
        "is already on one",
    ),
    "mesh inside a body": (
        pair(gear("a"), gear("b"), "", "bodies:\n  one: {gears: [a, b]}\n"),
        "meshes.m.gears",
        5,
        "two bodies",
    ),
    "gear on no body": (
        pair(gear("a"), gear("b"), "", "bodies:\n  one: {gears: [a]}\n"),
        "gears.b",
        3,
        "add b to gears of a body",
    ),
    "no place": (
        pair(gear("a"), gear("b"), "", BODIES % ("", "") + "  three: {inertia: 1 kg m^2}\n"),
        "bodies.three",
        9,
        "give position",
    ),
    "positions against distance": (
        pair(
            gear("a"),
            gear("b"),
            "center_distance: 90 mm",
            BODIES % (", position: [0, 0, 0]", ", position: [0, 91 mm, 0]"),
        ),
        "meshes.m.center_distance",
        5,
        "is 1 mm less than the distance between the positions of its bodies, 91 mm",
    ),
    "faces apart": (
        pair(gear("a"), gear("b"), "", BODIES % (", position: [0, 0, 0]", ", position: [90 mm, 0, 30 mm]")),
        "meshes.m.gears",
        5,
        "the gap between their faces is 10 mm",
    ),
    "load on a fixed body": (
        pair(
            gear("a"),
            gear("b"),
            "",
            BODIES % (", motion: fixed", "") + "loads:\n  l: {body: one, torque: 1}\n",
        ),
        "loads.l.body",
        10,
        "fixed",
    ),
    "force on a torsion body": (
        pair(gear("a"), gear("b"), "", BODIES % ("", "") + "loads:\n  l: {body: one, force: [0, 3 N, 0]}\n"),
        "loads.l.force",
        10,
        "only rotates",
    ),
    "formula that is Python": (
        pair(gear("a"), gear("b"), "", BODIES % ("", "") + "loads:\n  l: {body: one, torque: t.__class__}\n"),
        "loads.l.torque",
        10,
        "a formula may use",
    ),
    "formula of another dimension": (
        pair(
            gear("a"),
            gear("b"),
            "",
            BODIES % ("", "") + "loads:\n  l: {body: one, torque: 150 kg * sin(2*pi*25 Hz*t)}\n",
        ),
        "loads.l.torque",
        10,
        "give kg, not N m",
    ),
    "prescribed speed that is an angle": (
        pair(
            gear("a"),
            gear("b"),
            "",
            BODIES % ("", "") + "scenarios:\n  s: {duration: 1 s, drive: {one: {speed: 1500 rpm * t}}}\n",
        ),
        "scenarios.s.drive.one.speed",
        10,
        "not rad/s",
    ),
    "Python code": (
        pair(gear("a"), gear("b"), "stiffness: {law: user, python: 'k.py:k'}"),
        "meshes.m.stiffness.python",
        5,
        "--allow-code",
    ),
    "speeds against the ratio": (
        pair(
            gear("a"),
            gear("b", 60),
            "",
            BODIES % ("", "") + "scenarios:\n  s: {duration: 1 s, speed: {one: 100 rpm, two: 50 rpm}}\n",
        ),
        "scenarios.s.speed.two",
        10,
        "does not match the gear ratio",
    ),
    "no duration": (
        pair(gear("a"), gear("b"), "", BODIES % ("", "") + "scenarios:\n  s: {speed: {one: 100 rpm}}\n"),
        "scenarios.s.duration",
        10,
        "add duration",
    ),
    "two backlashes": (
        pair(gear("a"), gear("b"), "backlash: {normal: 1 mm, base_tangent: 1 mm}"),
        "meshes.m.backlash",
        5,
        "exactly one of",
    ),
    "backlash without direction": (
        pair(gear("a"), gear("b"), "backlash: {}"),
        "meshes.m.backlash",
        5,
        "none",
    ),
    "unsorted table": (
        pair(
            gear("a"),
            gear("b"),
            "",
            BODIES % ("", "") + "loads:\n  l: {body: one, torque: {table: [[1, 0], [0, 1]]}}\n",
        ),
        "loads.l.torque.table[1]",
        10,
        "sort the rows",
    ),
    "two balances": (
        pair(
            gear("a"),
            gear("b"),
            "",
            BODIES % ("", "")
            + "loads:\n  l: {body: one, torque: balance}\n  k: {body: two, torque: balance}\n",
        ),
        "loads.k.torque",
        11,
        "all but one",
    ),
    "impossible assembly": (
        pair(gear("a", more="initial_angle: 0"), gear("b", more="initial_angle: 0")),
        "gears.b.initial_angle",
        3,
        "remove initial_angle",
    ),
    "wrong law": (
        pair(gear("a"), gear("b"), "stiffness: {law: dim3990}"),
        "meshes.m.stiffness.law",
        5,
        "din3990",
    ),
    "wrong material": (
        "gears:\n" + gear("a", more="material: steal"),
        "gears.a.material",
        2,
        "did you mean steel",
    ),
    "alias to itself": ("gears: &g\n  a: *g\n", "gears.a", 1, "refers to itself"),
    "tag": ("gears:\n  a: !!python/object:os.system {}\n", "gears.a", 2, ""),
    "empty file": ("", "model", 1, "begin with gears"),
    "a list": ("- a\n", "model", 1, "not a mapping"),
}


@pytest.mark.parametrize("case", CASES)
def test_bad_input_names_place_line_and_remedy(case: str) -> None:
    text, where, line, words = CASES[case]
    found = [p for p in problems(text) if p.where == where]
    assert found, [str(p) for p in problems(text)]
    assert any(p.line == line and words in str(p) for p in found), [str(p) for p in found]
    assert all(p.remedy or p.limit for p in found if case != "tag")


ONE_PROBLEM = [
    c for c in CASES if c not in ("unknown section", "tag", "alias to itself", "a list", "NaN as text")
]


@pytest.mark.parametrize("case", ONE_PROBLEM)
def test_nothing_else_is_reported(case: str) -> None:
    """A fault is told once; what merely follows from it is not."""
    text, where, *_ = CASES[case]
    others = [str(p) for p in problems(text) if p.where != where]
    assert not others


def test_all_problems_at_once_in_the_order_of_the_file() -> None:
    text = TORSIONAL_PAIR
    text = text.replace("g1: {number_of_teeth: 50", "g1: {colour: red, number_of_teeth: 50")
    text = text.replace("center_distance: 150 mm", "center_distance: 150 kg")
    text = text.replace("{ratio: 0.05}", "{ratio: .nan}")
    text = text.replace("{body: driven, torque", "{body: drivne, torque")
    text = text.replace("duration: 0.5 s", "duration: 0.5 s, method: euler")
    found = problems(text)
    assert [p.where for p in found] == [
        "gears.g1.colour",
        "meshes.stage.center_distance",
        "meshes.stage.damper.ratio",
        "loads.output.body",
        "scenarios.steady.method",
    ]
    lines = text.splitlines()
    words = ["colour", "150 kg", ".nan", "drivne", "euler"]
    assert all(w in lines[p.line - 1] for w, p in zip(words, found, strict=True) if p.line is not None)


def test_deep_nesting_and_alias_bombs_are_refused() -> None:
    (deep,) = problems("gears: " + "[" * 400 + "]" * 400)
    assert "nested" in deep.text
    bomb = "a0: &a0 [1, 1]\n" + "".join(
        f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 9)}]\n" for i in range(1, 12)
    )
    assert any("values" in p.text for p in problems(bomb))
