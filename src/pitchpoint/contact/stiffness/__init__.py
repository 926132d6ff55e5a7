# SPDX-License-Identifier: Apache-2.0
"""Mesh stiffness laws: one module per law with a function of the same name, from gear pair to description.

Model files reach a law through its class in `model.components.stiffness`. Importing this package does not
import the laws.
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
        Name of the law in model files, of its module in this package, and of the function in that module.

    Examples
    --------
    >>> law_function("constant")(None, mean=1.0e5).mean
    100000.0
    """
    found: Callable[..., Any] = getattr(import_module(f"{__name__}.{name}"), name)
    return found
