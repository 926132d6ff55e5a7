# SPDX-License-Identifier: Apache-2.0
"""Check of the options of a diagnosis before any file is read: all problems at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.turning_parts import train_parts
from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.diagnosis.bearings import read_bearing
from pitchpoint.report.diagnosis.machine import read_shaft, stages
from pitchpoint.report.diagnosis.reference import compared_files
from pitchpoint.report.diagnosis.request import Request, slip_of
from pitchpoint.report.diagnosis.severity import machine_group
from pitchpoint.report.diagnosis.speeds import given_speed


def check_options(request: Request) -> None:
    """Check the options that can be checked without the file.

    Raises
    ------
    SignalError
        If an option cannot be used.
    """
    problems = []
    for check in _checks(request):
        try:
            check()
        except PitchpointError as error:
            problems.append(str(error))
    every = list(dict.fromkeys(problems))
    if every:
        raise SignalError(every[0] if len(every) == 1 else "\n  ".join([f"{len(every)} problems", *every]))


def _checks(request: Request) -> Iterator[Callable[[], object]]:
    """Functions that raise an error if an option cannot be used."""
    if request.train is not None:
        text = request.train
        yield lambda: train_parts(stages(text))
    for reader, texts in (
        (given_speed, request.speeds),
        (read_shaft, request.shafts),
        (read_bearing, request.bearings),
    ):
        for one in texts:
            yield partial(reader, one)
    yield partial(slip_of, request)
    if request.machine_group:
        yield partial(machine_group, request.machine_group)
    if request.references:
        yield partial(compared_files, request)
