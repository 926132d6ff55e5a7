# SPDX-License-Identifier: Apache-2.0
"""Damping of one contact node of tooth surfaces in addition to that of the flank law: film and structure."""

from __future__ import annotations

from pitchpoint.contact.film_damping import film_force, structural_share
from pitchpoint.core.kernel import kernel


@kernel
def farthest_gap(b):
    """Gap up to which nodes without contact have a film force [m]."""
    return 2.0 * b["oil_film"] if b["oil_rate"] > 0.0 else 0.0


@kernel
def with_losses(b, x, w, elastic, found):
    """Force of a node with film and structural damping, never negative, its derivatives by x without that of
    the film, of the film by x, and by w.

    `elastic`: elastic force and its derivative by x; `found`: force with the damping of the flank law, and
    its derivatives by x and by w.
    """
    f, by_x, by_w = found
    film_by_x = 0.0
    if b["structural"] > 0.0:
        share, slope = structural_share(w, b["structural"], b["structural_speed"])
        f += elastic[0] * share
        by_x += elastic[1] * share
        if b["request"]["jac"] != 2:  # a dry friction, which has no linearisation at rest
            by_w += elastic[0] * slope
    if b["oil_rate"] > 0.0:
        film, film_by_x, film_by_w = film_force(x, w, b["oil_rate"], b["oil_film"], b["oil_power"])
        f += film
        by_w += film_by_w
    if f <= 0.0:
        return 0.0, 0.0, 0.0, 0.0
    return f, by_x, film_by_x, by_w
