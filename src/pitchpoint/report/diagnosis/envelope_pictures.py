# SPDX-License-Identifier: Apache-2.0
"""Envelope spectra of one channel of a diagnosis with the lines of the bearing parts."""

from __future__ import annotations

import math
from html import escape

import numpy as np

from pitchpoint.analysis.bearing_detectors import LIMITS, WAYS
from pitchpoint.analysis.bearing_signals import envelope_band, without_healthy_lines
from pitchpoint.analysis.bearing_tests import alike
from pitchpoint.analysis.envelope import band_envelope
from pitchpoint.analysis.family_lines import FamilyLines
from pitchpoint.analysis.family_search import CAGE_HARMONICS, HARMONICS, SPREAD, STRONG
from pitchpoint.analysis.findings import Evidence
from pitchpoint.analysis.line_prominence import OMITTED
from pitchpoint.analysis.line_tests import fine_spectrum
from pitchpoint.analysis.sampled import Array, SignalError
from pitchpoint.report.diagnosis.study import Study
from pitchpoint.viz.diagnosis_plots import Lines, in_hertz, line_places, plot_levels, plot_lines
from pitchpoint.viz.quantities import number, span
from pitchpoint.viz.report.page import Section

PARTS = {"outer ring": "○", "inner ring": "◇", "rolling element": "□", "cage": "△"}
"""Symbol of each bearing part, in the order of the plot symbols."""


def add_envelopes(section: Section, study: Study, channel: str, unit: str) -> None:
    """Add the envelope spectra by which the bearing parts were tested."""
    if study.parts.meshes:
        _add_band(section, study, channel, unit)
        return
    tests = [e for e in study.diagnosis.evidence if e.channel == channel and e.detectors]
    shown = [e for e in tests if e.found] or sorted(tests, key=lambda e: e.threshold - e.value)[:1]
    for detector in dict.fromkeys(e.detectors[0] for e in shown):
        _add_levels(section, study, channel, detector, tests)


def axis_of(study: Study) -> str:
    """Quantity of the horizontal axis of spectra: `frequency` at a known speed, else `order`."""
    return "frequency" if math.isfinite(study.over.frequency) else "order"


def place_of(study: Study, order: float) -> float:
    """Frequency [Hz] of an order if the speed is known, else the order."""
    return order * study.over.frequency if math.isfinite(study.over.frequency) else order


def named_line(study: Study, name: str, order: float) -> str:
    """Name of a line with its frequency, or its order if the speed varies."""
    value = number(place_of(study, order), 4)
    return f"{name}, {value} Hz" if math.isfinite(study.over.frequency) else f"{name}, order {value}"


def _add_levels(section: Section, study: Study, channel: str, detector: str, tests: list[Evidence]) -> None:
    """Add the envelope spectrum of one detector above its running median, with the limit of the detector."""
    over, limit = study.over, LIMITS[detector]
    lines = WAYS[detector](over.signals[channel], over.samples_per_turn, study.parts, limit)
    named = [e for e in tests if e.found and e.detectors[0] == detector]
    average = _average(lines, named or [e for e in tests if e.detectors[0] == detector])
    level = _levels(lines, average)
    order = np.arange(OMITTED, OMITTED + level.size, dtype=np.float64) * lines.step
    places = {(e.gear, e.shaft): e.order for e in tests}
    marks = _marks(study, float(order[-1]), places, {(e.gear, e.shaft) for e in named})
    last = max((float(mark.places[-1]) for mark in marks if mark.places.size), default=math.inf)
    figure = plot_levels(
        order * place_of(study, 1.0),
        level,
        marks,
        limit=limit,
        over=axis_of(study),
        highest=min(1.08 * last, place_of(study, float(order[-1]))),
    )
    mean = f" Mean levels of {average} lines: random slip widens the lines." if average > 1 else ""
    found = " and ".join(f"{e.shaft} of {e.gear}" for e in named)
    numbered = f"; those of {found} are numbered" if named else ""
    section.add_figure(
        figure,
        f"Envelope spectrum of {channel} by {detector}, level above the running median.{mean} Marked: "
        f"harmonics of the bearing parts, {_symbols(study)}, with the slip found{numbered}. "
        f"A part is found if all of its first {HARMONICS} harmonics (cage {CAGE_HARMONICS}) reach the limit; "
        f"one may be {SPREAD:g} dB lower if their mean is {STRONG:g} dB above it.",
    )


def _levels(lines: FamilyLines, average: int) -> Array:
    """Levels above the running median [dB]; of averaged lines those of equally probable single ones."""
    found = lines.levels[average]
    if average == 1:
        return np.asarray(found.prominence, dtype=np.float64)
    likelihood = -np.log(np.maximum(found.probability, 1e-300)) / np.log(2.0)
    return np.asarray(10.0 * np.log10(np.maximum(likelihood, 1e-3)))


def _average(lines: FamilyLines, tests: list[Evidence]) -> int:
    """Number of averaged lines at which the weakest harmonic of the clearest part is highest."""
    if not tests:
        return 1
    e = max(tests, key=lambda e: e.value - e.threshold)
    orders = np.arange(1, HARMONICS + 1) * e.order

    def weakest(average: int) -> float:
        """Level of the weakest harmonic."""
        level = _levels(lines, average)
        at = np.clip(np.rint(orders / lines.step).astype(int) - OMITTED, 0, level.size - 1)
        return float(level[at].min())

    # averaged only as far as necessary, as in the search
    clear = [average for average in lines.levels if weakest(average) >= e.threshold]
    return clear[0] if clear else max(lines.levels, key=weakest)


def _add_band(section: Section, study: Study, channel: str, unit: str) -> None:
    """Add the spectrum of the squared envelope of a band without mesh lines."""
    over, parts = study.over, study.parts
    try:
        rest = without_healthy_lines(over.signals[channel], over.samples_per_turn, parts)
        low, high = envelope_band(rest, over.samples_per_turn, parts)
        envelope = band_envelope(rest, over.samples_per_turn, band=(low, high)).envelope
        spectrum = in_hertz(fine_spectrum(envelope**2, over.samples_per_turn), over.frequency)
    except SignalError as reason:
        section.add(f"<p>No envelope of {escape(channel)}: {escape(str(reason))}.</p>")
        return
    marks = _marks(study, spectrum.highest / place_of(study, 1.0), {}, set())
    last = max((float(m.places[-1]) for m in marks if m.places.size), default=spectrum.highest)
    known = math.isfinite(over.frequency)
    band = span(place_of(study, low), place_of(study, high)) if known else f"orders {low:.4g} to {high:.4g}"
    figure = plot_lines(
        spectrum,
        marks,
        unit=f"({unit})²" if unit else "",
        quantity="squared envelope",
        over=axis_of(study),
        span=(0.0, min(1.15 * last, spectrum.highest)),
    )
    section.add_figure(
        figure,
        f"Spectrum of the squared envelope of {channel} without mesh lines, band {band}, with the "
        f"frequencies of the bearing parts and their harmonics up to {HARMONICS}: {_symbols(study)}.",
    )


def _marks(
    study: Study,
    highest: float,
    places: dict[tuple[str, str], float],
    named: set[tuple[str, str]],
) -> list[Lines]:
    """Marks of all bearing parts up to an order, at the orders found in the record; named parts numbered."""
    marks = []
    for look, bearing in enumerate(alike(study.parts.bearings), start=1):
        for part, nominal in bearing.orders.items():
            order = places.get((bearing.name, part), nominal)
            # five harmonics of a cage are compared in envelope spectra of detectors
            count = CAGE_HARMONICS if part == "cage" and places else HARMONICS
            lines = line_places(place_of(study, order), count, place_of(study, highest))
            numbers = [str(k + 1) for k in range(lines.size)] if (bearing.name, part) in named else []
            marks.append(
                Lines(
                    named_line(study, f"{bearing.name}, {part}", order),
                    lines,
                    tuple(numbers),
                    look=look,
                    group=bearing.name,
                    symbol=list(PARTS).index(part),
                )
            )
    return marks


def _symbols(study: Study) -> str:
    """Symbols of the parts in words."""
    there = {part for bearing in study.parts.bearings for part in bearing.orders}
    return ", ".join(f"{sign}\N{NO-BREAK SPACE}{part}" for part, sign in PARTS.items() if part in there)
