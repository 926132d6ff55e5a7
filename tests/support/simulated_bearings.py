# SPDX-License-Identifier: Apache-2.0
"""Records of simulated machines with rolling bearings, of random geometry, speed, structure and disturbances.

Every machine has its own bearing, speed, sample rate, resonances, tones and coloured noise; in a record one
part of the bearing is damaged, or none. Nothing of it comes from the diagnosis: the impacts follow from the
kinematics of the bearing, the load zone and random slip.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from pitchpoint.analysis.turning_parts import Bearing, Shaft, TurningParts

PARTS = ("", "outer ring", "inner ring", "rolling element")
RATES = (12_000.0, 12_800.0, 20_000.0, 25_600.0)


@dataclass(frozen=True)
class BearingMachine:
    """Simulated machine: bearing, speed [Hz], sample rate [Hz], resonances [Hz] and their damping ratios."""

    orders: dict[str, float]
    speed: float
    sample_rate: float
    resonances: np.ndarray
    damping: np.ndarray
    tones: np.ndarray
    colour: float
    pump: float

    @property
    def parts(self) -> TurningParts:
        """Rotor with its bearing."""
        return TurningParts((Shaft("rotor", Fraction(1)),), (), (Bearing("bearing", self.orders, "rotor"),))

    def record(self, part: str, level: float, seed: int, seconds: float = 6.0) -> np.ndarray:
        """Acceleration with a damaged part, its impacts `level` dB above noise and tones together."""
        rng = np.random.default_rng(seed)
        count = int(seconds * self.sample_rate)
        t = np.arange(count) / self.sample_rate
        speed = self.speed * (1.0 + rng.uniform(-0.01, 0.01))
        x = self._background(t, speed, rng)
        if part:
            knocks = self._response(self._impacts(part, speed, t, rng), rng)
            x += knocks * (10.0 ** (0.05 * level) * x.std() / knocks.std())
        return x

    def _background(self, t: np.ndarray, speed: float, rng: np.random.Generator) -> np.ndarray:
        """Coloured noise, tones of the shaft, and noise that a pump or fan modulates with the speed."""
        white = rng.standard_normal((2, t.size))
        line = np.fft.rfftfreq(t.size)
        shape = 1.0 / (1.0 + (line / 0.08) ** self.colour)
        noise = np.fft.irfft(np.fft.rfft(white[0]) * shape, t.size)
        x = noise / noise.std()
        angle = 2.0 * np.pi * speed * t
        x += sum(a * np.cos(k * angle + rng.uniform(0.0, 6.3)) for k, a in enumerate(self.tones, 1))
        flow = np.fft.irfft(np.fft.rfft(white[1]) * self._gain(line * self.sample_rate), t.size)
        return np.asarray(x + self.pump * (1.0 + 0.5 * np.cos(angle)) * flow / flow.std())

    def _impacts(self, part: str, speed: float, t: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        """Impulses at the rate of the part, with slip and the load zone."""
        order = self.orders[part] * (1.0 + rng.uniform(-0.01, 0.005))
        slip = rng.uniform(0.001, 0.02)
        when = np.cumsum(rng.normal(1.0, slip, int(t[-1] * speed * order))) / (speed * order)
        when = when[when < t[-1]]
        through = {"inner ring": 1.0, "rolling element": self.orders["cage"]}.get(part, 0.0)
        size = 1.0 + 0.2 * np.cos(2.0 * np.pi * speed * when)
        if through:
            load = np.maximum(np.cos(2.0 * np.pi * speed * through * when), 0.0)
            size = rng.uniform(0.05, 0.4) + load
        impulse = np.zeros(t.size)
        np.add.at(
            impulse,
            (when * self.sample_rate).astype(np.int64),
            size * rng.uniform(0.6, 1.4, when.size),
        )
        return impulse

    def _response(self, impulse: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        """Acceleration at the sensor."""
        line = np.fft.rfftfreq(impulse.size, 1.0 / self.sample_rate)
        return np.fft.irfft(np.fft.rfft(impulse) * self._gain(line), impulse.size)

    def _gain(self, frequency: np.ndarray) -> np.ndarray:
        """Frequency response of the structure, acceleration over force."""
        gain = np.zeros(frequency.size, dtype=np.complex128)
        for k, (f, d) in enumerate(zip(self.resonances, self.damping, strict=True)):
            ratio = frequency / f
            gain += (-1.0) ** k * ratio**2 / (1.0 - ratio**2 + 2j * d * ratio)
        return gain


def bearing_machine(seed: int) -> BearingMachine:
    """One of the simulated machines."""
    rng = np.random.default_rng([seed, 21])
    balls, ratio = int(rng.integers(7, 15)), rng.uniform(0.15, 0.27)
    small = ratio * np.cos(np.radians(rng.choice([0.0, 15.0])))
    orders = {
        "outer ring": 0.5 * balls * (1.0 - small),
        "inner ring": 0.5 * balls * (1.0 + small),
        "rolling element": (1.0 - small**2) / ratio,
        "cage": 0.5 * (1.0 - small),
    }
    rate = float(rng.choice(RATES))
    return BearingMachine(
        orders=orders,
        speed=float(rng.uniform(15.0, 50.0)),
        sample_rate=rate,
        resonances=rate * np.sort(rng.uniform(0.05, 0.45, 3)),
        damping=rng.uniform(0.01, 0.05, 3),
        tones=rng.uniform(0.0, 1.5, 12) * rng.integers(0, 2, 12),
        colour=float(rng.uniform(0.0, 3.0)),
        pump=float(rng.uniform(0.0, 1.0)),
    )
