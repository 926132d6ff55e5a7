# SPDX-License-Identifier: Apache-2.0
"""WT-CTRL: steady states of the NREL 5 MW turbine with the controller library of ROSCO.

References: (1) the library of ROSCO 2.10.6, called directly by a rotor of one degree of freedom with the
table of power coefficients of the wheel and 4.37e7 kg m^2: the same table and input file are used here, so
that only the interface differs, and all printed digits agree. (2) J. Jonkman et al., NREL/TP-500-38060
(2009), table 7-1: pitch 10.45 and 17.47 deg at 15 and 20 m/s, with other aerodynamics (0.15 deg); rated
torque 43 093.55 N m and speed 12.1 rpm. Runs only if the wheel `rosco` is installed.
"""

from __future__ import annotations

import importlib.util
import math
import shutil
from pathlib import Path

import numpy as np
import pytest
from ruamel.yaml import YAML

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.solvers.time import run_time, solve_time
from pitchpoint.system.compile import compile_model

FOUND = importlib.util.find_spec("rosco")
pytestmark = pytest.mark.skipif(FOUND is None, reason="the wheel rosco is not installed")

ROTOR = """
from pathlib import Path

import numpy as np

lines = (Path(__file__).parent / "Cp_Ct_Cq.NREL5MW.txt").read_text().splitlines()
rows = [[float(x) for x in line.split()] for line in lines if line.strip() and not line.startswith("#")]
PITCH, RATIO, CP = np.array(rows[0]), np.array(rows[1]), np.array(rows[3:29])


def torque(t, inputs, state, parameters):
    speed, pitch = inputs
    (wind,) = parameters
    ratio = speed * 63.0 / wind
    i = min(max(np.searchsorted(RATIO, ratio) - 1, 0), RATIO.size - 2)
    low, high = (np.interp(np.degrees(pitch), PITCH, CP[k]) for k in (i, i + 1))
    cp = low + (ratio - RATIO[i]) / (RATIO[i + 1] - RATIO[i]) * (high - low)
    return 0.5 * 1.225 * np.pi * 63.0**2 * wind**3 * cp / speed
"""
MODEL = """\
bodies: {{rotor: {{motion: torsion, inertia: 43702538.057 kg m^2}}}}
sensors: {{speed: {{type: joint, coordinate: rotor, derivative: 1}}}}
blocks:
  fast: {{type: sum, inputs: {{speed: 97}}, unit: rad/s}}
  power: {{type: formula, formula: "0.944*fast*torque", inputs: [fast, torque], unit: W}}
  shaft_torque: {{type: sum, inputs: {{torque: -97, air_torque: 1}}, unit: N m}}
controllers:
  air: {{type: python, function: "rotor.py:torque", inputs: [speed, pitch], outputs: [air_torque],
    period: 50 ms, parameters: [{wind}], unit: N m}}
  turbine: {{type: discon, library: {library}, input_file: DISCON.IN,
    period: 50 ms, pitch_control: individual,
    inputs: {{generator_speed: fast, rotor_speed: speed, generator_torque: torque,
      electrical_power: power, wind_speed: {wind},
      blade_1_pitch: pitch, blade_2_pitch: pitch, blade_3_pitch: pitch}},
    outputs: {{generator_torque_demand: torque, blade_1_pitch_demand: pitch}}, start: {{pitch: {pitch}}}}}
actuators: {{shaft: {{type: torque, signal: shaft_torque, bodies: [rotor]}}}}
scenarios:
  run: {{start: assembled, speed: {{rotor: {speed} rpm}}, duration: 400 s, step: 50 ms, sample_rate: 1 Hz,
    settle_time: 390 s}}
"""
PUBLISHED = {15: 10.45, 20: 17.47}
CONTROL = """
blocks:
  wind_at_hub: {{type: input, value: 15 m/s, unit: m/s}}
  fast: {{type: sum, inputs: {{{speed}: 97}}, unit: rad/s}}
  torque: {{type: rate_limit, input: torque_demand, rate: 150 kN m/s, time_constant: 20 ms, start: 43093 N m}}
  reaction: {{type: sum, inputs: {{torque: -97}}, unit: N m}}
  power: {{type: formula, formula: "0.944*torque*fast", inputs: [torque, fast], unit: W}}
actuators:
  generator_torque: {{type: torque, signal: reaction, bodies: [generator, nacelle]}}
controllers:
  rosco: {{type: discon, library: {library}, input_file: DISCON.IN, period: 20 ms,
    inputs: {{generator_speed: fast, rotor_speed: {speed}, generator_torque: torque, electrical_power: power,
      wind_speed: wind_at_hub, blade_1_pitch: pitch_1, blade_2_pitch: pitch_2, blade_3_pitch: pitch_3}},
    outputs: {{generator_torque_demand: torque_demand, pitch_demand: demand}},
    start: {{torque_demand: 43093 N m, demand: 10.1 deg}}}}
"""
"""Control of the example `wind-turbine` by ROSCO, from the pitch of the steady state."""
EXAMPLE = Path(__file__).parents[2] / "examples" / "wind-turbine"
CASES = {
    8: (9.0944, 0.0, 19719.0, 1719.6e3),
    15: (12.1, 10.345, 43093.5, 5e6),
    20: (12.1, 17.347, 43093.5, 5e6),
}


def copied(folder: Path) -> str:
    """Copy the input files to a folder; returns the library, as it is named in a model."""
    assert FOUND is not None and FOUND.origin is not None
    package = Path(FOUND.origin).parent
    for name in ("DISCON.IN", "Cp_Ct_Cq.NREL5MW.txt"):
        shutil.copy(package.parent / "Examples" / "Test_Cases" / "NREL-5MW" / name, folder)
    return "rosco"


@pytest.mark.parametrize("wind", CASES)
def test_steady_state(tmp_path: Path, wind: int) -> None:
    library = copied(tmp_path)
    (tmp_path / "rotor.py").write_text(ROTOR, encoding="utf-8")
    speed, pitch, torque, power = CASES[wind]
    text = MODEL.format(wind=wind, library=library, pitch=0.18 * (wind > 11), speed=9 if wind < 11 else 12)
    model = loads_model(text, allow_code=True, file=str(tmp_path / "model.yaml"))
    done = run_time(compile_model(model, "run"))
    assert done.status == 1, done.sentence
    found = {name: done.channels[f"signal[{name}]"]["mean"] for name in ("speed", "pitch", "torque", "power")}
    assert found["speed"] * 30.0 / math.pi == pytest.approx(speed, rel=2e-5)
    assert math.degrees(found["pitch"]) == pytest.approx(pitch, abs=1e-3)
    if wind in PUBLISHED:
        assert math.degrees(found["pitch"]) == pytest.approx(PUBLISHED[wind], abs=0.15)
        assert found["torque"] == pytest.approx(43093.55, rel=2e-6)
    assert found["torque"] == pytest.approx(torque, rel=5e-5)
    assert found["power"] == pytest.approx(power, rel=5e-5)


def elastic_turbine(folder: Path) -> Path:
    """The turbine of the example with its pitch servos, and ROSCO instead of its own control."""
    library = copied(folder)
    shutil.copytree(EXAMPLE, folder / "turbine", dirs_exist_ok=True)
    yaml = YAML(typ="safe")
    file = folder / "turbine" / "model.yaml"
    whole = yaml.load(file)
    speed = next(n for n, part in whole["sensors"].items() if part.get("coordinate") == "generator")
    servos = {name: part for name, part in whole["blocks"].items() if name.startswith("servo_")}
    for servo in servos.values():  # the first input is the wanted pitch
        servo["inputs"] = dict(
            zip(["demand", *list(servo["inputs"])[1:]], servo["inputs"].values(), strict=True)
        )
    turned = {n: part for n, part in whole["actuators"].items() if part["signal"] in servos}
    added = yaml.load(CONTROL.format(library=library, speed=speed))
    whole |= {"blocks": servos | added["blocks"], "actuators": turned | added["actuators"]}
    whole |= {"controllers": added["controllers"]}
    whole["scenarios"] = {"rated": whole["scenarios"]["rated"]}
    whole.pop("loads", None)
    for name in ("DISCON.IN", "Cp_Ct_Cq.NREL5MW.txt"):
        shutil.copy(folder / name, folder / "turbine")
    yaml.dump(whole, file)
    return file


@pytest.mark.study
def test_elastic_turbine(tmp_path: Path) -> None:
    """The turbine of the example, with shear of the wind, starts in steady operation and remains there.

    10.1 deg is the pitch of its own control, `rated`.
    """
    model = load_model(elastic_turbine(tmp_path), allow_code=True)
    changes = {"duration": "20 s", "settle_time": "10 s", "sample_rate": "50 Hz"}
    data = solve_time(
        compile_model(model.replace_all({f"scenarios.rated.{k}": v for k, v in changes.items()}), "rated")
    )
    speed = data["speed[generator]"].values * 30.0 / math.pi
    demand, power = np.degrees(data["signal[demand]"].values), data["signal[power]"].values
    assert np.abs(speed - 12.1).max() < 0.05 and np.abs(demand - 10.1).max() < 0.15
    assert speed[500:].mean() == pytest.approx(12.1, rel=5e-4)
    assert demand[500:].mean() == pytest.approx(10.1, abs=0.1)
    assert power[500:].mean() == pytest.approx(5e6, rel=1e-3)
