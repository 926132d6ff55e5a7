# SPDX-License-Identifier: Apache-2.0
"""Wind files cut at any byte and with bytes changed give a box or a sentence with the name of the file."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.io.wind.mann import MannGeometry, read_mann
from pitchpoint.model.wind.file_errors import WindFileError
from pitchpoint.model.wind.turbsim import read_turbsim
from tests.unit.io.test_wind_files import turbsim_bytes

# most of what can go wrong is in the header
PLACES = st.one_of(st.integers(0, 69), st.integers(0, 268))
EDITS = st.lists(st.tuples(PLACES, st.integers(0, 255)), max_size=5)
CUT = st.one_of(st.none(), st.integers(0, 269))


@given(edits=EDITS, cut=CUT, tower=st.sampled_from([0, 2]))
def test_cut_and_changed_files_of_turbsim(tmp_path_factory, edits, cut, tower):
    path = tmp_path_factory.getbasetemp() / "fuzz.bts"
    raw = bytearray(turbsim_bytes(tower)[0])
    for place, value in edits:
        raw[place % len(raw)] = value
    path.write_bytes(bytes(raw[:cut]))
    try:
        box = read_turbsim(path)
    except WindFileError as error:
        assert str(path) in str(error) and "\n" not in str(error)
    else:
        assert np.isfinite(box.velocity).all()
        assert box.velocity.size <= len(raw)


@given(data=st.binary(max_size=120), points=st.tuples(*[st.integers(1, 4)] * 3))
def test_any_bytes_as_a_mann_box(tmp_path_factory, data, points):
    path = tmp_path_factory.getbasetemp() / "fuzz.bin"
    path.write_bytes(data)
    geometry = MannGeometry(points=points, spacing=(1.0, 2.0, 3.0), mean_speed=9.0, hub_height=90.0)
    try:
        box = read_mann([path] * 3, geometry)
    except WindFileError as error:
        assert str(path) in str(error) and "\n" not in str(error)
    else:
        assert len(data) == 4 * points[0] * points[1] * points[2]
        assert np.isfinite(box.velocity).all()


def test_no_byte_may_be_missing(tmp_path):
    whole = turbsim_bytes()[0]
    for cut in range(len(whole)):
        (tmp_path / "a.bts").write_bytes(whole[:cut])
        with pytest.raises(WindFileError, match="cut off"):
            read_turbsim(tmp_path / "a.bts")
