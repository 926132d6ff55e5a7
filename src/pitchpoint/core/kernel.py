# SPDX-License-Identifier: Apache-2.0
"""The one door to the compiler: decorator, cache stamp, raw views, calls through addresses.

Everything else in the package is plain Python. A kernel is an ordinary function marked with `kernel`; it
compiles at its first call, one machine-code file per signature, kept in the user's cache. Numba's own cache
looks only at the file of the function itself; the locator here stamps the *import closure* of that file, so
an edited helper is noticed and an unrelated edit is not. With ``NUMBA_DISABLE_JIT=1`` the same functions
run as plain Python.

Kernel modules import at the top, absolutely or relatively, and never conditionally: the stamp is a text scan.
"""

from __future__ import annotations

import ctypes
import hashlib
import math
import os
import sys
import types as pytypes
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from llvmlite import ir
from numba import cfunc, config, njit, types
from numba.core import cgutils
from numba.core.caching import CompileResultCacheImpl, FunctionCache, _CacheLocator
from numba.core.registry import CPUDispatcher
from numba.extending import intrinsic
from numba.np.arrayobj import populate_array

from pitchpoint.core.companion import announce, await_entry, delegate
from pitchpoint.core.import_closure import import_closure, register_package

__all__ = [
    "COMPILING",
    "address",
    "cache_folder",
    "call",
    "call_law",
    "import_closure",
    "invoke",
    "is_compiled",
    "kernel",
    "law_address",
    "prepare",
    "register_package",
    "view",
]

COMPILING = not config.DISABLE_JIT

_FLAGS: dict[str, Any] = {"error_model": "numpy", "fastmath": {"contract", "nsz"}}
_ENTRY = types.int64(types.int64, types.int64, types.int64)
_LAW = types.float64(types.float64, types.float64, types.CPointer(types.float64))
_F = TypeVar("_F", bound=Callable[..., Any])

# ---------------------------------------------------------------------------------------------- cache stamp

_STAMPS: dict[str, str] = {}


def _stamp(file: str) -> str:
    if file not in _STAMPS:
        # a set prints in another order in each process: its sorted members make the stamp
        fixed = (_FLAGS["error_model"], sorted(_FLAGS["fastmath"]))
        flags = (config.BOUNDSCHECK, config.OPT, config.DEBUG, fixed)
        digest = hashlib.sha256(repr(flags).encode())
        for path in import_closure(file):
            digest.update(path.name.encode() + path.read_bytes())
        _STAMPS[file] = digest.hexdigest()
    return _STAMPS[file]


def cache_folder() -> Path:
    """Folder of the compiled kernels: NUMBA_CACHE_DIR if set, else the user's cache."""
    if config.CACHE_DIR:
        return Path(config.CACHE_DIR)
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local"))
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"))
    return base / "pitchpoint" / "kernels"


class Locator(_CacheLocator):
    """Tells Numba where compiled kernels live and when they are out of date; serves marked functions only."""

    def __init__(self, py_func: Any, py_file: str) -> None:
        self._py_file = py_file
        self._lineno = py_func.__code__.co_firstlineno
        self._variant = py_func._pitchpoint
        mode = "bounds" if config.BOUNDSCHECK else "plain"
        self._path = str(cache_folder() / mode / self.get_suitable_cache_subpath(py_file))

    def get_cache_path(self) -> str:
        """Folder of the compiled files."""
        return self._path

    def get_source_stamp(self) -> str:
        """Hash of everything that the compiled code depends on."""
        return _stamp(self._py_file)

    def get_disambiguator(self) -> str:
        """Line of the function, which tells functions of one name apart."""
        return f"{self._lineno}{self._variant}"

    @classmethod
    def from_function(cls, py_func: Any, py_file: str) -> Locator | None:
        """Locator of a function marked by `kernel`; None for all others, which keep their own cache."""
        if not getattr(py_func, "_pitchpoint", None) or not os.path.exists(py_file):
            return None
        self = cls(py_func, py_file)
        try:
            self.ensure_cache_path()
        except OSError:
            return None
        return self


CompileResultCacheImpl._locator_classes = [Locator, *CompileResultCacheImpl._locator_classes]


# ------------------------------------------------------------------------------------ decorator and addresses


class Kernel(CPUDispatcher):
    """A compiled function that is cheap to compile for other kernels and still callable from Python.

    Calls from kernels need neither the Python nor the C wrapper, a quarter of the compile time; they share
    one compilation whether an argument is a constant or not. Python calls a twin that has a wrapper.
    """

    _outer: Any = None
    #: Whether the disk cache is still to be switched on: most kernels of a warm start never compile.
    cache_waits: bool = False

    def compile(self, sig: Any) -> Any:
        """Compile for a signature, or load what was compiled before."""
        if self.cache_waits:
            self.cache_waits = False
            self.enable_caching()
        return super().compile(sig)

    def __call__(self, *args: Any) -> Any:
        if self._outer is None:
            copy, cached = _twin(self, "p")
            self._outer = njit(cache=cached, nogil=True, **_FLAGS)(copy)
        return self._outer(*args)

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """Type a call from another kernel as if no argument were a constant."""
        plain = {name: types.unliteral(kind) for name, kind in kws.items()}
        return super().get_call_template(tuple(types.unliteral(kind) for kind in args), plain)


def kernel(function: Any = None, *, inline: bool = False) -> Any:
    """Compile a function at its first call, without the interpreter lock, cached on disk.

    Kernels take floats, integers and arrays, allocate nothing, raise nothing and return integer statuses.

    Parameters
    ----------
    function
        The function; left out in ``@kernel(inline=True)``.
    inline
        Put the body into every caller. An array travels as seven words and more, so a kernel with several
        arrays and one caller belongs there.
    """
    if function is None:
        return partial(kernel, inline=inline)
    if not COMPILING:
        return function
    function._pitchpoint = "k"
    options = {"nopython": True, "nogil": True, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    made = Kernel(py_func=function, targetoptions={**options, **_FLAGS, "forceinline": inline})
    made.cache_waits = os.path.exists(function.__code__.co_filename)
    return made


def _twin(function: Any, variant: str) -> tuple[Any, bool]:
    """Copy of a kernel's source function with its own cache name, so both compilations live side by side."""
    source = getattr(function, "py_func", function)
    copy = pytypes.FunctionType(
        source.__code__, source.__globals__, source.__name__, source.__defaults__, source.__closure__
    )
    copy.__qualname__, copy.__module__ = source.__qualname__, source.__module__
    copy._pitchpoint = variant  # type: ignore[attr-defined]
    return copy, os.path.exists(source.__code__.co_filename)


_COMPILED: dict[Any, Any] = {}
_TABLE: dict[int, Any] = {}


def address(entry: Any) -> int:
    """Address of a kind's ``int64 entry(int64 ctl, int64 records, int64 n)``, valid in this process only.

    Compiles (or loads) at the first request. Never store or pickle an address.
    """
    if not COMPILING:
        _TABLE[id(entry)] = entry
        return id(entry)
    if entry not in _COMPILED:
        await_entry(label(entry))
        copy, cached = _twin(entry, "c")
        _COMPILED[entry] = cfunc(_ENTRY, cache=cached, **_FLAGS)(copy)
    return int(_COMPILED[entry].address)


def label(entry: Any) -> str:
    """Name of an entry for another process: "module:function"."""
    return f"{entry.__module__}:{entry.__name__}"


def is_compiled(entry: Any) -> bool:
    """Whether the machine code of an entry is at hand: made in this process or kept in the cache."""
    if not COMPILING or entry in _COMPILED:
        return True
    copy, cached = _twin(entry, "c")
    return cached and bool(FunctionCache(copy)._cache_file._load_index())


def prepare(mine: Sequence[Any], theirs: Sequence[Any]) -> None:
    """Compile what the cache lacks of two lists of entries; `address` waits for those of the second.

    Parameters
    ----------
    mine
        Entries to compile here, before this returns.
    theirs
        Entries that a second process compiles meanwhile.
    """
    missing = [e for e in theirs if not is_compiled(e)]
    here = [e for e in mine if not is_compiled(e)]
    if missing or here:
        announce()
    if missing and here:
        delegate([label(e) for e in missing])
    for entry in here:
        address(entry)


def invoke(entry: Any, ctl: int, records: int, n: int) -> int:
    """Call an entry from Python, through the address that the drivers use.

    Parameters
    ----------
    entry
        The kernel.
    ctl, records, n
        Its three arguments: addresses and a number.

    Returns
    -------
    int
        Its status.
    """
    if not COMPILING:
        return int(entry(ctl, records, n))
    call_type = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_int64, ctypes.c_int64, ctypes.c_int64)
    return int(call_type(address(entry))(ctl, records, n))


def _guarded(function: Any) -> Any:
    """A plain Python law as a callback; an exception becomes NaN, which the solver's guard reports."""

    def law(t: float, x: float, p: Any) -> float:
        try:
            return float(function(t, x, p))
        except Exception as error:  # the callback boundary: nothing may pass it
            law.error = error  # type: ignore[attr-defined]
            return float("nan")

    return law


def _caught(function: Any) -> Any:
    """A law to compile; an exception raised in compiled code would otherwise return an unmarked zero."""
    inner = njit(nogil=True, **_FLAGS)(getattr(function, "py_func", function))

    def law(t, x, p):
        try:
            return float(inner(t, x, p))
        except Exception:
            return math.nan

    return law


def law_address(function: Any) -> int:
    """Address of a user law ``double f(double t, double x, double* p)``.

    Parameters
    ----------
    function
        A Python function (compiled if it can be, called back through the interpreter if not), an object with
        an `address` attribute, or an integer address from another library.

    Returns
    -------
    int
        Address for `call_law`, valid in this process only.
    """
    if isinstance(function, int):
        return function
    if COMPILING and isinstance(getattr(function, "address", None), int):
        return int(function.address)
    if not COMPILING:
        if function not in _COMPILED:
            _COMPILED[function] = _guarded(function)
        _TABLE[id(function)] = _COMPILED[function]
        return id(function)
    if function not in _COMPILED:
        try:
            _COMPILED[function] = cfunc(_LAW, **_FLAGS)(_caught(function))
        except Exception:  # whatever the compiler dislikes still runs as plain Python
            kind = ctypes.CFUNCTYPE(
                ctypes.c_double, ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_double)
            )
            _COMPILED[function] = kind(_guarded(function))
    made = _COMPILED[function]
    if hasattr(made, "address"):
        return int(made.address)
    return int(ctypes.cast(made, ctypes.c_void_p).value or 0)


if COMPILING:

    @intrinsic
    def view(typingctx, where, shape, dtype):
        """Array of the given final shape over memory that somebody else owns; no copy, no reference count."""
        n = len(shape) if isinstance(shape, types.BaseTuple) else 1
        form = types.UniTuple(types.int64, n) if isinstance(shape, types.BaseTuple) else types.int64
        made = types.Array(dtype.dtype, n, "C")

        def generate(context, builder, signature, args):
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
    def call(typingctx, where, a, b, c):
        """Call an entry through its address."""

        def generate(context, builder, signature, args):
            word = ir.IntType(64)
            function = builder.inttoptr(args[0], ir.FunctionType(word, [word] * 3).as_pointer())
            return builder.call(function, args[1:])

        return types.int64(*[types.int64] * 4), generate

    @intrinsic
    def call_law(typingctx, where, t, x, p):
        """Call a user law through its address; p is the address of its parameters."""

        def generate(context, builder, signature, args):
            real = ir.DoubleType()
            form = ir.FunctionType(real, [real, real, real.as_pointer()])
            function = builder.inttoptr(args[0], form.as_pointer())
            return builder.call(function, [args[1], args[2], builder.inttoptr(args[3], real.as_pointer())])

        return types.float64(types.int64, types.float64, types.float64, types.int64), generate

else:

    def view(where, shape, dtype):
        """Array of the given final shape over memory that somebody else owns; no copy."""
        shape = shape if isinstance(shape, tuple) else (shape,)
        dtype = np.dtype(dtype)
        size = int(np.prod(shape, dtype=np.int64)) * dtype.itemsize
        if size == 0 or where == 0:
            return np.zeros([0] * len(shape), dtype)
        raw = (ctypes.c_char * size).from_address(int(where))
        return np.frombuffer(raw, dtype).reshape(shape)

    def call(where, a, b, c):
        """Call an entry through its table key."""
        return _TABLE[int(where)](int(a), int(b), int(c))

    def call_law(where, t, x, p):
        """Call a user law through its table key."""
        pointer = ctypes.cast(int(p), ctypes.POINTER(ctypes.c_double))
        return float(_TABLE[int(where)](float(t), float(x), pointer))
