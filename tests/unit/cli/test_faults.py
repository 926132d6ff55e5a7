# SPDX-License-Identifier: Apache-2.0
"""Bad input and faults as a user meets them: exit codes, sentences, no traceback, results that are kept."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core import status as st
from pitchpoint.core.errors import join_notes, split_notes
from pitchpoint.io.reading import read_channel, read_header
from tests.support.cli_files import ISO_EX1, TORSION, written
from tests.support.model_files import gear, pair

# row: (file, what is replaced, by what, words of the message)
ISO, PAIR, SMALL = "iso", "pair", "small"
RACK = "rack: {dedendum: 1.0, root_radius: 0.1}"
FILES = {
    ISO: ISO_EX1,
    PAIR: TORSION,
    SMALL: pair(gear("a", 8, more=RACK), gear("b", 120), "center_distance: 192 mm"),
}
BAD_INPUT = {
    "wrong unit": (ISO, "500 mm", "500 kg", "line 8): '500 kg'"),
    "unknown key": (ISO, "face_width: 100 mm, tip", "face_widht: 100 mm, tip", "did you mean face_width?"),
    "missing gear": (ISO, "gears: [pinion, wheel]", "gears: [pinion, weel]", "'weel'"),
    "no contact": (ISO, "500 mm", "525 mm", "keeps the tips apart"),
    "interference": (SMALL, "", "", "shorten the tip"),
    "negative tip clearance": (ISO, "dedendum: 1.4", "dedendum: 0.8", "tip clearance of"),
    "pointed tooth": (
        PAIR,
        "g1: {number_of_teeth: 50",
        "g3: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 1.4}\n"
        "  g1: {number_of_teeth: 50",
        "use at most",
    ),
    "equal hands": (ISO, "hand: right", "hand: left", "change the hand"),
    "internal smaller than pinion": (
        ISO,
        "wheel:  {number_of_teeth: 103",
        "wheel:  {type: internal, number_of_teeth: 15",
        "wheel",
    ),
    "two internals": (
        PAIR,
        ": {number_of_teeth: 50",
        ": {type: internal, number_of_teeth: 50",
        "both internal",
    ),
    "zero inertia": (PAIR, "inertia: 0.0115 kg m^2", "inertia: 0", "inertia"),
    "negative inertia": (PAIR, "inertia: 0.0115 kg m^2", "inertia: -1 kg m^2", ">= 0"),
    "zero mass": (PAIR, "motion: torsion, inertia", "motion: planar, mass: 0 kg, inertia", "planar"),
    "not a number": (PAIR, "torque: 150 N m", "torque: .nan", "not a finite number"),
    "infinite": (PAIR, "mean: 4.0e8 N/m", "mean: .inf", "finite"),
    "duplicate names": (PAIR, "  g2:", "  g1:", "line 3 and line 4"),
    "YAML syntax": (PAIR, "bodies:", "bodies: {", "YAML syntax"),
    "Python code": (PAIR, "torque: 150 N m", "torque: {python: 'law.py:f'}", "--allow-code"),
    "formula that is Python": (PAIR, "torque: 150 N m", "torque: t.__class__", "a formula may use"),
    "wrong unit in a formula": (PAIR, "torque: 150 N m", "torque: 150 kg * sin(2*pi*25 Hz*t)", "kg, not N m"),
}


@pytest.mark.parametrize("row", BAD_INPUT)
@pytest.mark.parametrize("command", [["check"], ["gears"], ["run", "-s", "steady"]])
def test_bad_input_exits_2(
    row: str, command: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    which, old, new, words = BAD_INPUT[row]
    text = FILES[which]
    assert old in text
    file = written(tmp_path, text.replace(old, new))
    assert run_command([*command, file, "--json"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "Traceback" not in captured.err
    assert words in captured.err
    assert "(line " in captured.err
    assert file in captured.err


def test_every_problem_at_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = TORSION
    for old, new in (
        ("g1: {number_of_teeth: 50", "g1: {colour: red, number_of_teeth: 50"),
        ("center_distance: 150 mm", "center_distance: 150 kg"),
        ("damper: {ratio: 0.05}", "damper: {ratio: -1}"),
        ("{body: driven, torque", "{body: drivne, torque"),
    ):
        text = text.replace(old, new)
    assert run_command(["run", written(tmp_path, text), "-s", "steady"]) == 2
    err = capsys.readouterr().err
    assert "4 problems" in err
    for words in (
        "gears.g1.colour (line 3): is an unknown key",
        "meshes.stage.center_distance (line 11): '150 kg'",
        "such as 3 mm",
        "meshes.stage.damper.ratio (line 14): -1 is out of range (limit >= 0",
        "loads.output.body (line 18)",
        "did you mean driver",
    ):
        assert words in err, words


INPUT = "input:  {body: driver, torque: 150 N m}"
FAULTS = {
    "Newton": (st.DIVERGED, "150 N m * exp(1e4 * angle^2)", "", "Newton"),
    "torque without bound": (
        st.UNBOUNDED,
        "150 N m + 1e3 N m * (0.01 / (0.01000001 - t))^3",
        ", method: runge_kutta",
        "grew without bound",
    ),
    "NaN of a formula": (st.NOT_FINITE, "150 N m * sqrt(0.01 - t)", "", "not a number"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_failed_computations_exit_3_and_keep_what_was_computed(
    fault: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, torque, method, words = FAULTS[fault]
    text = TORSION.replace(INPUT, f'input: {{body: driver, torque: "{torque}"}}')
    text = text.replace("duration: 0.5 s", f"duration: 0.02 s, settle_time: 0 s{method}")
    target = tmp_path / "out.h5"
    assert run_command(["run", written(tmp_path, text), "-s", "steady", "-o", str(target), "--json"]) == 3
    captured = capsys.readouterr()
    found = json.loads(captured.out)
    assert found["status"] == "failed"
    assert 0.0 < found["t_end"] < 0.02
    assert words in found["sentence"]
    assert f"(status {code})" in captured.err
    assert str(target) in captured.err
    assert "Traceback" not in captured.err
    head = read_header(target)
    assert (head["status"], head["status_code"]) == ("failed", code)
    assert words in head["sentence"]
    t, _ = read_channel(target, "mesh_force[stage]")
    assert t.size > 10
    assert t[-1] == pytest.approx(found["t_end"], abs=2e-5)


def test_a_failure_before_the_window_has_no_statistics(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = TORSION.replace(INPUT, 'input: {body: driver, torque: "150 N m * sqrt(0.001 - t)"}')
    file, target = written(tmp_path, text), tmp_path / "out.h5"
    assert run_command(["run", file, "-s", "steady", "-o", str(target), "--json"]) == 3
    row = json.loads(capsys.readouterr().out)["channels"]["mesh_force[stage]"]
    assert row == {"unit": "N", "mean": None, "rms": None, "min": None, "max": None}
    assert run_command(["run", file, "-s", "steady", "-o", str(target)]) == 3
    assert "no statistics: the run ended at 1 ms, before their window" in capsys.readouterr().out


def test_a_sweep_that_fails_keeps_its_points(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "law.py").write_text("def torque(t, x, p):\n    return 150.0 if t < 0.3 else float('nan')\n")
    text = TORSION.replace(INPUT, "input: {body: driver, torque: {python: 'law.py:torque'}}")
    text = text.replace("settle_periods: 200", "settle_periods: 20")
    file, target = written(tmp_path, text), tmp_path / "out.h5"
    assert run_command(["sweep", file, "-o", str(target), "--json", "--allow-code"]) == 3
    captured = capsys.readouterr()
    found = json.loads(captured.out)
    assert found["status"] == "failed"
    assert 1 < len(found["points"]) < 162
    assert f"(status {st.NOT_FINITE})" in captured.err
    assert read_header(target)["status"] == "failed"


def test_a_load_that_grows_without_bound_ends_as_a_failure(tmp_path: Path) -> None:
    table = "torque: {table: [[0 s, 0 N m], [1 s, 1e59 N m]]}"
    file = written(tmp_path, TORSION.replace("torque: 150 N m}", table + "}", 1))
    assert run_command(["run", file, "-s", "steady", "-o", str(tmp_path / "out.h5"), "-q"]) == 3


def line_of(file: str, words: str) -> int:
    """Line of a file that holds these words, from 1."""
    return next(n for n, row in enumerate(Path(file).read_text().splitlines(), 1) if words in row)


@pytest.mark.parametrize("function", ["missing", "two"])
def test_a_python_law_that_cannot_be_used_is_told_at_its_place(
    function: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "law.py").write_text("def two(t, x):\n    return 1.0\n", encoding="utf-8")
    law = f"torque: {{python: 'law.py:{function}'}}}}"
    file = written(tmp_path, TORSION.replace("torque: 150 N m}", law, 1))
    out = str(tmp_path / "out.h5")
    assert run_command(["run", file, "-s", "steady", "-o", out, "--allow-code"]) == 2
    said = capsys.readouterr().err
    assert f"loads.input.torque (line {line_of(file, law)}): names " in said
    assert {"missing": "which 'law.py' does not define", "two": "which takes 2 arguments"}[function] in said


def test_the_element_that_failed_has_name_and_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    law = "torque: 150 N m * sqrt(1e-3 - t)}"
    file = written(tmp_path, TORSION.replace("torque: 150 N m}", law, 1))
    assert run_command(["run", file, "-s", "steady", "-o", str(tmp_path / "out.h5")]) == 3
    assert f": loads.input (line {line_of(file, law)}): a force" in capsys.readouterr().err


@pytest.mark.parametrize(("command", "scenario"), [("run", "steady"), ("run", "roll"), ("sweep", "sweep")])
def test_flanks_deep_in_each_other_are_noted(
    command: str, scenario: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = TORSION.replace("4.0e8 N/m", "4.0e6 N/m").replace("duration: 0.5 s", "duration: 5 ms")
    text = text.replace("points: 81", "points: 2").replace("settle_periods: 200", "settle_periods: 2")
    text += "  roll: {quasi_static: {points: 5}}\n"
    target = tmp_path / "out.h5"
    file = written(tmp_path, text)
    assert run_command([command, file, "-s", scenario, "-o", str(target), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["status"] == "finished"
    told = [note for note in found["notes"] if "0.1 m_n = 0.3 mm" in note]
    assert len(told) == 1
    assert told[0].startswith("meshes.stage: the flank penetration reaches ")
    assert join_notes(told) in split_notes(read_header(target)["notes"])


FOURIER = "{law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1, -0.05]}"
EMPTY = {
    "run": (["run", "-s", "steady"], {"steps": 0, "events": 0, "channels": {}}),
    "roll": (["run", "-s", "roll"], {"steps": 0, "periods_rolled": [], "meshes": {}, "channels": {}}),
    "sweep": (["sweep"], {"steps": 0, "points": [], "jumps": []}),
    "modes": (["modes"], {"modes": []}),
    "cases": (["run", "-s", "steady", "--vary", "meshes.stage.damper.ratio=0.05,0.1"], {"cases": []}),
}


@pytest.mark.parametrize("name", EMPTY)
def test_json_comes_also_when_nothing_could_begin(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its keys are those of a computation that succeeds, its tables are empty."""
    (tmp_path / "law.py").write_text("def k(t, x, p):\n    return float('nan')\n", encoding="utf-8")
    (command, *options), empty = EMPTY[name]
    text = TORSION.replace("duration: 0.5 s", "duration: 1 ms").replace("points: 81", "points: 2")
    text = text.replace("settle_periods: 200", "settle_periods: 2") + "  roll: {quasi_static: {points: 2}}\n"
    file = written(tmp_path, text.replace(FOURIER, "{law: user, python: 'law.py:k'}"))
    options = [*options, "-o", str(tmp_path / "out.h5")]
    assert run_command([command, file, *options, "--allow-code", "--json"]) == 3
    captured = capsys.readouterr()
    found = json.loads(captured.out)
    assert found["status"] == "failed"
    assert found["output"] is None
    assert found["wall_s"] > 0.0
    assert {key: found[key] for key in empty} == empty
    assert f"computation failed (status {st.NOT_FINITE}): law.py:k returned nan" in captured.err
    assert run_command([command, file, *options, "--allow-code"]) == 3
    assert capsys.readouterr().out == ""
    assert run_command([command, written(tmp_path, text, "good.yaml"), *options, "--json"]) == 0
    assert set(found) == set(json.loads(capsys.readouterr().out))


def test_json_of_a_run_without_an_equilibrium(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The file is there by then and says the same."""
    torque = "150 N m * sqrt(0 - 1 - t)"
    file = written(tmp_path, TORSION.replace(INPUT, f'input: {{body: driver, torque: "{torque}"}}'))
    target = tmp_path / "out.h5"
    assert run_command(["run", file, "-s", "steady", "-o", str(target), "--json"]) == 3
    found = json.loads(capsys.readouterr().out)
    assert (found["status"], found["steps"], found["channels"]) == ("failed", 0, {})
    head = read_header(target)
    assert (head["status"], head["sentence"]) == ("failed", found["sentence"])


def test_ctrl_c_before_the_first_step_has_json_too(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def stopped(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("pitchpoint.solvers.time.prepare_start", stopped)
    target = str(tmp_path / "out.h5")
    assert run_command(["run", written(tmp_path, TORSION), "-s", "steady", "-o", target, "--json"]) == 130
    assert json.loads(capsys.readouterr().out)["status"] == "interrupted"


def test_a_stiffness_below_zero_is_told_with_law_and_phase(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "law.py").write_text("def k(t, x, p):\n    return 3e8 - 5e8 * (x >= 0.5)\n", encoding="utf-8")
    file = written(tmp_path, TORSION.replace(FOURIER, "{law: user, python: 'law.py:k'}"))
    out = str(tmp_path / "out.h5")
    assert run_command(["run", file, "--scenario", "steady", "-o", out, "--allow-code"]) == 3
    assert "law.py:k gives -2e+08 N/m (mesh phase 0.5000; limit > 0)" in capsys.readouterr().err


def test_what_is_no_model_at_all_is_said_plainly(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "result.h5"
    file.write_bytes(b"\x89HDF\r\n\x1a\n\0\0\0\xff")
    assert run_command(["check", str(file)]) == 2
    assert "name the model file; this is an HDF5 file, such as a result" in capsys.readouterr().err
    text = TORSION[: TORSION.index("scenarios:")]
    assert run_command(["sweep", written(tmp_path, text)]) == 2
    assert "the model has no scenario of the kind sweep; add one" in capsys.readouterr().err
