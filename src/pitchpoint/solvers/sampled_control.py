# SPDX-License-Identifier: Apache-2.0
"""Sampled controllers during a run: called at their sampling instants, between calls of the compiled loop.

Integrators step exactly onto every instant and restart if an output has changed, because forces jump there.
At an instant all inputs are read first; then the outputs without delay, and those whose delay has elapsed,
are written in the order of the controllers. Every run starts with new states and initial values, so runs are
reproducible bit by bit.
"""

from __future__ import annotations

import copy
import math
from contextlib import ExitStack
from fractions import Fraction
from typing import Any

from pitchpoint.core.errors import Message, SolverError, note
from pitchpoint.core.status import CONTROLLER, NOT_FINITE, OK
from pitchpoint.solvers.explicit.derivative import SLOPE_AT
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.implicit.force_jump import continue_after_jump
from pitchpoint.solvers.step_choice import divided
from pitchpoint.system import evaluate, signals
from pitchpoint.system.controller import SampledController
from pitchpoint.system.signals import kind_of_signals
from pitchpoint.system.source import source
from pitchpoint.system.system import State, System
from pitchpoint.system.workspace import VALID

SAME = 1e-9
"""Fraction of a period within which two instants count as equal."""
FINEST = 1e-3
"""Smallest fraction of the chosen step to which the instants may reduce it."""


CHANGING = ("status", "failure", "_calls", "_waiting")
"""Attributes of a sampler that change during a run, besides the states of the controllers."""


class Sampler:
    """The controllers of one run.

    Parameters
    ----------
    system
        System with controllers; its held signals are set to their initial values.
    state
        Start of the run; the controllers are called there for the first time.

    Attributes
    ----------
    status, failure
        Status of the last calls, and a message if a controller failed.
    notes
        Remarks of the controllers at the end of the run.
    """

    def __init__(self, system: System, state: State) -> None:
        self.system, self.t0 = system, state.t
        self.failure = ""
        self.notes: tuple[Message, ...] = ()
        self._calls = [0] * len(system.controllers)
        self._states = [copy.deepcopy(c.state) for c in system.controllers]
        self._waiting: list[tuple[float, str, float]] = []
        signals.reset(system)
        evaluate.prepare(system)
        evaluate.load(system, state)
        self.status, _ = self.update(state.t)

    def close(self) -> None:
        """End the controllers; processes of libraries end too."""
        with ExitStack() as stack:  # an interrupted end does not keep the others
            for controller, state in zip(self.system.controllers, self._states, strict=True):
                stack.callback(self._finish, controller, state)

    def _finish(self, controller: SampledController, state: Any) -> None:
        if controller.finish is not None:
            where = _named(self.system, controller.name)[1]
            self.notes += tuple(note(f"{where} {remark}") for remark in controller.finish(state))

    def next(self) -> float:
        """Time of the next instant [s]."""
        calls = [self._instant(k) for k in range(len(self._calls))]
        return min([*calls, *(t for t, _, _ in self._waiting)])

    def steps(self, t: float, h: float) -> int:
        """Number of time steps h [s] from t to the next instant, at least 1."""
        return max(1, round((self.next() - t) / h))

    def _instant(self, k: int) -> float:
        return self.t0 + self._calls[k] * self.system.controllers[k].period

    def follow(self, run: Any) -> int:
        """Make the updates due at the time of a run, and continue it after the jumps of the forces."""
        if self.next() > run.t + self._room():
            return OK
        self.status, changed = self.update(run.t)
        if not changed:
            return self.status
        if not isinstance(run, generalized_alpha.Run):
            return begin_anew(run)
        forces = self.system.workspace.R
        before = forces.copy()
        status = signals.evaluate_signals(self.system, run.t)
        return status if status != OK else continue_after_jump(run, forces - before)

    def save(self) -> dict[str, Any]:
        """Copy of all that changes from call to call, for `restore`."""
        states = [c.keeping[0](s) for c, s in zip(self.system.controllers, self._states, strict=True)]
        return {"states": states, "own": copy.deepcopy({name: getattr(self, name) for name in CHANGING})}

    def restore(self, saved: dict[str, Any]) -> None:
        """Go back to what `save` has returned."""
        pairs = zip(self.system.controllers, saved["states"], strict=True)
        self._states[:] = [c.keeping[1](s) for c, s in pairs]
        vars(self).update(copy.deepcopy(saved["own"]))

    def _room(self) -> float:
        return SAME * min(c.period for c in self.system.controllers)

    def update(self, t: float) -> tuple[int, bool]:
        """Make the updates due at the state in the workspace; returns the status and if an output changed."""
        system = self.system
        room = self._room()
        status = signals.evaluate_signals(system, t)
        if status != OK:
            return status, False
        due = [k for k in range(len(self._calls)) if self._instant(k) <= t + room]
        read = {k: signals.values(system, system.controllers[k].inputs) for k in due}
        writing = [(name, value) for when, name, value in self._waiting if when <= t + room]
        self._waiting = [w for w in self._waiting if w[0] > t + room]
        for k in due:
            controller = system.controllers[k]
            outputs, self.failure = controller.call(t, read[k], self._states[k])
            if self.failure:
                self.failure = self.failure.replace(*_named(system, controller.name), 1)
                return CONTROLLER, False
            when = self._instant(k) + controller.delay
            self._calls[k] += 1
            for name, value in zip(controller.outputs, outputs, strict=True):
                if controller.delay > 0.0:
                    self._waiting.append((when, name, value))
                else:
                    writing.append((name, value))
        before = signals.values(system, [name for name, _ in writing])
        for name, value in writing:
            signals.hold(system, name, value)
        return OK, any(x != value for x, (_, value) in zip(before, writing, strict=True))

    def common_step(self, h: float, sample_rate: float | None) -> tuple[float, int]:
        """Time step [s], at most h, that hits all instants and samples, and the steps between samples.

        Raises
        ------
        SolverError
            If periods, delays and the sample period have no common divisor of useful size.
        """
        times = [x for c in self.system.controllers for x in (c.period, c.delay) if x > 0.0]
        times += [1.0 / sample_rate] if sample_rate else []
        parts = [Fraction(x).limit_denominator(10**9) for x in times]
        whole = math.lcm(*(p.denominator for p in parts))
        base = math.gcd(*(int(p * whole) for p in parts)) / whole
        step, _ = divided(base, h) if base > 0.0 else (0.0, 0)
        if not step > FINEST * h:
            raise SolverError(
                f"periods and delays of controllers and samples ({', '.join(f'{x:.9g}' for x in times)} s) "
                f"have no common step near {h:.3g} s; choose multiples of one period, or variable steps",
                NOT_FINITE,
            )
        return step, max(1, round(1.0 / (sample_rate * step))) if sample_rate else 1


def _named(system: System, name: str) -> tuple[str, str]:
    """Name of a controller as in its message, and the same with its line in the model file if known."""
    short = f"the controller {name!r}"
    known = system.model is not None and name in system.model.controllers
    return short, source(system, kind_of_signals(system), name) if known else short


def begin_anew(run: Any) -> int:
    """Restart an integration at its present state after a jump of the forces; returns the status."""
    w = run.system.workspace
    if hasattr(run, "go_on"):
        return int(run.go_on())
    status = evaluate.accelerations(run.system, run.t)
    for name, now in (("al", w.a), ("ap", w.a), ("lp", w.lam)):
        w.arrays[name][:] = now
    w.arrays["real"][SLOPE_AT] = math.nan
    w.clock[VALID] = 0
    return status
