# SPDX-License-Identifier: Apache-2.0
"""Compiler flags and intrinsics for calls by address, common to both Numba back ends."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

FLAGS: dict[str, Any] = {"error_model": "numpy", "fastmath": {"contract", "nsz"}}
ENTRY = types.int64(types.int64, types.int64, types.int64)
LAW = types.float64(types.float64, types.float64, types.CPointer(types.float64))


@intrinsic
def _pointer(typingctx, where):
    """Convert an address to a pointer."""

    def generate(context, builder, signature, args):
        """Machine code of the conversion."""
        return builder.inttoptr(args[0], context.get_value_type(types.voidptr))

    return types.voidptr(types.int64), generate


@intrinsic
def _call_entry(typingctx, where, a, b, c):
    """Call an entry point by its address."""

    def generate(context, builder, signature, args):
        """Machine code of a call of an entry point."""
        word = ir.IntType(64)
        function = builder.inttoptr(args[0], ir.FunctionType(word, [word] * 3).as_pointer())
        return builder.call(function, args[1:])

    return types.int64(*[types.int64] * 4), generate


@intrinsic
def _call_law(typingctx, where, t, x, p):
    """Call a user law by its address; p is the address of its parameters."""

    def generate(context, builder, signature, args):
        """Machine code of a call of a law."""
        real = ir.DoubleType()
        form = ir.FunctionType(real, [real, real, real.as_pointer()])
        function = builder.inttoptr(args[0], form.as_pointer())
        return builder.call(function, [args[1], args[2], builder.inttoptr(args[3], real.as_pointer())])

    return types.float64(types.int64, types.float64, types.float64, types.int64), generate


pointer: Any = _pointer
call_entry: Any = _call_entry
call_law: Any = _call_law
