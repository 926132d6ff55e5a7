# SPDX-License-Identifier: Apache-2.0
"""Prescribed motions of a scenario as constraint rows on the spins."""

from __future__ import annotations

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
"""Points at which a speed given as formula or Python law is tabulated over the duration."""


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
        t = np.linspace(drive.angle.abscissa[0], drive.angle.abscissa[-1], N_TABLE)
        smooth = PchipInterpolator(drive.angle.abscissa, drive.angle.values)
        element.set_speed_table(row, pool, t, smooth.derivative()(t))
    else:
        raise CompileError("a prescribed angle is a formula of t or a table over time")


def speed_table(law: Law, duration: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Speed over time as a table, shape (n,) each [s], [rad/s]."""
    if isinstance(law, TableLaw):
        return np.array(law.abscissa), np.array(law.values)
    t = np.linspace(0.0, duration, N_TABLE)
    if isinstance(law, FormulaLaw):
        return t, np.broadcast_to(np.asarray(Formula.parse(law.text, ("t",))(t), dtype=float), t.shape)
    if isinstance(law, PythonLaw):
        own = user_law(law)
        return t, np.array([_value(own, s) for s in t])
    raise CompileError(f"a speed cannot be prescribed by {type(law).__name__}")


def _value(law: UserLaw, t: float) -> float:
    """Speed by a user's law; one that fails is a failed computation, not a wrong file."""
    said = law.diagnose(t, 0.0)
    if said:
        raise SolverError(f"{said} (t = {t:.6g} s)", NOT_FINITE)
    return law(t, 0.0)
