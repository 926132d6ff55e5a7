# SPDX-License-Identifier: Apache-2.0
"""Distribution of the energy of a synchronous average over the teeth: one tooth or all teeth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.indicators import standardised_moment
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, whole

STEPS_PER_TOOTH = 4
DRAWS = 999


@dataclass(frozen=True)
class ToothEnergy:
    """Maximum energy of a synchronous average within the angle of one tooth.

    Attributes
    ----------
    share
        Share of the energy within the angle of one tooth [-]; 1/z for an even distribution.
    angle
        Middle of the tooth angle [rad].
    probability
        Probability that Gaussian noise of the same spectrum reaches the share [-].
    """

    share: float
    angle: float
    probability: float


def tooth_energy(residual: ArrayLike, *, teeth: int) -> ToothEnergy:
    """Maximum energy of a residual signal within the angle of one tooth.

    Parameters
    ----------
    residual
        One revolution without mesh harmonics, shape (n,), any unit.
    teeth
        Number of teeth z [-].

    Returns
    -------
    ToothEnergy
        Share, angle and probability.

    Raises
    ------
    SignalError
        If the residual is zero, or has fewer than two samples per tooth.

    Notes
    -----
    A window of one tooth is moved in quarters of its width. For Gaussian noise with lines of the power P_k
    the energy has about ν = 2 (Σ P_k)²/Σ P_k² degrees of freedom, ν/z of them in the window, and the share
    has a beta distribution; the probability of the largest of 4 z windows is bounded by the sum of their
    probabilities [1]_. Valid for z > 3 and a spectrum of more than a few lines.

    References
    ----------
    .. [1] W. G. Cochran, The distribution of the largest of a set of estimated variances as a fraction of
       their total, Annals of Eugenics 11, 1941, 47-52.

    Examples
    --------
    >>> turn = np.zeros(400)
    >>> turn[105] = 1.0
    >>> found = tooth_energy(turn, teeth=20)
    >>> round(found.share, 3), int(found.angle / (2 * np.pi / 20)), bool(found.probability < 1e-9)
    (1.0, 5, True)
    """
    from scipy.stats import beta

    x = as_signal(residual, "residual", 8)
    z = whole(teeth, "teeth", 4)
    share = _shares(x, z)
    steps = share.size
    place = int(np.argmax(share))
    power = np.abs(np.fft.rfft(x)) ** 2
    freedom = max(2.0 * float(power.sum()) ** 2 / float((power**2).sum()), 2.0)
    inside = freedom / z
    alone = float(beta.sf(min(share[place], 1.0), 0.5 * inside, 0.5 * (freedom - inside)))
    return ToothEnergy(
        share=float(min(share[place], 1.0)),
        angle=float((place + 0.5 * STEPS_PER_TOOTH) * 2.0 * np.pi / steps % (2.0 * np.pi)),
        probability=min(1.0, steps * alone),
    )


def share_of_finer(residual: ArrayLike, *, coarse: int, fine: int) -> float:
    """Energy of an event within two pitches of a fine gear over that within one pitch of a coarse gear.

    Parameters
    ----------
    residual
        One revolution without mesh harmonics, shape (n,), any unit.
    coarse, fine
        Numbers of teeth of two gears on the shaft [-].

    Returns
    -------
    float
        Share [-]: 2 `coarse`/`fine` for an event with constant energy over one pitch of the coarse gear, 1
        for an event of the fine gear or an impact.

    Raises
    ------
    SignalError
        As `tooth_energy`.

    Notes
    -----
    A damaged tooth changes the force while it is in contact, one to two pitches of its gear [1]_. The energy
    outside the event, the median over the windows of each width, is subtracted. An impact is shorter than
    either pitch and does not distinguish the gears. Valid for total contact ratios up to two and numbers of
    teeth that differ by a factor of four.

    References
    ----------
    .. [1] P. D. McFadden, Detecting fatigue cracks in gears by amplitude and phase demodulation of the
       meshing vibration, Journal of Vibration, Acoustics, Stress, and Reliability in Design 108(2), 1986,
       165-170.

    Examples
    --------
    >>> turn = np.zeros(960)
    >>> turn[80:160] = 1.0
    >>> round(share_of_finer(turn, coarse=12, fine=80), 3)
    0.3
    """
    x = as_signal(residual, "residual", 8)
    wide, narrow = _shares(x, whole(coarse, "teeth", 4)), _shares(x, whole(fine, "teeth", 4), 2)
    base = float(np.median(wide))
    return float((narrow.max() - np.median(narrow)) / max(float(wide.max()) - base, 1e-300))


def _shares(x: Array, z: int, pitches: int = 1) -> Array:
    """Shares of the energy in windows of one or more pitches of z teeth, moved in quarters, shape (4 z,)."""
    if x.size < 2 * z:
        raise SignalError(f"residual: has {x.size} samples (limit {2 * z}, two per tooth); use more samples")
    energy = x**2
    total = float(energy.sum())
    if total <= 0.0:
        raise SignalError("residual: is zero everywhere; there is nothing besides the mesh")
    steps, width = STEPS_PER_TOOTH * z, STEPS_PER_TOOTH * pitches
    edge = np.arange(steps + width + 1) * (x.size / steps)
    running = np.concatenate([[0.0], np.cumsum(np.concatenate([energy, energy]))])
    share = np.diff(np.interp(edge, np.arange(running.size), running))
    found: Array = np.convolve(share, np.ones(width), mode="valid")[:steps] / total
    return found


def peaked_as_trains(residual: ArrayLike, *, teeth: int) -> float:
    """Probability that a train of impacts at all teeth, randomly modulated, is as peaked as a residual.

    Parameters
    ----------
    residual
        One revolution without mesh harmonics, shape (n,), any unit.
    teeth
        Number of teeth z [-].

    Returns
    -------
    float
        Share of the random trains with at least the kurtosis of the residual [-].

    Raises
    ------
    SignalError
        If there are fewer than four teeth, or the residual is constant.

    Notes
    -----
    A healthy pair may have an impact at every tooth, and other meshes modulate these impacts from tooth to
    tooth: such an average is as peaked as a single impact, but at z angles. Its orders are in classes k mod
    z: each class is a train of impacts modulated by one cosine over the teeth, and the classes are
    independent. Comparison trains are therefore surrogate signals of the same spectrum [1]_ with one random
    phase per class, which keeps the shape of the impacts and changes only their variation from tooth to
    tooth. A local fault has all classes in phase at one tooth, which random phases do not produce. Valid for
    three or more significant classes.

    References
    ----------
    .. [1] J. Theiler, S. Eubank, A. Longtin, B. Galdrikian, J. D. Farmer, Testing for nonlinearity in time
       series: the method of surrogate data, Physica D 58, 1992, 77-94.

    Examples
    --------
    Twenty impacts modulated by a cosine, and a single impact:

    >>> strike = np.zeros((20, 32))
    >>> strike[:, 7] = np.cos(2 * np.pi * 3 * np.arange(20) / 20)
    >>> one = np.zeros((20, 32))
    >>> one[4, 7] = 1.0
    >>> peaked_as_trains(strike.ravel(), teeth=20) > 0.01, peaked_as_trains(one.ravel(), teeth=20) < 0.002
    (True, True)
    """
    from scipy.fft import irfft

    x = as_signal(residual, "residual", 8)
    z = whole(teeth, "teeth", 4)
    observed = standardised_moment(x, 4)
    lines = np.fft.rfft(x)
    group = np.arange(lines.size) % z
    dice = np.random.default_rng([x.size, z])
    reached = 0
    for _ in range(DRAWS):
        phase = np.zeros(z)
        half = (z - 1) // 2
        phase[1 : half + 1] = dice.uniform(0.0, 2.0 * np.pi, half)
        # opposite phases of k and -k keep the signal real
        phase[-half:] = -phase[half:0:-1]
        if z % 2 == 0:
            phase[z // 2] = np.pi * dice.integers(2)
        drawn = irfft(lines * np.exp(1j * phase)[group], x.size)
        # tolerance for round-off
        reached += standardised_moment(drawn, 4) >= observed * (1.0 - 1e-12)
    return reached / DRAWS
