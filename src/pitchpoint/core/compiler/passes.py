# SPDX-License-Identifier: Apache-2.0
"""How a kernel becomes intermediate code: Numba's steps, without what only other functions need.

Numba writes a record of every pass, looks for closures, array expressions and objects whose references it has
to count, and finds out anew, at every operation of two numbers, which of a dozen rules serves it. Kernels
are short and many: all of that takes longer than their own code, which stays the same without it.
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

#: Passes for what kernels do not have: closures, `with`, literal arguments, overloads to inline, array
#: expressions; and annotations for people.
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
"""Types without references to count."""


class Passes(PassManager):
    """Runs passes and keeps no record of them."""

    def _runPass(self, index: int, pss: Any, internal_state: Any) -> None:
        pss.analysis = self._analysis
        pss.run_initialization(internal_state)
        pss.run_pass(internal_state)
        pss.run_finalizer(internal_state)


class Typing:
    """Numba's typing context, which remembers what built-in functions and operators return.

    Parameters
    ----------
    context
        The context.
    flags
        Name of the flags of a compilation.
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
        # which code serves a signature is kept with the function; others than kernels may have replaced it
        if found is None or func.get_impl_key(found) is not chosen:
            found = self._context.resolve_function_type(func, args, kws)
            if found is not None:
                self._known[key] = found, func.get_impl_key(found)
        return found

    def resolve_setitem(self, target: Any, index: Any, value: Any) -> Any:
        """Signature of writing an item."""
        form = self.resolve_value_type(operator.setitem)
        return self.resolve_function_type(form, (target, index, value), {})


class Lowering(Lower):
    """Writes the intermediate code of a kernel: numbers need no clean-up, except for debugging."""

    def _is_plain(self, name: str) -> bool:
        return not self.flags.debuginfo and isinstance(self.typeof(name), _PLAIN)

    def lower_inst(self, inst: Any) -> None:
        """Write one statement."""
        if isinstance(inst, ir.Del) and self._is_plain(inst.value):
            return
        if isinstance(inst, ir.Assign) and not isinstance(inst.value, ir.Arg) and not self.flags.debuginfo:
            name = inst.target.name
            self.storevar(self.lower_assign(self.typeof(name), inst), name)
        else:
            super().lower_inst(inst)

    def storevar(self, value: Any, name: str, argidx: int | None = None) -> None:
        """Give a variable its value."""
        if argidx is None and name not in self._singly_assigned_vars and self._is_plain(name):
            self._alloca_var(name, self.typeof(name))
            self.builder.store(value, self.getvar(name))
        else:
            super().storevar(value, name, argidx)

    def alloca_lltype(self, name: str, lltype: Any, datamodel: Any = None) -> Any:
        """Room for a variable."""
        if self.flags.debuginfo:
            return super().alloca_lltype(name, lltype, datamodel)
        return cgutils.alloca_once(self.builder, lltype, name=name, zfill=False)

    def lower_binop(self, resty: Any, expr: Any, op: Any) -> Any:
        """Write an operation; how two variables are served is known since their types are."""
        variables = expr.static_lhs is ir.UNDEFINED and expr.static_rhs is ir.UNDEFINED
        if op is not expr.fn or not variables:
            return super().lower_binop(resty, expr, op)
        return self._apply(op, (expr.lhs, expr.rhs), self.fndesc.calltypes[expr], resty)

    def lower_getitem(self, resty: Any, expr: Any, value: Any, index: Any, signature: Any) -> Any:
        """Write the reading of an item."""
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
    """Lowers a kernel."""

    _name = "pitchpoint_kernel_lowering"

    @property
    def lowering_class(self) -> Any:
        """What writes the intermediate code."""
        return Lowering


class KernelCompiler(CompilerBase):
    """Numba's compiler with the passes that kernels need."""

    lowering: Any = KernelLowering

    def __init__(self, typing: Any, target: Any, library: Any, *others: Any) -> None:
        super().__init__(typing, target, library, *others)
        self.state.typingctx = Typing(typing, self.state.flags.get_mangle_string())

    def define_pipelines(self) -> list[Any]:
        """List the passes."""
        passes = Passes("kernel")
        for each, text in DefaultPassBuilder.define_nopython_pipeline(self.state).passes:
            if each.__name__ not in _SKIPPED:
                passes.add_pass(self.lowering if each is NativeLowering else each, text)
        passes.finalize()
        return [passes]
