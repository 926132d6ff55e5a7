# SPDX-License-Identifier: Apache-2.0
"""A disk that refuses: a sentence and an exit code; stored samples are readable, older files stay whole."""

from __future__ import annotations

import errno
import json
import os
import shutil
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.failure import exit_code_of
from pitchpoint.core.status import NOT_WRITTEN
from pitchpoint.io.reading import open_result, read_channel, read_header
from pitchpoint.io.results import Channel, Header, ResultWriter
from pitchpoint.io.target import OutputError, write_file
from tests.support.cli_files import TORSION, written

resource = pytest.importorskip("resource", reason="limits of sizes are those of Unix")

KILOBYTE = 1024
WRITE_RUN = """
    import sys
    import numpy as np
    from pitchpoint.io.results import Channel, Header, ResultWriter

    values = np.random.default_rng(1).normal(size=(40 * 256, 5))
    with ResultWriter(sys.argv[1], Header("time"), [Channel(f"x[{k}]", "m") for k in range(5)],
                      block=256, events=["hit"]) as writer:
        for k in range(40):
            rows = slice(256 * k, 256 * (k + 1))
            writer.append(np.arange(256.0) + 256 * k, values[rows])
            writer.append_events(np.array([[256.0 * k, 0, 1]]))
"""
WRITE_TABLE = """
    import sys
    from pitchpoint.io.results import Header
    from pitchpoint.io.tables import Axis, Quantity, TableWriter

    axes = [Axis("point", list(range(40))), Axis("words", ["a", "b"])]
    wanted = [Quantity(f"x[{k}]", ("point", "words"), "m") for k in range(30)]
    with TableWriter(sys.argv[1], Header("sweep"), axes, wanted, growing=[("at", "Hz", "f8")]) as table:
        for k in range(40):
            for q in wanted:
                table.fill(q.name, k, [k, -k])
            table.extend({"at": k})
            table.flush()
"""
CHILD = """
    import resource
    import sys
    from pitchpoint.cli.failure import exit_code_of
    resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[2]), resource.RLIM_INFINITY))
    try:
        exec(compile({code!r}, "writer", "exec"))
    except BaseException as error:
        raise SystemExit(exit_code_of(error))
"""


def limited(code: str, path: Path, limit: int) -> subprocess.CompletedProcess:
    """Run a writer in a process whose files must not grow beyond a limit [bytes]."""
    child = textwrap.dedent(CHILD).format(code=textwrap.dedent(code))
    command = [sys.executable, "-B", "-c", child, str(path), str(limit)]  # Python keeps bytecode that is cut
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)


@pytest.mark.parametrize("limit", [1, 5, 12, 30, 46, 60, 75, 100, 130, 170])
def test_samples_that_were_written_before_the_disk_was_full_are_readable(limit: int, tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    done = limited(WRITE_RUN, path, limit * KILOBYTE)
    assert done.returncode == 3, (done.returncode, done.stderr)
    assert "cannot be written any more (File too large)" in done.stderr
    assert "Traceback" not in done.stderr
    if not path.exists():
        assert "no data are retained" in done.stderr
        return
    header = read_header(path)
    assert (header["status"], header["status_code"]) == ("failed", NOT_WRITTEN)
    assert "File too large" in header["sentence"]
    whole = np.random.default_rng(1).normal(size=(40 * 256, 5)).astype("f4")
    with open_result(path) as data:
        rows = data.sizes["time"]
        assert rows % 256 == 0
        for k in range(5):  # every block that was flushed, and no row of the one that failed
            assert np.array_equal(data[f"x[{k}]"].values, whole[:rows, k])
        assert data.sizes["event"] <= rows // 256
    if limit >= 100:
        assert rows > 0


@pytest.mark.parametrize("limit", [1, 10, 20, 30])
def test_tables_on_a_full_disk(limit: int, tmp_path: Path) -> None:
    path = tmp_path / "sweep.h5"
    done = limited(WRITE_TABLE, path, limit * KILOBYTE)
    if done.returncode == 0:
        assert limit == 30
        return
    assert done.returncode == 3, (done.returncode, done.stderr)
    assert "cannot be written any more" in done.stderr
    if path.exists():
        assert read_header(path)["status"] == "failed"


def test_a_run_on_a_full_disk(tmp_path: Path) -> None:
    """The command, with summary: what is in the file is named."""
    code = """
        import resource, sys
        from pitchpoint.cli.main import run_command
        run_command(["run", sys.argv[1], "-s", "steady", "-o", sys.argv[2] + "x", "-q"])
        resource.setrlimit(resource.RLIMIT_FSIZE, (400 * 1024, resource.RLIM_INFINITY))
        raise SystemExit(run_command(["run", sys.argv[1], "-s", "steady", "-o", sys.argv[2], "-q", "--json"]))
    """
    file, target = written(tmp_path, TORSION), tmp_path / "run.h5"
    command = [sys.executable, "-B", "-c", textwrap.dedent(code), file, str(target)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 3, done.stderr
    summary = json.loads(
        done.stdout[done.stdout.rindex("\n{\n") :] if "\n{\n" in done.stdout else done.stdout
    )
    assert summary["status"] == "failed"
    assert summary["output"] == str(target)
    assert len(read_channel(target, "mesh_force[stage]")[0]) > 0


def test_an_older_page_stays_whole_when_the_disk_is_full(tmp_path: Path, monkeypatch) -> None:
    page = tmp_path / "report.html"
    write_file(page, "old")
    page.chmod(0o640)

    def full(descriptor: int) -> None:
        """Refuse as a full disk does."""
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with monkeypatch.context() as patched:
        patched.setattr(os, "fsync", full)
        with pytest.raises(OutputError, match="No space left on device") as caught:
            write_file(page, "new")
    assert exit_code_of(caught.value) == 3
    assert page.read_text() == "old"
    assert list(tmp_path.iterdir()) == [page]
    write_file(page, "new")
    assert page.read_text() == "new"
    assert page.stat().st_mode & 0o777 == 0o640


def test_a_text_from_a_damaged_file_is_written(tmp_path: Path) -> None:
    """HDF5 gives bytes that are not UTF-8 as surrogates, which no file can hold."""
    write_file(tmp_path / "page.html", b"title: \xffm".decode("utf-8", "surrogateescape"))
    assert (tmp_path / "page.html").read_text() == "title: ?m"


def test_a_link_goes_on_pointing_to_the_file(tmp_path: Path) -> None:
    (tmp_path / "link.html").symlink_to(tmp_path / "there.html")
    write_file(tmp_path / "link.html", "a")
    assert (tmp_path / "link.html").is_symlink()
    assert (tmp_path / "there.html").read_text() == "a"


def test_a_pipe_without_a_reader_is_refused(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(OutputError, match="start the process that reads this pipe first"):
        write_file(pipe, "page")
    with (tmp_path / "copy").open("wb") as copy:
        reader = subprocess.Popen(["cat", str(pipe)], stdout=copy)
        for _ in range(200):
            try:
                write_file(pipe, "page" * 100_000)
                break
            except OutputError:  # it has not opened the pipe yet
                time.sleep(0.02)
        assert reader.wait(timeout=20) == 0
    assert (tmp_path / "copy").stat().st_size == 400_000


def test_sigterm_ends_a_run_in_order(tmp_path: Path) -> None:
    long = TORSION.replace("duration: 0.5 s", "duration: 500 s")
    assert long != TORSION
    file, target = written(tmp_path, long), tmp_path / "run.h5"
    code = "from pitchpoint.cli.main import main; main()"
    command = [sys.executable, "-c", code, "run", file, "-s", "steady", "-o", str(target), "-q"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
    deadline = time.monotonic() + 120.0
    while time.monotonic() < deadline:
        time.sleep(0.2)
        if target.exists() and target.stat().st_size > 200_000:
            break
    process.send_signal(signal.SIGTERM)
    _, words = process.communicate(timeout=60)
    assert process.returncode == 143, words
    assert read_header(target)["status"] == "interrupted"
    assert len(read_channel(target, "mesh_force[stage]")[0]) > 0


def test_ctrl_c_while_the_structure_is_made_leaves_no_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stopped(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(ResultWriter, "_make_variables", stopped)
    with pytest.raises(KeyboardInterrupt):
        ResultWriter(tmp_path / "r.h5", Header("time"), [Channel("mesh_force[stage]", "N")])
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("name", "code"), [("SIGHUP", 129), ("SIGTERM", 143), ("SIGINT", 130)])
@pytest.mark.parametrize("ignored", [False, True])
def test_signals_that_end_a_command_in_order(name: str, code: int, ignored: bool) -> None:
    """One that was ignored before, as `nohup` does, goes on being ignored."""
    lines = f"""
        import os, signal, sys
        from pitchpoint.cli.interrupt import code_of_interruption, end_at_the_second_interrupt
        if {ignored}:
            signal.signal(signal.{name}, signal.SIG_IGN)
        end_at_the_second_interrupt()
        try:
            os.kill(os.getpid(), signal.{name})
        except KeyboardInterrupt:
            sys.exit(code_of_interruption())
    """
    done = subprocess.run([sys.executable, "-c", textwrap.dedent(lines)], check=False)
    assert done.returncode == (0 if ignored else code)


FULL = """
    import os, shutil, sys
    from pitchpoint.io.reading import read_header
    shutil.copy(sys.argv[1], "r.h5")
    os.truncate("r.h5", 1 << 20)
    with open("rest", "wb", buffering=0) as file:
        try:
            while file.write(bytes(4096)) == 4096:
                pass
        except OSError:
            print(read_header("r.h5")["status"])
"""


def test_a_result_with_gaps_is_read_on_a_full_disk_in_memory(tmp_path: Path) -> None:
    """Gaps of a file that is mapped have to be filled: a process that reads them there ends by SIGBUS."""
    with ResultWriter(tmp_path / "r.h5", Header("time"), [Channel("mesh_force[stage]", "N")]):
        pass
    mount = ["unshare", "-rm", "sh", "-c"]
    disk = tmp_path / "disk"
    disk.mkdir()
    words = f'mount -t tmpfs -o size=256k disk "{disk}" && cd "{disk}" && exec "$0" "$@"'
    if shutil.which("unshare") is None or subprocess.run([*mount, words, "true"], check=False).returncode:
        pytest.skip("a file system in memory cannot be mounted here")
    code = [sys.executable, "-c", textwrap.dedent(FULL), str(tmp_path / "r.h5")]
    done = subprocess.run([*mount, words, *code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.strip()) == (0, "finished"), done.stderr
