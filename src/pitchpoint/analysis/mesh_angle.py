# SPDX-License-Identifier: Apache-2.0
"""Angle of a shaft from the phase of a mesh line: drift of a nearly constant speed, without a tacho."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive
from pitchpoint.analysis.turning_parts import TurningParts

HARMONICS = 3
"""Harmonics of every mesh that may be used."""
HALF_WIDTH = 0.3
"""Half width of the band about a mesh line over the order of the slowest shaft: sidebands are excluded."""
CLEAR = 10.0
"""Smallest power of the band over that of the two adjacent half bands."""
LINES = 4.0
"""Smallest half width of the band [lines of the record]."""


def mesh_angle(signals: Mapping[str, Array], samples_per_turn: float, parts: TurningParts) -> Array | None:
    """Angle of the reference shaft that follows the clearest mesh line of a record at nearly constant speed.

    Parameters
    ----------
    signals
        Values by channel, shape (n,) each, any unit, at a constant mean speed.
    samples_per_turn
        Samples per revolution of the reference shaft at the mean speed [-].
    parts
        Rotating parts; orders refer to the reference shaft.

    Returns
    -------
    NDArray or None
        Angle at the samples [rad], shape (n,); None if no mesh line is clear.

    Raises
    ------
    SignalError
        If a signal is not finite, there is none, or the rate is not positive.

    Notes
    -----
    Phase of the analytic signal of a band about the line k z, without the sidebands of the slowest shaft,
    over k z [1]_. Phase steps of all channels are added with their powers as weights, because the line of one
    channel may vanish for a moment; constant phase differences of the channels have no effect. Changes faster
    than 0.3 times the speed of the slowest shaft are not followed. Valid for speeds that change by less than
    0.3 times the speed of the slowest shaft over the mesh order.

    References
    ----------
    .. [1] F. Bonnardot, M. El Badaoui, R. B. Randall, J. Danière, F. Guillet, Use of the acceleration signal
       of a gearbox in order to perform angular resampling (with limited speed fluctuation), Mechanical
       Systems and Signal Processing 19(4), 2005, 766-785.

    Examples
    --------
    A drift of 0.05 revolutions over 100, of which the mean speed contains nothing:

    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> turned = 2 * np.pi * np.arange(40_000) / 400.0
    >>> angle = turned + 2 * np.pi * 0.05 * np.sin(turned / 100)
    >>> found = mesh_angle({"a": np.cos(20 * angle)}, 400.0, train_parts([(20, 31)]))
    >>> bool(np.abs(np.diff(found - angle)[400:-400].sum()) < 2 * np.pi * 1e-4)
    True
    """
    rate = positive(samples_per_turn, "samples_per_turn")
    x = [as_signal(values, name, 64) for name, values in signals.items()]
    if not x:
        raise SignalError("signals: there is no channel (limit 1)")
    length = x[0].size
    half = HALF_WIDTH * float(min(shaft.order for shaft in parts.shafts)) * length / rate
    if half < LINES:
        return None
    lines = [np.fft.rfft(one - one.mean()) for one in x]
    best, chosen, number = CLEAR, 0.0, 0
    for mesh in parts.meshes:
        for k in range(1, HARMONICS + 1):
            order = k * parts.mesh_order(mesh)
            middle = order * length / rate
            if middle + 2.0 * half >= lines[0].size - 1:
                continue
            edges = np.rint(middle + half * np.array([-2.0, -1.0, 1.0, 2.0])).astype(int)
            below, inside, above = (
                sum(float(np.sum(np.abs(one[a:b]) ** 2)) for one in lines)
                for a, b in zip(edges[:-1], edges[1:], strict=True)
            )
            ratio = inside / max(below + above, 1e-300)
            if ratio > best:
                best, chosen, number = ratio, order, int(edges[1])
    if not chosen:
        return None
    count = int(2.0 * half)
    steps = np.zeros(length - 1, dtype=np.complex128)
    for one in lines:
        band = np.zeros(length, dtype=np.complex128)
        # the band is moved to zero frequency: phases change slowly
        at = np.arange(number, number + count)
        band[(at - int(np.rint(chosen * length / rate))) % length] = one[at]
        moved = np.fft.ifft(band)
        steps += moved[1:] * moved[:-1].conj()
    slow = np.r_[0.0, np.cumsum(np.angle(steps))]
    moved_by = 2.0 * np.pi * np.rint(chosen * length / rate) / length
    return np.asarray((slow + moved_by * np.arange(length)) / chosen)
