# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C that Python acts upon at the edge of a callback, where no exception can pass."""

from __future__ import annotations

import ctypes
import signal
import subprocess
import sys
import time

import pytest

from pitchpoint.core import kernel

CALLBACK = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double, ctypes.c_double, ctypes.c_void_p)

LOST = """\
import signal, sys, time
from pitchpoint.cli.interrupt import end_at_the_second_interrupt

class Closing:
    def __del__(self):
        signal.raise_signal(signal.SIGINT)

end_at_the_second_interrupt()
try:
    Closing()
    print("lost", flush=True)
    for _ in range(3000):
        time.sleep(0.01)
except KeyboardInterrupt:
    print("heard")
"""

IN_LAPACK = """\
import numpy
from pitchpoint.cli.interrupt import end_at_the_second_interrupt

end_at_the_second_interrupt()
matrix = numpy.random.default_rng(1).normal(size=(4000, 4000))
print("begins", flush=True)
numpy.linalg.eig(matrix)
"""


@pytest.mark.skipif(not kernel.COMPILING, reason="callbacks of compiled code")
@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_a_ctrl_c_that_waits_when_a_plain_law_begins_is_not_lost():
    """The signal comes in compiled code, which calls the law next: its first instruction raises."""
    from numba import cfunc

    strike = getattr(ctypes.CDLL(None), "raise")
    strike.argtypes, strike.restype = (ctypes.c_int,), ctypes.c_int
    called = []

    def law(t, x, p):
        """A law that the compiler does not take."""
        called.append({}.get(t, t))
        return 1.0

    callback = CALLBACK(kernel.law_address(law))
    number = int(signal.SIGINT)

    @cfunc("int64(int64, int64, int64)")
    def entry(ctl, records, n):
        if n:
            strike(number)
        return int(callback(0.5, 0.0, 0))

    assert kernel.invoke_address(entry.address, 0, 0, 0) == 1 and called == [0.5]
    with pytest.raises(KeyboardInterrupt):
        kernel.invoke_address(entry.address, 0, 0, 1)
    assert called == [0.5], "the law had not begun"
    assert kernel.invoke_address(entry.address, 0, 0, 0) == 1 and called == [0.5, 0.5]


def test_a_ctrl_c_that_is_lost_in_a_destructor_is_sent_again_and_is_no_second_one():
    """With the ordinary hook the program would go on to its end."""
    child = subprocess.run(
        [sys.executable, "-c", LOST], capture_output=True, text=True, timeout=60, check=False
    )
    assert child.stdout.split() == ["lost", "heard"] and child.returncode == 0
    assert child.stderr == ""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_the_second_ctrl_c_ends_a_decomposition_at_once():
    """LAPACK returns after a minute and the first Ctrl-C acts then; a line on stderr says so."""
    with subprocess.Popen(
        [sys.executable, "-c", IN_LAPACK], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as child:
        assert child.stdout and child.stderr and child.stdout.readline() == "begins\n"
        time.sleep(0.5)  # LAPACK has begun
        child.send_signal(signal.SIGINT)
        assert "press Ctrl-C again" in child.stderr.readline()
        child.send_signal(signal.SIGINT)
        assert child.wait(timeout=10) == 130
