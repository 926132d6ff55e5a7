# SPDX-License-Identifier: Apache-2.0
"""A controller library with the interface of Bladed, in a process of its own.

Such libraries keep their state in global variables, and may crash or never return. Each controller therefore
has its own process, which is ended if a call takes too long, when the controller is closed, and when this
process ends for any reason.
"""

from __future__ import annotations

import math
import os
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import weakref
from collections.abc import Sequence
from pathlib import Path
from typing import IO, Any, Self

import numpy as np

from pitchpoint.core.child import end_with_children
from pitchpoint.core.discon import host
from pitchpoint.core.discon.records import (
    BY_NAME,
    LOG_SIZE,
    MESSAGE_SIZE,
    SET,
    SIZE,
    TABLE_START,
    find_record,
)
from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.nearest import did_you_mean

LOG_NAMES_SIZE = LOG_SIZE * 32 + 1
FIRST, NEXT, LAST = 0.0, 1.0, -1.0
"""Status of a call."""
OVERRIDES = ("pitch_override", "torque_override")


class ControllerError(Exception):
    """A controller failed; the text continues a sentence that begins with the controller."""


class Discon:
    """Controller library, called with its swap record.

    Parameters
    ----------
    library
        Shared library, for this system and processor.
    infile
        Input file of the controller; its folder is the working directory of the library.
    outname
        Name from which the library makes the names of its output files; ROSCO replaces what follows the
        last point.
    procedure
        Name of the procedure in the library.
    blades
        Number of blades.
    interval
        Sample time [s].
    timeout
        Longest time of a call [s of wall clock]; then the process is ended.
    torque_table
        Points (generator speed [rad/s], torque [N m]) of a table below rated.

    Attributes
    ----------
    record
        Swap record, float32, shape (3300,); record N is `record[N - 1]`. `controller["generator_speed"]` is
        the same by name, `controller[20]` by number.
    messages
        Warnings of the library (positive flag), each once.

    Raises
    ------
    ControllerError
        If the library cannot be loaded; from `call` and `close` also if it crashes, takes too long, or
        reports a failure.

    Examples
    --------
    One call of a library, and the last one at the end of the block::

        with Discon("libdiscon.so", "DISCON.IN", interval=0.01) as controller:
            controller["generator_speed"] = 122.9
            controller.call(0.0)
            torque = controller["generator_torque_demand"]
    """

    def __init__(
        self,
        library: str | Path,
        infile: str | Path = "",
        *,
        outname: str = "discon.out",
        procedure: str = "DISCON",
        blades: int = 3,
        interval: float = 0.01,
        timeout: float = 30.0,
        torque_table: Sequence[tuple[float, float]] = (),
    ) -> None:
        self.record = np.zeros(SIZE, np.float32)
        self.messages: list[str] = []
        self.timeout = timeout
        self._library = Path(library).resolve()
        given = Path(infile).resolve() if str(infile) else None
        name = given.name if given is not None else ""
        self._set(interval, blades, len(name.encode()), len(outname.encode()))
        self._torque_table(torque_table)
        self._printed: IO[bytes] = tempfile.TemporaryFile()  # noqa: SIM115 - closed with the process
        sizes = (SIZE * 4, MESSAGE_SIZE, LOG_NAMES_SIZE)
        self._process = subprocess.Popen(
            [sys.executable, "-I", "-S", host.__file__, str(self._library), procedure, name, outname]
            + [str(size) for size in sizes],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._printed,
            cwd=(given or self._library).parent,
            start_new_session=True,  # the library may start processes, which end with it
        )
        self._watch = _Watch(self._process, timeout)
        self._end = weakref.finalize(self, _end, self._process, self._printed, self._watch)
        flag, text, _ = self._exchange(None)
        if flag == host.NO_PROCEDURE:
            self._end()
            raise ControllerError(f"has no procedure {procedure} in its library '{self._library.name}'")
        if flag != host.LOADED:
            self._end()
            raise ControllerError(f"cannot load its library '{self._library.name}': {text}")

    def _set(self, interval: float, blades: int, infile: int, outname: int) -> None:
        """Fill the records of the interface; the lengths include the end of the text."""
        for name, value in {
            "interval": interval,
            "generator_contactor": 1,
            "message_size": MESSAGE_SIZE,
            "infile_size": infile + 1,
            "outname_size": outname + 1,
            "blades": blades,
            "log_size": LOG_SIZE,
            "log_start": TABLE_START,
            "log_names_size": LOG_NAMES_SIZE,
            "platform_start": 1001,
            "size": SIZE,
            "extension": 1,
        }.items():
            self._write(name, value)

    def _torque_table(self, points: Sequence[tuple[float, float]]) -> None:
        if not points:
            return
        self._write("torque_table_start", TABLE_START)
        self._write("torque_table_points", len(points))
        self._write("log_start", TABLE_START + 2 * len(points))
        self.record[TABLE_START - 1 : TABLE_START - 1 + 2 * len(points)] = np.ravel(points)

    def _write(self, name: str, value: float) -> None:
        self.record[_number(name) - 1] = value

    def __getitem__(self, name: str | int) -> float:
        """Value of a record, by name or number."""
        return float(self.record[_number(name) - 1])

    def __setitem__(self, name: str | int, value: float) -> None:
        """Set a record, by name or number."""
        record = find_record(name)
        if record is not None and record.direction == SET and record.name in OWN:
            raise KeyError(f"record {record.number} ({record.name}) is set by the interface")
        self.record[_number(name) - 1] = value

    def call(self, t: float) -> None:
        """Call the controller at a time [s]; the first call has the status 0, all others 1.

        Parameters
        ----------
        t
            Time [s].
        """
        status = FIRST if self._first else NEXT
        self._write("time", t)
        self._write("present_pitch_demand", self._pitch_demand())
        self._write("present_pitch_rate_demand", self["pitch_rate_demand"])
        self._call(status)
        self._first = False
        for name in OVERRIDES:
            if self[name] != 0.0:
                raise ControllerError(
                    f"requests the {name.replace('_', ' ')} (record {_number(name)}), which does not exist"
                )

    _first = True

    def _pitch_demand(self) -> float:
        return self["blade_1_pitch_demand" if self["pitch_control"] else "pitch_demand"]

    def close(self) -> None:
        """Make the last call, with the status -1, and end the process."""
        if not self._end.alive:
            return
        try:
            if not self._first:
                self._call(LAST)
            if self._process.stdin is not None:
                self._process.stdin.write(host.END)
                self._process.stdin.flush()
            self._process.wait(self.timeout)
        except (OSError, subprocess.TimeoutExpired):
            pass
        finally:
            self._end()

    def __deepcopy__(self, memo: Any) -> Self:
        raise PitchpointError(f"the state of the controller library {self._library.name} cannot be saved")

    def __enter__(self) -> Self:
        """Return the controller."""
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        """Close the controller, without the last call after an error."""
        if kind is None:
            self.close()
        else:
            self._end()

    def _call(self, status: float) -> None:
        self._write("simulation_status", status)
        flag, text, answer = self._exchange(host.CALL + self.record.tobytes())
        self.record[:] = np.frombuffer(answer, np.float32)
        if flag < 0:
            self._end()
            raise ControllerError(f"reports a failure ({flag}): {text or 'no message'}")
        if flag > 0 and text and text not in self.messages:
            self.messages.append(text)

    def _exchange(self, request: bytes | None) -> tuple[int, str, bytes]:
        """Send a request and wait for its answer: flag, message, swap record."""
        process = self._process
        if not self._end.alive:
            raise ControllerError("is closed")
        answer, in_time = None, True
        self._watch.begin()
        try:
            assert process.stdin is not None and process.stdout is not None
            if request is not None:
                process.stdin.write(request)
                process.stdin.flush()
            head = process.stdout.read(host.HEAD.size)
            flag, length = host.HEAD.unpack(head)
            size = length if request is None else length + SIZE * 4
            rest = process.stdout.read(size)
            if len(rest) == size:
                answer = flag, rest[:length].decode("utf-8", "replace").strip(), rest[length:]
        except (OSError, struct.error):
            pass
        except BaseException:  # an interrupted call has no answer, and the next one would read it
            self._end()
            raise
        finally:
            in_time = self._watch.end()
        if answer is not None and in_time:
            return answer
        try:
            status = process.wait(self.timeout)
        except subprocess.TimeoutExpired:  # the library has closed the pipe and still runs
            process.kill()
            status = process.wait()
        printed = self._last_line()
        self._end()
        if not in_time:
            raise ControllerError(f"did not return within {self.timeout:g} s; its process was ended{printed}")
        raise ControllerError(f"{_how_it_ended(status)}{printed}")

    def _last_line(self) -> str:
        """The last line that the library has printed."""
        size = self._printed.seek(0, os.SEEK_END)
        self._printed.seek(max(0, size - 2000))
        lines = self._printed.read().decode("utf-8", "replace").split("\n")
        last = next((line.strip() for line in reversed(lines) if line.strip()), "")
        return f"; it printed: {last[:200]}" if last else ""


class _Watch:
    """Ends a process whose call takes too long, in a thread that waits for all calls."""

    def __init__(self, process: subprocess.Popen[bytes], limit: float) -> None:
        self._process, self._limit = process, limit
        self._begun, self._expired = math.inf, False
        self._lock, self._closed = threading.Lock(), threading.Event()
        threading.Thread(target=self._run, daemon=True).start()

    def begin(self) -> None:
        """A call begins."""
        with self._lock:
            self._begun = time.monotonic()

    def end(self) -> bool:
        """The call has ended; returns whether it was in time. If not, its process has been ended."""
        with self._lock:
            self._begun = math.inf
            return not self._expired

    def close(self) -> None:
        """End the thread."""
        self._closed.set()

    def _run(self) -> None:
        left = self._limit
        while not self._closed.wait(min(left, self._limit, threading.TIMEOUT_MAX)):
            with self._lock:
                left = self._begun + self._limit - time.monotonic()
                if left <= 0.0:
                    self._expired = True
                    end_with_children(self._process)
                    return


OWN = frozenset(
    (
        "simulation_status",
        "time",
        "interval",
        "present_pitch_demand",
        "present_pitch_rate_demand",
        "torque_table_start",
        "torque_table_points",
        "message_size",
        "infile_size",
        "outname_size",
        "blades",
        "log_size",
        "log_start",
        "log_names_size",
        "size",
    )
)
"""Records that `Discon` sets itself."""


def _number(name: str | int) -> int:
    record = find_record(name)
    if record is None:
        raise KeyError(f"no record {name!r}; {did_you_mean(str(name), BY_NAME)}numbers are 1 to {SIZE}")
    return record.number


def _how_it_ended(status: int) -> str:
    if status < 0:
        try:
            name = signal.Signals(-status).name
        except ValueError:
            name = f"signal {-status}"
        return f"crashed in its library ({name})"
    return f"ended its process with the status {status}" + (" (a crash)" if status > 255 else "")


def _end(process: subprocess.Popen[bytes], printed: IO[bytes], watch: _Watch) -> None:
    """End the process, if it still runs, with its children, and close the pipes."""
    watch.close()
    end_with_children(process)
    process.wait()
    for pipe in (process.stdin, process.stdout):
        if pipe is not None and not pipe.closed:
            try:
                pipe.close()
            except OSError:  # an unsent request of a process that has ended
                continue
    printed.close()
