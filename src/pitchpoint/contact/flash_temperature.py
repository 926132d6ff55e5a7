# SPDX-License-Identifier: Apache-2.0
"""Flash temperature of two sliding flanks: rise of the surface temperature within the contact.

Source: H. Blok, Proc. Inst. Mech. Eng., General Discussion on Lubrication (1937); ISO/TS 6336-20.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]

SEMI_ELLIPTIC = 0.785983
"""Maximum over x of 2/π^1.5 ∫ √(1 − s²)/√(x − s) ds from −1 to x: heat distributed like Hertz's pressure."""
STEEL = 13_795.0
"""Thermal contact coefficient √(λ ρ c) of martensitic steels to ISO/TS 6336-20 [W s^0.5/(m² K)]."""


def flash_temperature(
    load: ArrayLike,
    width: ArrayLike,
    speed_1: ArrayLike,
    speed_2: ArrayLike,
    friction: float,
    thermal_contact: tuple[float, float] = (STEEL, STEEL),
) -> FloatArray:
    """Maximum rise of the surface temperature in a line contact [K], shape of the arrays.

    Parameters
    ----------
    load
        Normal force per length of the contact line, w [N/m].
    width
        Half width of the contact, b_H [m].
    speed_1, speed_2
        Speeds of both surfaces relative to the contact, in the same direction [m/s], ≥ 0, not both zero.
    friction
        Coefficient of friction μ [-].
    thermal_contact
        Thermal contact coefficients of both bodies, B_M = √(λ ρ c) [W s^0.5/(m² K)].

    Notes
    -----
    Θ_fl = 0.786 μ w |v_1 − v_2|/(√b_H (B_M1 √v_1 + B_M2 √v_2)); with the whole width 2 b_H the factor is 1.11
    (Blok 1937). It is the maximum of a semi-elliptic heat source that moves fast compared with the conduction
    of heat, v b_H ρ c/λ > 10; the heat is divided so that both bodies have the same maximum.

    Examples
    --------
    Steel, 500 N/mm, b_H 0.2 mm, 10 and 6 m/s, μ 0.05:

    >>> round(float(flash_temperature(5e5, 2e-4, 10.0, 6.0, 0.05)), 2)
    71.79
    """
    w, b_H, v_1, v_2 = (np.asarray(x, dtype=np.float64) for x in (load, width, speed_1, speed_2))
    sink = thermal_contact[0] * np.sqrt(v_1) + thermal_contact[1] * np.sqrt(v_2)
    return np.asarray(SEMI_ELLIPTIC * friction * w * np.abs(v_1 - v_2) / (np.sqrt(b_H) * sink))
