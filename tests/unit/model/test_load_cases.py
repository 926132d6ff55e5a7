# SPDX-License-Identifier: Apache-2.0
"""Load cases: speeds, torques and powers in place of those of the file, and what is refused."""

from __future__ import annotations

import json
import math

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.rexs.exporting.exporting import export_rexs
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.law import Balance, Constant
from pitchpoint.model.load_cases import oil_of
from pitchpoint.model.scenario import Scenario
from pitchpoint.system.compile import compile_model

TEXT = """\
gears:
  g1: {number_of_teeth: 20, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 40, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  a: {gears: [g1]}
  b: {gears: [g2]}
meshes:
  m: {gears: [g1, g2], backlash: {normal: 0.1 mm}, stiffness: {law: constant, value: 2e8}}
loads:
  motor: {body: a, torque: 50 N m}
  fan: {body: b, torque: balance}
lubricant: {grade: ISO VG 320, temperature: 60 degC}
load_cases:
  full: {speed: {a: 1500 rpm}, loads: {motor: {torque: 80 N m}},
         load_duration_fraction: 30 %, temperature: 80 degC}
  part: {speed: {b: 300 rpm}, loads: {motor: {power: 3 kW}}, load_duration_fraction: 70 %}
scenarios:
  run: {speed: {a: 900 rpm}, duration: 2 ms}
  driven: {drive: {a: {speed: 900 rpm}}, duration: 2 ms}
  roll: {quasi_static: {points: 8}}
"""
RPM = 2.0 * math.pi / 60.0


def test_the_case_in_effect_replaces_speeds_and_torques():
    model = loads_model(TEXT)
    assert model.loads["motor"].torque == Constant(50.0)
    full = model.replace("load_case", "full")
    assert full.loads["motor"].torque == Constant(80.0)
    assert full.loads["fan"].torque == Balance()
    assert full.scenarios["run"].speed == {"a": 1500.0 * RPM}
    assert full.scenarios["driven"].drive["a"].speed == Constant(1500.0 * RPM)
    assert full.scenarios["driven"].speed == {}
    assert oil_of(full).temperature == 353.15
    assert oil_of(full).dynamic_viscosity < oil_of(model).dynamic_viscosity


def test_a_power_is_divided_by_the_speed_of_the_body_of_its_load():
    """3 kW at 600 rpm of the motor, twice the 300 rpm of the fan, against its direction: -47.7 N m."""
    part = loads_model(TEXT).replace("load_case", "part")
    assert part.loads["motor"].torque.value == pytest.approx(-3000.0 / (600.0 * RPM))


def test_another_case_begins_from_the_values_of_the_file():
    """What the new case does not name is as in the file; texts are written as given."""
    text = TEXT.replace("  part:", "  hot: {temperature: 90 degC}\n  part:")
    hot = loads_model(text).replace("load_case", "full").replace("load_case", "hot")
    assert hot.loads["motor"].torque == Constant(50.0)
    assert hot.scenarios["run"].speed == {"a": 900.0 * RPM}
    assert "torque: 50 N m" in hot.to_yaml()
    assert "load_case: hot" in hot.to_yaml()
    assert loads_model(hot.to_yaml()) == hot
    assert (
        hot.replace("loads.motor.torque", 70.0).replace("load_case", None).loads["motor"].torque.value == 70.0
    )


OWN = TEXT.replace("{a: 900 rpm}, dur", "{a: 900 rpm}, load_case: full, dur").replace(
    "roll: {", "roll: {load_case: part, "
)
"""The file with a load case of its own for two of its scenarios."""


def test_a_scenario_has_its_own_load_case():
    """Its speeds are in the model, its loads and temperature in the compiled system; the case of
    --load-case takes precedence. Without load case, the scenario has the values of the file."""
    model = loads_model(OWN)
    assert model.scenarios["run"].speed == {"a": 1500.0 * RPM}
    assert model.scenarios["driven"].drive["a"].speed == Constant(900.0 * RPM)
    assert model.loads["motor"].torque == Constant(50.0)
    torques = {
        name: compile_model(model, name).model.loads["motor"].torque.value
        for name in ("run", "driven", "roll")
    }
    assert torques == {"run": 80.0, "driven": 50.0, "roll": pytest.approx(-3000.0 / (600.0 * RPM))}
    assert oil_of(compile_model(model, "run").model).temperature == 353.15
    part = model.replace("load_case", "part")
    assert part.scenarios["run"].speed == {"b": 300.0 * RPM}
    assert compile_model(part, "run").model.loads["motor"].torque.value == torques["roll"]
    assert "load_case: full" in model.to_yaml() and "a: 900 rpm" in model.to_yaml()
    assert loads_model(model.to_yaml()) == model
    other = compile_model(model, Scenario(load_case="full", duration=1.0))
    assert other.scenario.speed == {"a": 1500.0 * RPM}
    assert other.model.loads["motor"].torque.value == 80.0


def test_check_and_run_use_the_load_case_of_each_scenario(tmp_path, capsys):
    """The motor gives 80 N m at 1500 rpm, 50 N m at 900 rpm and 3 kW at 600 rpm in the other direction."""
    file = tmp_path / "pair.yaml"
    file.write_text(OWN, encoding="utf-8")
    assert run_command(["check", str(file), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    powers = {name: flow["external"][0]["power"] for name, flow in found["power_flow"].items()}
    assert powers["run"] == pytest.approx(80.0 * 1500.0 * RPM)
    assert powers["driven"] == pytest.approx(50.0 * 900.0 * RPM)
    assert powers["roll"] == pytest.approx(3000.0)
    assert found["load_cases"]["full"]["scenarios"] == ["run"]
    assert run_command(["check", str(file)]) == 0
    assert "full (in run)" in capsys.readouterr().out
    file.write_text(f"load_case: full\n{OWN}", encoding="utf-8")
    assert run_command(["check", str(file)]) == 0
    words = capsys.readouterr()
    assert "scenarios.roll.load_case (line 21): has no effect: full, load_case of the file," in words.err
    assert "full (in effect)" in words.out
    file.write_text(OWN, encoding="utf-8")
    out = str(tmp_path / "roll.h5")
    assert run_command(["run", str(file), "-s", "roll", "-o", out, "--json"]) == 0
    force = json.loads(capsys.readouterr().out)["channels"]["mesh_force[m]"]["mean"]
    assert force == pytest.approx(-3000.0 / (600.0 * RPM) / (0.02 * math.cos(math.radians(20.0))), rel=1e-6)


def test_rexs_files_have_the_loads_of_scenarios_with_a_load_case():
    """A scenario at the speeds of its load case is that case, one at others is written with its loads."""
    text = OWN.replace("  part:", "  hot: {temperature: 90 degC, loads: {motor: {torque: 20 N m}}}\n  part:")
    text += "  mine: {speed: {a: 1000 rpm}, load_case: hot, duration: 2 ms}\n"
    (spectrum,) = export_rexs(loads_model(text)).rexs.load_spectra
    values = [
        {id: one.value for found in case.components.values() for id, one in found.items()}
        for case in spectrum.cases
    ]
    assert [found["torque_around_u_axis"] for found in values] == pytest.approx([20.0, 80.0, 20.0, -47.7465])
    assert values[0]["rotational_speed"] == pytest.approx(1000.0 * RPM)
    assert "operating_time_fraction" not in values[0]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "run: {speed",
            "run: {load_case: ful, speed",
            "scenarios.run.load_case (line 18): names the load case 'ful', which does not exist; did you mean"
            " full? there are full, part",
        ),
        (
            "loads: {motor: {torque",
            "loads: {moter: {torque",
            "load_cases.full.loads.moter (line 14): moter names a load",
        ),
        (
            "speed: {a: 1500",
            "speed: {c: 1500",
            "load_cases.full.speed.c (line 14): c names a body that does not exist",
        ),
        ("70 %", "80 %", "110 % is the sum of the shares of the time (limit 100 %)"),
        ("70 %", "120 %", "load_cases.part.load_duration_fraction (line 16): '120 %' is out of range"),
        ("{power: 3 kW}", "{power: 3 kW, torque: 1 N m}", "gives torque and power together"),
        ("{power: 3 kW}", "{}", "gives neither torque nor power nor force"),
        ("speed: {b: 300 rpm}, ", "", "requires a speed of a, which is at rest in this load case"),
        (
            "speed: {b: 300 rpm}",
            "speed: {b: 300 rpm, a: 400 rpm}",
            "contradicts the other speeds and the gear ratios",
        ),
        ("load_cases:", "load_case: ful\nload_cases:", "did you mean full? there are full, part"),
        ("temperature: 80 degC", "temperature: 80", "temperature (line 15): 80 is out of range"),
        (
            TEXT[TEXT.index("  full:") : TEXT.index("  part:")],
            "  full: {}\n",
            "has neither speed nor loads nor",
        ),
        ("grade: ISO VG 320, ", "", "lubricant (line 12): has no viscosity_at_40_degree_celsius and no"),
        ("ISO VG 320", "ISO VG 330", "did you mean ISO VG 320?"),
        (
            "temperature: 60 degC",
            "temperature: 60 degC, viscosity_at_100_degree_celsius: 400 mm^2/s",
            "400 mm^2/s is not below that at 40 °C (limit < 320 mm^2/s)",
        ),
    ],
)
def test_wrong_cases_and_lubricants_are_refused(old, new, words):
    assert old in TEXT
    with pytest.raises(ModelError) as caught:
        loads_model(TEXT.replace(old, new, 1))
    assert words in str(caught.value)


def test_commands_take_one_case_or_all(tmp_path, capsys):
    """The mesh forces of a roll are T/r_b of each case."""
    file = tmp_path / "pair.yaml"
    file.write_text(TEXT, encoding="utf-8")
    out = str(tmp_path / "cases.h5")
    assert run_command(["run", str(file), "-s", "roll", "--load-cases", "-o", out, "--json"]) == 0
    cases = json.loads(capsys.readouterr().out)["cases"]
    assert [case["values"] for case in cases] == [{"load_case": "full"}, {"load_case": "part"}]
    r_b = 0.02 * math.cos(math.radians(20.0))
    forces = [case["channels"]["mesh_force[m]"]["mean"] for case in cases]
    assert forces == pytest.approx([80.0 / r_b, -3000.0 / (600.0 * RPM) / r_b], rel=1e-6)
    assert run_command(["frequencies", str(file), "--load-case", "part", "--json"]) == 0
    shafts = json.loads(capsys.readouterr().out)["shafts"]
    assert shafts["a"]["frequency"] == pytest.approx(10.0)
    assert run_command(["run", str(file), "-s", "run", "--load-case", "ful", "-o", out]) == 2
    assert "load_case (--load-case): names the load case 'ful'" in capsys.readouterr().err


def test_a_file_without_cases_says_so(tmp_path, capsys):
    file = tmp_path / "pair.yaml"
    file.write_text(TEXT[: TEXT.index("load_cases")] + TEXT[TEXT.index("scenarios") :], encoding="utf-8")
    assert run_command(["run", str(file), "-s", "run", "--load-cases"]) == 2
    assert "has no load_cases" in capsys.readouterr().err


def test_hours_instead_of_shares():
    """6000 and 2000 h are 75 and 25 %; a share next to hours has no common sum and is refused."""
    from pitchpoint.model.load_cases import shares_of_time

    text = TEXT.replace("load_duration_fraction: 70 %", "load_duration: 6000 h").replace(
        "load_duration_fraction: 30 %", "load_duration: 2000 h"
    )
    assert "6000 h" in text and "2000 h" in text
    assert shares_of_time(loads_model(text).load_cases) == {"full": 0.25, "part": 0.75}
    with pytest.raises(ModelError, match="is a share of the time, and part has a load_duration"):
        loads_model(TEXT.replace("load_duration_fraction: 70 %", "load_duration: 6000 h"))
