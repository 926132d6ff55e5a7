# SPDX-License-Identifier: Apache-2.0
"""Stiffness laws: each one small file with one function of the same name, from a gear pair to a description.

A law comes into model files by its class in `model.components.stiffness`. Importing this package imports none
of them.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any


def law_function(name: str) -> Callable[..., Any]:
    """Function of a stiffness law, ``function(pair, **options)``; imported on first use.

    Parameters
    ----------
    name
        Name in model files, of the module in this package, and of the function in it.

    Examples
    --------
    >>> law_function("constant")(None, mean=1.0e5).mean
    100000.0
    """
    found: Callable[..., Any] = getattr(import_module(f"{__name__}.{name}"), name)
    return found
