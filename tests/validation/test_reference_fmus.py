# SPDX-License-Identifier: Apache-2.0
"""Reference FMUs of the Modelica Association in a model, against the results that they ship with.

Source: github.com/modelica/Reference-FMUs (BSD-2), `MODEL/MODEL_out.csv`. The files are computed with the
fixed internal step of each unit, so a co-simulation with the same communication points gives the same
numbers, up to the digits of the file. Set PITCHPOINT_REFERENCE_FMUS to a checkout; cc builds the units.
"""

from __future__ import annotations

import csv
import os
import shutil
import subprocess
import zipfile
from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.fmi.fmu_file import own_platform

#: signals of the units are only recorded
pytestmark = pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")
MACHINE = """
bodies:
  rotor: {motion: torsion, inertia: 2 kg m^2}
controllers:
  unit: {type: fmu, file: FILE, inputs: INPUTS, outputs: OUTPUTS, period: PERIOD s}
blocks:
  half: {type: sum, inputs: {}, offset: 0.5}
  five: {type: sum, inputs: {}, offset: 5}
  two: {type: sum, inputs: {}, offset: 2}
  one: {type: sum, inputs: {}, offset: 1}
loads:
  wind: {body: rotor, torque: 0 N m}
scenarios:
  run:
    {speed: {rotor: 1 rad/s}, start: assembled, method: adams, duration: END s, step: PERIOD s,
     sample_rate: RATE Hz}
"""


@pytest.fixture(scope="module")
def sources() -> Path:
    """Checkout of the reference units."""
    pytest.importorskip("fmpy", reason="fmpy is not installed (extra fmi)")
    folder = os.environ.get("PITCHPOINT_REFERENCE_FMUS", "")
    if not Path(folder, "src", "cosimulation.c").is_file():
        pytest.skip("PITCHPOINT_REFERENCE_FMUS names no checkout of github.com/modelica/Reference-FMUs")
    if shutil.which("cc") is None or own_platform() != "x86_64-linux":
        pytest.skip("the units are built with cc for x86_64-linux")
    return Path(folder)


def build(sources: Path, name: str, version: int, folder: Path) -> Path:
    """Unit of a model."""
    library = folder / f"{name}.so"
    include = [f"-I{sources / 'include'}", f"-I{sources / name}"]
    defined = [f"-DFMI_VERSION={version}", "-DDISABLE_PREFIX", "-fvisibility=hidden"]
    parts = [sources / name / "model.c", sources / "src" / f"fmi{version}Functions.c"]
    files = [str(part) for part in (*parts, sources / "src" / "cosimulation.c")]
    command = ["cc", "-shared", "-fPIC", "-O2", *defined, *include, *files, "-o", str(library), "-lm"]
    subprocess.run(command, check=True)
    place = "linux64" if version == 2 else "x86_64-linux"
    with zipfile.ZipFile(folder / f"{name}.fmu", "w") as archive:
        archive.write(sources / name / f"FMI{version}.xml", "modelDescription.xml")
        archive.write(library, f"binaries/{place}/{name}.so")
    return folder / f"{name}.fmu"


def reference(sources: Path, name: str) -> dict[str, np.ndarray]:
    """Columns of the results that a unit ships with."""
    with open(sources / name / f"{name}_out.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {key: np.array([float(row[key]) for row in rows]) for key in rows[0]}


def run(folder: Path, file: Path, outputs: str, period: float, end: float, inputs: str = "{}") -> object:
    """Dataset with samples at the communication points; each shows the outputs of the point before."""
    text = MACHINE.replace("FILE", file.name).replace("OUTPUTS", outputs).replace("INPUTS", inputs)
    text = text.replace("PERIOD", repr(period)).replace("END", repr(end)).replace("RATE", repr(1.0 / period))
    (folder / "model.yaml").write_text(text, encoding="utf-8")
    model = pp.load_model(folder / "model.yaml", allow_code=True)
    return pp.solve_time(pp.compile_model(model, "run"))


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize(
    ("name", "variables", "period", "end"),
    [
        ("Dahlquist", ["x"], 0.1, 10.0),
        ("VanDerPol", ["x0", "x1"], 0.01, 20.0),
        ("BouncingBall", ["h", "v"], 0.01, 3.0),
        ("Stair", ["counter"], 0.2, 8.8),  # it then requests the end
    ],
)
def test_results_are_those_of_the_reference(sources, name, variables, period, end, version, tmp_path):
    file = build(sources, name, version, tmp_path)
    want = reference(sources, name)
    found = run(tmp_path, file, "{" + ", ".join(f"{v}: {v}" for v in variables) + "}", period, end)
    for variable in variables:
        got = found[f"signal[{variable}]"].values[1:]
        np.testing.assert_allclose(got, want[variable][: len(got)], rtol=1e-9, atol=1e-12)


def test_published_end_values(sources):
    """The files that are read are those of the source: Dahlquist and Van der Pol."""
    assert reference(sources, "Dahlquist")["x"][-1] == pytest.approx(2.656139888758747e-5, rel=1e-12)
    oscillator = reference(sources, "VanDerPol")
    assert oscillator["x0"][-1] == pytest.approx(2.0148418861546133, rel=1e-12)
    assert oscillator["x1"][-1] == pytest.approx(0.24419470751904407, rel=1e-12)


@pytest.mark.parametrize("version", [2, 3])
def test_values_of_all_types_pass_through(sources, version, tmp_path):
    """Real numbers, integers (rounded), Booleans and enumerations."""
    file = build(sources, "Feedthrough", version, tmp_path)
    inputs = {"Float64_continuous_input": "half", "Int32_input": "five", "Boolean_input": "one"}
    inputs |= {"Enumeration_input": "two"}
    outputs = {key.replace("input", "output"): f"out_{value}" for key, value in inputs.items()}
    texts = ["{" + ", ".join(f"{k}: {v}" for k, v in each.items()) + "}" for each in (outputs, inputs)]
    found = run(tmp_path, file, texts[0], 0.1, 0.5, texts[1])
    for name, value in (("half", 0.5), ("five", 5.0), ("one", 1.0), ("two", 2.0)):
        assert np.all(found[f"signal[out_{name}]"].values[1:] == value)


def test_arrays_are_refused_by_name(sources, tmp_path):
    file = build(sources, "StateSpace", 3, tmp_path)
    with pytest.raises(pp.ModelError, match=r"y.* array"):
        run(tmp_path, file, "{y: y}", 1.0, 10.0)
