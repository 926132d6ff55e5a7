# SPDX-License-Identifier: Apache-2.0
"""Sections of a report: one function per section, from data to HTML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from html import escape
from typing import Any

import numpy as np

from pitchpoint.analysis.spectra import amplitude_spectrum
from pitchpoint.analysis.statistics import ContactStatistics, contact_statistics
from pitchpoint.viz.gear_drawing import mesh_zone_svg, pair_svg
from pitchpoint.viz.quantities import Array, Channel, amount, channels, number, scale
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.run_record import (
    FORCE_PARTS,
    TIME_QUANTITIES,
    changes_speed,
    channel_word,
    listed,
    owner,
    settled_part,
    turning_angle,
    uniform,
)
from pitchpoint.viz.signals_plot import plot_force_parts, plot_signals, signal_rows
from pitchpoint.viz.sweep_plot import plot_contact_shares, plot_sweep
from pitchpoint.viz.tables import (
    BEVEL_GEAR_ROWS,
    BEVEL_MESH_ROWS,
    GEAR_ROWS,
    MEASURE_ROWS,
    MESH_ROWS,
    plain_table,
    quantity_table,
)

MAX_LINES = 8
DETAIL_PERIODS = 12
WIDE, HALF = 5000, 2400
"""Points of a curve across the page, and of one of two next to each other: above one bucket per pixel."""


def gear_section(
    gears: Mapping[str, Mapping[str, Any]],
    meshes: Mapping[str, Mapping[str, Any]],
    flanks: Sequence[Sequence[str]] = (),
    bevels: tuple[Mapping[str, Mapping[str, Any]], Mapping[str, Mapping[str, Any]]] = ({}, {}),
    inactive_faults: int = 0,
) -> Section:
    """Section with tables of gear and mesh data, inspection dimensions, flank modifications and deviations.

    `bevels`: bevel gears and their meshes; `inactive_faults`: number of tooth faults with severity 0.
    """
    section = Section("gears", "Gears and meshes")
    section.add(quantity_table(GEAR_ROWS, gears))
    table = quantity_table(MEASURE_ROWS, gears)
    section.add(f"<h3>Inspection dimensions</h3>{table}" if table else "")
    narrow = [name for name, gear in gears.items() if gear.get("span_measurable") is False]
    if narrow:
        section.add(f"<p>Face width too small for the span measurement: {escape(', '.join(narrow))}.</p>")
    if flanks:
        rows = [f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in line)}</tr>" for line in flanks]
        head = ("gear", "flanks", "modification or deviation", "amount", "extent")
        section.add(f"<h3>Flanks</h3>{plain_table(head, rows, numbers=False)}")
    if inactive_faults:
        one = inactive_faults == 1
        waiting = "1 gear fault has" if one else f"{inactive_faults} gear faults have"
        section.add(f"<p>{waiting} severity 0 and no effect.</p>")
    table = quantity_table(MESH_ROWS, meshes)
    section.add(f"<h3>Meshes</h3>{table}" if table else "")
    for title, rows_of, things in zip(
        ("Bevel gears", "Bevel meshes"), (BEVEL_GEAR_ROWS, BEVEL_MESH_ROWS), bevels, strict=True
    ):
        table = quantity_table(rows_of, things)
        section.add(f"<h3>{title}</h3>{table}" if table else "")
    return section


def drawing_section(pairs: Mapping[str, tuple[Any, str, str]]) -> Section:
    """Section with drawings of both gears in mesh and of the mesh zone, per pair."""
    section = Section("drawing", "Gears in mesh")
    for mesh, (pair, first, second) in pairs.items():
        heading = f"<h3>{escape(mesh)}</h3>" if len(pairs) > 1 else ""
        section.add(
            f'{heading}<div class="pair"><figure>{pair_svg(pair, names=(first, second))}</figure>'
            f"<figure>{mesh_zone_svg(pair)}</figure></div>"
        )
    return section


def sweep_section(sweeps: Mapping[str, Mapping[str, Any]]) -> Section:
    """Section with speed sweeps, jumps and contact loss."""
    section = Section("sweep", "Speed sweep")
    for name, sweep in sweeps.items():
        points, jumps = sweep.get("points", ()), sweep.get("jumps", ())
        if not points:
            continue
        section.add(f"<h3>{escape(name)}</h3>" if len(sweeps) > 1 else "")
        for quantity, statistic in (("deflection", "rms"), ("mesh_force", "max")):
            if any(p.get(quantity) for p in points):
                caption = _jump_sentence(jumps) if quantity == "deflection" else ""
                section.add_figure(plot_sweep(points, jumps, quantity=quantity, statistic=statistic), caption)
        if any(float(p.get("contact_loss_share") or 0.0) > 0.0 for p in points):
            section.add_figure(
                plot_contact_shares(points), "Time without contact as a share of the evaluated time."
            )
        elif any(p.get("contact_loss_share") is not None for p in points):
            section.add("<p>The flanks stay in contact at every point of this sweep.</p>")
    return section


def time_section(runs: Mapping[str, Any], seen: str = "") -> Section:
    """Section with signals and contact times of the time responses.

    Parameters
    ----------
    runs
        Time responses by name.
    seen
        Run displayed in the scene of the page: its curves share the time of the scene.
    """
    section = Section("time", "Time response")
    for name, run in runs.items():
        time, found = channels(run.data)
        if time.size < 2 or not found:
            continue
        section.add(f"<h3>{escape(name)}</h3>" if len(runs) > 1 else "")
        section.add(f"<p>{escape(run.note)}</p>" if run.note else "")
        notes = "".join(f"<li>{escape(remark)}</li>" for remark in run.remarks)
        section.add(f'<ul class="notes">{notes}</ul>' if notes else "")
        section.add('<div class="linked">' if name == seen else "")
        settled = settled_part(time, run.settle_time)
        steady = not changes_speed(time[settled], turning_angle(run, found), settled)
        states = {owner(c): c.values for c in found.values() if c.quantity == "contact_state"}
        section.add(_contact_table(time[settled], {k: v[settled] for k, v in states.items()}, found, settled))
        for quantity in TIME_QUANTITIES:
            # channels that are zero throughout (such as friction) are listed in the table only
            group = [c for c in found.values() if listed(c, quantity) and np.any(c.values != 0.0)]
            for unit in dict.fromkeys(c.unit for c in group):
                same = [c for c in group if c.unit == unit]
                state = states.get(owner(same[0])) if len(same) == 1 and quantity == "mesh_force" else None
                _add_signals(section, time, same, state, steady)
        parts = [
            c for q in FORCE_PARTS for c in found.values() if c.quantity == q and np.any(c.values != 0.0)
        ]
        for mesh, unit in dict.fromkeys((owner(c), c.unit) for c in parts):
            tooth = [c for c in parts if owner(c) == mesh and c.unit == unit]
            part = _last_periods(time, tooth[0].values) if steady else slice(None)
            shown = [Channel(c.name, c.values[part], c.unit, c.long_name) for c in tooth]
            where = "over the last periods" if part.start is not None else "over the whole run"
            section.add_figure(
                plot_force_parts(time[part], shown, points=WIDE),
                f"Components of the tooth force of {mesh}, {where}.",
            )
        section.add("</div>" if name == seen else "")
    return section


def _add_signals(
    section: Section, time: Array, group: Sequence[Channel], state: Array | None, steady: bool
) -> None:
    """Add plots of the signals of one quantity over the whole run and, if steady, over the last periods."""
    drawn = group[:MAX_LINES]
    part = _last_periods(time, drawn[0].values) if steady else slice(None)
    end, rows = None, signal_rows(drawn)
    if part.start is not None:
        last = [replace(c, values=c.values[part]) for c in drawn]
        # the last periods are settled: their ranges determine the curves that share an axis
        rows = signal_rows(last)
        shown = None if state is None else state[part]
        end = plot_signals(time[part], last, contact_state=shown, points=HALF, rows=rows)
    points = WIDE if end is None else HALF
    whole = plot_signals(time, drawn, contact_state=state, points=points, rows=rows)
    section.add_figure(whole, _caption(group), beside=end)


def notes_section(warnings: Sequence[str], assumptions: Sequence[str], sources: Sequence[str]) -> Section:
    """Section with warnings, assumptions and sources."""
    section = Section("notes", "Warnings, assumptions, sources")
    for heading, lines, css in (
        ("Warnings", warnings, "notes warnings"),
        ("Assumptions", assumptions, "notes"),
        ("Sources", sources, "notes"),
    ):
        items = "".join(f"<li>{escape(line)}</li>" for line in lines)
        section.add(f'<h3>{heading}</h3><ul class="{css}">{items}</ul>' if items else "")
    return section


def _last_periods(time: Array, values: Array) -> slice:
    """Last dozen periods of a steady record; the whole record if there are few, or no clear period."""
    tail = slice(time.size // 2, None)
    if time[tail].size < 256 or not np.all(np.isfinite(values[tail])):
        return slice(None)
    piece, rate = uniform(time[tail], values[tail])
    spectrum = amplitude_spectrum(piece, rate)
    top = int(np.argmax(spectrum.amplitude[1:])) + 1
    if spectrum.amplitude[top] <= 1e-9 * abs(spectrum.mean) or top < DETAIL_PERIODS * 2:
        return slice(None)
    return slice(int(np.searchsorted(time, time[-1] - DETAIL_PERIODS / spectrum.frequency[top])), None)


def _caption(group: Sequence[Channel]) -> str:
    """Caption: description of a single channel, or the number of channels not drawn."""
    if len(group) > MAX_LINES:
        more = len(group) - MAX_LINES
        verb = "is" if more == 1 else "are"
        return f"{more} more {channel_word(more)} of this kind {verb} in the result file."
    long = group[0].long_name
    return f"{long[:1].upper()}{long[1:]}." if len(group) == 1 and long else ""


def _jump_sentence(jumps: Sequence[Mapping[str, Any]]) -> str:
    if not jumps:
        return "No jump found in this sweep."
    pitch = scale("Hz", [float(j["mesh_frequency"]) for j in jumps])
    places = ", ".join(
        f"{j['direction']} at {number(float(j['mesh_frequency']) * pitch.factor)}" for j in jumps
    )
    return f"Jumps: {places} {pitch.unit} mesh frequency."


def _contact_table(
    time: Array, states: Mapping[str, Array], found: Mapping[str, Channel], settled: np.ndarray
) -> str:
    """Table of contact loss, back contact and impacts per mesh."""
    body = []
    for mesh, state in states.items():
        force = found.get(f"mesh_force[{mesh}]")
        c = contact_statistics(time, state, None if force is None else force.values[settled])
        peaks = [i.peak for i in c.impacts if i.peak is not None]
        counted = found[f"contact_state[{mesh}]"].contact
        if counted is not None:  # at all steps, not at the stored samples
            cells: tuple[str, ...] = _counted_cells(counted, amount(max(peaks), "N") if peaks else "–")
        else:
            cells = _sampled_cells(c, peaks)
        body.append(
            f'<tr><th scope="row">{escape(mesh)}</th><td></td>'
            + "".join(f'<td class="num">{x}</td>' for x in cells)
            + "</tr>"
        )
    impacts = ("impacts", "largest impact", "closing speed", "impulse", "rattle index")
    head = ("mesh", "", "contact loss", "back contact", "longest loss", *impacts)
    return plain_table(head, body) if body else ""


def _counted_cells(counted: Mapping[str, float], largest: str) -> tuple[str, ...]:
    """Cells of a mesh from the numbers of all steps, and its largest force after an impact."""
    impacts = int(counted["front_impacts"] + counted["back_impacts"])
    index = counted["rattle_index"]
    return (
        f"{100.0 * counted['contact_loss_share']:.3g} %",
        f"{100.0 * counted['back_contact_share']:.3g} %",
        amount(counted["longest_loss"], "s") if counted["longest_loss"] > 0.0 else "–",
        str(impacts),
        largest,
        f"{1e3 * counted['closing_speed_max']:.4g} mm/s" if impacts else "–",
        f"{counted['impulse_max']:.4g} N s" if impacts else "–",
        f"{index:.3g}" if np.isfinite(index) else "–",
    )


def _sampled_cells(c: ContactStatistics, peaks: list[float]) -> tuple[str, ...]:
    """Cells of a mesh from the stored samples."""
    return (
        f"{100.0 * c.loss_share:.3g} %",
        f"{100.0 * c.back_contact_share:.3g} %",
        amount(c.longest_loss, "s") if c.separations else "–",
        str(len(c.impacts)),
        amount(max(peaks), "N") if peaks else "–",
        *("–" for _ in range(3)),
    )
