# SPDX-License-Identifier: Apache-2.0
"""Rows of the table of tools: function, arguments from the dataset, fields of the result."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

SOURCES = ("values", "sample_rate", "time", "start", "angle", "samples_per_revolution", "average")
"""Arguments that come from a dataset: samples of the channel, sample rate [Hz], times [s], first time [s],
shaft angle at the samples [rad]; for a signal over an angle its samples per revolution [-] and, as `average`,
its samples."""


@dataclass(frozen=True)
class Output:
    """One field of a result.

    Attributes
    ----------
    field
        Name in the dataclass; `lines.amplitude` is a field of its field `lines`.
    dims
        Dimensions, separated by spaces; empty for a scalar.
    unit
        SI unit; `{u}`: of the channel, `{u2}`: its square, `{squared}`: its square if that option is set.
    name
        Name in the dataset, if it is different.
    """

    field: str
    dims: str = ""
    unit: str = "1"
    name: str = ""

    @property
    def variable(self) -> str:
        """Name in the dataset."""
        return self.name or self.field.rpartition(".")[2]


@dataclass(frozen=True)
class Tool:
    """One row of the table.

    Attributes
    ----------
    home
        Module and function in `pitchpoint.analysis`.
    summary
        Description of the result in one line.
    takes
        Arguments that come from the dataset, all in `SOURCES`; the others are options.
    outputs
        Fields of the result.
    picture
        Type of plot: a name in `viz.analysis_pictures.PICTURES`, or `lines` for one curve per field.
    without
        Fields that are not stored in a dataset, such as arrays of different lengths.
    """

    home: str
    summary: str
    takes: tuple[str, ...]
    outputs: tuple[Output, ...]
    picture: str = "lines"
    without: tuple[str, ...] = ()

    def load(self) -> Callable[..., Any]:
        """Import the function."""
        module, _, name = self.home.rpartition(".")
        found: Callable[..., Any] = getattr(importlib.import_module(f"pitchpoint.analysis.{module}"), name)
        return found


def spectrum_outputs(axis: str, unit: str, of: str = "{u}") -> tuple[Output, ...]:
    """Fields of `spectra.Spectrum` over frequency or order.

    Parameters
    ----------
    axis
        Dimension, `frequency` or `order`.
    unit
        Its unit.
    of
        Unit of the amplitudes.
    """
    return (
        Output("frequency", axis, unit, axis),
        Output("amplitude", axis, of),
        Output("mean", "", of),
        Output("resolution", "", unit),
        Output("noise_bandwidth", "", unit),
    )
