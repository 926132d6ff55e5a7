# SPDX-License-Identifier: Apache-2.0
"""User laws in Python, referenced in a model file as ``file.py:function``.

A law has the signature ``double f(double t, double x, double* p)``. It is compiled if possible and otherwise
called through the interpreter; it returns NaN after an exception, which the solver reports as a status. Code
referenced in a file runs only with the permission of the user.
"""

from __future__ import annotations

import importlib.util
import inspect
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError


@dataclass(frozen=True, eq=False)
class UserLaw:
    """User law with its parameters; holds references to both while their addresses are in use.

    Parameters
    ----------
    function
        Function of time or another first argument, a second argument, and the parameters.
    parameters
        Parameters p, float64, contiguous.
    source
        Reference to the law, for messages.
    """

    function: Callable[[float, float, Any], float]
    parameters: NDArray[np.float64]
    source: str

    def __call__(self, t: float, x: float) -> float:
        """Evaluate in Python; exceptions are not caught.

        Parameters
        ----------
        t
            First argument, usually the time [s].
        x
            Second argument, defined by the element.
        """
        return float(self.function(t, x, self.parameters))

    def address(self) -> int:
        """Address of the compiled law or callback, valid in this process while the object exists."""
        from pitchpoint.core.kernel import law_address

        return law_address(self.function)

    def diagnose(self, t: float, x: float) -> str:
        """Reason for a failure of the law at a point; an empty text if it does not fail.

        Parameters
        ----------
        t, x
            Arguments at which the computation stopped.
        """
        try:
            value = self(t, x)
        except KeyboardInterrupt:
            raise
        except BaseException as error:  # noqa: BLE001 - user code may raise any exception, also SystemExit
            return f"{self.source} raised {type(error).__name__}: {error}"
        return "" if math.isfinite(value) else f"{self.source} returned {value}"


def load_user_law(
    reference: str,
    folder: Path,
    *,
    allow_code: bool,
    parameters: Sequence[float] = (),
    appended: int = 0,
    where: str = "law",
) -> UserLaw:
    """Load a law from a Python file.

    Parameters
    ----------
    reference
        ``file.py:function``, relative to the folder of the model.
    folder
        Folder of the model file.
    allow_code
        False: nothing is imported, and a ModelError states how to permit it.
    parameters
        Parameters of the law.
    appended
        Number of values that the element appends to them, such as the rate of a spring.
    where
        Path of the key in the model, for messages.

    Raises
    ------
    ModelError
        If file or function cannot be used, or if the function uses more parameters than are given.
    """
    function = load_function(reference, folder, ("t", "x", "p"), allow_code=allow_code, where=where)
    law = UserLaw(function, np.ascontiguousarray(parameters, dtype=np.float64), reference)
    trial = UserLaw(function, np.append(law.parameters, np.zeros(appended)), reference)
    if not hasattr(function, "address") and trial.diagnose(0.0, 0.0).startswith(
        f"{reference} raised IndexError"
    ):
        # compiled laws do not check their indices: a missing parameter would be whatever follows in memory
        _refuse(
            where,
            reference,
            f"uses more than its {len(parameters)} parameters",
            "add the numbers: parameters: [...], in the order of the function",
        )
    return law


def load_function(
    reference: str, folder: Path, arguments: Sequence[str], *, allow_code: bool, where: str
) -> Callable[..., Any]:
    """Load a function from a Python file.

    Parameters
    ----------
    reference, folder
        As in `load_user_law`.
    arguments
        Names of the required arguments.
    allow_code, where
        As in `load_user_law`.
    """
    if not allow_code:
        _refuse(
            where,
            reference,
            "names Python code, which is not run unasked",
            "call with --allow-code if you trust it",
        )
    name, _, attribute = reference.rpartition(":")
    if not name.endswith(".py") or not attribute.isidentifier():
        _refuse(where, reference, "is not a reference to a function", "write file.py:function")
    path = Path(folder, name)
    if not path.is_file():
        _refuse(
            where,
            reference,
            f"names a file that does not exist: {path}",
            "give it relative to the model file",
        )
    module = _execute(path, where, reference)
    function: Any = getattr(module, attribute, None)
    if not callable(function):
        known = ", ".join(n for n, v in vars(module).items() if inspect.isfunction(v)) or "none"
        _refuse(where, reference, "names no function of that file", f"functions there: {known}")
    if not hasattr(function, "address") and len(_positional(function)) != len(arguments):
        _refuse(
            where,
            reference,
            f"does not take {_COUNT[len(arguments)]} arguments",
            f"define it as f({', '.join(arguments)})",
        )
    return function


_COUNT = {3: "three", 4: "four"}


def _execute(path: Path, where: str, reference: str) -> Any:
    """Execute the file as a module."""
    spec = importlib.util.spec_from_file_location(f"pitchpoint_user_{path.stem}", path)
    if spec is None or spec.loader is None:
        _refuse(where, reference, "cannot be imported", "check the file name")
    module = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except (Exception, SystemExit) as error:  # noqa: BLE001 - a user file may raise any exception, and exit
        _refuse(
            where,
            reference,
            f"fails while it is loaded: {type(error).__name__}: {error}",
            "run it with python",
        )
    return module


def _positional(function: Any) -> list[inspect.Parameter]:
    """Positional parameters of a function, compiled or not."""
    kinds = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    try:
        signature = inspect.signature(getattr(function, "py_func", function))
    except (TypeError, ValueError):
        return []
    return [p for p in signature.parameters.values() if p.kind in kinds]


def _refuse(where: str, value: str, message: str, remedy: str) -> NoReturn:
    raise ModelError([Message(where, message, value=value, remedy=remedy)])
