# SPDX-License-Identifier: Apache-2.0
"""Checks of what a program gives to a stepper or an export: model, scenario, lists of paths, numbers."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model.model import Model


def check_scenario(model: Any, scenario: Any) -> None:
    """Raise ModelError unless a scenario is a run over the time; compilation checks that it exists.

    Parameters
    ----------
    model
        The model.
    scenario
        Name of the scenario.
    """
    if not isinstance(model, Model):
        raise ModelError(
            [Message("model", "is not a model", repr(model)[:80], remedy="read it with pp.load_model")]
        )
    given = model.scenarios.get(scenario) if isinstance(scenario, str) else None
    if given is not None and given.kind != "time":
        listed = ", ".join(name for name, s in model.scenarios.items() if s.kind == "time") or "none"
        text = f"{scenario!r} is of the kind {given.kind}, not time"
        remedy = f"of that kind there are: {listed}"
        raise ModelError([Message(f"scenarios.{scenario}", text, remedy=remedy)])


def check_list(where: str, names: Iterable[str]) -> None:
    """Raise ModelError for a text in place of a list of texts.

    Parameters
    ----------
    where
        Name of the argument.
    names
        The list.
    """
    if isinstance(names, str):
        remedy = f"write {where}=[{names!r}]"
        raise ModelError([Message(where, "is a text, not a list of texts", repr(names[:80]), remedy=remedy)])


def number_problem(where: str, value: Any, unit: str) -> Message | None:
    """Problem of a value that is not a number.

    Parameters
    ----------
    where
        Name of the value.
    value
        The value.
    unit
        Its unit.

    Examples
    --------
    >>> print(number_problem("loads.motor.torque", "4 N m", "N m"))
    loads.motor.torque: '4 N m' is not a number; write the number in N m
    >>> print(number_problem("communication step", True, "s"))
    communication step: True is not a number; write the number in s
    """
    try:
        if not isinstance(value, str | bytes | bool | np.bool_):
            float(value)
            return None
    except (TypeError, ValueError, OverflowError):
        pass
    return Message(where, "is not a number", repr(value)[:80], remedy=f"write the number in {unit}")
