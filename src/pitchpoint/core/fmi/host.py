# SPDX-License-Identifier: Apache-2.0
"""Process that runs one functional mock-up unit: `python -m pitchpoint.core.fmi.host FOLDER`.

`fmu_process` starts it with the folder of the unpacked unit. One line of JSON per request and answer. The
process ends with its parent: a thread waits for the end of the requests, also while the unit computes.
"""

from __future__ import annotations

import ctypes
import json
import os
import queue
import shutil
import signal
import sys
import threading
from contextlib import suppress
from typing import Any, BinaryIO

from pitchpoint.core.fmi.fmu_file import INTEGERS

WARNING = 1
"""Highest status of FMI with which a computation continues."""


def main() -> None:
    """Answer requests until they end."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent, which ends this process
    requests, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    empty = os.open(os.devnull, os.O_RDWR)
    for descriptor in (0, 1, 2):  # what the unit prints must not be read as an answer
        os.dup2(empty, descriptor)
    waiting: queue.Queue[bytes] = queue.Queue()
    threading.Thread(target=_listen, args=(requests, waiting), daemon=True).start()
    unit: _Unit | None = None
    while True:
        request = json.loads(waiting.get())
        messages: list[str] = []
        try:
            if unit is None:
                unit = _Unit(request, messages)
            else:
                unit.messages = messages
                unit.answer(request)
            answer: dict[str, Any] = {"values": unit.values()}
        except Exception as error:  # noqa: BLE001 - whatever happens is reported
            answer = {"failed": "; ".join([str(error) or type(error).__name__, *messages[-1:]])}
        answers.write(json.dumps(answer).encode() + b"\n")
        answers.flush()


def _listen(requests: BinaryIO, waiting: queue.Queue[bytes]) -> None:
    """Pass on the requests; at their end the process ends, whatever it is doing, and deletes the files."""
    for line in requests:
        waiting.put(line)
    shutil.rmtree(sys.argv[1], ignore_errors=True)
    os._exit(0)


class _Unit:
    """Instance of a unit in step mode.

    Parameters
    ----------
    request
        Library, version, token and identifier of the unit, start time, and its variables.
    messages
        Receives the messages of the unit.
    """

    def __init__(self, request: dict[str, Any], messages: list[str]) -> None:
        self.messages = messages
        self.version = request["version"]
        self.states: dict[int, Any] = {}
        self.inputs, self.outputs = request["inputs"], request["outputs"]
        names = {"guid": request["token"], "modelIdentifier": request["identifier"], "instanceName": "unit"}
        where = {"unzipDirectory": sys.argv[1], "libraryPath": request["library"]}
        t = request["t"]
        if self.version == 2:
            from fmpy import fmi2

            self.unit: Any = fmi2.FMU2Slave(**names, **where)
            self.callbacks = fmi2.fmi2CallbackFunctions()
            self.callbacks.logger = fmi2.fmi2CallbackLoggerTYPE(self._logged2)
            self.callbacks.allocateMemory = fmi2.fmi2CallbackAllocateMemoryTYPE(fmi2.calloc)
            self.callbacks.freeMemory = fmi2.fmi2CallbackFreeMemoryTYPE(fmi2.free)
            with suppress(ImportError, OSError):  # inserts the arguments of messages
                from fmpy.logging import addLoggerProxy

                addLoggerProxy(ctypes.byref(self.callbacks))
            self.unit.instantiate(callbacks=self.callbacks)
            self.unit.setupExperiment(startTime=t)
            self._set(request["parameters"])
            self.unit.enterInitializationMode()
        else:
            from fmpy import fmi3

            self.unit = fmi3.FMU3Slave(**names, **where)
            self.unit.instantiate(logMessage=self._logged3)
            self._set(request["parameters"])
            self.unit.enterInitializationMode(startTime=t)
        self._set_inputs(request["values"])
        self.unit.exitInitializationMode()

    def _logged2(self, environment: Any, name: Any, status: int, category: Any, text: bytes, *_: Any) -> None:
        if status > WARNING:
            self.messages.append(text.decode(errors="replace"))

    def _logged3(self, environment: Any, status: int, category: Any, text: bytes) -> None:
        if status > WARNING:
            self.messages.append(text.decode(errors="replace"))

    def step(self, request: dict[str, Any]) -> None:
        """Advance by a communication step with the inputs set before, then set new inputs."""
        done = self.unit.doStep(request["t"], request["h"])
        if self.version == 3:
            _, ends, early, reached = done
            if ends:
                raise RuntimeError("it requests the end of the simulation")
            if early:
                raise RuntimeError(f"it has stopped within the step, at {reached:.9g} s")
        self._set_inputs(request["values"])

    def answer(self, request: dict[str, Any]) -> None:
        """Release saved states, then advance, or save or restore a state of a number."""
        word = "FMUstate" if self.version == 2 else "FMUState"
        for number in request["release"]:
            getattr(self.unit, f"free{word}")(self.states.pop(number))
        if "save" in request:
            self.states[request["save"]] = getattr(self.unit, f"get{word}")()
        elif "restore" in request:
            getattr(self.unit, f"set{word}")(self.states[request["restore"]])
        else:
            self.step(request)

    def _set_inputs(self, values: list[float]) -> None:
        self._set([(*variable, value) for variable, value in zip(self.inputs, values, strict=True)])

    def _set(self, given: list[Any]) -> None:
        """Set variables, given as type, value reference and value."""
        for kind, reference, value in given:
            exact = _cast(kind, value)
            getattr(self.unit, f"set{self._method(kind)}")([reference], [exact])

    def _method(self, kind: str) -> str:
        """Type of the functions for a type of variable: enumerations are integers."""
        return {2: "Integer", 3: "Int64"}[self.version] if kind == "Enumeration" else kind

    def values(self) -> list[float]:
        """Present values of the outputs."""
        return [
            float(getattr(self.unit, f"get{self._method(kind)}")([reference])[0])
            for kind, reference in self.outputs
        ]


def _cast(kind: str, value: float) -> Any:
    """Value of a variable from a signal: integers are rounded, and a Boolean is true from 0.5."""
    if kind == "Boolean":
        return value >= 0.5
    return round(value) if kind in INTEGERS else value


if __name__ == "__main__":
    main()
