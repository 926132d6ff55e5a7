# SPDX-License-Identifier: Apache-2.0
"""Kind of a result, by the dimensions of its dataset: solvers, files and analyses have the same."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.rolls import POSITION

if TYPE_CHECKING:
    import xarray as xr

KINDS = {
    "frequency_response": {"frequency", "output", "input"},
    "mesh_response": {"speed", "order", "output"},
    "campbell": {"crossing", "excitation"},
    "relief": {"design", "map_torque"},
    "contact": {"tooth_pair"},
    "quasi_static": {POSITION},
    "study": {"case", "factor", "result"},
    "cases": {"case"},
    "sweep": {"direction", "mesh_frequency"},
    "modes": {"mode"},
    "equilibrium": {"coordinate"},
    "time": {"time"},
}
"""Dimensions that identify a kind, the most specific first."""


def kind_of(data: xr.Dataset) -> str:
    """Kind of a result, as in `attrs["kind"]` of a file: a key of `KINDS`, or `analysis`.

    Raises
    ------
    PitchpointError
        If the dataset is none of these.
    """
    if "tool" in data.attrs:
        return "analysis"
    dimensions = {str(name) for name in data.dims}
    for kind, wanted in KINDS.items():
        if wanted <= dimensions:
            return kind
    over = ", ".join(map(str, data.dims)) or "no dimension"
    raise PitchpointError(
        f"a dataset over {over} is not a result; give a dataset of a solver, of analyse or of open_result; "
        "open a contact file of several meshes by open_result(file, 'meshes/NAME')"
    )
