# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint run`: the contract of its JSON, the file it leaves, failure, interruption, kill."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import join_notes
from pitchpoint.io.container import Header
from pitchpoint.io.reading import open_result, read_channel, read_header
from pitchpoint.io.writing import Channel, ResultWriter
from tests.support.cli_files import ISO_EX1, TORSION, json_of, written
from tests.support.machines import pair

SHORT = TORSION.replace("duration: 0.5 s", "duration: 0.02 s")
LONG = TORSION.replace("duration: 0.5 s", "duration: 500 s")


def start(file: str, target: Path, *options: str) -> subprocess.Popen[str]:
    """Start a run in a process of its own and wait until its file holds samples."""
    code = "from pitchpoint.cli.main import main; main()"
    command = [sys.executable, "-c", code, "run", file, "--scenario", "steady", "-o", str(target), "--json"]
    command += options
    child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 120.0
    while time.monotonic() < deadline and child.poll() is None:
        if target.exists() and len(read_channel(target, "mesh_force[stage]")[0]) > 1000:
            return child
        time.sleep(0.05)
    child.kill()
    raise AssertionError(child.communicate())


def test_contract(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "out.h5"
    file = written(tmp_path, SHORT)
    found = json_of(["run", file, "--scenario", "steady", "-o", str(target)], capsys)
    assert found["status"] == "finished"
    assert found["steps"] > 1000
    assert found["wall_s"] > 0.0
    assert found["window"] == pytest.approx([0.004, 0.02])
    for name, unit in (("transmission_error", "m"), ("deflection", "m"), ("mesh_force", "N")):
        row = found["channels"][f"{name}[stage]"]
        assert row["unit"] == unit
        assert row["min"] < row["mean"] < row["max"]
        assert 0.0 < row["rms"] < row["max"] - row["min"]
    # 150 N m on a base radius of 70.477 mm
    assert found["channels"]["mesh_force[stage]"]["mean"] == pytest.approx(150.0 / 0.0704769, rel=0.05)
    with open_result(target) as ds:
        assert ds.sizes["time"] == 2001
        np.testing.assert_allclose(ds["time"], 1e-5 * np.arange(2001), atol=1e-12)
        force = ds["mesh_force[stage]"].sel(time=slice(0.004, None))
        assert float(force.mean()) == pytest.approx(found["channels"]["mesh_force[stage]"]["mean"], rel=1e-3)
        assert ds.attrs["status"] == "finished"
        assert ds.attrs["solver"] == "generalized_alpha"
        assert ds.attrs["model_text"].startswith("title: torsional pair")
    assert read_header(target)["options"]["settle_time"] == pytest.approx(0.004)


def test_people_get_a_table_and_the_step_can_be_set(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    file = written(tmp_path, SHORT.replace("100 kHz", "10 kHz"))
    assert run_command(["run", file, "--step", "10 us", "--decimate", "2"]) == 0
    out = capsys.readouterr().out
    assert "mesh_force[stage]" in out
    assert "2000 steps of 10 µs" in out
    assert "model-steady.h5" in out
    assert read_channel(tmp_path / "model-steady.h5", "mesh_force[stage]")[0].size == 101


def test_the_file_keeps_the_statistics_of_all_steps(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Samples may keep step with the mesh and miss what lies between them; a killed run has none yet."""
    target = tmp_path / "out.h5"
    found = json_of(["run", written(tmp_path, SHORT), "-o", str(target), "--decimate", "7"], capsys)
    with open_result(target) as ds:
        for name, numbers in found["channels"].items():
            kept = ds[name].attrs["statistics"]
            assert list(kept) == [numbers[key] for key in ("mean", "rms", "min", "max")]
    with ResultWriter(tmp_path / "begun.h5", Header("time"), [Channel("mesh_force[stage]", "N")]) as writer:
        with open_result(tmp_path / "begun.h5") as ds:
            assert np.isnan(ds["mesh_force[stage]"].attrs["statistics"]).all()
        writer.append(np.arange(3.0), np.array([[1.0], [2.0], [3.0]]))
    with open_result(tmp_path / "begun.h5") as ds:
        assert list(ds["mesh_force[stage]"].attrs["statistics"]) == pytest.approx(
            [2.0, (2 / 3) ** 0.5, 1.0, 3.0]
        )


def test_events_are_in_the_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "out.h5"
    file = written(
        tmp_path, SHORT.replace("sample_rate: 100 kHz", "events: [pair_entry], sample_rate: 1 kHz")
    )
    found = json_of(["run", file, "-o", str(target)], capsys)
    # 25 Hz, 50 teeth, 0.02 s
    with open_result(target, "events") as ds:
        assert ds.sizes["time"] == found["events"]
        assert int((ds["direction"] == 1).sum()) == pytest.approx(25, abs=1)
    with open_result(target) as ds:
        assert ds.sizes["event"] == found["events"]
        assert set(ds["event_name"].values) == {"pair_entry[stage]"}
        assert ds.attrs["notes"] == join_notes(found["notes"])


@pytest.mark.parametrize(
    ("step", "rate", "note"),
    [
        (
            "5 ms",
            "sample_rate: 100 kHz",
            "the step is 10 µs instead of 5 ms: steps divide the sample period, 10 µs",
        ),
        ("5 us", "sample_rate: 100 kHz", ""),
        ("3 us", "settle_time: 0 s", "the step is 2.8 µs instead of 3 µs: steps divide the duration"),
    ],
)
def test_a_step_that_had_to_be_shortened_is_told(
    step: str, rate: str, note: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = SHORT.replace("sample_rate: 100 kHz", rate)
    if not note.endswith("10 µs"):
        text = text.replace("0.02 s", "0.0001 s" if "3" not in step else "0.000028 s")
    target = tmp_path / "out.h5"
    found = json_of(
        ["run", written(tmp_path, text), "-s", "steady", "--step", step, "-o", str(target)], capsys
    )
    assert found["notes"] == ([note] if note else [])
    assert read_header(target)["notes"] == note


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["--jobs", "2"], "--jobs has no effect without --vary"),
        (["--decimate", "2", "--vary", "loads.input.torque=1 N m"], "--decimate has no effect with --vary"),
        (["--scenario", "stedy"], "did you mean steady?"),
        (["--scenario", "sweep"], "of the kind sweep"),
        (["--step", "3 kg"], "'kg'"),
        (["--step", "-1 us"], "greater than zero"),
    ],
)
def test_bad_input(
    arguments: list[str], expected: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_command(["run", written(tmp_path, SHORT), *arguments]) == 2
    assert expected in capsys.readouterr().err


def test_a_model_without_scenarios(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["run", written(tmp_path, ISO_EX1)]) == 2
    assert "the model has no scenario of the kind time or quasi_static" in capsys.readouterr().err


def test_a_failed_run_says_so_and_keeps_its_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "law.py").write_text("def torque(t, x, p):\n    return 150.0 if t < 0.01 else float('nan')\n")
    text = SHORT.replace(
        "input:  {body: driver, torque: 150 N m}", "input:  {body: driver, torque: {python: 'law.py:torque'}}"
    )
    file, target = written(tmp_path, text), tmp_path / "out.h5"
    assert run_command(["run", file, "-s", "steady", "-o", str(target), "--json"]) == 2
    assert "--allow-code" in capsys.readouterr().err
    assert run_command(["run", file, "-s", "steady", "-o", str(target), "--json", "--allow-code"]) == 3
    captured = capsys.readouterr()
    found = json.loads(captured.out)
    assert found["status"] == "failed"
    assert found["t_end"] == pytest.approx(0.01, abs=1e-4)
    assert "Traceback" not in captured.err
    assert str(target) in captured.err
    assert read_header(target)["status"] == "failed"
    assert read_channel(target, "mesh_force[stage]")[0].size == pytest.approx(1000, abs=2)


def test_a_run_that_stops_before_its_window_has_no_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A sentence says so in place of a table of dashes; the window begins at 20 % of the duration."""
    (tmp_path / "law.py").write_text(
        "def torque(t, x, p):\n    return 150.0 if t < 0.003 else float('nan')\n"
    )
    text = SHORT.replace(
        "input:  {body: driver, torque: 150 N m}", "input:  {body: driver, torque: {python: 'law.py:torque'}}"
    )
    file, target = written(tmp_path, text), tmp_path / "out.h5"
    assert run_command(["run", file, "-s", "steady", "-o", str(target), "--allow-code"]) == 3
    shown = capsys.readouterr()
    assert "no statistics: the run ended at 2.998 ms, before their window, which begins at 4 ms" in shown.out
    assert "–" not in shown.out
    assert "alternating rms" not in shown.out
    assert "steps of" in shown.out
    assert "Traceback" not in shown.err


def test_ctrl_c_stops_within_a_second_and_keeps_the_result(tmp_path: Path) -> None:
    target = tmp_path / "out.h5"
    child = start(written(tmp_path, LONG), target)
    begun = time.monotonic()
    child.send_signal(signal.SIGINT)
    out, err = child.communicate(timeout=30)
    assert time.monotonic() - begun < 5.0  # one second on an idle machine
    assert child.returncode == 130
    assert json.loads(out)["status"] == "interrupted"
    assert "interrupted" in err
    assert "Traceback" not in err
    head = read_header(target)
    assert head["status"] == "interrupted"
    assert head["steps"] > 1000


@pytest.mark.parametrize(
    ("where", "fates"),
    [
        ("pitchpoint.system.compile.compile_model", ("was not written", "is unchanged")),
        ("pitchpoint.io.writing.ResultWriter._make_variables", ("was not written", "was removed")),
        ("pitchpoint.solvers.time.run_time", ("has no samples", "has no samples")),
    ],
)
def test_an_interrupt_before_the_first_sample_states_what_is_left(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    where: str,
    fates: tuple[str, str],
) -> None:
    """Without and with an older result, while the model is compiled, the file is made, the run begins."""
    file, target = written(tmp_path, SHORT), tmp_path / "out.h5"

    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    for older, fate in zip((False, True), fates, strict=True):
        target.unlink(missing_ok=True)
        if older:
            ResultWriter(target, Header("time"), [Channel("speed[a]", "rad/s")]).finish()
        with monkeypatch.context() as patch:
            patch.setattr(where, interrupted)
            assert run_command(["run", file, "-s", "steady", "-o", str(target), "--json"]) == 130
        out, err = capsys.readouterr()
        assert err.startswith("interrupted (status 9): before the first sample: nothing has been computed")
        assert fate in err and "out.h5" in err
        assert json.loads(out)["output"] is None
        assert target.exists() == (fate in ("is unchanged", "has no samples"))


@pytest.mark.parametrize(
    ("beta", "driven", "words"),
    [
        (
            "17 deg",
            "  b: {body: driven, stiffness: {radial: 1e8 N/m, tilt: 1e6 N m/rad}}\n",
            "holds driven along its axis: add",
        ),
        ("", "", "holds driven across its axis: add"),
    ],
)
def test_what_nothing_holds_is_named_with_exit_code_3(
    beta: str, driven: str, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    held = "  a: {body: driver, stiffness: {radial: 1e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}\n"
    rest = f"bearings:\n{held}{driven}scenarios: {{go: {{duration: 1 ms}}}}\n"
    file = written(tmp_path, pair("{law: din3990}", beta=beta, motion="free", rest=rest))
    for command in (["run", file, "-o", str(tmp_path / "x.h5")], ["modes", file]):
        assert run_command(command) == 3
        assert words in capsys.readouterr().err


LOOP = """\
def torque(t, x, p):
    while t > 0.11:
        pass
    return 150.0
"""


def test_a_second_ctrl_c_ends_a_compiled_law_that_never_returns(tmp_path: Path) -> None:
    """Python cannot act there; samples that were written before stay readable."""
    (tmp_path / "law.py").write_text(LOOP)
    text = LONG.replace("500 s", "0.5 s").replace(
        "input:  {body: driver, torque: 150 N m}", "input:  {body: driver, torque: {python: 'law.py:torque'}}"
    )
    target = tmp_path / "out.h5"
    child = start(written(tmp_path, text), target, "--allow-code")
    time.sleep(1.0)
    child.send_signal(signal.SIGINT)
    time.sleep(2.5)
    assert child.poll() is None
    child.send_signal(signal.SIGINT)
    out, err = child.communicate(timeout=30)
    assert child.returncode == 130
    assert out == ""
    assert "press Ctrl-C again" in err
    assert "Traceback" not in err
    assert read_header(target)["status"] == "running"
    t, force = read_channel(target, "mesh_force[stage]")
    assert t.size > 1000
    assert t[-1] <= 0.11
    assert np.isfinite(force).all()


def test_the_channels_to_store_are_chosen(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """By the scenario or by --channels, * for any characters; the values are those of the whole file."""
    file, every, some = written(tmp_path, SHORT), str(tmp_path / "every.h5"), str(tmp_path / "some.h5")
    json_of(["run", file, "-s", "steady", "-o", every], capsys)
    few = ["--channels", "speed[*]", "--channels", "mesh_force[stage]"]
    found = json_of(["run", file, "-s", "steady", "-o", some, *few], capsys)
    assert set(found["channels"]) == {"speed[driver]", "speed[driven]", "mesh_force[stage]"}
    with open_result(every) as whole, open_result(some) as chosen:
        assert set(chosen.data_vars) >= set(found["channels"])
        assert "deflection[stage]" not in chosen.data_vars
        for name in found["channels"]:
            np.testing.assert_array_equal(chosen[name].values, whole[name].values)
    inside = SHORT.replace("duration: 0.02 s", "duration: 0.02 s, channels: ['speed[*]']")
    found = json_of(["run", written(tmp_path, inside), "-s", "steady", "-o", some], capsys)
    assert set(found["channels"]) == {"speed[driver]", "speed[driven]"}
    assert run_command(["report", file, some, "-o", str(tmp_path / "page.html"), "-q"]) == 0


def test_a_pattern_that_names_no_channel_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path, SHORT)
    assert run_command(["run", file, "-s", "steady", "--channels", "mesh_farce[stage]"]) != 0
    said = capsys.readouterr().err
    assert "'mesh_farce[stage]' matches none of the" in said
    assert "an example is mesh_force[stage]" in said


@pytest.mark.parametrize(
    "command", [["run", "FILE", "-s", "steady"], ["run", "FILE", "-s", "steady", "--json"]]
)
def test_a_quiet_run_prints_errors_only(
    command: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path, SHORT)
    words = [file if word == "FILE" else word for word in command]
    assert run_command([*words, "-o", str(tmp_path / "q.h5"), "-q"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert (out == "") != ("--json" in command)


@pytest.mark.parametrize("command", ["gears", "mesh", "mass", "clearance"])
def test_commands_that_print_numbers_take_quiet_too(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_command([command, written(tmp_path, ISO_EX1), "-q"]) == 0
    out, err = capsys.readouterr()
    assert out != ""
    assert err == ""
