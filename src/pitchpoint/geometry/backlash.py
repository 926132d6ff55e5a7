# SPDX-License-Identifier: Apache-2.0
"""Backlash of a gear pair at any centre distance: transverse, circumferential and normal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from pitchpoint.geometry.involute import inv

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair


class Backlash(NamedTuple):
    """Backlash of a pair at one centre distance.

    `j_bt` along the base tangent in the transverse section, `j_wt` as an arc on the working pitch circles,
    `j_bn` normal to the flanks [m]; a negative value means that both flanks interfere.
    """

    j_bt: float
    j_wt: float
    j_bn: float


def backlash_at(pair: GearPair, a: float) -> Backlash:
    """Backlash of a pair at a centre distance.

    Parameters
    ----------
    pair
        The pair; its own centre distance is not used.
    a
        Centre distance [m], negative for a pair with an internal gear.

    Returns
    -------
    Backlash
        j_bt, j_wt, j_bn [m].

    Raises
    ------
    GeometryError
        If the base circles have no common tangent at this centre distance.

    Notes
    -----
    j_bt = (d_b1 + d_b2)(inv α_wt − inv α_w0) − Σ A_sn cos α_t / cos β with inv α_w0 of the given profile
    shifts, whence dj_bt/da = 2 sin α_wt; j_wt = j_bt / cos α_wt, j_bn = j_bt cos β_b  (ISO 21771).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> gear = CylindricalGear(z=50, m_n=3e-3)
    >>> round(backlash_at(GearPair(gear, gear, 0.15), 0.1501).j_bn * 1e6, 3)
    68.576
    """
    alpha_wt = pair.working_pressure_angle(a)
    g1, g2 = pair.gear1, pair.gear2
    allowance = (g1.thickness_allowance + g2.thickness_allowance) * math.cos(g1.alpha_t) / math.cos(g1.beta)
    j_bt = (g1.d_b + g2.d_b) * (inv(alpha_wt) - pair.inv_alpha_w0) - allowance
    return Backlash(j_bt, j_bt / math.cos(alpha_wt), j_bt * math.cos(g1.beta_b))
