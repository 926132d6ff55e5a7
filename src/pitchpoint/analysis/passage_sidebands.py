# SPDX-License-Identifier: Apache-2.0
"""Lines that passing balls put in addition to those of a bearing that is loud itself."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.shaft_tests import HARMONICS, OFF, ShaftView, passages

DEEPEST = 4.0
"""Power of a line over that of a line next to it, at the least: a line that comes and goes altogether, as
deep as anything can be modulated, has half its amplitude on either side."""


def passage_sidebands(view: ShaftView, tested: Array, rates: Sequence[float], reach: float) -> Array:
    """Orders near tested lines at which ball passing puts sidebands next to stronger lines of loud bearings.

    Parameters
    ----------
    view
        Orders of the shaft that is tested.
    tested
        Orders of the lines that are tested [-], shape (n,).
    rates
        Passages, or strikes, of the loud bearings in one turn of the reference shaft [-].
    reach
        How near to a tested line a place counts, in lines of the record [-].

    Returns
    -------
    ndarray
        Orders [-], shape (m,), rising.

    Notes
    -----
    Loud bearings have lines at k f and h f_mesh ± k f for many k. What modulates the mesh lines of healthy
    machines, balls that pass in all bearings [1]_, modulates those as well: lines next to them, up to three
    passages away, of half the amplitude at the most. Only lines that are seen count, and none that may be an
    order of the shaft itself. Valid where balls do not slip by more than the record resolves.

    References
    ----------
    .. [1] C. S. Sunnersjö, Varying compliance vibrations of rolling bearings, Journal of Sound and Vibration
       58(3), 1978, 363-373.

    Examples
    --------
    A mesh at 21 and strikes at 3.57: the line of both at 24.57, and next to it the balls of a second bearing:

    >>> from pitchpoint.analysis.line_tests import fine_spectrum
    >>> from pitchpoint.analysis.turning_parts import Bearing, train_parts
    >>> bearings = [Bearing("loud", {"outer ring": 3.57}), Bearing("other", {"outer ring": 1.57})]
    >>> parts = train_parts([(21, 40)], bearings)
    >>> turned = 2 * np.pi * np.arange(50_000) / 500.0
    >>> x = np.cos(24.57 * turned) * (1 + 0.4 * np.cos(1.57 * turned))
    >>> view = ShaftView(fine_spectrum(x, 500.0), parts, parts.shafts[0], 1.0, 500.0)
    >>> passage_sidebands(view, np.array([23.0]), [3.57], 0.5).round(3).tolist()
    [23.0]
    """
    spectrum, parts = view.spectrum, view.parts
    off, line = passages(parts)[0], spectrum.resolution
    if not off.size:
        return np.empty(0)
    wide = float(np.abs(off).max()) + reach * line
    low, high = float(tested.min()) - wide, min(float(tested.max()) + wide, 0.9 * spectrum.highest)
    about = {h * parts.mesh_order(mesh) for mesh in parts.meshes for h in range(1, HARMONICS + 1)}
    loud = [
        place
        for rate in rates
        for middle in (0.0, *about)
        for place in middle + rate * np.arange(np.ceil((low - middle) / rate), (high - middle) / rate)
        if place > 2.0 * line and abs(place - middle) > 0.5 * rate
    ]
    own = np.array(loud) - np.rint(np.array(loud) / view.order) * view.order
    seen = [
        place
        for place, off_own in zip(loud, own, strict=True)
        if abs(off_own) > OFF * line and view.has_top_at(float(place))
    ]
    lines = np.add.outer(np.array(seen), off).ravel()
    nearest = tested[np.abs(lines[:, None] - tested).argmin(axis=1)]
    deep = np.repeat(spectrum.power(seen), off.size) >= DEEPEST * spectrum.power(nearest)
    return np.unique(lines[deep & (np.abs(lines - nearest) <= reach * line) & (lines > 0.0)])
