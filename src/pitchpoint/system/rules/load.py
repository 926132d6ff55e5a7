# SPDX-License-Identifier: Apache-2.0
"""Torques and forces of a model as records; a balancing torque starts at zero."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import CompileError
from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements import force as force_element
from pitchpoint.elements import signal as sig
from pitchpoint.elements import torque as torque_element
from pitchpoint.model.components.law import Balance, Constant, FormulaLaw, Law, PythonLaw, TableLaw
from pitchpoint.model.frames import GROUND, body_frame
from pitchpoint.model.shafts import place_of_load
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import end_of, frame_at, seat_at
from pitchpoint.system.rules.places import Places
from pitchpoint.system.rules.stiffness import user_law

if TYPE_CHECKING:
    from pitchpoint.model.components.load import Load
    from pitchpoint.model.model import Model

OVER = {
    "time": sig.OVER_TIME,
    "angle": sig.OVER_ANGLE,
    "elongation": sig.OVER_ANGLE,
    "rate": sig.OVER_SPEED,
}
"""Abscissa codes of a table; an elongation along a line is passed as an angle."""


def set_signal(record: Any, pool: sig.Pool, law: Law, where: str) -> Any:
    """Write a law to the signal fields of a record; returns the function of a Python law, else None."""
    if isinstance(law, Constant):
        sig.set_constant(record, law.value)
    elif isinstance(law, Balance):
        sig.set_constant(record, 0.0)
    elif isinstance(law, TableLaw):
        over = OVER[law.over]
        period = law.abscissa[-1] - law.abscissa[0] if law.over == "angle" else 0.0
        if abs(period - 2.0 * math.pi) < 1e-9:
            period = 2.0 * math.pi
        sig.set_table(record, pool, np.array(law.abscissa), np.array(law.values), over, period)
    elif isinstance(law, FormulaLaw):
        sig.set_formula(record, pool, Formula.parse(law.text, law.variables))
    elif isinstance(law, PythonLaw):
        sig.set_law(record, pool, law.parameters, sig.OVER_ANGLE)
        return user_law(law, where).function
    else:
        raise CompileError(f"a law of type {type(law).__name__} is not supported")
    return None


def load_banks(places: Places) -> list[Bank]:
    """All torques and forces."""
    return [_torques(places.model), _forces(places.model)]


def _torques(model: Model) -> Bank:
    pool = sig.Pool()
    rows, names, laws = [], [], []
    for name, load in model.loads.items():
        if load.torque is None:
            continue
        row = np.zeros(1, torque_element.RECORD)[0]
        row["i"], row["j"] = _ends(model, load)
        laws.append(set_signal(row, pool, load.torque, f"loads.{name}.torque"))
        rows.append(row)
        names.append(name)
    return pack("torque", torque_element.RECORD, rows, names, pool=pool.array(), laws=tuple(laws))


def _forces(model: Model) -> Bank:
    pool = sig.Pool()
    rows, names, laws = [], [], []
    for name, load in model.loads.items():
        for part, letter in (("force", ""), ("moment", "m")):
            for axis, law in enumerate(getattr(load, part) or ()):
                if isinstance(law, Constant) and law.value == 0.0:
                    continue
                row = np.zeros(1, force_element.RECORD)[0]
                row["i"], row["j"] = _ends(model, load)
                _put_application(row, model, load, axis, part == "moment")
                laws.append(set_signal(row, pool, law, f"loads.{name}.{part}[{axis}]"))
                rows.append(row)
                names.append(f"{name}.{letter}{'xyz'[axis]}")
    return pack("force", force_element.RECORD, rows, names, pool=pool.array(), laws=tuple(laws))


def _ends(model: Model, load: Load) -> tuple[int, int]:
    """Body numbers of a load and its reaction; on shafts those of the stations at the load."""
    there = place_of_load(model, load)
    return tuple(frame_at(model, body, there)[0] for body in (load.body, load.reaction or GROUND))  # type: ignore[return-value]


def _put_application(row: Any, model: Model, load: Load, axis: int, turns: bool) -> None:
    """Set point of application and direction of a force, or of a moment (turns)."""
    direction = np.eye(3)[axis]
    if load.marker is not None:
        _, row["p"], axes = end_of(model, f"{load.body}.{load.marker}")
        if load.along == "marker":
            row["axes"] = force_element.BODY
            direction = axes[:, axis]
    row["F"][3 * turns : 3 * turns + 3] = direction
    if turns or load.marker is not None:
        return
    # lever arm off the spin axis: the point of application does not rotate with the spin
    arm = body_frame(model, load.body)[1] @ np.array((*load.position[:2], 0.0))
    row["F"][3:] = np.cross(arm, direction)
    row["z"] = seat_at(model, load.body, load.position[2])[1]
