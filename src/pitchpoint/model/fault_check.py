# SPDX-License-Identifier: Apache-2.0
"""What is wrong with the faults of a model: no such tooth, sizes larger than it, a law of the whole mesh."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import Problem
from pitchpoint.model.components.gear_faults import Eccentricity
from pitchpoint.model.components.stiffness import OF_PAIRS
from pitchpoint.model.components.tooth_faults import BrokenTooth, PitchError
from pitchpoint.model.keys import Place
from pitchpoint.model.read import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.parts import Parts


def hand_on(report: Reader, base: Place, problem: Problem, taint: bool = True) -> None:
    """Report a problem of the geometry at the key that it names."""
    place: Place = (*base, *(problem.where.split(".") if problem.where else ()))
    report.problem(
        place, problem.message, value=problem.value, limit=problem.limit, remedy=problem.remedy, taint=taint
    )


def check_faults(gear: Gear, at: Place, report: Reader) -> None:
    """Report faults that no tooth of a gear can have."""
    for label, fault in gear.faults.items():
        here = (*at, label)
        tooth = getattr(fault, "tooth", 0)
        if tooth >= gear.number_of_teeth:
            report.problem(
                (*here, "tooth"),
                "is no tooth of this gear",
                value=str(tooth),
                limit=f"<= {gear.number_of_teeth - 1}",
                remedy="count from 0",
                taint=False,
            )
        for problem in _problems(gear, fault):
            hand_on(report, here, problem, taint=False)


def _problems(gear: Gear, fault: object) -> list[Problem]:
    from pitchpoint.geometry.modifications import size_problems
    from pitchpoint.geometry.tooth_faults import break_problems

    if isinstance(fault, BrokenTooth):
        return break_problems(fault.width or 0.0, fault.height or 0.0, gear.geometry)
    if isinstance(fault, PitchError):
        return size_problems({"amount": fault.amount}, gear.geometry)
    if isinstance(fault, Eccentricity):
        return size_problems({"amount": fault.amount}, gear.geometry)
    return []


def check_fault_laws(parts: Parts, report: Reader) -> None:
    """Report faulty gears in meshes whose stiffness knows no single teeth."""
    for name, mesh in parts.meshes.items():
        if mesh.stiffness.law in OF_PAIRS or ("meshes", name, "stiffness") in report.tainted:
            continue
        for gear in mesh.gears:
            for label in parts.gears[gear].tooth_faults if gear in parts.gears else ():
                report.problem(
                    ("gears", gear, "faults", label),
                    f"has no effect in the mesh {name}, whose law {mesh.stiffness.law} is that of the whole "
                    "mesh and knows no single teeth",
                    remedy=f"use one of {', '.join(OF_PAIRS)} there",
                    taint=False,
                )
