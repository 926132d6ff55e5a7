# SPDX-License-Identifier: Apache-2.0
"""Case FD-WAVELET: the Db5 levels of the mining-shovel study, 6456 samples at 430.4 Hz.

Source: the study decomposes a bearing force with Db5 in five levels. Bands and lengths follow from the number
of samples and the filter length of 10; the shares of pure tones were computed independently with periodic
extension for cosines that start at 0 and are quoted to 0.1 %.
"""

from __future__ import annotations

import numpy as np
import pytest
import pywt

from pitchpoint.analysis.wavelets import wavelet_levels

RATE, SAMPLES = 430.4, 6456
T = np.arange(SAMPLES) / RATE


def shares(frequency: float) -> dict[str, float]:
    """Percent of the energy of a cosine in each level."""
    found = wavelet_levels(np.cos(2 * np.pi * frequency * T), RATE, extension="periodization")
    return dict(zip(found.names, 100.0 * found.energy_share, strict=True))


def test_filter_of_ten_coefficients() -> None:
    """Sums of a Daubechies filter, by its definition."""
    filter_ = pywt.Wavelet("db5")
    h = np.array(filter_.rec_lo)
    assert filter_.dec_len == pytest.approx(10, abs=0)
    assert filter_.vanishing_moments_psi == pytest.approx(5, abs=0)
    assert h.sum() == pytest.approx(np.sqrt(2.0), rel=1e-12)
    assert np.sum(h**2) == pytest.approx(1.0, rel=1e-12)


def test_lengths_of_the_levels() -> None:
    """Symmetric extension, exact."""
    found = wavelet_levels(np.cos(T), RATE)
    lengths = dict(zip(found.names, (c.size for c in found.coefficients), strict=True))
    assert lengths["d1"] == pytest.approx(3232, abs=0)
    assert lengths["d2"] == pytest.approx(1620, abs=0)
    assert lengths["d3"] == pytest.approx(814, abs=0)
    assert lengths["d4"] == pytest.approx(411, abs=0)
    assert lengths["d5"] == pytest.approx(210, abs=0)
    assert lengths["a5"] == pytest.approx(210, abs=0)


def test_bands_of_the_levels() -> None:
    """Powers of two below half the sample rate, exact."""
    found = wavelet_levels(T, RATE)
    band = dict(zip(found.names, found.band, strict=True))
    assert band["a5"][1] == pytest.approx(6.725, rel=1e-12)
    assert band["d5"][1] == pytest.approx(13.45, rel=1e-12)
    assert band["d4"][1] == pytest.approx(26.9, rel=1e-12)
    assert band["d3"][1] == pytest.approx(53.8, rel=1e-12)
    assert band["d2"][1] == pytest.approx(107.6, rel=1e-12)
    assert band["d1"][1] == pytest.approx(215.2, rel=1e-12)


def test_where_the_tones_of_the_gearbox_go() -> None:
    """Shares of energy, quoted to one decimal."""
    fault, slow, middle, fast = (shares(f) for f in (0.29557, 3.251271, 20.098765, 135.666667))
    assert fault["a5"] == pytest.approx(99.7, abs=0.05)
    assert slow["a5"] == pytest.approx(99.5, abs=0.05)
    assert middle["d4"] == pytest.approx(88.4, abs=0.05)
    assert middle["d3"] == pytest.approx(10.9, abs=0.05)
    assert fast["d1"] == pytest.approx(90.0, abs=0.05)
    assert fast["d2"] == pytest.approx(9.9, abs=0.05)
