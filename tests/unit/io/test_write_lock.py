# SPDX-License-Identifier: Apache-2.0
"""Two processes and one result file: what one writes the other never cuts; an old file may be replaced."""

from __future__ import annotations

import contextlib
import errno
import os
import stat
import subprocess
import sys
import textwrap
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import NoReturn

import h5py
import numpy as np
import pytest

from pitchpoint.core.errors import PitchpointError
from pitchpoint.io import write_lock
from pitchpoint.io.container import Container, Header, ResultError
from pitchpoint.io.reading import open_result, read_channel, read_header
from pitchpoint.io.target import OutputError, check_target
from pitchpoint.io.writing import Channel, ResultWriter

pytestmark = pytest.mark.skipif(
    write_lock.fcntl is None or "HDF5_USE_FILE_LOCKING" in os.environ,
    reason="Windows has no advisory locks; with HDF5_USE_FILE_LOCKING those of HDF5 are not the usual ones",
)

CHANNEL = Channel("mesh_force[stage]", "N")
HELD = r"h5: cannot be written \(another process holds it\); wait until it is closed, or name another file$"

#: Ends when its stdin is closed; says "up" as soon as the file is open, or what kept it from that.
CHILD = """
    import sys
    import h5py
    import numpy as np
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.io.container import Container, Header
    from pitchpoint.io.writing import Channel, ResultWriter

    path, manner = sys.argv[1:]
    if manner == "race":
        print("ready", flush=True)
        sys.stdin.readline()
    try:
        if manner == "foreign":
            held = h5py.File(path, "w")
            held["x"] = np.arange(10000)
            held.flush()
        elif manner == "beginning":
            held = Container(path, Header("time"))
            held.dimension("point", [0, 1, 2])
        else:
            held = ResultWriter(path, Header("time"), [Channel("mesh_force[stage]", "N")], block=100)
            held.append(np.arange(1000.0), np.arange(1000.0)[:, None])
        print("up", flush=True)
    except PitchpointError as error:
        print(error, flush=True)
        sys.exit()
    sys.stdin.readline()
    held.close() if manner == "foreign" else held.finish()
"""


@contextlib.contextmanager
def another(path: Path, manner: str = "running") -> Iterator[subprocess.Popen[str]]:
    """Run a process that has the file open for writing in a certain manner, until it is told to end."""
    command = [sys.executable, "-c", textwrap.dedent(CHILD), str(path), manner]
    child = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert child.stdout is not None
    try:
        assert child.stdout.readline().strip() == ("ready" if manner == "race" else "up")
        yield child
    finally:
        child.communicate()


def finished(path: Path, value: float = 1.0) -> Path:
    """Write a short result that is finished."""
    with ResultWriter(path, Header("time"), [CHANNEL]) as writer:
        writer.append(np.arange(10.0), np.full((10, 1), value))
    return path


def forces(path: Path) -> list[float]:
    """The samples of a result."""
    values: list[float] = read_channel(path, CHANNEL.name)[1].tolist()
    return values


@pytest.mark.parametrize("manner", ["foreign", "beginning", "running"])
def test_what_another_process_writes_is_refused_and_whole(manner: str, tmp_path: Path) -> None:
    path = tmp_path / "r.h5"
    with another(path, manner):
        before = path.read_bytes()
        with pytest.raises(OutputError, match=HELD):
            check_target(path, "result")
        with pytest.raises(PitchpointError, match=HELD):
            Container(path, Header("time"))
        assert path.read_bytes() == before
    if manner == "foreign":
        with h5py.File(path) as file:
            assert file["x"][:].sum() == 49995000
    elif manner == "running":
        assert forces(path) == list(range(1000))
    if manner != "foreign":
        assert read_header(path)["status"] == "finished"


@pytest.mark.parametrize("manner", ["beginning", "running"])
def test_a_killed_run_is_replaced(manner: str, tmp_path: Path) -> None:
    path = tmp_path / "r.h5"
    with another(path, manner) as child:
        child.kill()
        child.wait()
    assert read_header(path)["status"] == "running"
    assert forces(finished(path)) == [1.0] * 10


def test_a_running_file_has_readers(tmp_path: Path) -> None:
    path = tmp_path / "r.h5"
    with another(path), h5py.File(path) as plain, open_result(path) as ds:
        assert plain["time"].shape == (1000,)
        assert ds.sizes["time"] == 1000


def test_hdf5_does_not_lock_what_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It would release its lock and request it again where SWMR begins; a reader in between ended the run."""
    monkeypatch.setattr("pitchpoint.io.container.hold", lambda *_: True)
    container = Container(tmp_path / "r.h5", Header("time"))
    assert not write_lock.is_held(container.path)
    container.begin()
    assert write_lock.is_held(container.path)
    container.finish()


def test_a_writer_waits_for_a_reader_that_comes_before_the_structure(tmp_path: Path) -> None:
    path = tmp_path / "r.h5"
    with path.open("x+b") as file, path.open("rb") as other:
        write_lock.share(other.fileno())
        threading.Timer(0.05, other.close).start()
        assert write_lock.hold(file.fileno(), path)
        path.unlink()
        assert not write_lock.hold(file.fileno(), path)


@pytest.mark.parametrize("old", [False, True])
def test_of_several_that_begin_at_once_one_goes_on(old: bool, tmp_path: Path) -> None:
    path = tmp_path / "r.h5"
    if old:
        finished(path)
    with contextlib.ExitStack() as stack:
        children = [stack.enter_context(another(path, "race")) for _ in range(4)]
        for child in children:
            assert child.stdin is not None
            child.stdin.write("\n")
            child.stdin.flush()
        said = [child.stdout.readline().strip() for child in children if child.stdout is not None]
    assert said.count("up") == 1, said
    assert sum("another process holds it" in words for words in said) == 3, said
    assert forces(path) == list(range(1000))


def test_a_reader_of_the_old_file_keeps_it(tmp_path: Path) -> None:
    path = finished(tmp_path / "r.h5", 1.0)
    with open_result(path) as old:
        with pytest.raises(OutputError, match=HELD):
            finished(path, 2.0)
        np.testing.assert_array_equal(old[CHANNEL.name], np.full(10, 1.0))
    with h5py.File(path, locking=False) as old:
        with another(path):
            np.testing.assert_array_equal(old[CHANNEL.name], np.full(10, 1.0))
        np.testing.assert_array_equal(old[CHANNEL.name], np.full(10, 1.0))
    assert forces(path) == list(range(1000))


def test_a_replaced_file_keeps_its_permissions_and_links(tmp_path: Path) -> None:
    path, link = finished(tmp_path / "r.h5"), tmp_path / "link.h5"
    path.chmod(0o600)
    link.symlink_to(path)
    finished(link, 2.0)
    assert link.is_symlink()
    assert forces(path) == [2.0] * 10
    assert stat.S_IMODE(path.stat().st_mode) == 0o600


def test_without_locks_the_one_whose_file_is_gone_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def flock(*_: int) -> NoReturn:
        raise OSError(errno.ENOTSUP, os.strerror(errno.ENOTSUP))

    monkeypatch.setattr(write_lock.fcntl, "flock", flock)
    path = tmp_path / "r.h5"
    early, running = Container(path, Header("time")), tmp_path / "running.h5"
    late = Container(running, Header("time"))
    late.begin()
    for name in (path, running):
        name.unlink()  # as the other one does
        finished(name)
    with pytest.raises(ResultError, match=HELD):
        early.begin()
    with pytest.raises(ResultError, match="removed or replaced while it was written; rerun"):
        late.finish()
    assert forces(path) == forces(running) == [1.0] * 10


def test_a_folder_that_forbids_to_replace_is_told_before_the_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = finished(tmp_path / "r.h5")
    monkeypatch.setattr("pitchpoint.io.target.os.access", lambda name, _: Path(name).is_file())
    with pytest.raises(OutputError, match=r"r\.h5: cannot be written \(Permission denied\)$"):
        check_target(path, "result")


def test_a_result_is_no_device() -> None:
    with pytest.raises(ResultError, match=r"null: cannot be written \(no ordinary file\)$"):
        Container(os.devnull, Header("time"))
