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
    seen: dict[int, str] = {}
    for section, wrong in (("inputs", OUT), ("outputs", IN)):
        given = getattr(part, section)
        for name in given:
            _record((*at, section, name), name, wrong, seen if section == "outputs" else {}, report)
        numbers = [find_record(name).number for name in given if find_record(name)]  # type: ignore[union-attr]
        for name in given:
            record = find_record(name)
            if record is not None and numbers.count(record.number) > 1 and name != record.name:
                report.problem(
                    (*at, section, name), f"is the same record as {record.name}", remedy="remove one"
                )
    for name, signal in part.outputs.items():
        if not isinstance(signal, str):
            report.problem((*at, "outputs", name), "is not the name of a signal", value=f"{signal:g}")
    for name, value in part.start.items():
        if name not in part.outputs:
            remedy = did_you_mean(name, part.outputs) + f"outputs are {', '.join(part.outputs)}"
            report.problem((*at, "start", name), "is not among the outputs", remedy=remedy)
        elif isinstance(value, str):
            report.problem((*at, "start", name), "is not a number", value=value, remedy="give a number")
    _demands(at, part, report)
    if part.torque_table is not None and len(part.torque_table) > MOST_POINTS:
        report.problem(
            (*at, "torque_table"), "has too many points", str(len(part.torque_table)), f"<= {MOST_POINTS}"
        )


def _record(at: Place, name: str, wrong: str, seen: dict[int, str], report: Reader) -> None:
    """Check the name and the direction of a record."""
    record = find_record(name)
    if record is None:
        remedy = f"{did_you_mean(name, BY_NAME)}or record_N with N from 1 to {SIZE}"
        report.problem(at, "is not a record of the swap array", remedy=remedy)
    elif record.direction == SET:
        report.problem(at, f"is set by the interface: {record.meaning}", remedy="remove it")
    elif record.direction == wrong:
        whose = "output" if wrong == OUT else "input"
        report.problem(at, f"is an {whose} of the library: {record.meaning}", remedy=f"move it to {whose}s")


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
