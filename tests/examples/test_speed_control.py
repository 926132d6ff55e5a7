# SPDX-License-Identifier: Apache-2.0
"""The example `speed-control`: characteristic values, dip, error that stays and stability by hand."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "speed-control"
WORDS = " ".join((FOLDER / "README.md").read_text(encoding="utf-8").split())
J, KP, KI, T, STEP = 0.02 + 0.4 / 4.0, 4.0, 50.0, 0.005, 40.0
WANTED = 1000.0 * math.pi / 30.0


def run(changes=None):
    model = load_model(FOLDER / "model.yaml", allow_code=True)
    system = compile_model(model.replace_all(changes or {}), "step")
    memory = Memory()
    done = run_time(system, sink=memory)
    assert done.status == 1, done.sentence
    rows = np.concatenate(memory.rows)
    return done, np.concatenate(memory.times), lambda name: rows[:, system.layout.channel(name)]


def by_hand(n, period=T, ki=KI):
    """Errors at the instants after the load step, and the torque."""
    e, s, found = 0.0, 0.0, []
    for _ in range(n):
        found.append(e)
        s += ki * period * e
        e -= period / J * (KP * e + s - STEP)
    return np.array(found)


def test_characteristic_values_and_dip():
    done, t, channel = run()
    assert done.notes == ()
    error = channel("signal[error]")
    np.testing.assert_allclose(error[t < 0.1], 0.0, atol=1e-8)  # it starts in the steady state
    at = np.rint((0.1 + T * np.arange(80)) / 1e-4).astype(int)
    e = error[at]
    wanted = by_hand(80)
    # the load rises over 0.1 ms (half of that late), and the teeth take 0.1 mrad of turn
    np.testing.assert_allclose(e, wanted, atol=0.03)
    late = e[12:50]  # the torsional vibration of the pair falls to a third from one instant to the next
    total, product = np.linalg.lstsq(np.column_stack([late[1:-1], -late[:-2]]), late[2:], rcond=None)[0]
    assert total == pytest.approx(2.0 - T / J * (KP + KI * T), abs=5e-5)
    assert product == pytest.approx(1.0 - T * KP / J, abs=5e-5)
    assert f"| {2.0 - T / J * (KP + KI * T):.5f} | {total:.4f} |" in WORDS
    assert f"| {1.0 - T * KP / J:.5f} | {product:.4f} |" in WORDS
    rpm = 30.0 / math.pi
    assert f"| {(WANTED - wanted.max()) * rpm:.1f} rpm | {(WANTED - e.max()) * rpm:.1f} rpm |" in WORDS
    torque = channel("signal[wanted]")
    assert torque[0] == pytest.approx(20.0, rel=1e-9)
    assert torque[-1] == pytest.approx(60.0, rel=1e-3)


def test_the_error_that_stays_without_an_integral():
    # 20 N m are in the integral from the start, 40 N m are left to the error
    _, _, channel = run({"controllers.loop.parameters": [KP, 0.0, 100.0]})
    assert channel("signal[error]")[-1] == pytest.approx(STEP / KP, rel=1e-3)


@pytest.mark.parametrize(("period", "grows"), [(0.045, False), (0.05, True)])
def test_the_longest_period(period, grows):
    limit = (-2.0 * KP + math.sqrt(4.0 * KP**2 + 16.0 * KI * J)) / (2.0 * KI)
    assert f"{limit * 1e3:.1f} ms" in WORDS
    changes = {
        "controllers.loop.period": period,
        "controllers.loop.parameters": [KP, KI, 1e9],
        "scenarios.step.duration": 1.5,
        "scenarios.step.step": 1e-4,
        "scenarios.step.sample_rate": 1000.0,
    }
    _, t, channel = run(changes)
    e = np.abs(channel("signal[error]"))
    early, late = e[(t > 0.2) & (t < 0.4)].max(), e[t > 1.3].max()
    assert (late > early) == grows
