# SPDX-License-Identifier: Apache-2.0
"""Object code of entry points for other processors and systems, with the results of our own run bit by bit.

The intermediate code of an entry point is optimised in the same sequence as for this process, so that
functions are inlined and products are fused with sums in the same places. It is stored in the cache of
compiled kernels and translated for a target at every export. Decision 0052 has the measured deviations of
other ways.
"""

from __future__ import annotations

import re
import zlib
from functools import cache, lru_cache
from typing import Any

from llvmlite import binding as llvm
from numba.core import codegen, config
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler_lock import global_compiler_lock
from numba.core.compiler_machinery import register_pass

from pitchpoint.core.compiler import machine_code, private_numba, public_numba
from pitchpoint.core.compiler.interpreter import run_compiler
from pitchpoint.core.compiler.passes import KernelCompiler, KernelLowering
from pitchpoint.core.errors import PitchpointError

_HEAD = b"pitchpoint intermediate code 1"
#: Target for which the code is optimised; its instructions decide where products are fused with sums.
WIDE = "x86_64-unknown-linux-gnu", "x86-64-v3"
#: WebAssembly has code of its own, as its addresses have 4 bytes.
NARROW = "wasm32-unknown-wasi", "generic"
_ENDINGS = {WIDE: ".portable", NARROW: ".wasm"}

#: Decrement of a reference count with an intrinsic of one processor, and the test of its result for zero.
_DECREMENT = re.compile(
    r"%(\w+) = call i8 @llvm\.x86\.atomic\.sub\.cc\.i64\(ptr (\S+), i64 1, i32 4\)\n"
    r"\s*%(\w+) = trunc i8 %\1 to i1"
)
_COUNTS = re.compile(r"^define [^\n]*@(NRT_(?:incref|decref))\([^\n]*\{\n.*?^\}$", re.MULTILINE | re.DOTALL)
_TARGET = re.compile(r"^target (triple|datalayout) = .*$", re.MULTILINE)


class _Whole(JITCodeLibrary):
    """Library that is neither optimised by function (with assumptions on pointers) nor translated."""

    def _optimize_functions(self, ll_module: Any) -> None:
        ll_module.data_layout = self._codegen._data_layout

    def _optimize_final_module(self) -> None:
        return

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._finalized = True


@register_pass(mutates_CFG=True, analysis_only=False)
class _WholeLowering(KernelLowering):
    """Lower a kernel to a `_Whole`."""

    _name = "pitchpoint_whole_lowering"

    def run_pass(self, state: Any) -> bool:
        """Lower a kernel."""
        state.library = _Whole(state.targetctx.codegen(), state.func_id.func_qualname)
        return bool(super().run_pass(state))


class _WholeCompiler(KernelCompiler):
    """Compile a kernel to a `_Whole`."""

    lowering = _WholeLowering


@cache
def machine(triple: str, processor: str) -> Any:
    """Target machine of LLVM for position-independent code.

    Parameters
    ----------
    triple
        Target, such as "x86_64-unknown-linux-gnu".
    processor
        Name of the processor, such as "x86-64-v3".
    """
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    model = "small" if triple.startswith("wasm") else "default"
    return llvm.Target.from_triple(triple).create_target_machine(
        cpu=processor, opt=3, reloc="pic", codemodel=model
    )


def intermediate_code(entry: Any, optimised_for: tuple[str, str] = WIDE) -> bytes | None:
    """Optimised bitcode of an entry point with its `machine_code.symbol`; from the cache if it is there.

    None if the code needs Numba or the interpreter at run time (exceptions, allocations).

    Parameters
    ----------
    entry
        Kernel of the entry point.
    optimised_for
        WIDE for all targets with addresses of 8 bytes, NARROW for WebAssembly.

    Raises
    ------
    PitchpointError
        If kernels compile through the public interface of Numba alone.
    """
    source = entry.py_func
    stored = _read(source, _ENDINGS[optimised_for])
    if stored is None:
        if public_numba.private() is None:
            raise PitchpointError(
                "object code for other programs needs the fast compilation of kernels, which is switched off "
                "or not tested with this version of Numba; unset PITCHPOINT_STOCK_NUMBA, or install a tested "
                "version"
            )
        stored = run_compiler(lambda: _compile(source, optimised_for))
        _save(source, _ENDINGS[optimised_for], stored)
    return stored or None


@global_compiler_lock
def _compile(source: Any, optimised_for: tuple[str, str]) -> bytes:
    """Bitcode of an entry point; empty if it is not self-contained."""
    name = machine_code.symbol(source)
    library = private_numba.open_library(source, name, _WholeCompiler)
    library.finalize()
    text = str(library._final_module)
    target = machine(*optimised_for)
    module = _optimised(_parsed(_portable_counts(text), target, optimised_for[0]), target)
    unfit = private_numba.raises(module) or library.has_dynamic_globals
    module = llvm.parse_assembly(_without_counts(str(module)))
    for each in (*module.functions, *module.global_variables):
        if not each.is_declaration and each.name != name:
            each.linkage = "internal"
    _manager(target, 0, dead_code=True)(module)
    unfit = unfit or machine_code.is_foreign(machine_code.declared(module))
    return b"" if unfit else bytes(module.as_bitcode())


def _parsed(text: str, target: Any, triple: str) -> Any:
    module = llvm.parse_assembly(_TARGET.sub("", text))
    module.triple, module.data_layout = triple, str(target.target_data)
    return module


def _optimised(module: Any, target: Any) -> Any:
    """The module after Numba's two pipelines, and again if exceptions remain (`private_numba.standalone`)."""
    for _ in range(2):
        _manager(target, 0, cheap=True)(module)
        _manager(target, 3)(module)
        if not private_numba.raises(module):
            break
    return module


def _manager(target: Any, level: int, *, cheap: bool = False, dead_code: bool = False) -> Any:
    """Function that optimises a module as Numba does (`CPUCodegen._module_pass_manager`)."""
    options = llvm.create_pipeline_tuning_options(speed_level=level)
    options.loop_vectorization = bool(level and config.LOOP_VECTORIZE)
    options.slp_vectorization = bool(level and config.SLP_VECTORIZE)
    builder = llvm.create_pass_builder(target, options)
    manager = builder.getModulePassManager()
    if cheap:
        manager.add_loop_rotate_pass()
        manager.add_instruction_combine_pass()
        manager.add_jump_threading_pass()
    if dead_code:
        manager.add_global_dead_code_eliminate_pass()
    elif config.LLVM_REFPRUNE_PASS:
        manager.add_refprune_pass(codegen._parse_refprune_flags())
    return lambda module: manager.run(module, builder)


def _portable_counts(text: str) -> str:
    """Code whose reference counts use no intrinsic of one processor; its functions keep their sizes."""
    return _DECREMENT.sub(r"%\1 = atomicrmw sub ptr \2, i64 1 monotonic\n  %\3 = icmp eq i64 %\1, 1", text)


def _without_counts(text: str) -> str:
    """Optimised code whose reference counts do nothing, as views own no memory.

    Before the optimisation this would change the inlining, and with it the fusing of products and sums.
    """
    body = r"define internal void @\1(ptr %p) alwaysinline nounwind {\n  ret void\n}"
    return _COUNTS.sub(body, text)


# ----------------------------------------------------------------------------------------------- object code


@lru_cache(maxsize=64)
def object_of_entry(bitcode: bytes, triple: str, processor: str) -> bytes:
    """Object file of an entry point for a target.

    Its symbol is hidden: libraries of two models in one process do not call the entry points of each other.

    Parameters
    ----------
    bitcode
        From `intermediate_code`.
    triple, processor
        Target, see `machine`.
    """
    module = llvm.parse_bitcode(bitcode)
    target = machine(triple, processor)
    for function in module.functions:
        if not function.is_declaration and function.linkage == llvm.Linkage.external:
            function.visibility = "hidden"
    module.triple, module.data_layout = triple, str(target.target_data)
    return bytes(target.emit_object(module))


@lru_cache(maxsize=16)
def object_of_text(text: str, triple: str, processor: str) -> bytes:
    """Object file of a module in LLVM text, such as data or functions translated from C.

    Parameters
    ----------
    text
        Module.
    triple, processor
        Target, see `machine`.
    """
    target = machine(triple, processor)
    module = _parsed(text, target, triple)
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    builder = llvm.create_pass_builder(target, options)
    builder.getModulePassManager().run(module, builder)
    return bytes(target.emit_object(module))


def external_symbols(bitcode: bytes) -> list[str]:
    """External symbols of the bitcode of an entry point, such as `sin`."""
    return machine_code.declared(llvm.parse_bitcode(bitcode))


# ----------------------------------------------------------------------------------------------------- cache


def _read(source: Any, ending: str) -> bytes | None:
    """Stored bitcode of an entry point, empty if it is not self-contained; None without a valid file."""
    file = machine_code.code_file(source)
    body = machine_code.contents(file.with_suffix(ending), _HEAD) if file else None
    return None if body is None else zlib.decompress(body)


def _save(source: Any, ending: str, bitcode: bytes) -> None:
    """Store the bitcode of an entry point."""
    file = machine_code.code_file(source)
    if file is not None:
        machine_code.store(source, file.with_suffix(ending), _HEAD, zlib.compress(bitcode))
