# SPDX-License-Identifier: Apache-2.0
"""Flank modifications that both flanks have: reliefs of tip and root, crowning of profile and helix."""

from __future__ import annotations

from typing import Any

from pitchpoint.io.rexs.conversion.state import Conversion, q
from pitchpoint.io.rexs.document import RexsComponent

RELIEFS = ("tip_relief", "root_relief")
CROWNINGS = {
    "profile_crowning": ("profile_crowning_at_tip", "profile_crowning_at_root", "profile_crowning"),
    "helix_crowning": (
        "helix_crowning_amount_datum_face",
        "helix_crowning_amount_non_datum_face",
        "lead_crowning",
    ),
}
"""Amounts at both ends, and key of the model file."""
SHAPES = {"linear": "linear", "parabolic": "parabolic", "circular": "parabolic"}
OTHERS = (
    *("profile_slope", "helix_slope", "end_relief_datum_face", "end_relief_non_datum_face", "profile_twist"),
    *("topographical_modification", "triangular_tip_relief", "triangular_root_relief"),
)
"""Modifications that are not converted."""


def modifications_of(conversion: Conversion, flanks: dict[str, RexsComponent], path: str) -> dict[str, Any]:
    """Modifications of a gear for the model file; empty without any.

    Parameters
    ----------
    conversion
        The conversion.
    flanks
        Left and right flank.
    path
        Key of the gear in the model file.
    """
    target = f"{path}.modifications.both"
    sides = [_of_flank(conversion, flank, target) for flank in flanks.values()]
    if not any(sides):
        return {}
    if len(sides) < 2 or sides[0] != sides[1]:
        for flank in flanks.values():
            for one in conversion.referenced(flank, *RELIEFS, *CROWNINGS):
                conversion.ignored(
                    one, "all", "left and right flank differ: add it to the model file by hand"
                )
        return {}
    return {"both": sides[0]}


def _of_flank(conversion: Conversion, flank: RexsComponent, target: str) -> dict[str, Any]:
    """Modifications of one flank."""
    found: dict[str, Any] = {}
    for one in conversion.referenced(flank, *OTHERS):
        conversion.ignored(one, "all", f"{one.type} is not converted: add it to the model file by hand")
    for one in conversion.referenced(flank, *RELIEFS):
        _add(conversion, one, found, one.type, *_relief(conversion, one, target))
    for one in conversion.referenced(flank, *CROWNINGS):
        _add(conversion, one, found, CROWNINGS[one.type][2], *_crowning(conversion, one, target))
    return found


def _add(
    conversion: Conversion, one: RexsComponent, found: dict[str, Any], key: str, value: Any, reason: str
) -> None:
    """Add a modification, or list the reason why it is not converted."""
    conversion.done.add(one.id)
    if key in found:
        value, reason = None, "a flank of a model has one modification of a kind"
    if value is not None:
        found[key] = value
    else:
        conversion.ignored(one, "all", reason)


def _relief(conversion: Conversion, one: RexsComponent, target: str) -> tuple[dict[str, Any] | None, str]:
    """Relief at tip or root, or why it is not converted."""
    depth = conversion.number(one, f"{one.type}_depth", f"{target}.{one.type}.amount")
    start = conversion.number(one, f"{one.type}_datum_diameter", f"{target}.{one.type}.start_diameter")
    shape = str(conversion.word(one, "shape_of_relief", f"{target}.{one.type}.shape") or "linear")
    if depth is None or start is None or depth <= 0.0 or start <= 0.0:
        return None, "a relief needs a depth above 0 and a datum diameter"
    if shape not in SHAPES:
        return None, f"a model has no {shape} relief"
    if SHAPES[shape] != shape:
        conversion.changed(
            one, "shape_of_relief", SHAPES[shape], f"{target}.{one.type}.shape", f"for {shape}"
        )
    values = {"amount": q(depth, "length"), "start_diameter": q(start, "length")}
    return values | ({} if SHAPES[shape] == "linear" else {"shape": SHAPES[shape]}), ""


def _crowning(conversion: Conversion, one: RexsComponent, target: str) -> tuple[Any, str]:
    """Amount of a crowning that is equal at both ends, or why it is not converted."""
    first, second, key = CROWNINGS[one.type]
    amounts = [conversion.number(one, name, f"{target}.{key}") for name in (first, second)]
    given = [amount for amount in amounts if amount is not None]
    if len(given) < 2 or abs(given[0] - given[1]) > 1e-9:
        return None, "a crowning of a model is equal at both ends"
    if any("is_specified" in name for name in one.attributes):
        return None, "its amount is not that at the ends"
    return q(given[0], "length"), ""
