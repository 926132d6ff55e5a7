# SPDX-License-Identifier: Apache-2.0
"""Energy balance of the whole NREL 5 MW turbine in a gust, with elastic blades and tower and pitch control.

Work of the air on the blades, of the generator and of the pitch drives less the losses in shaft, yaw drive,
blades and tower equals the change of the energy of motion, weight, beams and springs. Energy and losses are
computed from positions and rates of the bodies (NumPy), work from the channels of the run by Simpson's rule.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import simpson

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.energy import energy_of
from tests.support.rotors import FOLDER

DURATION, GRAVITY = 1.3, 9.80665
SHAFT, SHAFT_DAMPING, YAW, YAW_DAMPING = 8.67637e8, 6.215e6, 9.02832e9, 1.916e7


def imbalance(model, step: float) -> tuple[float, float]:
    """Energy that is not accounted for over the work of the air, and the largest pitch angle."""
    system = compile_model(model, "gust")
    begin = prepare_start(system, system.scenario)
    copy, layout = begin.system.copy(), begin.system.layout
    run = start(begin.system, begin.state, step)
    energy, power, air, pitch = [], [], [], []
    for _ in range(round(DURATION / step) + 1):
        state = run.state()
        row = evaluate.observe(copy, state)
        value = lambda name, row=row: float(row[layout.channel(name)])  # noqa: E731
        q, v = (
            {n: x[layout.coordinate(f"{n}.spin")] for n in ("hub", "generator", "nacelle")}
            for x in (state.q, state.v)
        )
        stored, lost = energy_of(copy, state, GRAVITY)
        stored += 0.5 * SHAFT * (q["hub"] - q["generator"]) ** 2 + 0.5 * YAW * q["nacelle"] ** 2
        lost += SHAFT_DAMPING * (v["hub"] - v["generator"]) ** 2 + YAW_DAMPING * v["nacelle"] ** 2
        drives = sum(value(f"signal[servo_{k}]") * value(f"signal[pitch_rate_{k}]") for k in (1, 2, 3))
        air.append(value("aerodynamic_power[rotor]"))
        energy.append(stored)
        power.append(air[-1] + value("signal[generator_torque]") * v["generator"] + drives - lost)
        pitch.append(value("signal[pitch_1]"))
        assert run.advance(1).status == 1
    rest = energy[-1] - energy[0] - simpson(power, dx=step)
    return float(rest / simpson(air, dx=step)), float(np.abs(pitch).max())


@pytest.mark.parametrize("air", [pytest.param("steady", marks=pytest.mark.study), "dynamic"])
def test_power_of_the_air_is_accounted_for(air):
    """Induction and stall steady, and as states. The error decreases at least with the square of the step."""
    changes = {
        **{f"beams.blade_{k}.pieces": 4 for k in (1, 2, 3)},
        "beams.tower.pieces": 3,
        "wind_rotors.rotor.inflow": air,
        "wind_rotors.rotor.stall": air,
        "wind_rotors.rotor.step": 0.0,  # loads are not extrapolated
        "winds.gust.gust.start": 0.0,
        "winds.gust.gust.duration": 2.0,
        "blocks.overspeed.offset": "-9.1 rpm",  # the pitch drives work too
        "blocks.speed.time_constant": 0.02,
    }
    model = load_model(FOLDER.parent / "model.yaml").replace_all(changes)
    coarse, pitch = imbalance(model, 0.005)
    fine, _ = imbalance(model, 0.00125)
    assert pitch > 0.01
    assert abs(coarse) < 1e-5
    assert abs(fine) < 6e-7
    assert coarse / fine > 12.0  # more with steady induction: 26
