# SPDX-License-Identifier: Apache-2.0
"""Motion of a rigid train with zero mean ripple under pulsating torques: a boundary value problem.

    M s' = Q(t, a, s) - q,    a' = s,    a(0) = 0,    mean of s = 0,    mean of s' = 0

with the ripple s of the free speeds and a of the free angles. Unknown are the constant torques q and the
speeds s(0). Newton's method solves the two means for them: the motion is integrated by the trapezoidal rule,
with its derivatives by both unknowns. Over a period the second mean is the condition s(period) = s(0), and
the first one a(period) = 0. The unknowns over a short smooth window are the initial values of a window twice
as long: over many periods a wrong torque would carry the train away from the mean speed. If the iteration
fails in the shortest window, it proceeds from a part of the torques to the whole of them.

Source of the window: S. Das, Y. Saiki, E. Sander, J. A. Yorke, Quantitative quasiperiodicity, Nonlinearity 30
(2017) 4111-4140: the weighted mean converges faster than any power of the number of periods.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Torques = Callable[[slice, Array, Array], tuple[Array, Array, Array]]
"""Torques on the free rotations at some points of the grid: their values, shape (n, points), and their slopes
over the angles and over the speeds, shape (n, n, points)."""

FIRST = 4096
"""Points of the shortest window, and up to twice as many without a shorter one before."""
CHUNK = 512
"""Points over which the motion is iterated at a time."""
PASSES = 20
"""Largest number of iterations of the unknowns, and of a chunk."""
CLOSE = 1e-6
"""Relative change of the speeds below which Newton's method ends; the error is about its square."""
ACCURATE = 1e-11
"""The same for the motion over a chunk."""
LEAST_STEP = 1.0 / 256.0
"""Least step of the part of the torques."""
SAME = 1e-5
"""Relative change from one window to the next below which a longer one would not change the result."""


@dataclass(frozen=True)
class Motion:
    """A motion with ripple.

    Parameters
    ----------
    speed, angle
        Ripples of the free speeds [rad/s] and angles [rad], shape (n, points).
    weights
        Weights of their means, shape (points,).
    torque
        Means of the torques on the free rotations [N m], shape (n,).
    """

    speed: Array
    angle: Array
    weights: Array
    torque: Array


@dataclass(frozen=True)
class _Path:
    """Motion from initial speeds: `ripple` of speeds and angles (2n, points), its derivatives by initial
    speeds and constant torques (2n, points, 2n), and the torques over it."""

    ripple: Array
    by: Array
    torques: tuple[Array, Array, Array]


def window(points: int) -> Array:
    """Weights exp(-1/(x (1 - x))) over some points; they sum to one.

    Examples
    --------
    >>> window(3).round(4)
    array([0.0377, 0.9246, 0.0377])
    """
    x = (np.arange(points) + 0.5) / points
    weights = np.exp(-1.0 / (x * (1.0 - x)))
    return np.asarray(weights / weights.sum())


def steady_motion(torques: Torques, mass: Array, h: float, points: int, periodic: bool) -> Motion | None:
    """Steady motion under pulsating torques; None if none was found.

    Parameters
    ----------
    torques
        The torques over the grid.
    mass
        Inertia matrix of the free rotations [kg m^2], shape (n, n).
    h
        Distance of the points [s].
    points
        Number of points: of the period, or the largest one without a period.
    periodic
        Whether the points are a period of the torques. If not, and if no motion over the whole period was
        found, the result is that of the longest window.
    """
    n = len(mass)
    if n == 0:
        empty, weights = np.zeros((0, points)), _weights(points, points, periodic)
        return Motion(empty, empty, weights, np.zeros(0))
    sizes = [points]
    while sizes[0] >= 2 * FIRST:
        sizes.insert(0, sizes[0] // 2)
    found: Motion | None = None
    for size in sizes:
        weights = _weights(size, points, periodic)
        if found is None:
            new = _by_parts(torques, mass, h, weights)
        else:
            new = _over(torques, mass, h, weights, (found.speed[:, 0], found.torque))
        if new is None:
            return found
        settled = found is not None and _unchanged(found, new)
        found = new
        if settled and not periodic:
            break
    return found


def _weights(size: int, points: int, periodic: bool) -> Array:
    return np.full(size, 1.0 / size) if periodic and size == points else window(size)


def _unchanged(before: Motion, after: Motion) -> bool:
    size = float(np.abs(after.speed).max())
    moved = float(np.abs(after.speed[:, 0] - before.speed[:, 0]).max())
    turned = float(np.abs(after.torque - before.torque).max())
    return moved <= SAME * size and turned <= SAME * float(np.abs(after.torque).max(initial=0.0))


def _by_parts(torques: Torques, mass: Array, h: float, weights: Array) -> Motion | None:
    """Motion over the shortest window; the part of the torques grows in steps that are halved on failure."""
    n, part, step = len(mass), 0.0, 1.0
    rest = np.zeros((n, weights.size))
    begin, level = np.zeros(n), torques(slice(0, weights.size), rest, rest)[0] @ weights
    while step >= LEAST_STEP:
        tried = min(part + step, 1.0)
        found = _over(_share(torques, tried), mass, h, weights, (begin, tried * level))
        if found is None:
            step *= 0.5
        elif tried == 1.0:
            return found
        else:
            part, begin, level = tried, found.speed[:, 0], found.torque / tried
    return None


def _share(torques: Torques, part: float) -> Torques:
    """A part of all torques."""

    def over(points: slice, speed: Array, angle: Array) -> tuple[Array, Array, Array]:
        """Torques and slopes, see `Torques`."""
        value, by_angle, by_speed = torques(points, speed, angle)
        return part * value, part * by_angle, part * by_speed

    return over


def _over(
    torques: Torques, mass: Array, h: float, weights: Array, unknowns: tuple[Array, Array]
) -> Motion | None:
    """Motion over a window, from estimates of the unknowns; None if Newton's method does not converge."""
    n, points = len(mass), weights.size
    guess, (begin, level) = np.zeros((2 * n, points)), unknowns
    last = np.inf
    for k in range(PASSES):
        path = _path(torques, mass, h, (begin, level), guess)
        change = None if path is None else _correction(path, level, weights)
        if path is None or change is None:
            return None
        step = path.by @ change
        moved, size = float(np.abs(step[:n]).max()), float(np.abs(path.ripple[:n]).max())
        begin, level, guess = begin + change[:n], level + change[n:], path.ripple + step
        if moved <= CLOSE * size:
            return Motion(guess[:n], guess[n:], weights, level)
        if k > 2 and moved > last:
            return None
        last = moved
    return None


def _correction(path: _Path, level: Array, weights: Array) -> Array | None:
    """Changes of the initial speeds and of the constant torques that make both means zero."""
    value, by_angle, by_speed = path.torques
    n = len(value)
    speeds, angles = path.by[:n], path.by[n:]
    rest = np.concatenate([path.ripple[:n] @ weights, value @ weights - level])
    means = np.einsum("ikc,k->ic", speeds, weights)
    slopes = np.einsum("ijk,jkc,k->ic", by_speed, speeds, weights, optimize=True)
    slopes += np.einsum("ijk,jkc,k->ic", by_angle, angles, weights, optimize=True)
    slopes[:, n:] -= np.eye(n)
    try:
        found = np.linalg.solve(np.concatenate([means, slopes]), -rest)
    except np.linalg.LinAlgError:
        return None
    return found if np.all(np.isfinite(found)) else None


def path_from(torques: Torques, mass: Array, h: float, points: int, level: Array) -> Array | None:
    """Ripple of the free speeds, shape (n, points), of a train that starts at its mean speeds.

    Parameters
    ----------
    torques, mass, h, points
        See `steady_motion`.
    level
        Constant torques that act against the pulsating ones [N m], shape (n,).
    """
    n = len(mass)
    found = _path(torques, mass, h, (np.zeros(n), level), np.zeros((2 * n, points)))
    return None if found is None else found.ripple[:n]


def _path(torques: Torques, mass: Array, h: float, given: tuple[Array, Array], guess: Array) -> _Path | None:
    """Motion from initial speeds under constant torques (`given`); None if it leaves all bounds."""
    n, points = len(mass), guess.shape[1]
    begin, level = given
    ripple, by = np.zeros((2 * n, points)), np.zeros((2 * n, points, 2 * n))
    over = np.zeros((n, points)), np.zeros((n, n, points)), np.zeros((n, n, points))
    ripple[:n, 0], by[:n, 0, :n] = begin, np.eye(n)
    for k in range(0, points - 1, CHUNK):
        part = slice(k, min(k + CHUNK, points - 1) + 1)
        now = guess[:, part] + (ripple[:, k] - guess[:, k])[:, None]
        for _ in range(PASSES):
            value, by_angle, by_speed = torques(part, now[:n], now[n:])
            with np.errstate(over="ignore", invalid="ignore"):
                try:
                    found = _linear(mass, h, now, (value - level[:, None], by_angle, by_speed), by[:, k])
                except np.linalg.LinAlgError:  # the trial motion left all bounds
                    return None
                now = now + found[:, :, 0]
            if not np.all(np.isfinite(found)):
                return None
            if np.abs(found[:n, :, 0]).max() <= ACCURATE * np.abs(now[:n]).max():
                break
        else:
            return None
        ripple[:, part], by[:, part] = now, found[:, :, 1:]
        for whole, new in zip(over, (value, by_angle, by_speed), strict=True):
            whole[..., part] = new
    return _Path(ripple, by, over)


def _linear(mass: Array, h: float, y: Array, torques: tuple[Array, Array, Array], begin: Array) -> Array:
    """Newton step of the motion over a chunk and its derivatives, shape (2n, points, 1 + 2n).

    The trapezoidal rule B (y' - y) = h/2 (f' + f) with f = (torque, speed) is linearised about `y`; `begin`
    are the derivatives at the first point, which remains.
    """
    from scipy.linalg import solve_banded

    value, by_angle, by_speed = torques
    n, steps = len(mass), y.shape[1] - 1
    m = 2 * n
    slopes = np.zeros((m, m, steps + 1))
    slopes[:n, :n], slopes[:n, n:] = by_speed, by_angle
    slopes[n:, :n] = np.eye(n)[:, :, None]
    scale = np.eye(m)
    scale[:n, :n] = mass
    ahead, back = scale[:, :, None] - 0.5 * h * slopes, -scale[:, :, None] - 0.5 * h * slopes
    f = np.concatenate([value, y[:n]])
    right = np.zeros((steps, m, 1 + m))
    right[:, :, 0] = (0.5 * h * (f[:, 1:] + f[:, :-1]) - scale @ np.diff(y, axis=1)).T
    right[:, :n, 1 + n :] = -h * np.eye(n)
    right[0, :, 1:] -= back[:, :, 0] @ begin
    upper, lower = m - 1, 2 * m - 1
    bands = np.zeros((upper + lower + 1, m * steps))
    for i in range(m):
        for j in range(m):
            bands[upper + i - j, j::m] = ahead[i, j, 1:]
            bands[upper + m + i - j, j : m * (steps - 1) : m] = back[i, j, 1:steps]
    found = solve_banded((lower, upper), bands, right.reshape(steps * m, 1 + m), check_finite=False)
    result = np.zeros((m, steps + 1, 1 + m))
    result[:, 0, 1:] = begin
    result[:, 1:] = found.reshape(steps, m, 1 + m).transpose(1, 0, 2)
    return result
