# SPDX-License-Identifier: Apache-2.0
"""Features of a record: levels of known lines, bands and residuals; angle from the phase of a mesh line."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from pitchpoint.analysis.mesh_angle import mesh_angle
from pitchpoint.analysis.orders import resample_over_angle
from pitchpoint.analysis.record_features import Feature, record_features
from pitchpoint.analysis.turning_parts import Bearing, Shaft, TurningParts, train_parts

RATE, TURNS = 400.0, 200.0
PARTS = train_parts([(20, 31)])
TURNED = np.arange(int(RATE * TURNS)) / RATE
NOISE = np.random.default_rng(1).standard_normal(TURNED.size)


def rig(turned: np.ndarray, *, knock: float = 0.0) -> np.ndarray:
    """Mesh with sidebands of both shafts; impacts of a tooth of the wheel."""
    wheel = turned * 20 / 31
    swing = 1.0 + 0.2 * np.cos(2 * np.pi * turned) + 0.1 * np.cos(2 * np.pi * wheel)
    impact = np.exp(-((((wheel + 0.3) % 1 - 0.5) / 0.004) ** 2)) * np.cos(2 * np.pi * 150 * wheel)
    return 2.0 * swing * np.cos(2 * np.pi * 20 * turned) + 0.3 * np.cos(2 * np.pi * turned) + knock * impact


def test_levels_of_lines_are_those_of_the_tones() -> None:
    found = record_features({"a": rig(TURNED) + 0.001 * NOISE}, RATE, PARTS)
    level = {(f.kind, f.part, f.detail): value for f, value in found.items()}
    assert level["mesh", "mesh 1", "harmonic 1"] == pytest.approx(10 * np.log10(2.0), abs=0.01)
    # sidebands have 0.1 and 0.05 of the amplitude 2 of the mesh
    assert level["sidebands", "mesh 1", "of shaft 1, harmonic 1"] == pytest.approx(
        10 * np.log10(0.04), abs=0.02
    )
    assert level["sidebands", "mesh 1", "of shaft 2, harmonic 1"] == pytest.approx(
        10 * np.log10(0.01), abs=0.05
    )
    assert level["shaft", "shaft 1", "order 1"] == pytest.approx(10 * np.log10(0.045), abs=0.01)
    assert level["mesh", "mesh 1", "harmonic 2"] < -60.0


def test_bands_of_white_noise_have_its_density() -> None:
    found = record_features({"a": NOISE}, RATE, PARTS, frequency=30.0)
    bands = {f.part: value for f, value in found.items() if f.kind == "band"}
    for name, low, high in (("1120 to 1410 Hz", 10**3.05, 10**3.15), ("3550 to 4470 Hz", 10**3.55, 10**3.65)):
        expected = 10 * np.log10((high - low) / (0.5 * RATE * 30.0))
        # the level of 2 T B degrees of freedom has a standard deviation of 4.34 √(2/(2 T B)) dB
        scatter = 4.34 * np.sqrt(1.5 / ((high - low) / 30.0 * TURNS))
        assert bands[name] == pytest.approx(expected, abs=4.0 * scatter)
    orders = record_features({"a": NOISE}, RATE, PARTS)
    assert any(f.part == "orders 11.2 to 14.1" for f in orders)


def test_a_damaged_tooth_changes_the_residual_of_its_gear_only() -> None:
    sound, broken = (
        {
            f.part: v
            for f, v in record_features({"a": x}, RATE, PARTS).items()
            if f.kind.startswith("residual")
        }
        for x in (rig(TURNED) + 0.3 * NOISE, rig(TURNED, knock=2.0) + 0.3 * NOISE)
    )
    change = {part: broken[part] - sound[part] for part in sound}
    assert change["Z2"] > 3.0
    assert abs(change["Z1"]) < 1.5


def test_a_wandering_speed_is_followed_by_the_mesh_line() -> None:
    # 0.08 revolutions in both directions, as measured: the residual of a constant speed is lost
    drift = 0.08 * np.sin(2 * np.pi * TURNED / 150) + 0.02 * np.sin(2 * np.pi * TURNED / 40)
    signals = {name: rig(TURNED + drift, knock=2.0) + 0.3 * NOISE for name in ("a", "b")}
    angle = mesh_angle(signals, RATE, PARTS)
    assert angle is not None
    error = angle / (2 * np.pi) - TURNED - drift
    inner = error[2000:-2000] - error[2000:-2000].mean()
    assert np.abs(inner).max() < 2e-3

    def kurtosis(values: np.ndarray, rate: float) -> float:
        """Kurtosis of the residual of the wheel [dB]."""
        return record_features({"a": values}, rate, PARTS)[Feature("a", "residual shape", "Z2", "kurtosis")]

    def over(turned: np.ndarray) -> float:
        """Kurtosis over an angle."""
        followed = resample_over_angle(signals["a"], turned)
        return kurtosis(followed.values, followed.samples_per_revolution)

    # four samples per period of the impacts: the kurtosis depends on the first angle of the grid, too
    true = 2 * np.pi * (TURNED + drift)
    exact = [over(np.r_[true[0] - shift * 2 * np.pi / RATE, true[1:]]) for shift in (0.0, 0.25, 0.5, 0.75)]
    assert min(exact) - 0.5 < over(angle) < max(exact) + 0.5
    assert kurtosis(signals["a"], RATE) < min(exact) - 3.0


def test_no_angle_without_a_clear_mesh_line() -> None:
    assert mesh_angle({"a": NOISE}, RATE, PARTS) is None
    assert mesh_angle({"a": rig(TURNED)[:1000]}, RATE, PARTS) is None


def test_bearings_without_a_known_speed_have_no_lines_of_shafts() -> None:
    bearing = Bearing("left", {"outer ring": 3.585, "inner ring": 5.415}, "rotor")
    parts = TurningParts((Shaft("rotor", Fraction(1)),), (), (bearing,))
    impacts = np.exp(-20 * (TURNED * 3.585 % 1)) * NOISE
    found = record_features({"a": impacts + 0.1 * NOISE[::-1]}, RATE, parts, tolerance=0.02)
    assert {f.kind for f in found} == {"level", "shape", "band", "bearing"}
    lines = {f.part: v for f, v in found.items() if f.kind == "bearing"}
    assert lines["outer ring of left"] > lines["inner ring of left"] + 10.0
