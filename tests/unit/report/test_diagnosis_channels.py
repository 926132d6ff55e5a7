# SPDX-License-Identifier: Apache-2.0
"""Channels that a diagnosis uses: simulated ones that only contain errors of the solution are omitted."""

from __future__ import annotations

import numpy as np

from pitchpoint.report.diagnosis.study import RESIDUE, usable

TIME = np.arange(2000) / 2000.0
SOLVED = np.sin(2.0 * np.pi * 50.0 * TIME)
UNITS = {"x": "m/s^2", "z": "m/s^2", "force": "N", "bare": ""}


def test_errors_of_the_solution_are_no_vibration():
    noise = 4e-8 * np.random.default_rng(3).normal(size=TIME.size)
    channels = {"x": SOLVED, "z": noise, "force": 1e-3 * noise, "bare": noise}
    kept, remarks = usable(channels, TIME, UNITS)
    assert list(kept) == ["x", "force", "bare"]
    (remark,) = remarks
    assert remark.startswith("z: varies by less than 1e-06 of another channel in m/s^2")
    assert "-c z includes it" in remark


def test_small_vibration_and_measured_channels_stay():
    weak = 2.0 * RESIDUE * SOLVED
    assert list(usable({"x": SOLVED, "z": weak}, TIME, UNITS)[0]) == ["x", "z"]
    assert list(usable({"x": SOLVED, "z": 1e-9 * SOLVED}, TIME)[0]) == ["x", "z"]
