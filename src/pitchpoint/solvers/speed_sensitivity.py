# SPDX-License-Identifier: Apache-2.0
"""Sensitivity of critical speeds to the stiffness of components and to the inertia of parts.

For a lightly damped mode z e^(i omega t) of symmetric stiffness, the first-order change of its frequency is
[1]_

    d omega/omega = (V d k/k - (T - E) d m/m)/(T + V)

with strain energy V of the component of stiffness k, and kinetic energy T and gyroscopic energy E of the part
whose mass and moments of inertia change by the same ratio (see `mode_energies`). The crossing of the branch
omega(Omega) with an order moves further than the branch by 1/(1 - s), where s is the slope of the branch over
that of the order: s = 0 without gyroscopic effects, s = 1 where the branch follows the order.

The sum over all components and parts is zero: a machine of twice the stiffness and twice the mass has the
same critical speeds.

References
----------
.. [1] M. I. Friswell, J. E. T. Penny, S. D. Garvey, A. W. Lees: Dynamics of Rotating Machines, Cambridge
   University Press 2010, section 2.6 (Rayleigh quotient).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pitchpoint.solvers.modes.energies import Energies, Motions
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.system.rules.places import STATE

PARALLEL = 1e-6
"""Difference of the slopes of branch and order, over that of the order, below which they do not cross."""


@dataclass(frozen=True)
class Sensitivity:
    """Relative change of one critical speed per relative change of a stiffness or an inertia.

    Parameters
    ----------
    stiffness
        By component, shape (components,); zero for weight and other loads.
    inertia
        By part: mass and moments of inertia, shape (parts,).
    """

    stiffness: Array
    inertia: Array


def sensitivities(motions: Motions, energies: Energies, slopes: Array) -> list[Sensitivity]:
    """Sensitivities of critical speeds.

    Parameters
    ----------
    motions, energies
        Parts and components, and energies of the n modes at their critical speeds.
    slopes
        Slope of each branch over that of the order, shape (n,).
    """
    groups = motions.groups
    per_kinetic = 1.0 / (1.0 + energies.strain_ratio)  # T/(T + V)
    away = 1.0 - slopes
    further = np.divide(per_kinetic, away, out=np.full(len(away), np.nan), where=np.abs(away) > PARALLEL)
    springs = np.array(groups.springs, dtype=bool)
    stiffness = energies.strain * (energies.strain_ratio * further)[:, None] * springs
    inertia = -(energies.kinetic.sum(axis=2) - energies.turning) * further[:, None]
    inertia *= [not name.endswith(STATE) for name in groups.parts]  # the bristles of clutches have no mass
    return [Sensitivity(k, m) for k, m in zip(stiffness, inertia, strict=True)]
