# SPDX-License-Identifier: Apache-2.0
"""Short representation of frozen dataclasses with many fields."""

from __future__ import annotations

from dataclasses import MISSING, fields
from typing import Any


class ShortRepr:
    """Base class of dataclasses that are shown by the fields that differ from their defaults.

    Numbers have nine digits. Large parts, such as the outline of a tooth, are only named.

    Examples
    --------
    >>> from dataclasses import dataclass
    >>> @dataclass(frozen=True)
    ... class Circle(ShortRepr):
    ...     d: float
    ...     x: float = 0.0
    ...     y: float = 0.0
    >>> Circle(1.0 / 3.0, y=0.5)
    Circle(d=0.333333333, y=0.5)
    """

    def __init_subclass__(cls) -> None:
        """Set the representation, which the decorator `dataclass` then keeps."""
        cls.__repr__ = ShortRepr.__repr__  # type: ignore[method-assign]

    def __repr__(self) -> str:
        """Fields that differ from their defaults."""
        shown = []
        for field in fields(self):  # type: ignore[arg-type]
            value = getattr(self, field.name)
            default = field.default_factory() if field.default_factory is not MISSING else field.default
            if field.repr and (default is MISSING or value is not default and value != default):
                shown.append(f"{field.name}={_short(value)}")
        return f"{type(self).__name__}({', '.join(shown)})"


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.9g}"
    plain = value is None or isinstance(value, int | str | ShortRepr)
    return repr(value) if plain else f"{type(value).__name__}(...)"
