# SPDX-License-Identifier: Apache-2.0
"""Lazy datasets of result files can be copied, interpolated and pickled."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.container import Header, ResultError
from pitchpoint.io.reading import open_result, read_channel
from pitchpoint.io.results import Channel, ResultWriter


def write_ramp(path: Path, slope: float, model_hash: str = "ab12") -> None:
    """Result with a force that increases linearly, 1000 samples per second."""
    header = Header("time", "ramp", "steady", "generalized_alpha", model_hash, "", {})
    t = 1e-3 * np.arange(1001)
    with ResultWriter(path, header, [Channel("force[a]", "N", "force"), Channel("b", "m", "way")]) as writer:
        writer.append(t, np.column_stack([slope * t, t]))


def test_lazy_channels_are_interpolated(tmp_path: Path) -> None:
    write_ramp(tmp_path / "run.h5", 3.0)
    with open_result(tmp_path / "run.h5") as data:
        assert float(data["force[a]"].interp(time=0.12345)) == pytest.approx(0.37035, rel=1e-6)
        found = data.interp(time=[0.25, 0.5])
        assert found["force[a]"].values == pytest.approx([0.75, 1.5], rel=1e-6)
        assert found["b"].values == pytest.approx([0.25, 0.5], rel=1e-6)


def test_copies_outlive_the_dataset(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    write_ramp(path, 3.0)
    data = open_result(path)
    channel = data["force[a]"]
    whole = [data.copy(deep=True), copy.deepcopy(data), pickle.loads(pickle.dumps(data))]
    single = [channel.copy(deep=True), pickle.loads(pickle.dumps(channel))]
    data.close()
    expected = read_channel(path, "force[a]")[1]
    for found in (*(one["force[a]"] for one in whole), *single):
        np.testing.assert_array_equal(found.values, expected)
        assert found.attrs["units"] == "N"
    for one in whole:
        np.testing.assert_array_equal(one["b"].values, read_channel(path, "b")[1])
        one.close()
    write_ramp(path, 2.0, "cd34")  # nothing holds the file


def test_copies_in_another_process(tmp_path: Path) -> None:
    write_ramp(tmp_path / "run.h5", 3.0)
    with open_result(tmp_path / "run.h5") as data:
        (tmp_path / "data.pickle").write_bytes(pickle.dumps(data))
    read = "import pickle, sys; print(float(pickle.load(open(sys.argv[1], 'rb'))['force[a]'].max()))"
    done = subprocess.run(
        [sys.executable, "-c", read, "data.pickle"], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert float(done.stdout) == pytest.approx(3.0)


def test_copies_refuse_another_result(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    write_ramp(path, 3.0)
    with open_result(path) as data:
        kept = pickle.dumps(data)
    write_ramp(path, 2.0, "cd34")
    with pytest.raises(ResultError, match="was written again since it was opened; open it once more"):
        pickle.loads(kept)["b"].load()
