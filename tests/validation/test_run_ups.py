# SPDX-License-Identifier: Apache-2.0
"""Run-up of the gearbox of docs/diagnosis.md without its angle channel: verdict and angle of the true angle.

Oracle: the angle channel of the simulation. A mesh line changes its phase by up to pi where it crosses a
resonance, and the angle, if it follows this line, by pi over its order: a step of pi/16 for the lowest mesh
line. The rms of a step about its mean is at most half its height, pi/32 = 0.098 rad. Seen: 0.026 to 0.027 rad
(healthy) and 0.020 to 0.051 rad (broken tooth), the latter with noise as large as the signal. In `make test`
a healthy run-up is in tests/unit/cli/test_diagnose_run_up.py.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.analysis.noise import with_white_noise
from pitchpoint.analysis.speed_track import speed_track
from pitchpoint.analysis.turning_parts import train_parts
from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import read_channel
from pitchpoint.report.diagnosis.request import Request, diagnose_file

DOCS = Path(__file__).parents[2] / "docs" / "diagnosis.md"
RUN_UP = (
    "run_up: {drive: {input: {speed: 600 rpm + 120 rpm * t / (1 s)}}, duration: 10 s, settle_time: 0 s, "
    "step: 10 us, sample_rate: 20 kHz}"
)
BROKEN = "profile_shift_coefficient: 0, faults: {broken: {type: broken_tooth, severity: 0.5, tooth: 3}}"
CHANNELS = ("mesh_force[first]", "mesh_force[second]")


@pytest.fixture(scope="module", params=[pytest.param("healthy", marks=pytest.mark.study), "broken"])
def run(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, str]:
    """State and result of a run-up from 600 to 1800 rpm in 10 s."""
    model = re.search(r"```yaml\n(title: two-stage.*?)```", DOCS.read_text(encoding="utf-8"), re.S)
    assert model
    text = re.sub(r"run_up: \{.*\}", RUN_UP, model[1]).replace("amount: 80 um", "amount: 20 um")
    if request.param == "broken":
        text = re.sub(r"(z3: .*)profile_shift_coefficient: 0", rf"\1{BROKEN}", text)
    folder = tmp_path_factory.mktemp(request.param)
    (folder / "model.yaml").write_text(text, encoding="utf-8")
    result = str(folder / "run.h5")
    arguments = ["run", str(folder / "model.yaml"), "--scenario", "run_up", "-o", result, "-q"]
    assert run_command(arguments) == 0
    return request.param, result


@pytest.mark.parametrize(
    ("noise", "speeds"),
    [
        pytest.param(20.0, ("input=600..1800rpm",), marks=pytest.mark.study),
        (0.0, ("input=600..1800rpm",)),
        pytest.param(20.0, (), marks=pytest.mark.study),
        pytest.param(0.0, (), marks=pytest.mark.study),
    ],
    ids=["20.0-range", "0.0-range", "20.0-channel", "0.0-channel"],
)
def test_the_verdict_is_that_of_the_angle_channel(
    run: tuple[str, str], noise: float, speeds: tuple[str, ...]
) -> None:
    """With the range of the speed as with the angle channel."""
    state, file = run
    request = Request(file, speeds=speeds, channels=CHANNELS, noise=noise)
    found = [(one.kind, one.shaft, one.gears) for one in diagnose_file(request).diagnosis.findings]
    assert found == ([("local fault", "idler", ("z2", "z3"))] if state == "broken" else [])


@pytest.mark.parametrize("noise", [20.0, *(pytest.param(x, marks=pytest.mark.study) for x in (10.0, 0.0))])
def test_the_angle_is_within_the_phase_of_one_resonance(run: tuple[str, str], noise: float) -> None:
    _, file = run
    time, angle = (np.asarray(x) for x in read_channel(file, "angle[input]"))
    signals = {
        name: with_white_noise(np.asarray(read_channel(file, name)[1]), signal_to_noise=noise, seed=1).values
        for name in CHANNELS
    }
    rate = (time.size - 1) / (time[-1] - time[0])
    found = speed_track(signals, rate, train_parts([(32, 96), (48, 80)]), 10.0, 30.0)
    # the run starts with an impact of the resting gears
    error = (found.angle - angle)[time > 0.5]
    assert np.std(error) < np.pi / 32
