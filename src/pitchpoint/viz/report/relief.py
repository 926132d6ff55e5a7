# SPDX-License-Identifier: Apache-2.0
"""Section of a report with relief designs: modifications, peak-to-peak errors, Harris map."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz.quantities import amount
from pitchpoint.viz.relief_plot import plot_relief
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.tables import plain_table

if TYPE_CHECKING:
    import xarray as xr

_DESIGNS = ("start", "optimum", "rounded")


def relief_section(designs: Mapping[str, xr.Dataset]) -> Section:
    """Section with relief designs by the name of the mesh."""
    section = Section("relief", "Relief design")
    for name, data in designs.items():
        section.add_name(name, designs)
        section.add(_modifications(data))
        section.add(_errors(data))
        section.add_figure(
            plot_relief(data),
            "Transmission error over the mesh phase without and with the rounded modifications, and its "
            "peak-to-peak value over the torque on gear 1 with the band of tolerances and misalignments.",
            name="relief",
        )
    return section


def _row(name: str, cells: Sequence[str]) -> str:
    """Row of a table."""
    body = "".join(f'<td class="num">{escape(cell)}</td>' for cell in cells)
    return f'<tr><th scope="row">{escape(name)}</th>{body}</tr>'


def _length(value: float) -> str:
    """Length, an en dash if there is none."""
    return amount(float(value), "m") if np.isfinite(value) else "–"


def _modifications(data: xr.Dataset) -> str:
    """Table of the modifications of all designs, with tolerances."""
    rows = []
    for k, path in enumerate(data["variable"].values):
        wide = float(data["tolerance"][k])
        cells = [_length(float(data["value"].sel(design=d)[k])) for d in _DESIGNS]
        rows.append(_row(str(path), [*cells, f"±{_length(wide)}" if wide else "–"]))
    return plain_table(("modification", *_DESIGNS, "tolerance"), rows)


def _errors(data: xr.Dataset) -> str:
    """Table of the peak-to-peak errors over the torques."""
    nominal = data["peak_to_peak"].max("misalignment")
    rows = []
    for k, torque in enumerate(data["torque"].values):
        cells = [_length(float(nominal.sel(design=d)[k])) for d in _DESIGNS]
        worst = _length(float(data["peak_to_peak_max"].sel(design="rounded")[k]))
        rows.append(_row(amount(float(torque), "N m"), [*cells, worst]))
    head = [f"TE p–p, {design}" for design in _DESIGNS]
    return plain_table(("torque", *head, "rounded, worst"), rows)
