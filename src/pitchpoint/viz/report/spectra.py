# SPDX-License-Identifier: Apache-2.0
"""Section of a report with spectra, orders and maps of run-ups."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.analysis.orders import (
    OrderMap,
    highest_resolved_order,
    order_map,
    tracked_spectrum,
)
from pitchpoint.analysis.sampled import SignalError, one_way
from pitchpoint.analysis.spectra import amplitude_spectrum
from pitchpoint.analysis.time_frequency import time_frequency_map
from pitchpoint.viz import spectrum_plots
from pitchpoint.viz.quantities import Array, Channel, channels
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.report.time import distinct
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
from pitchpoint.viz.tables import common_name

if TYPE_CHECKING:
    import plotly.graph_objects as go

QUANTITIES = ("deflection", "mesh_force")
WITHOUT_MESHES = re.compile(r"(?:bearing|coupling)_force\[.*\.(?:fx|mz)\]")
"""Channels of machines without meshes: forces of bearings across the shaft, which an unbalance rotates, while
their resultant is constant; torques of couplings."""
MAX_CHANNELS = 8
HARMONICS = 12.5
"""End of a frequency axis in mesh frequencies."""
SET = "Meshes of "
"""Beginning of the title of the meshes of a planetary set."""
SIGNIFICANT, BEYOND = 0.01, 1.05
"""Smallest amplitude over the largest one of a map that its order axis contains, and the room behind [-]."""
OVER_SPEED = "Amplitudes over order and speed: orders are vertical lines, resonances are hyperbolas."
OVER_TIME = "Amplitudes over order and time: orders are vertical lines, also where the speed changes."
EQUAL = 5e-3
"""Relative difference of two mesh frequencies that is invisible in a spectrum."""


def spectrum_section(
    runs: Mapping[str, Any],
    highest_order: float,
    shafts: Mapping[str, str] | None = None,
    wanted: Sequence[str] = (),
    overlaid: Collection[str] = (),
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
    wanted
        Channels; default: deflections and mesh forces, of machines without meshes forces of bearings and
        couplings.
    overlaid
        Runs with spectra in a common picture, which are omitted here if their speed is steady.
    """
    section = Section("spectra", "Spectra and orders")
    for name, run in runs.items():
        time, found = channels(run.data)
        picked = [c for q in QUANTITIES for c in found.values() if c.quantity == q]
        if not picked and not wanted:
            picked = [c for name, c in found.items() if WITHOUT_MESHES.fullmatch(name)]
        picked = [found[n] for n in wanted if n in found] if wanted else picked
        if time.size < 64 or not picked:
            continue
        window = settled_part(time, run.settle_time)
        if name in overlaid and not changes_speed(time[window], turning_angle(run, found), window):
            continue
        run = replace(run, mesh_frequencies=_merged(run.mesh_frequencies))
        orders = run.highest_order or highest_order
        kinds = dict.fromkeys(c.quantity for c in picked)
        parts = [distinct([c for c in picked if c.quantity == q]) for q in kinds]
        if sum(len(drawn) for drawn, _, _ in parts) > MAX_CHANNELS:
            parts = parts[-1:]  # of many meshes, the forces
        if not any(drawn for drawn, _, _ in parts):
            continue
        section.add_name(name, runs)
        words = dict.fromkeys(sentence for _, _, own in parts for sentence in own)
        section.add(f"<p>{escape(' '.join(words))}</p>" if words else "")
        missing: dict[str, list[str]] = {}
        for channels_of in _together([c for drawn, _, _ in parts for c in drawn], run.groups):
            channel = channels_of[0]
            signals = [Channel(c.name, c.values[window], c.unit, c.long_name) for c in channels_of]
            angle = turning_angle(run, found, (shafts or {}).get(owner(channel), ""))
            if angle is None:
                _add_spectrum(section, signals, time[window], {})
                continue
            turns = angle.values[window]
            speeds = geared_speeds(time[window], angle, found, window)
            named = Shafts(owner(angle), speeds, _mesh_orders(run, time[window], turns))
            if changes_speed(time[window], angle, window):
                # statistics begin after settling, maps show all of a run-up
                part = slice(None) if _is_one_way(angle.values) else window
                for c in channels_of:
                    whole = Channel(c.name, c.values[part], c.unit, c.long_name)
                    moment, turned = time[part], angle.values[part]
                    _add_maps(section, whole, moment, turned, orders, named, fitted=not run.highest_order)
            else:
                by_order = _order_spectrum(missing, signals, time[window], turns, orders, named)
                _add_spectrum(section, signals, time[window], run.mesh_frequencies, by_order)
        for reason, names in missing.items():
            section.add(f"<p>No order spectrum of {escape('; '.join(names))}: {escape(reason)}.</p>")
    return section


def _together(drawn: Sequence[Channel], groups: Sequence[tuple[str, Sequence[str]]]) -> list[list[Channel]]:
    """Channels of each picture: those of the meshes of a planetary set in one, others alone."""
    sets = [{*names} for title, names in groups if title.startswith(SET)]
    found: dict[tuple[int, str], list[Channel]] = {}
    for k, channel in enumerate(drawn):
        own = next((n for n, names in enumerate(sets) if channel.name in names), len(sets) + k)
        found.setdefault((own, channel.quantity), []).append(channel)
    return list(found.values())


def _merged(frequencies: Mapping[str, float]) -> dict[str, float]:
    """Mesh frequencies; equal ones, up to the speed ripple of a run, under one name."""
    found: list[tuple[list[str], float]] = []
    for mesh, frequency in sorted(frequencies.items(), key=lambda item: item[1]):
        if found and frequency <= (1.0 + EQUAL) * found[-1][1]:
            found[-1][0].append(mesh)
        else:
            found.append(([mesh], frequency))
    order = list(frequencies)  # as in the file, not by the ripple
    return {common_name(sorted(names, key=order.index)): frequency for names, frequency in found}


def default_highest_order(teeth: Sequence[float]) -> float:
    """End of the order axes: slightly above three mesh orders, so that the third one is not on the frame.

    Without teeth: orders of shafts and rolling bearings.
    """
    return 3.2 * max(teeth) if teeth else 10.0


def _is_one_way(angle: Array) -> bool:
    """Whether a shaft never stops or reverses."""
    try:
        one_way(angle)
    except SignalError:
        return False
    return True


def _mesh_orders(run: Any, time: Array, angle: Array) -> dict[str, float]:
    """Orders of the meshes relative to a reference shaft with this angle over the same window."""
    turns_per_second = abs(float(angle[-1] - angle[0])) / float(time[-1] - time[0]) / (2.0 * np.pi)
    if not turns_per_second > 0.0:
        return {}
    return {mesh: frequency / turns_per_second for mesh, frequency in run.mesh_frequencies.items()}


def _add_spectrum(
    section: Section,
    signals: Sequence[Channel],
    time: Array,
    meshes: Mapping[str, float],
    beside: go.Figure | None = None,
) -> None:
    spectra = {}
    for channel in signals:
        values, rate = uniform(time, channel.values)
        spectra[channel.label] = amplitude_spectrum(values, rate)
    # jumps of the stiffness excite all frequencies; those of gears end with a few harmonics of the meshes
    limit = min(HARMONICS * max(meshes.values()), 0.5 * rate) if meshes else None
    last = min(limit, max(map(spectrum_plots.last_peak, spectra.values()))) if limit else None
    drawn = spectrum_plots.plot_spectrum(spectra, unit=signals[0].unit, meshes=meshes, highest=last)
    section.add_figure(
        drawn,
        name=f"spectrum[{signals[0].name}]",
        beside=beside,
        beside_caption="The same over orders.",
        beside_name=f"order_spectrum[{signals[0].name}]",
    )


def _order_spectrum(
    missing: dict[str, list[str]],
    signals: Sequence[Channel],
    time: Array,
    angle: Array,
    highest: float,
    shafts: Shafts,
) -> go.Figure | None:
    """Order spectra; if there are none, the reason with the names of the channels is added to `missing`."""
    try:
        _long_enough(angle, time, ORDER_TURNS)
        spectra = {c.label: tracked_spectrum(c.values, angle, highest_order=highest) for c in signals}
    except SignalError as reason:
        missing.setdefault(str(reason), []).extend(c.label for c in signals)
        return None
    return spectrum_plots.plot_spectrum(spectra, unit=signals[0].unit, over="order", shafts=shafts)


def _add_maps(
    section: Section,
    channel: Channel,
    time: Array,
    angle: Array,
    highest: float,
    shafts: Shafts,
    *,
    fitted: bool,
) -> None:
    """Both maps of a channel; with `fitted`, the axes end with the content."""
    tracked, reason = None, ""
    if fitted:
        highest = max(highest, default_highest_order(list(shafts.meshes.values())))
    try:
        _long_enough(angle, time, MAP_TURNS)
        shown = min(highest, highest_resolved_order(angle))
        tracked = order_map(channel.values, angle, time, highest_order=shown, revolutions=_frame(angle))
        highest = map_end(tracked, shafts.meshes) if fitted else highest
    except SignalError as refused:
        reason = str(refused)
    values, rate = uniform(time, channel.values)
    top = min(0.5 * rate, highest * _top_speed(time, angle) / (2.0 * np.pi))
    data = time_frequency_map(values, rate, highest_frequency=top, start=float(time[0]))
    turning = np.abs(_speed_at(data.time, time, angle)) / (2.0 * np.pi)
    section.add_figure(
        spectrum_plots.plot_time_frequency(
            data,
            unit=channel.unit,
            quantity=channel.label,
            meshes={name: order * turning for name, order in shafts.meshes.items()},
        ),
        "Amplitudes over time and frequency: orders follow the speed, resonances remain constant.",
        name=f"time_frequency[{channel.name}]",
    )
    if tracked is None:
        section.add(f"<p>No order map of {escape(channel.label)}: {escape(reason)}.</p>")
        return
    inside = tracked.order <= highest
    part = replace(tracked, order=tracked.order[inside], amplitude=tracked.amplitude[:, inside])
    section.add_figure(
        spectrum_plots.plot_order_map(part, unit=channel.unit, quantity=channel.label, shafts=shafts),
        OVER_SPEED if tracked.is_run_up else OVER_TIME,
        name=f"order_map[{channel.name}]",
    )
    for note in tracked.notes:
        section.add(f"<p>{escape(note[0].upper() + note[1:])}.</p>")


def map_end(data: OrderMap, meshes: Mapping[str, float]) -> float:
    """End of the order axis of a map: above its last significant line and three orders of the fastest mesh.

    Parameters
    ----------
    data
        The map.
    meshes
        Orders of the meshes by name.

    Examples
    --------
    >>> order, none = np.arange(161.0), np.zeros(1)
    >>> amplitude = 5.0 * (order == 20.0) + 0.5 * (order == 80.0)
    >>> data = OrderMap(none, none, order, amplitude[None], none)
    >>> map_end(data, {"m": 20.0}), map_end(data, {"m": 40.0})
    (84.0, 128.0)
    """
    largest = data.amplitude[:, 1:].max(axis=0, initial=0.0)
    lines = np.flatnonzero(largest >= SIGNIFICANT * largest.max(initial=0.0)) if largest.any() else [-1]
    last = BEYOND * float(data.order[int(lines[-1]) + 1]) if lines[-1] >= 0 else 0.0
    fastest = default_highest_order(list(meshes.values())) if meshes else 0.0
    return float(min(data.order[-1], max(last, fastest) or np.inf))


def _long_enough(angle: Array, time: Array, limit: float) -> None:
    """Reject angles with too few revolutions in one direction."""
    turns = turns_of(one_way(angle, time))
    if turns < limit:
        raise SignalError(f"angle: {turns:.3g} revolutions (limit {limit:g}); use a longer record")


def _top_speed(time: Array, angle: Array) -> float:
    marks = np.linspace(0, time.size - 1, min(101, time.size)).round().astype(np.int64)
    return float(np.abs(np.diff(angle[marks]) / np.diff(time[marks])).max())


def _speed_at(moments: Array, time: Array, angle: Array) -> Array:
    """Mean speeds around instants of a record [rad/s]: over a hundredth of it, within its ends."""
    half = 0.005 * float(time[-1] - time[0])
    before, after = (np.clip(moments + way, time[0], time[-1]) for way in (-half, half))
    angles = (np.interp(at, time, angle) for at in (after, before))
    return np.asarray(np.subtract(*angles) / (after - before))


def _frame(angle: Array) -> float:
    """Revolutions per frame: 1/40 of the run, between one and eight."""
    return float(np.clip(np.floor(turns_of(angle) / 40.0), 1.0, 8.0))
