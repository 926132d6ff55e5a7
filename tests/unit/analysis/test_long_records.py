# SPDX-License-Identifier: Apache-2.0
"""Long records are read and transformed in parts: the same numbers, in a bounded part of the memory."""

from __future__ import annotations

import tracemalloc
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.analysis import line_tests, synchronous_average
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
