# SPDX-License-Identifier: Apache-2.0
"""The detectors of gear damage, each against its published definition in closed form.

Frame: one revolution of the averaged shaft, orders of this shaft; no signs are compared. Numbers are
derived here from the definitions in the papers. The average of a shaft without tacho, of a run-up and of
gear trains is tested in tests/unit/analysis/test_synchronous_average.py.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.gear_indicators import gear_indicators, na4, nb4
from pitchpoint.analysis.gear_signals import gear_signals, mesh_envelope
from pitchpoint.analysis.synchronous_average import synchronous_average

TAU = 2.0 * np.pi
SAMPLES = 4096
ANGLE = TAU * np.arange(SAMPLES) / SAMPLES


@pytest.mark.parametrize("turns", [8, 25, 64])
@pytest.mark.parametrize("order", [5.3, 5.02, 12.48])
def test_attenuation_of_a_tone_between_the_orders(turns: int, order: float) -> None:
    """P. D. McFadden, A revised model for the extraction of periodic waveforms by time domain averaging,
    Mechanical Systems and Signal Processing 1(1), 1987, 83-95.

    The average of N revolutions of a tone with o periods per revolution is the tone times |sin(πNo)/(N
    sin(πo))|. The mean square over the revolution is compared with that of the same tone in one revolution.
    Tolerance: spline interpolation between 200 samples per revolution, 12 per period and more: 1e-3 of the
    tone.
    """
    turned = TAU * np.arange(200 * turns + 1) / 200
    # phase at the middle of the record: the sum over the revolutions is symmetric
    tone = np.cos(order * turned + 0.4)
    found = synchronous_average(tone, turned, samples_per_turn=512)
    assert found.averages == turns
    middle = np.cos(order * (found.angle + np.pi * (turns - 1)) + 0.4)
    gain = np.sin(np.pi * turns * order) / (turns * np.sin(np.pi * order))
    worst = float(np.abs(found.values - gain * middle).max())
    assert worst == pytest.approx(0.0, abs=1e-3)
    rms = float(np.sqrt(np.mean(found.values**2)))
    assert rms == pytest.approx(abs(gain) * float(np.sqrt(np.mean(middle**2))), abs=1e-3)


@pytest.mark.parametrize(
    ("name", "gaussian", "sine"), [("fm4", 3, 1.5), ("m6a", 15, 2.5), ("m8a", 105, 4.375)]
)
def test_moments_of_the_difference_signal(name: str, gaussian: float, sine: float) -> None:
    """R. M. Stewart, University of Southampton, 1977; H. R. Martin, Proceedings of the 7th International
    Modal Analysis Conference, 1989, 1016-1021; J. J. Zakrajsek, D. P. Townsend, H. J. Decker, NASA TM
    105950, 1993.

    Standardised moments of order 2k of the difference signal: (2k - 1)!! of Gaussian noise, (2k)!/(k!² 2^k)
    of a sine. Gears on the shaft add mesh lines and first-order sidebands, which are removed. Tolerance:
    four standard deviations of 64 averages of 4096 points, Var = (4k - 1)!! - (2k - 1)!!² times n for
    independent points, times two for the lines that are removed; 1e-9 of the sine.
    """
    k = {"fm4": 2, "m6a": 3, "m8a": 4}[name]
    rng = np.random.default_rng(1)
    mesh = (1.0 + 0.2 * np.cos(ANGLE)) * np.cos(23 * ANGLE) + 0.4 * np.cos(46 * ANGLE + 1.0)
    found = [
        getattr(gear_indicators(mesh + 0.1 * rng.standard_normal(SAMPLES), teeth=23), name) for _ in range(64)
    ]
    odd = float(np.prod(np.arange(4 * k - 1, 0, -2.0)))
    spread = np.sqrt(2.0 * (odd - gaussian**2) / (64 * SAMPLES))
    mean = float(np.mean(found))
    assert mean == pytest.approx(gaussian, abs=4.0 * spread)
    pure = getattr(gear_indicators(mesh + 0.1 * np.cos(7 * ANGLE), teeth=23), name)
    assert pure == pytest.approx(sine, rel=1e-9)


def test_moments_of_one_damaged_tooth() -> None:
    """The same definitions for a vibration during one of z pitches, whose amplitude is a half sine.

    It has the moments of a sine, 1.5 and 2.5, times those of its amplitude over z pitches, z (3/8)/(1/2)²
    and z² (5/16)/(1/2)³. The removed lines k z and k z ± 1 are the share (1 + 2 cos 2πj/z)/z of the same
    vibration at the tooth j, so that r_j = δ_j0 - (1 + 2 cos 2πj/z)/z remains there: the moments are those
    times Σ r⁴/(Σ r²)² and Σ r⁶/(Σ r²)³. Tolerance: the order 2 of the shaft, which is removed as well,
    1e-3.
    """
    z, j = 16, np.arange(16)
    burst = np.where(ANGLE < TAU / z, np.sin(0.5 * z * ANGLE) * np.cos(10 * z * ANGLE), 0.0)
    found = gear_indicators(np.cos(z * ANGLE) + 0.3 * burst, teeth=z)
    left = (j == 0) - (1.0 + 2.0 * np.cos(TAU * j / z)) / z
    square = np.sum(left**2)
    fm4 = 1.5 * z * (3 / 8) / (1 / 2) ** 2 * float(np.sum(left**4) / square**2)
    m6a = 2.5 * z**2 * (5 / 16) / (1 / 2) ** 3 * float(np.sum(left**6) / square**3)
    assert found.fm4 == pytest.approx(fm4, rel=1e-3)
    assert found.m6a == pytest.approx(m6a, rel=1e-3)


def test_parts_of_an_average() -> None:
    """Stewart 1977 and Zakrajsek 1993: regular signal of the mesh and the lowest orders, residual with
    first-order sidebands, difference without. Closed form: modulation with the depth m once per revolution
    gives two sidebands of m/2, with the rms m/2. Tolerance: rounding."""
    m, second = 0.3, 0.05
    x = (1.0 + m * np.cos(ANGLE)) * np.cos(20 * ANGLE) + second * np.cos(22 * ANGLE)
    parts = gear_signals(x, teeth=20)
    regular, residual, difference = (
        float(np.sqrt(np.mean(p**2))) for p in (parts.regular, parts.residual, parts.difference)
    )
    assert regular == pytest.approx(np.sqrt(0.5), rel=1e-12)
    assert residual == pytest.approx(np.sqrt(0.5 * second**2 + 0.25 * m**2), rel=1e-12)
    assert difference == pytest.approx(second * np.sqrt(0.5), rel=1e-12)


@pytest.mark.parametrize("growth", [2.0, 4.0])
def test_na4_grows_with_the_damage_and_its_reference_does_not(growth: float) -> None:
    """J. J. Zakrajsek, D. P. Townsend, H. J. Decker, NASA TM 105950, 1993 (NA4); H. J. Decker, R. F.
    Handschuh, J. J. Zakrajsek, NASA TM 106553, 1994 (NA4*): mean fourth power of the residual over the
    squared mean variance of all records so far, or of the good ones.

    Closed form: M records of a sine, the last g times as large: 1.5 g⁴ (M/(M - 1 + g²))², or 1.5 g⁴ with
    the good records as reference. NB4 (NASA TM 106467) is the same of the envelope. FM4 of the last record
    alone is 1.5, as before: a fault that grows everywhere does not change it. Tolerance: rounding.
    """
    count, last = 6, 5
    records = [
        np.cos(20 * ANGLE) + (growth if k == last else 1.0) * 0.1 * np.cos(7 * ANGLE) for k in range(count)
    ]
    running, fixed = na4(records, teeth=20).value[-1], na4(records, teeth=20, good_records=5).value[-1]
    expected = 1.5 * growth**4
    assert running == pytest.approx(expected * (count / (count - 1 + growth**2)) ** 2, rel=1e-9)
    assert fixed == pytest.approx(expected, rel=1e-9)
    fm4 = gear_indicators(records[-1], teeth=20).fm4
    assert fm4 == pytest.approx(1.5, rel=1e-9)
    modulated = [
        (1.0 + 0.1 * (growth if k == last else 1.0) * np.cos(3 * ANGLE)) * np.cos(20 * ANGLE)
        for k in range(count)
    ]
    of_envelope = nb4(modulated, teeth=20).value[-1]
    assert of_envelope == pytest.approx(expected * (count / (count - 1 + growth**2)) ** 2, rel=1e-9)


def test_demodulation_of_a_mesh_harmonic() -> None:
    """P. D. McFadden, Detecting fatigue cracks in gears by amplitude and phase demodulation of the meshing
    vibration, Journal of Vibration, Acoustics, Stress, and Reliability in Design 108(2), 1986, 165-170.

    The analytic signal of the band about a mesh harmonic is a (1 + m(θ)) exp(i(kzθ + φ(θ))): its magnitude
    is the amplitude modulation. A crack is a dip of both at one angle; the phase does not change the
    magnitude. Tolerance: content of the Gaussian dip beyond half the mesh order, exp(-(20·0.35)²/4) = 5e-6,
    with that of the phase 1e-4.
    """
    z, centre, width = 40, 2.0, 0.35
    dip = np.exp(-(((ANGLE - centre) / width) ** 2))
    x = 1.7 * (1.0 - 0.4 * dip) * np.cos(2 * z * ANGLE + 0.3 * dip + 0.8) + np.cos(z * ANGLE)
    envelope = mesh_envelope(x, teeth=z, harmonic=2)
    worst = float(np.abs(envelope - 1.7 * (1.0 - 0.4 * dip)).max())
    assert worst == pytest.approx(0.0, abs=1e-4)
    least = float(ANGLE[np.argmin(envelope)])
    assert least == pytest.approx(centre, abs=TAU / SAMPLES)
