# SPDX-License-Identifier: Apache-2.0
"""Modes of a turning rotor with blades in multi-blade coordinates.

See `turning_rotors` for the transformation.
"""

from __future__ import annotations

import math
import time as clock
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.progress import Progress, silent
from pitchpoint.solvers.eigen import best_match, ratio_of
from pitchpoint.solvers.linear_system import linearise, rates_of
from pitchpoint.solvers.modal import FREQUENCY, RATIO
from pitchpoint.solvers.modes.energies import energies_of, motions_of, spins_of, whirl_words
from pitchpoint.solvers.modes.names import base_names, full_names
from pitchpoint.solvers.over_speed import OfTurningRotors
from pitchpoint.solvers.turning_rotors import TurningRotors
from pitchpoint.system.system import System

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.scenario import Scenario

Array = NDArray[np.float64]

AZIMUTHS = 12
"""Positions within the angle between two blades. With the flow around the tower, frequencies and damping
ratios are then within 0.05 % of those of 24 positions; with 6 within 0.4 %, with 3 within 0.7 %."""
LOWEST = 0.03
"""Least imaginary part over the absolute value of eigenvalues that oscillate."""


@dataclass(frozen=True)
class MultibladeModes:
    """Modes of a turning rotor with its support, in axes that do not turn, by frequency.

    Parameters
    ----------
    eigenvalue
        Eigenvalues [1/s], shape (n,), those with Im > 0.
    frequency, damping_ratio
        Im/2 pi [Hz] and -Re/|eigenvalue|, shape (n,).
    blades
        Amplitudes of the blades, collective, in forward and in backward whirl, shape (n, 3), relative to the
        largest multi-blade coordinate of the mode.
    speed
        Speed of the rotor [rad/s].
    names
        Names of the modes, with the whirl of the blades where they move most.
    strain
        Shares of the components in the strain energy, by mode.
    """

    eigenvalue: NDArray[np.complex128]
    frequency: Array
    damping_ratio: Array
    blades: Array
    speed: float
    names: tuple[str, ...]
    strain: tuple[dict[str, float], ...]


def find_multiblade_modes(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    hub: str,
    blades: Sequence[str],
    azimuths: int = AZIMUTHS,
    progress: Progress = silent,
) -> MultibladeModes:
    """Modes of a turning rotor with three or more equal blades, with its support.

    Parameters
    ----------
    system
        The compiled model. Blades are branches of the hub without closed loops.
    scenario
        Gives the speed of the hub; default: the one the system was compiled with.
    hub
        Body that carries the blades and turns about its z axis.
    blades
        Bodies or beams of the blades, in the order of their azimuths.
    azimuths
        Number of positions within the angle between two blades whose mean is used.
    progress
        Called after every element of the matrices.

    Returns
    -------
    MultibladeModes

    Raises
    ------
    CompileError
        If there are fewer than three blades, they differ, or closed loops connect them.
    """
    linear = linearise(system, scenario, progress=progress)
    rates = rates_of(linear, hub, scenario)
    axes = TurningRotors(linear.system, [(hub, blades)], rates)
    basis = axes.basis(linear)
    speed = float(linear.state.v[linear.system.spin(hub)])
    over = OfTurningRotors(linear, rates, axes, [hub], azimuths)
    mean = over.reference
    own = list(mean.states)
    M, D, K = mean.at_rest.M.copy(), mean.D.copy(), mean.K.copy()
    M[:, own], D[:, own], K[:, own] = 0.0, mean.at_rest.M[:, own], mean.D[:, own]
    total = np.array([basis.T @ A @ basis for A in (M, D, K)])
    values, z = _modes(total, len(own))
    shapes = z @ basis.T
    motions = motions_of(mean.system, mean.state, mean.at_rest)
    spins = spins_of(motions, linear.state.v)
    energies = energies_of(motions, shapes, values, 0.0 * shapes.real, spins)
    named = base_names(mean.system, motions, np.abs(values), shapes, energies)
    components = motions.groups.components
    return MultibladeModes(
        eigenvalue=values,
        frequency=values.imag / math.tau,
        damping_ratio=ratio_of(values),
        blades=axes.whirl(shapes, np.sqrt(np.abs(np.diag(mean.at_rest.M)))),
        speed=speed,
        names=full_names(named, whirl_words(energies), axes.ways(shapes, mean.at_rest.M)),
        strain=tuple(dict(zip(components, row.tolist(), strict=True)) for row in energies.strain),
    )


def _modes(matrices: Array, states: int) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues that oscillate and their shapes, by frequency; not those of the states, the last columns.

    Eigenvalues of states are real in turning axes, but turn with the rotor in those that do not. Those of the
    motion are most similar, in shape and value, to the eigenvalues at constant states.
    """
    values, z = _oscillating(matrices, states)
    if states:
        M = matrices[0]
        n = len(M) - states
        held, shapes = _oscillating(matrices[:, :n, :n], 0)
        moved = z[:, :n]
        overlap = np.abs(shapes.conj() @ M[:n, :n] @ moved.T) ** 2
        for one, by in ((shapes, 1), (moved, 0)):
            square = np.einsum("ik,kl,il->i", one.conj(), M[:n, :n], one).real
            overlap /= np.expand_dims(np.maximum(square, 1e-300), by)
        likeness = overlap / (1.0 + np.abs(np.log(values / held[:, None])))
        own = best_match(likeness)
        values, z = values[own], z[own]
    order = np.argsort(values.imag)
    return values[order], z[order]


def _oscillating(matrices: Array, states: int) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues with a positive imaginary part and their shapes, shape (m, n), states last."""
    M, D, K = matrices
    n = len(M) - states
    rates = -np.linalg.solve(np.hstack([M[:, :n], D[:, n:]]), np.hstack([K[:, :n], D[:, :n], K[:, n:]]))
    values, vectors = np.linalg.eig(np.vstack([np.eye(n, 2 * n + states, n), rates]))
    chosen = values.imag > LOWEST * np.abs(values)
    shapes = np.vstack([vectors[:n], vectors[2 * n :]])
    return values[chosen], shapes[:, chosen].T


def solve_multiblade_modes(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    hub: str,
    blades: Sequence[str],
    azimuths: int = AZIMUTHS,
) -> xr.Dataset:
    """Modes of a turning rotor in multi-blade coordinates; arguments and errors of `find_multiblade_modes`.

    Returns
    -------
    xarray.Dataset
        Over `mode`, by frequency: frequency [Hz], the damped natural frequency in axes that do not turn,
        damping_ratio, eigenvalue_real and eigenvalue_imag [1/s]; collective, forward and backward, the
        amplitudes of the blades relative to the largest multi-blade coordinate. `name` is a coordinate.
    """
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    began = clock.perf_counter()
    found = find_multiblade_modes(system, scenario, hub=hub, blades=blades, azimuths=azimuths)
    columns = {
        "frequency": (found.frequency, *FREQUENCY),
        "damping_ratio": (found.damping_ratio, *RATIO),
        "eigenvalue_real": (found.eigenvalue.real, "1/s", "real part of the eigenvalue"),
        "eigenvalue_imag": (found.eigenvalue.imag, "1/s", "imaginary part of the eigenvalue"),
        "collective": (found.blades[:, 0], "1", "amplitude of all blades together"),
        "forward": (found.blades[:, 1], "1", "amplitude of the blades in forward whirl"),
        "backward": (found.blades[:, 2], "1", "amplitude of the blades in backward whirl"),
    }
    names = np.array(found.names, dtype=object)
    options: dict[str, Any] = {"hub": hub, "blades": list(blades), "azimuths": azimuths, "speed": found.speed}
    return xr.Dataset(
        {
            name: (("mode",), values, {"units": unit, "long_name": text})
            for name, (values, unit, text) in columns.items()
        },
        coords={
            "mode": np.arange(1, len(found.frequency) + 1),
            "name": ("mode", names, {"long_name": "name of the mode"}),
        },
        attrs=attributes(system, "multiblade", wall_s=clock.perf_counter() - began, **options),
    )
