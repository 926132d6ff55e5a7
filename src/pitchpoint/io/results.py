# SPDX-License-Identifier: Apache-2.0
"""Results on disk: everything that writes or reads a result file, under one roof.

`writing` streams time series, `tables` and `sweep_store` keep tables, `reading` opens any of them;
`container` is the netCDF-4/HDF5 file that they share.
"""

from __future__ import annotations

from pitchpoint.io.container import FAILED, FINISHED, INTERRUPTED, RUNNING, Header, ResultError
from pitchpoint.io.reading import list_channels, open_result, read_blocks, read_channel, read_header
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
    "read_blocks",
    "read_channel",
    "read_header",
    "read_sweep",
    "write_tables",
]
