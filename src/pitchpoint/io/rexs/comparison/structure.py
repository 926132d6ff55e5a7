# SPDX-License-Identifier: Apache-2.0
"""Changes of the structure: parts on another shaft, gears of another stage, another order."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping

from pitchpoint.io.rexs.comparison.wording import OWNERS
from pitchpoint.io.rexs.document import RexsModel, RexsRelation

NOTHING = "–"
PARTS = {kind: part for kind, (part, _) in OWNERS.items()} | {
    "flank": "gear",
    "stage": "stage",
    "reference": "origin",
    "ordered_reference": "origin",
}
"""Role of the component that a change of a relation is listed for."""


def moves(a: RexsModel, b: RexsModel, pairs: Mapping[int, int]) -> Iterator[tuple[int, str, str, str]]:
    """Changed relations between components of both gear units.

    Parameters
    ----------
    a, b
        The gear units.
    pairs
        Components of `b` by those of `a`.

    Yields
    ------
    tuple
        Id of the component in `a`, role that another component has now, and this component in both files.
    """
    back = {j: i for i, j in pairs.items()}
    # both in the ids of `a`; relations of components that were added or removed are part of that
    of_a = [(r, dict(r.roles)) for r in a.relations if all(i in pairs for i in r.roles.values())]
    of_b = [
        (r, {role: back[j] for role, j in r.roles.items()})
        for r in b.relations
        if all(j in back for j in r.roles.values())
    ]
    gone, new = _unequal(of_a, of_b), _unequal(of_b, of_a)
    for relation, roles in gone:
        main = _main(relation)
        same = next((n for n in new if _alike(a, (relation, roles), n)), None)
        if same is not None:
            new.remove(same)
        after = {} if same is None else same[1]
        for role, i in roles.items():
            if role != main and after.get(role) != i:
                there = after.get(role)
                yield roles[main], role, str(a.components[i]), _named(b, pairs, there)
        for role, i in after.items():
            if role not in roles:
                yield roles[main], role, NOTHING, _named(b, pairs, i)
    for relation, roles in new:
        main = _main(relation)
        for role, i in roles.items():
            if role != main:
                yield roles[main], role, NOTHING, _named(b, pairs, i)
    yield from _reordered(of_a, of_b)


def _alike(
    a: RexsModel, one: tuple[RexsRelation, dict[str, int]], two: tuple[RexsRelation, dict[str, int]]
) -> bool:
    """Whether two relations are of the same part, with other components of the same types."""
    (relation, roles), (other, new) = one, two
    main = _main(relation)
    types = [{r: a.components[i].type for r, i in side.items()} for side in (roles, new)]
    return relation.type == other.type and new.get(main) == roles[main] and types[0] == types[1]


def _named(b: RexsModel, pairs: Mapping[int, int], i: int | None) -> str:
    return NOTHING if i is None else str(b.components[pairs[i]])


def _main(relation: RexsRelation) -> str:
    """Role of the component that a change is listed for."""
    main = PARTS.get(relation.type, "")
    return main if main in relation.roles else next(iter(relation.roles))


def _key(relation: RexsRelation, roles: Mapping[str, int]) -> tuple[str, frozenset[tuple[str, int]]]:
    return relation.type, frozenset(roles.items())


def _unequal(
    ones: list[tuple[RexsRelation, dict[str, int]]], others: list[tuple[RexsRelation, dict[str, int]]]
) -> list[tuple[RexsRelation, dict[str, int]]]:
    """Relations that the other gear unit does not have."""
    there = Counter(_key(*other) for other in others)
    found = []
    for one in ones:
        if there[_key(*one)] > 0:
            there[_key(*one)] -= 1
        elif one[1]:
            found.append(one)
    return found


def _reordered(
    of_a: list[tuple[RexsRelation, dict[str, int]]], of_b: list[tuple[RexsRelation, dict[str, int]]]
) -> Iterator[tuple[int, str, str, str]]:
    """Parts of ordered assemblies at another place among the parts that both have."""
    for kind, main, part in (
        ("ordered_assembly", "assembly", "part"),
        ("ordered_reference", "origin", "referenced"),
    ):
        orders = [_orders(side, kind, main, part) for side in (of_a, of_b)]
        for owner, first in orders[0].items():
            second = orders[1].get(owner, [])
            both = [[i for i in one if i in other] for one, other in ((first, second), (second, first))]
            for place, i in enumerate(both[0], 1):
                if both[1].index(i) + 1 != place:
                    yield i, "place in the order", str(place), str(both[1].index(i) + 1)


def _orders(
    side: list[tuple[RexsRelation, dict[str, int]]], kind: str, main: str, part: str
) -> dict[int, list[int]]:
    """Parts of each assembly in their order."""
    found: dict[int, list[tuple[int, int]]] = {}
    for relation, roles in side:
        if relation.type == kind and main in roles and part in roles:
            found.setdefault(roles[main], []).append((relation.order or 0, roles[part]))
    return {owner: [i for _, i in sorted(parts)] for owner, parts in found.items()}
