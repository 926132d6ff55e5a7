# SPDX-License-Identifier: Apache-2.0
"""Keys of a component that exclude each other or belong together."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from pitchpoint.model.keys import Place
from pitchpoint.model.read import Reader


def exactly_one(part: Any, keys: Iterable[str], at: Place, report: Reader) -> None:
    """Report a component that gives none or several of some keys."""
    given = [k for k in keys if getattr(part, k) is not None]
    if len(given) != 1 and at not in report.tainted:
        message = "gives none of its keys" if not given else f"gives {' and '.join(given)} at once"
        report.problem(at, message, remedy=f"give exactly one of {', '.join(keys)}")


def exactly_both(part: Any, keys: tuple[str, str], at: Place, report: Reader) -> None:
    """Report a component that gives one of two keys that belong together."""
    given = [k for k in keys if getattr(part, k) is not None]
    if len(given) == 1 and at not in report.tainted:
        other = keys[1] if given[0] == keys[0] else keys[0]
        report.problem((*at, given[0]), f"stands without {other}", remedy=f"give {other}")
