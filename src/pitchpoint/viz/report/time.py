# SPDX-License-Identifier: Apache-2.0
"""Section of a report with time responses: contact times, bearing forces, curves by meaning."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from html import escape
from typing import Any

import numpy as np

from pitchpoint.analysis.spectra import amplitude_spectrum
from pitchpoint.viz.quantities import Array, Channel, amount, channels, number, window_words
from pitchpoint.viz.report.bearing_forces import QUANTITY, bearing_forces, bearing_table, with_resultants
from pitchpoint.viz.report.contact_times import contact_table
from pitchpoint.viz.report.fatigue import add_fatigue
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.report.planets import planet_table
from pitchpoint.viz.run_record import (
    FORCE_PARTS,
    TIME_QUANTITIES,
    changes_speed,
    channel_word,
    listed,
    owner,
    settled_part,
    statistics_window,
    turning_angle,
    uniform,
)
from pitchpoint.viz.signals_plot import NOISE, plot_force_parts, plot_signals, signal_rows

MAX_LINES = 8
MAX_PARTS = 2
"""Meshes up to which the components of their tooth forces are drawn."""
DETAIL_PERIODS = 12
ROUND_OFF = 1e-8
"""Size of a channel relative to the largest one of the same unit in its group that counts as zero."""
SAMPLES = 20_000
"""Maximum number of samples of a curve; longer records keep the minimum and maximum of equal pieces."""
SAME = 2e-3
"""Difference of two curves relative to their variation that is within the width of a line."""


def time_section(runs: Mapping[str, Any], seen: str = "", overlaid: Collection[str] = ()) -> Section:
    """Section with contact times, bearing forces and curves of the time responses.

    Parameters
    ----------
    runs
        Time responses by name.
    seen
        Run displayed in the scene of the page: its curves share the time of the scene.
    overlaid
        Runs with curves in a common picture: only that of the scene has its own curves.
    """
    section = Section("time", "Time response")
    for name, run in runs.items():
        time, found = channels(run.data)
        if time.size < 2 or not found:
            continue
        found = with_resultants(found)
        section.add_name(name, runs)
        section.add(f"<p>{escape(run.note)}</p>" if run.note else "")
        section.add('<div class="linked">' if name == seen else "")
        settled = settled_part(time, run.settle_time)
        steady = not changes_speed(time[settled], turning_angle(run, found), settled)
        states = {owner(c): c.values for c in found.values() if c.quantity == "contact_state"}
        contact = contact_table(time[settled], {k: v[settled] for k, v in states.items()}, found, settled)
        table = bearing_table(bearing_forces(time, found, settled))
        window = window_words(*statistics_window(time, found, run.settle_time))
        words = f"<p>{escape(window.capitalize())}.</p>"
        section.add(f"<h4>Contact of the flanks</h4>{words}{contact}" if contact else "")
        section.add(f"<h4>Bearing forces</h4>{words}{table}" if table else "")
        shares = planet_table(run.planets)
        section.add(f"<h4>Load sharing of the planets</h4>{words}{shares}" if shares else "")
        add_fatigue(section, run.fatigue, name)
        if name == seen or name not in overlaid:
            constant = [
                words
                for title, names in groups_of(run, found)
                for words in _add_group(
                    section, title, time, [found[n] for n in names if n in found], states, steady
                )
            ]
            constant += _add_force_parts(section, time, found, steady)
            section.add(f"<p>Constant: {escape('; '.join(constant))}.</p>" if constant else "")
        section.add("</div>" if name == seen else "")
    return section


def groups_of(run: Any, found: Mapping[str, Channel]) -> list[tuple[str, Sequence[str]]]:
    """Groups of channels of a run; without groups, the main quantities in their order."""
    if run.groups:
        return list(run.groups)
    wanted = [c.name for q in TIME_QUANTITIES for c in found.values() if listed(c, q)]
    whole = {n for n in wanted if n.endswith((".radial]", ".axial]"))}
    return [("", [n for n in wanted if not n.startswith(QUANTITY) or not whole or n in whole])]


def _add_group(
    section: Section,
    title: str,
    time: Array,
    group: Sequence[Channel],
    states: Mapping[str, Array],
    steady: bool,
) -> list[str]:
    """Add the pictures of one group: one per quantity and unit, and per component of bearing forces.

    Larger components are drawn before smaller ones.

    Returns the constant curves with their values.
    """
    pictures: dict[tuple[str, str], dict[str, list[Channel]]] = {}
    sizes: dict[str, float] = {}
    for channel in group:
        sizes[channel.unit] = max(sizes.get(channel.unit, 0.0), _size(channel))
    for channel in group:
        # contact states are in the table, and shaded where a mesh has a picture of its own
        if channel.quantity != "contact_state" and _size(channel) > ROUND_OFF * sizes[channel.unit]:
            part = channel.name.rpartition(".")[2] if channel.quantity == QUANTITY else ""
            parts = pictures.setdefault((channel.quantity, channel.unit), {})
            parts.setdefault(part, []).append(channel)
    constant: list[str] = []
    headed = False
    ordered = [sorted(parts.values(), key=lambda own: -max(map(_size, own))) for parts in pictures.values()]
    for curves in (curves for parts in ordered for curves in parts):
        drawn, still, words = distinct(curves)
        constant += still
        if (drawn or words) and not headed:
            section.add(f"<h4>{escape(title)}</h4>" if title else "")
            headed = True
        if drawn:
            alone = len(drawn) == 1 and drawn[0].quantity == "mesh_force"
            _add_signals(section, time, drawn, states.get(owner(drawn[0])) if alone else None, steady)
        section.add(f"<p>{escape(' '.join(words))}</p>" if words else "")
    return constant


def _size(channel: Channel) -> float:
    """Largest absolute value of a channel."""
    return float(np.nanmax(np.abs(channel.values), initial=0.0))


def distinct(group: Sequence[Channel]) -> tuple[list[Channel], list[str], list[str]]:
    """Curves of one quantity to be drawn, constant ones with their values, sentences about the others.

    Constant curves are numbers; a curve equal to another one, for speeds up to the gear ratio, is drawn once;
    of more than `MAX_LINES` curves, those with the largest values are drawn.
    """
    constant: list[str] = []
    others: list[Channel] = []
    copies: list[str] = []
    for channel in group:
        if is_constant(channel):
            constant.append(constant_words(channel))
            continue
        twin = next(((one, k) for one in others if (k := _ratio(one, channel)) is not None), None)
        if twin is None:
            others.append(channel)
        else:
            place, other = (c.label.partition(", ")[2] or c.label for c in (channel, twin[0]))
            factor = "" if twin[1] == 1.0 else f" times {number(twin[1], 4)}"
            copies.append(f"{place} as {other}{factor}")
    words = [f"Equal curves are drawn once: {', '.join(copies)}."] if copies else []
    if len(others) > MAX_LINES:
        order = sorted(others, key=lambda c: -_size(c))[:MAX_LINES]
        more = len(others) - MAX_LINES
        is_are = "is" if more == 1 else "are"
        words.append(
            f"Drawn: the {MAX_LINES} curves with the largest values; "
            f"{more} more {channel_word(more)} {is_are} in the result."
        )
        others = [c for c in others if any(c is one for one in order)]
    return others, constant, words


def is_constant(channel: Channel) -> bool:
    """Whether a channel varies by no more than round-off."""
    finite = bool(np.all(np.isfinite(channel.values)))
    return finite and float(np.ptp(channel.values)) <= NOISE * _size(channel)


def constant_words(channel: Channel) -> str:
    """Name and value of a constant channel."""
    return f"{channel.label}: {amount(float(channel.values.mean()), channel.unit)}"


def _ratio(one: Channel, other: Channel) -> float | None:
    """Factor between two curves that differ by less than a line: any for speeds, else 1 or -1."""
    a, b = one.values, other.values
    if not (np.all(np.isfinite(a)) and np.all(np.isfinite(b))):
        return None
    tried = [1.0, -1.0]
    if one.quantity == "speed" and float(a @ a) > 0.0:
        tried = [float(a @ b) / float(a @ a)]
    limit = SAME * float(np.ptp(b))
    return next((k for k in tried if float(np.abs(b - k * a).max()) <= limit), None)


def _add_signals(
    section: Section, time: Array, drawn: Sequence[Channel], state: Array | None, steady: bool
) -> None:
    """Add plots of the signals of one quantity over the whole run and, if steady, over the last periods."""
    part = _last_periods(time, drawn[0].values) if steady else slice(None)
    end, rows = None, signal_rows(drawn)
    if part.start is not None:
        last = [replace(c, values=c.values[part]) for c in drawn]
        # the last periods are settled: their ranges determine the curves that share an axis
        rows = signal_rows(last)
        shown = None if state is None else state[part]
        end = plot_signals(time[part], last, contact_state=shown, points=SAMPLES, rows=rows, half=True)
    whole = plot_signals(time, drawn, contact_state=state, points=SAMPLES, rows=rows, half=end is not None)
    words = _curve_words(drawn[0]) if len(drawn) == 1 else ""
    section.add_figure(whole, words, name=drawn[0].quantity, beside=end)


def _curve_words(channel: Channel) -> str:
    """Caption of a picture with one curve, which has no other name; its element is in it.

    Examples
    --------
    >>> _curve_words(Channel("torque[shaft]", np.zeros(2), "N m", "torque on the first body"))
    'Torque, shaft: torque on the first body.'
    """
    name, long = channel.label, channel.long_name
    words = long if long and owner(channel) in long else f"{name}: {long}" if long else name
    return f"{words[:1].upper()}{words[1:]}."


def _add_force_parts(section: Section, time: Array, found: Mapping[str, Channel], steady: bool) -> list[str]:
    """Add the components of the tooth forces of up to `MAX_PARTS` meshes; returns constant ones in words."""
    own = [c for q in FORCE_PARTS for c in found.values() if c.quantity == q and np.any(c.values != 0.0)]
    parts = [c for c in own if not is_constant(c)]
    still = [constant_words(c) for c in own if is_constant(c)]
    pictures = dict.fromkeys((owner(c), c.unit) for c in parts)
    if len(pictures) > MAX_PARTS:
        section.add(
            f"<p>Components of the tooth forces of {len(pictures)} meshes are in the section Extremes.</p>"
        )
        return []
    for mesh, unit in pictures:
        tooth = [c for c in parts if owner(c) == mesh and c.unit == unit]
        part = _last_periods(time, tooth[0].values) if steady else slice(None)
        shown = [Channel(c.name, c.values[part], c.unit, c.long_name) for c in tooth]
        where = "over the last periods" if part.start is not None else "over the whole run"
        section.add_figure(
            plot_force_parts(time[part], shown, points=SAMPLES),
            f"Components of the tooth force of {mesh}, {where}.",
            name=f"tooth_force[{mesh}]",
        )
    return still


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
