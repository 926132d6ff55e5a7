# SPDX-License-Identifier: Apache-2.0
"""Tables of scenes come back within the error that was requested, whatever they look like."""

from __future__ import annotations

import base64
import gzip
import json
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from pitchpoint.viz.scene.packing import Block
from tests.support.scene_reader import Seen

RANDOM = np.random.default_rng(11)
T = np.linspace(0.0, 1.0, 500)
TRACKS = {
    "line": 75.0 * T,
    "parabola on a large number": 3e5 + 0.2 * T**2,
    "noise": 1e-5 * RANDOM.standard_normal(500),
    "steps": np.where(T > 0.3, -4.0, 7.0),
    "three of noise": 1e-5 * RANDOM.standard_normal((500, 3)),
    "one direction": np.sin(40.0 * T)[:, None] * [3.0, -4.0, 12.0] + [1e3, 0.0, -5.0],
    "a plane": np.column_stack([np.sin(9.0 * T), np.cos(9.0 * T), np.sin(9.0 * T) - 2.0]),
}


def read(block: Block, entry: dict[str, Any]) -> np.ndarray:
    header = json.dumps({"format": "pitchpoint-scene-2"})
    return Seen(header, base64.b64encode(gzip.compress(bytes(block.data))).decode()).array(entry)


@pytest.mark.parametrize("name", TRACKS)
@pytest.mark.parametrize("within", [1e-3, 1e-8])
def test_tracks_are_as_exact_as_asked_for(name: str, within: float) -> None:
    truth, block = TRACKS[name], Block()
    entry = json.loads(json.dumps(block.put_track(truth, within)))
    found = read(block, entry)
    assert np.abs(found - truth).max() <= within * (1.0 + 1e-9) + 1e-15 * np.abs(truth).max()


def test_columns_that_move_together_are_kept_once() -> None:
    block = Block()
    entry = block.put_track(TRACKS["one direction"], 1e-6)
    assert entry["shape"] == [500, 1] and np.shape(entry["mix"]) == (1, 3)
    # parts of one force along fixed directions follow from one number
    parts = [TRACKS["one direction"], -0.3 * TRACKS["one direction"][:, ::-1]]
    block = Block()
    both = block.put_tracks(parts, 1e-6)
    assert both[0]["at"] == both[1]["at"] and both[0]["shape"] == [500, 1]
    for entry, truth in zip(both, parts, strict=True):
        assert np.abs(read(block, entry) - truth).max() <= 1e-6


def test_what_does_not_move_is_one_row() -> None:
    block = Block()
    still = np.full((500, 3), 2.0) + 1e-9 * RANDOM.standard_normal((500, 3))
    entry = block.put_track(still, 1e-7)
    assert entry["shape"] == [1, 3]
    assert np.abs(read(block, entry) - still).max() < 1e-7
    assert block.put_track(np.full(9, 5.0), 1e-3)["shape"] == [1]
    # together with others that do, or not
    noise = RANDOM.standard_normal((500, 3))
    for other in (noise, TRACKS["one direction"], still + 1.0):
        found = [read(block, entry) for entry in block.put_tracks([other, still], 1e-7)]
        for values, truth in zip(found, (other, still), strict=True):
            assert np.abs(values - truth).max() <= 1.001e-7


def test_steps_have_a_zero_and_neighbours_may_lie_across() -> None:
    truth = np.where(RANDOM.random((50, 4, 9)) < 0.5, 0.0, RANDOM.random((50, 4, 9)))
    for across in (False, True):
        block = Block()
        found = read(block, block.put_steps(truth, 1e-3, across=across))
        assert found.shape == truth.shape and np.abs(found - truth).max() <= 0.5001e-3
        assert np.array_equal(found == 0.0, np.abs(truth) < 0.5e-3)
    block = Block()
    assert not read(block, block.put_steps(np.zeros((3, 2)), 0.0)).any()


@settings(max_examples=60, deadline=None)
@given(
    arrays.arrays(
        np.int64,
        arrays.array_shapes(min_dims=1, max_dims=3, max_side=6),
        elements=st.integers(-(2**44), 2**44),
    )
)
def test_whole_numbers_come_back(truth: np.ndarray) -> None:
    block = Block()
    assert np.array_equal(read(block, block.put_whole(truth)), truth)
    # and the same numbers are there once
    size = len(block.data)
    block.put_whole(truth.copy())
    assert len(block.data) == size
