# SPDX-License-Identifier: Apache-2.0
"""Memory images: a relocated copy runs with the same bits, and foreign addresses are refused."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import CompileError
from pitchpoint.core.kernel import address, invoke_address
from pitchpoint.solvers.exported_run import export_run
from pitchpoint.solvers.sampling import RECORDER, new_recorder
from pitchpoint.system.compile import compile_model
from pitchpoint.system.image import memory_image
from tests.support.fmu_models import own_run, pair


def relocated(run):
    """Copy of the image at a new address, with the addresses of this process."""
    block = np.frombuffer(run.image.data, np.int64).copy()
    for offset in run.image.moved:
        block[offset // 8] += block.ctypes.data
    for offset, number in run.code:
        block[offset // 8] = address(run.entries[number])
    return block


@pytest.mark.parametrize("method", ["adams", "rk4", "generalized_alpha"])
def test_a_relocated_copy_has_the_bits_of_the_run(method):
    run = export_run(compile_model(pair(method), "steady"))
    want = own_run(method).advance(200, every=1).rows
    for _ in range(2):  # the image itself is not changed
        block = relocated(run)
        block[run.numbers["order_n"] // 8] = 200
        recorder = new_recorder(run.system.sizes["no"], every=1, rows=200, sums=None, events=0)
        record = np.zeros(1, RECORDER)
        record["every"], record["stride"], record["n_rows"] = 1, 1, 200
        record["columns"] = recorder.rows.shape[1]
        record["rows"], record["done"] = recorder.rows.ctypes.data, recorder.done.ctypes.data
        at = block.ctypes.data
        args = (at + run.numbers["ctl"], at + run.numbers["order"], record.ctypes.data)
        assert invoke_address(address(run.entries[0]), *args) == 1
        assert np.array_equal(recorder.rows.view(np.int64), want.view(np.int64))


def test_every_address_is_found():
    """Pointers of control record, machine record, tables; entry points of kinds and of the core."""
    run = export_run(compile_model(pair("adams"), "steady"))
    system, at = run.system, run.image.at
    for name in ("fr", "q", "v", "a", "R", "mach"):
        offset = system.workspace.ctl.dtype.fields[name][1]
        assert at["ctl"] + offset in run.image.moved
        assert np.frombuffer(run.image.data, np.int64)[(at["ctl"] + offset) // 8] == at[name]
    words = np.frombuffer(run.image.data, np.int64)
    assert not np.any((words >= 1 << 32) & (words < 1 << 47))  # no address is left
    kinds = [entry.__module__.rpartition(".")[2] for entry in run.entries]
    assert {"equal_steps", "requests", "residual", "gear_mesh", "torque"} <= set(kinds)


def test_an_address_of_something_else_is_refused():
    system = compile_model(pair("adams"), "steady")
    stranger = np.zeros(8)

    def make():
        """A copy whose torque has the address of a law outside."""
        copy = system.copy()
        copy.workspace  # noqa: B018 - made before the address is written
        copy.records["torque"]["law"][0] = stranger.ctypes.data
        return copy, {}

    with pytest.raises(CompileError, match=r"records\.torque\+\d+: the model refers to memory outside of it"):
        memory_image(make)
