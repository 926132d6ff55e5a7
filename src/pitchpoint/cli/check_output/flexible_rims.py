# SPDX-License-Identifier: Apache-2.0
"""Ring modes of flexible rims, as `check` prints them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.cli.output import shown, table

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def ring_modes(model: Model) -> int:
    """Number of modes of all flexible rims on bodies."""
    rims = [model.gears[g].flexible_rim for body in model.bodies.values() for g in body.gears]
    return sum(rim.coordinates for rim in rims if rim is not None)


def rims_of_model(model: Model) -> dict[str, Any]:
    """Natural frequencies of all flexible rims, see `pitchpoint.system.rules.flexible_rim.rim_facts`."""
    from pitchpoint.system.rules.flexible_rim import rim_facts

    return rim_facts(model)


def show_rims(found: dict[str, Any]) -> None:
    """Print the natural frequencies of flexible rims.

    Parameters
    ----------
    found
        Result of `rims_of_model`.
    """
    rows = []
    for name, rim in found.items():
        for k, (n, free) in enumerate(zip(rim["waves"], rim["free"], strict=True)):
            held = rim["supported"][k] if rim["supported"] else []
            rows.append(
                [
                    name,
                    str(n),
                    shown(free, "frequency", 5),
                    ", ".join(shown(f, "frequency", 5) for f in held) or "no supports",
                ]
            )
    if rows:
        table("Ring modes without planets", ["gear", "waves n", "free rim", "on its supports"], rows)
