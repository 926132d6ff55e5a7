# SPDX-License-Identifier: Apache-2.0
"""Result of the finite elements of one gear: compliance of its flanks and stress of its fillets.

Derivation: docs/theory/tooth_fe.md, "Result".
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

_ARRAYS = ("roll", "same", "next", "far", "contact", "tangents", "fillet", "stress")


@dataclass(frozen=True)
class ToothFE:
    """Compliances in Legendre polynomials over height (P_m(t)) and width (ψ_p(z), see `WidthBasis`).

    A force per length on a left flank, Σ f_np P_n(t') ψ_p(z) concentrated at the height t', displaces a left
    flank at the height t by Σ P_m(t) ψ_p(z) C_mpnq P_n(t') f_q. Forces and displacements are those along the
    transverse base tangent; the force has the axial part of the normal force.

    Parameters
    ----------
    width
        Face width [m].
    roll
        Lengths of roll at t = -1 and t = +1 [m], shape (2,).
    same
        Displacement of the loaded tooth without local indentation [m²/N], shape (M, P, M, P).
    next, far
        Displacement of a tooth due to a force on the next tooth and the one after it, counter-clockwise.
    contact
        Square root of the compliance that refers `same` to the contact depth, as polynomial in t
        [m/N^(1/2)], shape (M,).
    tangents
        Tangent angles of the points of the fillet [rad], shape (F,).
    fillet
        These points at the loaded side of tooth 0 in the section z = 0 [m], shape (F, 2).
    stress
        Stress along the profile, stress along the width and shear stress in the surface of the fillet, as
        polynomials ψ_p(z), due to forces on the previous (clockwise), the same and the next tooth [1/m],
        shape (F, 3, P, 3, M, P).
    provenance
        Settings of the calculation.
    """

    width: float
    roll: FloatArray
    same: FloatArray
    next: FloatArray
    far: FloatArray
    contact: FloatArray
    tangents: FloatArray
    fillet: FloatArray
    stress: FloatArray
    provenance: Mapping[str, Any]

    def to_arrays(self) -> dict[str, NDArray[Any]]:
        """All data as arrays by name, for storage; shapes as in the class."""
        found: dict[str, NDArray[Any]] = {name: getattr(self, name) for name in _ARRAYS}
        found["width"] = np.array(self.width)
        found["provenance"] = np.array(json.dumps(dict(self.provenance)))
        return found

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]]) -> ToothFE:
        """Result from the arrays of `to_arrays`.

        Parameters
        ----------
        arrays
            Arrays by name; shapes as in the class.
        """
        data = {name: np.asarray(arrays[name], dtype=np.float64) for name in _ARRAYS}
        provenance = json.loads(str(arrays["provenance"]))
        return cls(width=float(arrays["width"]), provenance=provenance, **data)
