# SPDX-License-Identifier: Apache-2.0
"""Transmission error of spur pairs with constant pair stiffness and relieved tips, and its closed forms.

Independent of the package: pairs are springs k in parallel with gaps over the path of contact, in base
pitches from A; contact begins at A and ends at E.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Relief:
    """Linear relief: amount [m] at the end of the path, length [base pitches]."""

    amount: float = 0.0
    length: float = 0.0

    def __call__(self, distance):
        """Gap at a distance from the end of the path [base pitches]."""
        return self.amount * max(0.0, 1.0 - distance / self.length) if self.length > 0.0 else 0.0


def deflection(phase, force, k, eps, start=Relief(), end=Relief()):
    """Approach of the flanks at a mesh phase [base pitches]: sum of k max(0, x - gap) = force."""
    places = phase % 1.0 + np.arange(int(eps - phase % 1.0) + 1)
    gaps = sorted(start(p) + end(eps - p) for p in places)
    for n in range(len(gaps), 0, -1):
        x = (force / k + sum(gaps[:n])) / n
        if x >= gaps[n - 1]:
            return x
    raise ValueError("no pair within the path of contact")


def harris(force, k, C):
    """Peak-to-peak error of long linear relief C from the ends of single contact: |F/k - C|/2 (FC-9)."""
    return 0.5 * abs(force / k - C)


def best_relief(eps, k, *forces):
    """Length [base pitches] and amount [m] of least peak-to-peak error over the range of forces."""
    return eps - 1.0, 0.5 * (min(forces) + max(forces)) / k
