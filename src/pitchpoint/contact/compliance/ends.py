# SPDX-License-Identifier: Apache-2.0
"""Softer ends of helical teeth: slices near the acute end of a tooth, a rule of the KISSsoft user manual.

Derivation: docs/theory/flank_compliance.md, "Coupling along the face width".
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from pitchpoint.contact.compliance.description import Array, FlankCompliance
from pitchpoint.geometry.cylindrical_gear import CylindricalGear


def reduced_thickness(gear: CylindricalGear, z: Array, flank: str = "left") -> Array:
    """Thickness of helical teeth perpendicular to their trace, cut off by the end faces [m].

    Parameters
    ----------
    gear
        The gear.
    z
        Positions from the middle of the face [m], shape (n,).
    flank
        "left" or "right": the flank from which the thickness counts.

    Returns
    -------
    ndarray, shape (n,)
        At most s_n.

    Notes
    -----
    From a point of the left flank of a right-hand tooth the perpendicular to the trace reaches the end
    face z = b/2 after (b/2 − z)/sin β; the other flank or the other hand that at z = −b/2. Derivation:
    docs/theory/flank_compliance.md, "Coupling along the face width".

    Examples
    --------
    >>> gear = CylindricalGear(z=20, m_n=1e-3, b=10e-3, beta=math.radians(30.0))
    >>> (1e3 * reduced_thickness(gear, np.array([0.0, 4.5e-3]))).round(4).tolist()
    [1.5708, 1.0]
    """
    sine = math.sin(abs(gear.beta))
    if sine == 0.0:
        return np.full(np.shape(z), gear.s_n)
    towards = 1.0 if (gear.beta > 0.0) == (flank == "left") else -1.0
    return np.minimum(gear.s_n, (0.5 * gear.b - towards * np.asarray(z, dtype=np.float64)) / sine)


def reduced_ends(
    found: FlankCompliance, gear: CylindricalGear, width: tuple[float, float] | None = None
) -> FlankCompliance:
    """Compliance with softer planes at the acute ends of helical teeth.

    Parameters
    ----------
    found
        Compliance of the gear; its flank decides which end is acute.
    gear
        The gear.
    width
        Ends of the common face width from the middle of the face [m]; None: the whole face.

    Notes
    -----
    The stiffness of a plane whose middle has the thickness s_red < s_n counts with √(s_red/s_n), its
    compliance with the reciprocal; half of the factor on each side keeps the matrix symmetric and positive.
    Derivation: docs/theory/flank_compliance.md, "Coupling along the face width".

    Examples
    --------
    >>> from pitchpoint.contact.compliance.gear import flank_compliance
    >>> gear = CylindricalGear(z=20, m_n=1e-3, b=10e-3, beta=math.radians(30.0))
    >>> plain = flank_compliance(gear, planes=10, coupling="none")
    >>> ratio = reduced_ends(plain, gear).own[-1, -1, 0, 0] / plain.own[-1, -1, 0, 0]
    >>> round(float(ratio), 3)
    1.253
    """
    low, high = (-0.5 * gear.b, 0.5 * gear.b) if width is None else width
    n = found.planes
    middle = low + (high - low) * (np.arange(n) + 0.5) / n
    thickness = reduced_thickness(gear, middle, str(found.provenance.get("flank", "left")))
    factor = (gear.s_n / thickness) ** 0.25
    both = (factor[:, None] * factor)[:, :, None, None]
    return replace(
        found,
        own=found.own * both,
        beside=found.beside * both,
        provenance={**found.provenance, "ends": "reduced"},
    )
