# SPDX-License-Identifier: Apache-2.0
"""Tables of loads from text files: units, the torque over two revolutions, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.model.write import model_text
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

MODEL = """bodies:
  shaft: {motion: torsion, inertia: 1e-3 kg m^2}
loads:
  gas: {body: shaft, torque: {table: gas.csv, over: angle}}
scenarios:
  run: {drive: {shaft: {speed: 600 rpm}}, duration: 0.4 s, step: 1 ms}
"""


def model(folder, table):
    """Model with a table in a file."""
    (folder / "gas.csv").write_text(table)
    (folder / "model.yaml").write_text(MODEL)
    return load_model(folder / "model.yaml")


@pytest.mark.parametrize(
    "table",
    [
        "angle [deg], torque [N m]\n0, 0\n360, 10\n540, -4\n720, 0\n",
        "# a comment\n0 deg; 0\n1 rev; 10 N m\n\n540 deg; -4 N m\n2 rev; 0\n",
        "0 0\n6.283185307179586 10\n9.42477796076938 -4\n12.566370614359172 0\n",
    ],
    ids=["units in the first line", "units at the numbers", "SI"],
)
def test_a_table_over_two_revolutions(tmp_path, table):
    """The torque repeats after two revolutions in both directions of rotation; the model contains it."""
    found = model(tmp_path, table)
    for speed in (600.0, -600.0):
        run = solve_time(
            compile_model(found.replace("scenarios.run.drive.shaft.speed", f"{speed} rpm"), "run")
        )
        angle = np.mod(np.sign(speed) * 600.0 * math.tau / 60.0 * run["time"].values, 2.0 * math.tau)
        wanted = np.interp(angle, np.radians([0.0, 360.0, 540.0, 720.0]), [0.0, 10.0, -4.0, 0.0])
        assert run["torque[gas]"].values == pytest.approx(wanted, abs=1e-6)
    again = loads_model(model_text(found)).loads["gas"].torque
    assert again.values == found.loads["gas"].torque.values
    assert again.abscissa == pytest.approx(found.loads["gas"].torque.abscissa, rel=1e-12)


def test_a_shifted_table(tmp_path):
    """The torque of a cylinder that fires 180 deg later."""
    table = "0 deg, 0\n360 deg, 10\n540 deg, -4\n720 deg, 0\n"
    first = model(tmp_path, table)
    (tmp_path / "model.yaml").write_text(MODEL.replace("over: angle", "over: angle, shift: 180 deg"))
    later = load_model(tmp_path / "model.yaml")
    one, two = (solve_time(compile_model(m, "run"))["torque[gas]"].values for m in (first, later))
    assert two[50:] == pytest.approx(one[:-50], abs=1e-6)  # 600 rpm, 1 ms: 180 deg are 50 samples
    (tmp_path / "model.yaml").write_text(MODEL.replace("over: angle", "over: angle, shift: 1 mm"))
    with pytest.raises(ModelError, match=r"gas\.torque\.shift \(line 4\).*mm"):
        load_model(tmp_path / "model.yaml")


def test_an_angle_without_unit_is_remarked(tmp_path):
    """720 without unit are 720 rad."""
    found = model(tmp_path, "0, 0\n720, 1\n")
    (text,) = [str(each) for each in remarks_of_file(found) if "gas" in str(each)]
    assert "loads.gas.torque.table" in text and "720 rad" in text and "720 deg" in text
    assert not remarks_of_file(model(tmp_path, "angle [deg], torque [N m]\n0, 0\n720, 1\n"))


def test_bad_files_are_refused_with_their_lines(tmp_path):
    for table, message in {
        "0 deg, 1\n90 deg\n": r"gas\.torque\.table \(line 4\): there are 1 values instead of 2 .*line 2",
        "angle [deg], torque [N m]\n0, 1\n90, 2\n80, 3\n": r"line 4 of 'gas.csv' is not larger",
        "angle [deg], torque [mm]\n0, 1\n90, 2\n": r"mm.*line 2",
        "0 deg, x\n90 deg, 2\n": r"line 1",
        "0 deg, 1\n": r"has fewer than two rows",
    }.items():
        with pytest.raises(ModelError, match=message):
            model(tmp_path, table)
    (tmp_path / "gas.csv").unlink()
    with pytest.raises(ModelError, match=r"there is no file 'gas\.csv'"):
        load_model(tmp_path / "model.yaml")
