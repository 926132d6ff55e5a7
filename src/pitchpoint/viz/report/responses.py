# SPDX-License-Identifier: Apache-2.0
"""Section of a report with frequency responses, and with levels by mesh order over the speed."""

from __future__ import annotations

import json
from collections.abc import Mapping
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz.frequency_response_plot import curve_units, input_label, plot_frequency_response
from pitchpoint.viz.mesh_response_plot import order_names, plot_mesh_response
from pitchpoint.viz.quantities import amount, channel_label, number
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.tables import plain_table

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

MAX_ROWS = 40
"""Rows of the table of the largest responses."""


def response_section(responses: Mapping[str, xr.Dataset]) -> Section:
    """Section with datasets of `solve_frequency_response` and `solve_mesh_response` by name."""
    section = Section("responses", "Frequency response")
    for name, data in responses.items():
        section.add_name(name, responses)
        if "order" in data.dims:
            section.add_figure(
                _mesh_response(data),
                "Response to transmission error and shuttling force of every mesh under load: levels over the"
                " speed, dotted: natural frequencies.",
                name="response",
            )
            continue
        section.add(_largest(data))
        section.add_figure(
            _frequency_response(data), "Amplitude per unit of the input, and phase.", name="response"
        )
    return section


def _complex(data: xr.Dataset) -> xr.DataArray:
    """Complex response; a file opened by other programs has two parts."""
    return data["response"] if "response" in data else data["response_real"] + 1j * data["response_imag"]


def _names(data: xr.Dataset, name: str) -> list[str]:
    """Texts of a coordinate."""
    return [str(x) for x in data[name].values]


def _frequency_response(data: xr.Dataset) -> go.Figure:
    """Amplitude and phase over frequency."""
    whole = _complex(data).transpose("frequency", "output", "input").values
    units = curve_units(_names(data, "output_unit"), _names(data, "input_unit"))
    names = _names(data, "output"), _names(data, "input")
    return plot_frequency_response(data["frequency"].values, whole, *names, units)


def _mesh_response(data: xr.Dataset) -> go.Figure:
    """Order cuts and maps of the response to transmission errors."""
    options = json.loads(str(data.attrs.get("options") or "{}"))
    return plot_mesh_response(
        data["speed"].values,
        data["frequency"].transpose("speed", "order").values,
        abs(_complex(data)).transpose("speed", "order", "output").values,
        order_names(data["mesh"].values, data["harmonic"].values),
        _names(data, "output"),
        _names(data, "unit" if "unit" in data else "output_unit"),
        modes=data["mode_frequency"].values,
        shaft=str(options.get("body", "")) if isinstance(options, dict) else "",
    )


def _largest(data: xr.Dataset) -> str:
    """Table of the largest amplitude of every output by every input."""
    size = abs(_complex(data)).transpose("frequency", "output", "input").values
    outputs, inputs = _names(data, "output"), _names(data, "input")
    units = curve_units(_names(data, "output_unit"), _names(data, "input_unit"))
    hertz = data["frequency"].values
    rows = []
    for k, unit in enumerate(units):
        o, i = divmod(k, len(inputs))
        at = int(np.argmax(size[:, o, i]))
        cells = f"{number(float(size[at, o, i]))} {unit}", amount(float(hertz[at]), "Hz")
        label = f"{channel_label(outputs[o])} by {input_label(inputs[i])}"
        values = "".join(f'<td class="num">{escape(cell)}</td>' for cell in cells)
        rows.append(f'<tr><th scope="row">{escape(label)}</th>{values}</tr>')
    more = len(rows) - MAX_ROWS
    note = f"<p>{more} more are in the result file.</p>" if more > 0 else ""
    return plain_table(("response", "maximum", "at"), rows[:MAX_ROWS], words=1) + note
