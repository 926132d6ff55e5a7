# SPDX-License-Identifier: Apache-2.0
"""Components that represent others of the model file, such as the body of a shaft, a planet of a stage or a
seat of the housing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

T = TypeVar("T")


def stands_in(part: Any) -> bool:
    """Whether a component represents one of another section and is not written to a file."""
    of_housing = getattr(part, "of_housing", False)
    return bool(getattr(part, "stands_in", of_housing)) or getattr(part, "stage", None) is not None


def path_of(stage: str) -> str:
    """Path of the planetary stage or the scissor gear that contains a component.

    Examples
    --------
    >>> path_of("set"), path_of("scissor_gears.free")
    ('planetary_stages.set', 'scissor_gears.free')
    """
    return stage if "." in stage else f"planetary_stages.{stage}"


def own_parts(parts: Mapping[str, T]) -> dict[str, T]:
    """Components of a section as given: without those that represent others, bearings without the seat in
    the housing, loads and scenarios without the values of the load case."""
    return {
        name: part if (given := getattr(part, "given", None)) is None else given
        for name, part in parts.items()
        if not stands_in(part)
    }
