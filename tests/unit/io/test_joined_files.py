# SPDX-License-Identifier: Apache-2.0
"""Several files as one record: names, length, clock, units and statements."""

from __future__ import annotations

import hashlib

import numpy as np
import pytest
from scipy.io import savemat

from pitchpoint.io.measured.reading import read_measured
from pitchpoint.io.measured.record import MeasuredError

N = 1500


def rig(tmp_path, count=3, **content):
    """One file per channel; channel k is k + 1 times a ramp, and k samples shorter."""
    paths = []
    for k in range(count):
        paths.append(tmp_path / f"ch{k}.mat")
        savemat(paths[-1], {"x": (k + 1.0) * np.arange(N - k), "Header": {"SampFreq": 5120.0}} | content)
    return paths


def test_channels_are_named_after_their_files_and_cut_to_the_shortest(tmp_path):
    paths = rig(tmp_path, rpm=1500.0)
    data = read_measured(paths, units={"ch1": "50 m/s^2"})
    assert list(data.data_vars) == ["ch0", "ch1", "ch2"] and data.sizes["time"] == N - 2
    assert data["ch2"].values[:3].tolist() == [0.0, 3.0, 6.0]
    assert data["ch1"].values[1] == 100.0 and data["ch1"].units == "m/s^2" and data["ch0"].units == ""
    assert data.sample_rate == 5120.0 and data["time"].values[1] == 1 / 5120.0
    assert f"{N - 2} samples are used, as in the shortest file (longer: ch0.mat 1500, ch1.mat" in data.notes
    assert data.notes.count("speed 1500 rpm from rpm") == 1  # equal notes of all files are one
    assert data.attrs["shaft_speed"] == pytest.approx(50 * np.pi)
    assert data.source_file == "ch0.mat, ch1.mat, ch2.mat"
    assert data.sha256.split(", ") == [hashlib.sha256(p.read_bytes()).hexdigest() for p in paths]


def test_chosen_channels_and_names_of_files_with_several(tmp_path):
    for name in ("a", "b"):
        savemat(tmp_path / f"{name}.mat", {"x": np.arange(9.0), "y": np.ones(9), f"only_{name}": np.ones(9)})
    paths = [tmp_path / "a.mat", str(tmp_path / "b.mat")]
    names = ["a.x", "a.y", "only_a", "b.x", "b.y", "only_b"]
    data = read_measured(paths, sample_rate="1 kHz")
    assert list(data.data_vars) == names and data["b.x"].long_name == "b.x"
    assert list(read_measured(paths, sample_rate=1.0, channels=["b.x", "only_a"]).data_vars) == [
        "b.x",
        "only_a",
    ]
    with pytest.raises(MeasuredError, match=r"'a.z' is not a channel of the file; did you mean"):
        read_measured(paths, sample_rate=1.0, channels="a.z")
    with pytest.raises(MeasuredError, match="none is requested"):
        read_measured(paths, sample_rate=1.0, channels=[])
    (tmp_path / "c").mkdir()
    savemat(tmp_path / "c" / "a.mat", {"x": np.arange(9.0)})
    data = read_measured([paths[0], tmp_path / "c" / "a.mat"], sample_rate=1.0)
    assert f"{tmp_path.name}/a.x" in data and "c/a" in data


def test_files_that_do_not_fit_are_refused_by_name(tmp_path):
    paths = rig(tmp_path)
    savemat(tmp_path / "fast.mat", {"y": np.arange(3000.0), "fs": 10240.0})
    with pytest.raises(MeasuredError) as caught:
        read_measured([*paths, tmp_path / "fast.mat"])
    sentence = "fast.mat: sample rate: 10240 Hz differs from that of ch0.mat (limit 5120 Hz); read files"
    assert sentence in str(caught.value)
    savemat(tmp_path / "short.mat", {"y": np.arange(700.0), "fs": 5120.0})
    with pytest.raises(MeasuredError, match=r"short.mat: samples: 700 is much shorter.*limit 750 or more"):
        read_measured([*paths, tmp_path / "short.mat"])
    savemat(tmp_path / "late.mat", {"y": np.arange(1500.0), "t": 0.1 + np.arange(1500) / 5120.0})
    with pytest.raises(MeasuredError, match=r"late.mat: time: 0.1 s starts at another time than ch0.mat"):
        read_measured([*paths, tmp_path / "late.mat"])
    with pytest.raises(MeasuredError, match="is given more than once"):
        read_measured([paths[0], paths[0]])
    with pytest.raises(MeasuredError, match="no file is given"):
        read_measured([])
    savemat(tmp_path / "bad.mat", {"y": np.full(1500, np.nan), "fs": 5120.0})
    with pytest.raises(MeasuredError, match=r"bad.mat: y: 1500 of 1500 samples"):
        read_measured([*paths, tmp_path / "bad.mat"])
    assert len(read_measured([*paths, tmp_path / "bad.mat"], channels=["ch0", "ch2"]).data_vars) == 2


def test_speeds_that_differ_are_not_used(tmp_path):
    paths = rig(tmp_path, count=2, rpm=1500.0)
    savemat(tmp_path / "d.mat", {"y": np.arange(1500.0), "fs": 5120.0, "rpm": 1200.0})
    data = read_measured([*paths, tmp_path / "d.mat"])
    assert "shaft_speed" not in data.attrs and "speeds of the files differ, none is used" in data.notes
