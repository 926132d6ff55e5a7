# SPDX-License-Identifier: Apache-2.0
"""Kernels that only ever become machine code as parts of entries.

Numba links, optimises and translates every function by itself and again inside each of its callers. A pair of
gears has 200 kernels and eight entries: left to the entries, this work falls from 16 s to 6 s, and what runs
behind an address is as fast. A part holds its own code and knows the parts that it calls, in memory and on
disk.
"""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Iterator
from typing import Any

from llvmlite import binding
from numba import _dynfunc, types
from numba.core.caching import CompileResultCacheImpl
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompileResult
from numba.core.compiler_machinery import register_pass
from numba.core.datamodel import models
from numba.core.imputils import lower_constant

from pitchpoint.core import machine_code
from pitchpoint.core.compiler_cache import KernelCache
from pitchpoint.core.compiler_passes import KernelCompiler, KernelLowering


class PartType(types.Dispatcher):
    """Type of a kernel inside kernels."""


models.register_default(PartType)(models.OpaqueModel)


@lower_constant(PartType)
def _no_address(context: Any, builder: Any, kind: PartType, value: Any) -> Any:
    """Nothing stands for a kernel as a value; Numba would write the address of its Python object."""
    return context.get_dummy_value()


class Part(JITCodeLibrary):
    """Code of a kernel that other kernels call: its own alone, neither optimised nor translated.

    Only what is called through an address becomes machine code, with all its parts, so each part passes the
    linker and the optimiser once per entry and not once per level of the calls above it.
    """

    def __init__(self, codegen: Any, name: str, kernel: Any, args: tuple[Any, ...]) -> None:
        super().__init__(codegen, name)
        self.kernel = kernel
        self.args = args
        self.symbol = ""
        self._shared_module: Any = None

    @property
    def called(self) -> list[Part]:
        """The parts that this one calls."""
        return [other for other in dict.fromkeys(self._linking_libraries) if isinstance(other, Part)]

    def _optimize_functions(self, ll_module: Any) -> None:
        ll_module.data_layout = self._codegen._data_layout

    def finalize(self) -> None:
        """Close the part; code of Numba's own that it calls, such as a power of integers, goes into it."""
        for other in dict.fromkeys(self._linking_libraries):
            if not isinstance(other, Part):
                self._final_module.link_in(other._get_module_for_linking(), preserve=True)
        for function in self._final_module.functions:
            if not function.is_declaration and function.linkage == binding.Linkage.external:
                # Several callers in one entry may bring a part along. Names of Numba's own code tell it apart
                # in this process alone, and a part may come from another.
                function.linkage = "linkonce_odr" if function.name == self.symbol else "internal"
        self._finalize_final_module()

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._finalized = True

    def _get_module_for_linking(self) -> Any:
        """Code of the part with all that it calls."""
        if self._shared_module is None:
            whole = self._final_module.clone()
            for other in self._below({self}):
                whole.link_in(other._final_module, preserve=True)
            self._shared_module = whole
        return self._shared_module

    def _below(self, seen: set[Part]) -> Iterator[Part]:
        for other in self.called:
            if other not in seen:
                seen.add(other)
                yield other
                yield from other._below(seen)


@register_pass(mutates_CFG=True, analysis_only=False)
class PartLowering(KernelLowering):
    """Lowers a kernel into a `Part`."""

    _name = "pitchpoint_part_lowering"

    def run_pass(self, state: Any) -> bool:
        """Lower, and make the result known to the kernels that call it."""
        who, codegen = state.func_id, state.targetctx.codegen()
        state.library = Part(codegen, who.func_qualname, who.func.kernel, tuple(state.args))
        state.flags.no_compile = True
        super().run_pass(state)
        state.library.symbol = state.cr.fndesc.llvm_func_name
        mark = _mark(state.cr.fndesc, state.cr.env, state.library)
        state.targetctx.insert_user_function(mark, state.cr.fndesc, [state.library])
        state.cr = state.cr._replace(cfunc=mark)
        return True


def _mark(described: Any, environment: Any, library: Part) -> Any:
    """What stands for a compiled part in Numba's tables; it cannot be called."""
    name = described.qualname.rpartition(".")[2]
    return _dynfunc.make_function(described.lookup_module(), name, "part", 0, environment, (library,))


class PartCompiler(KernelCompiler):
    """Compiles a kernel into a `Part`."""

    lowering = PartLowering

    def _compile_bytecode(self) -> Any:
        """Compile under a name that is the same in every process: parts on disk refer to others by name."""
        who = self.state.func_id
        if not who.func.__closure__ and who.func.cached:
            text = f"{who.filename} {who.firstlineno} {machine_code.source_stamp(who.filename)}"
            who.unique_id = hashlib.sha256(text.encode()).hexdigest()[:16]
        return super()._compile_bytecode()


class _PartCacheImpl(CompileResultCacheImpl):
    """Reads and writes parts: each its own code, and by name those that it calls."""

    def __init__(self, py_func: Any) -> None:
        super().__init__(py_func)
        self.kernel = py_func.kernel

    def check_cachable(self, compiled: CompileResult) -> bool:
        """Whether a part and the way to all that it calls can be kept."""
        return super().check_cachable(compiled) and all(
            _is_reachable(other.kernel) for other in compiled.library.called
        )

    def reduce(self, compiled: CompileResult) -> Any:
        """What the cache keeps of a part."""
        described, library = compiled.fndesc, compiled.library
        described.typemap = described.calltypes = None  # large, and of use to the compiler only
        called = [(other.kernel, other.args, other.symbol) for other in library.called]
        code = library._final_module.as_bitcode()
        return library.name, code, called, described, compiled.environment, compiled.signature

    def rebuild(self, target_context: Any, payload: Any) -> CompileResult | None:
        """Compile result of what `reduce` wrote; None if what it calls has another name by now."""
        name, code, called, described, environment, signature = payload
        library = Part(target_context.codegen(), name, self.kernel, signature.args)
        library._final_module, library.symbol = binding.parse_bitcode(code), described.llvm_func_name
        for kernel, args, symbol in called:
            kernel.dispatcher.compile(args)
            other = kernel.dispatcher.overloads[args].library
            if other.symbol != symbol:  # LLVM ends the process over a name that nobody has
                return None
            library.add_linking_library(other)
        library._finalize_final_module()
        return CompileResult(
            target_context=target_context,
            typing_context=target_context.typing_context,
            library=library,
            environment=environment,
            entry_point=_mark(described, environment, library),
            fndesc=described,
            type_annotation="",
            signature=signature,
            objectmode=False,
            lifted=(),
            typing_error=None,
            call_helper=None,
            metadata=None,
            reload_init=(),
            referenced_envs=(),
        )


def _is_reachable(kernel: Any) -> bool:
    """Whether another process finds a kernel by its name."""
    found: Any = sys.modules.get(kernel.__module__)
    for name in kernel.__qualname__.split("."):
        found = getattr(found, name, None)
    return found is kernel


class PartCache(KernelCache):
    """Cache of parts."""

    _impl_class = _PartCacheImpl
