# SPDX-License-Identifier: Apache-2.0
"""FMUs of other programs in a model: coupled runs, several at once, failures, wrong and hostile files."""

from __future__ import annotations

import copy
import gc
import json
import os
import stat
import struct
import subprocess
import sys
import tempfile
import time
import zipfile
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import MissingDependencyError
from pitchpoint.core.fmi import fmu_file, fmu_process
from pitchpoint.core.fmi.fmu_file import FmuFileError, own_platform, read_fmu
from pitchpoint.core.status import CONTROLLER
from tests.support.controlled_rotors import controlled, rotor
from tests.support.fmu_models import need_linker
from tests.support.strange_fmu import elf_header, strange_fmu, write_fmu

WHOLE = """
bodies:
  rotor: {motion: torsion, inertia: 20 kg m^2}
  generator: {motion: torsion, inertia: 5 kg m^2}
couplings:
  shaft: {bodies: [rotor, generator], stiffness: {torsion: 1000 N m/rad}, damping: {torsion: 10 N m s/rad}}
loads:
  wind: {body: rotor, torque: 100 N m}
  grid: {body: generator, torque: -100 N m}
scenarios:
  run:
    speed: {rotor: 10 rad/s}
    start: assembled
    duration: 0.5 s
    step: 0.5 ms
    method: adams
    sample_rate: 100 Hz
"""

GENERATOR = rotor(
    "shaft: {body: generator, torque: 0 N m}, grid: {body: generator, torque: -100 N m}",
    "duration: 1 s, step: 0.5 ms",
    inertia=5.0,
    name="generator",
)
WIND = "wind: {body: rotor, torque: 100 N m}"
ROTOR = (
    rotor(WIND, "duration: 0.5 s, step: 0.5 ms, sample_rate: 100 Hz", inertia=20.0)
    + """
sensors:
  speed: {type: joint, coordinate: rotor, derivative: 1}
controllers:
  generator:
    type: fmu
    file: FILE
    inputs: {loads.shaft.torque: torque}
    outputs: {"speed[generator]": generator_speed}
    start: [10 rad/s]
    period: 4 ms
blocks:
  slip: {type: sum, inputs: {speed: 1, generator_speed: -1}, unit: rad/s}
  twist: {type: integrator, input: slip, unit: rad}
  torque: {type: sum, inputs: {twist: 1000 N m/rad, slip: 10}, unit: N m}
  reaction: {type: sum, inputs: {torque: -1}, unit: N m}
actuators:
  shaft: {type: torque, signal: reaction, bodies: [rotor]}
"""
)
MACHINE = rotor(WIND, "duration: 10 ms, step: 1 ms, sample_rate: 1 kHz") + controlled(
    "type: fmu, file: strange.fmu, inputs: {u: speed}, outputs: {y: wanted}, period: 1 ms, time_limit: 20 s"
)


def runs(folder, text, changes=None):
    """Dataset of the scenario of a model text in a folder."""
    file = folder / "model.yaml"
    file.write_text(text)
    model = pp.load_model(file, allow_code=True, changes=changes or {})
    return pp.solve_time(pp.compile_model(model, "run"))


def processes(parent=0):
    """Numbers of the processes of FMUs that a process has started, by default this one."""
    parent = parent or os.getpid()
    gc.collect()
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/stat") as file, open(f"/proc/{name}/cmdline") as command:
                fields, words = file.read().rpartition(")")[2].split(), command.read()
        except OSError:
            continue
        if fields[1] == str(parent) and "pitchpoint.core.fmi.host" in words:
            found.append(int(name))
    return found


@pytest.fixture(scope="module")
def strange(tmp_path_factory):
    """Folder with the FMU of C, which can fail."""
    return strange_fmu(tmp_path_factory.mktemp("strange")).parent


@pytest.mark.parametrize("version", [2, 3])
def test_our_own_fmu_couples_to_first_order(version, tmp_path, capsys):
    """A shaft between two programs, against the same machine in one model."""
    pytest.importorskip("fmpy", reason="fmpy is not installed (extra fmi)")
    need_linker()
    pp.export_fmu(pp.load_model(text=GENERATOR), tmp_path / "generator.fmu", "run", version=version)
    whole = pp.solve_time(pp.compile_model(pp.load_model(text=WHOLE), "run"))["speed[rotor]"].values
    errors = []
    for period in (4e-3, 2e-3, 1e-3):
        changes = {"controllers.generator.period": period, "controllers.generator.file": "generator.fmu"}
        errors.append(np.abs(runs(tmp_path, ROTOR, changes)["speed[rotor]"].values - whole).max())
    assert np.divide(errors[:-1], errors[1:]) == pytest.approx(2.0, rel=0.1)
    assert errors[-1] < 0.05 * np.ptp(whole)
    (tmp_path / "model.yaml").write_text(ROTOR.replace("FILE", "generator.fmu").replace("4 ms", "2 ms"))
    model = pp.load_model(tmp_path / "model.yaml", allow_code=True)
    estimated = pp.estimate_communication_error(model, "run")["speed[rotor]"]
    assert np.abs(estimated.values - whole).max() == errors[-1]
    assert estimated.attrs["communication_error"] == pytest.approx(errors[-1], rel=0.1)
    arguments = ["run", str(tmp_path / "model.yaml"), "-o", str(tmp_path / "out.h5"), "--allow-code"]
    assert run_command([*arguments, "--communication-error", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["communication_error"]["speed[rotor]"]
    own = 2.0 * estimated.attrs["communication_error"]
    assert found == pytest.approx(own, rel=1e-3)  # the file has single precision
    assert run_command([*arguments, "--communication-error"]) == 0
    assert "speed[rotor]" in capsys.readouterr().out.partition("error of the communication steps")[2]
    assert not processes()


def test_the_communication_error_needs_an_fmu(tmp_path, capsys):
    (tmp_path / "model.yaml").write_text(WHOLE)
    arguments = ["run", str(tmp_path / "model.yaml"), "-o", str(tmp_path / "out.h5"), "--communication-error"]
    assert run_command(arguments) == 2
    assert "controllers: contain no FMU" in capsys.readouterr().err


def test_units_and_the_communication_points(strange):
    """y = 2 u + 3 t with u in rpm: the output of a step has the inputs of its end."""
    data = runs(strange, MACHINE)
    t, speed = data["time"].values, data["signal[speed]"].values
    want = 2.0 * speed * 30.0 / np.pi + 3.0 * t
    np.testing.assert_allclose(data["signal[wanted]"].values[1:], want[:-1], rtol=1e-12)
    assert data["signal[wanted]"].attrs["units"] == "N m"
    assert not processes()


def test_several_at_once_do_not_share_their_state(strange):
    """The library has static variables: two instances in one process would disturb each other."""
    second = (
        "  second: {type: fmu, file: strange.fmu, inputs: {u: still}, outputs: {y: other}, period: 2 ms}\n"
    )
    text = MACHINE + "blocks:\n  still: {type: sum, inputs: {speed: 0}, offset: 1}\n"
    text = text.replace(
        "actuators:\n", second + "actuators:\n  second: {type: torque, signal: other, bodies: [rotor]}\n"
    )
    data = runs(strange, text)
    want = 2.0 * 30.0 / np.pi + 3.0 * 2e-3 * np.floor((data["time"].values - 5e-4) / 2e-3)
    np.testing.assert_allclose(data["signal[other]"].values[1:], want[1:], rtol=1e-9)
    assert data["signal[wanted]"].values[-1] > 190.0


@pytest.mark.parametrize(
    ("mode", "sentence"),
    [
        (1, r"the FMU strange.fmu has crashed \(SIGABRT\)"),
        (2, r"the FMU strange.fmu has not answered within 1 s \(time_limit\)"),
        (3, r"returned nan for 'wanted'"),
        (4, r"the FMU strange.fmu has failed: fmi2DoStep .*the engine has no fuel"),
        (5, r"the FMU strange.fmu has crashed \(exit code 7\)"),
    ],
)
def test_a_failure_ends_the_run_with_a_sentence_and_its_partial_result(strange, mode, sentence):
    changes = {"controllers.control.parameters": {"mode": mode}, "controllers.control.time_limit": 1.0}
    with pytest.raises(pp.SolverError, match=f"controllers.control .*{sentence}.*t = 0.005 s") as failure:
        runs(strange, MACHINE, changes)
    assert failure.value.status == CONTROLLER
    assert list(failure.value.partial["time"].values) == pytest.approx(1e-3 * np.arange(6))
    assert not processes()


def test_on_the_command_line(strange, tmp_path, capsys):
    (strange / "model.yaml").write_text(MACHINE)
    arguments = ["run", str(strange / "model.yaml"), "-o", str(tmp_path / "out.h5"), "--quiet"]
    assert run_command(arguments) == 2
    assert "--allow-code" in capsys.readouterr().err
    assert run_command([*arguments, "--allow-code", "--set", "controllers.control.parameters={mode: 1}"]) == 3
    text = capsys.readouterr().err
    assert "has crashed (SIGABRT)" in text and text.count("t = 0.005 s") == 1
    assert pp.open_result(tmp_path / "out.h5").sizes["time"] == 6
    assert not processes()


def test_a_killed_run_leaves_nothing(strange, tmp_path):
    """The FMU hangs in its own code, and its parent is killed without a chance to end it."""
    program = (
        "import pitchpoint as pp, sys\n"
        "changes = {'controllers.control.parameters': {'mode': 2}}\n"
        "model = pp.load_model(sys.argv[1], allow_code=True, changes=changes)\n"
        "pp.solve_time(pp.compile_model(model, 'run'))\n"
    )
    (strange / "model.yaml").write_text(MACHINE)
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    parent = subprocess.Popen([sys.executable, "-c", program, str(strange / "model.yaml")], env=environment)
    until, children = time.monotonic() + 60.0, []
    while not children and time.monotonic() < until and parent.poll() is None:
        time.sleep(0.1)
        children = processes(parent.pid)
    time.sleep(1.0)
    parent.kill()
    parent.wait()
    assert children
    while time.monotonic() < until and any(os.path.exists(f"/proc/{n}") for n in children):
        time.sleep(0.1)
    assert not any(os.path.exists(f"/proc/{n}") for n in children)
    assert not list(tmp_path.glob("pitchpoint-fmu-*"))


def of_folder(folder):
    """Numbers of the processes of FMUs that are unpacked in a folder, with their children."""
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        with suppress(OSError), open(f"/proc/{name}/cmdline") as command:
            if f"{folder}/pitchpoint-fmu-" in command.read():
                found.append(int(name))
    return found


def test_processes_that_an_fmu_starts_end_with_it(strange, tmp_path, monkeypatch):
    """At the end of the run, and when the parent is killed while the FMU hangs."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    begin = time.monotonic()
    assert runs(strange, MACHINE, {"controllers.control.parameters": {"mode": 6}}).sizes["time"] == 11
    assert time.monotonic() - begin < 30.0
    until = time.monotonic() + 5.0  # a killed process exists for an instant
    while of_folder(tmp_path) and time.monotonic() < until:
        time.sleep(0.01)
    assert not of_folder(tmp_path)
    program = (
        "import pitchpoint as pp, sys\n"
        "changes = {'controllers.control.parameters': {'mode': 7}}\n"
        "model = pp.load_model(sys.argv[1], allow_code=True, changes=changes)\n"
        "pp.solve_time(pp.compile_model(model, 'run'))\n"
    )
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    parent = subprocess.Popen([sys.executable, "-c", program, str(strange / "model.yaml")], env=environment)
    until = time.monotonic() + 60.0
    while len(of_folder(tmp_path)) < 2 and time.monotonic() < until:
        time.sleep(0.1)
    assert len(of_folder(tmp_path)) == 2
    parent.kill()
    parent.wait()
    while of_folder(tmp_path) and time.monotonic() < until:
        time.sleep(0.1)
    assert not of_folder(tmp_path)


def test_a_stepper_cannot_save_the_state_of_an_fmu(strange):
    (strange / "model.yaml").write_text(MACHINE)
    stepper = pp.Stepper(pp.load_model(strange / "model.yaml", allow_code=True), "run")
    stepper.advance(2e-3)
    assert stepper.value("signal[wanted]") > 190.0
    with pytest.raises(pp.PitchpointError, match=r"state of the FMU strange.fmu cannot be saved"):
        stepper.save()


def test_a_context_ends_the_process_of_an_fmu(strange):
    """The process ends with the context, while the stepper and its states still exist."""
    (strange / "model.yaml").write_text(MACHINE)
    with pp.Stepper(pp.load_model(strange / "model.yaml", allow_code=True), "run") as stepper:
        stepper.advance(2e-3)
        assert len(processes()) == 1
    assert not processes() and stepper.closed and stepper.t == pytest.approx(2e-3)
    with pytest.raises(pp.SolverError, match="its controllers have ended"):
        stepper.advance(1e-3)


@dataclass
class CountedUnit:
    """Process of a unit that saves its number of requests; it records them."""

    requests: list

    def save(self):
        self.requests.append("save")
        return self

    def restore(self):
        self.requests.append("restore")
        return self

    def close(self):
        self.requests.append("close")


def test_only_a_sampler_saves_restores_and_ends_a_unit():
    """A saved state may be copied: the running unit does not notice it."""
    unit = CountedUnit([])
    state = {"unit": unit, "t": 0.1}
    saved = fmu_process.save(state)
    state["t"] = 0.2
    copied = copy.copy(saved)
    assert unit.requests == ["save"] and copied["t"] == 0.1
    assert fmu_process.restore(copied) == {"unit": unit, "t": 0.1}
    assert fmu_process.finish(state) == () and fmu_process.finish(state) == ()
    assert unit.requests == ["save", "restore", "close"]


@pytest.mark.parametrize("version", [2, 3])
def test_a_stepper_saves_the_state_of_an_fmu_that_can(version, tmp_path):
    """Our own unit: the restored run has the same bits, also after another load."""
    pytest.importorskip("fmpy", reason="fmpy is not installed (extra fmi)")
    need_linker()
    pp.export_fmu(pp.load_model(text=GENERATOR), tmp_path / "generator.fmu", "run", version=version)
    (tmp_path / "model.yaml").write_text(ROTOR.replace("FILE", "generator.fmu"))
    stepper = pp.Stepper(pp.load_model(tmp_path / "model.yaml", allow_code=True), "run")
    stepper.advance(0.02)
    state, ends = stepper.save(), []
    for wind in (100.0, 500.0, 100.0):
        stepper.restore(state)
        stepper.set({"loads.wind.torque": wind})
        stepper.advance(0.04)
        ends.append(list(stepper.outputs().values()))
    assert ends[0] == ends[2] != ends[1]
    held = stepper._loop.sampler._states[0]["unit"]
    copied = copy.deepcopy(state._more["sampler"]["own"])  # no request to the unit
    assert copied["_calls"] == [6] and not held._forgotten
    del state
    gc.collect()
    assert held._forgotten == [1]  # released with the next request
    stepper.advance(0.01)
    assert held._forgotten == []
    del stepper, held
    assert not processes()


def test_without_the_importer(tmp_path, monkeypatch):
    monkeypatch.setattr("pitchpoint.core.fmi.fmu_process.find_spec", lambda name: None)
    write_fmu(tmp_path / "strange.fmu")
    with pytest.raises(MissingDependencyError, match=r"pip install 'pitchpoint\[fmi\]'"):
        runs(tmp_path, MACHINE)


# --- files --------------------------------------------------------------------------------------------------
def problems_of(folder, **changes):
    """Problems of the model with the controller changed."""
    (folder / "model.yaml").write_text(MACHINE)
    changes = {f"controllers.control.{key}": value for key, value in changes.items()}
    with pytest.raises(pp.ModelError) as found:
        pp.load_model(folder / "model.yaml", allow_code=True, changes=changes)
    return [str(problem) for problem in found.value.problems]


def test_all_wrong_connections_are_reported_together(tmp_path):
    write_fmu(
        tmp_path / "strange.fmu",
        changes={'causality="parameter"><Real start="0"/>': 'causality="parameter"><Real/>'},
    )
    found = problems_of(
        tmp_path, inputs={"v": "speed", "y": "speed"}, outputs={"note": "wanted", "y": "more"}
    )
    said = {
        message.partition(":")[0].partition(" (")[0].partition("control.")[2]: message for message in found
    }
    wanted = {
        "parameters": "do not give mode, which has no start value in the FMU; add mode to parameters",
        "inputs.v": "does not exist in the FMU; inputs of the FMU: u",
        "inputs.y": "is output there",
        "outputs.note": "String is not a number",
    }
    assert len(found) == 4 and all(words in said[key] for key, words in wanted.items()), said


def test_an_input_without_start_value_must_be_connected(tmp_path):
    write_fmu(tmp_path / "strange.fmu", changes={'<Real start="0" unit="rpm"/>': '<Real unit="rpm"/>'})
    (found,) = problems_of(tmp_path, inputs={})
    assert "controllers.control.inputs" in found and "do not give u, which has no start value" in found


def test_an_fmu_for_another_platform(tmp_path):
    write_fmu(tmp_path / "one.fmu")
    with zipfile.ZipFile(tmp_path / "one.fmu") as archive:
        text = archive.read("modelDescription.xml")
    with zipfile.ZipFile(tmp_path / "strange.fmu", "w") as archive:
        archive.writestr("modelDescription.xml", text)
        archive.writestr("binaries/riscv64-plan9/strange.so", b"")
    (found,) = problems_of(tmp_path)
    assert "controllers.control.file (line 10)" in found
    assert f"has no library for this computer, {own_platform()}; it has libraries for riscv64-plan9" in found


@pytest.mark.parametrize(
    "name", ["../../evil.txt", "/evil.txt", "a\\..\\evil.txt", "C:evil.txt", "x/../../evil"]
)
def test_paths_outside_are_refused(tmp_path, name):
    write_fmu(tmp_path / "strange.fmu", {name: "evil"})
    (found,) = problems_of(tmp_path)
    assert "leads out of the folder of the FMU" in found and "evil" in found


def test_links_and_double_entries_are_refused(tmp_path):
    file = write_fmu(tmp_path / "link.fmu")
    link = zipfile.ZipInfo("resources/link")
    link.external_attr = (stat.S_IFLNK | 0o777) << 16
    with zipfile.ZipFile(file, "a") as archive:
        archive.writestr(link, "/etc/passwd")
    with pytest.raises(FmuFileError, match="symbolic link"):
        read_fmu(str(file))
    file = write_fmu(tmp_path / "twice.fmu", {"resources/a": "1", "resources/A": "2"})
    with pytest.raises(FmuFileError, match="twice"):
        read_fmu(str(file))


def test_a_size_bomb_is_refused_before_it_is_written(tmp_path, monkeypatch):
    monkeypatch.setattr(fmu_file, "LARGEST", 10_000_000)
    file = write_fmu(tmp_path / "bomb.fmu", {"resources/zeros": bytes(11_000_000)})
    assert file.stat().st_size < 30_000
    with pytest.raises(FmuFileError, match="too large when extracted"):
        read_fmu(str(file))


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({'fmiVersion="2.0"': 'fmiVersion="1.0"'}, "is of version 1.0 of FMI, which is not supported"),
        ({' modelIdentifier="strange"': ""}, "without modelIdentifier"),
        (
            {'modelIdentifier="strange"': 'modelIdentifier="../odd"'},
            r"has no library ../odd.so for .* but strange.so",
        ),
        ({'valueReference="': 'valueReference="x'}, "with a wrong number, .*: valueReference 'x"),
        ({'factor="0.10': 'factor="0" x="0.10'}, "with a wrong number, BaseUnit: factor '0'"),
        ({'factor="0.10': 'factor="inf" x="0.10'}, "with a wrong number, BaseUnit: factor 'inf'"),
        ({"<CoSimulation": "<ModelExchange"}, "is not for co-simulation"),
        ({'identifier="strange"': 'identifier="strange" needsExecutionTool="true"'}, "needs the program"),
        ({"<UnitDefinitions>": "<UnitDefinitions"}, "that is not XML"),
        ({"?>": '?><!DOCTYPE a [<!ENTITY b "b">]>'}, "with entities"),
    ],
)
def test_descriptions_that_cannot_be_used(tmp_path, changes, sentence):
    changes = {
        key.replace("identifier=", "modelIdentifier="): v.replace("identifier=", "modelIdentifier=")
        for key, v in changes.items()
    }
    with pytest.raises(FmuFileError, match=sentence):
        read_fmu(str(write_fmu(tmp_path / "one.fmu", changes=changes)))


def test_files_that_are_no_fmu(tmp_path):
    (tmp_path / "text.fmu").write_text("FMU")
    with pytest.raises(FmuFileError, match="is not a ZIP archive"):
        read_fmu(str(tmp_path / "text.fmu"))
    whole = write_fmu(tmp_path / "whole.fmu").read_bytes()
    (tmp_path / "cut.fmu").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(FmuFileError, match="is cut off or damaged; copy the FMU again"):
        read_fmu(str(tmp_path / "cut.fmu"))
    (tmp_path / "empty.fmu").write_bytes(b"")
    with pytest.raises(FmuFileError, match="is empty and not a ZIP archive"):
        read_fmu(str(tmp_path / "empty.fmu"))
    with zipfile.ZipFile(tmp_path / "other.fmu", "w") as archive:
        archive.writestr("readme.txt", json.dumps({}))
    with pytest.raises(FmuFileError, match=r"contains no modelDescription.xml"):
        read_fmu(str(tmp_path / "other.fmu"))
    library = f"binaries/{own_platform()}/strange.so"
    for data, sentence in (
        (b"MZ or so", "is not a library"),
        (elf_header(end=5000) + bytes(100), "is cut off"),
        (elf_header(processor=9999), "is for another system, Linux processor 9999"),
    ):
        with pytest.raises(FmuFileError, match=sentence):
            read_fmu(str(write_fmu(tmp_path / f"{len(data)}.fmu", {library: data})))
    other = write_fmu(tmp_path / "check.fmu", {"resources/table": bytes(range(256)) * 64})
    with zipfile.ZipFile(other) as archive:
        entry = archive.getinfo("resources/table")
    damaged = bytearray(other.read_bytes())
    damaged[damaged.rfind(struct.pack("<I", entry.CRC))] ^= 1
    other.write_bytes(damaged)
    with pytest.raises(FmuFileError, match=r"is damaged: .*resources/table"):
        read_fmu(str(other))
    (found,) = problems_of(tmp_path, file=str(other))
    assert found.startswith("controllers.control.file") and "is damaged" in found
    damaged = bytearray(whole)
    damaged[120:160] = bytes(40)
    (tmp_path / "damaged.fmu").write_bytes(damaged)
    with pytest.raises(FmuFileError, match=r"is damaged"):
        read_fmu(str(tmp_path / "damaged.fmu"))
    damaged = bytearray(whole)
    struct.pack_into("<H", damaged, 26, 60_000)  # length of the first name
    (tmp_path / "long.fmu").write_bytes(damaged)
    with pytest.raises(FmuFileError, match=r"is damaged: File name in directory") as error:
        read_fmu(str(tmp_path / "long.fmu"))
    assert len(str(error.value)) < 300
