# SPDX-License-Identifier: Apache-2.0
"""The table of analysis functions that work on datasets: a new tool is one row.

A row says which function it is, what of its arguments comes from the dataset, and what the fields of its
result are: dimensions (those with a field of their own name have coordinates) and units, where `{u}` is the
unit of the channel.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

SOURCES = ("values", "sample_rate", "time", "start", "angle", "samples_per_revolution")
"""What a dataset can give: samples of the channel, sample rate [Hz], times [s], the first time [s], angle of
a shaft at the same samples [rad], samples per revolution of a signal over an angle [-]."""


@dataclass(frozen=True)
class Output:
    """One field of a result.

    Attributes
    ----------
    field
        Name in the dataclass.
    dims
        Dimensions, separated by spaces; empty for a number.
    unit
        SI unit; `{u}` is that of the channel, `{u2}` its square.
    name
        Name in the dataset, if it is another one.
    """

    field: str
    dims: str = ""
    unit: str = "1"
    name: str = ""

    @property
    def variable(self) -> str:
        """Name in the dataset."""
        return self.name or self.field


@dataclass(frozen=True)
class Tool:
    """One row of the table.

    Attributes
    ----------
    home
        Module and function inside `pitchpoint.analysis`.
    summary
        What it gives, in a line.
    takes
        Arguments that come from the dataset, each of `SOURCES`; all others are options.
    outputs
        Fields of the result.
    picture
        How it is drawn: `spectrum`, `order_spectrum`, `order_map`, `time_frequency`, or `lines`.
    """

    home: str
    summary: str
    takes: tuple[str, ...]
    outputs: tuple[Output, ...]
    picture: str = "lines"

    def load(self) -> Callable[..., Any]:
        """The function."""
        module, _, name = self.home.rpartition(".")
        found: Callable[..., Any] = getattr(importlib.import_module(f"pitchpoint.analysis.{module}"), name)
        return found


def _spectrum(axis: str, unit: str) -> tuple[Output, ...]:
    """Fields of `spectra.Spectrum` over frequency or order."""
    return (
        Output("frequency", axis, unit, axis),
        Output("amplitude", axis, "{u}"),
        Output("mean", "", "{u}"),
        Output("resolution", "", unit),
        Output("noise_bandwidth", "", unit),
    )


TOOLS: dict[str, Tool] = {
    "signal_statistics": Tool(
        "statistics.signal_statistics",
        "Mean, rms of the alternating part, smallest and largest value.",
        ("values", "time"),
        (
            Output("mean", "", "{u}"),
            Output("rms", "", "{u}"),
            Output("min", "", "{u}"),
            Output("max", "", "{u}"),
        ),
    ),
    "amplitude_spectrum": Tool(
        "spectra.amplitude_spectrum",
        "Peak amplitudes over frequency.",
        ("values", "sample_rate"),
        _spectrum("frequency", "Hz"),
        "spectrum",
    ),
    "power_spectral_density": Tool(
        "spectra.power_spectral_density",
        "Power spectral density over frequency, averaged over segments.",
        ("values", "sample_rate"),
        (
            Output("frequency", "frequency", "Hz"),
            Output("density", "frequency", "{u2}/Hz"),
            Output("n_segments"),
        ),
    ),
    "time_frequency_map": Tool(
        "time_frequency.time_frequency_map",
        "Amplitudes over time and frequency.",
        ("values", "sample_rate", "start"),
        (
            Output("time", "time", "s"),
            Output("frequency", "frequency", "Hz"),
            Output("amplitude", "time frequency", "{u}"),
        ),
        "time_frequency",
    ),
    "resample_over_angle": Tool(
        "orders.resample_over_angle",
        "The signal at equal steps of a shaft angle.",
        ("values", "angle"),
        (Output("angle", "angle", "rad"), Output("values", "angle", "{u}"), Output("samples_per_revolution")),
    ),
    "order_spectrum": Tool(
        "spectra.order_spectrum",
        "Peak amplitudes over orders, of a signal over an angle.",
        ("values", "samples_per_revolution"),
        _spectrum("order", "1"),
        "order_spectrum",
    ),
    "tracked_spectrum": Tool(
        "orders.tracked_spectrum",
        "Peak amplitudes over orders of a shaft, of a signal over time.",
        ("values", "angle"),
        _spectrum("order", "1"),
        "order_spectrum",
    ),
    "order_map": Tool(
        "orders.order_map",
        "Amplitudes over time and orders of a run-up.",
        ("values", "angle", "time"),
        (
            Output("time", "time", "s"),
            Output("speed", "time", "rad/s"),
            Output("order", "order"),
            Output("amplitude", "time order", "{u}"),
        ),
        "order_map",
    ),
}
