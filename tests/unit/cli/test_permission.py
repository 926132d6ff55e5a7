# SPDX-License-Identifier: Apache-2.0
"""Python code runs with `--allow-code` only, whichever file names it, and never from the working folder."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.child import python_command, python_environment
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.io.yaml_plan import load_plan
from pitchpoint.model.components.law import PythonLaw
from pitchpoint.sweep.cases import run_case
from tests.support.dataset_files import MODEL, PLAN, written

CODE = "import pathlib\npathlib.Path(__file__).with_name('ran').touch()\ndef f(t, x, p):\n    return 100.0\n"
LAW = {"python": "law.py:f"}
FACTOR = "factors:\n  c: {one: {loads.input.torque: {python: 'law.py:f'}}}\n"
COMMANDS = {
    "set": ["run", "pair.yaml", "-s", "steady", "--set", "loads.input.torque={python: 'law.py:f'}"],
    "vary": ["run", "pair.yaml", "-s", "steady", "--vary", "loads.input.torque={python: 'law.py:f'},50 N m"],
    "plan": ["dataset", "plan.yaml"],
    "dry run": ["dataset", "plan.yaml", "--dry-run"],
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    plan = PLAN.replace("factors:\n  torque: {loads.input.torque: [100 N m, 150 N m]}\n", FACTOR).replace(
        "jitter: {loads.input.torque: 1 %}\n", ""
    )
    written(tmp_path, plan, MODEL)
    (tmp_path / "law.py").write_text(CODE)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("name", COMMANDS)
def test_code_that_a_value_names_is_not_run(name: str, folder: Path, capsys: pytest.CaptureFixture) -> None:
    code = run_command([*COMMANDS[name], "-q"])
    assert not (folder / "ran").exists()
    text = capsys.readouterr().err
    if name == "vary":  # one impossible case of several is a case that failed
        assert code == 3
    else:
        assert code == 2
    assert "--allow-code" in text


@pytest.mark.parametrize("name", ["set", "dry run"])
def test_it_runs_with_permission(name: str, folder: Path) -> None:
    assert run_command([*COMMANDS[name], "--allow-code", "-q"]) == 0
    assert (folder / "ran").exists()


def test_permission_in_python(folder: Path) -> None:
    """A model that was read without it needs an explicit argument; one that was read with it keeps it."""
    model = load_model("pair.yaml")
    for change in (model.replace, lambda path, value: model.replace_all({path: value})):
        with pytest.raises(ModelError, match="not run unless allowed"):
            change("loads.input.torque", LAW)
    with pytest.raises(ModelError):
        load_model("pair.yaml", allow_code=True).replace("loads.input.torque", LAW, allow_code=False)
    for changed in (
        model.replace("loads.input.torque", LAW, allow_code=True),
        load_model("pair.yaml", allow_code=True).replace("loads.input.torque", LAW),
        model.replace("loads.input.torque", PythonLaw("law.py", "f", ())),
    ):
        assert changed.loads["input"].torque == PythonLaw("law.py", "f", ())
    assert run_case(model, {"loads.input.torque": LAW}, "steady").status != 1
    assert not (folder / "ran").exists()


def test_the_permission_of_a_model_does_not_cover_a_plan(folder: Path) -> None:
    from pitchpoint.model.reading.dataset_plan import check_plan

    model = load_model("pair.yaml", allow_code=True)
    with pytest.raises(ModelError, match="not run unless allowed"):
        check_plan(load_plan("plan.yaml"), model, ())
    check_plan(load_plan("plan.yaml", allow_code=True), model, ())


@pytest.mark.parametrize("manner", [("-c", "import numpy"), ("-m", "pitchpoint.core.compiler.entries")])
def test_child_processes_do_not_import_from_the_working_folder(manner: tuple[str, str], folder: Path) -> None:
    (folder / "numpy.py").write_text(CODE)
    subprocess.run(python_command(*manner), env=python_environment(), check=True, stdin=subprocess.DEVNULL)
    assert not (folder / "ran").exists()


def test_measured_hdf5_files_are_not_read_with_modules_of_the_working_folder(folder: Path) -> None:
    from pitchpoint.io.measured.hdf5 import _survives

    (folder / "numpy.py").write_text(CODE)
    with h5py.File("record.h5", "w") as file:
        file["signal"] = np.zeros(100)
    assert _survives(Path("record.h5"), 4096)
    assert not (folder / "ran").exists()


def test_the_package_as_a_module_does_not_import_from_the_working_folder(folder: Path) -> None:
    (folder / "numpy.py").write_text(CODE)
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONSAFEPATH"}
    command = [sys.executable, "-m", "pitchpoint", "check", "pair.yaml", "-q"]
    subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL)
    assert not (folder / "ran").exists()
