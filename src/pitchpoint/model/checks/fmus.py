# SPDX-License-Identifier: Apache-2.0
"""Checks of FMUs of other programs: permission, file, platform, variables, start values."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.core.fmi.fmu_file import TYPES, FmuFileError, FmuVariable, read_fmu
from pitchpoint.core.nearest import LISTED, did_you_mean, nearest
from pitchpoint.model.keys import Place

if TYPE_CHECKING:
    from pitchpoint.model.components.controller import FmuController
    from pitchpoint.model.reading.reader import Reader


def check_fmu(at: Place, part: FmuController, report: Reader) -> None:
    """Check the file of an FMU and its connections."""
    if not report.allow_code:
        report.problem(
            (*at, "file"),
            "names an FMU, whose library is not run unless allowed",
            remedy="if you trust its author, use --allow-code (allow_code=True)",
        )
        return
    try:
        unit = read_fmu(part.file)
    except FmuFileError as error:
        report.hand_on((*at, "file"), error.problem.changed(value=f"'{Path(part.file).name}'"))
        return
    for key, causality in (("inputs", "input"), ("outputs", "output"), ("parameters", "parameter")):
        known = {name: v for name, v in unit.variables.items() if v.causality == causality}
        for name in getattr(part, key):
            _variable((*at, key, name), name, known, unit.variables, report)
    given = {*part.inputs, *part.parameters}
    for name, variable in unit.variables.items():
        if variable.causality in ("input", "parameter") and not variable.start and name not in given:
            key = f"{variable.causality}s"
            report.problem(
                (*at, key),
                f"do not give {name}, which has no start value in the FMU",
                remedy=f"add {name} to {key}",
            )


def _variable(
    at: Place,
    name: str,
    known: Mapping[str, FmuVariable],
    every: Mapping[str, FmuVariable],
    report: Reader,
) -> None:
    """Check that a variable exists, and that it is a number."""
    word = str(at[-2])
    if name not in known:
        what = f"is {every[name].causality} there" if name in every else "does not exist in the FMU"
        some = ", ".join(list(known)[:LISTED]) or "none"
        listed = f"{word} of the FMU: {some}"
        if len(known) > LISTED:
            near = ", ".join(nearest(name, known, 3) or list(known)[:3])
            listed = f"the FMU has {len(known)} {word}, such as {near}"
        report.problem(at, what, remedy=f"{did_you_mean(name, known)}{listed}")
    elif known[name].type not in TYPES or not known[name].scalar:
        what = known[name].type if known[name].scalar else f"array of {known[name].type}"
        report.problem(at, "is not a number", value=what, remedy="connect a scalar variable")
