# SPDX-License-Identifier: Apache-2.0
"""Choice of a picture by its name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.nearest import did_you_mean

if TYPE_CHECKING:
    import plotly.graph_objects as go

Figures = Mapping[str, "go.Figure"]
LISTED = 24
"""Maximum number of names in a message."""


def pick(figures: Figures, name: str, what: str) -> go.Figure:
    """Figure by name, or the first one of a kind.

    Raises
    ------
    PitchpointError
        If there is none; the message lists the others.
    """
    if not figures:
        raise PitchpointError(f"this {what} has no values to draw")
    found = next((f for key, f in figures.items() if name in ("", key, key.partition("[")[0])), None)
    if found is None:
        raise unknown(name, list(figures), what)
    return found


def unknown(name: str, known: list[str], what: str) -> PitchpointError:
    """Error about a name without picture; it lists the others."""
    shown = ", ".join(known[:LISTED]) + (f" and {len(known) - LISTED} more" if len(known) > LISTED else "")
    near = did_you_mean(name, known)
    return PitchpointError(f"this {what} has no picture {name!r}; {near}there are {shown}")
