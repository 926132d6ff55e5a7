# SPDX-License-Identifier: Apache-2.0
"""Section of a report with spectra, orders and maps of run-ups."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import Any

import numpy as np

from pitchpoint.analysis.orders import highest_resolved_order, one_way, order_map, tracked_spectrum
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.spectra import amplitude_spectrum
from pitchpoint.analysis.time_frequency import time_frequency_map
from pitchpoint.viz import spectrum_plots
from pitchpoint.viz.quantities import Array, Channel, channels
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.run_record import (
    MAP_TURNS,
    ORDER_TURNS,
    changes_speed,
    geared_speeds,
    owner,
    settled_part,
    turning_angle,
    turns_of,
    uniform,
)
from pitchpoint.viz.spectrum_plots import Shafts

QUANTITIES = ("deflection", "mesh_force")
MAX_CHANNELS = 8


def spectrum_section(
    runs: Mapping[str, Any], highest_order: float, shafts: Mapping[str, str] | None = None
) -> Section:
    """Section with spectra and orders of steady runs, and maps of run-ups.

    Parameters
    ----------
    runs
        Time responses by name.
    highest_order
        End of the order axis, if a run does not set it.
    shafts
        Body of gear 1 by name of the mesh: reference of the orders of its channels.
    """
    section = Section("spectra", "Spectra and orders")
    for name, run in runs.items():
        time, found = channels(run.data)
        picked = [c for q in QUANTITIES for c in found.values() if c.quantity == q]
        if time.size < 64 or not picked:
            continue
        section.add(f"<h3>{escape(name)}</h3>" if len(runs) > 1 else "")
        window = settled_part(time, run.settle_time)
        orders = run.highest_order or highest_order
        for channel in picked[:MAX_CHANNELS]:
            signal = Channel(channel.name, channel.values[window], channel.unit, channel.long_name)
            angle = turning_angle(run, found, (shafts or {}).get(owner(channel), ""))
            if angle is None:
                _add_spectrum(section, signal, time[window])
                continue
            turns = angle.values[window]
            named = Shafts(owner(angle), geared_speeds(time[window], angle, found, window))
            if changes_speed(time[window], angle, window):
                _add_maps(section, signal, time[window], turns, orders, named)
            else:
                _add_spectrum(section, signal, time[window])
                _add_order_spectrum(section, signal, turns, orders, named)
    return section


def _add_spectrum(section: Section, channel: Channel, time: Array) -> None:
    values, rate = uniform(time, channel.values)
    section.add_figure(
        spectrum_plots.plot_spectrum({channel.label: amplitude_spectrum(values, rate)}, unit=channel.unit)
    )


def _add_order_spectrum(
    section: Section, channel: Channel, angle: Array, highest: float, shafts: Shafts
) -> None:
    name = channel.label
    try:
        _long_enough(angle, ORDER_TURNS)
        spectrum = tracked_spectrum(channel.values, angle, highest_order=highest)
    except SignalError as reason:
        section.add(f"<p>No order spectrum of {escape(name)}: {escape(str(reason))}.</p>")
        return
    section.add_figure(
        spectrum_plots.plot_spectrum({name: spectrum}, unit=channel.unit, over="order", shafts=shafts),
    )


def _add_maps(
    section: Section, channel: Channel, time: Array, angle: Array, highest: float, shafts: Shafts
) -> None:
    values, rate = uniform(time, channel.values)
    top = min(0.5 * rate, highest * _top_speed(time, angle) / (2.0 * np.pi))
    data = time_frequency_map(values, rate, highest_frequency=top, start=float(time[0]))
    section.add_figure(
        spectrum_plots.plot_time_frequency(data, unit=channel.unit, quantity=channel.label),
        "Amplitudes over time and frequency: orders rise with the speed, resonances remain constant.",
    )
    try:
        _long_enough(angle, MAP_TURNS)
        shown = min(highest, highest_resolved_order(angle))
        tracked = order_map(channel.values, angle, time, highest_order=shown, revolutions=_frame(angle))
    except SignalError as reason:
        section.add(f"<p>No order map of {escape(channel.label)}: {escape(str(reason))}.</p>")
        return
    section.add_figure(
        spectrum_plots.plot_order_map(tracked, unit=channel.unit, quantity=channel.label, shafts=shafts),
        "Amplitudes over order and speed: orders are vertical lines, resonances are hyperbolas.",
    )


def _long_enough(angle: Array, limit: float) -> None:
    """Reject angles with too few revolutions in one direction."""
    turns = turns_of(one_way(angle))
    if turns < limit:
        raise SignalError(f"angle: {turns:.3g} revolutions (limit {limit:g}); use a longer record")


def _top_speed(time: Array, angle: Array) -> float:
    marks = np.linspace(0, time.size - 1, min(101, time.size)).round().astype(np.int64)
    return float(np.abs(np.diff(angle[marks]) / np.diff(time[marks])).max())


def _frame(angle: Array) -> float:
    """Revolutions per frame: 1/40 of the run, between one and eight."""
    return float(np.clip(np.floor(turns_of(angle) / 40.0), 1.0, 8.0))
