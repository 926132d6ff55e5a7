# SPDX-License-Identifier: Apache-2.0
"""Main numbers of the result of an analysis."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.spectra import largest_peaks
from pitchpoint.analysis.tools import TOOLS
from pitchpoint.viz.analysis_pictures import spectrum_of
from pitchpoint.viz.quantities import amount, number, span

if TYPE_CHECKING:
    import xarray as xr

_PEAKS = 8


def highlights(result: xr.Dataset) -> list[list[str]]:
    """Rows of name, value and position: peaks of a spectrum, else single numbers and maxima of curves.

    Parameters
    ----------
    result
        Result of `analyse` of one channel.
    """
    rows = [
        [_words(name), shown(float(v), str(v.attrs.get("units", ""))), ""]
        for name, v in result.data_vars.items()
        if not v.dims and v.dtype.kind in "fiub"
    ]
    kind = TOOLS[result.attrs["tool"]].picture
    if kind in _OWN:
        return _OWN[kind](result)
    if kind in ("spectrum", "order_spectrum"):
        axis = "frequency" if kind == "spectrum" else "order"
        spectrum = spectrum_of(result, axis)
        unit, across = str(result["amplitude"].attrs["units"]), str(result[axis].attrs["units"])
        peaks = largest_peaks(spectrum, _PEAKS)
        return rows + [
            [f"peak {k}", shown(a, unit), shown(_rounded(f, spectrum.resolution), across)]
            for k, (f, a) in enumerate(peaks, start=1)
        ]
    return rows + [
        _top(result, str(name))
        for name, v in result.data_vars.items()
        if v.dims and v.size and v.dtype.kind in "fiu"
    ]


def _levels(result: xr.Dataset) -> list[list[str]]:
    """Energy share of each level, with its band."""
    return [
        [str(name), _percent(share), f"{span(*band)}, {int(count)} coefficients"]
        for name, share, band, count in zip(
            *(result[n].values for n in ("level", "energy_share", "band", "coefficients")), strict=True
        )
    ]


def _packets(result: xr.Dataset) -> list[list[str]]:
    """Bands with the largest energy shares."""
    share, band = result["energy_share"].values, result["band"].values
    largest = np.argsort(-share, kind="stable")[:_PEAKS]
    return [[f"share {k}", _percent(share[i]), span(*band[i])] for k, i in enumerate(largest, start=1)]


def _scalogram(result: xr.Dataset) -> list[list[str]]:
    """Maximum amplitude, and extent of the edge effects."""
    return [_top(result, "amplitude"), ["edge effects up to", *_top(result, "edge")[1:]]]


def _kurtogram(result: xr.Dataset) -> list[list[str]]:
    """Band in which impacts stand out most."""
    kurtosis, spread = float(result["best_kurtosis"]), float(result["best_spread"])
    band = span(float(result["best_low"]), float(result["best_high"]))
    return [
        ["maximum kurtosis", shown(kurtosis, ""), band],
        ["its standard deviation in noise", shown(spread, ""), f"ratio {number(kurtosis / spread, 3)}"],
    ]


def _prominence(result: xr.Dataset) -> list[list[str]]:
    """Most prominent lines with their probability in noise."""
    axis = "frequency" if "frequency" in result.coords else "order"
    across, level = str(result[axis].attrs["units"]), result["prominence"].values
    top = np.r_[True, level[1:] >= level[:-1]] & np.r_[level[:-1] > level[1:], True]
    lines = np.flatnonzero(top)
    lines = lines[np.argsort(-level[lines], kind="stable")][:_PEAKS]
    return [
        [
            f"line {k}, {number(float(level[i]), 3)} dB",
            shown(float(result[axis].values[i]), across),
            f"probability in noise {number(float(result['probability'].values[i]), 2)}",
        ]
        for k, i in enumerate(lines, start=1)
    ]


def _coherence(result: xr.Dataset) -> list[list[str]]:
    """Highest lines of the enhanced envelope spectrum relative to the threshold."""
    cyclic, value = result["cyclic_frequency"].values, result["enhanced"].values
    ratio = value / result["enhanced_threshold"].values
    top = np.r_[True, ratio[1:] >= ratio[:-1]] & np.r_[ratio[:-1] > ratio[1:], True]
    lines = np.flatnonzero(top)
    lines = lines[np.argsort(-ratio[lines], kind="stable")][:_PEAKS]
    return [
        [
            f"mean coherence {k}, {number(float(value[i]), 3)}",
            shown(float(cyclic[i]), "Hz"),
            f"{number(float(ratio[i]), 3)} times the threshold of noise (1 %)",
        ]
        for k, i in enumerate(lines, start=1)
    ]


def _period(result: xr.Dataset) -> list[list[str]]:
    """Detected period, if any, with its significance."""
    limit = f"limit {number(float(result['false_alarm']))}"
    chance = ["probability in noise", number(float(result["p_value"]), 3), limit]
    if not bool(result["found"]):
        return [["period", "nothing found", ""], chance]
    deviation = f"standard deviation {shown(float(result['deviation']), 's')}"
    return [
        ["period", shown(float(result["period"]), "s"), deviation],
        chance,
        ["turns in the record", str(int(result["turns"])), ""],
        ["lines used", str(result.sizes["harmonic"]), ""],
    ]


def _evidence(result: xr.Dataset) -> list[list[str]]:
    """Probability of each period in noise."""
    columns = (result[n].values for n in ("period", "p_value", "turns", "lines"))
    rows = []
    for period, chance, turns, lines in zip(*columns, strict=True):
        seen = f"{turns} turn{'' if turns == 1 else 's'}, {lines} line{'' if lines == 1 else 's'}"
        known = bool(np.isfinite(chance))
        rows.append(
            [
                f"probability in noise of {shown(float(period), 's')}",
                number(float(chance), 3) if known else "not known",
                seen if known else f"{seen}: too few for a test; use a longer record",
            ]
        )
    return rows


def _tones(result: xr.Dataset) -> list[list[str]]:
    """Amplitude and frequency of each tone."""
    unit = str(result["amplitude"].attrs["units"])
    columns = (result[n].values for n in ("expected", "amplitude", "frequency", "is_peak"))
    return [
        [
            f"near {shown(float(expected), 'Hz')}",
            shown(float(amplitude), unit),
            f"{number(float(frequency), 6)} Hz" + ("" if peak else ", no peak"),
        ]
        for expected, amplitude, frequency, peak in zip(*columns, strict=True)
    ]


_OWN = {
    "tones": _tones,
    "wavelet_levels": _levels,
    "wavelet_packets": _packets,
    "scalogram": _scalogram,
    "kurtogram": _kurtogram,
    "line_prominence": _prominence,
    "order_prominence": _prominence,
    "spectral_coherence": _coherence,
    "find_period": _period,
    "period_evidence": _evidence,
}


def _percent(share: float) -> str:
    return f"{number(round(100.0 * float(share), 1), 4)} %"


def _rounded(place: float, resolution: float) -> float:
    """Frequency or order of a peak, rounded to a tenth of the line spacing or finer."""
    return round(place, -int(np.floor(np.log10(0.1 * resolution))))


def shown(value: float, unit: str) -> str:
    """Value in a customary unit.

    Examples
    --------
    >>> shown(1.5e-6, "m"), shown(17.0, "1"), shown(3.0, "N^2/Hz")
    ('1.5 µm', '17', '3 N²/Hz')
    >>> shown(float("nan"), "m")
    'not known'
    """
    return "not known" if np.isnan(value) else amount(value, unit, 5)


def _words(name: object) -> str:
    return str(name).replace("_", " ")


def _top(result: xr.Dataset, name: str) -> list[str]:
    """Maximum of a curve or map, and its position."""
    variable = result[name]
    if np.isnan(variable.values).all():
        return [f"maximum {_words(name)}", "not known", ""]
    values = np.where(np.isnan(variable.values), -np.inf, variable.values)
    place = np.unravel_index(int(np.argmax(values)), variable.shape)
    at = [
        f"{_words(dim)} {shown(float(result[dim].values[k]), str(result[dim].attrs.get('units', '')))}"
        for dim, k in zip(variable.dims, place, strict=True)
        if dim in result.coords
    ]
    unit = str(variable.attrs.get("units", ""))
    return [f"maximum {_words(name)}", shown(float(variable.values[place]), unit), ", ".join(at)]
