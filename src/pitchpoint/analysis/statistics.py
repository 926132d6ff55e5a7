# SPDX-License-Identifier: Apache-2.0
"""Statistics of signals, and of flank contact: contact shares, separations, impacts.

Samples are weighted by time, so that records with variable and with uniform steps give the same results.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, as_increasing, as_signal, same_length

FRONT, SEPARATED, BACK, BOTH = 1, 0, -1, 2


@dataclass(frozen=True)
class SignalStatistics:
    """Mean, RMS of the alternating part, minimum and maximum of a signal, all in its unit."""

    mean: float
    rms: float
    min: float
    max: float


@dataclass(frozen=True)
class Separation:
    """One interval without contact.

    Attributes
    ----------
    start, end
        Times [s]; `end` is the end of the record if contact is not regained.
    flank_before, flank_after
        Contact state before and after: 1 front, -1 back, 2 both; None if the record begins or ends separated.
    """

    start: float
    end: float
    flank_before: int | None
    flank_after: int | None

    @property
    def duration(self) -> float:
        """Duration of the interval [s]."""
        return self.end - self.start


@dataclass(frozen=True)
class Impact:
    """Contact regained after a separation.

    Attributes
    ----------
    time
        Time of contact [s].
    flank
        1 front, -1 back, 2 both.
    flight
        Duration of the preceding separation [s].
    peak
        Maximum magnitude of the force until the flanks separate again (or the record ends) [N]; None without
        a force.
    """

    time: float
    flank: int
    flight: float
    peak: float | None


@dataclass(frozen=True)
class ContactStatistics:
    """Contact statistics of a mesh.

    Attributes
    ----------
    loss_share, back_contact_share, front_contact_share
        Shares of the time without contact, with contact of the back flanks, with contact of the front flanks
        [-]; contact of both flanks (negative backlash) is included in front and back.
    loss_time, longest_loss
        Total time without contact, and the longest interval [s].
    separations, impacts
        Separations and impacts in chronological order.
    """

    loss_share: float
    back_contact_share: float
    front_contact_share: float
    loss_time: float
    longest_loss: float
    separations: tuple[Separation, ...]
    impacts: tuple[Impact, ...]


def time_weights(clock: Array) -> Array:
    """Duration represented by each sample [s]; the sum is the length of the record.

    Parameters
    ----------
    clock
        Times [s], shape (n,), increasing.

    Examples
    --------
    >>> time_weights(np.array([0.0, 1.0, 3.0])).tolist()
    [0.5, 1.5, 1.0]
    """
    weights = np.zeros(clock.size)
    half = 0.5 * np.diff(clock)
    weights[:-1] += half
    weights[1:] += half
    return weights


def signal_statistics(values: ArrayLike, time: ArrayLike | None = None) -> SignalStatistics:
    """Mean, RMS of the alternating part, minimum and maximum of a signal.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    time
        Times [s], shape (n,); default: equal weights (correct for uniform samples of whole periods).

    Returns
    -------
    SignalStatistics
        In the unit of the signal.

    Raises
    ------
    SignalError
        If the data are not finite, or the times do not increase.

    Notes
    -----
    mean = Σ w x / Σ w, rms² = Σ w (x - mean)² / Σ w; with times, w is half the distance between the adjacent
    samples (trapezoidal rule) [1]_. Valid for any record; mean and RMS are meaningful for whole periods.

    References
    ----------
    .. [1] DIN 1311-1:2000, terms of vibration (rms value of the alternating part).

    Examples
    --------
    >>> t = np.arange(1000) / 1000.0
    >>> s = signal_statistics(2.0 + 3.0 * np.sin(2 * np.pi * 5 * t))
    >>> round(s.mean, 9), round(s.rms, 9), round(s.min, 9), round(s.max, 9)
    (2.0, 2.121320344, -1.0, 5.0)
    """
    x = as_signal(values, minimum=1)
    if time is None:
        weights = np.full(x.size, 1.0 / x.size)
    else:
        clock = as_increasing(time, "time", 2)
        same_length(x, clock, "values, time")
        weights = time_weights(clock) / float(clock[-1] - clock[0])
    mean = float(weights @ x)
    return SignalStatistics(mean, float(np.sqrt(weights @ (x - mean) ** 2)), float(x.min()), float(x.max()))


def contact_statistics(
    time: ArrayLike, contact_state: ArrayLike, force: ArrayLike | None = None
) -> ContactStatistics:
    """Shares of contact loss and back flank contact, separations and impacts of one mesh.

    Parameters
    ----------
    time
        Times [s], shape (n,), increasing; need not be uniform.
    contact_state
        Contact state at these times, shape (n,): 1 front flank, 0 separated, -1 back flank, 2 both.
    force
        Mesh force [N], shape (n,), for the peaks of the impacts.

    Returns
    -------
    ContactStatistics
        Shares, times and events.

    Raises
    ------
    SignalError
        If another state occurs, the channels differ in length, or the times do not increase.

    Notes
    -----
    A state applies from half-way to the preceding sample to half-way to the next, so that every share is the
    sum of its durations over t_n - t_1, and the shares of front only, back only, both and separated add up to
    one. Events are half-way between two samples, the estimate of smallest error [1]_. Intervals shorter than
    the sampling interval may be missed.

    References
    ----------
    .. [1] Original rule, consistent with the trapezoidal rule of `signal_statistics`; contact states as in A.
       Kahraman, R. Singh, Non-linear dynamics of a spur gear pair, Journal of Sound and Vibration 142(1),
       1990, 49-75.

    Examples
    --------
    >>> t = np.arange(11) * 0.1
    >>> c = contact_statistics(t, [1, 1, 0, 0, 0, -1, 0, 1, 1, 1, 1])
    >>> round(c.loss_share, 12), round(c.back_contact_share, 12), len(c.impacts)
    (0.4, 0.1, 2)
    >>> [(round(s.start, 12), round(s.duration, 12)) for s in c.separations]
    [(0.15, 0.3), (0.55, 0.1)]
    """
    clock = as_increasing(time)
    raw = as_signal(contact_state, "contact_state")
    same_length(clock, raw, "time, contact_state")
    state = raw.round().astype(np.int64)
    odd = np.flatnonzero((raw != state) | ~np.isin(state, (FRONT, SEPARATED, BACK, BOTH)))
    if odd.size:
        raise SignalError(f"contact_state: sample {odd[0]} is {raw[odd[0]]:g} (limit -1, 0, 1 or 2)")
    load = None if force is None else as_signal(force, "force")
    if load is not None:
        same_length(clock, load, "time, force")
    weights = time_weights(clock)
    total = float(clock[-1] - clock[0])

    def share(*states: int) -> float:
        """Share of the time in any of the contact states [-]."""
        return float(weights[np.isin(state, states)].sum()) / total

    separations, impacts = _events(clock, state, load)
    lost = float(weights[state == SEPARATED].sum())
    return ContactStatistics(
        loss_share=lost / total,
        back_contact_share=share(BACK, BOTH),
        front_contact_share=share(FRONT, BOTH),
        loss_time=lost,
        longest_loss=max((s.duration for s in separations), default=0.0),
        separations=separations,
        impacts=impacts,
    )


def _events(
    clock: Array, state: np.ndarray, load: Array | None
) -> tuple[tuple[Separation, ...], tuple[Impact, ...]]:
    """Separations, and the impacts after them."""
    lost = (state == SEPARATED).astype(np.int8)
    edges = np.flatnonzero(np.diff(lost))
    begins = [int(k) + 1 for k in edges if lost[k] == 0]
    ends = [int(k) + 1 for k in edges if lost[k] == 1]
    if lost[0]:
        begins.insert(0, 0)
    if lost[-1]:
        ends.append(clock.size)
    separations: list[Separation] = []
    impacts: list[Impact] = []
    for number, (first, after) in enumerate(zip(begins, ends, strict=True)):
        start = float(clock[0] if first == 0 else 0.5 * (clock[first - 1] + clock[first]))
        touches = after < clock.size
        end = float(0.5 * (clock[after - 1] + clock[after]) if touches else clock[-1])
        flank = int(state[after]) if touches else None
        separations.append(Separation(start, end, None if first == 0 else int(state[first - 1]), flank))
        if flank is not None:
            until = begins[number + 1] if number + 1 < len(begins) else clock.size
            peak = None if load is None else float(np.abs(load[after:until]).max())
            impacts.append(Impact(end, flank, end - start, peak))
    return tuple(separations), tuple(impacts)
