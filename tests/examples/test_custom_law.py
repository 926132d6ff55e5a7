# SPDX-License-Identifier: Apache-2.0
"""The example `custom-law`: one's own Python laws give what the built-in ones give, and fail with a sentence.

The classical Runge-Kutta method takes the same steps with either law, so all signals agree to round-off. The
last digit of an angle of 2 pi is 9e-16 rad, 3e-8 N of the force at a base radius of 70 mm and 5e8 N/m, which
50 000 steps of a lightly damped vibration add up to some digits: tolerance 1e-10 of the largest value. The
implicit method agrees to what its iteration leaves.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "custom-law"
SIGNALS = (
    "mesh_force[stage]",
    "transmission_error[stage]",
    "deflection[stage]",
    "speed[driven]",
    "torque[output]",
)


def signals(file, **changes):
    model = load_model(FOLDER / file, allow_code=True)
    for path, value in changes.items():
        model = model.replace(f"scenarios.steady.{path}", value)
    system = compile_model(model, "steady")
    memory = Memory()
    done = run_time(system, sink=memory)
    rows = np.concatenate(memory.rows)
    return done, {name: rows[:, system.layout.channel(name)] for name in SIGNALS}


@pytest.mark.parametrize(("method", "tolerance"), [("rk4", 1e-10), ("generalized_alpha", 1e-9)])
def test_same_result_as_the_built_in_laws(method, tolerance):
    _, builtin = signals("builtin.yaml", method=method)
    _, custom = signals("custom.yaml", method=method)
    for name in SIGNALS:
        size = np.abs(builtin[name]).max()
        assert np.abs(custom[name] - builtin[name]).max() < tolerance * size, name


def test_power_fed_in_by_the_stiffness():
    """The slope of a user's law is taken by differences, step 1e-5: error of second order."""
    of = [
        signals(file)[0].channels["parametric_power[stage]"]["rms"]
        for file in ("builtin.yaml", "custom.yaml")
    ]
    assert of[1] == pytest.approx(of[0], rel=1e-6)


def test_fails_with_a_sentence_and_keeps_the_rest(tmp_path, capsys):
    out = tmp_path / "out.h5"
    assert run_command(["run", str(FOLDER / "broken.yaml"), "--allow-code", "-o", str(out)]) == 3
    said = capsys.readouterr().err
    assert "laws.py:broken raised ValueError: the table of the test rig ends here" in said
    assert "Traceback" not in said
    assert out.is_file()


def test_not_run_unasked(capsys):
    assert run_command(["run", str(FOLDER / "custom.yaml")]) == 2
    assert "--allow-code" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("body", "reason"),
    [("return float('nan')", "returned nan"), ("return 1.0 / (psi - psi)", "ZeroDivisionError")],
)
def test_stiffness_law_that_fails(tmp_path, capsys, body, reason):
    (tmp_path / "laws.py").write_text(
        f"def tooth_stiffness(t, psi, p):\n    if psi > 0.7:\n        {body}\n    return 4e8\n"
    )
    text = (FOLDER / "builtin.yaml").read_text()
    start = text.index("{law: fourier")
    end = text.index("\n", start)
    law = '{law: user, python: "laws.py:tooth_stiffness"}'
    (tmp_path / "model.yaml").write_text(text[:start] + law + text[end:])
    arguments = ["run", str(tmp_path / "model.yaml"), "--allow-code", "-o", str(tmp_path / "out.h5")]
    assert run_command(arguments) == 3
    said = capsys.readouterr().err
    assert "laws.py:tooth_stiffness" in said and reason in said
    with pytest.raises(SolverError):
        compile_model(load_model(tmp_path / "model.yaml", allow_code=True))
