# SPDX-License-Identifier: Apache-2.0
"""Start of a run for another program: memory image, compiled loop, inputs, and what must be refused.

The other program relocates the image, sets time and number of steps in the arguments of the loop, and calls
it: the same code with the same data as `time.run_time`, so that all results have the same bits.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.compiler.memory_image import MemoryImage
from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.fmi.fmu_process import FmuFunction
from pitchpoint.core.kernel import COMPILING, address
from pitchpoint.elements.kind import DRIVE
from pitchpoint.model.scenario import EXPLICIT_METHODS
from pitchpoint.solvers.event_watch import FUNCTIONS
from pitchpoint.solvers.explicit import equal_steps
from pitchpoint.solvers.explicit.derivative import SLOPE_AT
from pitchpoint.solvers.exported_rest import ExportedRest, exported_rest
from pitchpoint.solvers.fixed_steps import FIXED_METHODS, loop_of, start_fixed_steps, without_long_steps
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.initial_state.start import Start, prepare_start
from pitchpoint.solvers.input_places import Place, drive_places, load_places, shafts
from pitchpoint.solvers.inputs_outputs import coordinate_units
from pitchpoint.solvers.step_choice import choose_step
from pitchpoint.solvers.time import run_time, scenario_of
from pitchpoint.solvers.vibration_losses import with_vibration_losses
from pitchpoint.system import evaluate
from pitchpoint.system.image import memory_image
from pitchpoint.system.meshes import forget_contacts
from pitchpoint.system.requests import handle_request
from pitchpoint.system.rules.discon import LibraryLaw
from pitchpoint.system.source import source
from pitchpoint.system.system import State, System
from pitchpoint.system.workspace import VALID

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario

RATE = 200.0
"""Rate of the constraint stabilisation of single evaluations [1/s], as in `explicit.runge_kutta`."""
WORDS = {FmuFunction: "an FMU", LibraryLaw: "a controller library"}
"""Words for functions of controllers."""


@dataclass(frozen=True)
class ExportedRun:
    """Started run of a scenario that another program can continue.

    Parameters
    ----------
    system
        The started system, for names and units.
    state
        Its initial state.
    image
        Memory of the run; the array "order" has the arguments of the loop.
    entries
        Entry points: the loop, the single evaluations, then those of the image.
    code
        Offset and number in `entries` of each word that holds the address of an entry point.
    numbers
        Sizes, offsets and flags that the other program needs, by name.
    t0, h, rate
        Start [s], step [s], stabilisation rate of single evaluations [1/s].
    duration, sample
        Duration and sample period of the scenario [s]; 100 steps without a sample rate.
    inputs
        Constant loads of the model file.
    drives
        Constant speeds of drives; their words are the offsets of the records.
    states
        Names and units of the coordinates.
    indicators
        Event functions of contacts and of sticking: zero where forces have a jump or kink. Functions of the
        mesh phase are not among them, because they jump where a pair of teeth follows the next.
    shafts
        Variables of every shaft with a torque or a drive, see `input_places.shafts`.
    rest
        Data for the initial equilibrium.
    far
        Largest distance of a body from the origin at the start, at least 1 m.
    """

    system: System
    state: State
    image: MemoryImage
    entries: tuple[Any, ...]
    code: tuple[tuple[int, int], ...]
    numbers: Mapping[str, int]
    t0: float
    h: float
    rate: float
    duration: float
    sample: float
    inputs: tuple[Place, ...]
    drives: tuple[Place, ...]
    states: tuple[tuple[str, str], ...]
    indicators: tuple[int, ...]
    shafts: tuple[tuple[str, str, str, str], ...]
    rest: ExportedRest
    far: float


def export_run(system: System, scenario: Scenario | None = None) -> ExportedRun:
    """Start the run of a scenario for another program.

    Parameters
    ----------
    system
        Compiled with the scenario.
    scenario
        Scenario; default the one of the system.

    Raises
    ------
    ModelError
        If the model has Python functions or controllers, or the method has variable steps.
    CompileError
        If the memory of the model refers to something outside of it.
    """
    chosen = scenario_of(system, scenario)
    check_exportable(system, chosen)
    chosen = without_long_steps(system, chosen, "an exported model")
    start = started(system, chosen)
    h, every = choose_step(start, chosen)
    loop = loop_of(chosen.method)
    for entry in (loop, handle_request):
        address(entry)
    image = memory_image(lambda: _begun(start, chosen, h))
    entries = (loop, handle_request, *(e for e in image.entries if e not in (loop, handle_request)))
    code = tuple((offset, entries.index(image.entries[k])) for offset, k in image.code)
    return ExportedRun(
        start.system,
        start.state,
        image,
        entries,
        code,
        _numbers(start.system, image, chosen, h),
        start.state.t,
        h,
        RATE,
        float(chosen.duration or 0.0),
        (every if chosen.sample_rate else 100) * h,
        tuple(load_places(start.system, image.at)),
        tuple(drive_places(start.system, image.at)),
        tuple(coordinate_units(start.system).items()),
        _indicators(start.system),
        tuple(shafts(start.system)),
        exported_rest(start.system, start.state, chosen),
        _farthest(start),
    )


def _farthest(start: Start) -> float:
    """Largest distance of a body from the origin [m], at least 1 m."""
    evaluate.residual(start.system, start.state)
    return max(1.0, float(np.abs(start.system.workspace.fr["r"]).max(initial=0.0)))


def check_exportable(system: System, scenario: Scenario) -> None:
    """Refuse a model that needs Python at run time, and methods without fixed steps, by name.

    Raises
    ------
    ModelError
        With all problems.
    """
    problems = [
        Message(
            f"controllers.{controller.name}",
            f"is {WORDS.get(type(controller.function), 'a Python function')}, which an exported model cannot "
            "call",
            remedy="remove it, and use blocks, or a constant load, which becomes an input",
        )
        for controller in system.controllers
    ]
    for kind, laws in system.laws.items():
        problems += [
            Message(
                source(system, kind, system.names[kind][k]),
                "has a law in Python, which an exported model cannot call",
                remedy="give it as a formula or table",
            )
            for k, law in enumerate(laws)
            if law is not None
        ]
    if scenario.method not in FIXED_METHODS:
        problems.append(
            Message(
                "method of the scenario",
                "cannot be exported",
                scenario.method,
                " | ".join(FIXED_METHODS),
                f"use {instead_of(scenario.method)}, with the step in `step`",
            )
        )
    if not COMPILING:
        problems.append(Message("NUMBA_DISABLE_JIT", "disables the compiler", remedy="unset it"))
    if problems:
        raise ModelError(problems)


def instead_of(method: str) -> str:
    """Method with fixed steps for a model that a method with variable steps suits.

    Examples
    --------
    >>> instead_of("runge_kutta"), instead_of("dassl")
    ('adams', 'generalized_alpha')
    """
    return "adams" if method in EXPLICIT_METHODS else "generalized_alpha"


def started(system: System, scenario: Scenario) -> Start:
    """System and state at the start of a run, as for `time.run_time`."""
    start = with_vibration_losses(prepare_start(system, scenario), scenario, run_time)
    forget_contacts(start.system)
    return start


def _begun(start: Start, scenario: Scenario, h: float) -> tuple[System, dict[str, NDArray[Any]]]:
    """New copy of the system with its run begun, and the arrays of the run."""
    copy = start.system.copy()
    run = start_fixed_steps(copy, start.state, scenario, h)
    more = {"order": run.order(0)}
    if getattr(run, "iteration", None) is not None:
        record, arrays = run.iteration
        more |= {"iteration": record} | {f"iteration.{k}": array for k, array in enumerate(arrays)}
    return copy, more


def _numbers(system: System, image: MemoryImage, scenario: Scenario, h: float) -> dict[str, int]:
    """Sizes, offsets and flags of a run, by name."""
    at = image.at
    fields = _order_fields(scenario)
    found = {name: at[name] for name in ("ctl", "q", "v", "a", "lam", "fr", "R", "A", "G", "g", "gt")}
    found |= {
        name: at[f"work.{name}"] for name in ("row", "real", "clock", "al", "ap", "lp", "ev1", "weight", "x")
    }
    found |= {name: system.sizes[name] for name in ("nd", "nc", "no", "ne")}
    found |= {f"order_{name}": at["order"] + fields[name][1] for name in ("t0", "h", "first", "n")}
    found["order_tol"] = at["order"] + fields["tol"][1] if "tol" in fields else 0
    found["per_q"] = at.get("iteration.0", 0)
    found |= {"order": at["order"], "size": len(image.data)}
    found |= {"slope_at": SLOPE_AT, "past": equal_steps.PAST, "valid": VALID}
    found["implicit"] = int(scenario.method == "generalized_alpha")
    drives = sum(len(system.records[kind]) for kind in system.kinds(DRIVE))
    found["driven"] = int(drives > len(drive_places(system, at)))
    # the rotation vector of a tumbling body needs a new reference attitude after half a turn
    found["exchange"] = int(not np.any(system.program["body"]["chart"] >= 0))
    return found


def _order_fields(scenario: Scenario) -> Any:
    """Fields of the arguments of the compiled loop of a method: name to type and offset."""
    loop: Any = generalized_alpha if scenario.method == "generalized_alpha" else equal_steps
    return loop.ORDER.fields


def _indicators(system: System) -> tuple[int, ...]:
    """Event functions of contacts and of sticking."""
    wanted = {*FUNCTIONS["contact"], *FUNCTIONS["stick_slip"]}
    events = enumerate(system.layout.events)
    return tuple(k for k, event in events if event.name.partition("[")[0] in wanted)
