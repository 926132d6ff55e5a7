# SPDX-License-Identifier: Apache-2.0
"""Plots of each kind of result by name, from the sections of a report; the main plot is the first."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

Figures = Mapping[str, "go.Figure"]
FORCES = ("mesh_force", "bearing_force", "coupling_force", "bushing_force", "contact_force", "tension")
"""Quantities of an equilibrium in its main plot."""


def analysis_figures(data: xr.Dataset) -> Figures:
    """Plots of a tool of `analyse`, by tool and channel."""
    from pitchpoint.viz.analysis_page import plot_analysis, results_by_channel

    tool = str(data.attrs["tool"])
    found: dict[str, go.Figure] = {}
    for channel, one in results_by_channel(data).items():
        for k, figure in enumerate(plot_analysis(one, channel), start=1):
            found[f"{tool}[{channel}]{f' {k}' if k > 1 else ''}"] = figure
    return found


def frequency_response_figures(data: xr.Dataset) -> Figures:
    """Amplitude and phase over frequency."""
    from pitchpoint.viz.report.responses import response_section

    return response_section({"": data}).figures


def mesh_response_figures(data: xr.Dataset) -> Figures:
    """Order cuts and maps of the response to transmission errors."""
    return frequency_response_figures(data)


def campbell_figures(data: xr.Dataset) -> Figures:
    """Campbell diagram."""
    from pitchpoint.report.campbell import KEPT
    from pitchpoint.viz.report.campbell import campbell_section

    options = _options(data)
    missing = {key: options[key] for key in KEPT if key in options and key not in data.attrs}
    return campbell_section({"": data.assign_attrs(missing)}).figures


def study_figures(data: xr.Dataset) -> Figures:
    """Distribution, sensitivities, result over the factors and convergence of every result of a study."""
    from pitchpoint.report.study_result import study_summary
    from pitchpoint.viz.study_page import result_sections

    found: dict[str, go.Figure] = {}
    for section in result_sections(study_summary(data)):
        found |= section.figures
    return found


def relief_figures(data: xr.Dataset) -> Figures:
    """Transmission error without and with the designed modifications."""
    from pitchpoint.viz.report.relief import relief_section

    return relief_section({"": data}).figures


def contact_figures(data: xr.Dataset) -> Figures:
    """Contact pattern, and curves over path, face width and mesh cycle."""
    from pitchpoint.viz.report.contact import contact_result, contact_section

    return contact_section({"": contact_result(data)}).figures


def meshes_figures(analyses: Mapping[str, xr.Dataset]) -> Figures:
    """Line loads of all meshes over the face width, and the plots of each mesh."""
    from pitchpoint.viz.report.contact import contact_result, overview_section

    known = {name: contact_result(one) for name, one in analyses.items() if one["transmission_error"].size}
    found = dict(overview_section(known, {}).figures) if known else {}
    for name in known:
        found |= {f"{key}[{name}]": figure for key, figure in contact_figures(analyses[name]).items()}
    return found


def quasi_static_figures(data: xr.Dataset) -> Figures:
    """Transmission error of each mesh over the rolled periods."""
    from pitchpoint.report.rolls import given_roll
    from pitchpoint.viz.report.cycles import roll_section

    return roll_section({"": given_roll(data)}).figures


def sweep_figures(data: xr.Dataset) -> Figures:
    """Resonance curves with jumps, contact loss and closing speeds, of all meshes and of each."""
    from pitchpoint.report.study_data import sweep_of
    from pitchpoint.viz.report.sweeps import sweep_section
    from pitchpoint.viz.sweep_plot import plots_of_each

    sweep = sweep_of(data)
    return {**sweep_section({"": sweep}).figures, **plots_of_each(sweep["points"], sweep["jumps"])}


def cases_figures(data: xr.Dataset) -> Figures:
    """Results over the varied value."""
    from pitchpoint.report.study_data import case_table
    from pitchpoint.viz.report.cases import case_section

    return case_section({"": case_table(data)}).figures


def modes_figures(data: xr.Dataset) -> Figures:
    """Strain energies of the modes."""
    from pitchpoint.viz.report.build import ModeData
    from pitchpoint.viz.report.tables import mode_section

    listed = "component" in data.dims  # a system without strain energy has no component
    modes = ModeData(
        names=[str(x) for x in data["name"].values],
        frequency=data["frequency"].values.tolist(),
        damping_ratio=data["damping_ratio"].values.tolist(),
        components=[str(x) for x in data["component"].values] if listed else (),
        strain_share=data["strain_share"].transpose("mode", "component").values if listed else (),
    )
    return mode_section({"": modes}).figures


def equilibrium_figures(data: xr.Dataset) -> Figures:
    """Forces of meshes and supports; every quantity."""
    from pitchpoint.report.run_pictures import chosen_channels
    from pitchpoint.viz.quantities import Channel
    from pitchpoint.viz.rest_plot import plot_rest

    groups: dict[tuple[str, str], list[Channel]] = {}
    main: list[Channel] = []
    resultants = chosen_channels(data, [str(name) for name in data.data_vars if "[" in str(name)])
    for name, array in data.data_vars.items():
        if array.dims or "[" not in str(name):
            continue
        channel = Channel(str(name), np.asarray(array.values), str(array.attrs.get("units", "")))
        groups.setdefault((channel.quantity, channel.unit), []).append(channel)
        shown = channel.quantity in FORCES and channel.unit == "N" and channel.name in resultants
        if shown and float(channel.values) != 0.0:
            main.append(channel)
    main.sort(key=lambda channel: FORCES.index(channel.quantity))
    found = {"forces": plot_rest(main)} if main else {}
    for (quantity, unit), group in groups.items():
        found[quantity if quantity not in found else f"{quantity} [{unit}]"] = plot_rest(group)
    return found


def _options(data: xr.Dataset) -> dict[str, Any]:
    """Options of a result; its attributes contain them as JSON."""
    found = json.loads(str(data.attrs.get("options") or "{}"))
    return found if isinstance(found, dict) else {}
