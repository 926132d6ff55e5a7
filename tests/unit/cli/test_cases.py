# SPDX-License-Identifier: Apache-2.0
"""`run --vary` and `sweep --vary`: one table of all combinations, kept whatever happens."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import click
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.cli.vary import values_of
from pitchpoint.io.case_store import read_cases
from pitchpoint.io.reading import open_result, read_header
from pitchpoint.io.sweep_store import read_sweep
from tests.support.cli_files import TORSION, json_of, written

SHORT = TORSION.replace("duration: 0.5 s", "duration: 0.01 s")
SMALL = TORSION.replace("points: 81", "points: 3").replace(
    "settle_periods: 200, measure_periods: 50", "settle_periods: 2, measure_periods: 2"
)
VARY = ["--vary", "loads.input.torque=100 N m,150 N m", "--vary", "meshes.stage.damper.ratio=0.05,0.1"]


def test_table_and_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "cases.h5"
    file = written(tmp_path, SHORT)
    found = json_of(["run", file, "-s", "steady", *VARY, "-j", "2", "-o", str(target)], capsys)
    assert found["status"] == "finished"
    assert [c["values"]["loads.input.torque"] for c in found["cases"]] == ["100 N m"] * 2 + ["150 N m"] * 2
    assert [c["numbers"]["meshes.stage.damper.ratio"] for c in found["cases"]] == [0.05, 0.1] * 2
    kept = read_cases(target)
    assert [c["case"] for c in kept] == [0, 1, 2, 3]
    for one, two in zip(kept, found["cases"], strict=True):
        assert one["channels"]["mesh_force[stage]"] == two["channels"]["mesh_force[stage]"]
        assert one["numbers"] == two["numbers"]
    assert read_header(target)["kind"] == "cases"
    with open_result(target) as data:
        assert data["deflection[stage]"].dims == ("case", "statistic")
        assert data["deflection[stage]"].attrs["symbol"] == "u_bt − e"


def test_sweeps(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "cases.h5"
    file = written(tmp_path, SMALL)
    found = json_of(
        ["sweep", file, "--vary", "meshes.stage.damper.ratio=0.05,0.1", "-o", str(target)], capsys
    )
    kept = read_cases(target)
    for one, two in zip(kept, found["cases"], strict=True):
        assert [p["deflection"] for p in one["points"]] == [p["deflection"] for p in two["points"]]
        assert [p["direction"] for p in one["points"]] == ["up"] * 3 + ["down"] * 3
    assert run_command(["report", file, str(target), "-o", str(tmp_path / "page.html")]) == 0
    assert "meshes.stage.damper.ratio = 0.1" in (tmp_path / "page.html").read_text(encoding="utf-8")


def test_people_get_a_table_and_failed_cases_a_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    file = written(tmp_path, SHORT)
    assert run_command(["run", file, "-s", "steady", "--vary", "meshes.stage.damper.ratio=0.05,1e9"]) == 3
    captured = capsys.readouterr()
    assert "rms of deflection" in captured.out
    assert "out of range" in captured.out
    assert "1 of 2 cases finished" in captured.err
    kept = read_cases(tmp_path / "model-steady-cases.h5")
    assert [c["status"] for c in kept] == [1, 2]
    assert kept[0]["sentence"] == "finished"
    assert kept[1]["sentence"].startswith("meshes.stage.damper.ratio: 1000000000.0 is out of range")
    assert run_command(["report", file, "model-steady-cases.h5"]) == 0
    page = (tmp_path / "model.html").read_text(encoding="utf-8")
    assert "<td>meshes.stage.damper.ratio: 1000000000.0 is out of range" in page


@pytest.mark.parametrize(
    ("vary", "expected"),
    [
        (["loads"], "PATH=V1,V2"),
        (["loads.input.torque=1,,2"], "PATH=V1,V2"),
        (["loads.inptu.torque=3 N m", "meshes.stage.damper.ratio=3 kg"], "loads.inptu: does not exist"),
        (["loads.inptu.torque=3 N m", "meshes.stage.damper.ratio=3 kg"], "'3 kg'"),
        (["gears.g1.z=20"], "unknown key"),
        (["title=a", "title=b"], "varied twice"),
        (["loads.input.torque={a: [}"], "--vary"),
    ],
)
def test_bad_input(
    vary: list[str], expected: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = [word for text in vary for word in ("--vary", text)]
    assert run_command(["run", written(tmp_path, SHORT), "-s", "steady", *options, "--json"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert expected in captured.err
    assert "Traceback" not in captured.err


def test_commas_in_brackets_belong_to_the_value() -> None:
    assert values_of("a.b=[1, 2],[3]") == ("a.b", [[1, 2], [3]])
    assert values_of("a=min(t, 1), 2 mm,true") == ("a", ["min(t, 1)", "2 mm", True])


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (
            "parameters.n=1000..2000rpm",
            "'1000..2000rpm' is a range, .* 'parameters.n=1000 rpm,1500 rpm,2000",
        ),
        ("a.b=0.5 mm..2 mm", "list the values, such as 'a.b=0.5 mm,1.25 mm,2 mm'"),
        ("a.b=1000:2000:5", "list the values, such as 'a.b=1000,1500,2000'"),
        ("a.b=1 mm,2..4 mm", "'2..4 mm' is a range"),
    ],
)
def test_a_range_is_refused_with_the_values_to_list(text: str, wanted: str) -> None:
    with pytest.raises(click.BadParameter, match=wanted):
        values_of(text)


def test_paths_of_files_are_no_ranges() -> None:
    assert values_of("a.file=../2..3/x.csv,C:/a.csv")[1] == ["../2..3/x.csv", "C:/a.csv"]


def start(arguments: list[str], target: Path, ready: int) -> subprocess.Popen[str]:
    """Start a command in a process of its own and wait until its table holds this many entries."""
    code = "from pitchpoint.cli.main import main; main()"
    child = subprocess.Popen(
        [sys.executable, "-c", code, *arguments, "-o", str(target), "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    deadline = time.monotonic() + 120.0
    while time.monotonic() < deadline and child.poll() is None:
        if target.exists() and entries(target) >= ready:
            return child
        time.sleep(0.05)
    child.kill()
    raise AssertionError(child.communicate())


def entries(target: Path) -> int:
    kind = read_header(target)["kind"]
    return len(read_cases(target)) if kind == "cases" else len(read_sweep(target)["points"])


@pytest.mark.parametrize("command", ["cases", "sweep"])
def test_stopped_by_ctrl_c_it_keeps_what_was_computed(command: str, tmp_path: Path) -> None:
    """Kills are in `test_kills`."""
    target = tmp_path / "out.h5"
    if command == "sweep":
        arguments = ["sweep", written(tmp_path, TORSION.replace("points: 81", "points: 8001"))]
    else:
        many = ",".join(f"{0.02 + 1e-5 * k:.5f}" for k in range(2000))
        arguments = ["run", written(tmp_path, TORSION), "-s", "steady"]
        arguments += ["--vary", f"meshes.stage.damper.ratio={many}", "-j", "2"]
    child = start(arguments, target, 3)
    begun = time.monotonic()
    child.send_signal(signal.SIGINT)
    out, err = child.communicate(timeout=60)
    assert entries(target) >= 3
    assert time.monotonic() - begun < 5.0  # one second on an idle machine
    assert child.returncode == 130
    assert json.loads(out)["status"] == "interrupted"
    assert "interrupted" in err
    assert "failed" not in err
    assert "Traceback" not in err
    assert read_header(target)["status"] == "interrupted"


def test_a_case_that_fails_before_its_window_has_no_numbers(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path, SHORT)
    vary = ["--vary", "loads.input.torque=150 N m,150*sqrt(0.001 - t)"]
    command = ["run", file, "-s", "steady", *vary, "-o", str(tmp_path / "cases.h5")]
    assert run_command(command) == 3
    printed = capsys.readouterr().out
    failed = next(line for line in printed.splitlines() if "failed (4)" in line)
    assert failed.split()[-2:] == ["–", "–"]
    assert any(line.split()[-7:-1] == ["0", "%", "0", "1/s", "0", "mm/s"] for line in printed.splitlines())
    assert run_command([*command, "--json"]) == 3
    cases = json.loads(capsys.readouterr().out)["cases"]
    assert cases[1]["channels"]["mesh_force[stage]"] == {
        "unit": "N", "mean": None, "rms": None, "min": None, "max": None
    }  # fmt: skip
    assert cases[0]["channels"]["mesh_force[stage]"]["mean"] > 0.0


def test_a_model_without_meshes_has_a_table_too(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = (
        "gears: {g: {number_of_teeth: 20, normal_module: 1 mm, face_width: 5 mm, "
        "profile_shift_coefficient: 0}}\n"
        "bodies: {disc: {motion: torsion, inertia: 1}}\nloads: {push: {body: disc, torque: 1 N m}}\n"
        "scenarios: {go: {duration: 1 ms, step: 1 us}}\n"
    )
    command = ["run", written(tmp_path, text), "--vary", "loads.push.torque=1 N m,2 N m"]
    assert run_command([*command, "-o", str(tmp_path / "cases.h5")]) == 0, capsys.readouterr().err
    assert "2 N m" in capsys.readouterr().out


def test_notes_name_their_case(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One torque of two is in the wrong unit."""
    target = tmp_path / "cases.h5"
    command = ["run", written(tmp_path, SHORT), "-s", "steady", "-o", str(target)]
    assert run_command([*command, "--vary", "loads.input.torque=150 N m,150 kN m", "-q"]) == 0
    assert "note:" not in capsys.readouterr().out
    assert run_command([*command, "--vary", "loads.input.torque=150 N m,150 kN m"]) == 0
    deep = "case 1: meshes.stage: the flank penetration reaches "
    assert capsys.readouterr().out.count(f"note: {deep}") == 1
    assert deep in read_header(target)["notes"]


def test_interrupted_cases_did_not_fail(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ctrl-C in the second of three cases: told, shown and kept as what it is; the first case stays."""
    from pitchpoint.cli import progress
    from pitchpoint.solvers import time as solver

    begun = solver.run_time
    calls: list[int] = []

    def second_is_stopped(*args: Any, **options: Any) -> Any:
        calls.append(1)
        if len(calls) == 2:
            raise KeyboardInterrupt
        return begun(*args, **options)

    monkeypatch.setattr(solver, "run_time", second_is_stopped)
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    monkeypatch.setattr(progress, "LINE_EVERY", 0.0)
    target = tmp_path / "cases.h5"
    vary = ["--vary", "loads.input.torque=100 N m,150 N m,200 N m", "-j", "1"]
    command = ["run", written(tmp_path, SHORT), "-s", "steady", *vary, "-o", str(target)]
    assert run_command(command) == 130
    captured = capsys.readouterr()
    assert "case 1: interrupted" in captured.err
    assert "interrupted (status 9): 2 of 3 cases finished; interrupted by the user" in captured.err
    assert "interrupted (9)" in captured.out
    assert "failed" not in captured.out + captured.err
    assert [c["status"] for c in read_cases(target)] == [1, 9, 1]
    head = read_header(target)
    assert (head["status"], head["status_code"]) == ("interrupted", 9)
    with open_result(target) as data:
        assert data.sizes["case"] == 3


def test_contact_on_the_back_flank_is_contact(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Torques of the other sign press the other flanks: forces are negative, no contact is lost."""
    text = SHORT.replace("torque: 150 N m", "torque: -150 N m")
    command = ["run", written(tmp_path, text), "-s", "steady", "--vary", "meshes.stage.damper.ratio=0.05,0.1"]
    assert run_command([*command, "-o", str(tmp_path / "cases.h5")]) == 0
    rows = [line.split() for line in capsys.readouterr().out.splitlines() if line.split()[:1] == ["0.1"]]
    assert rows[0][-7:-3] == ["0", "%", "0", "1/s"]  # the rattle index comes last
    assert float(rows[0][-9]) < -2128.0  # 150 N m at 70.477 mm


def test_flanks_that_change_without_a_gap_do_not_lose_contact(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Without backlash the contact state jumps between 1 and -1; a gap has states 0 between."""
    text = SHORT.replace("150 N m}", "150 N m * cos(2000 rad/s * t)}").replace(
        "0.01 s", "5 ms, settle_time: 0 s"
    )
    file = written(tmp_path, text.replace("transmission_error:", "# transmission_error:"))
    vary = ["--vary", "meshes.stage.backlash.normal=0 mm,0.1 mm"]
    arguments = ["run", file, "-s", "steady", *vary, "-o"]
    found = json_of([*arguments, str(tmp_path / "one.h5")], capsys)
    states = [case["channels"]["contact_state[stage]"] for case in found["cases"]]
    assert [(s["min"], s["max"], s["share_zero"] > 0.0) for s in states] == [(-1, 1, False), (-1, 1, True)]
    assert run_command([*arguments, str(tmp_path / "two.h5")]) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    losses = [float(line[-7]) for line in lines if line[-2:-1] == ["mm/s"] and line[-6] == "%"]
    assert losses == [0.0, pytest.approx(100.0 * states[1]["contact_loss_share"], rel=1e-2)]
    assert states[0]["front_impacts"] == states[0]["back_impacts"] == 0
    assert states[1]["front_impacts"] + states[1]["back_impacts"] > 0
