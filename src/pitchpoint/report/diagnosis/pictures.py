# SPDX-License-Identifier: Apache-2.0
"""Plots of one channel of a diagnosis: spectrum, lines of the suspected part, mean turn, envelope."""

from __future__ import annotations

import math
from dataclasses import dataclass
from html import escape

import numpy as np

from pitchpoint.analysis.findings import Evidence
from pitchpoint.analysis.indicators import signal_indicators
from pitchpoint.analysis.line_tests import FineSpectrum, fine_spectrum
from pitchpoint.analysis.mesh_angle import HARMONICS as MESH_HARMONICS
from pitchpoint.analysis.shaft_tests import MIN_TURNS
from pitchpoint.analysis.speed_without_gears import SHAFT_HARMONICS
from pitchpoint.analysis.time_frequency import time_frequency_map
from pitchpoint.analysis.turning_parts import Shaft
from pitchpoint.report.diagnosis.envelope_pictures import add_envelopes, axis_of, named_line, place_of
from pitchpoint.report.diagnosis.study import Study
from pitchpoint.report.diagnosis.tables import HARMONICS, indicator_tables
from pitchpoint.report.diagnosis.tooth_places import GearTurn, gear_turns
from pitchpoint.report.diagnosis.words import named_mesh
from pitchpoint.viz.diagnosis_plots import Lines, in_hertz, line_places, plot_lines, plot_mean_turn
from pitchpoint.viz.quantities import amount, number
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.spectrum_plots import plot_time_frequency

SIDEBANDS = 6
"""Number of marked shaft orders on each side of a line."""
ABOUT_INDICATORS = (
    "rms: of the mean turn and of its residual (without mesh harmonics and the two lowest orders). Crest "
    "factor, kurtosis and tooth energy: of the residual; FM4, M6A and M8A: of the difference signal. Tooth "
    "energy: largest share of the energy within the angle of one tooth. In brackets: value exceeded by "
    "1\N{NO-BREAK SPACE}% of stationary signals with the same spectrum; for the tooth energy the share of "
    "an even distribution. Bold: limit exceeded, as by 1\N{NO-BREAK SPACE}% of healthy values; the tests "
    "below decide."
)


def add_channel(section: Section, study: Study, channel: str) -> None:
    """Add the text, plots and tables of one channel to a section."""
    unit, over = study.units.get(channel, ""), study.over
    spectrum = in_hertz(fine_spectrum(over.signals[channel], over.samples_per_turn), over.frequency)
    section.add(f"<p>{escape(_level(study, channel, unit))}</p>")
    section.add_figure(
        plot_lines(spectrum, _meshes(study, spectrum), unit=unit, quantity="amplitude", over=axis_of(study)),
        f"Spectrum of {channel}"
        + (
            f", with the mesh lines of all gears and their harmonics up to {HARMONICS}."
            if study.parts.meshes
            else "."
        ),
    )
    turns = [row for s in study.parts.shafts for row in gear_turns(channel, s.name, over, study.parts)]
    # an average of one or two turns still contains the vibration of all other shafts
    rows = [row for row in turns if row.turn.averages >= MIN_TURNS]
    for evidence in questions(study, channel):
        for view in _views(study, spectrum, evidence):
            _add_orders(section, study, spectrum, study.parts.shaft(evidence.shaft), view, unit)
        _add_turn(section, study, rows, evidence, unit)
    if study.parts.bearings:
        add_envelopes(section, study, channel, unit)
    if rows:
        section.add("<h3>Indicators of the mean turns</h3>")
        section.add(indicator_tables(rows, unit))
        section.add(f"<p>{ABOUT_INDICATORS}</p>")


def add_speed(section: Section, study: Study, channel: str) -> None:
    """Add a map of one channel over time and frequency with the speed found in the record."""
    found = study.over.found
    if found is None:
        return
    path, parts = found.track.path, study.parts
    orders = {mesh.name: parts.mesh_order(mesh) for mesh in parts.meshes}
    orders = orders or {shaft.name: float(shaft.order) for shaft in parts.shafts}
    harmonics = MESH_HARMONICS if parts.meshes else SHAFT_HARMONICS
    top = 1.1 * harmonics * max(orders.values()) * float(path.frequency.max())
    data = time_frequency_map(
        found.signals[channel],
        found.sample_rate,
        frame=round(found.sample_rate / path.resolution),
        highest_frequency=min(top, 0.5 * found.sample_rate),
        start=found.start,
    )
    speed = np.interp(data.time, found.start + path.time, path.frequency)
    unit = study.units.get(channel, "")
    curves = {name: order * speed for name, order in orders.items()}
    section.add("<h3>Speed found in the record</h3>")
    section.add_figure(
        plot_time_frequency(data, unit=unit, quantity=channel, meshes=curves),
        f"{channel} over time and frequency, with the lines expected at the speed found: "
        f"{', '.join(orders)} and harmonics. The speed is wrong if the curves are not on the ridges.",
    )


def questions(study: Study, channel: str) -> list[Evidence]:
    """Strongest evidence for each shaft with a finding in a channel; without findings the closest one."""
    mine = [e for e in study.diagnosis.evidence if e.channel == channel and e.kind != "bearing"]
    mine.sort(key=lambda e: (e.probability, e.threshold - e.value))
    found = study.diagnosis.findings
    if not found:
        return mine[:1]
    shafts = [f.shaft for f in found if f.channel == channel and f.kind != "bearing"]
    return [e for shaft in dict.fromkeys(shafts) for e in [e for e in mine if e.shaft == shaft][:1]]


def _level(study: Study, channel: str, unit: str) -> str:
    """rms, kurtosis and crest factor of the whole channel, in words."""
    from scipy.stats import norm

    found, size = signal_indicators(study.over.signals[channel]), study.over.signals[channel].size
    # median of the largest magnitude of `size` independent Gaussian samples
    peak = float(norm.isf(-0.5 * np.expm1(np.log(0.5) / size)))
    return (
        f"Alternating part of the whole record: rms {amount(found.rms, unit)}, "
        f"kurtosis {number(found.kurtosis, 3)} (Gaussian noise 3, a sine 1.5), crest factor "
        f"{number(found.crest_factor, 3)} (Gaussian noise of {size} samples about {number(peak, 2)})."
    )


def _meshes(study: Study, spectrum: FineSpectrum) -> list[Lines]:
    """Mesh lines with their harmonics."""
    found = []
    for look, mesh in enumerate(study.parts.meshes, start=1):
        order = study.parts.mesh_order(mesh)
        places = line_places(place_of(study, order), HARMONICS, spectrum.highest)
        found.append(Lines(named_line(study, mesh.name, order), places, look=look))
    return [lines for lines in found if lines.places.size]


@dataclass(frozen=True)
class _View:
    """Detail of the spectrum: shaft order in the middle, order from which labels count, caption."""

    middle: int
    counted: int
    words: str


def _views(study: Study, spectrum: FineSpectrum, e: Evidence) -> list[_View]:
    """Details of the spectrum drawn for a piece of evidence; for a comb also the sidebands of a mesh."""
    shaft = study.parts.shaft(e.shaft)
    if e.kind == "low order":
        words = f"The lowest orders of {shaft.name}. Numbers are orders of the shaft."
        return [_View(SIDEBANDS + 1, 0, words)]
    found = []
    for mesh, teeth, harmonic in _sidebands(study, spectrum, e)[:1]:
        words = (
            f"Harmonic {harmonic} of {named_mesh(mesh)} with its sidebands at the rotation frequency of "
            f"{shaft.name}, numbered: slow modulation over a turn raises the first sidebands, a local fault "
            "all of them."
        )
        found.append(_View(harmonic * teeth, harmonic * teeth, words))
    if e.kind == "comb":
        middle = _clearest(spectrum, place_of(study, float(shaft.order)))
        words = (
            f"The {2 * SIDEBANDS + 1} consecutive orders of {shaft.name} that stand out most: a local fault "
            "raises all of them above the spectrum between them. Numbers are orders of the shaft."
        )
        # one plot, that of the sidebands, if both details overlap
        if not found or abs(middle - found[0].middle) > SIDEBANDS:
            found.insert(0, _View(middle, 0, words))
    return found


def _sidebands(study: Study, spectrum: FineSpectrum, e: Evidence) -> list[tuple[str, int, int]]:
    """Meshes of the suspected gears with tooth count and harmonic, the clearest first."""
    gears, same = _gears(study, e), (e.channel, e.shaft, "sidebands")
    tests = [o for o in study.diagnosis.evidence if (o.channel, o.shaft, o.kind) == same and o.gear in gears]
    found = []
    for test in sorted(tests, key=lambda other: other.probability):
        mesh, teeth = study.parts.gears_of(e.shaft)[test.gear]
        found.append((mesh.name, teeth, max(round(test.order / study.parts.mesh_order(mesh)), 1)))
    # meshes without a test are shown too, if the spectrum covers them
    for gear, (mesh, teeth) in study.parts.gears_of(e.shaft).items():
        if gear in gears and place_of(study, study.parts.mesh_order(mesh)) < spectrum.highest:
            found.append((mesh.name, teeth, 1))
    return found


def _clearest(spectrum: FineSpectrum, step: float) -> int:
    """Middle of the orders that stand out most above the points half-way between orders."""
    count = int(0.9 * spectrum.highest / step)
    number = np.arange(1, count + 1)
    width = min(2 * SIDEBANDS + 1, count)
    lines, between = spectrum.power(number * step), spectrum.power((number + 0.5) * step)
    smallest = 1e-12 * max(float(lines.max()), 1e-300)
    excess = np.log(np.maximum(lines, smallest)) - np.log(np.maximum(between, smallest))
    return int(np.argmax(np.convolve(excess, np.ones(width), mode="valid"))) + 1 + width // 2


def _gears(study: Study, e: Evidence) -> tuple[str, ...]:
    """Suspected gears: those of the finding, else that of the test, else all of the shaft."""
    found = [f.gears for f in study.diagnosis.findings if f.shaft == e.shaft and f.kind != "bearing"]
    if found and found[0]:
        return found[0]
    return (e.gear,) if e.gear else tuple(study.parts.gears_of(e.shaft))


def _add_orders(
    section: Section, study: Study, spectrum: FineSpectrum, shaft: Shaft, view: _View, unit: str
) -> None:
    """Add a detail of the spectrum with the orders of a shaft and mesh lines."""
    step = place_of(study, float(shaft.order))
    low = max((view.middle - SIDEBANDS - 0.6) * step, 0.3 * step)
    high = min((view.middle + SIDEBANDS + 0.6) * step, spectrum.highest)
    orders = range(math.ceil(low / step), math.floor(high / step) + 1)
    labels = tuple(_order_label(k - view.counted, view.counted > 0) for k in orders)
    name = named_line(study, f"orders of {shaft.name}", float(shaft.order))
    marks = [Lines(name, step * np.array(orders, dtype=np.float64), labels)]
    marks += [m for m in _meshes(study, spectrum) if ((m.places >= low) & (m.places <= high)).any()]
    figure = plot_lines(
        spectrum, marks, unit=unit, quantity="amplitude", over=axis_of(study), span=(low, high)
    )
    section.add_figure(figure, view.words)


def _order_label(k: int, sideband: bool) -> str:
    """Label of an order or a sideband; empty for the mesh line itself."""
    if not sideband:
        return str(k)
    return f"{k:+d}".replace("-", "−") if k else ""


def _add_turn(section: Section, study: Study, rows: list[GearTurn], e: Evidence, unit: str) -> None:
    """Add the mean turn over the teeth of the gear, or over degrees if the gear is not identified."""
    gears = _gears(study, e)
    places = zip(study.diagnosis.findings, study.places, strict=True)
    own = [turns for f, turns in places if (f.shaft, f.channel) == (e.shaft, e.channel) and turns]
    turns = [row for row in (own[0] if own else rows) if row.shaft == e.shaft and set(row.gears) & set(gears)]
    if not turns:
        return
    turn = min(turns, key=lambda row: row.turn.energy.probability)
    mine = [f for f in study.diagnosis.findings if f.shaft == e.shaft and f.kind == "local fault"]
    known = len(turns) == 1 and all(f.gears for f in mine)
    marked = bool(mine) and turn.stands_out(study.diagnosis.false_alarm)
    figure = plot_mean_turn(
        turn.turn,
        unit=unit,
        teeth=turn.teeth if known else None,
        zero=turn.zero,
        since=turn.since,
        mark=(turn.angle, math.tau / turn.teeth) if marked else None,
    )
    words = f"Mean of {turn.turn.averages} turns of {e.shaft}"
    words += f", over the teeth of {' or '.join(turn.gears)}" if known else ""
    shaded = "; shaded: angle of one tooth with the most energy of the residual" if marked else ""
    section.add_figure(figure, f"{words}, in its sense of rotation from {turn.since}{shaded}.")
