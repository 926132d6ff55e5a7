# SPDX-License-Identifier: Apache-2.0
"""Detection of jumps in speed sweeps, where the response changes from one branch to another.

A mesh with backlash has two stable responses over a range of speeds. A sweep that continues from the previous
state follows one branch to its end and then jumps to the other; there the level changes between two points
far more than around them.

The rule
--------
Let y_i = ln(rms_i) in the order of the sweep and d_i = y_{i+1} - y_i. Interval i has a jump if

1. |d_i| ≥ ln(`smallest_ratio`): the level changes by at least that ratio, and
2. |d_i| > `contrast` · (largest |d| of the two intervals before and the two after).

The rule has no false alarms at smooth resonances. Logarithms make it independent of unit and level. However
coarsely a smooth resonance is sampled, a steep step has another steep step within two intervals: with samples
at …, 1+p, p, 1-p, 2-p, … grid steps from the pole of an undamped resonance, the sharpest possible curve,
d = ln((1+p)/p) is compared with ln((1-p)/p) and ln((2-p)/(1-p)), and the ratio is below 1.7 for all p. A
floor reduces the neighbours; over all widths, floors and positions the ratio is below 2.0. The default
contrast of 2.5 is above both. Near a fold the slope per grid step decreases with the grid, while the jump
does not: a finer sweep makes the jump clearer.

If both directions are known, hysteresis is an additional criterion: a response that is equal up and down is a
single function of the frequency without a jump, whatever its shape (such as two narrow resonances between a
few points). `sweep_jumps` therefore also requires that the levels of the two directions differ by
`smallest_ratio` or more at the point before or after the jump. With this confirmation a contrast of 2 is
sufficient, and a jump spread over two steps of one sign, because of too short a settling time, is found too.

Not detected are jumps within two points of an end of the sweep, jumps smaller than `smallest_ratio`, two
jumps within two intervals of each other, and, with both directions, a hysteresis narrower than the grid.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, same_length

SMALLEST_RATIO = 1.1
CONTRAST = 2.5
CONFIRMED_CONTRAST = 2.0
NEIGHBOURS = 2


@dataclass(frozen=True)
class Jump:
    """One jump of a sweep.

    Attributes
    ----------
    direction
        `up` or `down`: direction of the sweep.
    frequency
        Midpoint between the two points [Hz, or the unit of the frequency axis].
    before, after
        Level at the last point on the old and the first point on the new branch, in the unit of the level.
    half_width
        Half the distance between the two points: uncertainty of the midpoint.
    """

    direction: str
    frequency: float
    before: float
    after: float
    half_width: float


def find_jumps(
    frequency: ArrayLike,
    level: ArrayLike,
    *,
    smallest_ratio: float = SMALLEST_RATIO,
    contrast: float = CONTRAST,
) -> tuple[Jump, ...]:
    """Jumps in one direction of a sweep; see the module for the rule.

    Parameters
    ----------
    frequency
        Mesh frequency [Hz] (or speed, or any monotonic axis), shape (n,), in the order of the sweep.
    level
        RMS of the alternating response at these points, shape (n,), ≥ 0, any unit.
    smallest_ratio
        Minimum ratio of levels of a jump [-], > 1.
    contrast
        Minimum ratio of a step to its neighbours [-], > 1.

    Returns
    -------
    tuple of Jump
        In the order of the sweep.

    Raises
    ------
    SignalError
        If the frequencies are not monotonic, a level is negative, or a threshold is not above one.

    Notes
    -----
    See the module; a smooth resonance gives no jump on any grid, a fold gives one on every grid that resolves
    its surroundings [1]_. Valid for steady-state points; scatter of transient levels hides jumps but does not
    produce false ones.

    References
    ----------
    .. [1] Original rule, developed for the sweeps of G. W. Blankenship, A. Kahraman, Steady state forced
       response of a mechanical oscillator with combined parametric excitation and clearance type
       non-linearity, Journal of Sound and Vibration 185(5), 1995, 743-765.

    Examples
    --------
    >>> f = [1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6]
    >>> jumps = find_jumps(f, [0.20, 0.21, 0.22, 0.60, 0.58, 0.55, 0.53])
    >>> [(j.direction, round(j.frequency, 9), round(j.before, 9), round(j.after, 9)) for j in jumps]
    [('up', 1.25, 0.22, 0.6)]
    """
    if not (smallest_ratio > 1.0 and contrast > 1.0):
        raise SignalError(f"smallest_ratio, contrast: {smallest_ratio}, {contrast} (limit > 1)")
    if np.size(frequency) < 2 * NEIGHBOURS + 2:
        return ()
    f, y = _checked(frequency, level)
    steps = np.diff(y)
    return tuple(_jump(f, y, i) for i in _steep(steps, float(np.log(smallest_ratio)), contrast))


def sweep_jumps(
    points: Sequence[Mapping[str, Any]],
    *,
    quantity: str = "deflection",
    smallest_ratio: float = SMALLEST_RATIO,
) -> tuple[Jump, ...]:
    """Jumps of a sweep given as a list of points, in one or both directions.

    Parameters
    ----------
    points
        Points in the order of the sweep, each a mapping with `direction` (`up` or `down`), `mesh_frequency`
        [Hz] and, under `quantity`, a mapping with `rms`.
    quantity
        Response whose level is used; deflection along the line of action distinguishes branches best.
    smallest_ratio
        See `find_jumps`; with both directions also the minimum ratio of their levels next to a jump.

    Returns
    -------
    tuple of Jump
        Jumps of the upward sweep first.

    Raises
    ------
    SignalError
        As `find_jumps`.

    Notes
    -----
    One direction: `find_jumps`. Both directions: steep steps confirmed by hysteresis, see the module [1]_.
    Points with a missing or non-finite level (failed cases) are omitted. Valid for sweeps that continue from
    the state of the previous point.

    References
    ----------
    .. [1] See `find_jumps`.

    Examples
    --------
    The upward sweep follows the lower branch to 1200 Hz, the downward sweep the upper branch to 1100 Hz:

    >>> up = [0.9, 0.95, 1, 1.1, 1.2, 1.3, 4, 3.9, 3.8, 3.7]
    >>> down = [3.7, 3.8, 3.9, 4, 4.5, 5, 1.1, 1, 0.95, 0.9]
    >>> points = [{"direction": "up", "mesh_frequency": 700.0 + 100 * k, "deflection": {"rms": a}}
    ...           for k, a in enumerate(up)]
    >>> points += [{"direction": "down", "mesh_frequency": 1600.0 - 100 * k, "deflection": {"rms": a}}
    ...            for k, a in enumerate(down)]
    >>> [(j.direction, j.frequency) for j in sweep_jumps(points)]
    [('up', 1250.0), ('down', 1050.0)]
    """
    threshold = float(np.log(smallest_ratio))
    branches = {d: branch(points, d, quantity) for d in ("up", "down")}
    jumps: list[Jump] = []
    for direction, other in (("up", "down"), ("down", "up")):
        frequency, level = branches[direction]
        if branches[other][0].size < 2:
            jumps.extend(find_jumps(frequency, level, smallest_ratio=smallest_ratio))
            continue
        if frequency.size < 2 * NEIGHBOURS + 2:
            continue
        f, y = _checked(frequency, level)
        f_other, y_other = _checked(*branches[other])
        rising = np.argsort(f_other)
        apart = np.abs(y - np.interp(f, f_other[rising], y_other[rising])) >= threshold
        steps = np.diff(y)
        found = _steep(steps, threshold, CONFIRMED_CONTRAST)
        found += _half_way(steps, threshold, found)
        jumps.extend(_jump(f, y, i) for i in sorted(found) if apart[i] or apart[i + 1])
    return tuple(jumps)


def branch(
    points: Sequence[Mapping[str, Any]], direction: str, quantity: str, statistic: str = "rms"
) -> tuple[Array, Array]:
    """Frequencies [Hz] and levels, shapes (n,), of one direction of a sweep, without failed points.

    Parameters
    ----------
    points
        Points of a sweep, each with direction, mesh_frequency [Hz] and one mapping per quantity.
    direction
        "up" or "down".
    quantity
        Channel or quantity.
    statistic
        Statistic of the quantity that is the level.

    Examples
    --------
    >>> points = [{"direction": "up", "mesh_frequency": 5.0, "deflection": {"rms": 2.0}}]
    >>> branch(points, "up", "deflection")
    (array([5.]), array([2.]))
    """
    rows = []
    for point in points:
        if point["direction"] == direction and point.get(quantity) is not None:
            value = point[quantity].get(statistic)
            if value is not None and np.isfinite(value):
                rows.append((float(point["mesh_frequency"]), float(value)))
    table = np.array(rows, dtype=np.float64).reshape(-1, 2)
    return table[:, 0], table[:, 1]


def _checked(frequency: ArrayLike, level: ArrayLike) -> tuple[Array, Array]:
    """Check frequencies and levels of one direction; the levels as logarithms."""
    f = as_signal(frequency, "frequency")
    a = as_signal(level, "level")
    same_length(f, a, "frequency, level")
    if np.any(a < 0.0):
        raise SignalError("level: is negative; pass the rms of the alternating part")
    if np.any(np.diff(f if f[-1] > f[0] else -f) <= 0.0):
        raise SignalError("frequency: is not monotonic; pass each direction of the sweep separately")
    # levels of zero would give infinite steps
    return f, np.log(np.maximum(a, max(1e-12 * float(a.max()), np.finfo(np.float64).tiny)))


def _jump(f: Array, y: Array, i: int) -> Jump:
    return Jump(
        direction="up" if f[-1] > f[0] else "down",
        frequency=0.5 * float(f[i] + f[i + 1]),
        before=float(np.exp(y[i])),
        after=float(np.exp(y[i + 1])),
        half_width=0.5 * abs(float(f[i + 1] - f[i])),
    )


def _steep(steps: Array, threshold: float, contrast: float) -> list[int]:
    """Intervals whose step exceeds the two on either side by the contrast."""
    size = np.abs(steps)
    inner = range(NEIGHBOURS, steps.size - NEIGHBOURS)
    return [i for i in inner if size[i] >= threshold and size[i] > contrast * _around(size, i, i)]


def _half_way(steps: Array, threshold: float, found: list[int]) -> list[int]:
    """Larger step of every jump that is spread over two steps of one sign and not yet found."""
    size = np.abs(steps)
    more: list[int] = []
    for i in range(NEIGHBOURS, steps.size - NEIGHBOURS - 1):
        if steps[i] * steps[i + 1] <= 0.0 or i in found or i + 1 in found:
            continue
        both = float(size[i] + size[i + 1])
        if both >= threshold and both > 2.0 * CONFIRMED_CONTRAST * _around(size, i, i + 1):
            more.append(i if size[i] >= size[i + 1] else i + 1)
    return more


def _around(size: Array, first: int, last: int) -> float:
    """Largest step among the neighbours on both sides of the intervals first … last."""
    before = size[first - NEIGHBOURS : first]
    after = size[last + 1 : last + 1 + NEIGHBOURS]
    return float(max(before.max(), after.max()))
