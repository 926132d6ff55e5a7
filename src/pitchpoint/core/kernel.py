# SPDX-License-Identifier: Apache-2.0
"""The one door to the compiler: decorator, raw views, calls through addresses.

Everything else in the package is plain Python. A kernel is an ordinary function marked with `kernel`; it
compiles when it is first needed and is kept in the user's cache. What solvers call are *entries*, kernels of
three integers: the machine code of an entry comes from the cache without the compiler being imported. With
``NUMBA_DISABLE_JIT=1`` the same functions run as plain Python.

Kernel modules import at the top, absolutely or relatively, and never conditionally: the stamp of the cache is
a text scan.
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
    """A function that compiles when another kernel or Python calls it.

    Parameters
    ----------
    function
        The function.
    inline
        Whether its body goes into every caller.
    """

    def __init__(self, function: Any, inline: bool = False) -> None:
        self.py_func = function
        self.inline = inline
        update_wrapper(self, function)

    @cached_property
    def dispatcher(self) -> Any:
        """What represents this kernel inside other kernels."""
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
        """Compile with a wrapper for Python and call; solvers use `invoke`."""
        return self._python_callable(*args)

    def __reduce__(self) -> str:
        return str(self.__qualname__)  # type: ignore[attr-defined]


class Intrinsic:
    """Represents a function that exists only inside kernels."""

    def __init__(self, name: str) -> None:
        self.__name__ = name


def kernel(function: Any = None, *, inline: bool = False) -> Any:
    """Compile a function at its first call, without the interpreter lock, cached on disk.

    Kernels take floats, integers and arrays, allocate nothing, raise nothing and return integer statuses.

    Parameters
    ----------
    function
        The function; omitted in ``@kernel(inline=True)``.
    inline
        Put the body into every caller. An array travels as seven words and more, so a kernel with several
        arrays and one caller belongs there.
    """
    if function is None:
        return partial(kernel, inline=inline)
    return Kernel(function, inline) if COMPILING else function


def plain(function: Any) -> Any:
    """A kernel as plain Python, for a single call or for whole arrays; other functions as they are."""
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
    """Address of a kind's ``int64 entry(int64 ctl, int64 records, int64 n)``, valid in this process only.

    Loads the machine code, or compiles it, at the first request. Never store or pickle an address.
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


def label(entry: Any) -> str:
    """Name of an entry for another process: "module:function"."""
    return f"{entry.__module__}:{entry.__name__}"


def is_compiled(entry: Any) -> bool:
    """Whether the machine code of an entry is at hand: made in this process or kept in the cache."""
    if not COMPILING or entry in _addresses:
        return True
    file = machine_code.code_file(entry.py_func)
    return file is not None and file.exists()


def expect(entry: Any) -> None:
    """Let the next `prepare` compile an entry that will be needed soon, while others wait for their turn."""
    _expected.append(entry)


def prepare(mine: Sequence[Any], theirs: Sequence[Any]) -> None:
    """Compile what the cache lacks of two lists of entries; `address` waits for those of the second.

    Parameters
    ----------
    mine
        Entries to compile here, before this returns.
    theirs
        Entries that a second process compiles meanwhile, if the cache can carry them over.
    """
    missing = [e for e in theirs if not is_compiled(e)]
    here = [e for e in (*mine, *_expected) if not is_compiled(e)]
    _expected.clear()
    if missing or here:
        announce()
    if missing and here and machine_code.can_save():
        delegate([label(e) for e in missing])
    run_compiler(lambda: _compile(here, missing))


def _compile(here: Sequence[Any], there: list[Any]) -> None:
    """Compile what is for this process, then what the second process has not begun."""
    for entry in here:
        address(entry)
    # whoever is done first takes from the end of the list; the first one left is being compiled there
    while len(there) > 1:
        last = there.pop()
        if not is_compiled(last) and not all(is_compiled(e) for e in there):
            withdraw(label(last))
            address(last)


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

    Raises
    ------
    KeyboardInterrupt
        If the user stopped it while a law in plain Python ran.
    """
    if COMPILING:
        return invoke_address(address(entry), ctl, records, n)
    return _unless_stopped(int(entry(ctl, records, n)))


def invoke_address(where: int, ctl: int, records: int, n: int) -> int:
    """The same for the address of an entry.

    Parameters
    ----------
    where
        Address of a compiled entry.
    ctl, records, n
        Its three arguments.
    """
    return _unless_stopped(int(_ENTRY_CALL(where)(ctl, records, n)))


def _unless_stopped(status: int) -> int:
    """A status; or the Ctrl-C that came while plain laws ran."""
    if _stopped:
        raise _stopped.pop()
    return status


def _guarded(function: Any) -> Callable[..., float]:
    """A plain Python law as a callback; an exception becomes NaN, which the solver's guard reports."""

    def law(t: float, x: float, p: Any) -> float:
        """The law, with NaN in place of an exception; Ctrl-C is kept for `invoke`."""
        try:
            return float(function(t, x, p))
        except KeyboardInterrupt as stop:  # continues in `invoke`
            _stopped.append(stop)
        except BaseException:  # nothing may pass the boundary of a callback
            pass
        return float("nan")

    law.guarded = True  # type: ignore[attr-defined]
    return law


def _hear_callbacks() -> None:
    """Keep a Ctrl-C that Python acts upon before a law has begun or after it has ended, as it often does.

    It was pressed while compiled code ran, and the first instruction behind that is the first one of the
    callback, where nothing catches yet. ctypes then calls `sys.unraisablehook` and hands on a zero.
    """
    before = sys.unraisablehook
    if getattr(before, "hears_callbacks", False):
        return

    def hook(found: Any) -> None:
        """Keep Ctrl-C for `invoke`, hand on everything else."""
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
    with _lock:  # a second callback in its place would end the first one, whose address is in use
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
    #: Array of the given final shape over memory that somebody else owns: ``view(where, shape, dtype)``.
    view: Any = Intrinsic("view")
    #: Call of an entry through its address: ``call(where, a, b, c)``.
    call: Any = Intrinsic("call")
    #: Call of a user law through its address: ``call_law(where, t, x, p)``, p the address of its parameters.
    call_law: Any = Intrinsic("call_law")

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
