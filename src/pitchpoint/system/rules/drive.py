# SPDX-License-Identifier: Apache-2.0
"""Prescribed motions of a scenario as constraint rows on the spins."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError, SolverError
from pitchpoint.core.formula import Formula
from pitchpoint.core.status import NOT_FINITE
from pitchpoint.elements import drive as element
from pitchpoint.elements.signal import Pool
from pitchpoint.model.components.law import Constant, FormulaLaw, Law, PythonLaw, TableLaw
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import body_numbers
from pitchpoint.system.rules.stiffness import user_law

if TYPE_CHECKING:
    from pitchpoint.core.user_law import UserLaw
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Drive, Scenario

N_TABLE = 20001
"""Points at which a speed given as formula or Python law is tabulated at first, over the duration."""
MOST_POINTS = 4_000_000
"""Points of a table; beyond that it would take more than 100 MB."""
MOST_SPLITS = 28
"""Halvings of a first interval: a kink is met by then, a jump never."""
RELATIVE, ABSOLUTE = 1e-6, 1e-9
"""Difference between table and speed: share of the greatest speed, and [rad/s]."""
GOLDEN = 0.6180339887498949


def drive_bank(model: Model, scenario: Scenario) -> Bank:
    """Rows for every driven and every held body of a scenario."""
    number = body_numbers(model)
    pool = Pool()
    rows, names = [], []
    speeds = model.start_speeds(scenario)
    for body, drive in scenario.drive.items():
        row = np.zeros(1, element.RECORD)[0]
        row["i"] = number[body]
        _prescribe(row, pool, drive, scenario.duration or 1.0)
        rows.append(row)
        names.append(body)
    for body in scenario.hold:
        row = np.zeros(1, element.RECORD)[0]
        row["i"] = number[body]
        row["form"], row["speed"] = element.SPEED, speeds[body]
        rows.append(row)
        names.append(body)
    return pack("drive", element.RECORD, rows, names, pool=pool.array())


def _prescribe(row: Any, pool: Pool, drive: Drive, duration: float) -> None:
    if drive.speed is not None:
        if isinstance(drive.speed, Constant):
            row["form"], row["speed"] = element.SPEED, drive.speed.value
            return
        t, w = speed_table(drive.speed, duration)
        element.set_speed_table(row, pool, t, w)
    elif isinstance(drive.angle, FormulaLaw):
        element.set_angle_formula(row, pool, Formula.parse(drive.angle.text, ("t",)))
    elif isinstance(drive.angle, TableLaw):
        from scipy.interpolate import PchipInterpolator

        # a table of angles needs a smooth speed: monotone cubic through its points
        smooth = PchipInterpolator(drive.angle.abscissa, drive.angle.values).derivative()
        t, w = tabulate(smooth, drive.angle.abscissa[0], drive.angle.abscissa[-1])
        element.set_speed_table(row, pool, t, w)
    else:
        raise CompileError("a prescribed angle is a formula of t or a table over time")


def speed_table(law: Law, duration: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Speed over time as a table, shape (n,) each [s], [rad/s]."""
    if isinstance(law, TableLaw):
        return np.array(law.abscissa), np.array(law.values)
    if isinstance(law, FormulaLaw):
        formula = Formula.parse(law.text, ("t",))
        return tabulate(
            lambda t: np.broadcast_to(np.asarray(formula(t), dtype=float), t.shape), 0.0, duration
        )
    if isinstance(law, PythonLaw):
        own = user_law(law)
        return tabulate(lambda t: np.array([_value(own, s) for s in t]), 0.0, duration)
    raise CompileError(f"a speed cannot be prescribed by {type(law).__name__}")


def tabulate(
    speed: Callable[[NDArray[np.float64]], NDArray[np.float64]], begin: float, end: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Table of a speed that straight lines between its points follow closely.

    Intervals are halved until the lines agree with the speed, to 1e-6 of the greatest speed, in the middle of
    each interval and at one more place. That place differs from interval to interval by the golden ratio: a
    ripple that is zero at all points and all middles would go unseen otherwise.

    Parameters
    ----------
    speed
        Speed [rad/s] at times [s], both of shape (n,).
    begin, end
        Range of the table [s].

    Returns
    -------
    tuple
        Times [s] and speeds [rad/s], shape (n,) each, more densely where the speed bends.

    Raises
    ------
    CompileError
        If the speed jumps, or the table would get longer than `MOST_POINTS`.

    Examples
    --------
    >>> t, w = tabulate(lambda t: np.minimum(10.0 * t, 7.0), 0.0, 1.0)
    >>> bool(abs(np.interp(0.70001, t, w) - 7.0) < 1e-5)
    True
    """
    t = np.linspace(begin, end, N_TABLE)
    w = np.array(speed(t), dtype=float)
    k = np.arange(t.size - 1)
    for _ in range(MOST_SPLITS + 1):
        bent = np.zeros(t.size + 1, bool)
        bent[k[_bent(speed, t, w, k)] + 1] = True
        # neighbours too: by chance the speed may cross the line at both places of an interval
        k = np.flatnonzero(bent[1:-1] | bent[:-2] | bent[2:])
        if not k.size:
            return t, w
        if t.size + k.size > MOST_POINTS:
            raise CompileError(
                f"a prescribed speed changes too fast to be tabulated from {begin:g} s to {end:g} s with "
                f"{MOST_POINTS} points; give a shorter duration, or the speed as a table"
            )
        middle = 0.5 * (t[k] + t[k + 1])
        t, w = np.insert(t, k + 1, middle), np.insert(w, k + 1, speed(middle))
        k = k + np.arange(k.size)
        k = np.stack([k, k + 1], axis=1).ravel()
    raise CompileError(
        f"a prescribed speed jumps at t = {t[k[0]]:.6g} s, which takes an infinite torque; "
        "let it rise by ramp or smoothstep, or give the speed as a table"
    )


def _bent(
    speed: Callable[[NDArray[np.float64]], NDArray[np.float64]],
    t: NDArray[np.float64],
    w: NDArray[np.float64],
    k: NDArray[np.int64],
) -> NDArray[np.bool_]:
    """Whether the speed leaves the straight line in the intervals k."""
    allowed = RELATIVE * float(np.max(np.abs(w))) + ABSOLUTE
    length, rise = t[k + 1] - t[k], w[k + 1] - w[k]
    bad = np.zeros(k.size, bool)
    for share in ((k + 1) * GOLDEN % 1.0, 0.5):
        at = t[k] + share * length
        bad |= np.abs(speed(at) - (w[k] + (at - t[k]) / length * rise)) > allowed
    return bad


def _value(law: UserLaw, t: float) -> float:
    """Speed by a user's law; one that fails is a failed computation, not a wrong file."""
    try:
        value = law(t, 0.0)
    except Exception:  # noqa: BLE001 - a user's code may raise anything; diagnose says what
        value = math.nan
    if not math.isfinite(value):
        raise SolverError(f"{law.diagnose(t, 0.0)} (t = {t:.6g} s)", NOT_FINITE)
    return value
