# SPDX-License-Identifier: Apache-2.0
"""Power supplied by jumps of a mesh stiffness, where tooth pairs enter or leave without relief.

A pair without relief meets flanks that the other pairs have already deflected by x: its elastic energy jumps
from zero to k x^2/2, and the speed of the gears does not supply it. The channel `parametric_power` contains
the work of the smooth changes only, since a jump has no power at an instant. Its work is what is missing in
the energy balance of the mesh between the two samples around the jump::

    W = [U] - F dx + (P_damping - P_parametric) dt

with the elastic energy U, the mesh force F (damper included) and the deflection x; F and P are means of the
two samples.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

NEEDED = (
    "mesh_phase mesh_stiffness elastic_energy mesh_force deflection damping_power parametric_power".split()
)
"""Channels of a mesh from which the work of its jumps follows."""


def jump_phases(model: Model) -> dict[str, tuple[float, ...]]:
    """Phases of a cycle at which the stiffness of a mesh jumps [-], by mesh with such jumps."""
    from pitchpoint.report.numbers import cycles_of_model

    return {name: cycle.jumps for name, (cycle, _, _) in cycles_of_model(model, 3).items() if cycle.jumps}


def jump_power(time: Array, channels: dict[str, Array], phases: tuple[float, ...]) -> float | None:
    """Mean power supplied by the jumps of a mesh stiffness [W]; None if the samples do not separate them.

    Parameters
    ----------
    time
        Times of the samples [s], shape (n,).
    channels
        Channels `NEEDED` of the mesh in SI units, each of shape (n,).
    phases
        Phases of one cycle at which the stiffness jumps, of one flank [-].

    Notes
    -----
    The back flank has as many jumps at other phases, and the axes shift those of both flanks, so the jumps
    are found where the stiffness changes most between two samples in contact.

    Examples
    --------
    A stiffness of 1e8 N/m that doubles at the deflection of 10 um supplies 5 mJ:

    >>> k = np.array([1e8, 1e8, 2e8, 2e8])
    >>> x, zero = np.full(4, 10e-6), np.zeros(4)
    >>> mesh = dict(mesh_phase=np.array([0.7, 0.9, 0.1, 0.3]), mesh_stiffness=k, elastic_energy=k * x**2 / 2)
    >>> mesh |= dict(mesh_force=k * x, deflection=x, damping_power=zero, parametric_power=zero)
    >>> round(jump_power(np.array([0.0, 0.1, 0.2, 0.3]), mesh, (0.0,)) * 0.3, 6)
    0.005
    """
    mesh = channels
    turned = np.unwrap(mesh["mesh_phase"], period=1.0)
    apart = np.diff([*sorted(phases), min(phases) + 1.0])
    if time.size < 2 or np.abs(np.diff(turned)).max() >= 0.5 * apart.min():
        return None
    force, lost, fed = (
        0.5 * (mesh[name][1:] + mesh[name][:-1])
        for name in ("mesh_force", "damping_power", "parametric_power")
    )
    work = (
        np.diff(mesh["elastic_energy"]) - force * np.diff(mesh["deflection"]) + (lost - fed) * np.diff(time)
    )
    k = mesh["mesh_stiffness"]
    change = np.where((k[1:] > 0.0) & (k[:-1] > 0.0), np.abs(np.diff(k)), 0.0)
    count = min(round(len(phases) * np.abs(np.diff(turned)).sum()), change.size)
    passed = np.argsort(change)[change.size - count :]
    return float(work[passed].sum() / (time[-1] - time[0]))
