# SPDX-License-Identifier: Apache-2.0
"""Prescribed motions of a scenario as constraint rows on the spins."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import CompileError, SolverError
from pitchpoint.core.formula.formula import Formula
from pitchpoint.core.status import NOT_FINITE
from pitchpoint.elements import drive as element
from pitchpoint.elements.ratio import SPIN
from pitchpoint.elements.signal import Pool
from pitchpoint.elements.speed_profile import SpeedPieces, fit_pieces, straight_pieces
from pitchpoint.model.components.law import Constant, FormulaLaw, Law, PythonLaw, TableLaw
from pitchpoint.model.mechanism import coordinate
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import body_numbers
from pitchpoint.system.rules.stiffness import user_law

if TYPE_CHECKING:
    from pitchpoint.core.user_law import UserLaw
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Drive, Scenario


def drive_bank(model: Model, scenario: Scenario) -> Bank:
    """Constraint rows of all driven and held bodies of a scenario, with their ripple."""
    number = body_numbers(model)
    pool = Pool()
    rows, names = [], []
    speeds = model.start_speeds(scenario)
    for word, drive in scenario.drive.items():
        row = np.zeros(1, element.RECORD)[0]
        found = coordinate(model.mechanism, model, word)
        if isinstance(found, str):
            raise CompileError(f"drive.{word}: {found}")
        body, row["q_i"], dimension = found
        row["i"], row["linear"] = number[body], dimension == "length"
        if drive.rate is None and drive.value is None:  # of a sweep, which prescribes the mean speed
            row["form"], row["speed"] = element.SPEED, speeds[body]
        else:
            _prescribe(row, pool, drive, scenario.duration or 1.0, f"drive.{word}")
        if drive.value is None:  # a speed without a start angle
            row["angle"] = _start(model, body, int(row["q_i"]))
        if drive.ripple:
            waves = [(wave.order, wave.amplitude, wave.phase) for wave in drive.ripple.values()]
            element.set_ripple(row, pool, waves)
        rows.append(row)
        names.append(word)
    for body in scenario.hold:
        row = np.zeros(1, element.RECORD)[0]
        row["i"], row["q_i"] = number[body], SPIN
        row["form"], row["speed"] = element.SPEED, speeds[body]
        seat = coordinate(model.mechanism, model, body)
        row["angle"] = _start(model, *seat[:2]) if not isinstance(seat, str) else 0.0
        rows.append(row)
        names.append(body)
    return pack("drive", element.RECORD, rows, names, pool=pool.array())


def _start(model: Model, body: str, place: int) -> float:
    """Start value of a joint coordinate of a body [rad, m]."""
    seat = model.mechanism.seats[body]
    if seat.joint is None:
        return 0.0
    return float(model.joints[seat.joint].start.get(seat.coordinates[place], 0.0))


def _prescribe(row: Any, pool: Pool, drive: Drive, duration: float, where: str) -> None:
    rate, value = drive.rate, drive.value
    if rate is not None:
        if isinstance(rate, Constant):
            row["form"], row["speed"] = element.SPEED, rate.value
            return
        key = "speed" if drive.speed is not None else "velocity"
        element.set_speed_pieces(row, pool, speed_pieces(rate, duration, f"{where}.{key}"))
    elif isinstance(value, Constant):
        element.set_angle_formula(row, pool, Formula.parse(repr(value.value), ("t",)))
    elif isinstance(value, FormulaLaw):
        element.set_angle_formula(row, pool, Formula.parse(value.text, ("t",)))
    elif isinstance(value, TableLaw):
        from scipy.interpolate import PchipInterpolator

        # a table of angles needs a smooth speed: monotone cubic through its points
        smooth = PchipInterpolator(value.abscissa, value.values).derivative()
        at = np.array(value.abscissa)
        pieces = fit_pieces(smooth, at[0], at[-1], at)
        element.set_speed_pieces(row, pool, pieces)
        row["angle"] = value.values[0] - pieces.angles()[0]
    else:
        raise CompileError("a prescribed angle must be a value, a formula of t or a table over time")


def speed_pieces(law: Law, duration: float, where: str = "drive.speed") -> SpeedPieces:
    """Piecewise polynomial approximation of a prescribed speed over time.

    Parameters
    ----------
    law
        Speed [rad/s] over time.
    duration
        Time up to which a formula or function is approximated [s].
    where
        Path in the scenario, for messages.

    Raises
    ------
    CompileError
        If the type of law is not supported.
    """
    if isinstance(law, TableLaw):
        return straight_pieces(law.abscissa, law.values)
    if isinstance(law, FormulaLaw):
        formula = Formula.parse(law.text, ("t",))
        return fit_pieces(
            lambda t: np.broadcast_to(np.asarray(formula(t), dtype=float), t.shape), 0.0, duration
        )
    if isinstance(law, PythonLaw):
        own = user_law(law, where)
        return fit_pieces(lambda t: np.array([value_of_law(own, s) for s in t]), 0.0, duration)
    raise CompileError(f"a speed cannot be prescribed by {type(law).__name__}")


def value_of_law(law: UserLaw, t: float) -> float:
    """Value of a user law at time t; a failure raises a SolverError, since the model file itself is valid."""
    try:
        value = law(t, 0.0)
    except Exception:  # noqa: BLE001 - a user's code may raise anything; diagnose reports it
        value = math.nan
    if not math.isfinite(value):
        raise SolverError(f"{law.diagnose(t, 0.0)} (t = {t:.6g} s)", NOT_FINITE)
    return value
