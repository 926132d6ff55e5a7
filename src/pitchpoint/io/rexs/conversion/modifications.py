# SPDX-License-Identifier: Apache-2.0
"""Flank modifications: reliefs of tip, root and ends, crownings and slopes, by flank.

REXS counts the flanks as seen from the datum face, the model as seen from the end of the z axis. The sign of
a helix slope is not defined by REXS: positive adds material towards the non-datum face, as a positive profile
slope adds it towards the tip.
"""

from __future__ import annotations

from typing import Any

from pitchpoint.io.rexs.conversion.frames import frame_of
from pitchpoint.io.rexs.conversion.hubs import shaft_of
from pitchpoint.io.rexs.conversion.profile_amounts import ProfileAmount
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
ENDS = {"end_relief_datum_face": "datum_face", "end_relief_non_datum_face": "non_datum_face"}
SHAPES = {"linear": "linear", "parabolic": "parabolic", "circular": "parabolic"}
OTHERS = (
    *("profile_twist", "topographical_modification", "triangular_tip_relief", "triangular_root_relief"),
)
"""Modifications that a model does not have."""
SAME = 1e-9
"""Difference of amounts that counts as rounding [m]."""
SIGN = "REXS does not define its sign: positive adds material towards"


def modifications_of(
    conversion: Conversion, gear: RexsComponent, flanks: dict[str, RexsComponent], path: str
) -> dict[str, Any]:
    """Modifications of a gear for the model file; empty without any.

    Parameters
    ----------
    conversion
        The conversion.
    gear
        The gear.
    flanks
        Left and right flank.
    path
        Key of the gear in the model file.
    """
    datum = _datum(conversion, gear)
    target = f"{path}.modifications"
    sides = {
        side: _of_flank(conversion, gear, flank, target, datum or -1.0) for side, flank in flanks.items()
    }
    if not any(sides.values()):
        return {}
    if len(sides) == 2 and sides["left"] == sides["right"]:
        return {"both": sides["left"]}
    if datum is None:
        text = "at the end of the smallest z: left and right flank, and the sign of helix slopes"
        conversion.default(gear, "datum_face_orientation", text, target)
    if (datum or -1.0) < 0.0:
        sides = {{"left": "right", "right": "left"}[side]: found for side, found in sides.items()}
    return {side: sides[side] for side in ("left", "right") if sides.get(side)}


def _datum(conversion: Conversion, gear: RexsComponent) -> float | None:
    """End of the z axis at which the datum face of a gear is: +1 or -1; None if it is not given."""
    word = conversion.word(gear, "datum_face_orientation")
    if word not in ("positive", "negative"):
        return None
    shaft = shaft_of(conversion, gear)
    frame = frame_of(conversion, gear) or (None if shaft is None else frame_of(conversion, shaft))
    along = 1.0 if frame is None else conversion.aligned(frame)[1]
    return along if word == "positive" else -along


def _of_flank(
    conversion: Conversion, gear: RexsComponent, flank: RexsComponent, target: str, datum: float
) -> dict[str, Any]:
    """Modifications of one flank."""
    found: dict[str, Any] = {}
    for one in conversion.referenced(flank, *OTHERS):
        conversion.ignored(one, "all", f"a model has no {one.type.replace('_', ' ')}", values=True)
    for one in conversion.referenced(flank, *RELIEFS):
        _add(conversion, one, found, one.type, *_relief(conversion, one, target))
    for one in conversion.referenced(flank, *CROWNINGS):
        _add(conversion, one, found, CROWNINGS[one.type][2], *_crowning(conversion, gear, one, target))
    for one in conversion.referenced(flank, "helix_slope", "profile_slope"):
        _add(conversion, one, found, one.type, *_slope(conversion, gear, one, target, datum))
    _add_ends(conversion, conversion.referenced(flank, *ENDS), found, target)
    for one in conversion.referenced(flank, "profile_crowning", "profile_slope"):
        key = CROWNINGS[one.type][2] if one.type in CROWNINGS else one.type
        if key in found:
            _note_diameters(conversion, one, ProfileAmount(found, key, target))
    return found


def _add(
    conversion: Conversion, one: RexsComponent, found: dict[str, Any], key: str, value: Any, reason: str
) -> None:
    """Add a modification, or list the reason why it is not converted, with its values."""
    conversion.done.add(one.id)
    if key in found:
        value, reason = None, "a flank of a model has one modification of a kind"
    if value is not None:
        found[key] = value
    else:
        conversion.ignored(one, "all", reason, values=True)


def _relief(conversion: Conversion, one: RexsComponent, target: str) -> tuple[dict[str, Any] | None, str]:
    """Relief at tip or root, or why it is not converted."""
    depth = conversion.number(one, f"{one.type}_depth", f"{target}.{one.type}.amount")
    start = conversion.number(one, f"{one.type}_datum_diameter", f"{target}.{one.type}.start_diameter")
    length = conversion.number(one, f"{one.type}_datum_length", f"{target}.{one.type}.length")
    shape = str(conversion.word(one, "shape_of_relief", f"{target}.{one.type}.shape") or "linear")
    if not depth or depth < 0.0 or not (start or length) or (start or length or 0.0) <= 0.0:
        return None, "a relief needs a depth above 0 and a datum diameter"
    if shape not in SHAPES:
        return None, f"a model has no {shape} relief"
    _say_shape(conversion, one, shape, f"{target}.{one.type}.shape")
    extent = {"start_diameter": q(start, "length")} if start else {"length": q(length or 0.0, "length")}
    values = {"amount": q(depth, "length"), **extent}
    return values | ({} if SHAPES[shape] == "linear" else {"shape": SHAPES[shape]}), ""


def _say_shape(conversion: Conversion, one: RexsComponent, shape: str, target: str) -> None:
    if SHAPES[shape] != shape:
        conversion.changed(one, "shape_of_relief", SHAPES[shape], target, f"for {shape}")


def _crowning(
    conversion: Conversion, gear: RexsComponent, one: RexsComponent, target: str
) -> tuple[Any, str]:
    """Amount of a crowning at the ends, or why it is not converted."""
    first, second, key = CROWNINGS[one.type]
    amounts = [conversion.number(one, name, f"{target}.{key}") for name in (first, second)]
    given = [amount for amount in amounts if amount is not None]
    if len(given) < 2:
        return None, "its amount is not given at both ends"
    if one.type == "helix_crowning":
        half = 0.5 * (conversion.number(gear, "face_width") or 0.0)
        places = [
            conversion.number(one, f"coordinate_where_helix_crowning_is_specified_{end}")
            for end in ("datum_face", "non_datum_face")
        ]
        given = [a * (half / abs(s)) ** 2 if s else a for a, s in zip(given, places, strict=True)]
    if abs(given[0] - given[1]) > SAME:
        return None, "a crowning of a model is equal at both ends"
    if abs(given[0]) < SAME:
        return None, "its amount is 0"
    return q(given[0], "length"), ""


def _slope(
    conversion: Conversion, gear: RexsComponent, one: RexsComponent, target: str, datum: float
) -> tuple[Any, str]:
    """Slope over the whole flank, or why it is not converted."""
    amount = conversion.number(one, one.type, f"{target}.{one.type}")
    if not amount:
        return None, "its amount is 0" if amount is not None else "its amount is missing"
    if one.type == "profile_slope":
        return q(amount, "length"), ""
    ends = [conversion.number(one, f"helix_evaluation_{end}") for end in ("start", "end")]
    width = conversion.number(gear, "face_width") or 0.0
    if None not in ends and ends[0] != ends[1]:
        amount *= width / abs((ends[1] or 0.0) - (ends[0] or 0.0))
    value = q(-datum * amount, "length")
    reason = (
        f"{SIGN} the non-datum face, which is at the end of the {'small' if datum > 0.0 else 'larg'}est z"
    )
    conversion.changed(one, "helix_slope", str(value), f"{target}.helix_slope", reason)
    return value, ""


def _add_ends(conversion: Conversion, parts: list[RexsComponent], found: dict[str, Any], target: str) -> None:
    """Add the relief of both ends, if it is the same at both."""
    values = []
    for one in parts:
        conversion.done.add(one.id)
        end = ENDS[one.type]
        depth = conversion.number(one, f"end_relief_depth_{end}", f"{target}.end_relief.amount")
        length = conversion.number(one, f"end_relief_length_{end}", f"{target}.end_relief.length")
        shape = conversion.word(one, "shape_of_relief", f"{target}.end_relief.shape") or "linear"
        values.append((depth, length, shape))
    kinds = {one.type for one in parts}
    if not parts:
        return
    depth, length, shape = values[0]
    same = len(parts) == len(kinds) == 2 and all(v == values[0] for v in values)
    if not same or not depth or not length or shape not in SHAPES or min(depth, length) <= 0.0:
        for one in parts:
            reason = "a model has the same linear or parabolic relief at both ends"
            conversion.ignored(one, "all", reason, values=True)
        return
    _say_shape(conversion, parts[0], shape, f"{target}.end_relief.shape")
    entry = {"amount": q(depth, "length"), "length": q(length, "length")}
    found["end_relief"] = entry | ({} if SHAPES[shape] == "linear" else {"shape": SHAPES[shape]})


_DIAMETERS = {
    "profile_crowning": (
        "diameter_where_profile_crowning_root_is_specified",
        "diameter_where_profile_crowning_tip_is_specified",
    ),
    "profile_slope": ("profile_evaluation_start", "profile_evaluation_end"),
}


def _note_diameters(conversion: Conversion, one: RexsComponent, amount: ProfileAmount) -> None:
    """Note the diameters between which an amount is given: it is converted to the whole flank later."""
    root, tip = (conversion.number(one, name) for name in _DIAMETERS[one.type])
    if root is not None and tip is not None and abs(root - tip) > SAME:
        amount.component, amount.diameters = one, (abs(root), abs(tip))
        conversion.profile_amounts.append(amount)
