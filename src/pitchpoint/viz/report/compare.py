# SPDX-License-Identifier: Apache-2.0
"""Section of a report with variants: curves, spectra and sweeps of several results in one picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.analysis.jumps import branch
from pitchpoint.analysis.mesh_sweep import swept_meshes
from pitchpoint.analysis.spectra import amplitude_spectrum
from pitchpoint.viz import theme
from pitchpoint.viz.downsampling import kept_samples
from pitchpoint.viz.quantities import Array, Channel, channel_scale, channels, scale
from pitchpoint.viz.report.bearing_forces import with_resultants
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.report.time import SAME, groups_of, is_constant
from pitchpoint.viz.run_record import changes_speed, channel_word, settled_part, turning_angle, uniform
from pitchpoint.viz.spectrum_plots import plot_spectrum
from pitchpoint.viz.sweep_plot import UNITS, frequency_words

if TYPE_CHECKING:
    import plotly.graph_objects as go

MAX_PICTURES = 16
MAX_SPECTRA = 4
POINTS = 4000
SPECTRA = ("deflection", "mesh_force")
SWEPT = (("deflection", "rms"), ("mesh_force", "max"))


def compare_section(families: Sequence[tuple[str, Mapping[str, str]]], results: Any) -> Section:
    """Section with the variants of each family in common pictures.

    Parameters
    ----------
    families
        Title, and names of runs or sweeps by what distinguishes them.
    results
        `ReportResults` with these runs and sweeps.
    """
    section = Section("comparison", "Comparison")
    for title, members in families:
        section.add_name(title, families)
        runs = {label: results.runs[name] for label, name in members.items() if name in results.runs}
        sweeps = {label: results.sweeps[name] for label, name in members.items() if name in results.sweeps}
        if len(runs) > 1:
            _add_runs(section, runs)
        if len(sweeps) > 1:
            for quantity, statistic in SWEPT:
                section.add_figure(plot_sweeps(sweeps, quantity, statistic))
    return section


def _add_runs(section: Section, runs: Mapping[str, Any]) -> None:
    """Add the common curves of runs, a picture per channel, and the spectra of steady runs."""
    read = {label: channels(run.data) for label, run in runs.items()}
    read = {label: (time, with_resultants(found)) for label, (time, found) in read.items() if time.size > 1}
    first = next(iter(runs))
    equal: list[str] = []
    shown, more, heading = 0, 0, ""
    for title, names in groups_of(runs[first], read[first][1]):
        for name in names:
            curves = {label: (time, found[name]) for label, (time, found) in read.items() if name in found}
            if (
                name.startswith("contact_state")
                or len(curves) < 2
                or all(is_constant(c) for _, c in curves.values())
            ):
                continue
            if _equal(list(curves.values())):
                equal.append(next(iter(curves.values()))[1].label)
                continue
            if shown == MAX_PICTURES:
                more += 1
                continue
            section.add(f"<h4>{escape(title)}</h4>" if title != heading else "")
            heading, shown = title, shown + 1
            section.add_figure(plot_runs(curves))
    if more:
        section.add(f"<p>{more} more common {channel_word(more)} of the results are not drawn.</p>")
    if equal:
        section.add(f"<p>Equal in all results: {escape('; '.join(equal))}.</p>")
    _add_spectra(section, runs, read)


def _add_spectra(section: Section, runs: Mapping[str, Any], read: Mapping[str, Any]) -> None:
    """Add common spectra of the meshes over the windows of the statistics."""
    found: dict[str, dict[str, Any]] = {}
    for label, (time, own) in read.items():
        window = settled_part(time, runs[label].settle_time)
        if window.sum() < 64 or changes_speed(time[window], turning_angle(runs[label], own), window):
            return
        for channel in own.values():
            varied = channel.quantity in SPECTRA and np.all(np.isfinite(channel.values))
            if varied and not is_constant(channel):
                values, rate = uniform(time[window], channel.values[window])
                found.setdefault(channel.name, {})[label] = amplitude_spectrum(values, rate)
    common = {name: spectra for name, spectra in found.items() if len(spectra) > 1}
    section.add("<h4>Spectra</h4>" if common else "")
    for name in list(common)[:MAX_SPECTRA]:
        channel = next(own[name] for _, own in read.values() if name in own)
        section.add_figure(plot_spectrum(common[name], unit=channel.unit, quantity=channel.label))


def plot_runs(curves: Mapping[str, tuple[Array, Channel]]) -> go.Figure:
    """Plot of one channel of several runs over time.

    Parameters
    ----------
    curves
        Times [s], shape (n,), and channel by label.
    """
    one = next(iter(curves.values()))[1]
    shown = channel_scale(one.name, one.unit, np.concatenate([c.values for _, c in curves.values()]))
    clock = scale("s", [float(time[-1]) for time, _ in curves.values()])
    figure = theme.figure(clock.title("time"), shown.title(one.label), height=340)
    for k, (label, (time, channel)) in enumerate(curves.items()):
        kept = kept_samples(channel.values, POINTS)
        figure.add_scatter(
            x=(time[kept] * clock.factor).astype(np.float32),
            y=(channel.values[kept] * shown.factor).astype(np.float32),
            mode="lines",
            name=label,
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 1.3, "simplify": False},
        )
    figure.update_layout(showlegend=True)
    return figure


def plot_sweeps(sweeps: Mapping[str, Mapping[str, Any]], quantity: str, statistic: str) -> go.Figure:
    """Plot of the response of several sweeps over mesh frequency: up solid, down dashed.

    Parameters
    ----------
    sweeps
        Mappings with `points` by label.
    quantity, statistic
        As in `plot_sweep`.
    """
    lines = {
        (label, direction): branch(sweep["points"], direction, quantity, statistic)
        for label, sweep in sweeps.items()
        for direction in ("up", "down")
    }
    lines = {key: line for key, line in lines.items() if line[0].size}
    frequencies = np.concatenate([np.zeros(0), *(f for f, _ in lines.values())])
    levels = np.concatenate([np.zeros(0), *(level for _, level in lines.values())])
    pitch, shown = scale("Hz", frequencies), channel_scale(quantity, UNITS.get(quantity, "m"), levels)
    words = {"rms": "rms", "max": "maximum"}[statistic]
    meshes = {swept_meshes(sweep["points"])[0] for sweep in sweeps.values() if _several(sweep)}
    swept = ", ".join(sorted(meshes))
    title = shown.title(f"{words} of {quantity.replace('_', ' ')}{f', {swept}' if swept else ''}")
    figure = theme.figure(pitch.title(frequency_words(swept)), title, height=400)
    order = list(sweeps)
    for (label, direction), (frequency, level) in lines.items():
        colour = theme.SERIES[order.index(label) % len(theme.SERIES)]
        figure.add_scatter(
            x=frequency * pitch.factor,
            y=level * shown.factor,
            mode="lines",
            name=label if direction == "up" else f"{label}, speed down",
            line={"color": colour, "width": 1.6, "dash": "solid" if direction == "up" else "dot"},
        )
    figure.update_yaxes(rangemode="tozero" if statistic == "rms" else "normal")
    figure.update_layout(showlegend=True)
    return figure


def _several(sweep: Mapping[str, Any]) -> bool:
    """Whether the machine of a sweep has several meshes, so that the plotted one has to be named."""
    return len(swept_meshes(sweep["points"])) > 1


def _equal(curves: Sequence[tuple[Array, Channel]]) -> bool:
    """Whether the curves of all runs differ by less than a line."""
    values = [np.interp(curves[0][0], time, channel.values) for time, channel in curves]
    spread = np.abs(np.array(values) - values[0]).max(initial=0.0)
    return bool(spread <= SAME * max(float(np.ptp(v)) for v in values))
