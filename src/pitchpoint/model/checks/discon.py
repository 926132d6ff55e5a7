# SPDX-License-Identifier: Apache-2.0
"""Checks of controller libraries: file, records, torque table."""

from __future__ import annotations

from pitchpoint.core.discon.library_file import library_problem
from pitchpoint.core.discon.records import BY_NAME, IN, LOG_SIZE, OUT, SET, SIZE, TABLE_START, find_record
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.components.controller import DisconController
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader

MOST_POINTS = (1000 - TABLE_START - LOG_SIZE) // 2
"""Points of a torque table that fit before the records above 1000."""
INDIVIDUAL = ("blade_1_pitch_demand", "blade_2_pitch_demand", "blade_3_pitch_demand")


def check_discon(at: Place, part: DisconController, report: Reader) -> None:
    """Check a controller library without loading it.

    Parameters
    ----------
    at
        Its path in the model.
    part
        The controller.
    report
        Collects the problems.
    """
    if (*at, "library") not in report.tainted:
        problem = library_problem(part.library, part.procedure)
        if problem is not None:
            report.hand_on((*at, "library"), problem)
    for section, wrong in (("inputs", OUT), ("outputs", IN)):
        numbers: set[int] = set()
        for name in getattr(part, section):
            _record((*at, section, name), name, wrong, numbers, report)
    made = tuple(part.outputs.values())
    for name in part.start:
        if name not in made:
            remedy = f"{did_you_mean(name, made)}output signals are {', '.join(made)}"
            report.problem((*at, "start", name), "is not an output signal", remedy=remedy)
    _demands(at, part, report)
    if part.torque_table is not None and len(part.torque_table) > MOST_POINTS:
        report.problem(
            (*at, "torque_table"),
            "has too many points",
            value=str(len(part.torque_table)),
            limit=f"<= {MOST_POINTS}",
            remedy="use fewer points: the records of the library have room for no more",
        )


def _record(at: Place, name: str, wrong: str, numbers: set[int], report: Reader) -> None:
    """Check the name and the direction of a record, and that it has not been given before."""
    record = find_record(name)
    if record is None:
        remedy = f"{did_you_mean(name, BY_NAME)}or record_N with N from 1 to {SIZE}"
        report.problem(at, "is not a record of the swap array", remedy=remedy)
    elif record.direction == SET:
        report.problem(at, f"is set by the interface: {record.meaning}", remedy="remove it")
    elif record.direction == wrong:
        whose = "output" if wrong == OUT else "input"
        report.problem(at, f"is an {whose} of the library: {record.meaning}", remedy=f"move it to {whose}s")
    elif record.number in numbers:
        report.problem(at, f"is record {record.number}, which has another entry", remedy="remove one of them")
    else:
        numbers.add(record.number)


def _demands(at: Place, part: DisconController, report: Reader) -> None:
    """Check that the library gives the demands that are read."""
    collective = part.pitch_control == "collective"
    for name in part.outputs:
        record = find_record(name)
        if record is None:
            continue
        if collective and record.name in INDIVIDUAL:
            remedy = "read pitch_demand, or write pitch_control: individual"
            report.problem(
                (*at, "outputs", name), "is not given with pitch_control: collective", remedy=remedy
            )
        if not collective and record.name in ("pitch_demand", "pitch_rate_demand"):
            remedy = "read blade_1_pitch_demand and so on, or write pitch_control: collective"
            report.problem(
                (*at, "outputs", name), "is not given with pitch_control: individual", remedy=remedy
            )
        if record.name in INDIVIDUAL[part.blades :]:
            report.problem(
                (*at, "outputs", name), "is of a blade that does not exist", limit=f"{part.blades} blades"
            )
