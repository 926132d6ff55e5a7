# SPDX-License-Identifier: Apache-2.0
"""Compilation of kernels, entry points and user laws through the public interface of Numba.

`kernel` imports this module on demand. For tested versions of Numba, `compiler.private_numba` replaces its
slow parts; ``PITCHPOINT_STOCK_NUMBA=1`` disables that. Both give the same results and store the machine code
of entry points in the same way, in separate folders.
"""

from __future__ import annotations

import ctypes
import math
import re
from collections.abc import Callable
from typing import Any

import numba
from llvmlite import binding
from numba import carray, cfunc, config, njit, typeof
from numba.extending import typeof_impl

from pitchpoint.core import kernel as door
from pitchpoint.core.compiler import machine_code
from pitchpoint.core.compiler.intrinsics import ENTRY, FLAGS, LAW, call_entry, call_law, pointer
from pitchpoint.core.notices import notice

TESTED = (0, 61), (0, 69)
"""Versions of Numba with which `compiler.private_numba` was tested: from the first to below the second."""


_ways: list[Any] = []
"""Selected private module or None, as the only item; empty before the selection."""


def private() -> Any:
    """Module for private interfaces of Numba; None if disabled or incompatible with the installed version."""
    if not _ways:
        _ways.append(None)
        reason = "" if machine_code.is_stock() else _misfit()
        if reason:
            _ways[:] = [None]
            notice(
                f"Numba {numba.__version__} {reason}: kernels compile through its public interface, "
                "which takes about three times as long"
            )
    return _ways[0]


def _misfit() -> str:
    """Select the private module if version and probe permit; returns the reason if not."""
    version = tuple(int(n) for n in re.findall(r"\d+", numba.__version__)[:2])
    low, high = TESTED
    if not low <= version < high:
        return f"is outside the tested range {low[0]}.{low[1]} to {high[0]}.{high[1] - 1}"
    try:
        from pitchpoint.core.compiler import private_numba

        _ways[:] = [private_numba]  # the probe itself compiles
        return "" if private_numba.probe() else "does not pass the probe"
    except Exception as found:
        return f"does not pass the probe ({type(found).__name__})"


@typeof_impl.register(door.Kernel)
def _type_of_kernel(kernel: door.Kernel, _: Any) -> Any:
    """Numba type of a kernel that another kernel calls."""
    return typeof(kernel.dispatcher)


@typeof_impl.register(door.Intrinsic)
def _type_of_intrinsic(found: door.Intrinsic, _: Any) -> Any:
    return private().intrinsic_type(found.__name__) if private() else typeof(_INTRINSICS[found.__name__])


# ------------------------------------------------------------------------------------- kernels and entries


def dispatcher(kernel: door.Kernel) -> Any:
    """Dispatcher of a kernel for calls from other kernels."""
    return private().dispatcher(kernel) if private() else njit(nogil=True, **FLAGS)(kernel.py_func)


def python_callable(kernel: door.Kernel) -> Any:
    """Dispatcher of a kernel for calls from Python."""
    return private().python_callable(kernel) if private() else njit(nogil=True, **FLAGS)(kernel.py_func)


def entry_address(kernel: door.Kernel) -> tuple[int, Any]:
    """Compile an entry point; returns its address, and an object that must be retained.

    The machine code is stored on disk if it does not need Numba at run time. Otherwise (exceptions,
    allocations) a callback of Numba is used, which every process compiles again.
    """
    source, name = kernel.py_func, machine_code.symbol(kernel.py_func)
    made = None
    if not config.BOUNDSCHECK and not machine_code.is_refused(source):
        try:
            if private():
                code, needs = private().standalone(source, name)
            else:
                made = cfunc(ENTRY, **FLAGS)(source)
                code, needs = _standalone(made, name)
            where = machine_code.link(name, code, needs) if code else None
        except Exception:  # an error of the kernel itself is raised again below
            where, code, needs = None, b"", []
        if where:
            machine_code.save(source, code, needs)
            return where, None
    made = made or cfunc(ENTRY, **FLAGS)(source)
    if not config.BOUNDSCHECK:
        machine_code.save(source, b"", [])  # the next process skips the attempt
    return int(made.address), made


def _standalone(made: Any, name: str) -> tuple[bytes, list[str]]:
    """Object file of a callback and its external symbols; empty if it needs Numba at run time.

    Numba's code has a branch to the interpreter for exceptions. LLVM removes it if no exception can occur and
    all code is visible: all functions except the callback itself are made internal to the module.
    """
    text = made.inspect_llvm()
    if "numba.dynamic.globals" in text:
        return b"", []
    module = binding.parse_assembly(text.replace(made.native_name, name))
    for each in (*module.functions, *module.global_variables):
        if not each.is_declaration and each.name != name:
            each.linkage = "internal"
    machine = binding.Target.from_triple(binding.get_process_triple()).create_target_machine(
        cpu=binding.get_host_cpu_name(),
        features=binding.get_host_cpu_features().flatten(),
        opt=3,
        codemodel="jitdefault",
        jit=True,
    )
    builder = binding.create_pass_builder(machine, binding.create_pipeline_tuning_options(speed_level=3))
    builder.getModulePassManager().run(module, builder)
    needs = machine_code.declared(module)
    return (b"", []) if machine_code.is_foreign(needs) else (machine.emit_object(module), needs)


# ------------------------------------------------------------------------------------------------------ laws


def law_callback(function: Any, plain: Callable[..., float]) -> Any:
    """Compile a user law; if the compilation fails, it is called as a Python function.

    Parameters
    ----------
    function
        The law.
    plain
        Python function of the law with exceptions caught.
    """
    try:
        return cfunc(LAW, **FLAGS)(_caught(function))
    except Exception:
        kind = ctypes.CFUNCTYPE(
            ctypes.c_double, ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_double)
        )
        return kind(plain)


def _caught(function: Any) -> Any:
    """Law that returns NaN after an exception, which would otherwise return zero in compiled code."""
    inner = njit(nogil=True, **FLAGS)(getattr(function, "py_func", function))

    def law(t, x, p):
        """The law, with NaN in place of an exception."""
        try:
            return float(inner(t, x, p))
        except Exception:
            return math.nan

    return law


# ------------------------------------------------------------------------------------------------ intrinsics


@njit(nogil=True, **FLAGS)
def _view(where, shape, dtype):
    return carray(pointer(where), shape, dtype)


@njit(nogil=True, **FLAGS)
def _call(where, a, b, c):
    return call_entry(where, a, b, c)


@njit(nogil=True, **FLAGS)
def _call_law(where, t, x, p):
    return call_law(where, t, x, p)


_INTRINSICS = {"view": _view, "call": _call, "call_law": _call_law}
