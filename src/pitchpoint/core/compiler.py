# SPDX-License-Identifier: Apache-2.0
"""Compiles kernels, entries and user laws with Numba. `kernel` imports it on demand."""

from __future__ import annotations

import ctypes
import math
import types as pytypes
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from llvmlite import binding, ir
from numba import cfunc, config, njit, types
from numba.core import cgutils, sigutils
from numba.core.ccallback import CFunc
from numba.core.compiler_lock import global_compiler_lock
from numba.core.registry import CPUDispatcher, cpu_target
from numba.extending import intrinsic
from numba.np.arrayobj import populate_array

from pitchpoint.core import machine_code
from pitchpoint.core.compiler_cache import FLAGS, KernelCache, Locator
from pitchpoint.core.compiler_parts import PartCache, PartCompiler, PartType
from pitchpoint.core.compiler_passes import KernelCompiler

if TYPE_CHECKING:
    from pitchpoint.core.kernel import Kernel

_BARE = {"nopython": True, "nogil": True, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
_ENTRY = types.int64(types.int64, types.int64, types.int64)
_LAW = types.float64(types.float64, types.float64, types.CPointer(types.float64))

# --------------------------------------------------------------------------------------------------- kernels


class Dispatcher(CPUDispatcher):
    """A compiled function that is cheap to compile for other kernels.

    Calls from kernels need neither the Python nor the C wrapper, a quarter of the compile time; they share
    one compilation whether an argument is a constant or not.
    """

    @property
    def _numba_type_(self) -> PartType:
        return PartType(self)

    def enable_caching(self) -> None:
        """Keep what is compiled on disk."""
        self._cache = PartCache(self.py_func)

    def compile(self, sig: Any) -> Any:
        """Compile for a signature, or load it; Numba's own way starts clocks that tell each other of all."""
        with global_compiler_lock:
            args, returned = sigutils.normalize_signature(sig)
            if args not in self.overloads:
                made = self._cache.load_overload(sig, self.targetctx)
                if made is None:
                    made = self._compiler.compile(args, returned)
                    self.add_overload(made)
                    self._cache.save_overload(sig, made)
                else:
                    self._cache_hits[sig] += 1
                    self.targetctx.insert_user_function(made.entry_point, made.fndesc, [made.library])
                    self.add_overload(made)
            return self.overloads[args].entry_point

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """Type a call from another kernel as if no argument were a constant."""
        plain = {name: types.unliteral(kind) for name, kind in kws.items()}
        return super().get_call_template(tuple(types.unliteral(kind) for kind in args), plain)


def dispatcher(kernel: Kernel) -> Dispatcher:
    """Make what stands for a kernel inside other kernels."""
    copy, cached = _twin(kernel.py_func, "k")
    copy.kernel, copy.cached = kernel, cached
    options = {**_BARE, **FLAGS, "forceinline": kernel.inline}
    made = Dispatcher(py_func=copy, targetoptions=options, pipeline_class=PartCompiler)
    if cached:
        made.enable_caching()
    return made


def python_callable(kernel: Kernel) -> Any:
    """Make what a call of a kernel from Python runs: a compilation with a wrapper."""
    copy, cached = _twin(kernel.py_func, "p")
    made = njit(nogil=True, **FLAGS)(copy)
    if cached:
        made._cache = KernelCache(copy)
    return made


def _twin(source: Any, variant: str) -> tuple[Any, bool]:
    """Copy of a function with its own cache name, so that several compilations live side by side.

    Second result: whether it can be cached. Where the folder cannot be written, Numba would turn to its own
    cache, which does not notice an edited helper, or refuse.
    """
    copy = pytypes.FunctionType(
        source.__code__, source.__globals__, source.__name__, source.__defaults__, source.__closure__
    )
    copy.__qualname__, copy.__module__ = source.__qualname__, source.__module__
    copy._pitchpoint = variant  # type: ignore[attr-defined]
    return copy, Locator.from_function(copy, source.__code__.co_filename) is not None


# --------------------------------------------------------------------------------------------------- entries


def entry_address(kernel: Kernel) -> tuple[int, Any]:
    """Compile an entry; its address, and what has to be kept for it.

    The machine code goes to disk if it can live without Numba. Otherwise (it may raise, it allocates, or this
    version of Numba hands its code out in another way) Numba's own callback and cache serve, from then on.
    """
    source, name = kernel.py_func, machine_code.symbol(kernel.py_func)
    if not config.BOUNDSCHECK and not machine_code.is_refused(source):
        try:
            with global_compiler_lock:
                code, needs = _standalone(source, name)
            where = machine_code.link(name, code, needs) if code else None
        except Exception:  # a fault of the kernel itself comes up again below
            where, code, needs = None, b"", []
        if where:
            machine_code.save(source, code, needs)
            return where, None
    copy, cached = _twin(source, "c")
    made: Any = CFunc(copy, (_ENTRY.args, _ENTRY.return_type), locals={}, options=FLAGS)
    if cached:
        made._cache = KernelCache(copy)
    made.compile()
    if not config.BOUNDSCHECK:
        machine_code.save(source, b"", [])  # the next process need not try
    return int(made.address), made


def _standalone(source: Any, name: str) -> tuple[bytes, list[str]]:
    """Object file with an entry as a C function of three integers, and the symbols that it expects.

    Empty if the code refers to Numba's run time, to this process, or can raise: such an exception must be
    reported, which needs the interpreter.
    """
    options = {**_BARE, **FLAGS}
    compiler = Dispatcher(py_func=source, targetoptions=options, pipeline_class=KernelCompiler)._compiler
    customize = compiler._customize_flags

    def unfinished(flags: Any) -> Any:
        """Flags of a compilation whose library stays open."""
        flags = customize(flags)
        flags.no_compile = True  # the library stays open for the function below
        return flags

    compiler._customize_flags = unfinished
    compiled = compiler.compile(_ENTRY.args, _ENTRY.return_type)
    library, described = compiled.library, compiled.fndesc
    library.add_ir_module(_c_function(name, described))
    library._optimize_final_module = _thorough(library)
    library.enable_object_caching()
    library.get_pointer_to_function(name)
    _, _, (code, bitcode) = library.serialize_using_object_code()
    final = binding.parse_bitcode(bitcode)
    needs = [f.name for f in final.functions if f.is_declaration and not f.name.startswith("llvm.")]
    needs += [g.name for g in final.global_variables if g.is_declaration]
    raises = _raises(final)
    foreign = any(n.startswith(("NRT_", "numba_", "_Py", "Py")) for n in {*needs} - {machine_code.UNREACHED})
    return (b"", []) if raises or foreign or library.has_dynamic_globals else (code, needs)


def _raises(module: Any) -> bool:
    """Whether code holds exceptions."""
    return any(".picklebuf" in g.name for g in module.global_variables)


def _thorough(library: Any) -> Callable[[], None]:
    """Optimise again if exceptions are left: those that never happen can need a second look."""
    optimise = library._optimize_final_module

    def optimise_twice() -> None:
        """Optimise, and once more if exceptions are left."""
        optimise()
        if _raises(library._final_module):
            optimise()

    return optimise_twice


def _c_function(name: str, described: Any) -> ir.Module:
    """Module with the C function of a compiled entry; what ends by an exception returns 0, "died"."""
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


# ------------------------------------------------------------------------------------------------------ laws


def law_callback(function: Any, plain: Callable[..., float]) -> Any:
    """Compile a user law; whatever the compiler dislikes is called back as plain Python.

    Parameters
    ----------
    function
        The law.
    plain
        The same for the interpreter, with exceptions caught.
    """
    try:
        return cfunc(_LAW, **FLAGS)(_caught(function))
    except Exception:
        kind = ctypes.CFUNCTYPE(
            ctypes.c_double, ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_double)
        )
        return kind(plain)


def _caught(function: Any) -> Any:
    """A law to compile; an exception raised in compiled code would otherwise return an unmarked zero."""
    inner = njit(nogil=True, **FLAGS)(getattr(function, "py_func", function))

    def law(t, x, p):
        """The law, with NaN in place of an exception."""
        try:
            return float(inner(t, x, p))
        except Exception:
            return math.nan

    return law


# ------------------------------------------------------------------------------------------------ intrinsics


@intrinsic
def _view(typingctx, where, shape, dtype):
    """Array of the given final shape over memory that somebody else owns; no copy, no reference count."""
    n = len(shape) if isinstance(shape, types.BaseTuple) else 1
    form = types.UniTuple(types.int64, n) if isinstance(shape, types.BaseTuple) else types.int64
    made = types.Array(dtype.dtype, n, "C")

    def generate(context, builder, signature, args):
        """Machine code of a view: extents and address become an array."""
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


@intrinsic
def _call(typingctx, where, a, b, c):
    """Call an entry through its address."""

    def generate(context, builder, signature, args):
        """Machine code of a call to an entry."""
        word = ir.IntType(64)
        function = builder.inttoptr(args[0], ir.FunctionType(word, [word] * 3).as_pointer())
        return builder.call(function, args[1:])

    return types.int64(*[types.int64] * 4), generate


@intrinsic
def _call_law(typingctx, where, t, x, p):
    """Call a user law through its address; p is the address of its parameters."""

    def generate(context, builder, signature, args):
        """Machine code of a call to a law."""
        real = ir.DoubleType()
        form = ir.FunctionType(real, [real, real, real.as_pointer()])
        function = builder.inttoptr(args[0], form.as_pointer())
        return builder.call(function, [args[1], args[2], builder.inttoptr(args[3], real.as_pointer())])

    return types.float64(types.int64, types.float64, types.float64, types.int64), generate


_INTRINSICS = {"view": _view, "call": _call, "call_law": _call_law}


def intrinsic_type(name: str) -> Any:
    """Numba's type of an intrinsic."""
    return cpu_target.typing_context.resolve_value_type(_INTRINSICS[name])
