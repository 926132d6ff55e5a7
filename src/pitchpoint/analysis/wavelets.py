# SPDX-License-Identifier: Apache-2.0
"""Wavelet decomposition of a signal into octaves, or into packets of equal bandwidth.

A wavelet keeps short events short, where a filter would ring. The transforms are those of PyWavelets, with
all its orthogonal and biorthogonal families. The extension of the record beyond its ends is an option and is
stored in every result:

`symmetric` mirrors the record, `reflect` mirrors without repeating the last sample, `periodic` repeats it,
`zero` and `constant` pad it, `smooth` extrapolates with the last slope, `antisymmetric` and `antireflect`
mirror with reversed sign, `periodization` repeats and keeps as many coefficients as samples, so that energies
add up exactly.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive
from pitchpoint.core.nearest import hint


@dataclass(frozen=True)
class WaveletLevels:
    """Decomposition of a signal into one approximation and details, one per octave.

    Attributes
    ----------
    names
        Shape (n_level + 1,). `a5`, `d5`, `d4`, ... `d1` for five levels, low frequencies first.
    signals
        Shape (n_level + 1, n). Contributions to the signal, in its unit; the rows add up to the signal, whose
        mean is in the first row.
    coefficients
        Wavelet coefficients, in the unit of the signal; shapes (n_1,), (n_2,), ...
    lengths
        Shape (n_level + 1,). Numbers of coefficients [-].
    band
        Shape (n_level + 1, 2). Nominal bands [Hz]; the filters overlap into the adjacent bands.
    energy_share
        Shape (n_level + 1,). Shares of the sum of squared coefficients of the signal less its mean [-]; zero
        for a constant signal.
    wavelet, extension
        Wavelet and extension used.
    """

    names: tuple[str, ...]
    signals: Array
    coefficients: tuple[Array, ...]
    lengths: NDArray[np.int64]
    band: Array
    energy_share: Array
    wavelet: str
    extension: str


@dataclass(frozen=True)
class WaveletPackets:
    """Decomposition of a signal into 2^levels bands of equal width.

    Attributes
    ----------
    band
        Shape (n_band, 2). Nominal bands [Hz], from low to high.
    time
        Shape (n_coefficient,). Nominal time of each coefficient [s], from `start`; for an asymmetric wavelet
        such as `db5` it is offset by part of the filter length, (filter length - 1)·(2^levels - 1)/f_s.
    coefficients
        Shape (n_band, n_coefficient). Coefficients, in the unit of the signal.
    energy_share
        Shape (n_band,). Shares of the sum of squared coefficients of the signal less its mean [-].
    wavelet, extension
        Wavelet and extension used.
    """

    band: Array
    time: Array
    coefficients: Array
    energy_share: Array
    wavelet: str
    extension: str


def wavelet_levels(
    values: ArrayLike,
    sample_rate: float,
    *,
    wavelet: str = "db5",
    levels: int = 5,
    extension: str = "symmetric",
) -> WaveletLevels:
    """Discrete wavelet transform, and the contribution of every level to the signal.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz]; samples per revolution for a signal over the angle, then the bands are orders.
    wavelet
        Name of a discrete wavelet, such as `db5`, `sym8`, `coif3`, `bior2.4`, `haar`.
    levels
        Number of levels L [-].
    extension
        Extension of the record beyond its ends, see the module.

    Returns
    -------
    WaveletLevels
        Approximation of the last level, then details from low to high frequencies.

    Raises
    ------
    SignalError
        If the record is too short for so many levels, or wavelet or extension are unknown.

    Notes
    -----
    Each level halves the band by a pair of filters and drops every second sample [1]_: detail j is the band
    f_s/2^(j+1) to f_s/2^j, the approximation the band below f_s/2^(L+1). The input of a level must be longer
    than the filter, as otherwise only the extension is analysed. The rows add up to the signal to round-off,
    except for `dmey` with its truncated filters (0.4 %).

    References
    ----------
    .. [1] S. G. Mallat, A theory for multiresolution signal decomposition: the wavelet representation, IEEE
       Transactions on Pattern Analysis and Machine Intelligence 11(7), 1989, 674-693.

    Examples
    --------
    A sine of 20.1 Hz sampled at 430.4 Hz is in the fourth detail, 13.45 to 26.9 Hz, and leaks into the third:

    >>> x = np.cos(2 * np.pi * 20.098765 * np.arange(6456) / 430.4)
    >>> found = wavelet_levels(x, 430.4, extension="periodization")
    >>> found.names
    ('a5', 'd5', 'd4', 'd3', 'd2', 'd1')
    >>> [round(float(share), 3) for share in found.energy_share]
    [0.003, 0.004, 0.884, 0.109, 0.001, 0.0]
    """
    import pywt

    x = _writeable(as_signal(values))
    rate = positive(sample_rate, "sample_rate")
    family, count = _discrete(wavelet, levels, x.size, extension)
    mean = float(x.mean())
    parts = pywt.wavedec(x, family, mode=extension, level=count)
    # without the mean, which is usually much larger than the alternating part
    energies = [float(np.sum(c * c)) for c in pywt.wavedec(x - mean, family, mode=extension, level=count)]
    signals = np.empty((count + 1, x.size))
    for row in range(count + 1):
        only = [part if k == row else np.zeros_like(part) for k, part in enumerate(parts)]
        signals[row] = pywt.waverec(only, family, mode=extension)[: x.size]
    top = [2.0 ** -(count + 1), *(2.0**-j for j in range(count, 0, -1))]
    bottom = [0.0, *(0.5 * high for high in top[1:])]
    return WaveletLevels(
        names=(f"a{count}", *(f"d{j}" for j in range(count, 0, -1))),
        signals=signals,
        coefficients=tuple(np.asarray(part, dtype=np.float64) for part in parts),
        lengths=np.array([part.size for part in parts], dtype=np.int64),
        band=rate * np.column_stack([bottom, top]),
        energy_share=_shares(np.array(energies), x, mean),
        wavelet=wavelet,
        extension=extension,
    )


def approximation(values: Array, level: int, *, wavelet: str = "db5", extension: str = "symmetric") -> Array:
    """Contribution of the band below f_s/2^(level + 1) to a signal, shape (n,), in its unit.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    level
        Number of halvings of the band [-], at most `most_levels`.
    wavelet, extension
        See `wavelet_levels`, whose first row this is.

    Examples
    --------
    >>> x = np.cos(2 * np.pi * 3.25 * np.arange(6456) / 430.4)
    >>> bool(np.allclose(approximation(x, 5), wavelet_levels(x, 430.4).signals[0]))
    True
    """
    import pywt

    parts = pywt.wavedec(_writeable(values), wavelet, mode=extension, level=level)
    rest = [np.zeros_like(part) for part in parts[1:]]
    found: Array = pywt.waverec([parts[0], *rest], wavelet, mode=extension)[: values.size]
    return found


def most_levels(samples: int, wavelet: str = "db5") -> int:
    """Largest number of levels of a record.

    Parameters
    ----------
    samples
        Number of samples [-].
    wavelet
        Name of the wavelet.

    Examples
    --------
    >>> most_levels(6456)
    9
    """
    import pywt

    return int(pywt.dwt_max_level(samples, pywt.Wavelet(wavelet)))


def wavelet_packets(
    values: ArrayLike,
    sample_rate: float,
    *,
    wavelet: str = "db5",
    levels: int = 5,
    extension: str = "symmetric",
    start: float = 0.0,
) -> WaveletPackets:
    """Wavelet packet transform: both halves of every band are halved again; bands in order of frequency.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz]; samples per revolution for a signal over the angle.
    wavelet
        Name of a discrete wavelet, see `wavelet_levels`.
    levels
        Number of levels L [-]: 2^L bands of f_s/2^(L+1).
    extension
        Extension of the record beyond its ends, see the module.
    start
        Time of the first sample [s].

    Returns
    -------
    WaveletPackets
        Bands from low to high.

    Raises
    ------
    SignalError
        As `wavelet_levels`.

    Notes
    -----
    Splitting a high-pass band reverses the order of its halves; the bands are sorted by frequency by the Gray
    code [1]_. Valid as `wavelet_levels`.

    References
    ----------
    .. [1] M. V. Wickerhauser, Adapted Wavelet Analysis from Theory to Software, A K Peters, 1994, chapter 7.

    Examples
    --------
    >>> x = np.cos(2 * np.pi * 300.0 * np.arange(4096) / 1024.0)
    >>> found = wavelet_packets(x, 1024.0, wavelet="db10", levels=3)
    >>> found.band[int(np.argmax(found.energy_share))]
    array([256., 320.])
    """
    import pywt

    x = _writeable(as_signal(values))
    rate = positive(sample_rate, "sample_rate")
    family, count = _discrete(wavelet, levels, x.size, extension)
    mean = float(x.mean())
    tree = pywt.WaveletPacket(x, family, mode=extension, maxlevel=count)
    without = pywt.WaveletPacket(x - mean, family, mode=extension, maxlevel=count)
    coefficients = np.array([node.data for node in tree.get_level(count, order="freq")])
    energies = np.array([np.sum(node.data**2) for node in without.get_level(count, order="freq")])
    edges = np.arange(2**count + 1) * rate / 2 ** (count + 1)
    n = coefficients.shape[1]
    # the extension adds equal numbers of coefficients before and after the record
    middle = 0.5 * (x.size - 1) + (np.arange(n) - 0.5 * (n - 1)) * 2.0**count
    return WaveletPackets(
        band=np.column_stack([edges[:-1], edges[1:]]),
        time=start + middle / rate,
        coefficients=coefficients,
        energy_share=_shares(energies, x, mean),
        wavelet=wavelet,
        extension=extension,
    )


def unknown(what: str, name: str, names: list[str]) -> SignalError:
    """Error for a name that is not in a list, with the nearest known name.

    Parameters
    ----------
    what
        Meaning of the name.
    name
        The unknown name.
    names
        Known names.
    """
    return SignalError(f"{what}: {name!r} is unknown; {hint(name, names)}")


def check_extension(name: str) -> None:
    """Raise for an unknown extension.

    Raises
    ------
    SignalError
        If PyWavelets does not know the extension.
    """
    import pywt

    if name not in pywt.Modes.modes:
        raise unknown("extension", name, pywt.Modes.modes)


def _writeable(values: Array) -> Array:
    """The samples, copied if they are read-only, as those of a file: PyWavelets rejects these."""
    return np.require(values, requirements="W")


def _discrete(wavelet: str, levels: int, samples: int, extension: str) -> tuple[Any, int]:
    """Wavelet and number of levels, after checks against the length of the record."""
    import pywt

    check_extension(extension)
    if wavelet not in pywt.wavelist(kind="discrete"):
        raise unknown("wavelet", wavelet, pywt.wavelist(kind="discrete"))
    family = pywt.Wavelet(wavelet)
    most = pywt.dwt_max_level(samples, family)
    if most < 1:
        raise SignalError(
            f"values: has {samples} samples (limit {2 * (family.dec_len - 1)} for one level of {wavelet}); "
            "use a longer record or a shorter wavelet"
        )
    if isinstance(levels, bool) or int(levels) != levels or not 1 <= levels <= most:
        raise SignalError(
            f"levels: {levels} (limit 1 to {most} for {samples} samples and {wavelet}); use a longer record "
            "or a shorter wavelet"
        )
    return family, int(levels)


def _shares(energies: Array, x: Array, mean: float) -> Array:
    """Shares of the total energy; zero if the alternating part is only round-off."""
    total = float(energies.sum())
    floor = x.size * (np.finfo(np.float64).eps * 16.0 * max(abs(mean), float(np.abs(x).max()))) ** 2
    return energies / total if total > floor else np.zeros_like(energies)
