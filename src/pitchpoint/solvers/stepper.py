# SPDX-License-Identifier: Apache-2.0
"""Co-simulation from Python: a run that another program advances by communication steps.

The rules are those of an exported FMU: inputs are constant in a communication step, which is divided into
equal time steps; the method restarts after a change of an input. The loop is that of `time.run_time`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError, SolverError, join_notes, with_time
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.model.scenario import ERROR_METHODS
from pitchpoint.solvers.controller_end import EndsControllers
from pitchpoint.solvers.coupled_calls import check_list, check_scenario, number_problem
from pitchpoint.solvers.exported_run import export_run, instead_of, started
from pitchpoint.solvers.fixed_steps import FIXED_METHODS, start_fixed_steps, without_long_steps
from pitchpoint.solvers.input_places import Place
from pitchpoint.solvers.sampled_control import begin_anew
from pitchpoint.solvers.stepper_inputs import StepperInputs
from pitchpoint.solvers.time import Loop, scenario_of
from pitchpoint.solvers.tunable import tunable_places
from pitchpoint.system import evaluate
from pitchpoint.system.channel_choice import chosen_channels
from pitchpoint.system.compile import compile_model
from pitchpoint.system.image import arrays_of

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

SAME = 1e-9
"""Relative deviation within which a communication step is a multiple of the time step."""
MOST = 1e9
"""Maximum number of time steps of a communication step."""


@dataclass
class _Record:
    """Sink of a stepper: the last channels, and those to be stored at the communication points."""

    kept: NDArray[np.int64] | None
    last: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    times: list[float] = field(default_factory=list)
    rows: list[NDArray[np.float64]] = field(default_factory=list)

    def append(self, t: NDArray[np.float64], values: NDArray[np.float64]) -> None:
        """Store the last of n samples."""
        self.last = values[-1].copy()
        if self.kept is not None:
            self.times.append(float(t[-1]))
            self.rows.append(self.last[self.kept] if len(self.kept) else self.last)


@dataclass(frozen=True)
class StepperState:
    """Saved state of a stepper, created by `Stepper.save`; it can be restored any number of times."""

    t: float
    _owner: int
    _arrays: Mapping[str, NDArray[Any]] = field(repr=False)
    _more: Mapping[str, Any] = field(repr=False)


class Stepper(EndsControllers):
    """Run that is advanced step by step, for co-simulation; a context that ends its controllers.

    Parameters
    ----------
    model
        The model. Sampled controllers and laws in Python are permitted.
    scenario
        Name of a scenario with a method of fixed steps (`adams`, `rk4`, `generalized_alpha`). The stepper
        starts in its initial state, and uses its time step.
    inputs
        Paths of numbers of the model that become inputs besides all constant loads, such as
        "blocks.error.offset"; as with `export_fmu`, the model must not have laws or controllers in Python.
    record
        Keep the channels of the scenario at each communication point for `dataset`.

    Attributes
    ----------
    inputs
        Present value of each input.
    units
        Unit of each input and output.

    Raises
    ------
    ModelError
        If the method has no fixed steps, or a path cannot be an input.
    SolverError
        If the run cannot start.

    Examples
    --------
    A rotor of 2 kg m^2 and 4 N m turns with 2 rad/s^2: after 0.5 s with 1 rad/s.

    >>> import pitchpoint as pp
    >>> model = pp.Model(
    ...     bodies={"rotor": pp.Body(inertia=2.0, motion="torsion")},
    ...     loads={"motor": pp.Load(body="rotor", torque=0.0)},
    ...     scenarios={"rest": pp.Scenario(speed={"rotor": 0.0}, step=1e-3, duration=1.0, method="adams")},
    ... )
    >>> stepper = pp.Stepper(model, "rest")
    >>> stepper.set({"loads.motor.torque": 4.0})
    >>> stepper.advance(0.5)
    >>> round(stepper.value("speed[rotor]"), 12)
    1.0
    """

    def __init__(
        self, model: Model, scenario: str, *, inputs: Sequence[str] = (), record: bool = True
    ) -> None:
        check_scenario(model, scenario)
        check_list("inputs", inputs)
        system = compile_model(model, scenario)
        chosen = scenario_of(system, None)
        if chosen.method not in FIXED_METHODS:
            where, limit = f"scenarios.{scenario}.method", " | ".join(FIXED_METHODS)
            remedy = f"use {instead_of(chosen.method)}"
            text = "has variable steps" if chosen.method in ERROR_METHODS else "is not for co-simulation"
            raise ModelError([Message(where, text, chosen.method, limit, remedy)])
        kept = np.array(chosen_channels(system, chosen.channels), np.int64) if record else None
        self._record = _Record(kept)
        everywhere = without_long_steps(system, chosen, "a Stepper")
        self._loop = Loop(started(system, chosen), everywhere, self._record)
        self._end_with(self._loop.sampler)
        self._system = self._loop.system
        try:
            self._inputs = StepperInputs(self._system, self._more_places(model, scenario, inputs))
        except ModelError:
            self.close()
            raise
        self._arrays = arrays_of(self._system)
        self._jumped, self._stale, self._failure = False, False, ""
        channels = self._system.layout.channels
        self._index = {c.name: k for k, c in enumerate(channels)}
        self.units = self._inputs.units | {c.name: c.unit for c in channels}
        self._loop.begin()
        sampler = self._loop.sampler
        if sampler is not None and sampler.status != OK:
            self.close()
            raise SolverError(self._loop.sentence(sampler.status), sampler.status)

    def _more_places(self, model: Model, scenario: str, paths: Sequence[str]) -> Sequence[Place]:
        """Inputs that are numbers of the model."""
        if not paths:
            return ()
        return tunable_places(model, scenario, export_run(compile_model(model, scenario)), paths)

    @property
    def t(self) -> float:
        """Time reached [s]."""
        return float(self._loop.run_.t)

    @property
    def inputs(self) -> dict[str, float]:
        """Present value of each input."""
        return dict(self._inputs.values)

    @property
    def events(self) -> list[tuple[float, str, int]]:
        """Events that the scenario requests: time [s], name, direction."""
        names = [event.name for event in self._system.layout.events]
        return [(float(t), names[int(k)], int(way)) for part in self._loop.events for t, k, way in part]

    def set(self, values: Mapping[str, float]) -> None:
        """Set inputs, which then are constant until they are set again.

        Parameters
        ----------
        values
            Values by name of the input, in the units of `units`.

        Raises
        ------
        ModelError
            If a name is not an input, or a value is not finite or out of range; then none is set.
        """
        if self._inputs.set(values):
            self._jumped = self._stale = True

    def advance(self, step: float) -> None:
        """Advance by a communication step.

        Parameters
        ----------
        step
            Communication step [s], > 0. It is divided into equal time steps of at most that of the scenario.

        Raises
        ------
        ModelError
            If the step is impossible.
        SolverError
            If the run fails; it has the status, a sentence and the `dataset` up to the last communication
            point. Then restore a saved state.
        """
        loop = self._loop
        n = self._division(step)
        if self._inputs.lead(self.t, step) or self._jumped:
            self._jumped, status = False, self._restart()
            if status != OK:
                self._fail(status)
        run, events = loop.run_, loop.watch.room
        while n:
            take = max(1, n - 1)
            if loop.sampler is not None:
                take = min(take, loop.sampler.steps(run.t, run.h))
            status = loop.take(run.advance(take, every=int(n == 1), events=events, **loop.more), None)
            if status != OK:
                self._fail(status)
            n -= take
        self._stale = False

    def _division(self, step: float) -> int:
        """Number of time steps of a communication step; changes the time step if necessary."""
        loop, run = self._loop, self._loop.run_
        if self.closed:
            raise SolverError("the stepper is closed: its controllers have ended", NOT_FINITE)
        if self._failure:
            raise SolverError(f"the run has failed before ({self._failure}): restore a state", NOT_FINITE)
        problem = number_problem("communication step", step, "s")
        if problem is not None:
            raise ModelError([problem])
        shown = f"{step:.9g} s"
        if not (step > 0.0 and step / loop.h < MOST):
            limit = f"> 0, < {MOST * loop.h:.3g} s"
            raise ModelError([Message("communication step", "is out of range", shown, limit)])
        end = loop.t_end - run.t
        if self._inputs.ends and step > end + SAME * step + 1e-12 * abs(loop.t_end):
            text = "is longer than the rest of the scenario, for which its drives are defined"
            message = Message("communication step", text, shown, f"{end:.9g} s", "increase its duration")
            raise ModelError([message])
        n = int(step / loop.h * (1.0 - SAME)) + 1
        h = step / n
        if abs(h - run.h) > SAME * h:
            if loop.sampler is not None:
                text, limit = "is not a multiple of the time step", f"multiples of {loop.h:.9g} s"
                remedy = "sampled controllers are called at multiples of it"
                raise ModelError([Message("communication step", text, shown, limit, remedy)])
            run.change_step(h)
        return n

    def _restart(self) -> int:
        """Restart the method after a jump of an input; at the start the run begins with the new values."""
        loop = self._loop
        if loop.steps:
            return begin_anew(loop.run_)
        h, start = loop.run_.h, loop.start
        loop.run_ = start_fixed_steps(self._system, start.state, loop.scenario, h)
        return OK

    def _fail(self, status: int) -> None:
        """Raise the failure of the run with its partial result."""
        self._failure = self._loop.sentence(status)
        raise SolverError(with_time(self._failure, self.t), status, self.dataset())

    def value(self, name: str) -> float:
        """Present value of an output, in the unit of `units`.

        Parameters
        ----------
        name
            Name of the channel, such as "speed[rotor]".

        Raises
        ------
        ModelError
            If there is no such channel.
        """
        if name not in self._index:
            known = did_you_mean(name, self._index)
            raise ModelError([Message(name, "is not an output", remedy=f"{known}see `units` for all names")])
        return float(self._channels()[self._index[name]])

    def outputs(self) -> dict[str, float]:
        """Present values of all channels."""
        return dict(zip(self._index, self._channels().tolist(), strict=True))

    def _channels(self) -> NDArray[np.float64]:
        """Channels at the present state and with the present inputs, shape (no,)."""
        if self._stale:
            evaluate.check(self._system, evaluate.accelerations(self._system, self.t))
            self._record.last = evaluate.observe(self._system, evaluate.store(self._system, self.t))
            self._stale = False
        return self._record.last

    def save(self) -> StepperState:
        """State with all inputs, for `restore`."""
        loop, record = self._loop, self._record
        more = {
            "clock": {k: x for k, x in vars(loop.run_).items() if isinstance(x, int | float)},
            "steps": loop.steps,
            "sampler": None if loop.sampler is None else loop.sampler.save(),
            "values": dict(self._inputs.values),
            "flags": (self._jumped, self._stale, self._failure),
            "last": record.last.copy(),
            "lengths": (len(record.times), len(loop.events)),
        }
        return StepperState(self.t, id(self), {n: a.copy() for n, a in self._all().items()}, more)

    def _all(self) -> dict[str, NDArray[Any]]:
        """All arrays that a run changes."""
        iteration = getattr(self._loop.run_, "iteration", None)
        if iteration is None:
            return self._arrays
        own = {f"iteration.{k}": a for k, a in enumerate(iteration[1]) if isinstance(a, np.ndarray)}
        return {**self._arrays, **own}

    def restore(self, state: StepperState) -> None:
        """Go back to a saved state: the run continues with the same bits.

        Parameters
        ----------
        state
            From `save` of this stepper.

        Raises
        ------
        ModelError
            If the state is that of another stepper.
        """
        if not isinstance(state, StepperState):
            remedy = "use a state from `save`"
            raise ModelError([Message("state", "is not a saved state", repr(state)[:80], remedy=remedy)])
        if state._owner != id(self):
            raise ModelError([Message("state", "belongs to another stepper", remedy="use its own states")])
        loop, record, more = self._loop, self._record, state._more
        for name, array in self._all().items():
            array[...] = state._arrays[name]
        vars(loop.run_).update(more["clock"])
        loop.steps = more["steps"]
        if loop.sampler is not None:
            loop.sampler.restore(more["sampler"])
        self._inputs.values = dict(more["values"])
        self._jumped, self._stale, self._failure = more["flags"]
        record.last = more["last"].copy()
        points, events = more["lengths"]
        del record.times[points:], record.rows[points:], loop.events[events:]

    def dataset(self) -> xr.Dataset:
        """Channels of the scenario at all communication points so far, over `time` [s], as of `solve_time`.

        Without `record` it has no points.
        """
        from pitchpoint.solvers.dataset import attributes, channel_dataset

        record, channels = self._record, self._record.kept
        width = len(channels) if channels is not None and len(channels) else len(self._index)
        rows = np.array(record.rows).reshape(len(record.times), width)
        attrs = attributes(self._system, self._loop.scenario.method, step=self._loop.h)
        if self._loop.sampler is not None:
            attrs["notes"] = join_notes(self._loop.sampler.notes)
        stored = None if channels is None or not len(channels) else channels.tolist()
        data = channel_dataset(self._system, "time", np.array(record.times), rows, attrs, stored)
        data["time"].attrs = {"units": "s", "long_name": "time"}
        return data
