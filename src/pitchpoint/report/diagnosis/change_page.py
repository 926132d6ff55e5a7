# SPDX-License-Identifier: Apache-2.0
"""Sections and page of the comparison with healthy records."""

from __future__ import annotations

import csv
import io
import math
from html import escape
from pathlib import Path

import numpy as np

from pitchpoint import __version__
from pitchpoint.io.csv_cells import plain_cell
from pitchpoint.io.target import TREND_OF_RECORDS
from pitchpoint.report.diagnosis.change_words import change_sentences, feature_words, trend_sentences
from pitchpoint.report.diagnosis.reference import Change, Trend
from pitchpoint.report.diagnosis.tables import rows_html
from pitchpoint.report.diagnosis.words import percent
from pitchpoint.viz.quantities import number
from pitchpoint.viz.reference_plot import plot_band_changes, plot_distances
from pitchpoint.viz.report.page import Section, page
from pitchpoint.viz.tables import plain_table

LISTED = 20
HEAD = ("channel", "feature", "healthy [dB]", "deviation [dB]", "spread [dB]", "by chance")
ABOUT = (
    "Distance: root mean square of deviation over spread of all features. Spread: standard deviation of the "
    "difference of a further healthy record, from the scatter of the healthy ones. The limit is the largest "
    "distance of a healthy record from the others. Healthy records of one session do not contain the changes "
    "between sessions, such as temperature and the mounting of machine and sensors: these are changes, too."
)


def change_section(change: Change, about: str = ABOUT) -> Section:
    """Section of one record: result, distances with their explanation, deviations of bands, largest ones."""
    section = Section("reference", "Comparison with healthy records")
    for text in change_sentences(change):
        section.add(f"<p><b>{escape(text[:1].upper() + text[1:])}.</b></p>")
    if change.limits is not None:
        section.add(f"<p>{about}</p>" if about else "")
        names = [one.file.name for one in change.healthy] + [change.file.file.name]
        distances = np.r_[change.limits.distances, change.found.distance]
        healthy = [True] * len(change.healthy) + [False]
        section.add_figure(
            plot_distances(names, distances, healthy, change.limits.limit),
            "Distance of the record from the healthy ones, and of each healthy one from the others.",
            name="distances",
        )
    _add_bands(section, change)
    section.add("<h3>Largest deviations</h3>")
    section.add(plain_table(HEAD, rows_html(deviation_rows(change, LISTED), 2)))
    items = "".join(f"<li>{escape(text)}</li>" for text in change.notes)
    section.add(f'<ul class="notes">{items}</ul>' if items else "")
    return section


def trend_page(trend: Trend, source: str) -> str:
    """HTML page of a trend; the same trend gives the same text.

    Parameters
    ----------
    trend
        Result of `reference.trend`.
    source
        Name of the folder.
    """
    section = Section("trend", "Trend")
    for text in trend_sentences(trend):
        section.add(f"<p><b>{escape(text[:1].upper() + text[1:])}.</b></p>")
    section.add(f"<p>{ABOUT}</p>")
    changes = trend.changes
    names = [change.file.file.name for change in changes]
    healthy = [_is_healthy(trend, change) for change in changes]
    distances = np.array([change.found.distance for change in changes])
    section.add_figure(
        plot_distances(names, distances, healthy, trend.limits.limit, trend=True, left=trend.left),
        "Distance of every record from the healthy ones.",
    )
    section.add(plain_table(TREND_HEAD, rows_html(trend_rows(trend), 2)))
    items = "".join(f"<li>{escape(text)}</li>" for text in trend.notes)
    section.add(f'<ul class="notes">{items}</ul>' if items else "")
    far = max((c for c, own in zip(changes, healthy, strict=True) if not own), key=lambda c: c.found.distance)
    last = change_section(far, about="")
    last.heading = f"Record with the largest distance, {far.file.file.name}"
    facts = [("folder", Path(source).name), ("records", str(len(changes))), ("version", __version__)]
    return page(f"Trend of {Path(source).name}", facts, [section, last], f"Made by pitchpoint {__version__}.")


TREND_COLUMNS = (
    *TREND_OF_RECORDS.split(","),
    "above the limit",
    "by chance",
    "load",
    "unit of load",
    "speed [rpm]",
    "sentences",
)
TREND_HEAD = ("record", "state", "load", "speed [Hz]", "distance", "limit")


def trend_rows(trend: Trend) -> list[tuple[str, ...]]:
    """Rows of record, state, load, speed, distance, limit."""
    rows: list[tuple[str, ...]] = []
    for change in trend.changes:
        above = change.found.distance > trend.limits.limit
        file, hertz = change.file.file, change.file.frequency
        rows.append(
            (
                file.name,
                "healthy" if _is_healthy(trend, change) else "above the limit" if above else "",
                "–" if file.load is None else f"{file.load:g} {file.unit}".strip(),
                "–" if math.isnan(hertz) else number(hertz, 5),
                f"{change.found.distance:.2f}",
                f"{trend.limits.limit:.2f}",
            )
        )
    return rows


def trend_csv(trend: Trend) -> str:
    """Table of a trend as CSV: a row per record, numbers without units."""
    made = io.StringIO()
    writer = csv.writer(made, lineterminator="\n")
    writer.writerow(TREND_COLUMNS)
    for change in trend.changes:
        file, hertz, distance = change.file.file, change.file.frequency, change.found.distance
        healthy = _is_healthy(trend, change)
        limits = change.limits or trend.limits
        cells: list[object] = [
            file.name,
            "healthy" if healthy else "compared",
            f"{distance:.4g}",
            f"{trend.limits.limit:.4g}",
            "" if healthy else "yes" if distance > trend.limits.limit else "no",
            f"{limits.probability(distance):.3g}",
            "" if file.load is None else f"{file.load:g}",
            file.unit,
            "" if math.isnan(hertz) else f"{60.0 * hertz:.6g}",
            "; ".join(change_sentences(change)),
        ]
        writer.writerow([plain_cell(cell) for cell in cells])
    return made.getvalue()


def deviation_rows(change: Change, count: int) -> list[tuple[str, ...]]:
    """Rows of the largest deviations: channel, feature, healthy value, deviation, spread, probability."""
    found = change.found
    rows: list[tuple[str, ...]] = []
    for k in change.largest[:count]:
        known = np.isfinite(found.spread[k])
        rows.append(
            (
                change.features[k].channel,
                feature_words(change.features[k]),
                f"{found.expected[k]:.1f}",
                f"{found.deviation[k]:+.1f}",
                f"{found.spread[k]:.1f}" if known else "–",
                percent(float(found.probability[k])).replace("less than", "<") if known else "–",
            )
        )
    return rows


def _is_healthy(trend: Trend, change: Change) -> bool:
    """Whether a record of a trend is a healthy one: it is compared with one record less."""
    return len(change.healthy) < len(trend.limits.distances)


def _add_bands(section: Section, change: Change) -> None:
    """Deviations of the bands of all channels."""
    bands = [(k, f) for k, f in enumerate(change.features) if f.kind == "band"]
    limits = {
        f.part: tuple(
            float(text) for text in f.part.removesuffix(" Hz").removeprefix("orders ").split(" to ")
        )
        for _, f in bands
    }
    order = sorted(limits, key=lambda part: limits[part])
    if not order:
        return
    middles = np.array([math.sqrt(limits[part][0] * limits[part][1]) for part in order])
    curves = {}
    for channel in dict.fromkeys(f.channel for _, f in bands):
        at = {f.part: k for k, f in bands if f.channel == channel}
        index = [at[part] for part in order if part in at]
        if len(index) == len(order):
            spread = change.found.spread[index]
            curves[channel] = (change.found.deviation[index], spread if np.isfinite(spread).all() else None)
    over = "frequency" if order[0].endswith("Hz") else "order"
    bars = "" if change.limits is None else " Bars: twice the spread of healthy records."
    section.add_figure(
        plot_band_changes(middles, curves, over=over),
        f"Deviation of the levels in thirds of octaves.{bars}",
        name="bands",
    )
