# SPDX-License-Identifier: Apache-2.0
"""Several turbines with controller libraries, runs at the same time, individual pitch, interrupts."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.reading import open_result, read_header
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.stepper import Stepper
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.discon_library import discon_library, input_file, processes_of_controllers

TURBINE = """\
  {name}: {{type: discon, library: libprobe.so, input_file: pi.in, period: {period},
    inputs: {{generator_speed: speed_{name}}}, outputs: {{pitch_demand: pitch_{name}}}}}
"""
PARTS = {
    "bodies": "  {name}: {{motion: torsion, inertia: 20 kg m^2, position: [0, 0, {at}]}}\n",
    "sensors": "  speed_{name}: {{type: joint, coordinate: {name}, derivative: 1}}\n",
    "blocks": "  air_{name}: {{type: formula, formula: '60*(1 - pitch_{name}) + {at}*sin(3*t)', "
    "inputs: [pitch_{name}, t], unit: N m}}\n",
    "controllers": TURBINE,
    "actuators": "  wind_{name}: {{type: torque, signal: air_{name}, bodies: [{name}]}}\n",
}
RUN = """\
scenarios:
  run: {{start: assembled, speed: {{{speeds}}}, duration: 0.6 s, step: 1 ms, settle_time: 0 s, method: adams}}
"""
TWO = {"east": (20, "10 ms", 100.0), "west": (35, "15 ms", 103.0)}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    shutil.copy(discon_library(), tmp_path / "libprobe.so")
    for what in ("pi", "individual", "hang"):
        input_file(tmp_path, what)
    return tmp_path


def turbines(folder: Path, *names: str) -> Path:
    """Model of some of the two turbines."""
    text = ""
    for section, line in PARTS.items():
        text += f"{section}:\n"
        text += "".join(line.format(name=n, at=TWO[n][0], period=TWO[n][1]) for n in names)
    text += RUN.format(speeds=", ".join(f"{n}: {TWO[n][2]} rad/s" for n in names))
    file = folder / f"{'_'.join(names)}.yaml"
    file.write_text(text, encoding="utf-8")
    return file


def pitch(data, name: str) -> np.ndarray:
    found = data[f"signal[pitch_{name}]"].values
    assert np.ptp(found) > 0.02
    return found


def test_two_turbines_of_one_model_do_not_share_their_state(folder: Path) -> None:
    """The integrals of the library are global variables: each turbine moves as if it were alone."""
    both = solve_time(compile_model(load_model(turbines(folder, "east", "west"), allow_code=True), "run"))
    for name in TWO:
        alone = solve_time(compile_model(load_model(turbines(folder, name), allow_code=True), "run"))
        np.testing.assert_array_equal(pitch(both, name), pitch(alone, name))
    assert not processes_of_controllers()


def test_runs_at_the_same_time(folder: Path) -> None:
    """In threads, and as steppers that take turns: the result is that of a run alone."""
    models = {name: load_model(turbines(folder, name), allow_code=True) for name in TWO}
    alone = {name: solve_time(compile_model(m, "run")) for name, m in models.items()}
    found = {}

    def go(k: int, name: str) -> None:
        """One run."""
        found[k] = name, solve_time(compile_model(models[name], "run"))

    threads = [threading.Thread(target=go, args=(k, name)) for k, name in enumerate(["east", "west", "east"])]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for name, data in found.values():
        np.testing.assert_array_equal(pitch(data, name), pitch(alone[name], name))
    with Stepper(models["east"], "run") as one, Stepper(models["east"], "run") as other:
        assert len(processes_of_controllers()) == 2
        for k in range(40):
            one.advance(0.01)
            if k % 2:
                other.advance(0.02)
        assert one.outputs() == other.outputs()
        assert one.value("signal[pitch_east]") == pitch(alone["east"], "east")[400]
    assert not processes_of_controllers()


INDIVIDUAL = """\
bodies: {rotor: {motion: torsion, inertia: 20 kg m^2}}
sensors: {angle: {type: joint, coordinate: rotor}}
blocks:
  moment_1: {type: formula, formula: "100 + 30*cos(angle)", inputs: [angle]}
  moment_2: {type: formula, formula: "100 + 30*cos(angle + 2*pi/3)", inputs: [angle]}
  moment_3: {type: formula, formula: "100 + 30*cos(angle - 2*pi/3)", inputs: [angle]}
controllers:
  turbine: {type: discon, library: libprobe.so, input_file: individual.in, period: 10 ms,
    pitch_control: individual,
    inputs: {blade_1_out_of_plane_moment: moment_1, blade_2_out_of_plane_moment: moment_2,
      blade_3_out_of_plane_moment: moment_3,
      blade_1_pitch: pitch_1, blade_2_pitch: pitch_2, blade_3_pitch: pitch_3},
    outputs: {blade_1_pitch_demand: pitch_1, blade_2_pitch_demand: pitch_2, blade_3_pitch_demand: pitch_3},
    start: {pitch_1: 0.1, pitch_2: 0.2, pitch_3: 0.3}}
scenarios: {run: {start: assembled, speed: {rotor: 5 rad/s}, duration: 1 s, step: 1 ms,
  settle_time: 0 s, method: adams, sample_rate: 100 Hz}}
"""


def test_individual_pitch(folder: Path) -> None:
    """Three demands by the moments and pitch angles of three blades, as the same recursion in Python."""
    (folder / "blades.yaml").write_text(INDIVIDUAL, encoding="utf-8")
    data = solve_time(compile_model(load_model(folder / "blades.yaml", allow_code=True), "run"))
    for k, shift in enumerate((0.0, 2.0 * np.pi / 3.0, -2.0 * np.pi / 3.0)):
        expected = [0.1 * (k + 1)]
        for n in range(len(data["time"]) - 1):
            moment = 100.0 + 30.0 * np.cos(0.05 * n + shift)
            expected.append(0.1 + 2e-3 * moment + 0.5 * expected[-1])
        found = data[f"signal[pitch_{k + 1}]"].values  # of an instant: before the call, except for the first
        np.testing.assert_allclose(found, [expected[1], *expected[1:]], rtol=1e-5)


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
@pytest.mark.parametrize("way", ["SIGINT", "SIGKILL"])
def test_a_command_that_is_interrupted_in_a_call(folder: Path, way: str) -> None:
    """Ctrl-C while the library hangs in its first call, and the end of the command without any warning."""
    file = turbines(folder, "east")
    text = file.read_text(encoding="utf-8").replace("pi.in", "hang.in")
    file.write_text(text, encoding="utf-8")
    arguments = [sys.executable, "-m", "pitchpoint", "run", str(file), "--allow-code", "-o", "run.h5"]
    command = subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    until = time.monotonic() + 60.0
    while not processes_of_controllers() and time.monotonic() < until:
        time.sleep(0.05)
    time.sleep(0.5)
    os.kill(command.pid, getattr(signal, way))
    _, said = command.communicate(timeout=60.0)
    while processes_of_controllers() and time.monotonic() < until + 10.0:
        time.sleep(0.05)
    assert not processes_of_controllers()
    assert command.returncode == {"SIGINT": 130, "SIGKILL": -9}[way], said


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_an_interrupt_during_a_run_keeps_the_partial_result(folder: Path) -> None:
    file = turbines(folder, "east")
    file.write_text(file.read_text(encoding="utf-8").replace("0.6 s", "1e5 s"), encoding="utf-8")
    arguments = [sys.executable, "-m", "pitchpoint", "run", str(file), "--allow-code", "-o", "run.h5"]
    command = subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    until = time.monotonic() + 60.0
    while not processes_of_controllers() and time.monotonic() < until:
        time.sleep(0.05)
    time.sleep(1.5)
    command.send_signal(signal.SIGINT)
    _, said = command.communicate(timeout=60.0)
    assert command.returncode == 130, said
    assert not processes_of_controllers()
    assert read_header("run.h5")["status"] == "interrupted"
    with open_result("run.h5") as data:
        assert len(data["time"]) > 10
