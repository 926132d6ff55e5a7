# SPDX-License-Identifier: Apache-2.0
"""Compiler passes of kernels: Numba's pipeline without the passes that kernels do not need.

Numba records every pass, searches for closures, array expressions and reference-counted objects, and resolves
the overload of every binary operation again. Kernels are short and numerous: this takes longer than the
generation of their code, which is identical without it.
"""

from __future__ import annotations

import operator
from types import BuiltinFunctionType
from typing import Any

from numba import types
from numba.core import cgutils, ir
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import PassManager, register_pass
from numba.core.lowering import Lower
from numba.core.typed_passes import NativeLowering

#: Passes for features that kernels do not use: closures, `with`, literal arguments, inlined overloads, array
#: expressions; and annotations.
_SKIPPED = {
    "AnnotateTypes",
    "DumpParforDiagnostics",
    "FindLiterallyCalls",
    "IRProcessing",
    "InlineClosureLikes",
    "InlineInlinables",
    "InlineOverloads",
    "LiteralPropagationSubPipelinePass",
    "LiteralUnroll",
    "MakeFunctionToJitFunction",
    "NoPythonSupportedFeatureValidation",
    "NopythonRewrites",
    "RewriteDynamicRaises",
    "WithLifting",
}


_PLAIN = (types.Number, types.Boolean, types.Record)
"""Types without reference counting."""


class Passes(PassManager):
    """Pass manager without a record of the passes."""

    def _runPass(self, index: int, pss: Any, internal_state: Any) -> None:
        pss.analysis = self._analysis
        pss.run_initialization(internal_state)
        pss.run_pass(internal_state)
        pss.run_finalizer(internal_state)


class Typing:
    """Numba's typing context with a cache of the signatures of built-in functions and operators.

    Parameters
    ----------
    context
        Typing context of Numba.
    flags
        Key of the compiler flags.
    """

    _known: dict[Any, Any] = {}

    def __init__(self, context: Any, flags: str) -> None:
        self._context = context
        self._flags = flags

    def __getattr__(self, name: str) -> Any:
        return getattr(self._context, name)

    def resolve_function_type(self, func: Any, args: Any, kws: Any) -> Any:
        """Signature of a call."""
        if isinstance(func, BuiltinFunctionType):  # an operator
            func = self.resolve_value_type(func)
        if kws or not isinstance(func, types.Function):
            return self._context.resolve_function_type(func, args, kws)
        key = self._flags, func, args
        found, chosen = self._known.get(key, (None, None))
        # the implementation of a signature may have been replaced by code other than kernels
        if found is None or func.get_impl_key(found) is not chosen:
            found = self._context.resolve_function_type(func, args, kws)
            if found is not None:
                self._known[key] = found, func.get_impl_key(found)
        return found

    def resolve_setitem(self, target: Any, index: Any, value: Any) -> Any:
        """Signature of an item assignment."""
        form = self.resolve_value_type(operator.setitem)
        return self.resolve_function_type(form, (target, index, value), {})


class Lowering(Lower):
    """Lowering of a kernel to LLVM code, without clean-up of numeric variables (except for debugging)."""

    def _is_plain(self, name: str) -> bool:
        return not self.flags.debuginfo and isinstance(self.typeof(name), _PLAIN)

    def lower_inst(self, inst: Any) -> None:
        """Lower one statement."""
        if isinstance(inst, ir.Del) and self._is_plain(inst.value):
            return
        if isinstance(inst, ir.Assign) and not isinstance(inst.value, ir.Arg) and not self.flags.debuginfo:
            name = inst.target.name
            self.storevar(self.lower_assign(self.typeof(name), inst), name)
        else:
            super().lower_inst(inst)

    def storevar(self, value: Any, name: str, argidx: int | None = None) -> None:
        """Store the value of a variable."""
        if argidx is None and name not in self._singly_assigned_vars and self._is_plain(name):
            self._alloca_var(name, self.typeof(name))
            self.builder.store(value, self.getvar(name))
        else:
            super().storevar(value, name, argidx)

    def alloca_lltype(self, name: str, lltype: Any, datamodel: Any = None) -> Any:
        """Allocate a variable."""
        if self.flags.debuginfo:
            return super().alloca_lltype(name, lltype, datamodel)
        return cgutils.alloca_once(self.builder, lltype, name=name, zfill=False)

    def lower_binop(self, resty: Any, expr: Any, op: Any) -> Any:
        """Lower a binary operation; for two variables the types determine the implementation."""
        variables = expr.static_lhs is ir.UNDEFINED and expr.static_rhs is ir.UNDEFINED
        if op is not expr.fn or not variables:
            return super().lower_binop(resty, expr, op)
        return self._apply(op, (expr.lhs, expr.rhs), self.fndesc.calltypes[expr], resty)

    def lower_getitem(self, resty: Any, expr: Any, value: Any, index: Any, signature: Any) -> Any:
        """Lower the reading of an item."""
        return self._apply(operator.getitem, (value, index), signature, resty)

    def _apply(self, op: Any, variables: tuple[Any, ...], signature: Any, returned: Any) -> Any:
        values = [
            self.context.cast(self.builder, self.loadvar(each.name), self.typeof(each.name), needed)
            for each, needed in zip(variables, signature.args, strict=True)
        ]
        function = self.context.typing_context.resolve_value_type(op)
        made = self.context.get_function(function, signature)(self.builder, values)
        return self.context.cast(self.builder, made, signature.return_type, returned)


@register_pass(mutates_CFG=True, analysis_only=False)
class KernelLowering(NativeLowering):
    """Lowering pass of a kernel."""

    _name = "pitchpoint_kernel_lowering"

    @property
    def lowering_class(self) -> Any:
        """Class that generates the LLVM code."""
        return Lowering


class KernelCompiler(CompilerBase):
    """Numba's compiler with the passes that kernels need."""

    lowering: Any = KernelLowering

    def __init__(self, typing: Any, target: Any, library: Any, *others: Any) -> None:
        super().__init__(typing, target, library, *others)
        self.state.typingctx = Typing(typing, self.state.flags.get_mangle_string())

    def define_pipelines(self) -> list[Any]:
        """Pipeline of the passes."""
        passes = Passes("kernel")
        for each, text in DefaultPassBuilder.define_nopython_pipeline(self.state).passes:
            if each.__name__ not in _SKIPPED:
                passes.add_pass(self.lowering if each is NativeLowering else each, text)
        passes.finalize()
        return [passes]
