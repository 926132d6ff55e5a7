# SPDX-License-Identifier: Apache-2.0
"""How deep two bevel flanks reach into each other, from their surfaces alone: no plane of action, no mesh."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.geometry.bevel.tooth import bevel_tooth, placed

GRID = np.linspace(0.0, 1.0, 61)
"""Places of a flank among which the deepest one is sought, again and again."""


def true_depths(m, flank, tooth, R, ahead=(0.0, 0.0)):
    """Deepest place of a tooth of gear 1 in a tooth of gear 2, along the base tangent.

    Parameters
    ----------
    m
        A `OneBevel` without `Placement.angles`: tooth 0 of gear 1 stands in a space of gear 2 at rest.
    flank
        1 for the front flanks, -1 for the back ones.
    tooth
        Number of the tooth of gear 1.
    R
        Distances from the apex of gear 1 [m].
    ahead
        Angles by which this tooth and that of gear 2 stand before their places [rad].

    Returns
    -------
    depth : ndarray
        Turn of gear 2 that would free each place, times its base radius there [m]; below 0 a gap.
    rolls : ndarray
        Rolls on gear 1 and gear 2 where these places are, shape (2, n) [rad].
    """
    one, two = m.pair.gear1, m.pair.gear2
    sides = [float(side) for side in m.row["side"]]
    frames = [m.frames["R"][k] @ np.diag([1.0, sides[k], sides[k]]) for k in range(2)]
    apexes = [m.frames["r"][k] + m.apexes[k] * m.frames["R"][k][:, 2] for k in range(2)]
    turned = [
        side * (math.atan2(ray[1], ray[0]) + phi)
        for side, ray, phi in zip(sides, m.row["towards"], m.frames["phi"], strict=True)
    ]
    base = math.sin(two.delta_b)
    low, high = np.zeros(np.size(R)), np.full(np.size(R), 1.2 * one.sigma_a)
    for _ in range(5):
        sigma = low[:, None] + (high - low)[:, None] * GRID
        polar, half = bevel_tooth(one).involute(sigma)
        at = turned[0] + 2.0 * math.pi * tooth / one.z + flank * half + ahead[0]
        world = apexes[0] + placed(one, polar, at + np.zeros_like(polar), np.array(R)[:, None]) @ frames[0].T
        x, y, z = np.moveaxis((world - apexes[1]) @ frames[1], -1, 0)
        away = np.sqrt(x * x + y * y + z * z)
        polar = np.arccos(z / away)
        leg = np.sin(polar + two.delta_b) * np.sin(polar - two.delta_b)
        rolls = np.arctan2(np.sqrt(np.maximum(leg, 0.0)), np.cos(polar))
        inv = rolls / base - np.arctan2(np.sin(rolls), np.cos(rolls) * base)
        # the tooth of gear 2 on the other side of this tooth's space turns its flank of the same hand here
        beside = turned[1] - (2.0 * math.pi * tooth + flank * math.pi) / two.z + ahead[1]
        surface = beside + flank * (two.psi_b - inv) + two.spiral_rate * np.log(away / two.R_m)
        depth = flank * np.remainder(surface - np.arctan2(y, x) + math.pi, 2.0 * math.pi) - flank * math.pi
        depth = depth * base * away
        best = np.argmax(depth, axis=1)
        rows = np.arange(np.size(R))
        step = (high - low) / (GRID.size - 1)
        low, high = sigma[rows, best] - step, sigma[rows, best] + step
    return depth[rows, best], np.stack([sigma[rows, best], rolls[rows, best]])
