# SPDX-License-Identifier: Apache-2.0
"""Kernels that only ever become machine code as parts of entries.

Numba optimises and translates every function by itself and again inside each of its callers. A pair of gears
has 200 kernels and eight entries: left to the entries, this work falls from 16 s to 6 s, and what runs behind
an address is as fast.
"""

from __future__ import annotations

from typing import Any

from llvmlite import binding
from numba import _dynfunc, types
from numba.core.caching import CompileResultCacheImpl, FunctionCache
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, CompileResult, DefaultPassBuilder
from numba.core.compiler_machinery import register_pass
from numba.core.datamodel import models
from numba.core.imputils import lower_constant
from numba.core.typed_passes import NativeLowering


class PartType(types.Dispatcher):
    """Type of a kernel inside kernels."""


models.register_default(PartType)(models.OpaqueModel)


@lower_constant(PartType)
def _no_address(context: Any, builder: Any, kind: PartType, value: Any) -> Any:
    """Nothing stands for a kernel as a value; Numba would write the address of its Python object."""
    return context.get_dummy_value()


class Part(JITCodeLibrary):
    """Code of a kernel that other kernels call: with all that it calls, neither optimised nor translated.

    Only what is called through an address becomes machine code, with all its parts, so each part passes the
    optimiser once per entry and not once per level of the calls above it.
    """

    def _optimize_functions(self, ll_module: Any) -> None:
        ll_module.data_layout = self._codegen._data_layout

    def _optimize_final_module(self) -> None:
        pass

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._finalized = True

    def serialize_using_object_code(self) -> tuple[str, str, bytes]:
        """State for the cache: there is no object code, the intermediate code serves."""
        state: tuple[str, str, bytes] = self.serialize_using_bitcode()
        return state


@register_pass(mutates_CFG=True, analysis_only=False)
class PartLowering(NativeLowering):
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
    """What stands for a compiled part in Numba's tables; it cannot be called."""
    name = described.qualname.rpartition(".")[2]
    return _dynfunc.make_function(described.lookup_module(), name, "part", 0, environment, (library,))


class PartCompiler(CompilerBase):
    """Numba's usual passes with `PartLowering` at their end."""

    def define_pipelines(self) -> list[Any]:
        """List the passes."""
        passes = DefaultPassBuilder.define_nopython_pipeline(self.state)
        passes.passes = [(PartLowering if p is NativeLowering else p, text) for p, text in passes.passes]
        passes.finalize()
        return [passes]


class _PartCacheImpl(CompileResultCacheImpl):
    """Reads and writes parts; the code of other functions would be translated as it is read."""

    def rebuild(self, target_context: Any, payload: Any) -> CompileResult:
        """Compile result of what `reduce` wrote."""
        (name, _, code), described, environment, signature, *_, reload_init, _ = payload
        library = Part(target_context.codegen(), name)
        library._final_module = binding.parse_bitcode(code)
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
            reload_init=reload_init,
            referenced_envs=(),
        )


class PartCache(FunctionCache):
    """Cache of parts."""

    _impl_class = _PartCacheImpl
