# SPDX-License-Identifier: Apache-2.0
"""Interface to the compiler: kernel decorator, memory views, calls by address.

This is the only module of the package that gives access to compiled code. A kernel is a function with the
decorator `kernel`; it is compiled at first use and stored in the user's cache. Solvers call *entry points*,
kernels with three integer arguments, whose machine code is loaded from the cache without importing the
compiler. With ``NUMBA_DISABLE_JIT=1`` the same functions run as Python code.

Kernel modules must have unconditional imports at the top, absolute or relative, because the cache stamp is
computed by a text scan.
"""

from __future__ import annotations

import ctypes
import os
import sys
import threading
from collections.abc import Callable, Sequence
from functools import cached_property, partial, update_wrapper
from typing import Any

import numpy as np

from pitchpoint.core.compiler import machine_code
from pitchpoint.core.compiler.interpreter import run_compiler
from pitchpoint.core.compiler.machine_code import cache_folder
from pitchpoint.core.compiler.second_process import announce, await_entry, delegate, withdraw
from pitchpoint.core.progress import report_step

__all__ = [
    "COMPILING",
    "Kernel",
    "address",
    "cache_folder",
    "call",
    "call_law",
    "expect",
    "invoke",
    "is_compiled",
    "kernel",
    "law_address",
    "prepare",
    "view",
]

COMPILING = os.environ.get("NUMBA_DISABLE_JIT", "0").strip() in ("", "0")


class Kernel:
    """Function that is compiled when another kernel or Python calls it.

    Parameters
    ----------
    function
        Python function.
    inline
        Whether it is inlined into every caller.
    """

    def __init__(self, function: Any, inline: bool = False) -> None:
        self.py_func = function
        self.inline = inline
        update_wrapper(self, function)

    @cached_property
    def dispatcher(self) -> Any:
        """Dispatcher for calls from other kernels."""
        from pitchpoint.core.compiler import public_numba

        return public_numba.dispatcher(self)

    @cached_property
    def _python_callable(self) -> Any:
        from pitchpoint.core.compiler import public_numba

        return public_numba.python_callable(self)

    @property
    def signatures(self) -> list[Any]:
        """Signatures compiled or loaded in this process for calls from other kernels."""
        return list(self.dispatcher.signatures) if "dispatcher" in vars(self) else []

    def __call__(self, *args: Any) -> Any:
        """Compile with a Python wrapper and call; solvers use `invoke`."""
        return self._python_callable(*args)

    def __reduce__(self) -> str:
        return str(self.__qualname__)  # type: ignore[attr-defined]


class Intrinsic:
    """Placeholder of a function that exists only in kernels."""

    def __init__(self, name: str) -> None:
        self.__name__ = name


def kernel(function: Any = None, *, inline: bool = False) -> Any:
    """Decorator: compile a function at its first call, without the interpreter lock, cached on disk.

    Arguments of kernels are floats, integers and arrays; kernels allocate no memory, raise no exceptions and
    return integer statuses.

    Parameters
    ----------
    function
        Python function; omitted in ``@kernel(inline=True)``.
    inline
        Inline the function into every caller. An array argument has seven words or more, so that this pays
        for a kernel with several arrays and one caller.
    """
    if function is None:
        return partial(kernel, inline=inline)
    return Kernel(function, inline) if COMPILING else function


def plain(function: Any) -> Any:
    """Python function of a kernel, for single calls or whole arrays; other functions unchanged."""
    return getattr(function, "py_func", function)


# ------------------------------------------------------------------------------------------------- addresses

_ENTRY_CALL = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_int64, ctypes.c_int64, ctypes.c_int64)

_lock = threading.RLock()
_addresses: dict[Any, int] = {}
_kept: list[Any] = []
_laws: dict[Any, Any] = {}
_expected: list[Any] = []
_stopped: list[KeyboardInterrupt] = []
_TABLE: dict[int, Any] = {}


def address(entry: Any) -> int:
    """Address of an entry point ``int64 entry(int64 ctl, int64 records, int64 n)``, for this process only.

    The first call loads or compiles the machine code. Never store or pickle an address.
    """
    if not COMPILING:
        _TABLE[id(entry)] = entry
        return id(entry)
    with _lock:
        if entry not in _addresses:
            await_entry(label(entry))
            where = machine_code.load(entry.py_func)
            if where is None:
                from pitchpoint.core.compiler import public_numba

                where, needed = run_compiler(lambda: public_numba.entry_address(entry))
                _kept.append(needed)
            _addresses[entry] = where
        return _addresses[entry]


def known_addresses() -> dict[int, Any]:
    """Entry points with an address in this process, by address."""
    with _lock:
        return {where: entry for entry, where in _addresses.items()}


def label(entry: Any) -> str:
    """Name of an entry point for another process, as module:function."""
    return f"{entry.__module__}:{entry.__name__}"


def is_compiled(entry: Any) -> bool:
    """Whether the machine code of an entry point is available: compiled in this process or in the cache."""
    if not COMPILING or entry in _addresses:
        return True
    file = machine_code.code_file(entry.py_func)
    return file is not None and file.exists()


def expect(entry: Any) -> None:
    """Schedule an entry point that will be needed soon for the next `prepare`."""
    _expected.append(entry)


def prepare(mine: Sequence[Any], theirs: Sequence[Any]) -> None:
    """Compile the entry points of two lists that are not in the cache, in two processes.

    Parameters
    ----------
    mine
        Entry points to compile in this process, before the function returns.
    theirs
        Entry points for a second process, if the cache is writable; `address` waits for them.
    """
    missing = [e for e in theirs if not is_compiled(e)]
    here = [e for e in (*mine, *_expected) if not is_compiled(e)]
    _expected.clear()
    if missing or here:
        announce(len(missing) + len(here))
    if missing and here and machine_code.can_save():
        delegate([label(e) for e in missing])
    run_compiler(lambda: _compile(here, missing))


def _compile(here: Sequence[Any], there: list[Any]) -> None:
    """Compile the entry points of this process, then those that the second process has not started."""
    every = [*here, *there]

    def report() -> None:
        """Report how many kernels both processes have completed."""
        report_step(f"compiling kernels, {sum(map(is_compiled, every))} of {len(every)} done")

    for entry in here:
        report()
        address(entry)
    # take from the end of the list; the second process works from its start
    while len(there) > 1:
        last = there.pop()
        if not is_compiled(last) and not all(is_compiled(e) for e in there):
            report()
            withdraw(label(last))
            address(last)


def invoke(entry: Any, ctl: int, records: int, n: int) -> int:
    """Call an entry point from Python by its address.

    Parameters
    ----------
    entry
        Kernel of the entry point.
    ctl, records, n
        Its arguments: two addresses and the number of records.

    Returns
    -------
    int
        Status of `pitchpoint.core.status`.

    Raises
    ------
    KeyboardInterrupt
        If the user interrupted a law that runs as Python code.
    """
    if COMPILING:
        return invoke_address(address(entry), ctl, records, n)
    return _unless_stopped(int(entry(ctl, records, n)))


def invoke_address(where: int, ctl: int, records: int, n: int) -> int:
    """Call an entry point at a given address.

    Parameters
    ----------
    where
        Address of a compiled entry point.
    ctl, records, n
        Its three arguments.
    """
    return _unless_stopped(int(_ENTRY_CALL(where)(ctl, records, n)))


def _unless_stopped(status: int) -> int:
    """Return a status, or raise a pending Ctrl-C from a law that runs as Python code."""
    if _stopped:
        raise _stopped.pop()
    return status


def _guarded(function: Any) -> Callable[..., float]:
    """Callback of a Python law; it returns NaN after an exception, which the solver reports."""

    def law(t: float, x: float, p: Any) -> float:
        """The law, with NaN in place of an exception; Ctrl-C is stored for `invoke`."""
        try:
            return float(function(t, x, p))
        except KeyboardInterrupt as stop:  # raised again in `invoke`
            _stopped.append(stop)
        except BaseException:  # no exception may leave a callback
            pass
        return float("nan")

    law.guarded = True  # type: ignore[attr-defined]
    return law


def _hear_callbacks() -> None:
    """Install a hook that stores a Ctrl-C raised at the start or end of a callback, outside its `try`.

    After Ctrl-C during compiled code, Python often raises the exception at the first instruction of the
    callback. ctypes then calls `sys.unraisablehook` and returns zero.
    """
    before = sys.unraisablehook
    if getattr(before, "hears_callbacks", False):
        return

    def hook(found: Any) -> None:
        """Store Ctrl-C for `invoke`; pass all other exceptions to the previous hook."""
        if issubclass(found.exc_type, KeyboardInterrupt) and getattr(found.object, "guarded", False):
            _stopped.append(KeyboardInterrupt())
        else:
            before(found)

    hook.hears_callbacks = True  # type: ignore[attr-defined]
    sys.unraisablehook = hook


def law_address(function: Any) -> int:
    """Address of a user law ``double f(double t, double x, double* p)``.

    Parameters
    ----------
    function
        Python function (compiled if possible, otherwise called through the interpreter), an object with an
        `address` attribute, or an integer address from another library.

    Returns
    -------
    int
        Address for `call_law`, valid in this process only.
    """
    if isinstance(function, int):
        return function
    if COMPILING and isinstance(getattr(function, "address", None), int):
        return int(function.address)
    with _lock:  # replacing a callback would free the first one, whose address is in use
        if function not in _laws:
            plain = _guarded(function)
            _hear_callbacks()
            if COMPILING:
                from pitchpoint.core.compiler import public_numba

                _laws[function] = public_numba.law_callback(function, plain)
            else:
                _laws[function] = plain
        made = _laws[function]
    if not COMPILING:
        _TABLE[id(function)] = made
        return id(function)
    if hasattr(made, "address"):
        return int(made.address)
    return int(ctypes.cast(made, ctypes.c_void_p).value or 0)


if COMPILING:
    #: Array of a given shape over external memory: ``view(where, shape, dtype)``.
    view: Any = Intrinsic("view")
    #: Call of an entry point by address: ``call(where, a, b, c)``.
    call: Any = Intrinsic("call")
    #: Call of a user law by address: ``call_law(where, t, x, p)``, p the address of its parameters.
    call_law: Any = Intrinsic("call_law")

else:

    def view(where, shape, dtype):
        """Array of a given shape over external memory, without copy."""
        shape = shape if isinstance(shape, tuple) else (shape,)
        dtype = np.dtype(dtype)
        size = int(np.prod(shape, dtype=np.int64)) * dtype.itemsize
        if size == 0 or where == 0:
            return np.zeros([0] * len(shape), dtype)
        raw = (ctypes.c_char * size).from_address(int(where))
        return np.frombuffer(raw, dtype).reshape(shape)

    def call(where, a, b, c):
        """Call an entry point by its table key."""
        return _TABLE[int(where)](int(a), int(b), int(c))

    def call_law(where, t, x, p):
        """Call a user law by its table key."""
        pointer = ctypes.cast(int(p), ctypes.POINTER(ctypes.c_double))
        return float(_TABLE[int(where)](float(t), float(x), pointer))
