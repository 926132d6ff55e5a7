# SPDX-License-Identifier: Apache-2.0
"""Dynamic amplification: ratio of dynamic to static load."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, as_signal


@dataclass(frozen=True)
class LoadFactors:
    """Dynamic load factors of a mesh.

    Attributes
    ----------
    dynamic_factor
        Maximum force over the static force [-] (K_v of ISO 6336-1 if the static force is the nominal one).
    alternating_ratio
        RMS of the alternating part over the static force [-].
    """

    dynamic_factor: float
    alternating_ratio: float


def amplification_factor(frequency_ratio: ArrayLike, damping_ratio: float) -> Array:
    """Amplification of a harmonically forced oscillator with one degree of freedom.

    Parameters
    ----------
    frequency_ratio
        Excitation over undamped natural frequency η [-], any shape.
    damping_ratio
        Damping ratio ζ [-], ≥ 0.

    Returns
    -------
    NDArray
        Amplitude over static deflection [-], shape of `frequency_ratio`; infinite at η = 1 without damping.

    Raises
    ------
    SignalError
        If the damping ratio is negative or not a number.

    Notes
    -----
    V = 1/√((1 - η²)² + (2ζη)²) [1]_. Valid for the linear system: for a gear mesh only without contact loss,
    that is, while V times the alternating force is below the mean force.

    References
    ----------
    .. [1] S. S. Rao, Mechanical Vibrations, response of a damped system under harmonic force.

    Examples
    --------
    >>> amplification_factor([0.0, 1.0, 2.0], 0.05).round(6)
    array([ 1.      , 10.      ,  0.332595])
    """
    if not np.isfinite(damping_ratio) or damping_ratio < 0.0:
        raise SignalError(f"damping_ratio: {damping_ratio} (limit >= 0)")
    eta = np.asarray(frequency_ratio, dtype=np.float64)
    with np.errstate(divide="ignore"):
        return np.asarray(1.0 / np.hypot(1.0 - eta**2, 2.0 * damping_ratio * eta))


def load_factors(force: ArrayLike, static_force: float | None = None) -> LoadFactors:
    """Dynamic factor and alternating ratio of a mesh force.

    Parameters
    ----------
    force
        Mesh force over whole mesh periods at equal steps [N], shape (n,).
    static_force
        Force without vibration [N], not zero; default: mean of `force`, correct for a constant mean torque.

    Returns
    -------
    LoadFactors
        Both ratios [-].

    Raises
    ------
    SignalError
        If the static force is zero or not finite.

    Notes
    -----
    K = max(F sgn F_0)/|F_0|, alternating ratio = rms(F - F̄)/|F_0|; internal dynamic factor defined as the
    maximum over the static tooth force [1]_. Valid for any record that covers the vibration.

    References
    ----------
    .. [1] ISO 6336-1, internal dynamic factor K_v.

    Examples
    --------
    >>> t = np.arange(100) / 100.0
    >>> f = load_factors(1000.0 + 300.0 * np.cos(2 * np.pi * t))
    >>> round(f.dynamic_factor, 9), round(f.alternating_ratio, 9)
    (1.3, 0.212132034)
    """
    data = as_signal(force, "force")
    static = float(data.mean()) if static_force is None else float(static_force)
    if not np.isfinite(static) or static == 0.0:
        raise SignalError(f"static_force: {static} (limit: not zero); give the nominal force of the mesh")
    largest = float((data * np.sign(static)).max())
    return LoadFactors(largest / abs(static), float(data.std()) / abs(static))
