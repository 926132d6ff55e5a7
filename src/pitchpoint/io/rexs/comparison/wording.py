# SPDX-License-Identifier: Apache-2.0
"""Components in words: "pinion of cylindrical_stage 19", "left flank of ring_gear 7"."""

from __future__ import annotations

from collections.abc import Mapping

from pitchpoint.io.rexs.document import RexsComponent, RexsModel

OWNERS = {
    "assembly": ("part", "assembly"),
    "ordered_assembly": ("part", "assembly"),
    "side": ("assembly", "inner_part"),
    "coupling": ("assembly", "side_1"),
    "stage_gear_data": ("stage_gear_data", "gear"),
    "manufacturing_step": ("tool", "workpiece"),
    "reference": ("referenced", "origin"),
    "ordered_reference": ("referenced", "origin"),
}
"""Roles of a part, and of the one that it belongs to, by type of the relation."""
WHOLE = ("gear_unit", "shaft", "gear_casing", "planet_carrier", "cylindrical_stage", "planetary_stage")
"""Parts that need no owner to be found."""


def in_words(model: RexsModel, id: int) -> str:
    """A component by its place in the gear unit.

    Parameters
    ----------
    model
        The gear unit.
    id
        Id of the component.

    Examples
    --------
    >>> from pitchpoint.io.rexs.document import RexsRelation
    >>> parts = {n: RexsComponent(n, t) for n, t in ((3, "shaft"), (5, "shaft_section"))}
    >>> part_of = RexsRelation(1, "assembly", {"assembly": 3, "part": 5})
    >>> in_words(RexsModel("1.5", components=parts, relations=(part_of,)), 5)
    'shaft_section 5 of shaft 3'
    """
    component = model.components[id]
    if component.type in WHOLE:
        return str(component)
    for role, word in (("gear_1", 0), ("gear_2", 1)):
        for relation in model.related("stage", **{role: id}):
            return _of_stage(model, component, relation.roles, word)
    for role in ("left", "right"):
        for relation in model.related("flank", **{role: id}):
            if "gear" in relation.roles:
                return f"{role} flank of {in_words(model, relation.roles['gear'])}"
    for kind, (part, owner) in OWNERS.items():
        for relation in model.related(kind, **{part: id}):
            if relation.roles.get(owner, id) != id:
                return _of_owner(model, component, relation.roles[owner])
    return str(component)


def _of_stage(model: RexsModel, component: RexsComponent, roles: Mapping[str, int], word: int) -> str:
    """Pinion or wheel of a pair, the gear with fewer teeth being the pinion; other gears by their type."""
    gears = [model.components[roles[r]] for r in ("gear_1", "gear_2") if r in roles]
    if "stage" not in roles:
        return str(component)
    stage = model.components[roles["stage"]]
    teeth = [g.get("number_of_teeth") for g in gears]
    pair = [g.type for g in gears] == ["cylindrical_gear", "cylindrical_gear"]
    if not pair or not all(isinstance(z, int | float) for z in teeth) or teeth[0] == teeth[1]:
        return f"{component} of {stage}"
    first_is_pinion = teeth[0] < teeth[1]  # type: ignore[operator]
    return f"{'pinion' if (word == 0) == first_is_pinion else 'wheel'} of {stage}"


def _of_owner(model: RexsModel, component: RexsComponent, owner: int) -> str:
    above = model.components[owner]
    if above.type == "gear_unit":
        return str(component)
    place = str(above) if above.type in WHOLE else in_words(model, owner)
    return f"{component} of {place}"


def words(id: str) -> str:
    """Id of an attribute or role in words.

    >>> words("face_width")
    'face width'
    """
    return id.replace("_", " ")
