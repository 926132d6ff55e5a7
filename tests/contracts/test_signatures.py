# SPDX-License-Identifier: Apache-2.0
"""Every kernel is compiled once: a second signature means that some array has another type or layout."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

# types are found and no code is made of them: that would take twice as long again
SIGNATURES = """
import importlib, sys
from numba.core.compiler import _LowerResult
from numba.core.funcdesc import PythonFunctionDescriptor
from numba.core.lowering import Environment
from pitchpoint.core import kernel as door
from pitchpoint.core.compiler import parts, private_numba, public_numba
from pitchpoint.core.compiler.interpreter import run_compiler
from pitchpoint.core.kernel import Kernel

def typed_only(self, state):
    flags, library = state.flags, state.targetctx.codegen().create_library(state.func_id.func_qualname)
    described = PythonFunctionDescriptor.from_specialized_function(
        state.func_ir, state.typemap, state.return_type, state.calltypes, mangler=state.targetctx.mangler,
        inline=flags.forceinline, noalias=flags.noalias, abi_tags=[flags.get_mangle_string()])
    environment = Environment.from_fndesc(described)
    mark = parts._mark(described, environment, library)
    state.targetctx.insert_user_function(mark, described, [library])
    state.library, state.cr = library, _LowerResult(described, None, cfunc=mark, env=environment)
    return True

parts.PartLowering.run_pass = typed_only
public_numba._ways[:] = [private_numba]  # the probe would need code
for entry in sys.argv[1:]:
    module, name = entry.split(":")
    found = getattr(importlib.import_module(module), name)
    run_compiler(lambda: found.dispatcher.compile(private_numba.ENTRY.args))
for name, module in list(sys.modules.items()):
    if name.startswith("pitchpoint.") and module is not door:
        for key, value in vars(module).items():
            if isinstance(value, Kernel) and value.py_func.__module__ == name:
                for signature in value.signatures:
                    print(name + "." + key, *(hash(a) if str(a) != "none" else "none" for a in signature))
"""

# all that a run of a driven pair with loads compiles: a mesh, a torque, the questions, the steps
ENTRIES = (
    "pitchpoint.elements.gear_mesh:entry",
    "pitchpoint.elements.torque:entry",
    "pitchpoint.system.requests:handle_request",
    "pitchpoint.solvers.implicit.generalized_alpha:entry",
)


@pytest.mark.slow
@pytest.mark.skipif(os.environ.get("NUMBA_DISABLE_JIT") == "1", reason="nothing is compiled")
def test_every_kernel_has_one_signature_but_for_arguments_left_out(tmp_path):
    """Compiled from nothing, as kernels are in every process."""
    done = subprocess.run(
        [sys.executable, "-c", SIGNATURES, *ENTRIES],
        env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    types = {}
    for line in done.stdout.splitlines():
        name, *signature = line.split()
        for k, argument in enumerate(signature):
            types.setdefault((name, k), set()).add(argument)
    assert len(types) > 300
    # parts of arrays of any record, too small to be compiled but into what asks for them
    small = {(f"pitchpoint.multibody.vectors.{name}", 0) for name in ("column", "triple")}
    several = {key: kinds for key, kinds in types.items() if len(kinds - {"none"}) > 1}
    assert set(several) <= small
