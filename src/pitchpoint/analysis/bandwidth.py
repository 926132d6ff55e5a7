# SPDX-License-Identifier: Apache-2.0
"""Bandwidth check: harmonics of mesh and shaft frequencies above half the sample rate."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pitchpoint.analysis.sampled import SignalError, positive


def lost_harmonics(sample_rate: float, lines: Mapping[str, float], *, harmonics: int = 3) -> str:
    """Message about the harmonics of lines that a record cannot represent; empty if there are none.

    Parameters
    ----------
    sample_rate
        Sample rate f_s [Hz].
    lines
        Frequencies of the first harmonics [Hz] by name, such as mesh frequencies.
    harmonics
        Number of harmonics of interest of each line [-].

    Returns
    -------
    str
        Message with limit, lost harmonics and sufficient sample rate.

    Raises
    ------
    SignalError
        If the rate or a frequency is not positive.

    Notes
    -----
    Harmonic k of a line f is lost if k f ≥ f_s/2 [1]_. Without an anti-aliasing filter it appears as a false
    line at |k f - n f_s|. The sample rate in the message is 2.56 times the highest harmonic, which includes
    the transition band of such a filter.

    References
    ----------
    .. [1] C. E. Shannon, Communication in the presence of noise, Proceedings of the IRE 37(1), 1949, 10-21.

    Examples
    --------
    >>> text = lost_harmonics(1000.0, {"a": 271.5, "b": 30.0})
    >>> print(text.replace("; ", ";" + chr(10)))
    sample rate: 1000 Hz shows nothing above 500 Hz;
    lost are harmonics 2 and 3 of a (271.5 Hz);
    sample with 2086 Hz or more
    >>> lost_harmonics(25600.0, {"mesh": 1000.0})
    ''
    """
    rate = positive(sample_rate, "sample_rate")
    if harmonics < 1:
        raise SignalError(f"harmonics: {harmonics} (limit >= 1); name how many are of interest")
    parts, needed = [], 0.0
    for name, value in lines.items():
        line = positive(value, name)
        lost = [k for k in range(1, harmonics + 1) if k * line >= 0.5 * rate]
        if lost:
            needed = max(needed, lost[-1] * line)
            parts.append(f"{_counted(lost, harmonics)} of {name} ({line:.6g} Hz)")
    if not parts:
        return ""
    return (
        f"sample rate: {rate:.6g} Hz shows nothing above {0.5 * rate:.6g} Hz; lost are {', '.join(parts)}; "
        f"sample with {np.ceil(2.56 * needed):.0f} Hz or more"
    )


def _counted(lost: list[int], harmonics: int) -> str:
    if len(lost) == harmonics:
        return "all harmonics" if harmonics > 1 else "the first harmonic"
    if len(lost) == 1:
        return f"harmonic {lost[0]}"
    if len(lost) == 2:
        return f"harmonics {lost[0]} and {lost[1]}"
    return f"harmonics {lost[0]} to {lost[-1]}"
