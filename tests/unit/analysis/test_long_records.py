# SPDX-License-Identifier: Apache-2.0
"""Long records are read and transformed in parts: the same numbers, in a bounded part of the memory."""

from __future__ import annotations

import tracemalloc
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.analysis import (
    diagnosis,
    envelope,
    line_prominence,
    line_tests,
    severity,
    synchronous_average,
)
from pitchpoint.analysis.turning_parts import Bearing, Shaft, TurningParts
from pitchpoint.io.measured import text
from pitchpoint.io.measured.record import MeasuredError, Wanted


@pytest.mark.parametrize("parts", [2, 16])
def test_a_spectrum_in_parts_is_that_of_the_whole_record(parts: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(line_tests, "AT_ONCE", 1000)
    x = np.cos(0.37 * np.arange(10_007)) + np.random.default_rng(3).standard_normal(10_007)
    usual = np.abs(np.fft.rfft((x - x.mean()) * np.hanning(x.size + 1)[:-1], 16 * 2700))
    found = line_tests.hann_transform(x, 16 * 2700 // parts, parts)
    np.testing.assert_allclose(found, usual, rtol=0.0, atol=1e-12 * usual.max())


def test_a_long_record_shows_its_tone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(line_tests, "LONG", 10_000)
    spectrum = line_tests.fine_spectrum(2.0 * np.cos(0.37 * np.arange(10_007)), 100.0)
    assert spectrum.power(100.0 * 0.37 / (2.0 * np.pi)) == pytest.approx(4.0, rel=0.01)


@pytest.mark.parametrize("size", [65_536, 70_000, 131_000])
def test_a_squared_envelope_in_parts_has_the_lines_of_the_whole(size: int, monkeypatch) -> None:
    """Bursts at 20 Hz in noise: the amplitude of their line over the mean is that of one transform.

    Tolerance: the share of the record that is not in the parts, 1638 samples at most and the ends of the
    filter, and the whitening of parts of 16384 instead of all samples; 5 %.
    """
    rate = 1000.0
    time = np.arange(size) / rate
    x = np.random.default_rng(2).standard_normal(size) * (1.0 + 4.0 * (time * 20.0 % 1.0 < 0.2))
    x += 10.0 * np.cos(2.0 * np.pi * 130.0 * time)

    def square(values: np.ndarray) -> np.ndarray:
        """Squared envelope of the whitened signal."""
        return envelope.band_envelope(values, rate, whiten=True).envelope ** 2

    whole, _ = envelope.square_in_parts(x, rate, 60.0, square)
    monkeypatch.setattr(envelope, "LONG", 10_000)
    monkeypatch.setattr(envelope, "AT_ONCE", 1 << 14)
    parts, lower = envelope.square_in_parts(x, rate, 60.0, square)
    assert lower == rate / 6.0
    assert abs(parts.size / lower - size / rate) < 2.0

    def line(values: np.ndarray, own: float, frequency: float) -> float:
        """Amplitude at a frequency over the mean."""
        turn = np.exp(-2j * np.pi * frequency / own * np.arange(values.size))
        return 2.0 * abs(np.mean((values - values.mean()) * turn)) / values.mean()

    for frequency in (20.0, 40.0):
        assert line(parts, lower, frequency) == pytest.approx(line(whole, rate, frequency), rel=0.05)


def test_the_verdict_of_a_long_record_is_that_of_a_short_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """Impacts on an outer ring with 1 % of random slip in noise, 30 Hz: the same part, its level within 3 dB.

    The level of lines of noise scatters by 1 to 2 dB.
    """
    rng, rate, speed, n = np.random.default_rng(1), 12_000.0, 30.0, 160_000
    x = rng.standard_normal(n) + 0.5 * np.cos(2.0 * np.pi * speed / rate * np.arange(n))
    for when in rate * np.cumsum(rng.normal(1.0 / 107.6, 1.0 / 10_760, 1400)):
        x[int(when) : int(when) + 100] += 4.0 * np.exp(-np.arange(100) / 20.0) * np.sin(1.5 * np.arange(100))
    orders = {"outer ring": 3.585, "inner ring": 5.415, "rolling element": 4.714, "cage": 0.398}
    parts = TurningParts((Shaft("rotor", Fraction(1)),), (), (Bearing("left", orders, "rotor"),))
    short = diagnosis.diagnose({"acc": x}, rate / speed, parts)
    for module in (envelope, line_tests, line_prominence):
        monkeypatch.setattr(module, "LONG", 20_000)
    monkeypatch.setattr(envelope, "AT_ONCE", 1 << 15)
    long = diagnosis.diagnose({"acc": x}, rate / speed, parts)
    named = [[(one.shaft, one.gears) for one in found.findings] for found in (short, long)]
    assert named == [[("outer ring", ("left",))]] * 2
    levels = [[e.value for e in found.evidence if e.found and e.kind == "bearing"] for found in (short, long)]
    assert levels[0] == pytest.approx(levels[1], abs=3.0)


def test_severity_in_parts_is_that_of_the_record(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lines at whole periods of the parts: equal to rounding of the edges of the band, 1e-3."""
    x = np.cos(2.0 * np.pi * 50.0 * np.arange(40_000) / 5000.0)
    whole = severity.vibration_severity(x, 5000.0, "m/s^2", turn=30.0)
    monkeypatch.setattr(severity, "LONG", 10_000)
    parts = severity.vibration_severity(x, 5000.0, "m/s^2", turn=30.0)
    assert parts.velocity == pytest.approx(whole.velocity, rel=1e-3)


def test_an_average_by_parts_is_that_of_one_spline(monkeypatch: pytest.MonkeyPatch) -> None:
    """The influence of a sample on a spline 40 samples away is 1e-23."""
    angle = np.linspace(0.3, 2.0 * np.pi * 57.9, 57 * 240)
    x = np.cos(17.0 * angle) + np.random.default_rng(5).standard_normal(angle.size)
    whole = synchronous_average.synchronous_average(x, angle)
    monkeypatch.setattr(synchronous_average, "AT_ONCE", 5000)
    parts = synchronous_average.synchronous_average(x, angle)
    np.testing.assert_allclose(parts.values, whole.values, rtol=0.0, atol=1e-13)
    assert parts.scatter == pytest.approx(whole.scatter, rel=1e-12)


def long_text(rows: int) -> bytes:
    lines = ["# sample_rate: 1 kHz", "force [N];temperature"]
    lines += [f"{k % 97},{k % 10}5;{k}" for k in range(rows)]
    return "\r\n".join(lines).encode()


@pytest.mark.study
def test_a_text_file_is_never_in_memory_as_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """A list of its lines takes ten times the numbers; blocks of 64 kB take less than the numbers again."""
    monkeypatch.setattr(text, "_BLOCK", 1 << 16)
    data = long_text(200_000)
    text.read_text(Path("warm.csv"), long_text(10), Wanted())
    tracemalloc.start()
    try:
        record = text.read_text(Path("long.csv"), data, Wanted())
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    numbers = sum(c.values.nbytes for c in record.columns)
    assert numbers == 2 * 8 * 200_000
    assert peak < 2.0 * numbers + 40 * text._BLOCK
    assert [one.value for one in record.rates] == [1000.0]
    assert record.columns[0].values[12_345] == 12_345 % 97 + 0.1 * (12_345 % 10) + 0.05


@pytest.mark.parametrize("block", [1, 50, 1 << 20])
def test_blocks_of_any_size_give_the_same_numbers_and_lines(block: int, monkeypatch) -> None:
    monkeypatch.setattr(text, "_BLOCK", block)
    data = b"# remark\n\n" + long_text(50) + b"\r\n# end\n\n"
    record = text.read_text(Path("a.csv"), data, Wanted())
    assert [c.values.size for c in record.columns] == [50, 50]
    np.testing.assert_array_equal(record.columns[1].values, np.arange(50))
    with pytest.raises(MeasuredError, match=r"temperature \(line 45\): 'x41' is not a number"):
        text.read_text(Path("a.csv"), data.replace(b";40\r", b";x41\r"), Wanted())
