# SPDX-License-Identifier: Apache-2.0
"""Table of scissor gears for `check`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pitchpoint.cli.output import shown, table


def show_scissors(scissors: Mapping[str, Mapping[str, Any]]) -> None:
    """Print the torque of the spring in mesh and its flank force."""
    head = ["free half", "next to", "face widths", "twist in mesh", "torque of the spring", "flank force"]
    rows = [
        [
            name,
            f"{row['gear']} of {row['body']}",
            " + ".join(shown(width, "length") for width in row["face_widths"]),
            shown(row["twist"], "angle", 3),
            shown(row["spring_torque"], "torque", 4),
            shown(row["flank_force"], "force", 4),
        ]
        for name, row in scissors.items()
    ]
    notes = [
        "the fixed half lifts off at a load, with inertia torques, above the spring torque and against it"
    ]
    table("Scissor gears", head, rows, notes)
