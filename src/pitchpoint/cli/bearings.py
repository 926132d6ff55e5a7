# SPDX-License-Identifier: Apache-2.0
"""Table of rolling bearings for `check`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.cli.output import show, table

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def show_bearings(model: Model) -> None:
    """Print the data of rolling bearings, given or estimated."""
    from pitchpoint.report.bearing_data import HEAD, bearing_lines

    rows, notes = bearing_lines(model)
    table("Rolling bearings", list(HEAD), rows)
    for note in notes:
        show(note)
