# SPDX-License-Identifier: Apache-2.0
"""Guided joints: moved frames and joints with user-defined coordinates."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from pitchpoint.core.errors import CompileError
from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements import guide as element
from pitchpoint.elements.signal import Pool
from pitchpoint.model.components.joint import DISPLACEMENTS, FUNCTIONS, Joint
from pitchpoint.model.components.law import Constant, FormulaLaw, Law, PythonLaw, TableLaw
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import body_numbers
from pitchpoint.system.rules.drive import value_of_law
from pitchpoint.system.rules.elastic_body import elastic_of
from pitchpoint.system.rules.flexible_rim import rims
from pitchpoint.system.rules.places import Places
from pitchpoint.system.rules.stiffness import user_law


def guide_bank(places: Places) -> Bank:
    """Functions of all guided joints; Python functions are approximated over the scenario duration."""
    model, scenario = places.model, places.scenario
    number = body_numbers(model)
    duration = (scenario.duration if scenario is not None else None) or 1.0
    pool = Pool()
    rows, names = [], []
    for seat in model.mechanism.seats.values():
        if seat.joint is None or seat.kind not in FUNCTIONS:
            continue
        joint = model.joints[seat.joint]
        first = True
        for word, laws in joint.motion.items():
            for law in laws:
                row = np.zeros(1, element.RECORD)[0]
                row["i"], row["m"], row["first"] = number[seat.body], list(DISPLACEMENTS).index(word), first
                _follow(row, pool, joint, law, duration, f"joints.{seat.joint}.motion.{word}")
                first = False
                rows.append(row)
                names.append(f"{seat.joint}.{word}")
    own = pack("guide", element.RECORD, rows, names, pool=pool.array())
    parts = {name: elastic_of(model, name, number[name]).guides for name in model.elastic_bodies}
    parts |= {rim.name: rim.guides for rim in rims(model, number)}
    names += [f"{name}.{k}" for name, records in parts.items() for k in range(len(records))]
    return replace(own, records=np.concatenate([own.records, *parts.values()]), names=tuple(names))


def _follow(row: Any, pool: Pool, joint: Joint, law: Law, duration: float, where: str) -> None:
    """Write one function to its record."""
    own = list(joint.coordinates)
    row["k"] = element.TIME
    if isinstance(law, Constant):
        row["form"], row["value"] = element.LINEAR, law.value
    elif isinstance(law, FormulaLaw):
        variable = law.variables[0]
        row["k"] = own.index(variable) if variable in own else element.TIME
        element.set_formula(row, pool, Formula.parse(law.text, law.variables))
    elif isinstance(law, TableLaw):
        row["k"] = own.index(law.over) if law.over in own else element.TIME
        element.set_table(row, pool, law.abscissa, law.values)
    elif isinstance(law, PythonLaw):
        function = user_law(law, where)
        element.set_function(
            row,
            pool,
            lambda t: np.array([value_of_law(function, s) for s in np.atleast_1d(t)]),
            0.0,
            duration,
        )
    else:
        raise CompileError(f"{where}: a displacement cannot be prescribed by {type(law).__name__}")
