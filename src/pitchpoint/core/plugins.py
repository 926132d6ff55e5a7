# SPDX-License-Identifier: Apache-2.0
"""Plugins: objects of package entry points in the group ``pitchpoint.kinds``."""

from __future__ import annotations

from typing import TypeVar

GROUP = "pitchpoint.kinds"
T = TypeVar("T")


def plugin_objects(of: type[T], name: str | None = None) -> list[T]:
    """Objects of a class from the entry points of installed packages.

    Parameters
    ----------
    of
        Class of the objects; other objects are ignored.
    name
        Name of the entry point; default: all.
    """
    from importlib.metadata import entry_points

    points = entry_points(group=GROUP) if name is None else entry_points(group=GROUP, name=name)
    found = [point.load() for point in points]
    return [one for one in found if isinstance(one, of)]
