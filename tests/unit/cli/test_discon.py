# SPDX-License-Identifier: Apache-2.0
"""Controller libraries in model files: the same law in C and Python, failures, exit codes."""

from __future__ import annotations

import gc
import importlib.util
import shutil
import struct
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError, PitchpointError, SolverError
from pitchpoint.core.provenance import content_hash
from pitchpoint.io.reading import open_result, read_header
from pitchpoint.io.yaml_model import dump_model, load_model, loads_model
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.controller import DisconController
from pitchpoint.model.model import Model
from pitchpoint.solvers.stepper import Stepper
from tests.support.cli_files import json_of
from tests.support.discon_library import discon_library, input_file, processes_of_controllers

ROTOR = """\
title: rotor with a pitch controller
bodies: {rotor: {motion: torsion, inertia: 20 kg m^2}}
sensors: {speed: {type: joint, coordinate: rotor, derivative: 1}}
blocks:
  air: {type: formula, formula: "60*(1 - pitch) + 20*sin(3*t)", inputs: [pitch, t], unit: N m}
  generator: {type: sum, inputs: {torque: -1}, unit: N m}
controllers:
  turbine: {type: discon, library: libprobe.so, input_file: pi.in, period: 10 ms, timeout: 60 s,
    inputs: {generator_speed: speed, rated_torque_demand: 30 N m},
    outputs: {pitch_demand: pitch, generator_torque_demand: torque},
    start: {torque: 30 N m}}
actuators:
  wind: {type: torque, signal: air, bodies: [rotor]}
  load: {type: torque, signal: generator, bodies: [rotor]}
scenarios: {run: {start: assembled, speed: {rotor: 100 rad/s}, duration: 0.6 s, step: 1 ms, settle_time: 0 s}}
"""
SAME = """\
import numpy as np


def law(t, inputs, state, parameters):
    error = float(np.float32(inputs[0])) - 100.0
    state["sum"] = state.get("sum", 0.0) + 0.02 * float(np.float32(0.01)) * error
    return float(np.float32(min(max(0.05 * error + state["sum"], 0.0), 1.5))), 30.0
"""


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    shutil.copy(discon_library(), tmp_path / "libprobe.so")
    input_file(tmp_path, "pi")
    (tmp_path / "rotor.yaml").write_text(ROTOR, encoding="utf-8")
    return tmp_path / "rotor.yaml"


def variant(file: Path, *changes: tuple[str, str]) -> Path:
    text = ROTOR
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    file.write_text(text, encoding="utf-8")
    return file


def run(file: Path, target: str = "run.h5") -> int:
    return run_command(["run", str(file), "--allow-code", "-o", target])


def test_a_law_in_c_is_the_same_law_in_python(file: Path) -> None:
    assert run(file) == 0
    (file.parent / "same.py").write_text(SAME, encoding="utf-8")
    text = ROTOR[: ROTOR.index("  turbine:")] + (
        "  turbine: {type: python, function: 'same.py:law', inputs: [speed], outputs: [pitch, torque],"
        " period: 10 ms, start: [0, 30]}\n"
    )
    (file.parent / "same.yaml").write_text(text + ROTOR[ROTOR.index("actuators:") :], encoding="utf-8")
    assert run(file.parent / "same.yaml", "same.h5") == 0
    with open_result("run.h5") as one, open_result("same.h5") as other:
        pitch = one["signal[pitch]"].values
        assert np.ptp(pitch) > 0.02
        np.testing.assert_array_equal(pitch, other["signal[pitch]"].values)
        np.testing.assert_array_equal(one["speed[rotor]"].values, other["speed[rotor]"].values)
        assert one["signal[pitch]"].attrs["units"] == "rad"
    assert not processes_of_controllers()


def test_a_second_run_starts_with_a_new_state(file: Path) -> None:
    """The integral of the library is a global variable: a run in the same process would continue it."""
    assert run(file) == 0
    assert run(file, "again.h5") == 0
    with open_result("run.h5") as one, open_result("again.h5") as other:
        np.testing.assert_array_equal(one["signal[pitch]"].values, other["signal[pitch]"].values)


@pytest.mark.parametrize("method", ["runge_kutta", "dassl"])
def test_methods_with_variable_steps(file: Path, method: str) -> None:
    changed = variant(file, ("step: 1 ms", f"sample_rate: 1 kHz, tolerance: 1e-9, method: {method}"))
    assert run(changed) == 0
    variant(file, ("step: 1 ms", "step: 0.1 ms, sample_rate: 1 kHz"))
    assert run(file, "fine.h5") == 0
    with open_result("run.h5") as one, open_result("fine.h5") as other:
        found = one["speed[rotor]"].values
        np.testing.assert_allclose(found, other["speed[rotor]"].values[: len(found)], rtol=3e-7)


FAILURES = {
    "crash": "crashed in its library (SIGSEGV); it printed: last words (t = 0 s)",
    "late": "crashed in its library (SIGSEGV); it printed: last words (t = 0.05 s)",
    "hang": "did not return within 0.5 s; its process was ended (t = 0 s)",
    "exit": "ended its process with the status 3 (t = 0 s)",
    "nan": "returned nan for 'torque' (t = 0 s)",
    "fail": "reports a failure (-1): the table of gains is empty (t = 0 s)",
}


@pytest.mark.parametrize("what", FAILURES)
def test_failures_keep_the_result_and_leave_no_process(
    file: Path, what: str, capsys: pytest.CaptureFixture[str]
) -> None:
    input_file(file.parent, what)
    limit = "0.5 s" if what == "hang" else "60 s"  # other processes may be stopped for seconds
    assert run(variant(file, ("pi.in", f"{what}.in"), ("60 s", limit))) == 3
    said = capsys.readouterr().err
    assert f"controllers.turbine (line 8) {FAILURES[what]}" in said, said
    assert "partial results are in run.h5" in said
    with open_result("run.h5") as data:
        assert data["time"].values[-1] == pytest.approx(0.05 if what == "late" else 0.0)
    assert read_header("run.h5")["status"] == "failed"
    assert not processes_of_controllers()


def test_warnings_are_notes(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for what, words in (("warn", "reports: speed above the table"), ("last", "(-2): cannot write the log")):
        input_file(file.parent, what)
        assert run(variant(file, ("pi.in", f"{what}.in"))) == 0
        assert words in capsys.readouterr().out
    assert not processes_of_controllers()


def test_library_of_an_installed_package(
    file: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """`library: rosco` is the library in the folder lib of the package; the written model keeps the word."""
    named = variant(file, ("libprobe.so", "rosco"))
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    assert run(named) == 2
    assert "names the package rosco, which is not installed; install it with pip" in capsys.readouterr().err
    monkeypatch.undo()
    package = file.parent / "packages" / "rosco"
    (package / "lib").mkdir(parents=True)
    (package / "__init__.py").write_text("raise ImportError('not imported')", encoding="utf-8")
    shutil.copy(file.parent / "libprobe.so", package / "lib" / "libdiscon.so")
    monkeypatch.syspath_prepend(package.parent)
    assert run(named) == 0
    model = load_model(named, allow_code=True)
    assert model.controllers["turbine"].library == str(package / "lib" / "libdiscon.so")
    assert "library: rosco" in model.to_yaml()


POINTS = [[k, k] for k in range(300)]
WRONG = {
    "no library": (("libprobe.so", "libprob.so"), "library", "names a file that does not exist"),
    "text": (("libprobe.so", "rotor.yaml"), "library", "is a text file, not a shared library"),
    "other": (("libprobe.so", "other.so"), "library", "is for another system, "),
    "procedure": (("period:", "procedure: discon, period:"), "library", "write procedure: DISCON"),
    "no input file": (("pi.in", "no.in"), "input_file", "names a file that does not exist"),
    "record": (("{pitch_demand:", "{pitch_deman:"), "outputs.pitch_deman", "did you mean pitch_demand?"),
    "number": (("generator_speed:", "record_3301:"), "inputs.record_3301", "N from 1 to 3300"),
    "own": (("generator_speed:", "time:"), "inputs.time", "is set by the interface: time; remove it"),
    "output": (("generator_speed:", "yaw_rate_demand:"), "inputs.yaw_rate_demand", "is an output of the"),
    "input": (("{pitch_demand:", "{wind_speed:"), "outputs.wind_speed", "move it to inputs"),
    "twice": (("{pitch_", "{record_47: more, pitch_"), "outputs.generator_torque_demand", "record 47"),
    "blade": (("{pitch_demand:", "{blade_1_pitch_demand:"), "outputs.blade_1_pitch_demand", "individual"),
    "signal": (("speed: speed", "speed: sped"), "inputs.generator_speed", "did you mean speed?"),
    "no outputs": (("{pitch_demand: pitch, generator_torque_demand: torque}", "{}"), "outputs", "write {gen"),
    "start": (("{torque: 30", "{torqe: 30"), "start.torqe", "did you mean torque?"),
    "no number": (("{torque: 30 N m}", "{torque: yes}"), "start.torque", "number"),
    "table": (("period:", f"torque_table: {POINTS}, period:"), "torque_table", "<= 277"),
    "timeout": (("timeout: 60 s", "timeout: 0 s"), "timeout", "> 0"),
}  # fmt: skip


@pytest.mark.parametrize("what", WRONG)
def test_wrong_controllers_are_refused(file: Path, what: str) -> None:
    change, key, words = WRONG[what]
    data = bytearray(discon_library().read_bytes())
    struct.pack_into("<H", data, 18, 243)
    (file.parent / "other.so").write_bytes(data)
    variant(file, change)
    assert run_command(["check", str(file), "--allow-code"]) == run(file) == 2
    assert not Path("run.h5").exists()
    with pytest.raises(ModelError) as found:
        load_model(file, allow_code=True)
    said = [p for p in found.value.problems if p.where == f"controllers.turbine.{key}"]
    assert said and words in str(said[0]), found.value


def test_a_stepper_calls_libraries_but_cannot_save_them(
    file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    variant(file, ("settle_time: 0 s", "settle_time: 0 s, method: adams"), ("0.6 s", "0.1 s"))
    assert run(file) == 0
    stepper = Stepper(load_model(file, allow_code=True), "run")
    for _ in range(10):
        stepper.advance(0.01)
    with open_result("run.h5") as data:
        assert stepper.value("signal[pitch]") == data["signal[pitch]"].values[-1] > 0.0
    with pytest.raises(PitchpointError, match=r"state of the controller library libprobe.so cannot be saved"):
        stepper.save()
    stepper.close()
    assert run_command(["export", str(file), "--allow-code", "--fmu", "rotor.fmu"]) == 2
    assert "controllers.turbine: is a controller library, which an exported model" in capsys.readouterr().err


def ways_to_end(way: str, model: Model) -> None:
    """Advance a stepper by two calls of its library, and end it."""
    stepper = Stepper(model, "run")
    stepper.advance(0.01)
    assert len(processes_of_controllers()) == 1
    if way == "close":
        stepper.close()
        stepper.close()
        assert stepper.closed and stepper.t == pytest.approx(0.01)
        with pytest.raises(SolverError, match="the stepper is closed: its controllers have ended"):
            stepper.advance(0.01)
    elif way == "context":
        with stepper as same:
            same.advance(0.01)
    elif way == "error":
        with pytest.raises(ZeroDivisionError), stepper:
            1 / 0  # noqa: B018
    else:
        del stepper
        gc.collect()


@pytest.mark.parametrize("way", ["close", "context", "error", "garbage"])
def test_the_end_of_a_stepper_ends_its_libraries(file: Path, way: str) -> None:
    """The library gets its last call, with the status -1, and leaves no process."""
    input_file(file.parent, "all")
    variant(file, ("pi.in", "all.in"), ("settle_time: 0 s", "settle_time: 0 s, method: adams"))
    ways_to_end(way, load_model(file, allow_code=True))
    assert not processes_of_controllers()
    later = np.fromfile(file.parent / "next.bin", np.float32).reshape(-1, 3300)
    assert later[-1, 0] == -1.0 and np.count_nonzero(later[:, 0] == -1.0) == 1


def test_a_program_that_ends_or_dies_leaves_no_process(file: Path) -> None:
    variant(file, ("settle_time: 0 s", "settle_time: 0 s, method: adams"))
    for last in ("", "raise ValueError", "os._exit(1)"):
        text = (
            "import os, sys; import pitchpoint as pp\n"
            "stepper = pp.Stepper(pp.load_model(sys.argv[1], allow_code=True), 'run')\n"
            f"stepper.advance(0.02)\n{last}"
        )
        subprocess.run([sys.executable, "-c", text, str(file)], stderr=subprocess.DEVNULL)
        until = time.monotonic() + 10.0
        while processes_of_controllers() and time.monotonic() < until:
            time.sleep(0.05)
        assert not processes_of_controllers(), last


def test_a_library_that_reports_at_its_last_call(file: Path) -> None:
    input_file(file.parent, "last")
    variant(file, ("pi.in", "last.in"), ("settle_time: 0 s", "settle_time: 0 s, method: adams"))
    with Stepper(load_model(file, allow_code=True), "run") as stepper:
        stepper.advance(0.01)
    assert "(-2): cannot write the log (at the last call)" in stepper.dataset().attrs["notes"]


def test_libraries_need_permission(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["check", str(file)]) == 2
    assert "names a library ('libprobe.so'), which is not loaded unless allowed" in capsys.readouterr().err
    found = json_of(["check", str(file), "--allow-code"], capsys)
    line = next(line for line in found["signals"] if line["signal"] == "pitch")
    assert line["what it is"] == "controller turbine (discon), every 10 ms" and line["made of"] == "speed"


def test_files_are_written_again_and_hashed_by_content(file: Path) -> None:
    model = load_model(file, allow_code=True)
    again = loads_model(dump_model(model), allow_code=True, file=str(file))
    assert again == model and content_hash(again) == content_hash(model)
    changed = model.replace_all({"controllers.turbine.period": "20 ms", "controllers.turbine.blades": 2})
    assert (changed.controllers["turbine"].period, changed.controllers["turbine"].blades) == (0.02, 2)
    built = Model(
        bodies={"rotor": Body(motion="torsion", inertia=20.0)},
        controllers={
            "turbine": DisconController(
                library=str(file.parent / "libprobe.so"),
                inputs={"wind_speed": 8.0, "power_demand": "5 MW"},
                outputs={"pitch_demand": "pitch"},
                period="10 ms",
            )
        },
    )
    assert built.controllers["turbine"].inputs == {"wind_speed": 8.0, "power_demand": 5e6}
    before = content_hash(model)
    with (file.parent / "libprobe.so").open("ab") as library:
        library.write(b"more")
    assert content_hash(load_model(file, allow_code=True)) != before
