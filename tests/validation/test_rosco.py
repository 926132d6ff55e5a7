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

import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.time import run_time
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
CASES = {
    8: (9.0944, 0.0, 19719.0, 1719.6e3),
    15: (12.1, 10.345, 43093.5, 5e6),
    20: (12.1, 17.347, 43093.5, 5e6),
}


@pytest.mark.parametrize("wind", CASES)
def test_steady_state(tmp_path: Path, wind: int) -> None:
    assert FOUND is not None and FOUND.origin is not None
    package = Path(FOUND.origin).parent
    cases = package.parent / "Examples" / "Test_Cases" / "NREL-5MW"
    for name in ("DISCON.IN", "Cp_Ct_Cq.NREL5MW.txt"):
        shutil.copy(cases / name, tmp_path)
    (tmp_path / "rotor.py").write_text(ROTOR, encoding="utf-8")
    speed, pitch, torque, power = CASES[wind]
    library = package / "lib" / "libdiscon.so"
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
