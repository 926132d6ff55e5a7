# SPDX-License-Identifier: Apache-2.0
"""The result store: what is written comes back, at any moment, also after a kill; memory stays constant."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import h5py
import numpy as np
import pytest

from pitchpoint.core import status as st
from pitchpoint.core.errors import PitchpointError, SolverError
from pitchpoint.io.container import Container, Header, MemoryContainer, ResultError
from pitchpoint.io.reading import list_channels, open_result, read_channel, read_header
from pitchpoint.io.results import Channel, ResultWriter, RunningStatistics
from pitchpoint.io.superblock import SIZE, clear_writer_flag, lookup3
from pitchpoint.io.tables import Axis, Quantity, TableWriter, write_tables

if TYPE_CHECKING:
    import xarray as xr

CHANNELS = [
    Channel("transmission_error[stage]", "m", "transmission error", "u_bt"),
    Channel("angle[driver]", "rad", "angle of rotation"),
]


def signals(n: int, start: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Make time and two channels of n samples at 10 kHz."""
    t = 1e-4 * np.arange(start, start + n)
    return t, np.column_stack([1e-6 * np.sin(2e3 * t), 157.0 * t + 1e5])


def test_what_is_written_comes_back(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "run.h5"
    t, values = signals(10_000)
    header = Header(
        "time", "Stirnradpaar β", "steady", "generalized_alpha", "ab12", "gears: {}", {"step": 1e-5}
    )
    with ResultWriter(path, header, CHANNELS, block=512) as writer:
        for k in range(0, 10_000, 777):
            writer.append(t[k : k + 777], values[k : k + 777])
    with open_result(path) as ds:
        np.testing.assert_array_equal(ds["time"], t)
        np.testing.assert_array_equal(ds["angle[driver]"], values[:, 1])
        np.testing.assert_allclose(ds["transmission_error[stage]"], values[:, 0], rtol=1e-7, atol=1e-15)
        assert ds["transmission_error[stage]"].dtype == np.float32
        assert ds["transmission_error[stage]"].dims == ("time",)
        expected = {"units": "m", "long_name": "transmission error", "symbol": "u_bt"}
        attrs = ds["transmission_error[stage]"].attrs
        assert {key: attrs[key] for key in expected} == expected
        assert attrs["statistics"] == pytest.approx(
            [values[:, 0].mean(), values[:, 0].std(), -1e-6, 1e-6], abs=1e-9
        )
        assert ds["time"].attrs["units"] == "s"
        assert (ds.attrs["status"], ds.attrs["title"]) == ("finished", "Stirnradpaar β")
        assert ds.attrs["model_text"] == "gears: {}"
    head = read_header(path)
    assert head["options"] == {"step": 1e-5}
    assert (head["status_code"], head["steps"], head["Conventions"]) == (st.OK, 10_000, "CF-1.11")
    assert head["sentence"] == "finished"
    assert head["model_hash"] == "ab12"
    assert list_channels(path) == ["angle[driver]", "transmission_error[stage]"]
    times, angle = read_channel(path, "angle[driver]", start=100, stop=110, step=2)
    np.testing.assert_array_equal(times, t[100:110:2])
    np.testing.assert_array_equal(angle, values[100:110:2, 1])


def test_layout_is_netcdf4_with_portable_filters(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    with ResultWriter(path, Header("time"), CHANNELS, block=256) as writer:
        writer.append(*signals(1024))
    with h5py.File(path) as file:
        assert file["time"].is_scale
        force = file["transmission_error[stage]"]
        assert force.dims[0][0] == file["time"]
        assert (force.compression, force.compression_opts, force.shuffle) == ("gzip", 1, True)
        assert force.chunks == (256,)


@pytest.mark.parametrize("decimate", [1, 3, 10, 1000])
def test_decimation_keeps_every_nth_sample_and_sees_all(tmp_path: Path, decimate: int) -> None:
    path = tmp_path / "run.h5"
    t, values = signals(2500)
    values[1234, 0] = 1.0
    with ResultWriter(path, Header("time"), CHANNELS, block=300, decimate=decimate) as writer:
        for k in range(0, 2500, 90):
            writer.append(t[k : k + 90], values[k : k + 90])
    np.testing.assert_array_equal(read_channel(path, "angle[driver]")[0], t[::decimate])
    assert writer.statistics()["transmission_error[stage]"]["max"] == 1.0
    with open_result(path, "blocks") as ds:
        assert ds["angle[driver]"].dims == ("time", "statistic")
        assert ds["transmission_error[stage]"].sel(statistic="max").max() == 1.0
        np.testing.assert_array_equal(ds["statistic"], ["min", "max", "mean", "rms"])


def test_running_statistics_equal_those_of_the_whole(tmp_path: Path) -> None:
    t, values = signals(5000)
    running = RunningStatistics(2, since=0.1)
    for k in range(0, 5000, 313):
        running.add(t[k : k + 313], values[k : k + 313])
    window = values[t >= 0.1]
    assert running.count == len(window)
    np.testing.assert_allclose(running.mean, window.mean(axis=0), rtol=1e-12)
    np.testing.assert_allclose(running.rms, window.std(axis=0), rtol=1e-12)
    np.testing.assert_array_equal(running.low, window.min(axis=0))
    np.testing.assert_array_equal(running.high, window.max(axis=0))


def test_events_are_a_list_of_their_own(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    with ResultWriter(
        path, Header("time"), CHANNELS, events=["contact[stage]", "pair entry[stage]"]
    ) as writer:
        writer.append_events(np.array([[0.1, 1, 1], [0.2, 0, -1]]))
        writer.append(*signals(10))
        writer.append_events(np.zeros((0, 3)))
        writer.append_events(np.array([[0.3, 0, 1]]))
    with open_result(path, "events") as ds:
        np.testing.assert_array_equal(ds["time"], [0.1, 0.2, 0.3])
        np.testing.assert_array_equal(ds["event"], [1, 0, 0])
        np.testing.assert_array_equal(ds["direction"], [1, -1, 1])
        assert ds["event"].attrs["flag_meanings"] == "contact[stage] pair_entry[stage]"
    with open_result(path) as ds:
        assert ds.sizes["event"] == 3
        np.testing.assert_array_equal(ds["event_time"], [0.1, 0.2, 0.3])
        assert ds["event_name"].values.tolist() == ["pair_entry[stage]", "contact[stage]", "contact[stage]"]
        np.testing.assert_array_equal(ds["event_direction"], [1, -1, 1])
        assert ds["angle[driver]"].dims == ("time",)


def test_notes_are_in_the_file(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    with ResultWriter(path, Header("time"), CHANNELS) as writer:
        writer.append(*signals(10))
        writer.finish(notes=("the backlash of stage is zero", "no drive ½"))
    assert read_header(path)["notes"] == "the backlash of stage is zero; no drive ½"
    with open_result(path) as ds:
        assert ds.attrs["notes"] == "the backlash of stage is zero; no drive ½"
        assert "event_time" not in ds


def test_statistics_without_a_sample_are_none(tmp_path: Path) -> None:
    with ResultWriter(tmp_path / "run.h5", Header("time"), CHANNELS, since=1e9) as writer:
        writer.append(*signals(10))
    assert writer.statistics()["angle[driver]"] == {
        "unit": "rad", "mean": None, "rms": None, "min": None, "max": None
    }  # fmt: skip


@pytest.mark.parametrize(
    ("error", "status", "code"),
    [
        (KeyboardInterrupt(), "interrupted", st.INTERRUPTED),
        (SolverError("Newton diverged at t = 0.1 s", st.DIVERGED), "failed", st.DIVERGED),
        (SolverError("stopped", st.INTERRUPTED), "interrupted", st.INTERRUPTED),
        (ZeroDivisionError("division by zero"), "failed", st.DIED),
    ],
)
def test_an_exception_marks_the_file_and_keeps_the_samples(
    tmp_path: Path, error: BaseException, status: str, code: int
) -> None:
    path = tmp_path / "run.h5"

    def run() -> None:
        with ResultWriter(path, Header("time"), CHANNELS) as writer:
            writer.append(*signals(100))
            raise error

    with pytest.raises(type(error)):
        run()
    head = read_header(path)
    assert (head["status"], head["status_code"]) == (status, code)
    assert str(error) in head["sentence"]
    assert head["sentence"]
    assert read_channel(path, "angle[driver]")[0].shape == (100,)


def test_long_sentences_are_cut_between_characters(tmp_path: Path) -> None:
    writer = ResultWriter(tmp_path / "run.h5", Header("time"), CHANNELS)
    writer.finish("failed", "ä" * 1000)
    writer.finish("finished", "too late")
    head = read_header(tmp_path / "run.h5")
    assert head["status"] == "failed"
    assert set(head["sentence"]) == {"ä"}


CHILD = """
    import sys, time
    import numpy as np
    from pitchpoint.io.container import Header
    from pitchpoint.io.results import Channel, ResultWriter

    force = Channel("mesh_force[stage]", "N")
    writer = ResultWriter(sys.argv[1], Header("time", "killed"), [force], block=500)
    k = 0
    while True:
        t = 1e-3 * np.arange(k, k + 250)
        writer.append(t, t[:, None])
        k += 250
        if k >= 2000:
            print(k, flush=True)
            time.sleep(0.01 if k < 20000 or sys.argv[2] == "busy" else 60)
"""


@contextlib.contextmanager
def writing(path: Path, manner: str) -> Iterator[Callable[[], int]]:
    """Run a process that writes until it is killed; gives a function that waits for its next report."""
    command = [sys.executable, "-c", textwrap.dedent(CHILD), str(path), manner]
    child = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert child.stdout is not None
    try:
        yield lambda: int(child.stdout.readline())
    finally:
        child.send_signal(signal.SIGKILL)
        child.wait()
        child.stdout.close()


def assert_consistent(path: Path, opened: xr.Dataset, at_least: int) -> None:
    """Check that a file says running and holds whole blocks of the right numbers."""
    with opened as ds:
        assert ds.attrs["status"] == "running"
        n = ds.sizes["time"]
        assert n >= at_least
        assert n % 500 == 0
        np.testing.assert_array_equal(ds["time"], 1e-3 * np.arange(n))
        np.testing.assert_allclose(ds["mesh_force[stage]"], ds["time"], rtol=1e-6)
    with open_result(path, "blocks") as ds:
        assert ds.sizes["time"] >= at_least // 500


def test_readable_while_running_and_after_a_kill_at_any_moment(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    with writing(path, "busy") as report:
        assert report() >= 2000
        with h5py.File(path, "r", libver="latest", swmr=True) as file:
            first = file["time"].shape[0]
            while report() < first + 3000:
                pass
            file["time"].refresh()
            assert file["time"].shape[0] > first >= 2000
        assert read_header(path)["status"] == "running"
        assert_consistent(path, open_result(path), 5000)
    assert_consistent(path, open_result(path), 5000)


def test_other_readers_need_no_repair_after_a_kill(tmp_path: Path) -> None:
    import xarray as xr

    path = tmp_path / "run.h5"
    with writing(path, "idle") as report:
        while report() < 20000:
            pass
        assert_consistent(path, xr.open_dataset(path, engine="h5netcdf"), 20000)
    assert_consistent(path, xr.open_dataset(path, engine="h5netcdf"), 20000)
    with h5py.File(path) as file:
        assert file["time"].shape == (20000,)


def test_memory_does_not_grow_with_the_run(tmp_path: Path) -> None:
    code = """
        import sys
        import numpy as np
        from pitchpoint.io.container import Header
        from pitchpoint.io.results import Channel, ResultWriter

        def resident():
            with open("/proc/self/statm") as file:
                return int(file.read().split()[1]) * 4096

        channels = [Channel(f"c[{k}]", "N") for k in range(8)]
        values = np.random.default_rng(0).normal(size=(1024, 8))
        with ResultWriter(sys.argv[1], Header("time"), channels, block=1024) as writer:
            for k in range(450):
                writer.append(1e-5 * np.arange(1024 * k, 1024 * (k + 1)), values)
                if k == 150:
                    early = resident()
            print(resident() - early)
    """
    if not Path("/proc/self/statm").exists():
        pytest.skip("memory in use is read from /proc, which Linux has")
    grown = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(code), str(tmp_path / "run.h5")],
        capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    # 300 blocks are 10 MB on disk and 22 MB in memory.
    assert int(grown) < 3e6


def test_tables_fill_point_by_point(tmp_path: Path) -> None:
    path = tmp_path / "sweep.h5"
    axes = [
        Axis("direction", ["up", "down"]),
        Axis("point", [0, 1, 2]),
        Axis("statistic", ["mean", "rms", "min", "max"]),
    ]
    quantities = [
        Quantity("deflection[stage]", ("direction", "point", "statistic"), "m"),
        Quantity("status", ("direction", "point"), dtype="i4"),
    ]
    jumps = [("jump_direction", "", "i4"), ("jump_mesh_frequency", "Hz", "f8")]
    with TableWriter(path, Header("sweep"), axes, quantities, growing=jumps) as table:
        table.fill("deflection[stage]", (0, 1), [1.0, 2.0, 3.0, 4.0])
        table.fill("status", (0, 1), 1)
        table.flush()
        with open_result(path) as ds:
            assert ds.attrs["status"] == "running"
            assert ds.attrs["kind"] == "sweep"
            here = ds["deflection[stage]"].sel(direction="up", point=1, statistic="rms")
            assert here == 2.0
            assert here.attrs["units"] == "m"
            assert np.isnan(ds["deflection[stage]"].sel(direction="down")).all()
        table.extend({"jump_direction": 1, "jump_mesh_frequency": 2450.0})
    with open_result(path) as ds:
        assert ds.attrs["status"] == "finished"
        np.testing.assert_array_equal(ds["jump_mesh_frequency"], [2450.0])
        np.testing.assert_array_equal(ds["status"], [[-1, 1, -1], [-1, -1, -1]])


def test_modes_are_tables_too(tmp_path: Path) -> None:
    path = tmp_path / "modes.h5"
    frequency = np.array([0.0, 2345.6])
    write_tables(
        path, Header("modes"), [Axis("mode", [1, 2])], [(Quantity("frequency", ("mode",), "Hz"), frequency)]
    )
    with open_result(path) as ds:
        np.testing.assert_array_equal(ds["frequency"], frequency)


def test_errors_name_file_and_remedy(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    with ResultWriter(path, Header("time"), CHANNELS) as writer:
        writer.append(*signals(10))
    with pytest.raises(ResultError, match="did you mean angle"):
        read_channel(path, "angle[drive]")
    with pytest.raises(ResultError, match="no such result file"):
        open_result(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("no")
    with pytest.raises(PitchpointError, match="not a readable HDF5"):
        read_header(tmp_path / "text.h5")
    with h5py.File(tmp_path / "other.h5", "w"):
        pass
    with pytest.raises(ResultError, match="not a result file"):
        open_result(tmp_path / "other.h5")
    with pytest.raises(PitchpointError, match="cannot be written"):
        ResultWriter(tmp_path, Header("time"), CHANNELS)
    with pytest.raises(ResultError, match="same name"):
        ResultWriter(path, Header("time"), [CHANNELS[0], CHANNELS[0]])


def test_checksum_is_that_of_the_library(tmp_path: Path) -> None:
    path = tmp_path / "any.h5"
    with h5py.File(path, "w", libver="latest") as file:
        file["x"] = [1.0]
    block = path.read_bytes()[:48]
    assert lookup3(block[:44]) == int.from_bytes(block[44:], "little")
    clear_writer_flag(path)
    assert path.read_bytes()[:48] == block


def test_reading_does_not_import_xarray() -> None:
    code = """
        import sys
        import pitchpoint.io.reading, pitchpoint.io.results, pitchpoint.io.tables
        print([name in sys.modules for name in ("xarray", "h5py", "numpy", "numba")])
    """
    code = textwrap.dedent(code)
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert out.strip() == str([False] * 4)


def test_a_reader_waits_for_a_writer_that_has_only_just_begun(tmp_path, monkeypatch):
    """An empty file is no fault for a while, and then it is one."""
    from pitchpoint.io import opening

    monkeypatch.setattr(opening, "PATIENCE", 0.1)
    target = tmp_path / "new.h5"
    target.touch()
    begun = time.monotonic()
    with pytest.raises(ResultError, match="not a readable HDF5 file"):
        read_header(target)
    assert time.monotonic() - begun >= 0.1


def test_a_closed_dataset_lets_go_of_its_file(tmp_path: Path) -> None:
    """What is opened afterwards is what stands there then, not what this process saw before."""
    path = tmp_path / "run.h5"
    for n in (5, 9):
        with ResultWriter(path, Header("time"), [Channel("x", "m")]) as writer:
            writer.append(np.arange(float(n)), np.zeros((n, 1)))
        with open_result(path) as data:
            assert data.sizes["time"] == n


def test_a_damaged_file_is_told_with_its_name(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    with ResultWriter(path, Header("time"), [Channel("x", "m")]) as writer:
        writer.append(np.zeros(1), np.zeros((1, 1)))
    data = bytearray(path.read_bytes())
    data[data.index(b"OHDR", data.index(b"OHDR") + 4) + 20] ^= 255  # header of the first array
    path.write_bytes(data)
    with pytest.raises(ResultError, match=r"run\.h5: is not a readable HDF5 file, damaged or incomplete"):
        open_result(path)


def test_datasets_are_those_of_other_readers(tmp_path: Path) -> None:
    """Names, dimensions, numbers, texts and attributes equal those which h5netcdf finds."""
    import xarray as xr

    run, table = tmp_path / "run.h5", tmp_path / "table.h5"
    with ResultWriter(
        run, Header("time", "β", options={"step": 1e-5}), CHANNELS, block=64, events=["a"]
    ) as w:
        w.append(*signals(100))
        w.append_events(np.array([[0.1, 0, 1]]))
    axes = [Axis("direction", ["up", "down"]), Axis("point", [0.5, 1.0]), Axis("letter", 4)]
    tables = [
        (Quantity("force[stage]", ("direction", "point"), "N"), np.eye(2)),
        (Quantity("status", ("point",), dtype="i4"), np.array([1, 2])),
        (Quantity("words", ("point",), dtype="text"), ["é", "two"]),
        (Quantity("sentence", ("point", "letter"), dtype="S1"), np.array([[b"f", b"i", b"n", b"e"]] * 2)),
    ]
    write_tables(table, Header("modes"), axes, tables)
    for path, group in ((run, "blocks"), (run, "events"), (table, None)):
        with (
            open_result(path, group) as ours,
            xr.open_dataset(path, group=group, engine="h5netcdf") as theirs,
        ):
            xr.testing.assert_identical(ours, theirs)
            assert {n: v.dtype for n, v in ours.variables.items()} == {
                n: v.dtype for n, v in theirs.variables.items()
            }
    with open_result(run) as ours, xr.open_dataset(run, engine="h5netcdf") as theirs:
        xr.testing.assert_identical(ours[list(theirs.variables)], theirs)
        rows = ours["angle[driver]"].isel(time=[3, 5, 90])
        np.testing.assert_array_equal(rows, theirs["angle[driver]"].values[[3, 5, 90]])
        assert ours["angle[driver]"].isel(time=-1) == theirs["angle[driver]"].values[-1]


@pytest.mark.parametrize("made", [Container, MemoryContainer])
def test_a_result_made_in_memory_is_one_on_disk(tmp_path: Path, made: type[Container]) -> None:
    """Same contents; the image carries no mark 'open for writing' (byte 11), the folder no file before."""
    path = tmp_path / "small.h5"
    container = made(path, Header(kind="time", title="small", stamped=False))
    scale = container.dimension("time", np.arange(5) / 10.0, attributes={"units": "s"})
    variable = container.variable("force", [scale], packed=True, chunks=(5,), attributes={"units": "N"})
    variable[...] = np.arange(5.0)
    container.finish("finished", "done", steps=7)
    if isinstance(container, MemoryContainer):
        assert not path.exists()
        path.write_bytes(container.image)
    assert path.read_bytes()[11] == 0
    header = read_header(path)
    assert (header["status"], header["sentence"], header["steps"]) == ("finished", "done", 7)
    with open_result(path) as data:
        np.testing.assert_array_equal(data["force"].values, np.arange(5.0))
        assert data["force"].dims == ("time",)
        assert data["force"].attrs["units"] == "N"


def test_blocks_behind_the_end_in_the_superblock_are_read(tmp_path: Path) -> None:
    """A writer killed within a flush: blocks and references are stored, the new end of the file is not."""
    path = tmp_path / "run.h5"
    writer = ResultWriter(path, Header("time"), CHANNELS, block=64)
    writer.append(*signals(64))
    writer.flush()
    before = path.read_bytes()[:SIZE]
    for _ in range(20):
        writer.append(*signals(64))
    writer.flush()
    data = path.read_bytes()
    assert int.from_bytes(before[28:36], "little") < len(data)
    killed = tmp_path / "killed.h5"
    killed.write_bytes(before + data[SIZE:])
    os.utime(killed, (0.0, 0.0))
    with open_result(killed) as found:
        assert found.attrs["status"] == "running"
        assert found.sizes["time"] == 21 * 64
        assert np.isfinite(found["angle[driver]"].values).all()
    writer.finish()
