# SPDX-License-Identifier: Apache-2.0
"""Origin of the data of a diagnosis: file, speed, machine, noise, assumptions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from pitchpoint.analysis.shaft_tests import SLIP
from pitchpoint.core.errors import split_notes
from pitchpoint.report.diagnosis.record import Record
from pitchpoint.report.diagnosis.severity import machine_group, standard

if TYPE_CHECKING:
    from pitchpoint.report.diagnosis.machine import Machine
    from pitchpoint.report.diagnosis.request import Request
    from pitchpoint.report.diagnosis.study import Study

Row = tuple[str, str, str]


def origin(
    request: Request, record: Record, machine: Machine, found: Study, noise: Sequence[str]
) -> tuple[Row, ...]:
    """Rows of the table of origins: quantity, value, origin.

    Parameters
    ----------
    request
        Options of the command.
    record
        Evaluated part of the file.
    machine
        The machine and what is known of its speed.
    found
        The study.
    noise
        Sentences about added noise.
    """
    time, count = record.time, record.time.size
    length = float(time[-1] - time[0])
    rate = (count - 1) / length if length > 0.0 else 0.0
    named = f"file, {record.rate_source}" if record.rate_source else "file"
    source = "--sample-rate" if request.sample_rate is not None else named
    rows = [
        (
            "file",
            ", ".join((request.file, *request.more)),
            ", ".join(text for key, text in record.about.items() if key != "notes" and text),
        ),
        ("sample rate", f"{rate:.6g} Hz", source),
        ("length", f"{length:.6g} s, {count} samples", _cut(record)),
        ("machine", *_machine(request, bool(record.model_text))),
        ("speed", _speed(found), found.over.source),
    ]
    rows += [("bearing", text, "--bearing") for text in machine.sources]
    rows += [("shaft", text, "--shaft") for text in request.shafts]
    if any(bearing.name not in _given(request) for bearing in found.parts.bearings):
        rows.append(("bearings", "all others" if request.bearings else "all", "model"))
    chosen = (
        "--channel"
        if request.channels
        else "all of sensors and internal quantities (--all-channels)"
        if request.all_channels and record.model_text
        else "sensors first, then internal quantities"
        if record.model_text
        else "all"
    )
    rows.append(("channels", ", ".join(found.over.signals), chosen))
    rows += [("sensor", text, "--sensor") for text in request.sensors]
    if request.machine_group:
        rows.append(("machine group", standard(machine_group(request.machine_group)), "--machine-group"))
    rows += [
        ("noise", "; ".join(noise), "--noise" if request.noise is not None else "default for results")
    ] * bool(noise)
    given = "default" if request.false_alarm == type(request).false_alarm else "--false-alarm"
    rows.append(("false alarms", f"{100.0 * request.false_alarm:g} % of records of noise alone", given))
    notes = record.about.get("notes", "")
    rows += [("note in the file", note, "file") for note in split_notes(notes)]
    assumed = "shafts with fixed axes" + "; teeth of equal pitch" * bool(found.parts.meshes)
    most = SLIP if request.slip is None else request.slip
    slip = f"; bearing slip below {100.0 * most:.2g} %" if found.parts.bearings else ""
    rows.append(("assumptions", assumed + slip, "–"))
    return tuple(rows)


def _cut(record: Record) -> str:
    if record.settle_time:
        return f"file, less the first {record.settle_time:g} s (settle_time of the scenario)"
    return "file"


def _machine(request: Request, found_in_file: bool) -> tuple[str, str]:
    if request.train is not None:
        return f"train of gears {request.train}", "--train"
    if request.model is not None:
        return request.model, "--model"
    if not found_in_file:
        return "one shaft" if not request.shafts else "shafts of the options", "options"
    return "model stored in the file", "file"


def _speed(found: Study) -> str:
    """Speed of the reference shaft."""
    shaft = next((s.name for s in found.parts.shafts if s.order == 1), "the input")
    hertz = found.over.frequency
    if found.over.speeds is not None:
        low, high = (60.0 * value for value in found.over.speeds)
        return f"{shaft}: {low:.4g} to {high:.4g} rpm"
    if hertz != hertz:
        return f"{shaft}: variable"
    near = f" ±{100.0 * found.over.tolerance:.3g} %" if found.over.tolerance else ""
    return f"{shaft}: {hertz:.6g} Hz ({60.0 * hertz:.6g} rpm){near}"


def _given(request: Request) -> set[str]:
    return {text.partition(":")[0].strip() for text in request.bearings}
