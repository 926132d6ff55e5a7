# SPDX-License-Identifier: Apache-2.0
"""Vibration severity of the channels of a diagnosis: rms velocity, zone of the standard, verdict."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from shlex import quote
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import SignalError, sample_rate_of
from pitchpoint.analysis.severity import ZONES, Severity, vibration_severity
from pitchpoint.core.nearest import hint

Array = NDArray[np.float64]

MEANING = {
    "A": "as of new machines",
    "B": "acceptable for unrestricted operation",
    "C": "not acceptable for long-term operation",
    "D": "severe enough to cause damage",
}


@dataclass(frozen=True)
class ChannelSeverity:
    """Severity of one channel.

    Attributes
    ----------
    channel
        Name of the channel.
    found
        rms velocity and zone.
    group
        Name in `ZONES`; empty for the velocity alone.
    """

    channel: str
    found: Severity
    group: str = ""

    @property
    def is_verdict(self) -> bool:
        """Whether the zone is C or D."""
        return self.found.zone in ("C", "D")

    @property
    def sentence(self) -> str:
        """Severity in words.

        Examples
        --------
        >>> ChannelSeverity("acc", Severity(2.3e-3, (10.0, 1000.0), "B"), "group 2 rigid").sentence
        'vibration severity in acc: 2.3 mm/s rms (10 to 1000 Hz), zone B of ISO 20816-3 group 2, rigid'
        """
        low, high = self.found.band
        size = f"{1e3 * self.found.velocity:.2g} mm/s rms ({low:.4g} to {high:.4g} Hz)"
        text = f"vibration severity in {self.channel}: {size}"
        return f"{text}, zone {self.found.zone} of {standard(self.group)}" if self.group else text

    @property
    def verdict(self) -> str:
        """Sentence with the meaning of the zone."""
        return f"{self.sentence}: {MEANING[self.found.zone]}"

    def as_data(self) -> dict[str, Any]:
        """Plain data, in SI units."""
        return {
            "kind": "severity",
            "channel": self.channel,
            "velocity": self.found.velocity,
            "band": list(self.found.band),
            "zone": self.found.zone,
            "group": self.group,
            "sentence": self.verdict if self.found.zone else self.sentence,
        }


def standard(group: str) -> str:
    """Standard and class of a machine group.

    Examples
    --------
    >>> standard("group 2 rigid"), standard("small")
    ('ISO 20816-3 group 2, rigid', 'ISO 10816-1 class I')
    """
    if group == "small":
        return "ISO 10816-1 class I"
    name, _, support = group.rpartition(" ")
    return f"ISO 20816-3 {name}, {support}"


def machine_group(text: str) -> str:
    """Name in `ZONES` of the option `--machine-group`; the word "group" may be omitted.

    Raises
    ------
    SignalError
        If there is no such group.

    Examples
    --------
    >>> machine_group("2 rigid"), machine_group("small")
    ('group 2 rigid', 'small')
    """
    words = " ".join(text.lower().replace(",", " ").split())
    name = f"group {words}" if words[:1].isdigit() else words
    if name not in ZONES:
        listed = [each.removeprefix("group ") for each in ZONES]
        raise SignalError(f"--machine-group: no group {text!r}; {hint(words.removeprefix('group '), listed)}")
    return name


def severities(
    signals: Mapping[str, Array], time: Array, units: Mapping[str, str], turn: float, group: str
) -> tuple[tuple[ChannelSeverity, ...], list[str]]:
    """Severity of all channels of acceleration or velocity, and remarks.

    Parameters
    ----------
    signals
        Channels over time, shape (n,) each.
    time
        Times [s], shape (n,).
    units
        SI unit of each channel, if known.
    turn
        Rotation frequency of the slowest shaft [Hz]; NaN if it varies.
    group
        Name in `ZONES`; empty for the velocity alone.
    """
    rows = []
    slowest = turn if math.isfinite(turn) else math.inf
    try:
        rate = sample_rate_of(time)
    except SignalError as error:
        return (), [f"vibration severity: {error}"] * bool(group)
    for name, values in signals.items():
        found = vibration_severity(values, rate, units.get(name, ""), turn=slowest, group=group)
        if found is not None:
            rows.append(ChannelSeverity(name, found, group))
    if group and not rows:
        remedy = f"; give the unit, such as --unit {quote(next(iter(signals)) + '=m/s^2')}" if signals else ""
        return (), [
            f"vibration severity: no channel of a housing is an acceleration or velocity up to 100 Hz{remedy}"
        ]
    return tuple(rows), []


def verdicts(rows: Sequence[ChannelSeverity]) -> tuple[str, ...]:
    """Sentences about channels in zones C and D, the highest velocity first."""
    bad = sorted((row for row in rows if row.is_verdict), key=lambda row: -row.found.velocity)
    return tuple(row.verdict for row in bad)
