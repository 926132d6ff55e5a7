# SPDX-License-Identifier: Apache-2.0
"""Faster compilation through private interfaces of Numba.

Used for the tested versions of Numba only, see `public_numba`. Decision 0025 has the measured times.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from llvmlite import binding, ir
from numba import njit, types
from numba.core import cgutils, sigutils
from numba.core.compiler_lock import global_compiler_lock
from numba.core.registry import CPUDispatcher, cpu_target
from numba.extending import intrinsic
from numba.np.arrayobj import populate_array

from pitchpoint.core import kernel as door
from pitchpoint.core.compiler import machine_code
from pitchpoint.core.compiler.cache import KernelCache
from pitchpoint.core.compiler.intrinsics import ENTRY, FLAGS, call_entry, call_law
from pitchpoint.core.compiler.parts import PartCompiler, PartType
from pitchpoint.core.compiler.passes import KernelCompiler

if TYPE_CHECKING:
    from pitchpoint.core.kernel import Kernel

_BARE = {"nopython": True, "nogil": True, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


class Dispatcher(CPUDispatcher):
    """Dispatcher of a kernel with a short compile time for calls from other kernels.

    Calls from kernels need neither the Python nor the C wrapper, which take a quarter of the compile time;
    calls with constant and variable arguments share one compilation.
    """

    @property
    def _numba_type_(self) -> PartType:
        return PartType(self)

    def compile(self, sig: Any) -> Any:
        """Compile for a signature, without the timers and caches of Numba."""
        with global_compiler_lock:
            args, returned = sigutils.normalize_signature(sig)
            if args not in self.overloads:
                self.add_overload(self._compiler.compile(args, returned))
            return self.overloads[args].entry_point

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """Type a call from another kernel without literal types of constant arguments."""
        plain = {name: types.unliteral(kind) for name, kind in kws.items()}
        return super().get_call_template(tuple(types.unliteral(kind) for kind in args), plain)


def dispatcher(kernel: Kernel) -> Dispatcher:
    """Dispatcher of a kernel for calls from other kernels."""
    options = {**_BARE, **FLAGS, "forceinline": kernel.inline}
    return Dispatcher(py_func=kernel.py_func, targetoptions=options, pipeline_class=PartCompiler)


def python_callable(kernel: Kernel) -> Any:
    """Dispatcher of a kernel for calls from Python: with a wrapper and the disk cache."""
    made = njit(nogil=True, **FLAGS)(kernel.py_func)
    with contextlib.suppress(RuntimeError):  # no usable cache folder
        made._cache = KernelCache(kernel.py_func)
    return made


# --------------------------------------------------------------------------------------------------- entries


@global_compiler_lock
def standalone(source: Any, name: str) -> tuple[bytes, list[str]]:
    """Object file of an entry point as a C function of three integers, and its external symbols.

    Empty if the code refers to Numba's run time or to this process, or can raise an exception, which requires
    the interpreter.

    Parameters
    ----------
    source
        Python function of the entry point.
    name
        Symbol of the C function.
    """
    library = open_library(source, name, KernelCompiler)
    library._optimize_final_module = _thorough(library)
    library.enable_object_caching()
    library.get_pointer_to_function(name)
    _, _, (code, bitcode) = library.serialize_using_object_code()
    final = binding.parse_bitcode(bitcode)
    needs = machine_code.declared(final)
    unfit = raises(final) or machine_code.is_foreign(needs) or library.has_dynamic_globals
    return (b"", []) if unfit else (code, needs)


def open_library(source: Any, name: str, compiler_class: Any) -> Any:
    """Library of a compiled entry point with its C function, neither optimised nor translated.

    Parameters
    ----------
    source
        Python function of the entry point.
    name
        Symbol of the C function.
    compiler_class
        Pipeline of the compiler.
    """
    options = {**_BARE, **FLAGS}
    compiler = Dispatcher(py_func=source, targetoptions=options, pipeline_class=compiler_class)._compiler
    customize = compiler._customize_flags

    def unfinished(flags: Any) -> Any:
        """Compiler flags that leave the library open."""
        flags = customize(flags)
        flags.no_compile = True  # the C function is added below
        return flags

    compiler._customize_flags = unfinished
    compiled = compiler.compile(ENTRY.args, ENTRY.return_type)
    compiled.library.add_ir_module(_c_function(name, compiled.fndesc))
    return compiled.library


def raises(module: Any) -> bool:
    """Whether a module contains exceptions."""
    return any(".picklebuf" in g.name for g in module.global_variables)


def _thorough(library: Any) -> Callable[[], None]:
    """Optimiser with a second pass if exceptions remain: unreachable ones may need two passes."""
    optimise = library._optimize_final_module

    def optimise_twice() -> None:
        """Optimise, and again if exceptions remain."""
        optimise()
        if raises(library._final_module):
            optimise()

    return optimise_twice


def _c_function(name: str, described: Any) -> ir.Module:
    """Module with the C function of a compiled entry point; it returns 0, "died", after an exception."""
    convention = cpu_target.target_context.call_conv
    module, word = ir.Module(name), ir.IntType(64)
    form = convention.get_function_type(described.restype, described.argtypes)
    inner = ir.Function(module, form, described.llvm_func_name)
    outer = ir.Function(module, ir.FunctionType(word, [word] * 3), name)
    builder = ir.IRBuilder(outer.append_basic_block("entry"))
    status, result = convention.call_function(
        builder, inner, described.restype, described.argtypes, outer.args
    )
    builder.ret(builder.select(status.is_ok, result, word(0)))
    return module


# ------------------------------------------------------------------------------------------------ intrinsics


@intrinsic
def _view(typingctx, where, shape, dtype):
    """Array of a given shape over external memory, without copy and reference counting."""
    n = len(shape) if isinstance(shape, types.BaseTuple) else 1
    form = types.UniTuple(types.int64, n) if isinstance(shape, types.BaseTuple) else types.int64
    made = types.Array(dtype.dtype, n, "C")

    def generate(context, builder, signature, args):
        """Machine code of a view: array from address and extents."""
        extents = cgutils.unpack_tuple(builder, args[1]) if form is not types.int64 else [args[1]]
        item = context.get_abi_sizeof(context.get_data_type(made.dtype))
        strides = [context.get_constant(types.intp, item)]
        for extent in reversed(extents[1:]):
            strides.insert(0, builder.mul(extent, strides[0]))
        array = context.make_array(made)(context, builder)
        data = builder.inttoptr(args[0], context.get_data_type(made.dtype).as_pointer())
        populate_array(array, data, extents, strides, strides[-1], None)
        return array._getvalue()

    return made(types.int64, form, dtype), generate


_INTRINSICS = {"view": _view, "call": call_entry, "call_law": call_law}


def intrinsic_type(name: str) -> Any:
    """Numba type of an intrinsic."""
    return cpu_target.typing_context.resolve_value_type(_INTRINSICS[name])


# ----------------------------------------------------------------------------------------------------- probe

_RECORD = np.dtype([("size", "f8"), ("table", "f8", (2, 2))], align=True)


@door.kernel
def _inner(one, k):
    """Kernel called by the probe: items, a power, a branch."""
    return one["table"][k, 1] + one["size"] ** 2 if k > 0 else 0.0


@door.kernel
def _probed(ctl, rec, n):
    """Entry point of the probe: a view, a loop, calls with and without constants."""
    record, total = door.view(rec, n, _RECORD), 0.0
    for k in range(n):
        total += _inner(record[k], k) + _inner(record[k], 1)
    return int(total)


def probe() -> bool:
    """Whether an entry point that is compiled and linked by this module returns the correct result."""
    record = np.zeros(2, _RECORD)
    record["size"], record["table"] = [3.0, 4.0], [[1.0, 2.0], [5.0, 7.0]]
    code, needs = standalone(_probed.py_func, "pitchpoint_probe")
    where = machine_code.link("pitchpoint_probe", code, needs) if code else None
    return where is not None and door.invoke_address(where, 0, record.ctypes.data, 2) == 16 + 2 * 23
