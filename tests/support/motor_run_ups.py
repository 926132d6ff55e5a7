# SPDX-License-Identifier: Apache-2.0
"""Closed-form vibration of a motor without gears at varying speed, with a damaged bearing or a sound one.

Not made with pitchpoint: harmonics of the shaft with random levels and phases, impacts at angles with random
slip that ring at a fixed natural frequency, and white noise. R. B. Randall, J. Antoni, Mechanical Systems and
Signal Processing 25(2), 2011, 485-520, section 2.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.turning_parts import Bearing, Shaft, TurningParts

Array = NDArray[np.float64]
RATE = 12_000.0
ORDERS = {"outer ring": 3.585, "inner ring": 5.415, "rolling element": 4.714, "cage": 0.398}
MOTOR = TurningParts((Shaft("motor", Fraction(1)),), (), (Bearing("DE", ORDERS, "motor"),))
# revolutions over time [s]; the rotation frequency [Hz] is the derivative
LAWS: dict[str, Callable[[Array], Array]] = {
    "up": lambda t: 10.0 * t + t**2,
    "down": lambda t: 30.0 * t - t**2,
    "fast": lambda t: 8.0 * t + 3.2 * t**2,
    "slow": lambda t: 24.0 * t + 0.3 * t**2,
    "wave": lambda t: 20.0 * t - 9.0 * 7.0 / (2 * np.pi) * np.cos(2 * np.pi * t / 7.0),
}


def motor_record(
    law: str, part: str = "", *, seed: int = 1, lines: int = 4, shaft: float = 0.3, seconds: float = 10.0
) -> tuple[Array, Array]:
    """Signal and revolutions of the shaft, shape (n,) each; noise has an rms of 1.

    `lines` harmonics of the shaft have a mean amplitude of `shaft`, growing with the speed.
    """
    random = np.random.default_rng(seed)
    t = np.arange(round(seconds * RATE)) / RATE
    turns = LAWS[law](t)
    speed = np.gradient(turns, t) / 20.0
    x = random.standard_normal(t.size)
    for k in range(1, lines + 1):
        level = shaft * np.exp(0.7 * random.standard_normal())
        x += level * speed * np.cos(2 * np.pi * k * turns + random.uniform(0, 2 * np.pi))
    if part:
        order = ORDERS[part]
        slip = 1.0 + random.uniform(-0.008, 0.008)
        count = int((turns[-1] - turns[0]) * order * slip) - 1
        steps = (1.0 + 0.01 * random.standard_normal(count)) / (order * slip)
        at = turns[0] + np.cumsum(steps)
        at = at[at < turns[-1]]
        place = np.interp(at, turns, np.arange(t.size))
        strength = 8.0 * np.interp(place, np.arange(t.size), speed) * random.uniform(0.7, 1.3, at.size)
        if part == "inner ring":
            strength *= 0.5 + 0.5 * np.cos(2 * np.pi * at)
        if part == "rolling element":
            strength *= 0.5 + 0.5 * np.cos(2 * np.pi * at * ORDERS["cage"])
        impacts = np.zeros(t.size)
        np.add.at(impacts, place.astype(int), strength)
        ring = np.arange(240) / RATE
        impacts = np.convolve(impacts, np.exp(-600 * ring) * np.sin(2 * np.pi * 3100 * ring))[: t.size]
        x += impacts
    return x, turns
