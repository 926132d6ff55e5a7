# SPDX-License-Identifier: Apache-2.0
"""Wavelet levels, packets and scalograms against identities and closed forms."""

from __future__ import annotations

import numpy as np
import pytest
import pywt
from scipy.special import dawsn

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.scalogram import scalogram
from pitchpoint.analysis.wavelets import wavelet_levels, wavelet_packets

NOISE = np.random.default_rng(3).normal(size=1001) + 5.0
# dmey is a cut-off approximation of an infinite filter
FAMILIES = [name for name in pywt.wavelist(kind="discrete") if name != "dmey"]


@pytest.mark.parametrize("extension", pywt.Modes.modes)
def test_levels_add_up_to_the_signal_in_every_family(extension: str) -> None:
    """Perfect reconstruction, to the round-off of filters that are given to 12 digits."""
    for name in FAMILIES:
        levels = min(3, pywt.dwt_max_level(NOISE.size, name))
        found = wavelet_levels(NOISE, 100.0, wavelet=name, levels=levels, extension=extension)
        np.testing.assert_allclose(found.signals.sum(axis=0), NOISE, atol=1e-9, err_msg=name)
        assert found.signals.shape == (levels + 1, NOISE.size)


def test_periodised_orthogonal_wavelets_keep_the_energy() -> None:
    """Parseval: with as many coefficients as samples an orthogonal transform is a rotation."""
    x = NOISE[:960]
    for name in ("db5", "sym8", "coif2", "haar"):
        found = wavelet_levels(x, 1.0, wavelet=name, levels=5, extension="periodization")
        assert sum(np.sum(c**2) for c in found.coefficients) == pytest.approx(np.sum(x**2), rel=1e-9)
        packets = wavelet_packets(x, 1.0, wavelet=name, levels=5, extension="periodization")
        assert np.sum(packets.coefficients**2) == pytest.approx(np.sum(x**2), rel=1e-9)
        assert packets.energy_share.sum() == pytest.approx(1.0, rel=1e-12)


def test_five_vanishing_moments() -> None:
    """db5 details do not see a polynomial of fourth degree, but for the ends; those of haar do."""
    t = np.linspace(-1.0, 1.0, 512)
    polynomial = t**4 - 2.0 * t**3 + t
    fine = wavelet_levels(polynomial, 1.0, levels=2)
    rough = wavelet_levels(polynomial, 1.0, levels=2, wavelet="haar")
    assert np.abs(fine.signals[1:, 64:-64]).max() < 1e-9
    assert np.abs(rough.signals[1:, 64:-64]).max() > 1e-3


def test_mean_is_in_the_approximation_and_in_no_share() -> None:
    t = np.arange(2048) / 1024.0
    x = 1e6 + np.sin(2 * np.pi * 200.0 * t)
    found = wavelet_levels(x, 1024.0, levels=3)
    assert found.signals[0].mean() == pytest.approx(1e6, rel=1e-6)
    # 200 Hz is in detail 2, 128 to 256 Hz; the shares are those without the mean
    assert found.names[int(np.argmax(found.energy_share))] == "d2"
    np.testing.assert_allclose(
        found.energy_share, wavelet_levels(x - 1e6, 1024.0, levels=3).energy_share, atol=1e-9
    )
    assert not wavelet_levels(np.full(256, 7.0), 1.0, levels=2).energy_share.any()


def test_packets_are_in_order_of_frequency() -> None:
    """A tone in the middle of each of the 16 bands is strongest in that band."""
    t = np.arange(8192) / 1000.0
    for band in range(16):
        x = np.cos(2 * np.pi * (band + 0.5) * 31.25 * t)
        found = wavelet_packets(x, 1000.0, wavelet="db10", levels=4)
        assert int(np.argmax(found.energy_share)) == band
        assert found.band[band] == pytest.approx([band * 31.25, (band + 1) * 31.25])


@pytest.mark.parametrize("extension", ["symmetric", "periodic", "zero"])
def test_packets_are_timed_to_their_length(extension: str) -> None:
    """The middle of what an impulse leaves in the bands is off by less than the filter is long."""
    x = np.zeros(4096)
    x[1800] = 1.0
    found = wavelet_packets(x, 1000.0, levels=4, extension=extension)
    weight = np.sum(found.coefficients**2, axis=0)
    centre = np.sum(weight * found.time) / weight.sum()
    assert abs(centre - 1.8) < 9 * 15 / 1000.0


def test_scalogram_shows_amplitude_time_and_frequency() -> None:
    """A gated tone of amplitude 3: its amplitude inside, nothing outside, its frequency highest."""
    t = np.arange(8000) / 1000.0
    x = 3.0 * np.cos(2 * np.pi * 40.0 * t) * ((t > 3.0) & (t < 5.0)) + 100.0
    f = np.geomspace(10.0, 200.0, 41)
    found = scalogram(x, 1000.0, np.append(f, 40.0))
    assert found.amplitude[-1, 4000] == pytest.approx(3.0, rel=1e-3)
    assert found.amplitude[-1, 1000] < 1e-3
    assert found.frequency[int(np.argmax(found.amplitude[:, 4000]))] == pytest.approx(40.0, rel=0.04)


def test_scalogram_of_a_morlet_wavelet_has_its_gaussian_response() -> None:
    """cmorB-C answers a tone f' in the row of f by exp(-pi^2 B C^2 (f'/f - 1)^2) of its amplitude."""
    t = np.arange(6000) / 1000.0
    x = np.cos(2 * np.pi * 50.0 * t)
    rows = np.array([35.0, 42.0, 50.0, 60.0, 75.0])
    found = scalogram(x, 1000.0, rows, wavelet="cmor1.5-1.0")
    expected = np.exp(-(np.pi**2) * 1.5 * (50.0 / rows - 1.0) ** 2)
    # 1e-3: the tabulated wavelet ends at 8 of its units, and samples are straight lines between its points
    np.testing.assert_allclose(found.amplitude[:, 3000], expected, atol=1e-3)
    # half width of |psi| ~ exp(-t^2/1.5) that holds 95 %: 1.96 times its standard deviation sqrt(0.75)
    assert found.edge[2] == pytest.approx(1.96 * np.sqrt(0.75) / 50.0, rel=5e-3)


@pytest.mark.parametrize(
    ("name", "ripple"), [("mexh", 0.01), ("gaus4", 0.01), ("cgau5", 0.05), ("morl", 0.01)]
)
def test_scalograms_read_amplitudes_in_other_families(name: str, ripple: float) -> None:
    """The highest reading of a steady sine; a complex family that is not quite one-sided ripples."""
    x = 2.0 * np.sin(2 * np.pi * 50.0 * np.arange(4000) / 1000.0)
    found = scalogram(x, 1000.0, [50.0], wavelet=name)
    assert found.amplitude[0, 1500:2500].max() == pytest.approx(2.0, rel=ripple)


def test_extension_decides_what_the_ends_show() -> None:
    x = np.cos(2 * np.pi * 20.0 * np.arange(2000) / 1000.0)
    mirrored, empty = (scalogram(x, 1000.0, [20.0], extension=e) for e in ("symmetric", "zero"))
    assert mirrored.amplitude[0, 0] == pytest.approx(1.0, rel=0.02)
    # half of the wavelet g(t) exp(2 pi i t), g = exp(-t^2/B)/sqrt(pi B), t in periods of 50 samples: with its
    # middle sample, 1/2 + g(0)/50 in phase; D(2 pi sqrt(B))/sqrt(pi) 90 degrees from it, D Dawson's integral
    g = 1.0 / np.sqrt(np.pi * 1.5)
    beside = float(dawsn(2.0 * np.pi * np.sqrt(1.5))) / np.sqrt(np.pi)
    # 1e-3: tabulated wavelet, as above
    assert empty.amplitude[0, 0] == pytest.approx(np.hypot(0.5 + g / 50.0, beside), abs=1e-3)
    beyond = int(2 * mirrored.edge[0] * 1000.0)
    np.testing.assert_allclose(mirrored.amplitude[0, beyond], empty.amplitude[0, beyond], rtol=1e-3)


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda x: wavelet_levels(x, 1.0, levels=9), r"levels: 9 \(limit 1 to 6 for 1001 samples and db5\)"),
        (lambda x: wavelet_levels(x, 1.0, levels=True), "levels: True"),
        (lambda x: wavelet_levels(x, 1.0, wavelet="db55"), "'db55' is unknown; did you mean db5?"),
        (lambda x: wavelet_levels(x, 1.0, wavelet="mexh"), "'mexh' is unknown; there are "),
        (lambda x: wavelet_levels(x, 1.0, extension="symetric"), "did you mean symmetric?"),
        (lambda x: wavelet_levels(np.append(x, np.nan), 1.0), "sample 1001 is nan"),
        (lambda x: wavelet_packets(x, 0.0), "sample_rate"),
        (lambda x: scalogram(x, 100.0, [60.0]), "frequencies: 60 Hz"),
        (lambda x: scalogram(x, 100.0, [0.01]), "frequencies: 0.01 Hz"),
        (lambda x: scalogram(x, 100.0, [10.0], wavelet="cmor"), "write such as 'cmor1.5-1.0'"),
        (lambda x: scalogram(x, 100.0, [10.0], wavelet="cmor1.5"), "write such as 'cmor1.5-1.0'"),
        (lambda x: scalogram(x, 100.0, [10.0], wavelet="mexh3"), "did you mean mexh?"),
    ],
)
def test_bad_input_is_named(call, says: str) -> None:
    with pytest.raises(SignalError, match=says):
        call(NOISE)


def test_scalogram_chooses_its_rows_by_the_record() -> None:
    """Twelve to the octave from four periods in the record to below half the sample rate."""
    found = scalogram(NOISE[:800], 100.0)
    assert found.frequency[0] == pytest.approx(4.0 * 100.0 / 800.0, rel=1e-12)
    np.testing.assert_allclose(np.diff(np.log2(found.frequency)), 1.0 / 12.0, rtol=1e-9)
    assert 50.0 * 2.0 ** (-1.0 / 12.0) <= found.frequency[-1] < 50.0
    assert found.amplitude.shape == (found.frequency.size, 800)


def test_maps_too_large_for_a_machine_are_refused() -> None:
    with pytest.raises(SignalError, match=r"200 rows of 200000 samples \(limit 150 rows\)"):
        scalogram(np.arange(200_000.0), 1000.0, np.linspace(1.0, 400.0, 200))


def test_times_count_from_the_start_of_the_record() -> None:
    early, late = (wavelet_packets(NOISE, 100.0, levels=3, start=s).time for s in (0.0, 7.0))
    np.testing.assert_allclose(late - early, 7.0, rtol=1e-12)
    assert scalogram(NOISE, 100.0, [10.0], start=7.0).time[0] == pytest.approx(7.0, abs=0)


def test_a_record_shorter_than_the_filter_is_told_what_it_needs() -> None:
    with pytest.raises(SignalError, match=r"has 17 samples \(limit 18 for one level of db5\)"):
        wavelet_levels(NOISE[:17], 1.0, levels=1)
    assert wavelet_levels(NOISE[:18], 1.0, levels=1).lengths.tolist() == [13, 13]
