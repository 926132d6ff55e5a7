# SPDX-License-Identifier: Apache-2.0
"""Polars of sections between two airfoils, by their relative thickness."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.geometry.rotor.polar import Polar

FloatArray = NDArray[np.float64]
_SAME = 1e-9


def blend_polars(polars: Sequence[Polar], thickness: ArrayLike, wanted: ArrayLike) -> list[Polar]:
    """Polars of other relative thicknesses, by monotone cubic interpolation (PCHIP) of the coefficients.

    Parameters
    ----------
    polars
        Complete polars.
    thickness
        Their relative thicknesses, increasing, shape (n,).
    wanted
        Relative thicknesses of the sections, shape (m,); the first or last polar beyond the range.

    Returns
    -------
    list of Polar
        One for each section, at the angles of attack of all polars; the given polars themselves at their own
        thickness.

    Examples
    --------
    >>> alpha = [-3.14159265359, 0.0, 3.14159265359]
    >>> thin, thick = (Polar(alpha=alpha, lift=[0, v, 0], drag=[v, v, v]) for v in (0.2, 0.4))
    >>> [float(p.at(0.0)[1]) for p in blend_polars([thin, thick], [0.2, 0.4], [0.3, 0.1])]
    [0.3, 0.2]
    """
    from scipy.interpolate import PchipInterpolator

    own, at = np.asarray(thickness, dtype=float), np.asarray(wanted, dtype=float)
    at = np.clip(at, own[0], own[-1])
    nearest = np.argmin(np.abs(own[None, :] - at[:, None]), axis=1)
    exact = np.abs(own[nearest] - at) < _SAME
    if exact.all():
        return [polars[k] for k in nearest]
    alpha = np.unique(np.concatenate([polar.knots[:, 0] for polar in polars]).round(9))
    alpha[0], alpha[-1] = -np.pi, np.pi
    table = np.array([[polar.at(a) for a in alpha] for polar in polars])
    between = PchipInterpolator(own, table)(at)
    return [
        polars[nearest[k]]
        if exact[k]
        else Polar(
            name=f"{100 * at[k]:.3g} % thickness",
            alpha=alpha,
            lift=between[k, :, 0],
            drag=between[k, :, 1],
            moment=between[k, :, 2],
        )
        for k in range(at.size)
    ]
