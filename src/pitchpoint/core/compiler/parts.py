# SPDX-License-Identifier: Apache-2.0
"""Kernels as parts of entry points: machine code is generated per entry point only.

Numba links, optimises and translates every function separately and again within each of its callers. A gear
pair has 200 kernels and eight entry points: per entry point this work takes 6 s instead of 16 s, and the code
called by address is as fast. A part has its own code and references to the parts that it calls. Parts are not
stored on disk: they would save no time in a first run and need ten times the space of the entry points.
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
    """Type of a kernel that is called by another kernel."""


models.register_default(PartType)(models.OpaqueModel)


@lower_constant(PartType)
def _no_address(context: Any, builder: Any, kind: PartType, value: Any) -> Any:
    """A kernel as a constant has no value; Numba would store the address of its Python object."""
    return context.get_dummy_value()


class Part(JITCodeLibrary):
    """Intermediate code of a kernel that other kernels call, neither optimised nor translated.

    Only entry points become machine code, with all their parts, so that each part is linked and optimised
    once per entry point and not once per call level.
    """

    def __init__(self, codegen: Any, name: str) -> None:
        super().__init__(codegen, name)
        self._shared_module: Any = None

    @property
    def called(self) -> list[Part]:
        """Parts that this part calls."""
        return [other for other in dict.fromkeys(self._linking_libraries) if isinstance(other, Part)]

    def _optimize_functions(self, ll_module: Any) -> None:
        ll_module.data_layout = self._codegen._data_layout

    def finalize(self) -> None:
        """Finalise the part; Numba functions that it calls, such as integer powers, are linked into it."""
        for other in dict.fromkeys(self._linking_libraries):
            if not isinstance(other, Part):
                self._final_module.link_in(other._get_module_for_linking(), preserve=True)
        for function in self._final_module.functions:
            if not function.is_declaration and function.linkage == binding.Linkage.external:
                function.linkage = "linkonce_odr"  # several callers in one entry point may include the part
        self._finalize_final_module()

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._finalized = True

    def _get_module_for_linking(self) -> Any:
        """Code of the part with all parts that it calls."""
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
    """Lower a kernel to a `Part`."""

    _name = "pitchpoint_part_lowering"

    def run_pass(self, state: Any) -> bool:
        """Lower a kernel and register the result for its callers."""
        state.library = Part(state.targetctx.codegen(), state.func_id.func_qualname)
        state.flags.no_compile = True
        super().run_pass(state)
        mark = _mark(state.cr.fndesc, state.cr.env, state.library)
        state.targetctx.insert_user_function(mark, state.cr.fndesc, [state.library])
        state.cr = state.cr._replace(cfunc=mark)
        return True


def _mark(described: Any, environment: Any, library: Part) -> Any:
    """Registration of a compiled part in Numba's tables; not callable."""
    name = described.qualname.rpartition(".")[2]
    return _dynfunc.make_function(described.lookup_module(), name, "part", 0, environment, (library,))


class PartCompiler(KernelCompiler):
    """Compile a kernel to a `Part`."""

    lowering = PartLowering
