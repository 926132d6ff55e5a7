# SPDX-License-Identifier: Apache-2.0
"""Order tracking and time-frequency maps on chirps, whose orders and amplitudes are known."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.dataset import analyse
from pitchpoint.analysis.orders import order_map, resample_over_angle, tracked_spectrum
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.spectra import amplitude_spectrum, largest_peaks, order_spectrum
from pitchpoint.analysis.time_frequency import time_frequency_map


def run_up(n: int = 60001) -> tuple[np.ndarray, np.ndarray]:
    """Time and angle of a run-up from 1 to 9 revolutions per second."""
    t = np.linspace(0.0, 8.0, n)
    return t, 2.0 * np.pi * (t + 0.5 * t**2)


def test_orders_are_sharp_where_frequencies_smear() -> None:
    t, angle = run_up()
    x = 2.0 * np.cos(23 * angle) + 0.5 * np.cos(46 * angle)
    signal = resample_over_angle(x, angle, samples_per_revolution=256)
    revolutions = signal.values.size // 256 * 256
    peaks = largest_peaks(order_spectrum(signal.values[:revolutions], 256), 2)
    assert [(round(o, 6), round(a, 2)) for o, a in peaks] == [(23.0, 2.0), (46.0, 0.5)]
    rate = (t.size - 1) / (t[-1] - t[0])
    assert amplitude_spectrum(x, rate).amplitude.max() < 0.2


def test_content_above_the_grid_does_not_fold_back() -> None:
    """Order 100 sampled 64 times per revolution would appear as order 28."""
    _, angle = run_up()
    signal = resample_over_angle(np.cos(100 * angle), angle, samples_per_revolution=64)
    middle = signal.values[400:-400]
    assert np.abs(middle).max() < 0.02


def test_clockwise_rotation_counts_backwards() -> None:
    _, angle = run_up(20001)
    forward = resample_over_angle(np.cos(5 * angle), angle, samples_per_revolution=64)
    backward = resample_over_angle(np.cos(5 * angle), -angle, samples_per_revolution=64)
    np.testing.assert_allclose(backward.values, forward.values)
    np.testing.assert_allclose(backward.angle, -forward.angle)


def test_default_grid_invents_nothing() -> None:
    _, angle = run_up(4001)
    signal = resample_over_angle(np.cos(angle), angle)
    assert signal.samples_per_revolution == pytest.approx(2 * np.pi / np.diff(angle).max(), rel=0.02)


def test_a_shaft_that_turns_back_is_refused() -> None:
    t = np.linspace(0.0, 1.0, 100)
    with pytest.raises(SignalError, match="reverses after sample"):
        resample_over_angle(np.zeros(100), t - 1.5 * t**2)
    with pytest.raises(SignalError, match="fewer|less than three steps"):
        resample_over_angle(np.zeros(100), 0.01 * t, samples_per_revolution=10)


@pytest.mark.parametrize(
    "first, last", [(-1000.0, 1000.0), (1000.0, -1000.0), (-500.0, 1500.0), (1500.0, -500.0)]
)
def test_a_run_through_zero_speed_is_refused_at_the_time_where_it_reverses(first: float, last: float) -> None:
    """In 3 s from first to last, both sampled: zero speed at 1.5, 1.5, 0.75 and 2.25 s."""
    t = np.linspace(0.0, 3.0, 60_001)
    angle = np.pi / 30.0 * (first * t + (last - first) / 6.0 * t**2)
    at = 3.0 * first / (first - last)
    where = f"stops or reverses at {at:.4g} s" if at >= 1.0 else f"stops or reverses at {1e3 * at:.4g} ms"
    with pytest.raises(SignalError, match=where):
        order_map(np.cos(20.0 * angle), angle, t, highest_order=30)
    with pytest.raises(SignalError, match=f"after sample {round(at * 20_000)};"):
        resample_over_angle(np.cos(20.0 * angle), angle)


def test_end_rows_of_an_order_map_are_as_sharp_as_its_lines() -> None:
    """Frames of one revolution at a steady order 20: no row has content beyond the lines of the window."""
    t, angle = run_up()
    m = order_map(np.cos(20 * angle), angle, t, highest_order=60, revolutions=1)
    assert m.amplitude[:, np.abs(m.order - 20.0) > 2.0].max() < 0.02


def test_the_note_of_a_map_advises_a_slower_run_up_only_for_run_ups() -> None:
    t = np.linspace(0.0, 4.0, 40_001)
    ripple = 2 * np.pi * (10.0 * t - 0.8 * np.cos(4.0 * t))
    m = order_map(np.cos(20 * ripple), ripple, t, highest_order=30)
    assert not m.is_run_up and m.notes[0].endswith("Use fewer revolutions per frame")
    fast = 2 * np.pi * (2.0 * t + 5.0 * t**2)
    up = order_map(np.cos(20 * fast), fast, t, highest_order=30)
    assert up.is_run_up and up.notes[0].endswith("or a slower run-up")


def test_order_map_keeps_order_and_amplitude_over_speed() -> None:
    t, angle = run_up()
    m = order_map(1.5 * np.sin(31 * angle), angle, t, highest_order=40, revolutions=4)
    assert {float(m.order[k]) for k in m.amplitude.argmax(axis=1)} == {31.0}
    np.testing.assert_allclose(m.amplitude.max(axis=1), 1.5, rtol=5e-3)
    np.testing.assert_allclose(m.speed, 2 * np.pi * (1.0 + m.time), rtol=2e-2)
    assert m.amplitude.shape == (m.time.size, m.order.size)


def test_order_map_needs_a_whole_frame() -> None:
    t = np.linspace(0.0, 1.0, 1000)
    with pytest.raises(SignalError, match="revolutions"):
        order_map(np.sin(t), 2 * np.pi * t, t, highest_order=10, revolutions=3)


def test_time_frequency_frames_are_amplitude_spectra() -> None:
    """Every row equals the spectrum of its frame, and SciPy's transform at the same place."""
    from scipy.signal import ShortTimeFFT, get_window

    x = np.random.default_rng(3).normal(size=4096)
    m = time_frequency_map(x, 1000.0, frame=256, frames=31)
    row = 7
    start = round(m.time[row] * 1000.0 - 127.5)
    expected = amplitude_spectrum(x[start : start + 256], 1000.0).amplitude
    np.testing.assert_allclose(m.amplitude[row, 1:], expected[1:], rtol=1e-12)
    hann = get_window("hann", 256, fftbins=True)
    stft = ShortTimeFFT(hann, hop=1, fs=1000.0, scale_to="magnitude", phase_shift=None)
    piece = x[start : start + 256] - x[start : start + 256].mean()
    reference = 2.0 * np.abs(stft.stft(piece, p0=128, p1=129, k_offset=0)[:, 0])
    np.testing.assert_allclose(m.amplitude[row, 1:-1], reference[1:-1], rtol=1e-9)


def test_time_frequency_map_stops_where_asked() -> None:
    m = time_frequency_map(np.sin(np.arange(5000.0)), 1000.0, frame=200, frames=11, highest_frequency=100.0)
    assert m.frequency[-1] == pytest.approx(100.0)
    assert m.amplitude.shape == (11, 21)
    with pytest.raises(SignalError, match="frame"):
        time_frequency_map(np.ones(100), 1.0, frame=101)


@pytest.mark.parametrize("order", [151.0, 160.0, 184.0, 200.0, 233.5, 400.0, 734.0, 1100.0, 1999.0])
@pytest.mark.parametrize("steady", [True, False])
def test_nothing_above_the_highest_order_folds_into_an_order_spectrum(order: float, steady: bool) -> None:
    """Orders 151 ... 1999 of a record with 4000 samples per revolution, requested up to 150."""
    t = np.linspace(0.0, 1.0, 40_001)
    angle = 2 * np.pi * (10.0 * t if steady else 9.0 * t + t**2)
    found = tracked_spectrum(np.cos(order * angle), angle, highest_order=150)
    assert found.frequency[-1] == 150.0
    # the window of ten revolutions reaches two lines to either side
    assert found.amplitude[found.frequency < order - 0.5].max() < 1e-3


@pytest.mark.parametrize("order", [1.0, 50.0, 113.0, 149.0, 150.0])
def test_an_order_inside_is_right(order: float) -> None:
    t = np.linspace(0.0, 1.0, 40_001)
    angle = 2 * np.pi * (10.3 * t + 1.1 * t**2)
    found = tracked_spectrum(
        2.0 * np.cos(order * angle + 0.3) + np.cos(210 * angle), angle, highest_order=150
    )
    highest = int(np.argmax(found.amplitude))
    assert found.frequency[highest] == pytest.approx(order)
    assert found.amplitude[highest] == pytest.approx(2.0, rel=0.01)


def test_an_order_spectrum_ends_where_the_record_resolves_no_more() -> None:
    """100 samples per revolution hold 50 orders; order 40 has its image at 60."""
    angle = 2 * np.pi * np.arange(2001) / 100
    found = tracked_spectrum(np.cos(40 * angle), angle, highest_order=150)
    assert found.frequency[-1] == pytest.approx(50.0)
    assert found.amplitude[found.frequency < 39.0].max() < 1e-3


def test_order_map_holds_nothing_of_what_lies_above() -> None:
    t, angle = run_up(240_001)
    m = order_map(np.cos(70 * angle), angle, t, highest_order=40, revolutions=4)
    assert m.amplitude[10:-10].max() < 1e-3
    # the low-pass filter continues the record by reflection, which frames at the ends contain
    assert m.amplitude.max() < 2e-2


def test_maps_of_a_run_up_reach_its_ends() -> None:
    """600 to 1800 rpm in 4 s: whole frames of two revolutions would begin at 629 rpm."""
    t = np.linspace(0.0, 4.0, 80_001)
    speed = np.pi / 30 * np.array([600.0, 1800.0])
    angle = speed[0] * t + 0.5 * (speed[1] - speed[0]) / 4.0 * t**2
    x = 3.0 * np.cos(20 * angle)
    m = order_map(x, angle, t, highest_order=30, revolutions=2)
    rpm = m.speed * 30 / np.pi
    # half a revolution less at each end: 15 and 5 rpm
    assert rpm[0] < 616 and rpm[-1] > 1794
    assert np.all(np.diff(m.speed) > 0.0)
    # amplitude and order are right at the ends too
    np.testing.assert_allclose(m.amplitude.max(axis=1), 3.0, rtol=5e-3)
    assert {float(m.order[k]) for k in m.amplitude.argmax(axis=1)} == {20.0}
    passed = time_frequency_map(x, 20_000.0, frame=2048)
    assert passed.time[0] < 0.02 and passed.time[-1] > 3.98


def test_the_map_of_a_slow_mesh_resolves_its_band() -> None:
    """3.25 Hz in 15 s at 20 kHz, drawn up to 40 Hz: lines of 26 Hz would be two blocks."""
    t = np.arange(300_000) / 20_000.0
    m = time_frequency_map(np.cos(2 * np.pi * 3.25 * t), 20_000.0, highest_frequency=40.0)
    assert m.frequency[1] < 1.3
    assert m.frequency.size > 30 and m.time.size > 100
    middle = m.amplitude[m.time.size // 2]
    assert m.frequency[middle.argmax()] == pytest.approx(3.25, abs=m.frequency[1])


def test_time_frequency_map_keeps_the_clock_of_the_record() -> None:
    x = np.sin(np.arange(5000.0))
    late = time_frequency_map(x, 1000.0, start=0.3)
    np.testing.assert_allclose(late.time, 0.3 + time_frequency_map(x, 1000.0).time)


@pytest.mark.parametrize("frequency", [700.0, 701.3, 702.5, 704.9])
def test_a_peak_between_two_lines_is_found(frequency: float) -> None:
    t = np.arange(4000) / 20_000.0
    found = amplitude_spectrum(np.sin(2 * np.pi * frequency * t), 20_000.0)
    assert largest_peaks(found, 1)[0][0] == pytest.approx(frequency, abs=0.02 * found.resolution)


def resonance(last: float, revolutions: float):
    """Map of a resonance at 2.2 kHz with 2 % damping that order 23 passes between 1000 and 9000 rpm."""
    time = np.arange(0.0, last, 1.0 / 40_000.0)
    gain = 8000.0 * np.pi / 30.0 / last
    angle = 1000.0 * np.pi / 30.0 * time + 0.5 * gain * time**2
    ratio = 23.0 * (1000.0 * np.pi / 30.0 + gain * time) / (2.0 * np.pi * 2200.0)
    x = np.real(np.exp(23j * angle) / (1.0 - ratio**2 + 0.04j * ratio))
    return gain, order_map(x, angle, time, highest_order=40, revolutions=revolutions)


def test_map_of_a_fast_run_up_states_its_resolution_in_speed() -> None:
    """Speed change within a frame of n revolutions at constant acceleration: alpha 2 pi n/Omega."""
    gain, fast = resonance(2.0, 8.0)
    whole = slice(fast.speed.size // 4, -fast.speed.size // 4)
    expected = gain * 16.0 * np.pi / fast.speed
    assert fast.speed_change[whole] == pytest.approx(expected[whole], rel=0.02)
    track = np.abs(fast.order - 23.0) < 1.5
    assert fast.amplitude[:, track].max() < 0.9 * 25.0
    (note,) = fast.notes
    assert "the speed changes by more than 5 % within a frame" in note
    peak = fast.speed[np.argmax(fast.amplitude[:, track].max(axis=1))] * 30.0 / np.pi
    low, high = (float(word.split(" rpm")[0]) for word in note.removeprefix("between ").split(" and ")[:2])
    assert low < peak < high
    _, slow = resonance(30.0, 2.0)
    assert slow.notes == ()
    assert slow.amplitude[:, np.abs(slow.order - 23.0) < 1.5].max() == pytest.approx(25.0, rel=0.01)


def test_analysis_of_a_dataset_keeps_the_note() -> None:
    time = np.arange(0.0, 2.0, 1e-3)
    angle = 2.0 * np.pi * (5.0 * time + 10.0 * time**2)
    data = xr.Dataset(
        {"force": ("time", np.cos(3.0 * angle), {"units": "N"}), "angle": ("time", angle, {"units": "rad"})},
        coords={"time": time},
    )
    found = analyse(data, "order_map", channel="force", angle="angle", highest_order=5)
    assert "within a frame" in found.attrs["notes"]
    assert found["speed_change"].units == "rad/s"
    assert "notes" not in analyse(data, "amplitude_spectrum", channel="force").attrs
