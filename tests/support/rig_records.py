# SPDX-License-Identifier: Apache-2.0
"""Records of gear pairs with and without a damaged tooth."""

from __future__ import annotations

from pathlib import Path

import numpy as np

BROKEN_PAIR = """
gears:
  pinion: {number_of_teeth: 21, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0,
    faults: {stump: {type: broken_tooth, tooth: 12, at: end, width: 10 mm, severity: 1}}}
  wheel: {number_of_teeth: 34, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  shaft: {motion: torsion, inertia: 0.002 kg m^2, gears: [pinion]}
  output: {motion: torsion, inertia: 0.02 kg m^2, gears: [wheel]}
meshes:
  stage: {gears: [pinion, wheel], center_distance: 82.7 mm, stiffness: {law: din3990}, damping: {ratio: 0.05}}
loads:
  motor: {body: shaft, torque: balance}
  brake: {body: output, torque: 200 N m}
scenarios:
  steady: {speed: {shaft: 600 rpm}, duration: 1.6 s, settle_time: 0.2 s, sample_rate: 5003.7 Hz, step: 10 us}
"""
"""A pair 21/34 whose pinion has lost half a tooth; `severity: 0` makes it healthy."""


def rig_file(folder: Path, fault: float = 2.0, rate: float = 5000.0) -> str:
    """Two seconds of a pair 32/95 at 10 Hz, whose pinion has a damaged tooth: 0.2 turns after the start."""
    time = np.arange(int(2 * rate)) / rate
    knock = np.exp(-((((time * 10 + 0.3) % 1 - 0.5) / 0.01) ** 2)) * np.cos(2 * np.pi * 1400 * time)
    noise = 0.4 * np.random.default_rng(3).standard_normal(time.size)
    x = np.cos(2 * np.pi * 320 * time) + 0.4 * np.cos(2 * np.pi * 640 * time) + noise + fault * knock
    file = folder / "rig.csv"
    np.savetxt(file, np.c_[time, x], delimiter=",", header="time [s],acc [m/s^2]", comments="", fmt="%.7g")
    return str(file)
