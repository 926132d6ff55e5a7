# SPDX-License-Identifier: Apache-2.0
"""A bearing force like that of a mining-shovel gearbox, as a sum of closed forms.

Three tooth meshes with harmonics, and once per turn of the pinion with 11 teeth a dip for one tooth mesh that
ends in an impact. The sample rate and the length are those of the published record, 6456 samples in 15 s.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.analysis.noise import with_white_noise

RATE = 430.4
SAMPLES = 6456
MESHES = (3.251271, 20.098765, 135.666667)
TURN = 11 / MESHES[0]
"""Period of the pinion Z5, 3.383292 s."""


def bearing_force(
    depth: float = 0.0,
    *,
    width: float = 1.0,
    impact: float = 0.5,
    start: float = 0.7,
    samples: int = SAMPLES,
) -> np.ndarray:
    """Bearing force in units of the first harmonic of the slow mesh.

    `depth` of the dip (0 is the healthy one), its `width` in tooth meshes, the `impact` at its end in depths,
    a ring-down of 15 Hz, and the `start` of the first dip in seconds.
    """
    t = np.arange(samples) / RATE
    force = np.full(samples, 20.0)
    for mesh, amplitudes in zip(MESHES, ((1.0, 0.4, 0.2), (0.5, 0.25), (0.4,)), strict=True):
        for k, amplitude in enumerate(amplitudes, 1):
            force += amplitude * np.cos(2 * np.pi * k * mesh * t + 1.1 * k + mesh)
    since = np.mod(t - start, TURN)
    length = width / MESHES[0]
    # raised cosine flanks of a tenth of the dip: force builds up over the contact, not at once
    inside = np.clip(np.minimum(since, length - since) / (0.1 * length), 0.0, 1.0)
    force -= depth * 0.5 * (1.0 - np.cos(np.pi * inside))
    after = since - length
    ring = np.where(after > 0.0, np.exp(-12.0 * after) * np.sin(2 * np.pi * 15.0 * after), 0.0)
    return force + impact * depth * ring


def noisy(force: np.ndarray, ratio: float, seed: int) -> np.ndarray:
    """With white noise, `ratio` decibels below the alternating rms of the force."""
    return with_white_noise(force, signal_to_noise=ratio, seed=seed).values
