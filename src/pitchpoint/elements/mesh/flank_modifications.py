# SPDX-License-Identifier: Apache-2.0
"""Flank modifications at a point of a flank: closed form from the rows of `geometry.modification_terms`."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.geometry.modification_terms import (
    END,
    HELIX_SLOPE,
    LEAD_CROWNING,
    N_TERM,
    PROFILE_CROWNING,
    PROFILE_SLOPE,
    ROOT,
    TIP,
)
from pitchpoint.multibody.channels import F8


@kernel
def _relief(row, at, u):
    """Gap of a relief at the relative distance u towards its end, and its slope."""
    start = row[at + 1]
    if u <= start:
        return 0.0, 0.0
    slope = row[at] / (1.0 - start)
    share = (u - start) / (1.0 - start)
    if row[at + 2] > 1.0:
        return row[at] * share * share, 2.0 * slope * share
    return row[at] * share, slope


@kernel
def modification_at(row, t, zeta):
    """Gap of the modifications in a row at the relative height t and the relative width zeta, and its slopes.

    Constant beyond 0 <= t <= 1 and -1 <= zeta <= 1.
    """
    inside_t = 1.0 if t > 0.0 and t < 1.0 else 0.0
    inside_zeta = 1.0 if zeta > -1.0 and zeta < 1.0 else 0.0
    t = min(max(t, 0.0), 1.0)
    zeta = min(max(zeta, -1.0), 1.0)
    tip, tip_slope = _relief(row, TIP, t)
    root, root_slope = _relief(row, ROOT, 1.0 - t)
    end, end_slope = _relief(row, END, abs(zeta))
    c = 2.0 * t - 1.0
    gap = row[PROFILE_CROWNING] * c * c - row[PROFILE_SLOPE] * (t - 0.5) + tip + root
    gap += row[LEAD_CROWNING] * zeta * zeta - 0.5 * row[HELIX_SLOPE] * zeta + end
    by_t = 4.0 * row[PROFILE_CROWNING] * c - row[PROFILE_SLOPE] + tip_slope - root_slope
    by_zeta = 2.0 * row[LEAD_CROWNING] * zeta - 0.5 * row[HELIX_SLOPE]
    by_zeta += end_slope if zeta > 0.0 else -end_slope
    return gap, by_t * inside_t, by_zeta * inside_zeta


@kernel
def second_derivative_at(row, t):
    """Second derivative of the modifications over the relative height t, without edges of linear reliefs."""
    if not (t > 0.0 and t < 1.0):
        return 0.0
    found = 8.0 * row[PROFILE_CROWNING]
    if row[TIP + 2] > 1.0 and t > row[TIP + 1]:
        found += 2.0 * row[TIP] / (1.0 - row[TIP + 1]) ** 2
    if row[ROOT + 2] > 1.0 and 1.0 - t > row[ROOT + 1]:
        found += 2.0 * row[ROOT] / (1.0 - row[ROOT + 1]) ** 2
    return found


@kernel
def roll_sign(b, gear):
    """Sign of lengths of roll on gear 1 or 2 (0 or 1); they have the opposite one inside its base circle."""
    return -1.0 if gear == 1 and b["r_b2"] < 0.0 else 1.0


@kernel
def relative_place(b, gear, z, roll):
    """Relative height and width of a point of a flank of gear 1 or 2 (0 or 1), and their slopes.

    z: width from the mid-face of the gear [m], roll: length of roll [m], signed.
    """
    per_z = 2.0 / (b["b1"] if gear == 0 else b["b2"])
    first = b["roll"][gear, 0]
    per_roll = 1.0 / (b["roll"][gear, 1] - first)
    sign = roll_sign(b, gear)
    return (sign * roll - first) * per_roll, z * per_z, sign * per_roll, per_z


@kernel
def modification(b, gear, z, roll):
    """Gap of the modifications of gear 1 or 2 (0 or 1) of the current flank, and its slopes over z and roll.

    z: width from the mid-face of the gear [m], roll: length of roll [m], signed.
    """
    row = view(pooled(b, b["terms"][gear]), (2, N_TERM), F8)[0 if b["now"]["flank"] > 0 else 1]
    t, zeta, per_roll, per_z = relative_place(b, gear, z, roll)
    gap, by_t, by_zeta = modification_at(row, t, zeta)
    return gap, by_zeta * per_z, by_t * per_roll
