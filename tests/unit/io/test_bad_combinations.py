# SPDX-License-Identifier: Apache-2.0
"""Keys that are fine one by one and wrong together: meshes, motions, speeds and drives, steps, matrices."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from tests.support.model_files import TORSIONAL_PAIR, gear

STEADY = "steady: {speed: {driver: 1500 rpm}, duration: 0.5 s, sample_rate: 100 kHz}"
FIXED = ("driven: {gears: [g2], motion: torsion", "driven: {gears: [g2], motion: fixed")
NO_LOAD = ("  output: {body: driven, torque: 150 N m}", "  #")
BEARING = "bearings:\n  b: {body: driver, stiffness: {matrix: [%s]}}\nloads:"


def steady(keys: str) -> tuple[str, str]:
    """Replace the keys of the scenario `steady`."""
    return STEADY, f"steady: {{{keys}}}"


def matrix(rows: dict[tuple[int, int], float]) -> str:
    """A bearing with a matrix of ones on the diagonal and some other entries."""
    entries = [[rows.get((i, j), float(i == j)) for j in range(6)] for i in range(6)]
    return BEARING % ", ".join(str(row) for row in entries)


# (changes of the contract file, place, words that the sentence must hold)
CASES: dict[str, tuple[list[tuple[str, str]], str, str]] = {
    "two meshes of one pair": (
        [("loads:", "  again: {gears: [g2, g1], center_distance: 150 mm}\nloads:")],
        "meshes.again.gears",
        "are already the gears of stage",
    ),
    "held twice": (
        [steady("hold: [driver, driver], duration: 1 s")],
        "scenarios.steady.hold",
        "names driver twice",
    ),
    "held and fixed": (
        [FIXED, NO_LOAD, steady("hold: [driven], duration: 1 s")],
        "scenarios.steady.hold",
        "fixed and cannot rotate",
    ),
    "driven and fixed": (
        [FIXED, NO_LOAD, steady("drive: {driven: {speed: 3 rpm}}, duration: 1 s")],
        "scenarios.steady.drive.driven",
        "fixed and cannot rotate",
    ),
    "a form of other methods": (
        [steady("duration: 1 s, form: SI1")],
        "scenarios.steady.form",
        "is not available with generalized_alpha",
    ),
    "an angle by Python": (
        [steady("drive: {driver: {angle: {python: 'a.py:f'}}}, duration: 1 s")],
        "scenarios.steady.drive.driver.angle",
        "give speed: {python: ...}",
    ),
    "driven and swept": (
        [("sweep: {body: driver", "drive: {driver: {speed: 10 rpm}}, sweep: {body: driver")],
        "scenarios.sweep.drive",
        "write hold: [driver]",
    ),
    "coupled against the ratio": (
        [
            (
                "loads:",
                "couplings:\n  c: {bodies: [driver, driven], stiffness: {torsion: 100 N m/rad}}\nloads:",
            )
        ],
        "scenarios.steady.speed.driver",
        "couplings.c locks driver and driven",
    ),
    "step beyond counting": (
        [steady("duration: 1 s, step: 1e-20")],
        "scenarios.steady.step",
        "gives 1e+20 steps",
    ),
    "samples beyond counting": (
        [steady("duration: 1 s, sample_rate: 1e13 Hz")],
        "scenarios.steady.sample_rate",
        "gives 1e+13 steps",
    ),
    "step as long as the window": (
        [steady("duration: 1 s, step: 0.5 s")],
        "scenarios.steady.step",
        "longer than half the evaluated time",
    ),
    "negative spring": (
        [("loads:", matrix({(1, 1): -1.0}))],
        "bearings.b.stiffness.matrix",
        "is not positive semidefinite",
    ),
    "indefinite matrix": (
        [("loads:", matrix({(0, 4): 2.0, (4, 0): 2.0}))],
        "bearings.b.stiffness.matrix",
        "is not positive semidefinite",
    ),
    "unknown function": (
        [("torque: 150 N m}", "torque: 150 N m * sinus(time)}")],
        "loads.input.torque",
        "unknown name 'sinus'",
    ),
    "quoted teeth": (
        [("g1: {number_of_teeth: 50", "g1: {number_of_teeth: '50'")],
        "gears.g1.number_of_teeth",
        "write 50 without quotes",
    ),
    "torque as a list": (
        [("input:  {body: driver, torque: 150 N m}", "input:  {body: driver, torque: [1]}")],
        "loads.input.torque",
        "write 150 N m",
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_a_wrong_combination_is_told_once_with_its_line(
    case: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a.py").write_text("def f(t, x, p):\n    return t\n")
    changes, where, words = CASES[case]
    text = TORSIONAL_PAIR
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    with pytest.raises(ModelError) as caught:
        loads_model(text, allow_code=True)
    found = caught.value.problems
    assert {p.where for p in found} <= {where, where.replace("input", "output")} | (
        {"scenarios.sweep.sweep.body"} if "coupled" in case or "fixed" in case else set()
    ), [str(p) for p in found]
    assert words in str(found[0])
    assert found[0].remedy
    assert found[0].line is not None


def test_three_gears_in_a_loop_lock_each_other() -> None:
    # 51 teeth: with 60 degrees at every corner all pairs find their gaps, yet neighbours must counter-turn
    text = "gears:\n" + "".join(gear(name, 51) for name in "abc")
    text += "bodies:\n" + "".join(f"  {name}: {{gears: [{name.lower()}]}}\n" for name in "ABC")
    text += "meshes:\n"
    for k, (one, two) in enumerate(("ab", "bc", "ca")):
        text += (
            f"  {one}{two}: {{gears: [{one}, {two}], center_distance: 153 mm, direction: {120 * k} deg}}\n"
        )
    still = text + "scenarios:\n  s: {duration: 1 s}\n"
    assert loads_model(still).meshes["ca"].theta == pytest.approx(4.18879, abs=1e-5)
    with pytest.raises(ModelError, match=r"cannot rotate A: meshes\.ca locks C and A: A/C = -1, but 1"):
        loads_model(text + "scenarios:\n  s: {speed: {A: 10 rpm}, duration: 1 s}\n")


def test_a_coupling_without_torsion_leaves_both_speeds_alone() -> None:
    coupling = "couplings:\n  c: {bodies: [driver, driven], stiffness: {radial: 1e8 N/m}}\nloads:"
    model = loads_model(TORSIONAL_PAIR.replace("loads:", coupling))
    assert model.start_speeds("steady")["driven"] == pytest.approx(-model.start_speeds("steady")["driver"])


def test_a_singular_matrix_written_with_few_digits_is_accepted() -> None:
    # a beam that is free to turn about one point: k [1, -l; -l, l^2] with l = 0.3333, in four digits
    rows = {(0, 0): 1e8, (0, 4): -3.333e7, (4, 0): -3.333e7, (4, 4): 1.111e7}
    model = loads_model(TORSIONAL_PAIR.replace("loads:", matrix(rows)))
    assert model.bearings["b"].stiffness.matrix6()[0][4] == -3.333e7


@pytest.mark.parametrize("character", ["\x00", "\x07"])
def test_control_characters_are_named_with_their_line(character: str) -> None:
    with pytest.raises(ModelError, match=rf"\(line 2\): holds the character #x{ord(character):04x}"):
        loads_model(f"title: a\ngears: {character}\n")
