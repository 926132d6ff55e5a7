# SPDX-License-Identifier: Apache-2.0
"""Jump detection: found on Duffing curves at every grid, never on smooth resonances.

Oracle: amplitudes of the Duffing oscillator from its cubic frequency equation (one harmonic), branches
followed by hand.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pitchpoint.analysis.jumps import branch, find_jumps, sweep_jumps
from pitchpoint.analysis.sampled import SignalError


def duffing(frequencies: np.ndarray, damping: float, force: float, cubic: float) -> np.ndarray:
    """Amplitudes along a sweep that carries its state: ((1 - w² + ¾ c A²)² + (2 z w)²) A² = F²."""
    levels: list[float] = []
    for w in frequencies:
        c, a, g = 0.75 * cubic, 1.0 - w * w, (2.0 * damping * w) ** 2
        roots = np.roots([c * c, 2.0 * a * c, a * a + g, -force * force])
        real = np.sort(roots[(np.abs(roots.imag) < 1e-9) & (roots.real > 0.0)].real)
        stable = real if real.size == 1 else real[[0, 2]]
        near = stable[0] if not levels else min(stable, key=lambda s: abs(np.log(s / levels[-1] ** 2)))
        levels.append(float(np.sqrt(near)))
    return np.array(levels)


def folds(damping: float, force: float, cubic: float) -> tuple[float, float]:
    """Frequencies of the two folds: where the number of real amplitudes changes."""
    w = np.linspace(0.9, 1.3, 40001)
    count = []
    for each in w:
        c, a, g = 0.75 * cubic, 1.0 - each * each, (2.0 * damping * each) ** 2
        roots = np.roots([c * c, 2.0 * a * c, a * a + g, -force * force])
        count.append(int(((np.abs(roots.imag) < 1e-9) & (roots.real > 0.0)).sum()))
    three = np.flatnonzero(np.array(count) == 3)
    return float(w[three[0]]), float(w[three[-1]])


def points_of(up: np.ndarray, level_up: np.ndarray, level_down: np.ndarray) -> list[dict[str, Any]]:
    rows = [("up", f, a) for f, a in zip(up, level_up, strict=True)]
    rows += [("down", f, a) for f, a in zip(up[::-1], level_down, strict=True)]
    return [{"direction": d, "mesh_frequency": float(f), "deflection": {"rms": float(a)}} for d, f, a in rows]


LONG = [pytest.param(n, marks=pytest.mark.study) for n in (81, 161, 641)]


@pytest.mark.parametrize("n", [41, *LONG])
def test_both_jumps_of_a_hardening_oscillator(n: int) -> None:
    case = {"damping": 0.02, "force": 0.05, "cubic": 0.3}
    f = np.linspace(0.4, 1.6, n)
    low, high = folds(**case)
    jumps = sweep_jumps(points_of(f, duffing(f, **case), duffing(f[::-1], **case)))
    assert [j.direction for j in jumps] == ["up", "down"]
    step = f[1] - f[0]
    assert jumps[0].frequency == pytest.approx(high, abs=0.5001 * step)
    assert jumps[1].frequency == pytest.approx(low, abs=0.5001 * step)
    assert jumps[0].after < jumps[0].before
    assert jumps[1].after > jumps[1].before
    assert all(j.half_width == pytest.approx(0.5 * step) for j in jumps)


@pytest.mark.parametrize("n", [81, 321])
def test_one_direction_alone(n: int) -> None:
    f = np.linspace(0.4, 1.6, n)
    jumps = find_jumps(f, duffing(f, damping=0.02, force=0.05, cubic=0.3))
    assert len(jumps) == 1
    assert jumps[0].direction == "up"


@settings(max_examples=300)
@given(
    offset=st.floats(0.0, 1.0),
    width=st.floats(1e-4, 10.0),
    floor=st.floats(0.0, 30.0),
    start=st.integers(-20, 0),
    n=st.integers(6, 40),
)
def test_no_sampling_of_a_smooth_resonance_is_a_jump(
    offset: float, width: float, floor: float, start: int, n: int
) -> None:
    x = start + np.arange(n) + offset
    level = np.sqrt(1.0 / (x**2 + width**2) + floor**2)
    assert find_jumps(x, level) == ()


@settings(max_examples=200)
@given(st.integers(6, 200), st.floats(0.001, 0.3), st.floats(0.1, 0.9), st.floats(1.0, 3.0))
def test_no_resonance_curve_is_a_jump(n: int, damping: float, first: float, last: float) -> None:
    f = np.linspace(first, last, n)
    level = 1.0 / np.hypot(1.0 - f**2, 2.0 * damping * f)
    assert find_jumps(f, level) == ()


@given(st.integers(0, 2**31 - 1))
def test_two_narrow_resonances_between_few_points_need_hysteresis(seed: int) -> None:
    """Up and down the same: one function of frequency, however wild, has no jump."""
    rng = np.random.default_rng(seed)
    f = np.arange(40.0)
    poles, widths = rng.uniform(0.0, 40.0, 6), 10.0 ** rng.uniform(-3.0, 1.0, 6)
    level = 0.1 + np.sum(1.0 / np.hypot(f[:, None] - poles, widths), axis=1)
    assert sweep_jumps(points_of(f, level, level[::-1])) == ()


def test_jump_caught_half_way() -> None:
    f = np.arange(100.0, 112.0)
    up = np.array([1.0, 1.01, 1.02, 1.03, 1.04, 1.05, 2.2, 4.0, 3.95, 3.9, 3.85, 3.8])
    down = np.array([3.8, 3.85, 3.9, 3.95, 4.0, 4.05, 4.1, 4.15, 1.03, 1.02, 1.01, 1.0])
    jumps = sweep_jumps(points_of(f, up, down))
    assert [(j.direction, j.frequency) for j in jumps] == [("up", 105.5), ("down", 103.5)]


def test_one_outlier_and_noise_are_no_jumps() -> None:
    level = np.full(30, 2.0)
    level[12] = 5.0
    assert find_jumps(np.arange(30.0), level) == ()
    quiet = 2.0 * (1.0 + 1e-3 * np.random.default_rng(0).normal(size=200))
    assert find_jumps(np.arange(200.0), quiet) == ()


def test_result_does_not_depend_on_the_unit() -> None:
    f = np.linspace(0.4, 1.6, 81)
    level = duffing(f, damping=0.02, force=0.05, cubic=0.3)
    small = find_jumps(f * 1e3, level * 1e-6)
    assert [j.frequency for j in small] == pytest.approx([j.frequency * 1e3 for j in find_jumps(f, level)])


def test_failed_points_are_left_out_and_bad_input_is_refused() -> None:
    points = points_of(np.arange(8.0), np.ones(8), np.ones(8))
    points[3]["deflection"] = {"rms": float("nan")}
    points[4]["deflection"] = None
    assert branch(points, "up", "deflection")[0].size == 6
    assert sweep_jumps(points) == ()
    assert sweep_jumps([]) == ()
    with pytest.raises(SignalError, match="is not monotonic"):
        find_jumps([0, 1, 2, 1, 2, 3], np.ones(6))
    with pytest.raises(SignalError, match="negative"):
        find_jumps(np.arange(6), -np.ones(6))
    with pytest.raises(SignalError, match="limit > 1"):
        find_jumps(np.arange(6), np.ones(6), contrast=1.0)
    assert find_jumps([1.0, 2.0], [1.0, 9.0]) == ()
