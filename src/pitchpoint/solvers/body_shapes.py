# SPDX-License-Identifier: Apache-2.0
"""Body motions of modes, and participation of modes in base excitation."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.system import evaluate
from pitchpoint.system.elastic import modal_bodies
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

DIRECTIONS = ("x", "y", "z", "rx", "ry", "rz")
"""Motions of the base: translations along the world axes, rotations about them through the world origin."""


def body_motions(system: System, state: State, shapes: NDArray[np.inexact]) -> NDArray[np.inexact]:
    """Displacement of the origin and small rotation of every body, world axes.

    Parameters
    ----------
    system, state
        The system and its operating point.
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
    """Twists of all bodies for given rates, without those of prescribed motion; linear in the rates."""
    moved = state.copy()
    found = []
    for sign in (1.0, -1.0):
        moved.v = sign * rates
        evaluate.residual(system, moved)
        found.append(system.workspace.fr["tw"].copy())
    return 0.5 * (found[0] - found[1])


def inertia_wrenches(system: System, state: State, shapes: Array) -> Array:
    """Inertia wrenches of all bodies for given accelerations of the coordinates.

    Force and moment about the origin of each body, world axes, of the mass that it accelerates; massive
    elements act on their bodies.

    Parameters
    ----------
    system, state
        The system and its operating point.
    shapes
        Accelerations of the coordinates, shape (n, nd).

    Returns
    -------
    ndarray, shape (n, nb, 6), ground first
    """
    stopped = state.copy()
    stopped.v[:] = 0.0
    stopped.a[:] = 0.0
    stopped.lam[:] = 0.0
    frames = system.workspace.fr
    evaluate.residual(system, stopped)
    base = frames["F"].copy()
    found = np.zeros((len(shapes), system.sizes["nb"], 6))
    for k, shape in enumerate(shapes):
        stopped.a = np.ascontiguousarray(shape)
        evaluate.residual(system, stopped)
        found[k] = base - frames["F"]
    return found


def base_momenta(system: System, state: State, shapes: Array) -> Array:
    """Momenta of the whole system for given motions, shape (n, 6).

    Along the world axes and about them through the world origin. By reciprocity, this is the modal force per
    unit acceleration of the base. Massive elements are included; forces on modal coordinates of elastic
    bodies are internal.

    Parameters
    ----------
    system, state
        The system and its operating point.
    shapes
        Rates of the coordinates, shape (n, nd).
    """
    wrenches = inertia_wrenches(system, state, shapes)
    wrenches[:, modal_bodies(system)] = 0.0
    force, moment = wrenches[..., :3], wrenches[..., 3:]
    about = moment + np.cross(system.workspace.fr["r"], force)
    return np.concatenate([force.sum(axis=1), about.sum(axis=1)], axis=1)


def participation(momenta: Array) -> tuple[Array, Array]:
    """Participation factors and effective masses of modes with modal mass 1.

    Parameters
    ----------
    momenta
        See `base_momenta`, shape (n, 6).

    Returns
    -------
    ndarray, ndarray, shape (n, 6) each
        Factors [kg^1/2, kg^1/2 m] and effective masses [kg, kg m^2]; their sum over all modes is the total
        movable mass.

    References
    ----------
    .. [1] R. W. Clough, J. Penzien: Dynamics of Structures, 3rd ed., section 26-3.

    Examples
    --------
    Two masses of 2 kg on equal springs in parallel, moving in phase and in antiphase:

    >>> participation(np.array([[2.0, 2.0]]) @ np.array([[0.5, 0.5], [0.5, -0.5]]))[1]
    array([[4., 0.]])
    """
    return momenta.copy(), momenta**2
