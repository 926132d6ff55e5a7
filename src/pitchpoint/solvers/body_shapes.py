# SPDX-License-Identifier: Apache-2.0
"""What modes do to the bodies: motions of their frames, and the share of a shaking base that drives them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

DIRECTIONS = ("x", "y", "z", "rx", "ry", "rz")
"""Motions of a base: along the world axes, and turns about them through the world origin."""


def body_motions(system: System, state: State, shapes: NDArray[np.inexact]) -> NDArray[np.inexact]:
    """Displacement of the origin and small turn of every body, world axes.

    Parameters
    ----------
    system, state
        The system and the place that it vibrates about.
    shapes
        Changes of the coordinates, real or complex, shape (n, nd).

    Returns
    -------
    ndarray, shape (n, nb, 6), ground first
        [m, rad] per unit of the shapes.
    """
    parts = (shapes.real, shapes.imag) if np.iscomplexobj(shapes) else (shapes,)
    found = [np.array([_twists(system, state, x) for x in part]) for part in parts]
    shape = (len(shapes), system.sizes["nb"], 6)
    return (found[0] + 1j * found[1] if len(found) == 2 else found[0]).reshape(shape)


def _twists(system: System, state: State, rates: Array) -> Array:
    """Twists of all bodies at some rates, less those that time alone makes; they are linear in the rates."""
    moved = state.copy()
    found = []
    for sign in (1.0, -1.0):
        moved.v = sign * rates
        evaluate.residual(system, moved)
        found.append(system.workspace.fr["tw"].copy())
    return 0.5 * (found[0] - found[1])


def base_vectors(system: System, state: State) -> Array:
    """Force on the coordinates by each unit acceleration of the base, shape (6, nd).

    They are the momenta of the whole system, forces by acceleration of each coordinate, along the world axes
    and about them through the world origin; massive elements count as bodies do.
    """
    still = state.copy()
    still.v[:] = 0.0
    still.a[:] = 0.0
    still.lam[:] = 0.0
    nd = system.sizes["nd"]
    found = np.zeros((6, nd))
    base = _total(system, still)
    for k in range(nd):
        still.a[k] = 1.0
        found[:, k] = base - _total(system, still)
        still.a[k] = 0.0
    return found


def _total(system: System, state: State) -> Array:
    """Sum of all wrenches about the world origin, shape (6,)."""
    evaluate.residual(system, state)
    frames = system.workspace.fr
    force, moment = frames["F"][:, :3], frames["F"][:, 3:]
    return np.concatenate([force.sum(axis=0), (moment + np.cross(frames["r"], force)).sum(axis=0)])


def participation(vectors: Array, shapes: Array) -> tuple[Array, Array]:
    """Participation factors and effective masses of modes with modal mass 1.

    Parameters
    ----------
    vectors
        See `base_vectors`, shape (6, nd).
    shapes
        Mass-normalised shapes, shape (n, nd).

    Returns
    -------
    ndarray, ndarray, shape (n, 6) each
        Factors [kg^1/2, kg^1/2 m] and effective masses [kg, kg m^2]: the sum over all modes is the mass that
        the coordinates can move.

    References
    ----------
    .. [1] R. W. Clough, J. Penzien: Dynamics of Structures, 3rd ed., section 26-3.

    Examples
    --------
    >>> participation(np.array([[2.0, 2.0]]), np.array([[0.5, 0.5], [0.5, -0.5]]))[1]
    array([[4.],
           [0.]])
    """
    factors = np.asarray(shapes @ vectors.T)
    return factors, factors**2
