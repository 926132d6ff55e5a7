# SPDX-License-Identifier: Apache-2.0
"""Files of compiled kernels: every key has its own, whoever writes at the same time; others are not used."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import pytest

from pitchpoint.core.kernel import COMPILING

if COMPILING:
    from pitchpoint.core.compiler.cache import KernelFiles

pytestmark = pytest.mark.skipif(not COMPILING, reason="needs the compiler")


def test_writers_at_the_same_time_do_not_mix_what_they_keep(tmp_path):
    """Numba's files fail here: two writers take the same number of a file for different signatures."""
    together = Barrier(8)

    def keep(key):
        """One process with a signature of its own."""
        files = KernelFiles(tmp_path, "solve", "stamp")
        together.wait()
        files.save(key, f"code of {key}")

    keys = [("float64", k) for k in range(8)]
    for _ in range(5):
        with ThreadPoolExecutor(8) as pool:
            list(pool.map(keep, keys))
        files = KernelFiles(tmp_path, "solve", "stamp")
        assert [files.load(key) for key in keys] == [f"code of {key}" for key in keys]
    assert len(list(tmp_path.iterdir())) == 8  # no drafts are left


def test_other_stamps_keys_and_damage_are_no_code(tmp_path):
    old = KernelFiles(tmp_path, "solve", "old")
    old.save("a", [1, 2])
    assert old.load("a") == [1, 2]
    assert old.load("b") is None
    new = KernelFiles(tmp_path, "solve", "new")
    assert new.load("a") is None
    new.save("a", [3])
    (file,) = tmp_path.iterdir()
    assert new.load("a") == [3]
    assert old.load("a") is None
    whole = file.read_bytes()
    for damaged in (b"", b"\n", whole[:-1], whole[:70], whole.replace(b"\n", b"\nx", 1)):
        file.write_bytes(damaged)
        assert new.load("a") is None
