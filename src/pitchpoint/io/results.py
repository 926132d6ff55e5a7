# SPDX-License-Identifier: Apache-2.0
"""Common interface for writing and reading result files.

`writing` streams time series, `tables` and `sweep_store` write tables, `reading` opens all of them;
`container` is the common netCDF-4/HDF5 file.
"""

from __future__ import annotations

from pitchpoint.io.container import FAILED, FINISHED, INTERRUPTED, RUNNING, Header, ResultError
from pitchpoint.io.reading import list_channels, open_result, read_channel, read_header
from pitchpoint.io.sweep_store import SweepWriter, read_sweep
from pitchpoint.io.tables import Axis, Quantity, TableWriter, write_tables
from pitchpoint.io.writing import Channel, ResultWriter, RunningStatistics

__all__ = [
    "FAILED",
    "FINISHED",
    "INTERRUPTED",
    "RUNNING",
    "Axis",
    "Channel",
    "Header",
    "Quantity",
    "ResultError",
    "ResultWriter",
    "RunningStatistics",
    "SweepWriter",
    "TableWriter",
    "list_channels",
    "open_result",
    "read_channel",
    "read_header",
    "read_sweep",
    "write_tables",
]
