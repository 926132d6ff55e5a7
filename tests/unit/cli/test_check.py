# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint check`: what will be simulated, with which defaults."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import SolverError
from tests.support.cli_files import ISO_EX1, TORSION, json_of, written
from tests.unit.solvers.test_mean_balance import FRICTION, gearbox


def test_says_what_will_be_simulated(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = json_of(["check", written(tmp_path, TORSION)], capsys)
    assert found["ok"] is True
    assert found["degrees_of_freedom"] == 2
    assert found["bodies"]["driven"]["degrees_of_freedom"] == ["spin"]
    assert found["bodies"]["driven"]["origin"] == pytest.approx([0.15, 0.0, 0.0])
    assert found["bodies"]["driver"]["polar_inertia"] == 0.0115
    assert found["meshes"]["stage"]["stiffness"] == "fourier"
    assert found["scenarios"] == {"steady": "time", "sweep": "sweep"}
    defaults = {entry["key"]: entry["value"] for entry in found["defaults"]}
    assert defaults["scenarios.steady.settle_time"] == "20 % of duration"
    assert defaults["gears.*.material"] == "steel"
    assert "half the root diameter" in defaults["gears.*.bore_diameter"]
    assert "gears.*.profile_shift_coefficient" not in defaults


def test_people_get_tables(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, TORSION)
    assert run_command(["check", file]) == 0
    captured = capsys.readouterr()
    for text in ("no problems", "2 degrees of freedom", "150 mm", "0.0115 kg m^2", "Defaults in effect"):
        assert text in captured.out
    assert captured.err == ""
    assert run_command(["check", file, "--quiet"]) == 0
    assert capsys.readouterr().out == ""


def test_the_first_line_counts_the_warnings(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, "parameters: {a: 1 mm}\n" + TORSION)
    assert run_command(["check", file]) == 0
    captured = capsys.readouterr()
    assert captured.err.count("warning:") == 1
    assert "no errors, 1 warning" in captured.out and "no problems" not in captured.out


def test_gears_alone_are_a_model(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = json_of(["check", written(tmp_path, ISO_EX1)], capsys)
    assert found["bodies"] == {}
    assert found["meshes"]["stage"]["center_distance"] == 0.5


@pytest.mark.parametrize("text", ["gears: [", "\tgears: 1", "a: 1\na: 2", "gears: {g: 3}", ""])
def test_broken_files_exit_2(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code = run_command(["check", written(tmp_path, text)])
    captured = capsys.readouterr()
    assert code == 2 or (text == "" and code == 0)
    assert "Traceback" not in captured.err


def test_unreadable_files_exit_2(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "model.yaml"
    path.write_bytes(b"title: \xff\xfe\x00")
    assert run_command(["check", str(path)]) == 2
    assert "UTF-8" in capsys.readouterr().err
    assert run_command(["check", str(tmp_path)]) == 2


BALANCED = {
    "constant": ('"100 N m"', "", "the loads at the start"),
    "wave": ('"100*(1 + 0.5*sin(angle))"', "", "the mean torque of out over its period of 120 ms"),
    "friction": (
        '"100 N m"',
        FRICTION,
        "the loads at the start, and flank friction over one mesh cycle (2 ms)",
    ),
}


@pytest.mark.parametrize("name", BALANCED)
def test_a_balancing_torque_is_printed_with_what_it_balances(name, tmp_path, capsys):
    law, friction, words = BALANCED[name]
    file = written(tmp_path, gearbox(law, friction=friction))
    found = json_of(["check", file, "--balance"], capsys)["balance"]["scenarios"]["run"]
    assert found["balance"] == words
    loss = 0.0 if not friction else 2e-2
    assert found["torques"]["in"] == pytest.approx(100.0 / 3.0, rel=loss or 1e-5)
    assert run_command(["check", file, "--balance"]) == 0
    assert f"torque: balance in run: in {found['torques']['in']:.5g} N m; {words}" in " ".join(
        capsys.readouterr().out.split()
    )


def test_quiet_prints_the_torques_that_were_asked_for(tmp_path, capsys):
    file = written(tmp_path, gearbox("100 N m"))
    assert run_command(["check", file, "--balance", "-q"]) == 0
    out = capsys.readouterr().out
    assert out == "torque: balance in run: in 33.333 N m; the loads at the start\n"
    assert run_command(["check", file, "-q"]) == 0
    assert capsys.readouterr().out == ""


UNSOLVED = {
    "constant": "the loads at the start",
    "wave": "the loads at the start and the mean of out over its period if it repeats over angle or time",
    "friction": "the loads at the start and the mean of flank friction over the mesh cycle",
}


@pytest.mark.parametrize("name", UNSOLVED)
def test_what_a_torque_balances_is_printed_without_solving(name, tmp_path, capsys, monkeypatch):
    def compiled(*_):
        raise AssertionError("check compiles the model")

    monkeypatch.setattr("pitchpoint.system.compile.compile_model", compiled)
    law, friction, _ = BALANCED[name]
    file = written(tmp_path, gearbox(law, friction=friction))
    assert json_of(["check", file], capsys)["balance"] == {"loads": ["in"], "balance": UNSOLVED[name]}
    assert run_command(["check", file]) == 0
    words = f"torque: balance: in balances {UNSOLVED[name]}; values with --balance"
    assert words in " ".join(capsys.readouterr().out.split())


def test_balance_is_refused_without_a_load_or_a_scenario(tmp_path, capsys):
    balanced = gearbox("100 N m")
    for text, words in (
        (gearbox("-3 N m", driver="1 N m"), "--balance has no effect without a load with torque: balance"),
        (
            balanced[: balanced.index("scenarios:")],
            "--balance has no effect without a time or quasi-static scenario",
        ),
    ):
        assert run_command(["check", written(tmp_path, text), "--balance"]) == 2
        assert words in " ".join(capsys.readouterr().err.split())


def test_a_torque_that_is_not_found_ends_with_code_3(tmp_path, capsys, monkeypatch):
    def fails(*_):
        raise SolverError("no equilibrium", 2)

    monkeypatch.setattr("pitchpoint.solvers.initial_state.start.prepare_start", fails)
    file = written(tmp_path, gearbox("100 N m"))
    assert run_command(["check", file, "--balance"]) == 3
    assert "torque: balance in run: not found; no equilibrium" in capsys.readouterr().out


def test_the_power_flow_comes_first(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, TORSION)
    assert run_command(["check", file]) == 0
    shown = capsys.readouterr().out
    places = [
        shown.index(words)
        for words in ("no problems", "Power flow in", "Meshes", "--drawing", "Bodies", "Defaults in effect")
    ]
    assert places == sorted(places)


def test_one_scenario_of_the_power_flow(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, TORSION)
    assert set(json_of(["check", file], capsys)["power_flow"]) == {"steady", "sweep"}
    flow = json_of(["check", file, "-s", "steady"], capsys)["power_flow"]
    assert set(flow) == {"steady"}
    steady = flow["steady"]
    assert steady["power_out"] == pytest.approx(steady["power_in"], rel=1e-12)
    assert run_command(["check", file, "-s", "standstill"]) == 2
    assert "no scenario 'standstill'" in capsys.readouterr().err


def test_defaults_are_listed_by_component(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One row per component, with all keys of the JSON list."""
    file = written(tmp_path, TORSION)
    entries = json_of(["check", file], capsys)["defaults"]
    assert run_command(["check", file]) == 0
    shown = " ".join(capsys.readouterr().out.split("Defaults in effect")[1].split())
    for entry in entries:
        key = entry["key"].split(".", 2)[-1]
        assert f"{key}:" in shown, key
