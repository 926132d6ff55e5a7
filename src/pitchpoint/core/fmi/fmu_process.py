# SPDX-License-Identifier: Apache-2.0
"""Functional mock-up unit in a process of its own, as a function for sampled controllers.

A unit that crashes or hangs ends its own process only. The process ends with the object, with this process,
and at the latest when the pipe to it is closed.
"""

from __future__ import annotations

import json
import queue
import signal
import subprocess
import tempfile
import threading
import weakref
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import IO, Any

from pitchpoint.core.child import python_command, python_environment
from pitchpoint.core.errors import MissingDependencyError, PitchpointError
from pitchpoint.core.fmi.fmu_file import FmuFile, FmuVariable

UNIT = "unit"
"""Key of the process in the state of a controller."""
STARTING = 60.0
"""Wall time for the start of the process and the initialisation, in addition to the limit [s]."""


class FmuError(PitchpointError, RuntimeError):
    """Unit that crashed, hung or reported an error."""


def check_importer() -> None:
    """Raise MissingDependencyError without FMPy."""
    if find_spec("fmpy") is None:
        raise MissingDependencyError(
            "fmpy is required for FMUs of other programs: pip install 'pitchpoint[fmi]'"
        )


@dataclass(frozen=True)
class FmuFunction:
    """Function (t, inputs, state, parameters) of a sampled controller that calls a unit; values in SI units.

    At each call the unit advances to t with the inputs of the last call, then receives the new ones. The
    first call starts the process, whose handle is in `state`.

    Parameters
    ----------
    file
        The unit.
    inputs, outputs
        Its variables in the order of the signals.
    parameters
        Variables that are set before the initialisation, and their values.
    time_limit
        Maximum wall time of a call [s].
    """

    file: FmuFile
    inputs: tuple[FmuVariable, ...]
    outputs: tuple[FmuVariable, ...]
    parameters: tuple[tuple[FmuVariable, float], ...]
    time_limit: float

    def __call__(
        self, t: float, inputs: Sequence[float], state: dict[str, Any], parameters: Any
    ) -> list[float]:
        """Outputs at t."""
        given = [_to_unit(v, float(x)) for v, x in zip(self.inputs, inputs, strict=True)]
        if UNIT not in state:
            state[UNIT] = FmuProcess(self.file, self.time_limit)
            request = {
                "inputs": [(v.type, v.reference) for v in self.inputs],
                "outputs": [(v.type, v.reference) for v in self.outputs],
                "parameters": [(v.type, v.reference, _to_unit(v, x)) for v, x in self.parameters],
                "values": given,
                "t": t,
            }
            found = state[UNIT].begin(request)
        else:
            last = state["t"]
            found = state[UNIT].call({"t": last, "h": t - last, "values": given})
        state["t"] = t
        return [v.factor * x + v.offset for v, x in zip(self.outputs, found, strict=True)]


def _to_unit(variable: FmuVariable, value: float) -> float:
    """Value in the unit of a variable from SI units."""
    return (value - variable.offset) / variable.factor


class FmuProcess:
    """Process of a unit.

    Parameters
    ----------
    file
        The unit.
    time_limit
        Maximum wall time of a call [s].
    """

    def __init__(self, file: FmuFile, time_limit: float) -> None:
        self.file, self.time_limit = file, time_limit
        self._folder = tempfile.TemporaryDirectory(prefix="pitchpoint-fmu-", ignore_cleanup_errors=True)
        file.extract(Path(self._folder.name))
        self._process = subprocess.Popen(
            python_command("-m", "pitchpoint.core.fmi.host", self._folder.name),
            env=python_environment(),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )
        self._saved = 0
        self._forgotten: list[int] = []  # saved states to be released with the next request
        self._answers: queue.Queue[bytes] = queue.Queue()
        threading.Thread(target=_listen, args=(self._process.stdout, self._answers), daemon=True).start()
        self.close = weakref.finalize(self, _end, self._process, self._folder)

    def save(self) -> SavedUnit:
        """Save the state of the unit.

        Raises
        ------
        FmuError
            If the unit cannot do so.
        """
        if not self.file.saves:
            raise FmuError(f"the state of the FMU {Path(self.file.path).name} cannot be saved")
        self._saved += 1
        self.call({"save": self._saved})
        saved = SavedUnit(self, self._saved)
        weakref.finalize(saved, self._forgotten.append, self._saved)
        return saved

    def begin(self, request: dict[str, Any]) -> list[float]:
        """Instantiate and initialise the unit; returns its outputs.

        Parameters
        ----------
        request
            Start time, parameters, inputs and outputs.
        """
        about = {
            "library": str(Path(self._folder.name) / self.file.library),
            "version": self.file.version,
            "token": self.file.token,
            "identifier": self.file.identifier,
        }
        return self.call({**about, **request}, STARTING)

    def call(self, request: dict[str, Any], more_time: float = 0.0) -> list[float]:
        """Send a request and return the outputs.

        Parameters
        ----------
        request
            See `host`.
        more_time
            Wall time in addition to the limit [s].

        Raises
        ------
        FmuError
            If the unit crashes, hangs or reports an error.
        """
        name = Path(self.file.path).name
        pipe = self._process.stdin
        assert pipe is not None
        if not self.close.alive:
            raise FmuError(f"the FMU {name} has ended")
        forgotten = [self._forgotten.pop() for _ in range(len(self._forgotten))]
        try:
            pipe.write(json.dumps({**request, "release": forgotten}).encode() + b"\n")
            pipe.flush()
            answer = self._answers.get(timeout=self.time_limit + more_time)
        except queue.Empty:
            self.close()
            text = f"the FMU {name} has not answered within {self.time_limit + more_time:g} s (time_limit)"
            raise FmuError(text) from None
        except OSError:
            answer = b""
        if not answer:
            self._process.wait()
            code = self._process.returncode
            self.close()
            raise FmuError(f"the FMU {name} has crashed ({_reason(code)})")
        found = json.loads(answer)
        if "failed" in found:
            self.close()
            raise FmuError(f"the FMU {name} has failed: {found['failed']}")
        values: list[float] = found["values"]
        return values


@dataclass(frozen=True, eq=False)
class SavedUnit:
    """State of a unit, kept in its process until this object is deleted.

    Parameters
    ----------
    process
        Process of the unit.
    number
        Number of the state there.
    """

    process: FmuProcess
    number: int

    def restore(self) -> FmuProcess:
        """Set the unit to this state; returns its process."""
        self.process.call({"restore": self.number})
        return self.process


def save(state: Mapping[str, Any]) -> dict[str, Any]:
    """Save the state of a sampled controller that calls a unit, for `restore`.

    Parameters
    ----------
    state
        State of the controller, see `FmuFunction`.
    """
    return {**state, UNIT: state[UNIT].save()} if UNIT in state else {**state}


def restore(saved: Mapping[str, Any]) -> dict[str, Any]:
    """Set a unit to a saved state; returns the state of its controller.

    Parameters
    ----------
    saved
        From `save`.
    """
    return {**saved, UNIT: saved[UNIT].restore()} if UNIT in saved else {**saved}


def finish(state: dict[str, Any]) -> tuple[str, ...]:
    """End the process of a unit and delete its files; there are no remarks.

    Parameters
    ----------
    state
        State of the controller, see `FmuFunction`.
    """
    process = state.pop(UNIT, None)
    if process is not None:
        process.close()
    return ()


def _listen(answers: IO[bytes], waiting: queue.Queue[bytes]) -> None:
    """Pass on the answers; an empty one at their end."""
    for line in answers:
        waiting.put(line)
    waiting.put(b"")


def _end(process: subprocess.Popen[bytes], folder: tempfile.TemporaryDirectory[str]) -> None:
    """End the process and delete its files."""
    process.kill()
    process.wait()
    for pipe in (process.stdin, process.stdout):
        if pipe is not None:
            with suppress(OSError):  # a request that was not sent
                pipe.close()
    folder.cleanup()


def _reason(code: int) -> str:
    """Words for an exit code.

    Examples
    --------
    >>> _reason(-11), _reason(3)
    ('SIGSEGV', 'exit code 3')
    """
    if code < 0:
        try:
            return signal.Signals(-code).name
        except ValueError:
            return f"signal {-code}"
    return f"exit code {code}"
