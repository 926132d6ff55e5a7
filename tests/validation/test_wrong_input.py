# SPDX-License-Identifier: Apache-2.0
"""100 000 model files with wrong edits: no raw exception, no hang, no number without a status.

Models of `examples` and of the pages in `docs`, each with one to five edits at once: values deleted, doubled,
swapped, moved, renamed, extreme or of another type, lists of another length (`tests/support/mutation.py`).
All are loaded; every fiftieth is compiled, its modes are found and its scenarios run for a few steps. Counts
are exact: what is allowed is a refusal with a sentence, or finite numbers, or a status. Measured files (CSV,
MAT, WAV, results) have up to five bytes changed and are cut at any place. Killed runs, sweeps and cases and
damaged result files have studies of their own in `make validate` (`test_kills.py`, `test_result_fuzz.py`).
"""

from __future__ import annotations

import os
import resource
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from multiprocessing import get_context

import pytest

from tests.support import measured_files
from tests.support.mutation import counted, counted_files

CASES, PARTS, EVERY = 100_000, 40, 50
FILES = 20_000
MEMORY = 6 << 30
"""Address space of a process that tries edited models [bytes]: one that takes more ends in an exception."""
IN_PROCESS = ("csv", "mat", "plain.mat", "wav", "float.wav", "own.h5")
"""Other people's HDF5 is tried in a process of its own, half a second each: see `test_measured_fuzz.py`."""


def bound_memory() -> None:
    """Let the process have so much memory and no more."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


@pytest.mark.study
def test_edited_models():
    words: Counter[str] = Counter()
    first = {}
    count = partial(counted, cases=CASES // PARTS, every=EVERY)
    with ProcessPoolExecutor(os.cpu_count(), get_context("spawn"), initializer=bound_memory) as pool:
        for found, faults in pool.map(count, range(1000, 1000 + PARTS)):
            words += found
            first |= faults
    faults = {word: n for word, n in words.items() if word not in ("refused", "loaded", "computed")}
    assert not faults, first
    cases = words.total()
    assert cases == pytest.approx(CASES)
    raw_exceptions = sum(n for word, n in words.items() if word.startswith("raw"))
    assert raw_exceptions == pytest.approx(0)
    hangs = words["hang"]
    assert hangs == pytest.approx(0)
    numbers_without_a_status = sum(n for word, n in words.items() if word.startswith("number"))
    assert numbers_without_a_status == pytest.approx(0)
    assert words["refused"] > 0.5 * CASES and words["computed"] > 0.002 * CASES


@pytest.mark.study
def test_damaged_measured_files(tmp_path):
    good = {}
    for name in IN_PROCESS:
        measured_files.WRITERS[name](tmp_path / f"good.{name}")
        good[name] = (tmp_path / f"good.{name}").read_bytes()
    words = counted_files(7, FILES, good, tmp_path)
    faults = {word: n for word, n in words.items() if word not in ("refused", "loaded")}
    assert not faults
    cases = words.total()
    assert cases == pytest.approx(FILES)
    raw_exceptions = sum(n for word, n in words.items() if word.startswith("raw"))
    assert raw_exceptions == pytest.approx(0)
    hangs = words["hang"]
    assert hangs == pytest.approx(0)
    assert min(words["refused"], words["loaded"]) > 0.05 * FILES
