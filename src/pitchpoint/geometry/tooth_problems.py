# SPDX-License-Identifier: Apache-2.0
"""Checks common to cylindrical and bevel gears: limits and messages.

`problems` and `bevel.problems` supply values and remedies. No check raises: a loader lists all problems.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from pitchpoint.core.errors import GeometryError, Message

TIP_THICKNESS_LIMIT = 0.2
"""Minimum tip thickness of design practice in normal modules: thinner tips may harden through or break."""
Found = tuple[str, str, str, str | None, str]
"""Key, message, value, limit and remedy."""


class Gear(Protocol):
    """Properties of a gear that the checks use."""

    def problems(self, where: str = "") -> list[Message]:
        """Everything that makes the gear impossible."""

    @property
    def undercut(self) -> bool:
        """Whether the tool cuts away part of the involute."""


def at_key(where: str, key: str) -> str:
    """Path of a key of a part in the model.

    Parameters
    ----------
    where
        Path of the part; may be empty.
    key
        Name of the key.

    Examples
    --------
    >>> at_key("gears.pinion", "rack"), at_key("", "rack")
    ('gears.pinion.rack', 'rack')
    """
    return f"{where}.{key}" if where else key


def placed(where: str, error: GeometryError) -> Message:
    """Message of an error, with the path of its part.

    Parameters
    ----------
    where
        Path of the part; may be empty.
    error
        The error; its place is relative to the part.

    Examples
    --------
    >>> print(placed("gears.pinion", GeometryError("is missing", where="rack")))
    gears.pinion.rack: is missing
    """
    p = error.problem
    return Message(at_key(where, p.where), p.text, p.value, p.limit, p.remedy)


def problems_of_gear(where: str, *checks: Callable[[], Found | None]) -> list[Message]:
    """First problem found by the checks of one gear; later checks would use undefined values.

    Parameters
    ----------
    where
        Path of the gear in the model.
    checks
        Functions that return a problem or None; a `GeometryError` counts as a problem.

    Examples
    --------
    >>> print(*problems_of_gear("gears.a", lambda: None, lambda: ("rack", "is odd", "3", "2", "use less")))
    gears.a.rack: 3 is odd (limit 2); use less
    """
    try:
        found = next((found for check in checks if (found := check()) is not None), None)
    except GeometryError as error:
        return [placed(where, error)]
    return [] if found is None else [Message(at_key(where, found[0]), *found[1:])]


def thin_tip(thickness: float, module: str, key: str, value: str, remedy: str) -> Found | None:
    """Report a tip that is thinner than usual, or a tooth that is pointed below its tip.

    Parameters
    ----------
    thickness
        Normal tip thickness in normal modules [-].
    module
        Symbol of the normal module.
    key, value
        Key and value that cause the thin tip.
    remedy
        Remedy.

    Notes
    -----
    A pointed tooth is not possible, a thin tip is: FZG gears of type A (ISO 14635-1) have 0.13 m_n.

    Examples
    --------
    >>> thin_tip(0.1, "m_n", "profile_shift_coefficient", "1", "reduce it")[1]
    'leaves a tip thickness of 0.1 m_n'
    """
    if thickness >= TIP_THICKNESS_LIMIT:
        return None
    if thickness <= 0.0:
        message = f"leaves a pointed tooth (tip thickness {thickness:.2g} {module})"
        return key, message, value, f"usually {TIP_THICKNESS_LIMIT:g} {module}", remedy
    return (
        key,
        f"leaves a tip thickness of {thickness:.2g} {module}",
        value,
        f"{TIP_THICKNESS_LIMIT:g} {module}",
        remedy,
    )


def full_rounding(where: str, asked: float, most: float) -> list[Message]:
    """Report a root radius larger than the tool allows; the teeth then have full rounding.

    Parameters
    ----------
    where
        Path of the gear in the model.
    asked, most
        Requested and largest possible root radius, in modules [-].

    Examples
    --------
    >>> print(*full_rounding("a", 0.5, 0.4))
    a.rack.root_radius: 0.5 modules have no room between the flanks of the rack (limit 0.4); the teeth get \
the full rounding of 0.4
    """
    if not 0.0 <= most < asked:
        return []
    message, remedy = (
        "modules have no room between the flanks of the rack",
        "the teeth get the full rounding of",
    )
    place = at_key(where, "rack.root_radius")
    return [Message(place, message, f"{asked:g}", f"{most:.4g}", f"{remedy} {most:.4g}")]
