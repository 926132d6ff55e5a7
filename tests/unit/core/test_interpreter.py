# SPDX-License-Identifier: Apache-2.0
"""Compiling without collections, with room for frames, and kernels as parts of entries."""

from __future__ import annotations

import gc
import os
import subprocess
import sys

import pytest

from pitchpoint.core.compiler.interpreter import run_compiler
from pitchpoint.core.kernel import COMPILING


@pytest.mark.nojit
def test_collections_pause_while_something_compiles_and_go_on_afterwards():
    assert gc.isenabled()
    assert run_compiler(lambda: (gc.isenabled(), run_compiler(gc.isenabled))) == (False, False)
    assert gc.isenabled()
    with pytest.raises(KeyError):
        run_compiler(lambda: {}["absent"])
    assert gc.isenabled()


@pytest.mark.nojit
def test_who_switched_collections_off_finds_them_off():
    gc.disable()
    try:
        assert run_compiler(gc.isenabled) is False
        assert not gc.isenabled()
    finally:
        gc.enable()


@pytest.mark.nojit
def test_calls_can_be_as_deep_as_ever():
    def sink(k):
        return 0 if k == 0 else 1 + sink(k - 1)

    deep = sys.getrecursionlimit() // 2
    assert run_compiler(lambda: sink(deep)) == deep


HELPERS = """
import numpy as np
from pitchpoint.core.kernel import kernel

@kernel
def refuse(n):
    if n > 1:
        raise ValueError("too large")
    return n

@kernel
def total(n):
    return int(np.ones(n).sum())

@kernel
def double(n):
    return 2 * n

@kernel
def fourfold(n):
    return double(double(n))
"""
ENTRIES = """
from pitchpoint.core.kernel import kernel
from outsider.helper import double, fourfold, refuse, total

@kernel
def raising(a, b, n):
    return refuse(n)

@kernel
def allocating(a, b, n):
    return total(n)

@kernel
def fit(a, b, n):
    return fourfold(n) + double(a)
"""
CALL = """
from outsider.kind import allocating, fit, raising
from pitchpoint.core.compiler import machine_code, parts
from pitchpoint.core.kernel import invoke
from outsider import helper
print(*(invoke(f, 1, 0, n) for f, n in ((raising, 1), (raising, 2), (allocating, 7), (fit, 6))))
print(*(machine_code.is_refused(f.py_func) for f in (raising, allocating, fit)))
kernels = [helper.refuse, helper.total, helper.double, helper.fourfold]
print(*(isinstance(r.library, parts.Part) for k in kernels for r in k.dispatcher.overloads.values()))
"""


@pytest.mark.slow
@pytest.mark.skipif(not COMPILING, reason="needs the compiler")
def test_kernels_are_parts_of_entries_also_where_they_raise_or_allocate(tmp_path):
    """Entries that changed are compiled again, with the kernels that they call."""
    (tmp_path / "outsider").mkdir()
    (tmp_path / "outsider/__init__.py").touch()
    (tmp_path / "outsider/helper.py").write_text(HELPERS)
    for text in (ENTRIES, ENTRIES + "# changed"):
        (tmp_path / "outsider/kind.py").write_text(text)
        done = subprocess.run(
            [sys.executable, "-c", CALL],
            env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / "cache"), "PYTHONPATH": str(tmp_path)},
            capture_output=True,
            text=True,
        )
        assert done.stdout.split() == [
            "1",
            "0",
            "7",
            "26",
            "True",
            "True",
            "False",
            *["True"] * 4,
        ]
