# SPDX-License-Identifier: Apache-2.0
"""Sidebands due to ball passage around the lines of a bearing with strong lines."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.shaft_tests import HARMONICS, OFF, ShaftView, passages

DEEPEST = 4.0
"""Minimum power of a line over that of its sideband: even full modulation gives sidebands of half the
amplitude."""


def passage_sidebands(view: ShaftView, tested: Array, rates: Sequence[float], reach: float) -> Array:
    """Orders near tested lines that are ball passage sidebands of stronger lines of loud bearings.

    Parameters
    ----------
    view
        Orders of the tested shaft.
    tested
        Orders of the tested lines [-], shape (n,).
    rates
        Ball passes, or impacts, of the loud bearings per revolution of the reference shaft [-].
    reach
        Maximum distance from a tested line, in lines of the record [-].

    Returns
    -------
    ndarray
        Orders [-], shape (m,), increasing.

    Notes
    -----
    Loud bearings have lines at k f and h f_mesh ± k f for many k. Ball passage in all bearings, which
    modulates the mesh lines of healthy machines [1]_, also modulates these lines: sidebands at up to three
    passages, of at most half the amplitude. Only lines above the noise are used, and none that may be an
    order of the shaft itself. Valid if the slip of the balls is within the resolution of the record.

    References
    ----------
    .. [1] C. S. Sunnersjö, Varying compliance vibrations of rolling bearings, Journal of Sound and Vibration
       58(3), 1978, 363-373.

    Examples
    --------
    A mesh at 21 and impacts at 3.57 have a line at 24.57, with sidebands of the balls of a second bearing:

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
