# SPDX-License-Identifier: Apache-2.0
"""Exit code of a command that a signal ends, wherever the signal arrives."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")

BEGIN = """\
import os, signal, sys, time
signal.signal(signal.SIGINT, signal.SIG_IGN)  # as for a job in the background of a shell
from pitchpoint.cli.interrupt import code_of_interruption, end_at_the_second_interrupt, run_to_its_code
end_at_the_second_interrupt()

def wait():
    end = time.monotonic() + 20.0
    while time.monotonic() < end:
        time.sleep(0.01)

def handled(stop):
    try:
        stop()
    except KeyboardInterrupt:
        return code_of_interruption()
    return 0
"""
LOST = """\
class Last:
    def __del__(self):
        os.kill(os.getpid(), signal.SIGTERM)
        wait()

def stop():
    Last()
    wait()

sys.exit(run_to_its_code(lambda: handled(stop)))
"""
IN_TEXT = """\
def stop():
    exec("os.kill(os.getpid(), signal.SIGTERM); wait()", globals())

sys.exit(run_to_its_code(lambda: handled(stop)))
"""
IN_CLASS = """\
from pitchpoint.cli.failure import exit_code_of

class Field:
    def __set_name__(self, owner, name):
        os.kill(os.getpid(), signal.SIGTERM)
        wait()

def command():
    try:
        type("Owner", (), {"field": Field()})
    except BaseException as error:
        return exit_code_of(error)

sys.exit(run_to_its_code(command))
"""
OUTSIDE = """\
def command():
    os.kill(os.getpid(), signal.SIGTERM)
    wait()

sys.exit(run_to_its_code(command))
"""
LATE = """\
code = run_to_its_code(lambda: 3)
os.kill(os.getpid(), signal.SIGTERM)
time.sleep(0.05)
sys.exit(code)
"""


@pytest.mark.parametrize(
    ("text", "code"),
    [(LOST, 143), (IN_TEXT, 143), (IN_CLASS, 143), (OUTSIDE, 143), (LATE, 3)],
    ids=["where exceptions are discarded", "in a text", "in a class", "outside the command", "at its end"],
)
def test_the_exit_code_after_sigterm(text: str, code: int, tmp_path: Path) -> None:
    (tmp_path / "command.py").write_text(BEGIN + text)
    done = subprocess.run([sys.executable, "-m", "command"], cwd=tmp_path, timeout=60.0, check=False)
    assert done.returncode == code
