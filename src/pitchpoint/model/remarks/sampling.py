# SPDX-License-Identifier: Apache-2.0
"""Remark on samples that are too coarse for the meshes."""

from __future__ import annotations

import math
from collections.abc import Mapping

from pitchpoint.core.errors import Message
from pitchpoint.core.units import format_quantity

HARMONICS = 3
"""Harmonics of the mesh that the recommended rate includes."""
PER_PERIOD = 2.56
"""Samples per period of the highest of them, as in `analysis.bandwidth`."""


def coarse_samples(rate: float, frequencies: Mapping[str, float], where: str) -> tuple[Message, ...]:
    """Note on samples that show meshes as false lines, since their frequency is at least half the rate.

    Parameters
    ----------
    rate
        Sample rate [Hz].
    frequencies
        Highest mesh frequency by mesh [Hz].
    where
        Key of the sample rate.

    Examples
    --------
    >>> message, = coarse_samples(1000.0, {"stage": 1200.0, "slow": 300.0}, "sample_rate")
    >>> message.value, message.remedy
    ('1000 Hz', 'for 3 harmonics give 9220 Hz or more')
    >>> coarse_samples(10000.0, {"stage": 1200.0}, "sample_rate")
    ()
    """
    mesh = max(frequencies, key=lambda name: frequencies[name], default="")
    if not mesh or frequencies[mesh] < 0.5 * rate:
        return ()
    enough = PER_PERIOD * HARMONICS * frequencies[mesh]
    size = 10.0 ** (math.floor(math.log10(enough)) - 2)  # three digits, rounded up
    given, half, reached, least = (
        format_quantity(f, "frequency", 4)
        for f in (rate, 0.5 * rate, frequencies[mesh], size * math.ceil(enough / size))
    )
    return (
        Message(
            where,
            f"shows nothing above {half}, and the mesh frequency of {mesh} reaches {reached}: its harmonics "
            "appear as false lines at lower frequencies (aliasing)",
            given,
            remedy=f"for {HARMONICS} harmonics give {least} or more",
            kind="note",
        ),
    )
