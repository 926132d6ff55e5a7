# SPDX-License-Identifier: Apache-2.0
"""Checks common to cylindrical and bevel gears and their pairs: order, limits, messages.

`problems` and `bevel.problems` give numbers and remedies. Nothing here raises: a loader lists all problems.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Protocol

from pitchpoint.core.errors import GeometryError, Message

TIP_THICKNESS_LIMIT = 0.2
"""Normal modules. Thinner tips break or burn through in hardening: a limit of design practice."""
INTERFERENCE_TOLERANCE = 0.01
"""Modules along the path of contact: less than what tip diameters, cones and centre distances are made to."""
USABLE_CONTACT_RATIO = 1.1
"""Below this a pair with undercut teeth does not reliably transfer load from one tooth pair to the next."""
NO_PAIR_IN_CONTACT = "leaves moments without a tooth pair in contact"
Found = tuple[str, str, str, str | None, str]
"""Key, message, value, limit and remedy."""


class Gear(Protocol):
    """What is asked of a gear."""

    def problems(self, where: str = "") -> list[Message]:
        """Everything that makes the gear impossible."""

    @property
    def undercut(self) -> bool:
        """Whether the tool cuts away part of the involute."""


class Pair(Protocol):
    """What is asked of a pair."""

    @property
    def gear1(self) -> Gear:
        """Gear 1."""

    @property
    def gear2(self) -> Gear:
        """Gear 2."""

    @property
    def eps_alpha_form(self) -> float:
        """Transverse contact ratio that the involutes leave."""

    @property
    def eps_beta(self) -> float:
        """Overlap ratio."""

    @property
    def eps_gamma(self) -> float:
        """Total contact ratio."""


@dataclass(frozen=True)
class Words:
    """Terms of messages about the pairs of one kind of gears.

    Parameters
    ----------
    surface
        What roots and bases are: "circle" or "cone".
    tangent
        What touches both bases: "tangent point" or "tangent ray".
    path
        Writes a length of the path of contact.
    heights, shifts, lengths
        Remedies: for tips in roots, for tips that reach beyond the base, for too short a path.
    """

    surface: str
    tangent: str
    path: Callable[[float], str]
    heights: str
    shifts: str
    lengths: str


def at_key(where: str, key: str) -> str:
    """Place of a key below the place of its part.

    Parameters
    ----------
    where
        Place of the part, empty for none.
    key
        Name of the key.

    Examples
    --------
    >>> at_key("gears.pinion", "rack"), at_key("", "rack")
    ('gears.pinion.rack', 'rack')
    """
    return f"{where}.{key}" if where else key


def _placed(where: str, error: GeometryError) -> Message:
    """The problem of an error, below the place of its part."""
    p = error.problem
    return Message(at_key(where, p.where), p.text, p.value, p.limit, p.remedy)


def problems_of_gear(where: str, *checks: Callable[[], Found | None]) -> list[Message]:
    """First problem that checks of one gear find; those behind it would speak of numbers without meaning.

    Parameters
    ----------
    where
        Place of the gear in its description.
    checks
        Each returns a problem or None; a `GeometryError` counts as a problem.

    Examples
    --------
    >>> print(*problems_of_gear("gears.a", lambda: None, lambda: ("rack", "is odd", "3", "2", "use less")))
    gears.a.rack: 3 is odd (limit 2); use less
    """
    try:
        found = next((found for check in checks if (found := check()) is not None), None)
    except GeometryError as error:
        return [_placed(where, error)]
    return [] if found is None else [Message(at_key(where, found[0]), *found[1:])]


def thin_tip(thickness: float, module: str, key: str, value: str, remedy: str) -> Found | None:
    """Report a tip that is thinner than usual, or a tooth that is pointed below its tip.

    Parameters
    ----------
    thickness
        Normal thickness of the tip in normal modules [-].
    module
        How these are called.
    key, value
        What makes it thin.
    remedy
        What to do.

    Notes
    -----
    A pointed tooth cannot be made; a thin one can: FZG gears of type A (ISO 14635-1) have 0.13 m_n.

    Examples
    --------
    >>> thin_tip(0.1, "m_n", "profile_shift_coefficient", "1", "reduce it")[1]
    'leaves a tip thickness of 0.1 m_n'
    """
    if thickness >= TIP_THICKNESS_LIMIT:
        return None
    if thickness <= 0.0:
        message = f"leaves a pointed tooth (tip thickness {thickness:.2g} {module})"
        return key, message, value, f"usually {TIP_THICKNESS_LIMIT:g} {module}", remedy
    return (
        key,
        f"leaves a tip thickness of {thickness:.2g} {module}",
        value,
        f"{TIP_THICKNESS_LIMIT:g} {module}",
        remedy,
    )


def full_rounding(where: str, asked: float, most: float) -> list[Message]:
    """Check the root radius: larger than the tool allows, the teeth get the full rounding.

    Parameters
    ----------
    where
        Place of the gear in its description.
    asked, most
        Root radius that is requested and the largest one, in modules [-].

    Examples
    --------
    >>> print(*full_rounding("a", 0.5, 0.4))
    a.rack.root_radius: 0.5 modules have no room between the flanks of the rack (limit 0.4); the teeth get \
the full rounding of 0.4
    """
    if not 0.0 <= most < asked:
        return []
    message, remedy = (
        "modules have no room between the flanks of the rack",
        "the teeth get the full rounding of",
    )
    place = at_key(where, "rack.root_radius")
    return [Message(place, message, f"{asked:g}", f"{most:.4g}", f"{remedy} {most:.4g}")]


def problems_of_pair(
    pair: Pair,
    where: str,
    names: tuple[str, str] | None,
    mismatches: Callable[[], list[Message]],
    contact: Callable[[], list[Message]],
) -> list[Message]:
    """Everything that makes a pair impossible: its gears, whether they belong together, then their contact.

    Parameters
    ----------
    pair
        The pair.
    where
        Place of the pair in its description.
    names
        How the messages call the two gears; None leaves the problems of the gears alone out.
    mismatches, contact
        Both list problems; `contact` is asked where nothing else is wrong.
    """
    one, two = names or ("", "")
    alone = pair.gear1.problems(one) + pair.gear2.problems(two)
    try:
        found = (alone if names else []) + mismatches()
        # the rest would only repeat that in other words, with numbers that mean nothing
        return found if found or alone else contact()
    except GeometryError as error:
        return [*(alone if names else []), _placed(where, error)]


def unequal(
    place: str,
    what: str,
    values: tuple[float, float],
    written: Callable[[float], str],
    names: tuple[str, str],
    key: str,
) -> Message:
    """Check quantities that both gears must share.

    Parameters
    ----------
    place
        Place of the gears of the pair in its description.
    what
        What differs, in the plural.
    values
        Values of both gears.
    written
        Writes one of them.
    names
        How the messages call the two gears.
    key
        Key of the gears that states it.

    Examples
    --------
    >>> print(unequal("s.gears", "helix angles", (1, 2), str, ("a", "b"), "helix_angle"))
    s.gears: a 1, b 2 have unequal helix angles (limit equal); give both gears the same helix_angle
    """
    value = f"{names[0]} {written(values[0])}, {names[1]} {written(values[1])}"
    return Message(place, f"have unequal {what}", value, "equal", f"give both gears the same {key}")


def wrong_hands(
    place: str, hands: tuple[str, str], names: tuple[str, str], internal: bool = False
) -> Message:
    """Check the hands of the helices.

    Parameters
    ----------
    place
        Place of the gears of the pair in its description.
    hands, names
        Hands of both gears, and how the messages call them.
    internal
        Whether the pair is internal.

    Examples
    --------
    >>> print(wrong_hands("s.gears", ("left", "left"), ("a", "b")))
    s.gears: a left, b left have hands that do not fit an external pair (limit opposite hands); change the \
hand of one gear
    """
    kind, rule = ("internal", "equal") if internal else ("external", "opposite")
    value = f"{names[0]} {hands[0]}, {names[1]} {hands[1]}"
    message = f"have hands that do not fit an {kind} pair"
    return Message(place, message, value, f"{rule} hands", "change the hand of one gear")


def tips_in_roots(
    place: str, clearances: tuple[float, float], names: tuple[str, str], words: Words
) -> list[Message]:
    """Check the clearance between tips and the mate's roots.

    Parameters
    ----------
    place
        Place in the description of the pair.
    clearances
        Of the tip of gear 1 in the root of gear 2, and the other way round.
    names
        How the messages call the two gears.
    words
        Terms of the messages.

    Examples
    --------
    >>> words = Words("circle", "tangent point", str, "shorten them", "", "")
    >>> print(*tips_in_roots("s.gears", (1, -2), ("a", "b"), words))
    s.gears: -2 is the tip clearance of b in the root of a (limit above 0); shorten them
    """
    return [
        Message(
            place,
            f"is the tip clearance of {tip} in the root of {root}",
            words.path(c),
            "above 0",
            words.heights,
        )
        for c, tip, root in zip(clearances, names, names[::-1], strict=True)
        if c < 0.0
    ]


def interferences(
    pair: Pair, place: str, beyond: Iterable[float], slack: float, names: tuple[str, str], words: Words
) -> list[Message]:
    """Check tips for contact beyond the mate's base.

    Parameters
    ----------
    pair
        The pair.
    place
        Place of the gears of the pair in its description.
    beyond
        How far the tip of gear 2 reaches beyond the base of gear 1, then that of gear 1 beyond the other.
    slack
        How far it may.
    names
        How the messages call the two gears.
    words
        Terms of the messages.

    Notes
    -----
    A rack or crown gear reaches deeper than any mate's tip: where it has undercut the gear, nothing is left
    to collide with, and the question is only whether enough involute remains to carry the motion.
    """
    remains = pair.eps_alpha_form + pair.eps_beta
    found = []
    for over, mate, tip, name in zip(beyond, (pair.gear1, pair.gear2), names[::-1], names, strict=False):
        if over > slack and not (mate.undercut and remains >= USABLE_CONTACT_RATIO):
            message = f"interferes with the root of {name}: it would touch beyond the base {words.surface}"
            limit = f"the {words.tangent}, it is {words.path(over)} beyond"
            if mate.undercut:
                limit += f", and undercut leaves a contact ratio of {remains:.3g} of {USABLE_CONTACT_RATIO:g}"
            found.append(Message(place, message, f"tip of {tip}", limit, words.shifts))
    return found


def odd_contact(
    pair: Pair,
    place: str,
    ends: tuple[tuple[float, str], tuple[float, str]],
    slack: float,
    names: tuple[str, str],
    words: Words,
) -> list[Message]:
    """List what is unusual about the contact of a feasible pair.

    Parameters
    ----------
    pair
        The pair.
    place
        Place of the gears of the pair in its description.
    ends
        Of gear 1 and gear 2: how much of the path of contact the involute lacks, and where it ends instead.
    slack
        How much it may lack.
    names
        How the messages call the two gears.
    words
        Terms of the messages.

    Notes
    -----
    Where a tip reaches below the mate's root form circle or cone the geometry still follows the tips (as
    published contact ratios do), but the involute ends sooner, in a fillet or an undercut. It depends on the
    tool, which is rarely known exactly. A total contact ratio below one leaves moments without contact.
    """
    found = []
    for (missing, limit), mate, tip, name in zip(
        ends, (pair.gear1, pair.gear2), names[::-1], names, strict=True
    ):
        if missing > slack:
            cause = "undercut" if mate.undercut else "root fillet"
            message = f"reaches below the root form {words.surface} of {name} ({cause})"
            left = f"the transverse contact ratio left is {pair.eps_alpha_form:.4g}"
            remedy = f"{left}; shorten the tip or set the rack"
            found.append(Message(place, message, f"tip of {tip}", limit, remedy))
    if pair.eps_gamma < 1.0:
        value = f"total contact ratio {pair.eps_gamma:.4g}"
        found.append(Message(place, NO_PAIR_IN_CONTACT, value, "1", words.lengths))
    return found
