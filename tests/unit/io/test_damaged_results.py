# SPDX-License-Identifier: Apache-2.0
"""Result files with objects that are missing or lie in another file; damaged archives of matrices."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest

from pitchpoint.core.errors import PitchpointError
from pitchpoint.io.container import ResultError
from pitchpoint.io.measured.reading import read_measured
from pitchpoint.io.measured.record import MeasuredError
from pitchpoint.io.reading import list_channels, open_result, read_channel, read_units
from pitchpoint.io.results import Channel, Header, ResultWriter
from pitchpoint.io.sweep_store import SweepWriter, read_sweep
from pitchpoint.multibody.fe_matrices import read_npz

SECRET = "secret.h5"


@pytest.fixture
def run(tmp_path: Path) -> Path:
    path = tmp_path / "run.h5"
    with ResultWriter(path, Header("time"), [Channel("force", "N"), Channel("speed", "rad/s")]) as writer:
        writer.append(np.arange(10.0), np.ones((10, 2)))
    with h5py.File(tmp_path / SECRET, "w") as file:
        file["data"] = np.arange(10.0)
    np.arange(10.0).tofile(tmp_path / "secret.bin")
    return path


def _link(file: h5py.File) -> None:
    file["force"] = h5py.ExternalLink(SECRET, "/data")


def _storage(file: h5py.File) -> None:
    file.create_dataset("force", (10,), "f8", external=[("secret.bin", 0, h5py.h5f.UNLIMITED)])


def _virtual(file: h5py.File) -> None:
    layout = h5py.VirtualLayout((10,), "f8")
    layout[:] = h5py.VirtualSource(SECRET, "data", (10,))
    file.create_virtual_dataset("force", layout)


@pytest.mark.parametrize("place", [_link, _storage, _virtual])
def test_other_files_are_not_read(place: Callable, run: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(run.parent)
    with h5py.File(run, "r+") as file:
        del file["force"]
        place(file)
        if "force" in file and not isinstance(file.get("force", getlink=True), h5py.ExternalLink):
            file["force"].dims[0].attach_scale(file["time"])
    questions = (open_result, list_channels, read_units, lambda path: read_channel(path, "force"))
    for question in questions:
        with pytest.raises(ResultError, match="somewhere else|in another file"):
            question(run)
    with pytest.raises(MeasuredError, match="damaged"):
        read_measured(run)


@pytest.mark.parametrize("place", [_storage, _virtual])
def test_measured_files_do_not_lead_to_other_files(
    place: Callable, run: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(run.parent)
    path = run.with_name("foreign.h5")
    with h5py.File(path, "w") as file:
        place(file)
        file["other"] = np.arange(10.0)
    with pytest.raises(MeasuredError, match="force: is stored in another file"):
        read_measured(path, sample_rate=1.0)
    assert read_measured(path, sample_rate=1.0, channels="other")["other"].values[-1] == 9.0


@pytest.mark.parametrize("name", ["time", "blocks/time", "blocks/statistic"])
def test_a_dimension_that_was_deleted(name: str, run: Path) -> None:
    """HDF5's own way to the dimensions ends the process there (segmentation fault)."""
    with h5py.File(run, "r+") as file:
        del file[name]
    with pytest.raises(ResultError, match="damaged or incomplete"):
        open_result(run, "blocks" if "/" in name else None)


@pytest.mark.parametrize("name", ["direction", "mesh_frequency", "speed", "point_status", "jump_direction"])
def test_a_sweep_without_one_of_its_variables(name: str, tmp_path: Path) -> None:
    path = tmp_path / "sweep.h5"
    with SweepWriter(path, Header("sweep"), "stage", ["up"], [1.0, 2.0], [10.0, 20.0]):
        pass
    assert read_sweep(path)["points"] == []
    with h5py.File(path, "r+") as file:
        del file[name]
    with pytest.raises(ResultError, match="damaged or incomplete"):
        read_sweep(path)


def test_damaged_archives_of_matrices(tmp_path: Path) -> None:
    path = tmp_path / "rod.npz"
    np.savez_compressed(path, K=np.zeros((6, 6)), M=np.eye(6), places=np.zeros((1, 3)))
    whole = path.read_bytes()
    for at in range(30, len(whole), 7):
        damaged = bytearray(whole)
        damaged[at] ^= 0xFF
        path.write_bytes(damaged)
        try:
            read_npz(path)
        except PitchpointError:
            continue


@pytest.mark.parametrize("name", ["kind", "model_text", "scenario", "sentence"])
@pytest.mark.parametrize("value", [3.5, [1.0, 2.0], -1])
def test_a_text_of_the_file_that_is_a_number(name: str, value: object, run: Path) -> None:
    with h5py.File(run, "r+") as file:
        file.attrs[name] = value
    with pytest.raises(ResultError, match=f"the attribute {name} is not a text"):
        open_result(run)


@pytest.mark.parametrize("status", ["finished", "running"])
def test_a_group_within_itself(status: str, run: Path) -> None:
    """A hard link that closes a circle: every group is read once."""
    with h5py.File(run, "r+") as file:
        group = file.create_group("inner")
        group["again"] = group
        file.attrs["status"] = status
    with open_result(run) as data:
        assert data["force"].values.tolist() == [1.0] * 10
