# SPDX-License-Identifier: Apache-2.0
"""Measured files cut at any byte and with bytes changed give a dataset or a sentence, and both soon."""

from __future__ import annotations

import time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pitchpoint.core.errors import PitchpointError
from pitchpoint.io.measured.reading import read_measured
from tests.support import measured_files as files

IN_PROCESS = ("csv", "mat", "plain.mat", "wav", "float.wav", "own.h5", "v4.mat", "structures.mat",
              "csv.gz")  # fmt: skip
IN_A_TRIAL = ("h5", "v73.mat")
"""Other people's HDF5 is tried in a process of its own: half a second each."""
SOON = 25.0
"""Seconds: the time after which a trial is given up, with room for a busy machine."""

# most of what can go wrong stands in the first bytes
PLACES = st.one_of(st.floats(0.0, 1.0), st.floats(0.0, 0.1))
VALUES = st.one_of(st.integers(0, 255), st.sampled_from([0, 1, 127, 128, 255]))
EDITS = st.lists(st.tuples(PLACES, VALUES), max_size=5)


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    folder = tmp_path_factory.mktemp("measured")
    found = {}
    for name, write in files.WRITERS.items():
        write(folder / f"good.{name}")
        found[name] = (folder / f"good.{name}").read_bytes()
    return folder, found


def read_or_refused(folder, name, data):
    path = folder / f"fuzz.{name.rpartition('.')[2]}"
    path.write_bytes(data)
    begun = time.monotonic()
    try:
        found = read_measured(path, sample_rate=None if name in ("own.h5", "csv") else 1000.0)
    except PitchpointError as error:
        assert str(path) in str(error) and "\n" not in str(error)
    else:
        assert all(np.all(np.isfinite(v)) for v in found.variables.values())
        assert all("units" in v.attrs for v in found.data_vars.values())
    assert time.monotonic() - begun < SOON


def changed(data, edits, cut):
    raw = bytearray(data)
    for place, value in edits:
        raw[min(int(place * len(raw)), len(raw) - 1)] = value
    return bytes(raw[: int(cut * len(raw))])


@pytest.mark.parametrize("name", IN_PROCESS)
@given(edits=EDITS, cut=st.one_of(st.just(1.0), st.floats(0.0, 1.0)))
def test_cut_and_changed_files(good, name, edits, cut):
    folder, contents = good
    read_or_refused(folder, name, changed(contents[name], edits, cut))


@pytest.mark.slow
@pytest.mark.parametrize("name", IN_A_TRIAL)
@settings(max_examples=15)
@given(edits=EDITS, cut=st.one_of(st.just(1.0), st.floats(0.0, 1.0)))
def test_cut_and_changed_foreign_hdf5(good, name, edits, cut):
    folder, contents = good
    read_or_refused(folder, name, changed(contents[name], edits, cut))


@given(edits=EDITS, cut=st.one_of(st.just(1.0), st.floats(0.0, 1.0)))
def test_cut_and_changed_universal_files(tmp_path_factory, edits, cut):
    folder = tmp_path_factory.getbasetemp()
    good = folder / "good.uff"
    if not good.exists():
        files.write_uff(good)
    read_or_refused(folder, "uff", changed(good.read_bytes(), edits, cut))


@pytest.mark.parametrize("name", ["wav", "plain.mat", "csv", "v4.mat", "csv.gz"])
def test_cut_at_every_byte(good, name):
    folder, contents = good
    for length in range(0, len(contents[name]), {"csv": 11, "csv.gz": 7, "v4.mat": 7}.get(name, 1)):
        read_or_refused(folder, name, contents[name][:length])


@given(st.text(alphabet="time x[];,.\t\n0123456789-+eE#\"'nan", max_size=200))
def test_any_text(tmp_path_factory, text):
    folder = tmp_path_factory.getbasetemp()
    read_or_refused(folder, "csv", text.encode())
