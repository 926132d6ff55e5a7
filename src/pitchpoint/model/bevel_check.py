# SPDX-License-Identifier: Apache-2.0
"""What is wrong with the bevel gears of a model: keys that exclude each other, shapes, where they sit."""

from __future__ import annotations

import math
from functools import partial
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message
from pitchpoint.model.fault_check import check_faults
from pitchpoint.model.keys import Place
from pitchpoint.model.pair_check import told_shape

if TYPE_CHECKING:
    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.read import Reader


def check_bevel_gears(parts: Parts, report: Reader) -> None:
    """Report all that is wrong with bevel gears by themselves, and two bodies that carry one of them.

    Parameters
    ----------
    parts
        The parts of the model; gears whose shape is impossible are noted there.
    report
        Where problems go.
    """
    _carriers(parts, report)
    for name, gear in parts.bevel_gears.items():
        at: Place = ("bevel_gears", name)
        if name in parts.known("gears"):
            report.problem(at, "has the name of a gear", remedy="call one of the two otherwise")
        before = len(report.problems)
        _choices(gear, at, report)
        if len(report.problems) > before or at in report.tainted:
            parts.misshapen.add(name)
            continue
        if not told_shape(parts, at, partial(_impossible, gear), report):
            check_faults(gear, (*at, "faults"), report)


def _carriers(parts: Parts, report: Reader) -> None:
    """Every bevel gear sits on one body."""
    carriers: dict[str, str] = {}
    for name, body in parts.bodies.items():
        for gear in body.bevel_gears:
            if gear in carriers:
                report.problem(
                    ("bodies", name, "bevel_gears"),
                    f"carries {gear}, which sits on {carriers[gear]} already",
                    remedy="leave it on one of the two bodies",
                )
            carriers.setdefault(gear, name)


def _choices(gear: BevelGear, at: Place, report: Reader) -> None:
    """Keys of which exactly one is allowed, and the hand of spirals."""
    if gear.spiral_angle > 0.0 and gear.hand is None:
        report.problem(
            (*at, "hand"),
            "is missing: a spiral bevel gear is left or right handed",
            remedy="add hand: left or hand: right",
        )
    if gear.mate_teeth is None and gear.shaft_angle != math.radians(90.0):
        report.problem((*at, "shaft_angle"), "requires mate_teeth", remedy="give mate_teeth, or remove it")


def _impossible(gear: BevelGear) -> list[Message]:
    """What makes a gear or its body impossible."""
    problems = gear.geometry.problems()
    if not problems:
        _ = gear.blank
    return problems
