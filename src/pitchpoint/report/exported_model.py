# SPDX-License-Identifier: Apache-2.0
"""Models for other programs: FMUs from a started run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.core.compiler import machine_code
from pitchpoint.core.errors import Message, ModelError, PitchpointError
from pitchpoint.core.fmi.fmu_file import own_platform
from pitchpoint.core.nearest import hint
from pitchpoint.io.fmu.linking import PLATFORMS
from pitchpoint.io.fmu.model import (
    ACCELERATION,
    INDICATOR,
    INPUT,
    OUTPUT,
    PARAMETER,
    SLOPE,
    SPEED,
    STATE,
    TIME,
    FmuModel,
    Variable,
    identifier,
)
from pitchpoint.io.fmu.writing import fmu_bytes
from pitchpoint.io.target import check_target, write_file
from pitchpoint.solvers.coupled_calls import check_list, check_scenario
from pitchpoint.solvers.exported_rest import ExportedRest
from pitchpoint.solvers.exported_run import ExportedRun, export_run
from pitchpoint.solvers.input_places import Place
from pitchpoint.solvers.tunable import tunable_places
from pitchpoint.system.compile import compile_model

if TYPE_CHECKING:
    import os

    from pitchpoint.model.model import Model

Parameters = Sequence[str] | Mapping[str, tuple[float, float] | None]


def export_fmu(
    model: Model,
    path: str | os.PathLike[str],
    scenario: str,
    *,
    version: int = 3,
    platforms: Sequence[str] = (),
    parameters: Parameters = (),
    inputs: Sequence[str] = (),
) -> Path:
    """Write a scenario of a model as an FMU; returns its path.

    Parameters
    ----------
    model
        The model.
    path
        File to write; a new file or an older FMU of this package.
    scenario
        Name of a scenario with a duration.
    version
        Version of FMI, 2 or 3.
    platforms
        Platforms by their names in FMI 3.0, such as "x86_64-linux"; default: that of this computer.
    parameters, inputs
        Paths of numbers of the model that become tunable parameters, and inputs besides constant loads. A
        mapping gives the smallest and largest value of each parameter in SI units, or None.

    Raises
    ------
    ModelError
        If the model or a parameter cannot be exported, with all reasons.
    MissingDependencyError
        If there is no linker for a platform.
    """
    _check_choice(version, platforms)
    target = check_target(path, "fmu")
    run, tunable = begin_export(model, scenario, parameters, inputs)
    unit = fmu_model(run, tunable, target.stem, model.title or scenario)
    return write_file(target, fmu_bytes(unit, version, list(platforms) or [own_platform()])[0])


def _check_choice(version: int, platforms: Sequence[str]) -> None:
    """Raise ModelError for a version or a platform that is not supported."""
    check_list("platforms", platforms)
    problems = []
    if version not in (2, 3):
        problems.append(Message("version", "is not supported", repr(version), "2 | 3", "use one of these"))
    for name in platforms:
        if name not in PLATFORMS:
            text = f"no library can be made for {name!r}"
            problems.append(Message("platforms", text, remedy=hint(name, list(PLATFORMS))))
    if problems:
        raise ModelError(problems)


def begin_export(
    model: Model, scenario: str, parameters: Parameters = (), inputs: Sequence[str] = ()
) -> tuple[ExportedRun, tuple[Place, ...]]:
    """Started run of a scenario for other programs, and its tunable parameters.

    Parameters
    ----------
    model, scenario
        Model and name of its scenario.
    parameters, inputs
        As for `export_fmu`.
    """
    check_scenario(model, scenario)
    check_list("parameters", parameters)
    check_list("inputs", inputs)
    run = export_run(compile_model(model, scenario))
    ranges = parameters if isinstance(parameters, Mapping) else {}
    given = {path: limits for path, limits in ranges.items() if limits is not None}
    more = tunable_places(model, scenario, run, inputs)
    tunable = tunable_places(model, scenario, run, list(parameters), given)
    return replace(run, inputs=(*run.inputs, *more)), tunable


def fmu_model(
    run: ExportedRun,
    tunable: Sequence[Place],
    name: str,
    title: str,
    optimised_for: tuple[str, str] | None = None,
) -> FmuModel:
    """Model of a unit from a started run.

    Parameters
    ----------
    run
        The run.
    tunable
        Tunable parameters.
    name, title
        Name of the libraries, and title of the model.
    optimised_for
        See `core.compiler.portable.intermediate_code`.
    """
    from pitchpoint.core.compiler import portable  # imports the compiler

    codes = []
    for entry in run.entries:
        code = portable.intermediate_code(entry, optimised_for or portable.WIDE)
        if code is None:
            raise PitchpointError(
                f"{entry.__module__}: this part needs Python at run time; the model cannot be exported"
            )
        codes.append((machine_code.symbol(entry.py_func), code))
    channels = run.system.layout.channels
    variables = [
        *(Variable(OUTPUT, c.name, c.unit, c.long_name, k) for k, c in enumerate(channels)),
        *(_settable(INPUT, p) for p in run.inputs),
        *(_settable(PARAMETER, p) for p in tunable),
        *(_settable(SPEED, p) for p in run.drives),
        *_accelerations(run),
        Variable(TIME, "time", "s", "time"),
        *_state_variables(run),
    ]
    settable = {v.name: k for k, v in enumerate(variables)}
    balancing = [(spin, settable.get(f"loads.{load}.torque", -1)) for spin, load in run.rest.balancing]
    rest = run.rest
    if any(variable < 0 for _, variable in balancing):
        rest, balancing = ExportedRest(), []
    return FmuModel(
        identifier(name),
        title,
        run.image,
        tuple(codes),
        run.code,
        run.numbers,
        {"t0": run.t0, "h": run.h, "rate": run.rate, "far": run.far},
        tuple(variables),
        run.indicators,
        run.t0 + run.duration,
        run.sample,
        run.shafts,
        {
            "entries_of_matrix": [x for row in rest.entries for x in row],
            "free": rest.free,
            "free_balancing": rest.free_balancing,
            "balancing": [x for pair in balancing for x in pair],
            "spins": rest.spins,
            "gaps": [channel for channel, _ in rest.gaps],
        },
        [x for pair in zip(rest.times, rest.weights, strict=True) for x in pair],
        rest.extents,
        [most for _, most in rest.gaps],
    )


def _settable(kind: int, p: Place) -> Variable:
    """Variable of a number that the importing program may change."""
    return Variable(kind, p.name, p.unit, p.text, 0, p.start, p.words, p.least, p.most)


def _accelerations(run: ExportedRun) -> list[Variable]:
    """Derivatives of the speeds of drives as inputs, if the unit is for model exchange."""
    text = "derivative of the prescribed speed, for model exchange"
    return [
        Variable(
            ACCELERATION, f"{p.name.rpartition('.')[0]}.acceleration", f"{p.unit}^2", text, words=p.words
        )
        for p in (run.drives if run.numbers["exchange"] else ())
    ]


def _state_variables(run: ExportedRun) -> list[Variable]:
    """States of the model exchange, their derivatives, and the event indicators."""
    n = len(run.states)
    places = [(f"coordinate[{name}]", unit) for name, unit in run.states]
    rates = [(f"rate[{name}]", f"{unit}/s") for name, unit in run.states]
    slopes = [unit for _, unit in rates] + [f"{unit}/s^2" for _, unit in run.states]
    both = [*places, *rates]
    values = [*run.state.q.tolist(), *run.state.v.tolist()]
    texts = ["joint coordinate"] * n + ["rate of a joint coordinate"] * n
    events = run.system.layout.events
    return [
        *(Variable(STATE, name, unit, texts[k], k, values[k]) for k, (name, unit) in enumerate(both)),
        *(
            Variable(SLOPE, f"der({name})", slopes[k], f"derivative of {name}", k)
            for k, (name, _) in enumerate(both)
        ),
        *(
            Variable(INDICATOR, f"indicator[{events[e].name}]", "1", events[e].long_name, k)
            for k, e in enumerate(run.indicators)
        ),
    ]
