# SPDX-License-Identifier: Apache-2.0
"""Kernels that only ever become machine code as parts of entries.

Numba links, optimises and translates every function by itself and again inside each of its callers. A pair of
gears has 200 kernels and eight entries: left to the entries, this work falls from 16 s to 6 s, and what runs
behind an address is as fast. A part holds its own code and knows the parts that it calls. It lives as long as
the process: kept on disk, parts saved nothing in a first run and took ten times the room of the entries.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from llvmlite import binding
from numba import _dynfunc, types
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler_machinery import register_pass
from numba.core.datamodel import models
from numba.core.imputils import lower_constant

from pitchpoint.core.compiler.passes import KernelCompiler, KernelLowering


class PartType(types.Dispatcher):
    """Type of a kernel inside kernels."""


models.register_default(PartType)(models.OpaqueModel)


@lower_constant(PartType)
def _no_address(context: Any, builder: Any, kind: PartType, value: Any) -> Any:
    """A kernel as a value is empty; Numba would write the address of its Python object."""
    return context.get_dummy_value()


class Part(JITCodeLibrary):
    """Code of a kernel that other kernels call: its own alone, neither optimised nor translated.

    Only what is called through an address becomes machine code, with all its parts, so each part passes the
    linker and the optimiser once per entry and not once per level of the calls above it.
    """

    def __init__(self, codegen: Any, name: str) -> None:
        super().__init__(codegen, name)
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
                function.linkage = "linkonce_odr"  # several callers in one entry may bring a part along
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
        state.library = Part(state.targetctx.codegen(), state.func_id.func_qualname)
        state.flags.no_compile = True
        super().run_pass(state)
        mark = _mark(state.cr.fndesc, state.cr.env, state.library)
        state.targetctx.insert_user_function(mark, state.cr.fndesc, [state.library])
        state.cr = state.cr._replace(cfunc=mark)
        return True


def _mark(described: Any, environment: Any, library: Part) -> Any:
    """Entry of a compiled part in Numba's tables; it cannot be called."""
    name = described.qualname.rpartition(".")[2]
    return _dynfunc.make_function(described.lookup_module(), name, "part", 0, environment, (library,))


class PartCompiler(KernelCompiler):
    """Compiles a kernel into a `Part`."""

    lowering = PartLowering
