# SPDX-License-Identifier: Apache-2.0
"""The few numbers of an analysis that people look for first."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.spectra import largest_peaks
from pitchpoint.analysis.tools import TOOLS
from pitchpoint.viz.analysis_page import spectrum_of
from pitchpoint.viz.quantities import number, scale

if TYPE_CHECKING:
    import xarray as xr

_PEAKS = 8


def highlights(result: xr.Dataset) -> list[list[str]]:
    """Rows of name, value and place: peaks of a spectrum, else single numbers and the tops of curves.

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


def _rounded(place: float, resolution: float) -> float:
    """Frequency or order of a peak to a tenth of the distance between lines, or finer."""
    return round(place, -int(np.floor(np.log10(0.1 * resolution))))


def shown(value: float, unit: str) -> str:
    """A value in the unit that people use.

    Examples
    --------
    >>> shown(1.5e-6, "m"), shown(17.0, "1"), shown(3.0, "N^2/Hz")
    ('1.5 µm', '17', '3 N²/Hz')
    """
    best = scale(unit, [value])
    return f"{number(value * best.factor, 5)} {best.unit}".rstrip()


def _words(name: object) -> str:
    return str(name).replace("_", " ")


def _top(result: xr.Dataset, name: str) -> list[str]:
    """Largest value of a curve or map, and where it is."""
    variable = result[name]
    place = np.unravel_index(int(np.argmax(variable.values)), variable.shape)
    at = [
        f"{_words(dim)} {shown(float(result[dim].values[k]), str(result[dim].attrs.get('units', '')))}"
        for dim, k in zip(variable.dims, place, strict=True)
        if dim in result.coords
    ]
    unit = str(variable.attrs.get("units", ""))
    return [f"largest {_words(name)}", shown(float(variable.values[place]), unit), ", ".join(at)]
