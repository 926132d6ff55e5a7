# SPDX-License-Identifier: Apache-2.0
"""A whole dataset in the result container: every variable over its own dimensions."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from pitchpoint.io.container import Header
from pitchpoint.io.tables import Axis, Quantity, write_tables

if TYPE_CHECKING:
    import xarray as xr


def write_dataset(path: str | os.PathLike[str], header: Header, data: xr.Dataset, **ending: Any) -> None:
    """Write a dataset of numbers to a result file.

    Parameters
    ----------
    path
        File to write.
    header
        Provenance; attributes of the dataset that the file is to contain are among its options.
    data
        Dataset; dimensions without coordinate are numbered.
    **ending
        Final status, as for `write_tables`.
    """
    axes = [
        Axis(
            str(name),
            data[name].values.tolist() if name in data.coords else list(range(size)),
            unit=str(data[name].attrs.get("units", "")) if name in data.coords else "",
            long_name=str(data[name].attrs.get("long_name", "")) if name in data.coords else "",
        )
        for name, size in data.sizes.items()
    ]
    filled = [
        (
            Quantity(
                str(name),
                tuple(map(str, variable.dims)),
                str(variable.attrs.get("units", "")),
                str(variable.attrs.get("long_name", "")),
            ),
            variable.values,
        )
        for name, variable in data.data_vars.items()
    ]
    write_tables(path, header, axes, filled, **ending)
