# SPDX-License-Identifier: Apache-2.0
"""Minimum thickness of the oil film of a lubricated line contact.

Source: D. Dowson and G. R. Higginson, *Elastohydrodynamic Lubrication* (1966).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]


def film_thickness(
    load: ArrayLike,
    radius: ArrayLike,
    rolling_speed: ArrayLike,
    compliance: float,
    viscosity: float,
    pressure_viscosity: float,
) -> FloatArray:
    """Minimum film thickness of a line contact of elastic bodies [m], shape of load × radius × speed.

    Parameters
    ----------
    load
        Normal force per length of the contact line, w [N/m].
    radius
        Reduced radius of curvature normal to the contact line, R [m].
    rolling_speed
        Mean of the rolling speeds of both surfaces, u = (v_1 + v_2)/2 [m/s], ≥ 0.
    compliance
        Sum of (1 − ν²)/E of both bodies [1/Pa].
    viscosity
        Dynamic viscosity at the inlet, η_0 [Pa s].
    pressure_viscosity
        Pressure-viscosity coefficient, α [1/Pa].

    Notes
    -----
    h_min/R = 2.65 U^0.7 G^0.54 W^−0.13 with U = η_0 u/(E' R), G = α E', W = w/(E' R), E' = 2/compliance
    (Dowson and Higginson 1966). Smooth surfaces, isothermal, without starvation.

    Examples
    --------
    Steel, 100 N/mm, R 10 mm, 5 m/s, 20 mPa s, 20 1/GPa: U 4.417e-11, G 4527.5, W 4.417e-5:

    >>> from pitchpoint.contact.hertz import plane_strain_compliance
    >>> soft = 2.0 * plane_strain_compliance(206e9, 0.3)
    >>> round(float(film_thickness(1e5, 0.01, 5.0, soft, 0.02, 20e-9)) * 1e6, 4)
    0.519
    """
    R = np.asarray(radius, dtype=np.float64)
    E = 2.0 / compliance
    U = viscosity * np.asarray(rolling_speed, dtype=np.float64) / (E * R)
    W = np.asarray(load, dtype=np.float64) / (E * R)
    return np.asarray(2.65 * R * U**0.7 * (pressure_viscosity * E) ** 0.54 * W**-0.13)
