# SPDX-License-Identifier: Apache-2.0
"""The second process that compiles may fail, but nothing may wait for it for ever."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap

from pitchpoint.core import notices
from pitchpoint.core.compiler import machine_code, second_process


def test_an_entry_that_nobody_was_asked_for_is_not_waited_for():
    second_process.await_entry("somewhere:entry")


def test_a_failing_second_process_does_no_harm(monkeypatch):
    monkeypatch.setattr(second_process, "cores", lambda: 2)
    second_process.delegate(["pitchpoint.no_such_module:entry", "pitchpoint.neither:entry"])
    second_process.await_entry("pitchpoint.neither:entry")
    assert not second_process._pending


def test_the_first_start_is_explained_once(monkeypatch):
    heard = []
    monkeypatch.setattr(notices, "_listeners", [])
    notices.listen(heard.append)
    monkeypatch.setattr(second_process, "_yardstick", lambda: 0.04)
    second_process.announce(7)
    second_process.announce(7)
    second_process.announce(1)
    assert heard == [
        "compiling 7 kernels for this machine: about 25 s, once",
        "compiling 1 kernel for this machine: about 5 s, once",
    ]


def entry(a: int) -> int:
    """Something that has sources."""
    return a


def test_killed_processes_leave_no_drafts(tmp_path, monkeypatch):
    """Of the second process at once, of others an hour later."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    code = """
        import os, pathlib, signal
        from pitchpoint.core.compiler import machine_code
        from tests.unit.core.test_second_process import entry
        pathlib.Path.write_bytes = lambda *_: os.kill(os.getpid(), signal.SIGKILL)
        machine_code.save(entry, b"code", [])
    """
    killed = subprocess.Popen([sys.executable, "-c", textwrap.dedent(code)])
    assert killed.wait() != 0
    folder = machine_code._folder()
    (left,) = folder.iterdir()
    machine_code.save(entry, b"code", [])
    assert left.is_dir()
    os.utime(left, (0.0, 0.0))
    machine_code.save(entry, b"code", [])
    assert [f.suffix for f in folder.iterdir()] == [".code"]
    draft = folder / left.name
    draft.mkdir()
    machine_code.clear_drafts(killed.pid)
    assert not draft.exists()


def test_a_killed_second_process_leaves_no_drafts(tmp_path, monkeypatch):
    monkeypatch.setattr(second_process, "cores", lambda: 2)
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    second_process.delegate(["pitchpoint.no_such_module:entry"])
    (process,) = second_process._pending.values()
    draft = machine_code._folder() / f"draft-{process.pid}-x"
    draft.mkdir(parents=True)
    (draft / "half.code").touch()
    second_process.await_entry("pitchpoint.no_such_module:entry")
    assert not draft.exists()
