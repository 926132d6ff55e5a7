# SPDX-License-Identifier: Apache-2.0
"""Checks of the courses of inputs in scenarios."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.components.block import Input
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.signals import TIME

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.scenario import Scenario


def check_inputs(parts: Parts, scenario: Scenario, at: Place, report: Reader) -> None:
    """Check that courses belong to inputs, and that their formulas depend on the time only.

    Parameters
    ----------
    parts
        Parts of the model.
    scenario
        The scenario.
    at
        Path of its inputs.
    report
        Collects the problems.
    """
    from pitchpoint.core.formula.formula import Formula, FormulaError

    known = [name for name, block in parts.blocks.items() if isinstance(block, Input)]
    for name, course in scenario.inputs.items():
        if name not in known and not (name in parts.known("blocks") and name not in parts.blocks):
            listed = f"inputs are {', '.join(known)}" if known else "add blocks: {NAME: {type: input}}"
            remedy = f"{did_you_mean(name, known)}{listed}"
            report.problem((*at, name), "is not the name of a block of type input", remedy=remedy)
        if course.formula is not None:
            try:
                Formula.parse(course.formula, (TIME,))
            except FormulaError as error:
                remedy = error.remedy or "a formula may use t, pi, numbers and functions"
                report.problem((*at, name, "formula"), f"cannot be read as a formula: {error}", remedy=remedy)
