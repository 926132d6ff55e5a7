# SPDX-License-Identifier: Apache-2.0
"""Files of compiled kernels: every key has its own, whoever writes at the same time; others are not used."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import pytest

from pitchpoint.core.kernel import COMPILING

if COMPILING:
    from pitchpoint.core.compiler_cache import KernelFiles

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


KERNELS = """
import numpy as np
from pitchpoint.core.kernel import kernel, view
MASS = np.dtype([("value", "f8")], align=True)
SPRING = np.dtype([("rest", "f8"), ("value", "f8")], align=True)

@kernel
def value(one):
    return one["value"]

@kernel
def twice(one):
    return 2.0 * value(one)

@kernel
def mass(a, rec, n):
    return int(twice(view(rec, n, MASS)[0]))

@kernel
def spring(a, rec, n):
    return int(twice(view(rec, n, SPRING)[0]))
"""
ASK = """
import sys
import numpy as np
from pitchpoint.core.kernel import invoke
import kinds
for name in sys.argv[1:]:
    record = np.zeros(1, getattr(kinds, name.upper()))
    record["value"] = 21.0
    assert invoke(getattr(kinds, name), 0, record.ctypes.data, 1) == 42
for each in kinds.value, kinds.twice:
    print(*(f"{args[0].size}:{made.library.symbol}" for args, made in each.dispatcher.overloads.items()))
"""


@pytest.mark.slow
def test_parts_of_different_processes_fit_each_other(tmp_path):
    """Numba names code by numbers of records and by the order of a set, others in each process."""
    (tmp_path / "kinds.py").write_text(KERNELS)

    def ask(seed, cache, *order):
        """Names of the parts of a process with a cache of its own."""
        env = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / cache), "PYTHONPATH": str(tmp_path)}
        call = [sys.executable, "-c", ASK, *order]
        done = subprocess.run(call, env={**env, "PYTHONHASHSEED": seed}, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return sorted(done.stdout.split())

    # these two seeds print {"contract", "nsz"} in different orders
    names = ask("1", "first", "mass", "spring")
    assert len(names) == 4
    assert ask("5", "second", "spring", "mass") == names
    (folder,) = {f.parent.relative_to(tmp_path / "second") for f in (tmp_path / "second").rglob("*.nbc")}
    for file in (tmp_path / "second" / folder).glob("value*"):
        assert (tmp_path / "first" / folder / file.name).exists()
        shutil.copy(file, tmp_path / "first" / folder)
    shutil.rmtree(tmp_path / "first" / "entries")  # they are linked anew, of parts of both
    assert ask("1", "first", "mass", "spring") == names
