# SPDX-License-Identifier: Apache-2.0
"""Operating range of a body: the whole range of drives, ripples and sweeps, through gear ratios."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.campbell import body_of_speeds, campbell_of, highest_speed
from pitchpoint.report.operating_range import operating_range, speed_range
from tests.support.planet_stages import stage_file

RPM = np.pi / 30.0
TEXT = """
gears:
  g1: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  driver: {gears: [g1], inertia: 2e-4 kg m^2}
  driven: {gears: [g2], inertia: 0.0115 kg m^2}
meshes:
  stage: {gears: [g1, g2], stiffness: {law: constant, value: 4.0e8 N/m}, damping: {ratio: 0.05}}
loads:
  output: {body: driven, torque: 15 N m}
  input: {body: driver, torque: balance}
scenarios:
"""
SCENARIOS = {
    "steady": ("{speed: {driver: 1500 rpm}, duration: 20 ms}", (1500.0, 1500.0)),
    "table": ("{drive: {driver: {speed: {table: [[0 s, 600 rpm], [1 s, 1800 rpm]]}}}, duration: 1 s}", None),
    # a peak between the times at which formulas are evaluated
    "peak": (
        "{drive: {driver: {speed: {table: [[0, 900 rpm], [0.5001234 s, 2000 rpm], [1 s, 900 rpm]]}}}, "
        "duration: 1 s}",
        (900.0, 2000.0),
    ),
    "ramp": (
        '{drive: {driven: {speed: "100 rpm + 200 rpm/s * t"}}, speed: {driver: 9 rpm}, duration: 1 s}',
        (250.0, 750.0),
    ),
    "coast": ('{drive: {driven: {angle: "10*pi*t - 5*pi*t^2"}}, duration: 1 s}', (0.0, 750.0)),
    "reversal": ('{drive: {driver: {speed: "900 rpm * cos(2*pi*1 Hz*t)"}}, duration: 0.5 s}', (0.0, 900.0)),
    "ripple": (
        "{drive: {driver: {speed: 1000 rpm, ripple: {two: {order: 2, fluctuation: 4 %}}}}, duration: 1 s}",
        (980.0, 1020.0),
    ),
    "sweep": ("{sweep: {body: driver, mesh_frequency: [200 Hz, 500 Hz], points: 3}}", (600.0, 1500.0)),
    "down": ("{sweep: {body: driven, speed: [200 rpm, 800 rpm], points: 3}}", (500.0, 2000.0)),
}


@pytest.fixture(scope="module")
def model() -> pp.Model:
    return loads_model(TEXT + "".join(f"  {name}: {text}\n" for name, (text, _) in SCENARIOS.items()))


def test_the_whole_range_of_drives_ripples_and_sweeps_counts(model: pp.Model) -> None:
    system = pp.compile_model(model)
    for name, (_, expected) in SCENARIOS.items():
        found = np.array(speed_range(system, model.scenarios[name], "driver")) / RPM
        assert found == pytest.approx(expected or (600.0, 1800.0), rel=1e-3, abs=0.5), name
    assert operating_range(system, "driver", [model.scenarios["steady"]]) == pytest.approx((1500 * RPM,) * 2)
    low, high = operating_range(system, "driven") or (-1.0, -1.0)
    assert (low / RPM, high / RPM) == pytest.approx((0.0, 800.0), abs=0.5)


def test_two_driven_members_of_a_planetary_stage_count_together() -> None:
    """Sun at 1000 rpm and ring from 0 to 300 rpm: the carrier has (21 n_s + 99 n_r)/120."""
    drives = "sun: {speed: 1000 rpm}, ring: {speed: {table: [[0 s, 0 rpm], [1 s, 300 rpm]]}}"
    text = stage_file().replace("motion: fixed", "inertia: 1 kg m^2")
    model = loads_model(f"{text}  sum: {{drive: {{{drives}}}, duration: 1 s}}\n")
    low, high = speed_range(pp.compile_model(model, "sum"), model.scenarios["sum"], "carrier")
    assert (low / RPM, high / RPM) == pytest.approx((175.0, 422.5), rel=1e-9)


def test_without_a_scenario_the_mesh_frequency_ends_the_diagram(model: pp.Model) -> None:
    bare = loads_model(TEXT.partition("scenarios:")[0])
    system = pp.compile_model(bare)
    assert operating_range(system, "driver") is None
    assert highest_speed(system, "driver", np.array([2500.0])) / RPM == pytest.approx(1.2 * 7500.0)


def test_a_run_up_through_a_critical_speed_is_in_range(
    model: pp.Model, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Once per tooth of the driver, the mesh excites the wheel within the range of the run-up."""
    data = campbell_of(model, "table")
    assert data.attrs["operating_speed"] == pytest.approx([600.0 * RPM, 1800.0 * RPM])
    frequency = np.sqrt(4e8 * (0.075 * np.cos(np.radians(20.0))) ** 2 / 0.0115) / (2.0 * np.pi)
    speed = frequency * 60.0 / 20.0
    ramp = f"  through: {{drive: {{driver: {{speed: {{table: [[0, 600 rpm], [1 s, {1.5 * speed} rpm]]}}}}}}, "
    path = tmp_path / "pair.yaml"
    path.write_text(TEXT + ramp + "duration: 1 s}\n", encoding="utf-8")
    assert run_command(["campbell", str(path), "-s", "through", "--json", "-q"]) == 0
    rows = json.loads(capsys.readouterr().out)["critical_speeds"]
    first = next(row for row in rows if row["order"] == "mesh stage")
    assert first["speed"] / RPM == pytest.approx(speed, rel=1e-3)
    assert first["separation"] == 0.0


@pytest.mark.parametrize(
    ("scenario", "body"),
    [
        ("{speed: {carrier: 20 rpm}, duration: 1 s}", "carrier"),
        ("{drive: {carrier: {speed: 20 rpm}}, duration: 1 s}", "carrier"),
        ("{drive: {sun: {speed: 0 rpm}, carrier: {speed: 20 rpm}}, duration: 1 s}", "carrier"),
        ("{drive: {sun: {angle: 0 deg}, carrier: {angle: '2 * t * 1 rad/s'}}, duration: 1 s}", "carrier"),
        ("{sweep: {body: sun, speed: [20 rpm, 40 rpm], points: 2}}", "sun"),
        ("{duration: 1 s}", "sun"),  # no speed: the first body in mesh that is no planet
    ],
)
def test_the_reference_speed_is_that_of_the_scenario(scenario: str, body: str) -> None:
    """Planets precede shafts in a model; their speed is that relative to the carrier."""
    text = stage_file()
    text = text[: text.index("scenarios:")] + f"scenarios:\n  s: {scenario}\n"
    model = loads_model(text)
    assert body_of_speeds(model) == body_of_speeds(model, [model.scenarios["s"]]) == body


def test_gears_on_shafts_come_before_planets() -> None:
    shaft = "shafts:\n  sun:\n    sections: [{length: 50 mm, diameter: 40 mm}]\n    gears: {sun: 25 mm}\n"
    text = stage_file("planets: 3\nmotion: planar\nbearing: {stiffness: {radial: 5e8 N/m}}")
    body = next(line for line in text.splitlines() if line.startswith("  sun: {gears"))
    text = text.replace(body + "\n", "")
    text = text[: text.index("scenarios:")] + shaft + "bearings: {a: {body: sun, stiffness: {radial: 1e8}}}\n"
    model = loads_model(text)
    assert list(model.bodies).index("planet_1") < list(model.bodies).index("sun")
    assert body_of_speeds(model) == "sun"
