# SPDX-License-Identifier: Apache-2.0
"""Sections of the page about the fault in noise: wavelet levels, periods, detection rates."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from diagnosis import CHANNEL, ENVELOPE_BAND, LONGEST, SHORTEST, TURN, Pair, Readings, levels_of, period_of
from study import RATE, READ_PERIOD

from pitchpoint.analysis.detection import DetectionCurves, least_ratio
from pitchpoint.viz import theme
from pitchpoint.viz.compared_table import Compared, compared_table, sourced_table
from pitchpoint.viz.detection_plot import plot_detection
from pitchpoint.viz.level_plot import plot_signal_and_levels
from pitchpoint.viz.quantities import Channel, number
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.signals_plot import plot_signals


def noise(pair: Pair, found: Sequence[Readings]) -> Section:
    """Noise on the bearing force, its wavelet levels, and the period that a5 shows."""
    section = Section("noise", "7 In the noise")
    section.add(
        f"<p>{CHANNEL} at {RATE:g} Hz, 6456 samples in 15 s as in the paper, with white noise: 0 dB is as "
        "much noise as alternating force. The paper does not print its level. Db5, five levels "
        "(analysis.wavelets.wavelet_levels); a5 holds what is slower than 6.7 Hz: the mesh of stage 3, and "
        "once per turn of the third shaft the broken tooth.</p>"
    )
    time = np.arange(pair.faulty.size) / RATE
    for reading in found:
        noisy = pair.noisy(True, reading.ratio, 0)
        section.add_figure(
            plot_signal_and_levels(time, noisy - noisy.mean(), levels_of(noisy - noisy.mean()), unit="N"),
            f"Broken tooth, {number(reading.ratio)} dB, seed 0: the signal S less its mean, its "
            "approximation a5 and its details, as in Fig. 10 of the paper.",
        )
    add_both(section, pair, time, found[0].ratio)
    rows = []
    for reading in found:
        n, m = reading.faulty.size, reading.healthy.size
        at, source = f"{number(reading.ratio)} dB", f"find_period of a5, {reading.faulty.size} seeds"
        mean = float(np.nanmean(reading.faulty)) if np.any(np.isfinite(reading.faulty)) else np.nan
        rows += [
            Compared(f"{at}: period, mean", mean, source, "s", TURN, 5),
            Compared(f"{at}: the same in steps", mean * RATE, source, "", TURN * RATE, 5),
            Compared(f"{at}: largest error of a seed", 100 * reading.worst, source, "%", "0.5 requested", 2),
            Compared(f"{at}: readings within 0.5 %", f"{reading.hits} of {n}", source, "", f"{n} of {n}"),
            Compared(
                f"{at}: healthy, period found",
                f"{reading.false_alarms} of {m}",
                f"find_period of a5, {m} seeds",
                "",
                "0",
            ),
        ]
    rows.append(
        Compared("the paper's reading", READ_PERIOD, "the paper, section 5.2: 1452 steps", "s", TURN, 5)
    )
    section.add(compared_table(rows, published="expected"))
    section.add(
        f"<p>Nothing but a5, the sample rate and the mesh frequencies go into find_period; it looks between "
        f"{SHORTEST:g} and {LONGEST:g} s and reports a period if noise would give as much with a chance "
        "below 0.1 %. Expected is one turn of the third shaft.</p>"
    )
    return section


def add_both(section: Section, pair: Pair, time: np.ndarray, ratio: float) -> None:
    """a5 of both gearboxes, and what speaks for each period."""

    signals = {"broken tooth": pair.noisy(True, ratio, 0), "healthy": pair.noisy(False, ratio, 0)}
    lines = [Channel(f"a5, {name}", levels_of(x - x.mean()).signals[0], "N") for name, x in signals.items()]
    section.add_figure(
        plot_signals(time, lines, rows=[[0], [1]]),
        f"a5 with and without the broken tooth at {ratio:g} dB, seed 0.",
    )
    figure = theme.figure("period [s]", "−log₁₀ of its chance in noise", height=320)
    for name, x in signals.items():
        found = period_of(x)
        figure.add_scatter(x=found.trial_period, y=found.trial_score, mode="lines", name=name)
    figure.add_vline(x=TURN, line={"color": theme.GREY, "width": 1, "dash": "dot"})
    section.add_figure(
        figure, f"What speaks for each period in a5 at {ratio:g} dB (coarse search); dotted: a turn of Z5."
    )


def detection(curves: DetectionCurves, found: Sequence[Readings]) -> Section:
    """Rates of detection over the noise."""
    section = Section("detection", "8 How much noise")
    section.add_figure(
        plot_detection(curves),
        f"Share of {curves.seeds} noisy signals of the broken tooth that exceed a threshold, which at most "
        f"{100 * curves.false_alarm:g} % of healthy ones do; bars are {100 * curves.confidence:g} % "
        "intervals.",
    )
    best = least_ratio(curves, 0.9)
    rows = []
    for k, name in enumerate(curves.detectors):
        at = f"{number(float(best[k]))} dB" if np.isfinite(best[k]) else "never"
        alarms = float(curves.false_alarm_rate[k].max())
        mean = float(curves.false_alarm_rate[k].mean())
        shown = [f"{number(100 * v, 2)} %" for v in (mean, alarms)]
        rows.append([name, "", at, *shown, f"detection_curves, {curves.seeds} seeds at each ratio"])
    head = ("indicator", "", "finds 9 of 10 down to", "false alarms, mean", "false alarms, most")
    section.add(sourced_table(head, rows))
    low, high = ENVELOPE_BAND
    healthy = "; ".join(f"{r.false_alarms} of {r.healthy.size} at {number(r.ratio)} dB" for r in found)
    section.add(
        "<p>From: detection_curves; false alarms are those of a second set of healthy signals. The comb in "
        "a5 knows the period of the shaft (period_evidence); FM4 knows the angle of the shaft and the "
        "teeth on it (synchronous_average, gear_indicators; 4 turns in 15 s); the envelope is that of the "
        f"band from {low:g} to {high:g} Hz about the mesh of stage 3. Kurtosis knows nothing. Without "
        f"knowing the period, find_period raised a false alarm in {healthy} of the healthy signals.</p>"
    )
    return section
