# SPDX-License-Identifier: Apache-2.0
"""Controller libraries of wind turbines: swap record, states, failures, processes that end."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

from pitchpoint.core.discon.process import OWN, ControllerError, Discon, _Watch
from pitchpoint.core.discon.records import RECORDS, SIZE, find_record
from tests.support.discon_library import discon_library, input_file, processes_of_controllers


def opened(tmp_path, what, **more):
    return Discon(discon_library(), input_file(tmp_path, what), **{"interval": 0.0125, **more})


def test_every_record_arrives_and_returns(tmp_path):
    own = {find_record(name).number for name in OWN}
    with opened(tmp_path, "all", outname="turbine one", blades=2) as controller:
        given = {n: 0.5 * n - 700.0 for n in range(1, SIZE + 1) if n not in own}
        for n, value in given.items():
            controller[n] = value
        controller.call(3.25)
        seen = np.fromfile(tmp_path / "turbine one.bin", np.float32)
        assert seen.shape == (SIZE,)
        for n, value in given.items():
            assert seen[n - 1] == np.float32(value), find_record(n)
        interface = {1: 0, 2: 3.25, 3: 0.0125, 11: given[42], 12: given[46], 25: 0, 26: 0, 49: 1025, 50: 7}
        interface |= {51: 12, 61: 2, 62: 300, 63: 145, 64: 9601, 129: SIZE}
        assert set(interface) == own
        for n, value in interface.items():
            assert seen[n - 1] == np.float32(value), find_record(n)
        assert (tmp_path / "texts").read_text() == "all.in|turbine one"
        for record in RECORDS:
            wanted = 0.0 if record.name in ("pitch_override", "torque_override") else 4999.0 + record.number
            assert controller[record.name] == controller[record.number] == wanted
        controller.call(3.2625)
    later = np.fromfile(tmp_path / "next.bin", np.float32).reshape(-1, SIZE)
    assert later[:, 0].tolist() == [1.0, -1.0]  # all other calls, and the last one
    # demands are kept for the next call; without individual control the present demand is the collective one
    assert later[0, 1] == np.float32(3.2625)
    assert later[0, 10] == 5041.0
    assert not processes_of_controllers()


def test_torque_table_and_start_of_the_log(tmp_path):
    points = ((70.0, 600.0), (90.0, 14000.0), (122.0, 40000.0))
    with opened(tmp_path, "all", torque_table=points) as controller:
        controller.call(0.0)
    seen = np.fromfile(tmp_path / "discon.out.bin", np.float32)
    assert seen[[24, 25, 62]].tolist() == [145.0, 3.0, 151.0]
    assert seen[144:150].reshape(3, 2).tolist() == [list(point) for point in points]


def test_numbers_and_names_are_unique():
    assert len({r.number for r in RECORDS}) == len({r.name for r in RECORDS}) == len(RECORDS)
    assert [r.number for r in RECORDS] == sorted(r.number for r in RECORDS)
    with pytest.raises(KeyError, match="did you mean generator_speed"):
        Discon.__getitem__(_Bare(), "generator_sped")
    with pytest.raises(KeyError, match="is set by the interface"):
        Discon.__setitem__(_Bare(), "time", 1.0)


class _Bare:
    record = np.zeros(SIZE, np.float32)


def test_controllers_do_not_share_their_state(tmp_path):
    with opened(tmp_path, "count") as one, opened(tmp_path, "count") as other:
        for k in range(5):
            one.call(0.1 * k)
        other["generator_speed"] = 8.0
        other.call(0.0)
        assert (one[47], other[47], other["pitch_demand"]) == (5.0, 1.0, 2.0)
        assert len(processes_of_controllers()) == 2
    assert not processes_of_controllers()


@pytest.mark.parametrize(
    ("what", "words"),
    [
        ("crash", r"crashed in its library \(SIGSEGV\); it printed: last words"),
        ("hang", r"did not return within 0\.5 s; its process was ended"),
        ("exit", "ended its process with the status 3"),
        ("fail", r"reports a failure \(-1\): the table of gains is empty"),
        ("override", r"requests the pitch override \(record 55\), which does not exist"),
    ],
)
def test_failures_are_sentences_and_leave_no_process(tmp_path, what, words):
    limit = 0.5 if what == "hang" else 60.0
    with pytest.raises(ControllerError, match=words), opened(tmp_path, what, timeout=limit) as controller:
        controller.call(0.0)
    assert not processes_of_controllers()
    with pytest.raises(ControllerError, match="is closed"):
        controller.call(0.1)
    controller.close()  # twice is permitted


def test_the_time_limit_counts_from_the_begin_of_a_call():
    """Calls begin at any time between two looks of the thread; what ends in time is never ended later."""
    process = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    watch = _Watch(process, 0.4)
    for rest in (0.0, 0.25, 0.1):
        watch.begin()
        time.sleep(0.3 - rest)
        assert watch.end()
        time.sleep(rest)
    time.sleep(0.5)
    assert process.poll() is None
    begun = time.monotonic()
    watch.begin()
    process.wait(30.0)
    assert 0.4 <= time.monotonic() - begun and not watch.end()
    watch.close()
    process.communicate()


def test_an_answer_that_arrives_at_the_time_limit(tmp_path):
    """The answer is complete, but the process was ended: this call fails, and not the next one."""
    controller = opened(tmp_path, "count", timeout=60.0)
    controller.call(0.0)
    watch, end = controller._watch, controller._watch.end

    def late():
        """As if the thread had been faster than the end of the call."""
        controller._process.kill()
        watch._expired = True
        return end()

    watch.end = late
    with pytest.raises(ControllerError, match=r"did not return within 60 s; its process was ended"):
        controller.call(0.1)
    assert not processes_of_controllers()


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_an_interrupted_call_ends_the_process(tmp_path):
    controller = opened(tmp_path, "hang")
    threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        controller.call(0.0)
    assert not processes_of_controllers()
    with pytest.raises(ControllerError, match="is closed"):  # and does not read the answer to the first call
        controller.call(0.1)
    controller.close()


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_signals_to_all_processes_of_a_terminal_leave_the_last_call_possible(tmp_path):
    with opened(tmp_path, "count") as controller:
        controller.call(0.0)
        for line in processes_of_controllers():
            for one in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                os.kill(int(line.split()[0]), one)
        controller.call(0.1)
        assert controller[47] == 2.0


def test_warnings_are_kept_once_and_the_last_call_may_fail(tmp_path):
    with opened(tmp_path, "warn") as controller:
        controller.call(0.0)
        controller.call(0.1)
        assert controller.messages == ["speed above the table"]
    controller = opened(tmp_path, "last")
    controller.call(0.0)
    with pytest.raises(ControllerError, match=r"failure \(-2\): cannot write the log"):
        controller.close()
    assert not processes_of_controllers()


def test_libraries_that_cannot_be_loaded(tmp_path):
    with pytest.raises(ControllerError, match="has no procedure discon in its library 'libprobe.so'"):
        Discon(discon_library(), procedure="discon")
    other = tmp_path / "libother.so"
    other.write_bytes(b"no library")
    with pytest.raises(ControllerError, match="cannot load its library 'libother.so': "):
        Discon(other)
    assert not processes_of_controllers()


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="signals of POSIX")
def test_the_process_ends_with_its_caller(tmp_path):
    text = (
        "import sys, threading; from pitchpoint.core.discon.process import Discon\n"
        "c = Discon(sys.argv[1], sys.argv[2]); print('begun', flush=True); c.call(0.0)"
    )
    arguments = [sys.executable, "-c", text, discon_library(), input_file(tmp_path, "hang")]
    caller = subprocess.Popen(arguments, stdout=subprocess.PIPE)
    assert caller.stdout.readline() == b"begun\n"
    assert len(processes_of_controllers()) == 1
    os.kill(caller.pid, signal.SIGKILL)
    caller.communicate()
    until = time.monotonic() + 10.0
    while processes_of_controllers() and time.monotonic() < until:
        time.sleep(0.05)
    assert not processes_of_controllers()
