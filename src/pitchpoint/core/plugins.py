# SPDX-License-Identifier: Apache-2.0
"""What other packages add: the objects that their entry points in the group ``pitchpoint.kinds`` name."""

from __future__ import annotations

from typing import TypeVar

GROUP = "pitchpoint.kinds"
T = TypeVar("T")


def plugin_objects(of: type[T], name: str | None = None) -> list[T]:
    """Objects of a class that installed packages add.

    Parameters
    ----------
    of
        Class of the objects; entry points that name something else are passed over.
    name
        Name of the entry point; all are loaded if omitted.
    """
    from importlib.metadata import entry_points

    points = entry_points(group=GROUP) if name is None else entry_points(group=GROUP, name=name)
    found = [point.load() for point in points]
    return [one for one in found if isinstance(one, of)]
